//! Speeds of the whole range of both types: every result is right, infinite or zero as it must be.

use tribos_core::coupling::compact::CompactPower;
use tribos_core::coupling::quadrature::DiskQuadrature;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{Annulus, LateralFriction};
use tribos_core::law::PowerLaw;
use tribos_tests::patches::{self, PatchTier, RESULTS, RoundTabulated, numbers, plain_numbers};
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::Table;
use tribos_tests::tolerance::{self, Bound};
use tribos_tests::worst::Worst;

/// What a type can hold.
#[derive(Clone, Copy)]
struct Range {
    /// Subnormal numbers may be off by two of these: rounding of a factor and of the product.
    smallest: f64,
    /// Share of the largest number from which on infinity will do.
    end: f64,
    largest: f64,
    lowest: i32,
    highest: i32,
}

trait Ranged: RoundTabulated {
    const RANGE: Range;
    const NAME: &'static str;
    const WRENCH: Bound;
    const JACOBIAN: Bound;
}

impl Ranged for f64 {
    const RANGE: Range = Range {
        smallest: 5e-324,
        end: 1.0 - 1e-13,
        largest: f64::MAX,
        lowest: -1074,
        highest: 1023,
    };
    const NAME: &'static str = "f64";
    const WRENCH: Bound = tolerance::RANGES;
    const JACOBIAN: Bound = tolerance::RANGES_JACOBIAN;
}

impl Ranged for f32 {
    const RANGE: Range = Range {
        smallest: 1.401_298_464_324_817e-45,
        end: 1.0 - 1e-5,
        largest: f32::MAX as f64,
        lowest: -149,
        highest: 127,
    };
    const NAME: &'static str = "f32";
    const WRENCH: Bound = tolerance::RANGES_SINGLE;
    const JACOBIAN: Bound = tolerance::RANGES_SINGLE_JACOBIAN;
}

/// Error over the larger of the number and `unit`, less what subnormal numbers cannot hold. Beyond
/// the range only the infinity will do, and next to its end the infinity too.
fn error(range: &Range, [wanted, unit]: [f64; 2], got: f64) -> f64 {
    let infinite = f64::INFINITY.copysign(wanted);
    let next_to_the_end = |x: f64| x.abs() >= range.largest * range.end && x * infinite > 0.0;
    if got == wanted || next_to_the_end(wanted) && next_to_the_end(got) {
        return 0.0;
    }
    let unheld = 2.0 * range.smallest;
    let beyond = (got - wanted).abs() - unheld;
    if beyond <= 0.0 {
        0.0
    } else {
        beyond / wanted.abs().max(unit)
    }
}

/// The unit of a derivative that is a difference: G for ∂(vG)/∂v under dry friction, which falls
/// with the third power of the ratio where sliding leads.
fn unit(n: usize, alpha: f64, wanted: &[f64; 9]) -> f64 {
    if n == 7 && alpha == 0.0 {
        wanted[2]
    } else {
        0.0
    }
}

fn assert_table<R: Ranged>() {
    let [mut wrench, mut jacobian] = [
        "F, T, G over the whole range",
        "derivatives over the whole range",
    ]
    .map(Worst::of);
    for row in Table::read("ranges.csv")
        .rows()
        .filter(|row| row.text("type") == R::NAME)
    {
        let [q, alpha, v, w] = ["q", "alpha", "v", "w"].map(|name| row.number(name));
        for (name, tier) in patches::tiers::<R>(q, alpha) {
            let got = numbers(tier.as_ref(), R::from_f64(v), R::from_f64(w));
            let expected = RESULTS.map(|column| row.reference(column).high);
            for (n, (column, got)) in RESULTS.into_iter().zip(got).enumerate() {
                let wanted = expected[n];
                let worst = if n < 3 { &mut wrench } else { &mut jacobian };
                let wanted = [wanted, unit(n, alpha, &expected)];
                let error = error(&R::RANGE, wanted, got);
                worst.see(error, || {
                    format!("{name}, q {q}, alpha {alpha}, ({v:e}, {w:e}): {column} {got:e}, not {wanted:?}")
                });
            }
        }
    }
    wrench.assert_within(&R::WRENCH);
    jacobian.assert_within(&R::JACOBIAN);
}

