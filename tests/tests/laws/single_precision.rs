//! f32 tiers stay within a few units of the f64 table, evaluated at the same f32 arguments.

use tribos_core::coupling::ReducedFriction;
use tribos_core::coupling::table::DiskTable64;
use tribos_tests::reference::Reference;
use tribos_tests::sweep;
use tribos_tests::tiers;
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

/// Arguments per exponent: log-uniform, uniform and around one.
const COUNT: usize = 10_000;

/// True where the number and its power are normal f32 with room for the intermediate products.
fn in_range(x: f64) -> bool {
    let normal = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    x == 0.0 || normal.contains(&x)
}

/// Worst force and torque of the tiers called `tier_name` over `alphas`, by `measure`.
fn wrench(
    quantities: [&'static str; 2],
    tier_name: &str,
    alphas: &[f64],
    measure: impl Fn(&Reference, f32) -> f64,
) -> [Worst; 2] {
    let [mut force, mut torque] = quantities.map(Worst::of);
    let mut ratios = sweep::ratios_f32(COUNT);
    ratios.extend(FOUND_WORST);
    for &alpha in alphas {
        // The f32 tier has the f32 exponent.
        let alpha = f64::from(alpha as f32);
        let wide = DiskTable64::new(alpha).unwrap();
        let tiers = tiers::exact::<f32>(alpha);
        let (_, tier) = tiers.iter().find(|(name, _)| *name == tier_name).unwrap();
        for &ratio in &ratios {
            let wanted = wide.reduced_wrench(f64::from(ratio), 1.0);
            if !in_range(wanted.force) || !in_range(wanted.torque) {
                continue;
            }
            let got = tier.reduced_wrench(ratio, 1.0);
            let place = || format!("alpha {alpha}, eps {ratio:e}");
            force.see(measure(&Reference::exact(wanted.force), got.force), place);
            torque.see(measure(&Reference::exact(wanted.torque), got.torque), place);
        }
    }
    [force, torque]
}

fn assert_all(worst: &[Worst], bound: &Bound) {
    for worst in worst {
        worst.assert_within(bound);
    }
}

const MODERATE: [f64; 13] = [
    -0.75, -0.5, -0.25, -0.05, 0.0, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0,
];

const STEEP: [f64; 3] = [7.0, 9.0, 10.0];

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

#[test]
fn coulomb_table_stays_within_five_ulps() {
    let names = ["f32 coulomb table F (ulp)", "f32 coulomb table T (ulp)"];
    let worst = wrench(names, "coulomb table", &[0.0], Reference::ulps_f32);
    assert_all(&worst, &tolerance::SINGLE_ULPS);
}

#[test]
fn power_tables_stay_within_five_ulps() {
    let names = [
        "f32 table F, alpha [-0.75, 5] (ulp)",
        "f32 table T, alpha [-0.75, 5] (ulp)",
    ];
    let worst = wrench(names, "table", &MODERATE, Reference::ulps_f32);
    assert_all(&worst, &tolerance::SINGLE_ULPS);
    let names = [
        "f32 table F, alpha [7, 10] (ulp)",
        "f32 table T, alpha [7, 10] (ulp)",
    ];
    let [force, torque] = wrench(names, "table", &STEEP, Reference::ulps_f32);
    force.assert_excused(&tolerance::SINGLE_STEEP_ULPS, &tolerance::SINGLE_ULPS);
    torque.assert_excused(&tolerance::SINGLE_STEEP_ULPS, &tolerance::SINGLE_ULPS);
}

#[test]
fn compact_powers_stay_within_five_ulps_for_every_tabulated_exponent() {
    let names = [
        "f32 compact F, alpha [-0.75, 10] (ulp)",
        "f32 compact T, alpha [-0.75, 10] (ulp)",
    ];
    let alphas = [&MODERATE[..], &STEEP[..]].concat();
    let worst = wrench(names, "compact", &alphas, Reference::ulps_f32);
    assert_all(&worst, &tolerance::SINGLE_ULPS);
}

#[test]
fn tables_close_to_minus_one_lose_digits_of_the_torque_only() {
    let alphas = [-0.99, -0.95, -0.9];
    let names = [
        "f32 table F, alpha [-0.99, -0.9] (ulp)",
        "f32 table T, alpha [-0.99, -0.9] (ulp)",
    ];
    let [force, torque] = wrench(names, "table", &alphas, Reference::ulps_f32);
    force.assert_within(&tolerance::SINGLE_ULPS);
    torque.assert_excused(&tolerance::SINGLE_DEEP_ULPS, &tolerance::SINGLE_ULPS);
    let names = [
        "f32 compact F, alpha [-0.99, -0.9] (ulp)",
        "f32 compact T, alpha [-0.99, -0.9] (ulp)",
    ];
    let worst = wrench(names, "compact", &alphas, Reference::ulps_f32);
    assert_all(&worst, &tolerance::SINGLE_ULPS);
}

#[test]
fn elliptic_coulomb_stays_within_its_bound() {
    let names = ["f32 AGM F", "f32 AGM T"];
    let worst = wrench(names, "coulomb compact", &[0.0], |wanted, got| {
        wanted.relative(f64::from(got))
    });
    assert_all(&worst, &tolerance::SINGLE_AGM);
}

#[test]
fn derivatives_stay_within_their_bound() {
    let mut worst = Worst::of("f32 Jacobian, alpha [-0.75, 5] (of F/v)");
    for alpha in MODERATE {
        let alpha = f64::from(alpha as f32);
        let wide = DiskTable64::new(alpha).unwrap();
        for (name, tier) in tiers::exact::<f32>(alpha) {
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
