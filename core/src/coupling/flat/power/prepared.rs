//! The functions of one variable that a power law needs, for one exponent.
//!
//! With β = 1 + α, the distance h of an edge's line from the centre of rotation and r² = h² + t²,
//! the integral that has no elementary form is
//!
//! ```text
//! |h| ∫₀ᵗ r^(β−2) dt = r^β s c F(s²),    s = t/r,   c = |h|/r,   F(z) = ₂F₁(1 − β/2, 1; 3/2; z)
//! ```
//!
//! which serves where |t| ≤ |h|. Beyond, with r as the variable of integration,
//!
//! ```text
//! ∫ r^(β−2) (1 − h²/r²)^(−1/2) dr,   (1 − y)^(−1/2) = Σ aₖ yᵏ
//!   → |h| ∫₀ᵗ r^(β−2) dt = C |h|^β + r^β c Σ aₖ c²ᵏ/(α − 2k)
//! ```
//!
//! Where a denominator ε = α − 2k is small, its term is aₖ |h|^β ((r/|h|)^ε − 1)/ε instead, which
//! becomes a logarithm at even α.

use super::fit::Fit;
use crate::coupling::table::MAX_EXPONENT;
use crate::law::{LawError, validated_exponent};
use crate::real::Real;
use crate::special::Gauss;

/// a₀ … a₂₃ for y ≤ 1/2: `chebyfit` of mpmath 1.3 for (1−y)^(−1/2) with 24 terms, to 1.7e-19.
const OUTER: [f64; 24] = [
    1.0,
    0.500_000_000_000_000_2,
    0.374_999_999_999_927_6,
    0.312_500_000_010_994_27,
    0.273_437_499_114_522_16,
    0.246_093_793_743_852_54,
    0.225_584_490_687_538_6,
    0.209_506_595_648_689_3,
    0.195_792_812_137_205_4,
    0.193_207_142_231_358_9,
    0.097_161_363_056_782_28,
    0.804_590_106_678_974_6,
    -3.921_851_678_195_697_7,
    21.175_103_518_042_43,
    -86.997_273_085_991_76,
    291.162_226_127_085_8,
    -779.947_602_775_094_4,
    1_665.646_508_246_788_3,
    -2_794.409_978_262_118_5,
    3_606.720_929_270_69,
    -3_458.817_643_608_507,
    2_326.024_036_673_335,
    -981.438_385_928_038_5,
    196.908_755_213_653_13,
];
/// The same with 16 terms, to 3e-13.
const OUTER_SINGLE: [f64; 24] = [
    0.999_999_999_999_866,
    0.500_000_000_137_138_5,
    0.374_999_976_798_313_8,
    0.312_501_545_472_057_5,
    0.273_383_677_852_923_65,
    0.247_221_558_816_391_4,
    0.210_162_732_433_806_54,
    0.354_202_110_912_858_8,
    -0.764_784_018_874_645_8,
    4.780_625_774_129_316,
    -15.722_581_790_344_35,
    39.706_991_725_369_37,
    -68.953_015_364_401_16,
    81.143_209_599_162_16,
    -57.445_953_541_784_4,
    19.306_407_693_498_813,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
];

/// A denominator below this has a term of its own, so that no other one is amplified by more than 4.
const RESONANT: f64 = 0.25;

/// The term whose denominator is small.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Resonance<R> {
    /// aₖ
    share: R,
    /// ε
    excess: R,
}

/// A friction law |v|^α, prepared for patches with straight edges.
///
/// *Size*: 127 numbers. *Cost*: about 60,000 floating-point operations in f64, once.
///
/// ```
/// use tribos_core::coupling::flat::PolygonPowerLaw;
/// let viscous = PolygonPowerLaw::new(1.0_f64)?;
/// assert_eq!(viscous.alpha(), 1.0);
/// assert!(size_of_val(&viscous) <= 1024); // bytes
/// assert!(PolygonPowerLaw::new(-1.0_f64).is_err());
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolygonPowerLaw<R> {
    pub(super) alpha: R,
    pub(super) beta: R,
    /// 1/β, 1/(β+1) and 1/(β+2)
    pub(super) inverses: [R; 3],
    /// F
    inner: Fit<R, 6>,
    /// Σ aₖ yᵏ/(α − 2k), without a resonant term.
    outer: Fit<R, 6>,
    /// C
    constant: R,
    resonance: Option<Resonance<R>>,
    /// (1 − (1−u)^α)/u
    pub(super) growth: Fit<R, 7>,
    /// ∫₀¹ u² (1 + z u²)^((α−1)/2) du
    pub(super) second: Fit<R, 4>,
    /// (∫₀¹ u (1 + z u²)^((α−1)/2) du − 1/2)/z
    pub(super) first_rate: Fit<R, 4>,
}

impl<R: Real> PolygonPowerLaw<R> {
    /// Largest exponent.
    pub const MAX_EXPONENT: f64 = MAX_EXPONENT;