#[test]
fn speeds_of_the_whole_range_agree_with_extended_precision() {
    assert_table::<f64>();
    assert_table::<f32>();
}

/// 2^`exponent` times `x`, rounded once.
fn scaled(x: f64, exponent: i32) -> f64 {
    let mut x = x;
    let mut left = exponent;
    // Down to the last step all products are exact: the largest steps first, towards 1.
    while left != 0 {
        let step = left.clamp(-960, 960);
        let next = x * 2.0_f64.powi(step);
        if next.abs() < f64::MIN_POSITIVE && x != 0.0 && left < -960 {
            // Far below all that is left is a zero or a few units.
            return x * 2.0_f64.powi(-960) * 2.0_f64.powi((left + 960).max(-1000));
        }
        x = next;
        left -= step;
    }
    x
}

/// h below which h² changes nothing: everything is a power of h.
const SLOW: i32 = 60;

/// The leading powers of h in the nine results.
fn powers(alpha: f64, sliding_leads: bool) -> [i32; 9] {
    let (first, third) = if alpha == 0.0 { (2, 3) } else { (0, 1) };
    if sliding_leads {
        [0, 1, 1, 0, first, 1, 0, 1, 0]
    } else {
        [1, 0, 0, 0, 0, 1, first, 0, third]
    }
}

/// The results at (2^i, 2^j), from speeds of order 1 and by what a power of two does to them.
struct Homogeneous {
    alpha: f64,
    /// By which speed leads and by the exponent modulo [`PERIOD`] and the (limited) distance.
    base: Vec<[f64; 9]>,
}

/// 2^(4α) is a power of two for all exponents tried.
const PERIOD: i32 = 4;

impl Homogeneous {
    fn new(tier: &dyn LateralFriction<f64>, alpha: f64) -> Self {
        let mut base = Vec::new();
        for sliding_leads in [false, true] {
            for major in 0..PERIOD {
                for apart in 0..=SLOW {
                    let [large, small] = [major, major - apart].map(|e| 2.0_f64.powi(e));
                    base.push(if sliding_leads {
                        numbers(tier, large, small)
                    } else {
                        numbers(tier, small, large)
                    });
                }
            }
        }
        Self { alpha, base }
    }

    fn at(&self, slide: i32, rim: i32) -> [f64; 9] {
        let sliding_leads = slide > rim;
        let (major, minor) = (slide.max(rim), slide.min(rim));
        let (apart, periods) = (major - minor, major.div_euclid(PERIOD));
        let known = apart.min(SLOW);
        let index = (i32::from(sliding_leads) * PERIOD + major.rem_euclid(PERIOD)) * (SLOW + 1);
        let mut out = self.base[(index + known) as usize];
        for (n, (x, power)) in out
            .iter_mut()
            .zip(powers(self.alpha, sliding_leads))
            .enumerate()
        {
            // F, T, G and the gradient of vG go with the speed to the power α, the rest with α − 1.
            let degree = if (3..7).contains(&n) {
                self.alpha - 1.0
            } else {
                self.alpha
            };
            let exponent = (f64::from(PERIOD * periods) * degree) as i32 - power * (apart - known);
            *x = scaled(*x, exponent);
        }
        out
    }
}

/// All pairs of `exponents` on one tier.
fn see_grid<R: Ranged>(
    worst: &mut [Worst; 2],
    tier: &PatchTier<R>,
    wide: &dyn LateralFriction<f64>,
    alpha: f64,
    pairs: &[(i32, i32)],
) {
    see_grid_in(&R::RANGE, worst, tier, wide, alpha, pairs);
}

