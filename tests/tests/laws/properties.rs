//! What any friction of this kind obeys, whatever its numbers: dissipation, scaling, Euler's
//! identity, reciprocity, derivatives. Random twists from a fixed seed.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use tribos_core::coupling::table::{self, DiskTable64};
use tribos_core::coupling::{ReducedFriction, ReducedWrench, compact};
use tribos_core::internals::Gauss;
use tribos_tests::tolerance;

/// Fixed seed, no files written.
fn config() -> Config {
    Config {
        cases: 20_000,
        rng_seed: RngSeed::Fixed(20_031_220),
        failure_persistence: None,
        ..Config::default()
    }
}

/// Speeds over eight decades, one in four equal to within a few units to the next.
fn speeds() -> impl Strategy<Value = (f64, f64)> {
    let speed = || (-4.0..4.0_f64).prop_map(|e| 10.0_f64.powf(e));
    prop_oneof![
        3 => (speed(), speed()),
        1 => (speed(), -40.0..-1.0_f64).prop_map(|(v, e)| (v, v * (1.0 + 2.0_f64.powf(e)))),
    ]
}

/// Multiples of 2⁻¹⁰, so that α ± 1 is exact and no test judges its own powers.
fn exponents() -> impl Strategy<Value = f64> {
    let grid = |range: std::ops::Range<i32>| range.prop_map(|n| f64::from(n) / 1024.0);
    prop_oneof![
        2 => grid(-768..10_240),
        2 => grid(-768..1_536),
        1 => prop::sample::select(vec![0.0, 1.0, 3.0]),
    ]
}

fn compact(alpha: f64) -> compact::CompactPower<f64> {
    compact::CompactPower::new(alpha).expect("in range")
}

/// D·(α+1) = ⟨|u|^(α+1)⟩ from its own hypergeometric function.
fn mean_power(alpha: f64, v: f64, w: f64) -> f64 {
    let s = alpha + 1.0;
    let major = v.max(w);
    let h = v.min(w) / major;
    let z = (1.0 - h) * (1.0 + h);
    let mean = if v <= w {
        2.0 / (alpha + 3.0) * Gauss::new(-0.5 * s, -0.5 * s - 1.0, 1.0).at(h * h, z).value
    } else {
        Gauss::new(-0.5 * s, -0.5 * s, 2.0).at(h * h, z).value
    };
    mean * major.powf(s)
}

