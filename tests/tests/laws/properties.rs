//! What friction obeys under any axisymmetric pressure: dissipation, homogeneity, symmetry and
//! convexity of the potential, limits of one pressure in another, and what the uniform disk has beside.
//! Random twists, a fixed seed.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use tribos_core::coupling::coulomb::{CoulombHertz, CoulombPunch, CoulombRing};
use tribos_core::coupling::round::{LateralPolynomialTable, RoundTable64};
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{
    Annulus, LateralFriction, ReducedFriction, ReducedWrench, RoundFriction, compact, coulomb,
};
use tribos_core::internals::Gauss;
use tribos_core::patch::PolynomialPressure;
use tribos_core::twist::Twist;
use tribos_tests::patches::{pressure, tiers};
use tribos_tests::pucks::relative;
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// Fixed seed, no files written.
fn config(cases: u32, seed: u64) -> Config {
    Config {
        cases,
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: None,
        ..Config::default()
    }
}

/// Speeds over eight decades, one in four equal to within a few units to the next.
fn speeds_of_disks() -> impl Strategy<Value = (f64, f64)> {
    let speed = || (-4.0..4.0_f64).prop_map(|e| 10.0_f64.powf(e));
    prop_oneof![
        3 => (speed(), speed()),
        1 => (speed(), -40.0..-1.0_f64).prop_map(|(v, e)| (v, v * (1.0 + 2.0_f64.powf(e)))),
    ]
}

/// The same, and as many with the first speed a little larger.
fn speeds() -> impl Strategy<Value = (f64, f64)> {
    let speed = || (-4.0..4.0_f64).prop_map(|e| 10.0_f64.powf(e));
    prop_oneof![
        3 => (speed(), speed()),
        1 => (speed(), -40.0..-1.0_f64).prop_map(|(v, e)| (v, v * (1.0 + 2.0_f64.powf(e)))),
        1 => (speed(), -40.0..-1.0_f64).prop_map(|(v, e)| (v * (1.0 + 2.0_f64.powf(e)), v)),
    ]
}

/// Orders and exponents that are multiples of 2⁻¹⁰, with the named ones often among them.
fn patches() -> impl Strategy<Value = (f64, f64)> {
    let grid = |range: std::ops::Range<i32>| range.prop_map(|n| f64::from(n) / 1024.0);
    let order = prop_oneof![
        2 => prop::sample::select(vec![-1.0, -0.5, 0.0, 0.5, 1.0]),
        1 => grid(-1024..6_144),
    ];
    let alpha = prop_oneof![
        1 => prop::sample::select(vec![-0.5, 0.0, 0.5, 1.0, 3.0]),
        2 => grid(-768..10_240),
    ];
    (order, alpha)
}