/// [`see_grid`] with another idea of the smallest number.
fn see_grid_in<R: Ranged>(
    range: &Range,
    worst: &mut [Worst; 2],
    (name, tier): &PatchTier<R>,
    wide: &dyn LateralFriction<f64>,
    alpha: f64,
    pairs: &[(i32, i32)],
) {
    let expected = Homogeneous::new(wide, alpha);
    for &(i, j) in pairs {
        let [v, w] = [i, j].map(|e| R::from_f64(scaled(1.0, e)));
        let got = numbers(tier.as_ref(), v, w);
        let expected = expected.at(i, j);
        for (n, (wanted, got)) in expected.into_iter().zip(got).enumerate() {
            let part = usize::from(n >= 3);
            let wanted = [wanted, unit(n, alpha, &expected)];
            let error = error(range, wanted, got);
            worst[part].see(error, || {
                format!(
                    "{name}, alpha {alpha}, (2^{i}, 2^{j}): {} {got:e}, not {wanted:?}",
                    RESULTS[n]
                )
            });
        }
    }
}

/// Exponents α with 4α a whole number, and orders q.
const EXPONENTS: [f64; 8] = [-0.75, -0.5, 0.0, 0.25, 1.0, 2.0, 3.5, 10.0];
const ORDERS: [f64; 4] = [-1.0, -0.5, 0.0, 0.5];

fn assert_grid<R: Ranged>(pairs: &[(i32, i32)]) {
    let mut worst = ["F, T, G at powers of two", "derivatives at powers of two"].map(Worst::of);
    for alpha in EXPONENTS {
        for order in ORDERS {
            let wide = patches::tiers::<f64>(order, alpha);
            for tier in &patches::tiers::<R>(order, alpha) {
                see_grid(&mut worst, tier, wide[0].1.as_ref(), alpha, pairs);
            }
        }
    }
    let [wrench, jacobian] = worst;
    wrench.assert_within(&R::WRENCH);
    jacobian.assert_within(&R::JACOBIAN);
}

/// Every exponent of a type with `count` random partners and with the ends.
fn pairs<R: Ranged>(count: usize) -> Vec<(i32, i32)> {
    let Range {
        lowest, highest, ..
    } = R::RANGE;
    let mut rng = Lcg::new(31);
    let mut out = Vec::new();
    for i in lowest..=highest {
        for _ in 0..count {
            let j = lowest + (rng.bits() % (highest - lowest + 1) as u64) as i32;
            out.extend([(i, j), (j, i)]);
        }
        for end in [lowest, highest, (i + 60).min(highest), (i - 1).max(lowest)] {
            out.extend([(i, end), (end, i)]);
        }
    }
    out
}

#[test]
fn every_power_of_two_in_double_precision() {
    assert_grid::<f64>(&pairs::<f64>(1));
}

#[test]
fn every_power_of_two_in_single_precision() {
    assert_grid::<f32>(&pairs::<f32>(8));
}

#[test]
fn tables_of_polynomials_at_every_power_of_two() {
    let mut worst = ["F, T, G, polynomial", "derivatives, polynomial"].map(Worst::of);
    for alpha in EXPONENTS {
        let table = || f64::polynomial_table(alpha).expect("in range");
        let tier: PatchTier<f64> = ("polynomial", table());
        see_grid(&mut worst, &tier, &*table(), alpha, &pairs::<f64>(1));
    }
    let [wrench, jacobian] = worst;
    wrench.assert_within(&tolerance::RANGES);
    jacobian.assert_within(&tolerance::RANGES_JACOBIAN);
}

/// The annulus' results against those of speeds of order 1: powers of two change nothing.
fn see_annulus<R: Ranged>(worst: &mut [Worst; 2], alpha: f64, inner: f64, pairs: &[(i32, i32)]) {
    let band = |disk| Annulus::new(disk, inner).expect("in range");
    let wide = band(CompactPower::new(alpha).expect("in range"));
    let narrow = CompactPower::new(R::from_f64(alpha)).expect("in range");
    let narrow = Annulus::new(narrow, R::from_f64(inner)).expect("in range");
    let tier: PatchTier<R> = ("annulus", Box::new(narrow));
    // Two disks' last places, divided by 1 − k.
    let range = Range {
        smallest: 16.0 * R::RANGE.smallest,
        // Where the disk's results leave the range the annulus' may still be in it.
        end: 1.0 / 16.0,
        ..R::RANGE
    };
    see_grid_in(&range, worst, &tier, &wide, alpha, pairs);
}

