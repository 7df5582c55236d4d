//! f32 tiers stay within a few units of the f64 table, evaluated at the same f32 arguments.

use tribos_core::coupling::ReducedFriction;
use tribos_core::coupling::table::DiskTable64;
use tribos_tests::patches;
use tribos_tests::reference::Reference;
use tribos_tests::sweep;
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

/// Arguments per exponent: log-uniform, uniform and around one.
const COUNT: usize = 10_000;

/// True where the number and its power are normal f32 with room for the intermediate products.
fn in_range(x: f64) -> bool {
    let normal = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    x == 0.0 || normal.contains(&x)
}

const MODERATE: [f64; 13] = [
    -0.75, -0.5, -0.25, -0.05, 0.0, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0,
];

const STEEP: [f64; 3] = [7.0, 9.0, 10.0];
const DEEP: [f64; 3] = [-0.99, -0.95, -0.9];

/// Ratios that a sweep of 800,000 a exponent found worst.
const FOUND_WORST: [f32; 12] = [
    1.747_881_3,
    1.938_435_7,
    1.934_747_9,
    1.758_255_6,
    0.705_785_45,
    0.954_945_9,
    0.999_136_75,
    0.999_220_8,
    81.846_86,
    1.815_121_9,
    0.059_276,
    1.414_25,
];

/// A tier and exponents, bounds of force and torque, and a tighter one that they do exceed.
type Line = (&'static str, &'static [f64], [Bound; 2], [Option<Bound>; 2]);

const LINES: [Line; 7] = {
    use tolerance::*;
    let (few, steep) = ([SINGLE_ULPS; 2], Some(SINGLE_ULPS));
    [
        ("form disk", &[0.0], few, [None; 2]),
        ("disk table", &MODERATE, few, [None; 2]),
        ("disk table", &STEEP, [SINGLE_STEEP_ULPS; 2], [steep; 2]),
        // Close to −1 the torque alone loses digits.
        (
            "disk table",
            &DEEP,
            [SINGLE_ULPS, SINGLE_DEEP_ULPS],
            [None, steep],
        ),
        ("compact", &MODERATE, few, [None; 2]),
        ("compact", &STEEP, few, [None; 2]),
        ("compact", &DEEP, few, [None; 2]),
    ]
};

/// Sees force and torque of the tiers of this name by `measure`, over all ratios.
fn see(worst: &mut [Worst; 2], of: &str, alpha: f64, measure: impl Fn(&Reference, f32) -> f64) {
    let mut ratios = sweep::ratios_f32(COUNT);
    ratios.extend(FOUND_WORST);
    // The f32 tier has the f32 exponent.
    let alpha = f64::from(alpha as f32);
    let wide = DiskTable64::new(alpha).unwrap();
    let tiers = patches::exact::<f32>(alpha);
    let (_, tier) = tiers.iter().find(|(name, _)| *name == of).unwrap();
    for &ratio in &ratios {
        let wanted = wide.reduced_wrench(f64::from(ratio), 1.0);
        if !in_range(wanted.force) || !in_range(wanted.torque) {
            continue;
        }
        let got = tier.reduced_wrench(ratio, 1.0);
        let place = || format!("alpha {alpha}, eps {ratio:e}");
        for (worst, (wanted, got)) in worst
            .iter_mut()
            .zip([(wanted.force, got.force), (wanted.torque, got.torque)])
        {
            worst.see(measure(&Reference::exact(wanted), got), place);
        }
    }
}

#[test]
fn every_tier_stays_within_a_few_units() {
    for (of, alphas, bounds, excused) in &LINES {
        let label = |part| format!("f32 {of} {part}, alpha {alphas:?} (ulp)");
        let mut worst = ["F", "T"].map(|part| Worst::of(label(part)));
        for &alpha in *alphas {
            see(&mut worst, of, alpha, Reference::ulps_f32);
        }
        for ((worst, bound), general) in worst.iter().zip(bounds).zip(excused) {
            match general {
                Some(general) => worst.assert_excused(bound, general),
                None => worst.assert_within(bound),
            }
        }
    }
}

#[test]
fn derivatives_stay_within_their_bound() {
    let mut worst = Worst::of("f32 Jacobian, alpha [-0.75, 5] (of F/v)");
    for alpha in MODERATE {
        let alpha = f64::from(alpha as f32);
        let wide = DiskTable64::new(alpha).unwrap();
        for (name, tier) in patches::exact::<f32>(alpha) {
            for ratio in sweep::ratios_f32(COUNT / 10) {
                let wanted = wide.reduced_jacobian(f64::from(ratio), 1.0);
                let got = tier.reduced_jacobian(ratio, 1.0);
                let place = || format!("{name}, alpha {alpha}, eps {ratio:e}");
                for (wanted, got) in [
                    (wanted.force_per_slide, got.force_per_slide),
                    (wanted.force_slide, got.force_slide),
                    (wanted.mixed, got.mixed),
                ] {
                    let scale = wide.reduced_jacobian(f64::from(ratio), 1.0).force_per_slide;
                    worst.see(Reference::exact(wanted).over(f64::from(got), scale), place);
                }
            }
        }
    }
    worst.assert_within(&tolerance::SINGLE_JACOBIAN);
}