fn compact(order: f64, alpha: f64) -> compact::CompactPower<f64> {
    compact::CompactPower::with_pressure(alpha, pressure(order)).expect("in range")
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

/// |a − b| within `bound` of the larger of |scale|s.
fn agrees(a: f64, b: f64, scale: f64, bound: f64) -> bool {
    (a - b).abs() <= bound * scale.abs().max(a.abs()).max(b.abs())
}

proptest! {
    #![proptest_config(config(20_000, 20_031_220))]

    #[test]
    fn euler_identity_holds_with_an_independent_potential((v, w) in speeds_of_disks(), alpha in exponents()) {
        let ReducedWrench { force, torque } = compact(0.0, alpha).reduced_wrench(v, w);
        let power = v * force + w * torque;
        prop_assert!(relative(power, mean_power(alpha, v, w)) <= tolerance::IDENTITY.limit);
    }

    #[test]
    fn force_over_speed_is_symmetric_in_both_speeds((v, w) in speeds_of_disks(), alpha in exponents()) {
        let profile = compact(0.0, alpha);
        let (one, other) = (profile.reduced_wrench(v, w).force, profile.reduced_wrench(w, v).force);
        prop_assert!(relative(one / v, other / w) <= tolerance::IDENTITY.limit);
        let ratio = v / w;
        let forth = profile.reduced_wrench(ratio, 1.0).force;
        let back = ratio.powf(1.0 + alpha) * profile.reduced_wrench(1.0 / ratio, 1.0).force;
        prop_assert!(relative(forth, back) <= 2.0 * tolerance::IDENTITY.limit);
    }

    #[test]
    fn powers_on_the_disk_are_homogeneous((v, w) in speeds_of_disks(), alpha in exponents(), scale in 0.01..100.0_f64) {
        let profile = compact(0.0, alpha);
        let (near, far) = (profile.reduced_wrench(v, w), profile.reduced_wrench(scale * v, scale * w));
        // Rounding scale·v moves the ratio by one unit, which T near v ≫ w passes on unchanged.
        let bound = (4.0 + alpha.abs()) * tolerance::IDENTITY.limit;
        prop_assert!(relative(far.force, scale.powf(alpha) * near.force) <= bound);
        prop_assert!(relative(far.torque, scale.powf(alpha) * near.torque) <= bound);
    }

    #[test]
    fn force_never_falls_with_sliding_speed_for_rising_laws(
        (v, w) in speeds_of_disks(), alpha in 0.0..10.0_f64, factor in 1.001..3.0_f64,
    ) {
        let profile = compact(0.0, alpha);
        let (slow, fast) = (profile.reduced_wrench(v, w), profile.reduced_wrench(factor * v, w));
        prop_assert!(fast.force >= slow.force * (1.0 - tolerance::IDENTITY.limit));
        let (slow, fast) = (profile.reduced_wrench(v, w), profile.reduced_wrench(v, factor * w));
        prop_assert!(fast.torque >= slow.torque * (1.0 - tolerance::IDENTITY.limit));
    }

    #[test]
    fn coupling_lowers_friction_below_the_linear_law_and_raises_it_above(
        (v, w) in speeds_of_disks(), alpha in exponents(),
    ) {
        // Sliding alone resists with v^α, spinning alone with 2/(3+α) w^α.
        let got = compact(0.0, alpha).reduced_wrench(v, w);
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

proptest! {
    #![proptest_config(config(5_000, 20_051_114))]

    #[test]
    fn friction_dissipates((v, w) in speeds(), (order, alpha) in patches()) {
        let got = compact(order, alpha).reduced_wrench(v, w);
        prop_assert!(got.force > 0.0 && got.torque > 0.0);
        prop_assert!(v * got.force + w * got.torque > 0.0);
        for dry in [coulomb::CoulombDisk.reduced_wrench(v, w), CoulombRing.reduced_wrench(v, w), CoulombPunch.reduced_wrench(v, w), CoulombHertz.reduced_wrench(v, w)] {
            prop_assert!(dry.force > 0.0 && dry.torque > 0.0);
        }
    }

    #[test]
    fn power_is_that_of_an_independent_mean_while_sliding_leads(
        (v, w) in speeds(), (order, alpha) in patches(),
    ) {
        // <|1 + h r e^(i theta)|^s> = 2F1(-s/2, -s/2; q+2; h^2), term by term.
        let (v, w) = (v.max(w), v.min(w));
        let got = compact(order, alpha).reduced_wrench(v, w);
        let s = alpha + 1.0;
        let z = (v - w) / v * (1.0 + w / v);
        let mean = Gauss::new(-0.5 * s, -0.5 * s, order + 2.0).at((w / v) * (w / v), z).value;
        let power = v * got.force + w * got.torque;
        prop_assert!(relative(power, mean * v.powf(s)) <= 2.0 * tolerance::IDENTITY.limit);
    }

    #[test]
    fn derivatives_are_those_of_homogeneous_functions((v, w) in speeds(), (order, alpha) in patches()) {
        let tier = compact(order, alpha);
        let (wrench, j) = (tier.reduced_wrench(v, w), tier.reduced_jacobian(v, w));
        for (along_v, along_w, wanted) in [
            (v * j.force_slide, w * j.mixed, alpha * wrench.force),
            (v * j.mixed, w * j.torque_rim, alpha * wrench.torque),
        ] {
            let finite = along_v.is_finite() && along_w.is_finite();
            prop_assert!(!finite || agrees(along_v + along_w, wanted, along_v, tolerance::IDENTITY.limit));
        }
        // vG is homogeneous as well, of degree alpha + 1.
        let (g, l) = (tier.lateral(v, w), tier.lateral_jacobian(v, w));
        let sum = v * l.slide + w * l.rim;
        prop_assert!(agrees(sum, (alpha + 1.0) * v * g, v * l.slide, tolerance::IDENTITY.limit));
    }

    #[test]
    fn rising_laws_have_a_convex_potential((v, w) in speeds(), order in -1.0..6.0_f64, alpha in 0.0..5.0_f64) {
        let j = compact(order, alpha).reduced_jacobian(v, w);
        prop_assume!(j.force_slide.is_finite());
        let slack = tolerance::EIGENVALUE.limit;
        prop_assert!(j.force_per_slide >= 0.0);
        prop_assert!(j.force_slide >= -slack * j.force_per_slide);
        prop_assert!(j.torque_rim >= -slack * (j.torque_rim.abs() + j.mixed.abs()));
        let [one, other] = [j.force_slide * j.torque_rim, j.mixed * j.mixed];
        // Dry friction has one zero eigenvalue, along (v, w).
        let terms = (j.force_per_slide + j.force_slide.abs()) * j.torque_rim.abs();
        prop_assert!(one - other >= -4.0 * slack * (terms + other), "{one} {other}");
    }

    #[test]
    fn powers_are_homogeneous((v, w) in speeds(), (order, alpha) in patches(), scale in 0.01..100.0_f64) {
        let tier = compact(order, alpha);
        let (near, far) = (tier.reduced_wrench(v, w), tier.reduced_wrench(scale * v, scale * w));
        let bound = (4.0 + alpha.abs()) * tolerance::IDENTITY.limit;
        // Rounding scale·v moves the ratio by a unit: near equal speeds a function that is steep
        // there (q + alpha < 0) passes on more than that.
        prop_assume!(order + alpha >= 0.0 || (v - w).abs() > 1e-3 * v.max(w));
        prop_assert!(relative(far.force, scale.powf(alpha) * near.force) <= bound);
        prop_assert!(relative(far.torque, scale.powf(alpha) * near.torque) <= bound);
    }

    #[test]
    fn dry_closed_forms_ignore_powers_of_two_to_the_bit((v, w) in speeds(), shift in -300..300_i32) {
        let scale = 2.0_f64.powi(shift);
        prop_assert_eq!(CoulombRing.reduced_wrench(v, w), CoulombRing.reduced_wrench(scale * v, scale * w));
        prop_assert_eq!(CoulombPunch.reduced_wrench(v, w), CoulombPunch.reduced_wrench(scale * v, scale * w));
        prop_assert_eq!(CoulombHertz.reduced_wrench(v, w), CoulombHertz.reduced_wrench(scale * v, scale * w));
        prop_assert_eq!(CoulombHertz.lateral(v, w), CoulombHertz.lateral(scale * v, scale * w));
        let disk = coulomb::CoulombDisk;
        prop_assert_eq!(disk.reduced_wrench(v, w), disk.reduced_wrench(scale * v, scale * w));
        let (near, far) = (disk.reduced_jacobian(v, w), disk.reduced_jacobian(scale * v, scale * w));
        prop_assert_eq!(near.force_slide, far.force_slide * scale);
        prop_assert_eq!(near.mixed, far.mixed * scale);
        prop_assert_eq!(near.torque_rim, far.torque_rim * scale);
    }

    #[test]
    fn a_ring_does_not_know_which_motion_is_which((v, w) in speeds(), alpha in -768..5_120_i32) {
        // Its elements move with v^2 + w^2 - 2 v w cos(theta), symmetric in both speeds.
        let alpha = f64::from(alpha) / 1024.0;
        let ring = compact(-1.0, alpha);
        let (here, there) = (ring.reduced_wrench(v, w), ring.reduced_wrench(w, v));
        prop_assert!(relative(here.torque, there.force) <= tolerance::IDENTITY.limit);
        prop_assert!(relative(here.force, there.torque) <= tolerance::IDENTITY.limit);
        let (here, there) = (CoulombRing.reduced_wrench(v, w), CoulombRing.reduced_wrench(w, v));
        prop_assert!(relative(here.torque, there.force) <= tolerance::IDENTITY.limit);
    }

    #[test]
    fn axisymmetric_pressure_pushes_against_the_velocity_only(
        (v, w) in speeds(), angle in 0.0..core::f64::consts::TAU, spin_is_left in any::<bool>(),
    ) {
        let spin = if spin_is_left { w } else { -w };
        let twist = Twist::new(v * angle.cos(), v * angle.sin(), spin);
        let hertz = RoundFriction::new(CoulombHertz, 0.4, 1.0).expect("in range").wrench(2.0, &twist);
        let ring = RoundFriction::new(CoulombRing, 0.4, 1.0).expect("in range").wrench(2.0, &twist);
        let disk = RoundFriction::new(coulomb::CoulombDisk, 0.4, 1.0).expect("in range").wrench(2.0, &twist);
        let most = 0.8 * (1.0 + tolerance::ROUNDING.limit);
        prop_assert!(disk.force.norm() <= most && disk.torque.abs() <= most * 2.0 / 3.0);
        for wrench in [hertz, ring, disk] {
            let (x, y) = (twist.velocity.x, twist.velocity.y);
            let size = wrench.force.x.hypot(wrench.force.y) * x.hypot(y);
            let across = wrench.force.x * y - wrench.force.y * x;
            prop_assert!(across.abs() <= tolerance::ROUNDING.limit * size);
            prop_assert!(wrench.force.x * x + wrench.force.y * y < 0.0);
            prop_assert!(wrench.torque * spin < 0.0);
        }
    }
}

#[test]
fn dry_forces_do_not_depend_on_the_unit_of_speed_down_to_the_last_octaves() {
    let orders = [-1.0, -0.9, -0.5, 0.0, 0.5, 1.0, 6.0];
    for (name, tier) in orders
        .into_iter()
        .flat_map(|order| tiers::<f64>(order, 0.0))
    {
        for (slide, rim) in [(0.75, 1.0), (1.0, 0.75), (1.0, 1.0), (0.0, 1.0)] {
            let wanted = tier.reduced_wrench(slide, rim);
            for scale in [-1070, 1020].map(|shift| 2.0_f64.powi(shift / 2).powi(2)) {
                let got = tier.reduced_wrench(slide * scale, rim * scale);
                for (got, wanted) in [(got.force, wanted.force), (got.torque, wanted.torque)] {
                    let is_same = (got - wanted).abs() <= tolerance::ROUNDING.limit * wanted;
                    assert!(is_same, "{name}: ({slide}, {rim}) x {scale:e}");
                }
            }
        }
    }
}

#[test]
fn derivatives_match_differences_from_both_sides_of_the_symmetry() {
    let mut worst = Worst::of("analytic - Richardson (of F/v + G)");
    let mut rng = Lcg::new(23);
    for _ in 0..3_000 {
        let (order, alpha) = (rng.between(-1.0, 6.0), rng.between(-0.75, 10.0));
        let minor = rng.between(0.1, 0.9);
        let (v, w) = if rng.unit() < 0.5 {
            (minor, 1.0)
        } else {
            (1.0, minor)
        };
        let tier = compact(order, alpha);
        let step = 0.125 * minor.min(1.0 - minor);
        let along_v = |f: &dyn Fn(f64, f64) -> f64| richardson(|d| f(v + d, w), step);
        let along_w = |f: &dyn Fn(f64, f64) -> f64| richardson(|d| f(v, w + d), step);
        let force = |v: f64, w: f64| tier.reduced_wrench(v, w).force;
        let torque = |v: f64, w: f64| tier.reduced_wrench(v, w).torque;
        let lateral = |v: f64, w: f64| v * tier.lateral(v, w);
        let (j, l) = (tier.reduced_jacobian(v, w), tier.lateral_jacobian(v, w));
        let size = j.force_per_slide + tier.lateral(v, w);
        for (name, numeric, analytic) in [
            ("dF/dv", along_v(&force), j.force_slide),
            ("dF/dw", along_w(&force), j.mixed),
            ("dT/dv", along_v(&torque), j.mixed),
            ("dT/dw", along_w(&torque), j.torque_rim),
            ("d(vG)/dv", along_v(&lateral), l.slide),
            ("d(vG)/dw", along_w(&lateral), l.rim),
        ] {
            let place = || format!("{name}, q {order}, alpha {alpha}, ({v}, {w})");
            worst.see((numeric - analytic).abs() / size, place);
        }
    }
    worst.assert_within(&tolerance::RICHARDSON);
}

/// Central differences of six steps, each half the one before, extrapolated in the squares of the steps.
fn richardson(f: impl Fn(f64) -> f64, step: f64) -> f64 {
    let mut slopes = [0.0; 6];
    for (n, slope) in slopes.iter_mut().enumerate() {
        let h = step * 0.5_f64.powi(n as i32);
        *slope = (f(h) - f(-h)) / (2.0 * h);
    }
    for order in 1..slopes.len() {
        let gain = 4.0_f64.powi(order as i32);
        for n in 0..slopes.len() - order {
            slopes[n] = (gain * slopes[n + 1] - slopes[n]) / (gain - 1.0);
        }
    }
    slopes[0]
}

const RATIOS: [f64; 11] = [0.0, 1e-8, 0.1, 0.5, 0.9, 0.999, 1.0, 1.001, 1.4, 3.0, 1e6];
const EXPONENTS: [f64; 5] = [-0.5, 0.0, 0.5, 1.0, 3.0];

fn assert_same(
    one: &dyn LateralFriction<f64>,
    other: &dyn LateralFriction<f64>,
    bound: f64,
    label: &str,
) {
    for ratio in RATIOS {
        let (a, b) = (
            one.reduced_wrench(ratio, 1.0),
            other.reduced_wrench(ratio, 1.0),
        );
        let (ga, gb) = (one.lateral(ratio, 1.0), other.lateral(ratio, 1.0));
        for (a, b) in [(a.force, b.force), (a.torque, b.torque), (ga, gb)] {
            assert!(
                agrees(a, b, 0.0, bound),
                "{label}, eps {ratio}: {a:e} {b:e}"
            );
        }
    }
}

#[test]
fn a_thinning_annulus_becomes_the_ring_in_proportion_to_its_width() {
    for alpha in EXPONENTS {
        let disk = compact(0.0, alpha);
        let ring = compact(-1.0, alpha);
        for ratio in [0.1, 0.5, 2.0, 5.0] {
            let distance = |inner: f64| {
                let band = Annulus::new(disk, inner).expect("in range");
                let (b, r) = (
                    band.reduced_wrench(ratio, 1.0),
                    ring.reduced_wrench(ratio, 1.0),
                );
                [
                    b.force - r.force,
                    b.torque - r.torque,
                    band.lateral(ratio, 1.0) - ring.lateral(ratio, 1.0),
                ]
            };
            for (wide, thin) in distance(0.99).into_iter().zip(distance(0.999)) {
                // A difference below 1e-9 has no order left (alpha = 1: F is the same for all).
                let fades = (wide / thin - 10.0).abs() <= 0.5 || wide.abs() < 1e-9;
                assert!(fades, "alpha {alpha}, eps {ratio}: {wide:e} {thin:e}");
            }
        }
    }
}

#[test]
fn polynomials_that_are_powers_give_their_numbers() {
    let same = 4.0 * tolerance::IDENTITY.limit;
    for alpha in EXPONENTS {
        let polynomial = |pressure: &PolynomialPressure<3>| {
            LateralPolynomialTable::new(alpha, pressure).expect("in range")
        };
        let power = |order: f64| RoundTable64::new(alpha, pressure(order)).expect("in range");
        for (coefficients, order) in [
            ([1.0, 0.0, 0.0], 0.0),
            ([1.0, -1.0, 0.0], 1.0),
            ([1.0, -2.0, 1.0], 2.0),
        ] {
            let patch = PolynomialPressure::new(coefficients).expect("positive");
            assert_same(&polynomial(&patch), &power(order), same, "polynomial");
            assert!(agrees(
                patch.mean_square_radius(),
                1.0 / (order + 2.0),
                0.0,
                tolerance::ROUNDING.limit
            ));
        }
        let single = PolynomialPressure::new([7.5]).expect("positive");
        let single = LateralPolynomialTable::new(alpha, &single).expect("in range");
        assert_same(&single, &power(0.0), tolerance::ROUNDING.limit, "constant");
    }
}

#[test]
fn load_towards_the_rim_raises_the_torque_and_lowers_the_drag_of_falling_laws() {
    for alpha in [-0.5, 0.0, 0.5, 1.0, 2.0, 4.0] {
        let at_zero = |order: f64| {
            let tier = compact(order, alpha);
            [
                tier.reduced_jacobian(0.0, 1.0).force_per_slide,
                tier.reduced_wrench(0.0, 1.0).torque,
            ]
        };
        let mut last = at_zero(-1.0);
        for n in -9..60 {
            let [drag, torque] = at_zero(f64::from(n) / 10.0);
            let rise = drag - last[0];
            assert!(
                torque < last[1],
                "alpha {alpha}: the torque rises with the order"
            );
            match alpha {
                1.0 => assert!(rise.abs() <= tolerance::IDENTITY.limit),
                a if a < 1.0 => assert!(rise > 0.0, "alpha {alpha}"),
                _ => assert!(rise < 0.0, "alpha {alpha}"),
            }
            last = [drag, torque];
        }
    }
}

#[test]
fn pure_spinning_has_the_moments_of_the_pressure() {
    // T(0) = <r^(1+alpha)>: rational for odd 1 + alpha even, and pi's for Coulomb.
    use core::f64::consts::PI;
    for (order, alpha, torque) in [
        (-1.0, 0.0, 1.0),
        (-0.5, 0.0, PI / 4.0),
        (0.0, 0.0, 2.0 / 3.0),
        (0.5, 0.0, 3.0 * PI / 16.0),
        (1.0, 0.0, 8.0 / 15.0),
        (0.5, 1.0, 1.0 / 2.5),
        (0.5, 3.0, 2.0 / (2.5 * 3.5)),
        (2.0, 5.0, 6.0 / (4.0 * 5.0 * 6.0)),
    ] {
        for (name, tier) in tribos_tests::patches::tiers::<f64>(order, alpha) {
            let got = tier.reduced_wrench(0.0, 1.0).torque;
            assert!(
                relative(got, torque) <= tolerance::ROUND_TABLE.limit,
                "{name} {order} {alpha}"
            );
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
