//! Every local law against differences, the other precision, the ends of the range and the disk.

use std::f64::consts::PI;

use tribos_core::coupling::{ReducedFriction, quadrature::DiskQuadrature};
use tribos_core::law::{CoulombLaw, DryFriction, LocalLaw, PowerLaw, Stribeck, StribeckParameters};
use tribos_friction::{AnyLaw, LawParameter, Precision, find};
use tribos_tests::laws::{LAWS, LawInstance, differentiated, made, plateau, usual};
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tables::Table;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

/// The list in one precision.
fn laws<R: Precision>() -> impl Iterator<Item = (&'static LawInstance, AnyLaw<R>)> {
    LAWS.iter()
        .map(|one| (one, made(one.text).build::<R>().unwrap()))
}

#[test]
fn every_local_law_of_the_catalogue_is_in_the_list_and_means_its_text() {
    let local = tribos_friction::LAWS
        .iter()
        .filter(|entry| entry.local.is_some());
    let names: Vec<&str> = usual().iter().map(|text| made(text).name()).collect();
    assert_eq!(local.map(|entry| entry.name).collect::<Vec<_>>(), names);
    for LawInstance { text, .. } in LAWS.iter() {
        assert_eq!(made(&made(text).to_string()), made(text));
    }
}

#[test]
fn laws_keep_their_formula() {
    for (LawInstance { text, exact, .. }, law) in laws::<f64>() {
        let single = made(text).build::<f32>().unwrap();
        for &[v, mu, slope] in *exact {
            assert!(
                (law.friction(v) / mu - 1.0).abs() < 1e-15,
                "{text}, v = {v:e}"
            );
            // The exponent of a bell is up to 690.
            assert!(
                (law.slope(v) - slope).abs() <= 1e-12 * slope.abs(),
                "{text}, v = {v:e}"
            );
            let single = f64::from(single.friction(v as f32));
            assert!((single / mu - 1.0).abs() < 1e-6, "{text}, v = {v:e}");
        }
    }
}

#[test]
fn slopes_are_derivatives_of_friction() {
    let mut rng = Lcg::new(41);
    let mut worst = Worst::of("slope of local laws");
    for (LawInstance { text, .. }, law) in laws::<f64>() {
        for _ in 0..2000 {
            let v = rng.log_between(1e-9, 1e2);
            let slope = law.slope(v);
            let scale = slope.abs() + law.friction(v) / v;
            let error = (slope - differentiated(|v| law.friction(v), v)).abs() / scale;
            worst.see(error, || format!("{text}, v = {v:e}"));
        }
    }
    worst.assert_within(&tolerance::LAW_SLOPE);
}

#[test]
fn friction_is_never_negative() {
    let mut rng = Lcg::new(43);
    for (LawInstance { text, .. }, law) in laws::<f64>() {
        for _ in 0..2000 {
            let v = rng.log_between(1e-300, 1e300);
            assert!(law.friction(v) >= 0.0, "{text}, v = {v:e}");
            assert!(!law.slope(v).is_nan(), "{text}, v = {v:e}");
        }
    }
}

#[test]
fn limits_are_numbers_and_nan_stays_nan() {
    for (LawInstance { text, .. }, law) in laws::<f64>() {
        // Negative speeds have no meaning, but do no harm.
        for v in special_f64() {
            let [friction, slope] = [law.friction(v), law.slope(v)];
            let is_speed = !v.is_sign_negative();
            assert!(
                !is_speed || friction.is_nan() == v.is_nan(),
                "{text}, v = {v:e}"
            );
            assert!(
                !is_speed || slope.is_nan() == v.is_nan(),
                "{text}, v = {v:e}"
            );
        }
    }
    for (LawInstance { text, .. }, law) in laws::<f32>() {
        for v in [0.0, 1e-45, f32::MIN_POSITIVE, 1.0, f32::MAX, f32::INFINITY] {
            assert!(law.friction(v) >= 0.0, "{text}, v = {v:e}");
            assert!(!law.slope(v).is_nan(), "{text}, v = {v:e}");
        }
        assert!(law.friction(f32::NAN).is_nan() && law.slope(f32::NAN).is_nan());
    }
}

#[test]
fn both_precisions_agree() {
    let mut rng = Lcg::new(47);
    let mut worst = Worst::of("local laws in f32");
    for ((LawInstance { text, .. }, single), (_, double)) in laws::<f32>().zip(laws::<f64>()) {
        for _ in 0..2000 {
            let v = rng.log_between(1e-9, 1e2) as f32;
            let (friction, slope) = (double.friction(f64::from(v)), double.slope(f64::from(v)));
            let error = (f64::from(single.friction(v)) - friction).abs() / friction;
            worst.see(error, || format!("{text}, friction at {v:e}"));
            let scale = slope.abs() + friction / f64::from(v);
            let error = (f64::from(single.slope(v)) - slope).abs() / scale;
            worst.see(error, || format!("{text}, slope at {v:e}"));
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

#[test]
fn quadrature_serves_laws_with_several_regimes() {
    let mut worst = Worst::of("laws with several regimes on a disk");
    for (LawInstance { text, disk, .. }, law) in laws::<f64>() {
        let Some([slowest, fastest]) = *disk else {
            continue;
        };
        let disk = DiskQuadrature::new(law);
        let mut rng = Lcg::new(83);
        for i in 0..40 {
            let [v, w] = [(); 2].map(|()| rng.log_between(slowest, fastest));
            // Every fourth disk rolls off its rim, where one point of it is at rest.
            let w = if i % 4 == 0 { v } else { w };
            let wanted = force_by_the_rim(disk.law(), v, w);
            let error = (disk.reduced_wrench(v, w).force / wanted - 1.0).abs();
            worst.see(error, || format!("{text}, ({v:e}, {w:e})"));
        }
    }
    worst.assert_within(&tolerance::REGIMES_ON_DISK);
}

#[test]
fn force_and_torque_of_laws_with_several_regimes_are_those_of_the_table() {
    let mut worst = Worst::of("F and T of laws with several regimes on a disk, of the larger");
    for row in Table::read("regimes.csv").rows() {
        // The columns are the parameters in the order of the catalogue.
        let entry = find(row.text("law")).expect("a law of the catalogue");
        let given = |(parameter, column): (&LawParameter, &&str)| {
            format!("{}={}", parameter.name, row.text(column))
        };
        let columns = ["a", "b", "c", "d", "e"];
        let given = entry.parameters.iter().zip(&columns).map(given);
        let given = given
            .filter(|text| !text.ends_with('='))
            .collect::<Vec<_>>();
        let text = format!("{}:{}", entry.name, given.join(","));
        let law = made(&text).build::<f64>().unwrap();
        let [v, w] = ["v", "w"].map(|column| row.number(column));
        let got = DiskQuadrature::new(law).reduced_wrench(v, w);
        let (force, torque) = (row.number("force"), row.number("torque"));
        let error = (got.force - force).abs().max((got.torque - torque).abs());
        worst.see(error / force.abs().max(torque.abs()), || {
            format!("{text}, ({v}, {w})")
        });
    }
    worst.assert_within(&tolerance::REGIMES_ON_DISK);
}