    /// Prepares the law of exponent α.
    ///
    /// *Domain*: −1 < `alpha` ≤ [`PolygonPowerLaw::MAX_EXPONENT`].
    pub fn new(alpha: R) -> Result<Self, LawError> {
        let exact = validated_exponent(alpha.to_f64(), Self::MAX_EXPONENT)?;
        let beta = 1.0 + exact;
        let inner = Gauss::new(1.0 - 0.5 * beta, 1.0, 1.5);
        let (outer, resonance) = outer::<R>(exact);
        // Both forms meet where t = h = 1, r² = 2 and c² = 1/2; there r^β = 2^(β/2).
        let whole = Gauss::new(0.5 * beta, 1.0, 1.0).series(0.5).value;
        let series = horner(&outer, 0.5) * core::f64::consts::FRAC_1_SQRT_2;
        let own = resonance.map_or(0.0, |Resonance { share, excess }| {
            let log = 0.5 * core::f64::consts::LN_2;
            share * log * relative_growth(excess * log)
        });
        let constant = whole * (0.5 * inner.series(0.5).value - series) - own;
        // Rim speed over speed, and the square of the tangent of an angle between velocities.
        let turn = 0.5;
        let most = turn * turn / (1.0 - turn * turn);
        let half = 0.5 * (exact - 1.0);
        let growth = Gauss::new(1.0 - exact, 1.0, 2.0);
        let second = Gauss::new(-half, 1.5, 2.5);
        let rate = Gauss::new(1.0 - half, 1.0, 3.0);
        Ok(Self {
            alpha,
            beta: R::from_f64(beta),
            inverses: [beta, beta + 1.0, beta + 2.0].map(|sum| R::from_f64(1.0 / sum)),
            inner: Fit::new([0.0, 0.5], |z| inner.series(z).value),
            outer: Fit::of(&outer),
            constant: R::from_f64(constant),
            resonance: resonance.map(|Resonance { share, excess }| Resonance {
                share: R::from_f64(share),
                excess: R::from_f64(excess),
            }),
            growth: Fit::new([-turn, turn], |u| exact * growth.series(u).value),
            second: Fit::new([0.0, most], |z| second.series(-z).value / 3.0),
            first_rate: Fit::new([0.0, most], |z| 0.25 * half * rate.series(-z).value),
        })
    }

    /// The exponent α.
    pub fn alpha(&self) -> R {
        self.alpha
    }

    /// |h| ∫₀ᵗ r^(β−2) dt.
    #[inline(always)]
    pub(super) fn arc(&self, line: &Line<R>, corner: &Corner<R>) -> R {
        let Corner { t, r, whole, .. } = *corner;
        let cos = line.distance / r;
        if t.abs() <= line.distance {
            let sin = t / r;
            return whole * sin * cos * self.inner.at(sin * sin);
        }
        let mut arc = self.constant * line.whole + whole * cos * self.outer.at(cos * cos);
        if let Some(Resonance { share, excess }) = self.resonance {
            let log = R::HALF * (corner.log_sq - line.log_sq);
            arc += share * line.whole * log * relative_growth(excess * log);
        }
        arc.copysign(t)
    }

    /// r^β = r r^α from r, r² and ln r²; nothing where r² has too few digits.
    #[inline(always)]
    fn whole(&self, r: R, sq: R, log_sq: R) -> R {
        if sq < R::MIN_POSITIVE {
            R::ZERO
        } else {
            r * (R::HALF * self.alpha * log_sq).exp()
        }
    }
}

/// The line of an edge, seen from the centre of rotation.
pub(super) struct Line<R> {
    /// |h|
    distance: R,
    /// ln h² and |h|^β
    log_sq: R,
    whole: R,
}

impl<R: Real> Line<R> {
    /// `None` if the centre lies on it.
    #[inline(always)]
    pub(super) fn new(power: &PolygonPowerLaw<R>, h: R) -> Option<Self> {
        let sq = h * h;
        (sq >= R::MIN_POSITIVE).then(|| {
            let (distance, log_sq) = (h.abs(), sq.ln());
            Self {
                distance,
                log_sq,
                whole: power.whole(distance, sq, log_sq),
            }
        })
    }
}

/// One end of an edge.
pub(super) struct Corner<R> {
    pub(super) t: R,
    r: R,
    /// r²
    pub(super) sq: R,
    /// ln r² and r^β
    log_sq: R,
    pub(super) whole: R,
}

impl<R: Real> Corner<R> {
    #[inline(always)]
    pub(super) fn new(power: &PolygonPowerLaw<R>, h: R, t: R) -> Self {
        let sq = h * h + t * t;
        let (r, log_sq) = (sq.sqrt(), sq.ln());
        Self {
            t,
            r,
            sq,
            log_sq,
            whole: power.whole(r, sq, log_sq),
        }
    }
}

/// Coefficients aₖ/(α − 2k), and the resonant term.
fn outer<R: Real>(alpha: f64) -> ([f64; 24], Option<Resonance<f64>>) {
    let (mut terms, mut resonance) = (if R::IS_SINGLE { OUTER_SINGLE } else { OUTER }, None);
    for (k, term) in terms.iter_mut().enumerate() {
        let excess = alpha - 2.0 * k as f64;
        if excess.abs() < RESONANT {
            resonance = Some(Resonance {
                share: *term,
                excess,
            });
            *term = 0.0;
        } else {
            *term /= excess;
        }
    }
    (terms, resonance)
}

fn horner(terms: &[f64], x: f64) -> f64 {
    terms.iter().rev().fold(0.0, |sum, term| sum * x + term)
}

/// (eˣ − 1)/x
#[inline(always)]
fn relative_growth<R: Real>(x: R) -> R {
    if x == R::ZERO { R::ONE } else { x.exp_m1() / x }
}
