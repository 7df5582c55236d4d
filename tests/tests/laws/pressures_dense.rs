//! Pressures between the rows of the tables: tables and closed forms against compact powers at
//! every cell border and next to equal speeds, f32 against f64.

use tribos_core::coupling::LateralFriction;
use tribos_tests::patches::{self, PatchTier, slope_error};
use tribos_tests::reference::Reference;
use tribos_tests::sweep;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const ORDERS: [f64; 8] = [-1.0, -0.9, -0.5, 0.0, 0.5, 1.0, 2.0, 6.0];
const MODERATE: [f64; 5] = [-0.5, 0.0, 0.02, 0.5, 3.0];
const ENDS: [f64; 5] = [-0.9, -0.75, 1.5, 5.5, 10.0];
const DEEP: [f64; 1] = [-0.99];

/// Speeds (v, w) of all kinds, most of them where formulas meet.
fn speeds() -> Vec<(f64, f64)> {
    let mut ratios = sweep::ratios(150);
    ratios.extend(sweep::cell_borders());
    ratios.retain(|ratio| *ratio == 0.0 || ratio.is_normal());
    let mut out: Vec<(f64, f64)> = ratios.into_iter().map(|ratio| (ratio, 1.0)).collect();
    out.extend(sweep::nearly_equal());
    out
}

/// Worst distances of two tiers: F, T and G relative; Jacobian and gradient of vG in units of F/v
/// and of its homogeneous counterpart, or of themselves if larger.
struct Distances {
    wrench: Worst,
    jacobian: Worst,
    lateral: Worst,
}

impl Distances {
    fn of([wrench, jacobian, lateral]: [&'static str; 3]) -> Self {
        Self {
            wrench: Worst::of(wrench),
            jacobian: Worst::of(jacobian),
            lateral: Worst::of(lateral),
        }
    }

    fn see(
        &mut self,
        tier: &dyn LateralFriction<f64>,
        oracle: &dyn LateralFriction<f64>,
        (v, w): (f64, f64),
        label: &str,
    ) {
        let place = || format!("{label}, ({v:e}, {w:e})");
        let (wanted, got) = (oracle.reduced_wrench(v, w), tier.reduced_wrench(v, w));
        let [lateral, got_lateral] = [oracle, tier].map(|tier| tier.lateral(v, w));
        for (wanted, got) in [
            (wanted.force, got.force),
            (wanted.torque, got.torque),
            (lateral, got_lateral),
        ] {
            self.wrench
                .see(Reference::exact(wanted).relative(got), place);
        }
        let (wanted, got) = (oracle.reduced_jacobian(v, w), tier.reduced_jacobian(v, w));
        let drag = wanted.force_per_slide;
        for (wanted, got) in [
            (drag, got.force_per_slide),
            (wanted.force_slide, got.force_slide),
            (wanted.mixed, got.mixed),
            (wanted.torque_rim, got.torque_rim),
        ] {
            self.jacobian
                .see(slope_error(&Reference::exact(wanted), got, drag), place);
        }
        let (wanted, got) = (oracle.lateral_jacobian(v, w), tier.lateral_jacobian(v, w));
        for (wanted, got, scale) in [
            (wanted.slide, got.slide, lateral),
            (wanted.rim, got.rim, lateral * v / w),
        ] {
            self.lateral
                .see(slope_error(&Reference::exact(wanted), got, scale), place);
        }
    }
}

/// The tiers whose name `is_meant` against the compact powers.
fn against_compact(
    names: [&'static str; 3],
    orders: &[f64],
    alphas: &[f64],
    is_meant: impl Fn(&str) -> bool,
) -> Distances {
    let mut worst = Distances::of(names);
    let speeds = speeds();
    for &order in orders {
        for &alpha in alphas {
            let tiers = patches::tiers::<f64>(order, alpha);
            let (_, oracle) = find(&tiers, "round compact");
            for (name, tier) in tiers.iter().filter(|(name, _)| is_meant(name)) {
                let label = format!("{name}, q {order}, alpha {alpha}");
                for &at in &speeds {
                    worst.see(tier.as_ref(), oracle.as_ref(), at, &label);
                }
            }
        }
    }
    worst
}

fn find<'a, R>(tiers: &'a [PatchTier<R>], name: &str) -> &'a PatchTier<R> {
    let found = tiers.iter().find(|(other, _)| *other == name);
    found.expect("a tier of this name")
}

