//! Every local law against differences, the other precision, the ends of the range and the disk.

use std::f64::consts::PI;

use tribos_core::coupling::{ReducedFriction, quadrature::DiskQuadrature};
use tribos_core::law::{
    CoulombLaw, DryFriction, LocalLaw, LuGre, LuGreParameters, PowerLaw, Stribeck,
    StribeckParameters,
};
use tribos_core::real::Real;
use tribos_tests::laws::{differentiated, lugre, plateau, rate_state, savkoor, stribeck};
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tables::Table;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

type Named<R> = (&'static str, Box<dyn LocalLaw<R>>);

/// Every local law, at several parameters.
fn laws<R: Real + 'static>() -> Vec<Named<R>> {
    let number = R::from_f64;
    vec![
        (
            "dry",
            Box::new(DryFriction::new(number(0.5), number(0.3)).unwrap()),
        ),
        ("Stribeck 1/2", Box::new(stribeck(0.5, 0.5))),
        ("Stribeck 1", Box::new(stribeck(1.0, 0.5))),
        ("Stribeck 2", Box::new(stribeck(2.0, 0.0))),
        ("plateau -1/2", Box::new(plateau(-0.5, 0.5))),
        ("plateau -0.19", Box::new(plateau(-0.19, 0.0))),
        ("plateau 0", Box::new(plateau(0.0, 1.0))),
        ("Savkoor, wide", Box::new(savkoor(0.4))),
        ("Savkoor, narrow", Box::new(savkoor(2.0))),
        (
            "rate-and-state, weakening",
            Box::new(rate_state(0.01, 0.015, 2.0).steady()),
        ),
        (
            "rate-and-state, strengthening",
            Box::new(rate_state(0.015, 0.01, 0.0).steady()),
        ),
        (
            "rate-and-state, neutral",
            Box::new(rate_state(0.01, 0.01, 0.0).steady()),
        ),
        (
            "rate-and-state, no state",
            Box::new(rate_state(0.02, 0.0, 0.0).steady()),
        ),
        (
            "LuGre",
            Box::new(lugre().steady_per_load(number(4.0)).unwrap()),
        ),
    ]
}

#[test]
fn slopes_are_derivatives_of_friction() {
    let mut rng = Lcg::new(41);
    let mut worst = Worst::of("slope of local laws");
    for (name, law) in laws::<f64>() {
        for _ in 0..2000 {
            let v = rng.log_between(1e-9, 1e2);
            let slope = law.slope(v);
            let scale = slope.abs() + law.friction(v) / v;
            let error = (slope - differentiated(|v| law.friction(v), v)).abs() / scale;
            worst.see(error, || format!("{name}, v = {v:e}"));
        }
    }
    worst.assert_within(&tolerance::LAW_SLOPE);
}

#[test]
fn friction_is_never_negative() {
    let mut rng = Lcg::new(43);
    for (name, law) in laws::<f64>() {
        for _ in 0..2000 {
            let v = rng.log_between(1e-300, 1e300);
            assert!(law.friction(v) >= 0.0, "{name}, v = {v:e}");
            assert!(!law.slope(v).is_nan(), "{name}, v = {v:e}");
        }
    }
}

#[test]
fn limits_are_numbers_and_nan_stays_nan() {
    for (name, law) in laws::<f64>() {
        for v in special_f64().into_iter().filter(|v| !v.is_sign_negative()) {
            let (friction, slope) = (law.friction(v), law.slope(v));
            assert_eq!(friction.is_nan(), v.is_nan(), "{name}, v = {v:e}");
            assert_eq!(slope.is_nan(), v.is_nan(), "{name}, v = {v:e}");
        }
        // Negative speeds have no meaning, but do no harm.
        for v in special_f64() {
            let _ = (law.friction(v), law.slope(v));
        }
    }
    for (name, law) in laws::<f32>() {
        for v in [0.0, 1e-45, f32::MIN_POSITIVE, 1.0, f32::MAX, f32::INFINITY] {
            assert!(law.friction(v) >= 0.0, "{name}, v = {v:e}");
            assert!(!law.slope(v).is_nan(), "{name}, v = {v:e}");
        }
        assert!(law.friction(f32::NAN).is_nan() && law.slope(f32::NAN).is_nan());
    }
}

#[test]
fn both_precisions_agree() {
    let mut rng = Lcg::new(47);
    let mut worst = Worst::of("local laws in f32");
    for ((name, single), (_, double)) in laws::<f32>().into_iter().zip(laws::<f64>()) {
        for _ in 0..2000 {
            let v = rng.log_between(1e-9, 1e2) as f32;
            let (friction, slope) = (double.friction(f64::from(v)), double.slope(f64::from(v)));
            let error = (f64::from(single.friction(v)) - friction).abs() / friction;
            worst.see(error, || format!("{name}, friction at {v:e}"));
            let scale = slope.abs() + friction / f64::from(v);
            let error = (f64::from(single.slope(v)) - slope).abs() / scale;
            worst.see(error, || format!("{name}, slope at {v:e}"));
        }
    }
    worst.assert_within(&tolerance::LAW_SINGLE);
}