fn relative(a: f64, b: f64) -> f64 {
    (a - b).abs() / a.abs().max(b.abs()).max(f64::MIN_POSITIVE)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn friction_dissipates((v, w) in speeds(), alpha in exponents()) {
        for got in [compact(alpha).reduced_wrench(v, w), table::CoulombDisk.reduced_wrench(v, w)] {
            prop_assert!(got.force > 0.0 && got.torque > 0.0);
            prop_assert!(v * got.force + w * got.torque > 0.0);
        }
    }

    #[test]
    fn euler_identity_holds_with_an_independent_potential((v, w) in speeds(), alpha in exponents()) {
        let ReducedWrench { force, torque } = compact(alpha).reduced_wrench(v, w);
        let power = v * force + w * torque;
        prop_assert!(relative(power, mean_power(alpha, v, w)) <= tolerance::IDENTITY.limit);
    }

    #[test]
    fn force_over_speed_is_symmetric_in_both_speeds((v, w) in speeds(), alpha in exponents()) {
        let profile = compact(alpha);
        let (one, other) = (profile.reduced_wrench(v, w).force, profile.reduced_wrench(w, v).force);
        prop_assert!(relative(one / v, other / w) <= tolerance::IDENTITY.limit);
        let ratio = v / w;
        let forth = profile.reduced_wrench(ratio, 1.0).force;
        let back = ratio.powf(1.0 + alpha) * profile.reduced_wrench(1.0 / ratio, 1.0).force;
        prop_assert!(relative(forth, back) <= 2.0 * tolerance::IDENTITY.limit);
    }

    #[test]
    fn coulomb_friction_ignores_powers_of_two_to_the_bit((v, w) in speeds(), shift in -300..300_i32) {
        let scale = 2.0_f64.powi(shift);
        let (near, far) = (
            table::CoulombDisk.reduced_wrench(v, w),
            table::CoulombDisk.reduced_wrench(scale * v, scale * w),
        );
        prop_assert_eq!(near, far);
        let (near, far) = (
            table::CoulombDisk.reduced_jacobian(v, w),
            table::CoulombDisk.reduced_jacobian(scale * v, scale * w),
        );
        prop_assert_eq!(near.force_slide, far.force_slide * scale);
        prop_assert_eq!(near.mixed, far.mixed * scale);
        prop_assert_eq!(near.torque_rim, far.torque_rim * scale);
    }

    #[test]
    fn powers_are_homogeneous((v, w) in speeds(), alpha in exponents(), scale in 0.01..100.0_f64) {
        let profile = compact(alpha);
        let (near, far) = (profile.reduced_wrench(v, w), profile.reduced_wrench(scale * v, scale * w));
        // Rounding scale·v moves the ratio by one unit, which T near v ≫ w passes on unchanged.
        let bound = (4.0 + alpha.abs()) * tolerance::IDENTITY.limit;
        prop_assert!(relative(far.force, scale.powf(alpha) * near.force) <= bound);
        prop_assert!(relative(far.torque, scale.powf(alpha) * near.torque) <= bound);
    }

    #[test]
    fn derivatives_match_central_differences((v, w) in speeds(), alpha in 0.5..10.0_f64) {
        let profile = compact(alpha);
        let major = v.max(w);
        let step = major * 2.0_f64.powi(-17);
        let j = profile.reduced_jacobian(v, w);
        let difference = |dv: f64, dw: f64| {
            let [plus, minus] = [1.0, -1.0].map(|s| (v + s * dv, w + s * dw));
            let (p, m) = (profile.reduced_wrench(plus.0, plus.1), profile.reduced_wrench(minus.0, minus.1));
            let width = (plus.0 - minus.0) + (plus.1 - minus.1);
            [(p.force - m.force) / width, (p.torque - m.torque) / width]
        };
        // The wrench is even: a speed below the step would be mirrored.
        if v.min(w) <= 2.0 * step {
            return Ok(());
        }
        let [[force_v, torque_v], [force_w, torque_w]] = [difference(step, 0.0), difference(0.0, step)];
        for (analytic, numeric) in [
            (j.force_slide, force_v),
            (j.mixed, torque_v),
            (j.mixed, force_w),
            (j.torque_rim, torque_w),
            (j.force_per_slide, profile.reduced_wrench(v, w).force / v),
        ] {
            let scale = j.force_per_slide * (1.0 + alpha * alpha);
            prop_assert!((analytic - numeric).abs() <= tolerance::DIFFERENCES.limit * scale);
        }
    }

    #[test]
    fn force_never_falls_with_sliding_speed_for_rising_laws(
        (v, w) in speeds(), alpha in 0.0..10.0_f64, factor in 1.001..3.0_f64,
    ) {
        let profile = compact(alpha);
        let (slow, fast) = (profile.reduced_wrench(v, w), profile.reduced_wrench(factor * v, w));
        prop_assert!(fast.force >= slow.force * (1.0 - tolerance::IDENTITY.limit));
        let (slow, fast) = (profile.reduced_wrench(v, w), profile.reduced_wrench(v, factor * w));
        prop_assert!(fast.torque >= slow.torque * (1.0 - tolerance::IDENTITY.limit));
    }

    #[test]
    fn coupling_lowers_friction_below_the_linear_law_and_raises_it_above(
        (v, w) in speeds(), alpha in exponents(),
    ) {
        // Sliding alone resists with v^α, spinning alone with 2/(3+α) w^α.
        let got = compact(alpha).reduced_wrench(v, w);
        let alone = [v.powf(alpha), 2.0 / (3.0 + alpha) * w.powf(alpha)];
        let slack = 1.0 + 4.0 * tolerance::IDENTITY.limit;
        for (coupled, alone) in [got.force, got.torque].into_iter().zip(alone) {
            if alpha <= 1.0 {
                prop_assert!(coupled <= alone * slack);
            }
            if alpha >= 1.0 {
                prop_assert!(coupled * slack >= alone);
            }
        }
    }
}

#[test]
fn force_of_falling_laws_rises_and_falls_again() {
    // Errata 9: for −1 < α < 0 the force is not monotone in ε.
    let table = DiskTable64::new(-0.5).unwrap();
    let force = |ratio| table.reduced_wrench(ratio, 1.0).force;
    assert!(force(0.5) < force(1.1) && force(1.1) > force(3.0) && force(3.0) > force(10.0));
}