fn is_table(name: &str) -> bool {
    name.ends_with("table")
}

#[test]
fn tables_of_moderate_exponents_agree_with_compact_powers_on_every_cell() {
    let names = [
        "round table - compact, F, T, G, alpha [-0.5, 3]",
        "round table - compact, Jacobian, alpha [-0.5, 3]",
        "round table - compact, grad vG, alpha [-0.5, 3]",
    ];
    let worst = against_compact(names, &ORDERS, &MODERATE, is_table);
    worst.wrench.assert_within(&tolerance::ROUND_TABLE);
    worst
        .jacobian
        .assert_within(&tolerance::ROUND_JACOBIAN_DENSE);
    worst
        .lateral
        .assert_within(&tolerance::ROUND_LATERAL_JACOBIAN);
}

#[test]
fn tables_of_all_exponents_agree_with_compact_powers_on_every_cell() {
    let names = [
        "round table - compact, F, T, G, alpha [-0.9, 10]",
        "round table - compact, Jacobian, alpha [-0.9, 10]",
        "round table - compact, grad vG, alpha [-0.9, 10]",
    ];
    let worst = against_compact(names, &ORDERS, &ENDS, is_table);
    let (bound, general) = (&tolerance::ROUND_TABLE_ENDS, &tolerance::ROUND_TABLE);
    worst.wrench.assert_excused(bound, general);
    let general = &tolerance::ROUND_JACOBIAN_DENSE;
    worst
        .jacobian
        .assert_excused(&tolerance::ROUND_JACOBIAN_DEEP, general);
    worst
        .lateral
        .assert_within(&tolerance::ROUND_LATERAL_JACOBIAN);
    let names = [
        "round table - compact, F, T, G, alpha -0.99",
        "round table - compact, Jacobian, alpha -0.99",
        "round table - compact, grad vG, alpha -0.99",
    ];
    let worst = against_compact(names, &ORDERS, &DEEP, is_table);
    let (bound, general) = (&tolerance::ROUND_TABLE_DEEP, &tolerance::ROUND_TABLE_ENDS);
    worst.wrench.assert_excused(bound, general);
    worst
        .jacobian
        .assert_within(&tolerance::ROUND_JACOBIAN_DEEP);
    worst
        .lateral
        .assert_within(&tolerance::ROUND_LATERAL_JACOBIAN);
}

#[test]
fn derivatives_of_bulging_pressures_are_as_good_as_the_disks() {
    // Orders q >= 0: the singularity at equal speeds is at most the disk's.
    let names = [
        "round table - compact, F, T, G, q >= 0",
        "round table - compact, Jacobian, q >= 0",
        "round table - compact, grad vG, q >= 0",
    ];
    let alphas = [-0.75, -0.5, 0.0, 0.5, 3.0, 10.0];
    let worst = against_compact(names, &[0.0, 0.5, 1.0, 2.0, 6.0], &alphas, is_table);
    worst.wrench.assert_within(&tolerance::ROUND_TABLE_ENDS);
    worst.jacobian.assert_within(&tolerance::JACOBIAN_DENSE);
    worst.lateral.assert_within(&tolerance::JACOBIAN_DENSE);
}

#[test]
fn closed_forms_agree_with_compact_powers_even_next_to_equal_speeds() {
    let names = [
        "punch, Hertz F, T, G",
        "punch, Hertz Jacobian",
        "punch, Hertz grad vG",
    ];
    let worst = against_compact(names, &[-0.5, 0.5], &[0.0], |name| {
        name.starts_with("closed")
    });
    worst.wrench.assert_within(&tolerance::CLOSED);
    worst.jacobian.assert_within(&tolerance::CLOSED_JACOBIAN);
    worst.lateral.assert_within(&tolerance::CLOSED_JACOBIAN);
    let names = ["ring F, T, G", "ring Jacobian", "ring grad vG"];
    let worst = against_compact(names, &[-1.0], &[0.0], |name| name == "closed ring");
    worst.wrench.assert_within(&tolerance::AGM);
    worst.jacobian.assert_within(&tolerance::AGM);
    worst.lateral.assert_within(&tolerance::AGM);
}