#[test]
fn laws_compose_with_the_disk() {
    // Purely viscous friction k v on a disk: force k v, torque k w/2 in reduced units.
    let dry = DryFriction::new(0.0_f64, 0.0).unwrap();
    let viscous = DiskQuadrature::new(
        Stribeck::new(StribeckParameters {
            dry,
            speed: 1.0,
            exponent: 2.0,
            viscous: 0.7,
        })
        .unwrap(),
    );
    // Dry friction on a disk is Coulomb's.
    let dry = DiskQuadrature::new(DryFriction::new(0.5_f64, 0.3).unwrap());
    let coulomb = DiskQuadrature::new(CoulombLaw::new(0.3_f64).unwrap());
    // α = −1/2 far above the plateau is the power law.
    let ice = DiskQuadrature::new(plateau::<f64>(-0.5, 0.5));
    let power = DiskQuadrature::new(PowerLaw::new(-0.5_f64, 0.008).unwrap());
    let mut rng = Lcg::new(53);
    let mut worst = Worst::of("linear law on a disk");
    for _ in 0..200 {
        let (v, w) = (rng.log_between(0.1, 10.0), rng.log_between(0.1, 10.0));
        let got = viscous.reduced_wrench(v, w);
        for (got, wanted) in [(got.force, 0.7 * v), (got.torque, 0.35 * w)] {
            worst.see((got / wanted - 1.0).abs(), || format!("({v}, {w})"));
        }
        assert_eq!(dry.reduced_wrench(v, w), coulomb.reduced_wrench(v, w));
        let (ice, power) = (ice.reduced_wrench(v, 0.0), power.reduced_wrench(v, 0.0));
        assert!((ice.force / power.force - 1.0).abs() < 1e-6);
    }
    worst.assert_within(&tolerance::LINEAR_ON_DISK);
    for v in [0.0, 1e-9, 1.0] {
        let at_low = DiskQuadrature::new(plateau::<f64>(-0.5, 0.5)).reduced_jacobian(v, 0.0);
        assert!(at_low.force_per_slide > 0.0);
    }
}

/// F of a disk by 100,000 angles of its rim: v⟨2 sin²θ g(ρ)/ρ⟩.
fn force_by_the_rim(law: &impl LocalLaw<f64>, v: f64, w: f64) -> f64 {
    let count = 100_000;
    let sum: f64 = (0..count)
        .map(|i| {
            let (sin, cos) = (PI * (f64::from(i) + 0.5) / f64::from(count)).sin_cos();
            let speed = (v * v + w * w - 2.0 * v * w * cos).sqrt();
            2.0 * sin * sin * law.friction(speed) / speed
        })
        .sum();
    v * sum / f64::from(count)
}

fn see_disk(worst: &mut Worst, name: &str, law: impl LocalLaw<f64>, range: (f64, f64)) {
    let disk = DiskQuadrature::new(law);
    let mut rng = Lcg::new(83);
    for i in 0..40 {
        let mut speed = || rng.log_between(range.0, range.1);
        // Every fourth disk rolls off its rim, where one point of it is at rest.
        let (v, w) = (speed(), speed());
        let w = if i % 4 == 0 { v } else { w };
        let wanted = force_by_the_rim(disk.law(), v, w);
        let error = (disk.reduced_wrench(v, w).force / wanted - 1.0).abs();
        worst.see(error, || format!("{name}, ({v:e}, {w:e})"));
    }
}

#[test]
fn quadrature_serves_laws_with_several_regimes() {
    let mut worst = Worst::of("laws with several regimes on a disk");
    let weakening = rate_state(0.01, 0.015, 2.0).steady();
    see_disk(&mut worst, "rate-and-state", weakening, (1e-6, 1.0));
    see_disk(&mut worst, "Stribeck", stribeck(2.0, 0.5), (1e-3, 0.1));
    see_disk(&mut worst, "plateau", plateau(-0.5, 0.5), (1e-5, 1.0));
    see_disk(&mut worst, "Savkoor", savkoor(0.4), (1e-3, 10.0));
    let joint = lugre().steady_per_load(4.0).unwrap();
    see_disk(&mut worst, "LuGre", joint, (1e-4, 1e-2));
    worst.assert_within(&tolerance::REGIMES_ON_DISK);
}

#[test]
fn force_and_torque_of_laws_with_several_regimes_are_those_of_the_table() {
    let mut worst = Worst::of("F and T of laws with several regimes on a disk, of the larger");
    for row in Table::read("regimes.csv").rows() {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(|column| row.number(column));
        let law: Box<dyn LocalLaw<f64>> = match row.text("law") {
            "stribeck" => {
                let dry = DryFriction::new(a, b).unwrap();
                Box::new(
                    Stribeck::new(StribeckParameters {
                        dry,
                        speed: c,
                        exponent: d,
                        viscous: row.number("e"),
                    })
                    .unwrap(),
                )
            }
            "lugre" => {
                let joint = LuGre::new(LuGreParameters {
                    coulomb_force: a,
                    static_force: b,
                    stribeck_speed: c,
                    stiffness: 1e5,
                    bristle_damping: 300.0,
                    viscous_damping: d,
                });
                Box::new(joint.unwrap().steady_per_load(1.0).unwrap())
            }
            other => panic!("no law {other} here"),
        };
        let [v, w] = ["v", "w"].map(|column| row.number(column));
        let got = DiskQuadrature::new(law.as_ref()).reduced_wrench(v, w);
        let (force, torque) = (row.number("force"), row.number("torque"));
        let error = (got.force - force).abs().max((got.torque - torque).abs());
        worst.see(error / force.abs().max(torque.abs()), || {
            format!("{} {a} {b} {c} {d}, ({v}, {w})", row.text("law"))
        });
    }
    worst.assert_within(&tolerance::REGIMES_ON_DISK);
}
