//! Pressures between the rows of the tables: tables and closed forms against compact powers at
//! every cell border and next to equal speeds, f32 against f64.

use tribos_core::coupling::LateralFriction;
use tribos_tests::patches::{self, PatchTier, numbers, slope_error};
use tribos_tests::reference::Reference;
use tribos_tests::sweep;
use tribos_tests::tolerance::{self, Bound};
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

/// A comparison of tiers with compact powers: of which, at which orders and exponents.
struct Line {
    tier: &'static str,
    orders: &'static [f64],
    alphas: &'static [f64],
    /// Bounds of F, T and G, relative; of the Jacobian in units of F/v and the gradient of vG in units of its
    /// homogeneous counterpart, or of themselves if larger.
    bounds: [Bound; 3],
    /// Tighter bounds which the first two do exceed.
    excused: [Option<Bound>; 2],
}

const LINES: [Line; 5] = {
    use tolerance::*;
    const fn line(
        tier: &'static str,
        orders: &'static [f64],
        alphas: &'static [f64],
        bounds: [Bound; 3],
        excused: [Option<Bound>; 2],
    ) -> Line {
        Line {
            tier,
            orders,
            alphas,
            bounds,
            excused,
        }
    }
    const BULGING: [f64; 5] = [0.0, 0.5, 1.0, 2.0, 6.0];
    const OF_BULGING: [f64; 6] = [-0.75, -0.5, 0.0, 0.5, 3.0, 10.0];
    let lateral = ROUND_LATERAL_JACOBIAN;
    [
        line(
            "table",
            &ORDERS,
            &MODERATE,
            [ROUND_TABLE, ROUND_JACOBIAN_DENSE, lateral],
            [None; 2],
        ),
        line(
            "table",
            &ORDERS,
            &ENDS,
            [ROUND_TABLE_ENDS, ROUND_JACOBIAN_DEEP, lateral],
            [Some(ROUND_TABLE), Some(ROUND_JACOBIAN_DENSE)],
        ),
        line(
            "table",
            &ORDERS,
            &DEEP,
            [ROUND_TABLE_DEEP, ROUND_JACOBIAN_DEEP, lateral],
            [Some(ROUND_TABLE_ENDS), None],
        ),
        // Orders q >= 0: the singularity at equal speeds is at most the disk's.
        line(
            "table",
            &BULGING,
            &OF_BULGING,
            [ROUND_TABLE_ENDS, JACOBIAN_DENSE, JACOBIAN_DENSE],
            [None; 2],
        ),
        line(
            "form",
            &[-1.0, -0.5, 0.0, 0.5, 1.0],
            &[0.0],
            [FORM, FORM_JACOBIAN, FORM_JACOBIAN],
            [None; 2],
        ),
    ]
};

/// Adds the distances of a tier from the oracle at one pair of speeds.
fn see(
    worst: &mut [Worst; 3],
    [oracle, tier]: [&dyn LateralFriction<f64>; 2],
    (v, w): (f64, f64),
    place: impl Fn() -> String,
) {
    let [wanted, got] = [oracle, tier].map(|tier| numbers(tier, v, w));
    let [_, _, lateral, drag, ..] = wanted;
    for (n, (wanted, got)) in wanted.into_iter().zip(got).enumerate() {
        let wanted = Reference::exact(wanted);
        let (part, error) = match n {
            0..=2 => (0, wanted.relative(got)),
            3..=6 => (1, slope_error(&wanted, got, drag)),
            7 => (2, slope_error(&wanted, got, lateral)),
            _ => (2, slope_error(&wanted, got, lateral * v / w)),
        };
        worst[part].see(error, &place);
    }
}

#[test]
fn tiers_agree_with_compact_powers_on_every_cell_and_next_to_equal_speeds() {
    let speeds = speeds();
    for line in &LINES {
        let Line {
            tier: name,
            orders,
            alphas,
            ..
        } = line;
        let label = |part| format!("{name} - compact, q {orders:?}, alpha {alphas:?}, {part}");
        let mut worst = ["F, T, G", "Jacobian", "grad vG"].map(|part| Worst::of(label(part)));
        for &order in line.orders {
            for &alpha in line.alphas {
                let tiers = patches::tiers::<f64>(order, alpha);
                let (_, oracle) = find(&tiers, "round compact");
                let is_meant = |of: &str| of.ends_with(name) || of.starts_with(name);
                for (name, tier) in tiers.iter().filter(|(of, _)| is_meant(of)) {
                    for &at in &speeds {
                        let place = || format!("{name}, q {order}, alpha {alpha}, {at:?}");
                        see(&mut worst, [oracle.as_ref(), tier.as_ref()], at, place);
                    }
                }
            }
        }
        for (worst, bound) in worst.iter().zip(&line.bounds) {
            worst.assert_within(bound);
        }
        for ((worst, bound), general) in worst.iter().zip(&line.bounds).zip(&line.excused) {
            if let Some(general) = general {
                worst.assert_excused(bound, general);
            }
        }
    }
}

fn find<'a, R>(tiers: &'a [PatchTier<R>], name: &str) -> &'a PatchTier<R> {
    let found = tiers.iter().find(|(other, _)| *other == name);
    found.expect("a tier of this name")
}

/// Exponents of the f32 tiers.
const SINGLE: [f64; 8] = [-0.75, -0.5, 0.0, 0.5, 3.0, 5.0, 7.0, 10.0];

/// A tier, its orders and exponents, the bound in ulp of f32, and a tighter one that it does exceed.
type SingleLine = (&'static str, usize, &'static [f64], Bound, Option<Bound>);

/// The f32 tiers.
const SINGLE_LINES: [SingleLine; 5] = {
    use tolerance::*;
    let (all, flat) = (ORDERS.len(), ORDERS.len() - 1);
    [
        (
            "round table",
            flat,
            &[-0.75, -0.5, 0.0, 0.5, 3.0],
            SINGLE_ROUND_ULPS,
            None,
        ),
        (
            "round table",
            flat,
            &[5.0],
            SINGLE_ROUND_STEEP_ULPS,
            Some(SINGLE_ROUND_ULPS),
        ),
        (
            "round table",
            all,
            &SINGLE,
            SINGLE_ROUND_ENDS_ULPS,
            Some(SINGLE_ROUND_STEEP_ULPS),
        ),
        (
            "round compact",
            all,
            &SINGLE,
            SINGLE_ROUND_COMPACT_ULPS,
            None,
        ),
        ("form", all, &[0.0], SINGLE_FORM_ULPS, None),
    ]
};

#[test]
fn single_precision_stays_within_a_few_units_of_double_at_the_same_arguments() {
    let (tiny, huge) = (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX));
    let ratios = sweep::ratios_f32(3000);
    for (of, orders, alphas, bound, general) in &SINGLE_LINES {
        let orders = &ORDERS[..*orders];
        let mut worst = Worst::of(format!("f32 {of}, q {orders:?}, alpha {alphas:?} (ulp)"));
        // The f32 tier has the f32 exponent.
        for alpha in alphas.iter().map(|&alpha| f64::from(alpha as f32)) {
            for order in orders.iter().map(|&order| f64::from(order as f32)) {
                let wide = patches::tiers::<f64>(order, alpha);
                let (_, oracle) = find(&wide, "round table");
                let single = patches::tiers::<f32>(order, alpha);
                for (name, tier) in single.iter().filter(|(name, _)| name.starts_with(of)) {
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
        match general {
            Some(general) => worst.assert_excused(bound, general),
            None => worst.assert_within(bound),
        }
    }
}