/// F, T and G of the f32 tiers against f64 ones at the same arguments, in ulp of f32.
fn single(
    quantity: &'static str,
    orders: &[f64],
    alphas: &[f64],
    is_meant: impl Fn(&str) -> bool,
) -> Worst {
    let mut worst = Worst::of(quantity);
    let (tiny, huge) = (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX));
    let ratios = sweep::ratios_f32(3000);
    for &order in orders {
        // The f32 tier has the f32 exponent.
        for alpha in alphas.iter().map(|&alpha| f64::from(alpha as f32)) {
            let order = f64::from(order as f32);
            let wide = patches::tiers::<f64>(order, alpha);
            let (_, oracle) = find(&wide, "round table");
            let single = patches::tiers::<f32>(order, alpha);
            for (name, tier) in single.iter().filter(|(name, _)| is_meant(name)) {
                for &ratio in &ratios {
                    let wanted = oracle.reduced_wrench(f64::from(ratio), 1.0);
                    let lateral = oracle.lateral(f64::from(ratio), 1.0);
                    let got = tier.reduced_wrench(ratio, 1.0);
                    let place = || format!("{name}, q {order}, alpha {alpha}, eps {ratio:e}");
                    for (wanted, got) in [
                        (wanted.force, got.force),
                        (wanted.torque, got.torque),
                        (lateral, tier.lateral(ratio, 1.0)),
                    ] {
                        if (tiny..=huge).contains(&wanted) {
                            worst.see(Reference::exact(wanted).ulps_f32(got), place);
                        }
                    }
                }
            }
        }
    }
    worst
}

#[test]
fn single_precision_tables_stay_within_a_few_units_of_double() {
    let is_table = |name: &str| name == "round table";
    let flat = &ORDERS[..7];
    let moderate = [-0.75, -0.5, 0.0, 0.5, 3.0];
    single(
        "f32 round table, q <= 2, alpha [-0.75, 3] (ulp)",
        flat,
        &moderate,
        is_table,
    )
    .assert_within(&tolerance::SINGLE_ROUND_ULPS);
    single(
        "f32 round table, q <= 2, alpha 5 (ulp)",
        flat,
        &[5.0],
        is_table,
    )
    .assert_excused(
        &tolerance::SINGLE_ROUND_STEEP_ULPS,
        &tolerance::SINGLE_ROUND_ULPS,
    );
    let all = [-0.75, -0.5, 0.0, 0.5, 3.0, 5.0, 7.0, 10.0];
    single(
        "f32 round table, q <= 6, alpha [-0.75, 10] (ulp)",
        &ORDERS,
        &all,
        is_table,
    )
    .assert_excused(
        &tolerance::SINGLE_ROUND_ENDS_ULPS,
        &tolerance::SINGLE_ROUND_STEEP_ULPS,
    );
}

#[test]
fn single_precision_without_tables_stays_within_a_few_units_of_double() {
    let all = [-0.75, -0.5, 0.0, 0.5, 3.0, 5.0, 7.0, 10.0];
    let is_compact = |name: &str| name == "round compact";
    single(
        "f32 round compact, q <= 6, alpha [-0.75, 10] (ulp)",
        &ORDERS,
        &all,
        is_compact,
    )
    .assert_within(&tolerance::SINGLE_ROUND_COMPACT_ULPS);
    let is_closed = |name: &str| name.starts_with("closed");
    single("f32 closed forms F, T, G (ulp)", &ORDERS, &[0.0], is_closed)
        .assert_within(&tolerance::SINGLE_CLOSED_ULPS);
}