#[test]
fn annuli_at_every_power_of_two() {
    let mut worst = ["F, T, G, annuli", "derivatives, annuli"].map(Worst::of);
    for alpha in EXPONENTS {
        for inner in [0.0, 0.5, 0.875] {
            // The rim speed within is a normal number, and the whole disk's derivatives are.
            let mut pairs = pairs::<f64>(1);
            pairs.retain(|(slide, rim)| {
                let degree = f64::from(*slide.max(rim)) * (alpha - 1.0);
                *rim >= -1018 && degree.abs() < 1000.0
            });
            see_annulus::<f64>(&mut worst, alpha, inner, &pairs);
        }
    }
    let [wrench, jacobian] = worst;
    wrench.assert_within(&tolerance::RANGES);
    jacobian.assert_within(&tolerance::RANGES_JACOBIAN);
}

#[test]
fn quadrature_at_every_power_of_two() {
    let mut worst = [
        "F, T, quadrature",
        "derivatives, quadrature",
        "F, T, quadrature, −1/2 ≤ α ≤ 7/2",
    ]
    .map(Worst::of);
    for alpha in EXPONENTS {
        let law = PowerLaw::new(alpha, 1.0).expect("in range");
        let tier = DiskQuadrature::new(law);
        let table = DiskTable64::new(alpha).expect("in range");
        let expected = Homogeneous::new(&table, alpha);
        for (i, j) in pairs::<f64>(1) {
            // The slowest elements still move by normal numbers, and friction is one.
            let major = i.max(j);
            if major < -988 || (f64::from(major) * alpha).abs() > 1000.0 {
                continue;
            }
            let [v, w] = [i, j].map(|e| scaled(1.0, e));
            let wanted = expected.at(i, j);
            let got = plain_numbers(&tier, v, w);
            for (m, (n, got)) in [0, 1, 3, 4, 5, 6].into_iter().zip(got).enumerate() {
                // Derivatives are promised in units of F/v.
                let unit = if m < 2 { 0.0 } else { wanted[3] };
                if unit == f64::INFINITY {
                    continue;
                }
                let error = error(&f64::RANGE, [wanted[n], unit], got);
                let part = match m {
                    0 | 1 if (-0.5..=3.5).contains(&alpha) => 2,
                    0 | 1 => 0,
                    _ => 1,
                };
                worst[part].see(error, || {
                    let wanted = wanted[n];
                    format!(
                        "alpha {alpha}, (2^{i}, 2^{j}): {} {got:e}, not {wanted:e}",
                        RESULTS[n]
                    )
                });
            }
        }
    }
    let [wrench, jacobian, usual] = worst;
    wrench.assert_within(&tolerance::QUADRATURE_RANGES);
    jacobian.assert_within(&tolerance::QUADRATURE_RANGES_JACOBIAN);
    usual.assert_within(&tolerance::QUADRATURE_FALLING);
}

/// Derivatives next to equal speeds, in units of the larger of the entry and F/v: those of a ring grow
/// without bound there.
#[test]
fn derivatives_next_to_equal_speeds() {
    let [mut form, mut other] = ["fitted forms next to equal speeds", "others"].map(Worst::of);
    for row in Table::read("equal_speeds.csv").rows() {
        let [q, alpha, v] = ["q", "alpha", "v"].map(|name| row.number(name));
        for (name, tier) in patches::tiers::<f64>(q, alpha) {
            let [_, _, _, got @ .., _, _] = numbers(tier.as_ref(), v, 1.0);
            let drag = row.number("drag");
            let worst = if name.starts_with("form") {
                &mut form
            } else {
                &mut other
            };
            for (column, got) in ["drag", "F_v", "F_w", "T_w"].into_iter().zip(got) {
                let wanted = row.reference(column);
                let error = wanted.over(got, drag.max(wanted.high.abs()));
                worst.see(error, || {
                    format!("{name}, q {q}, alpha {alpha}, v {v:?} w: {column}")
                });
            }
        }
    }
    form.assert_within(&tolerance::FORM_JACOBIAN);
    other.assert_within(&tolerance::ROUND_JACOBIAN_DENSE);
}
