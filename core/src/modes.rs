//! Final motion: the limit of the velocity ratio ε = v/(ωR) of a free slider.
//!
//! With C = I/(M R²) the equations of motion (3.25) give the autonomous equation
//! dε/d(−ln ω) = g(ε) = ε − C F/T (3.27). Its zeros are the fixed points: ε = 0 (pure spinning),
//! ε = ∞ (pure sliding) and where C_α(ε) = ε T/F, the quotient Χ/Φ of [`crate::coupling::PowerLawFriction`],
//! passes C. For the pressures (1−r²)^q the ends of C_α are 1/n and (1+α)/(2(q+2)) with
//! n = q + (3+α)/2; it falls from one to the other for α < 1 and rises for α > 1 (checked for
//! −1 ≤ q ≤ 6 and −0.9 ≤ α ≤ 9), hence ε₀ is unique, stable for α < 1 and unstable for α > 1.

use crate::coupling::{DominantSpeed, PowerLawFriction, Speeds};
use crate::law::{LawError, validated_positive};
use crate::real::Real;

/// How ε moves near a fixed point.
///
/// ```
/// use tribos_core::coupling::{compact::CompactPower, coulomb::CoulombDisk};
/// use tribos_core::modes::{TerminalMotion, Stability};
/// // A puck under dry friction leaves pure spinning, a thick hoop returns to it.
/// let [puck, hoop] = [0.5, 0.8_f64].map(|inertia| TerminalMotion::new(CoulombDisk, inertia));
/// assert_eq!(puck?.fixed_points().spinning, Stability::Unstable);
/// assert_eq!(hoop?.fixed_points().spinning, Stability::Stable);
/// // Oil slows both motions of a puck alike.
/// let oiled = TerminalMotion::new(CompactPower::new(1.0_f64)?, 0.5)?;
/// assert_eq!(oiled.fixed_points().spinning, Stability::Semistable);
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Stability {
    /// A small change of ε decays.
    Stable,
    /// A small change of ε stays (α = 1 with C = ⟨r²⟩, 1/2 for the uniform disk).
    Semistable,
    /// A small change of ε grows.
    Unstable,
}

/// All fixed points of one slider.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::modes::{FixedPoints, TerminalMotion, Stability};
/// let FixedPoints { spinning, finite, sliding } = TerminalMotion::new(CoulombDisk, 0.5_f64)?.fixed_points();
/// // Between two ends that it leaves there is one ratio to which the motion tends.
/// assert_eq!([spinning, sliding], [Stability::Unstable; 2]);
/// assert!(finite.is_some_and(|(_, stability)| stability == Stability::Stable));
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FixedPoints<R> {
    /// Stability of pure spinning, ε = 0.
    pub spinning: Stability,
    /// The finite fixed point ε₀, where there is exactly one.
    pub finite: Option<(R, Stability)>,
    /// Stability of pure sliding, ε = ∞.
    pub sliding: Stability,
}

/// The motion that dominates just before rest.
///
/// ```
/// use tribos_core::coupling::coulomb::CoulombDisk;
/// use tribos_core::modes::{TerminalMode, TerminalMotion};
/// // A disk loaded at its rim, one loaded at its hub, and a plain one, all thrown with v = ωR.
/// let last = |inertia: f64| Ok(TerminalMotion::new(CoulombDisk, inertia)?.terminal_mode(1.0));
/// assert_eq!(last(0.8)?, TerminalMode::Spinning);
/// assert_eq!(last(0.2)?, TerminalMode::Sliding);
/// assert!(matches!(last(0.5)?, TerminalMode::Together { ratio } if ratio > 0.6 && ratio < 0.7));
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum TerminalMode<R> {
    /// ε → 0.
    Spinning,
    /// ε → ∞.
    Sliding,
    /// Both motions fade in the fixed proportion ε.
    Together {
        /// The ratio they approach or keep.
        ratio: R,
    },
}

/// `ratio` if positive and finite.
pub(crate) fn validated_inertia_ratio<R: Real>(ratio: R) -> Result<R, LawError> {
    validated_positive("inertia ratio C = I/(M R^2)", ratio)
}

/// Limits of C between which a finite fixed point exists, (c_min, c_max), for the pressure
/// (1−r²)^`order` (for the uniform disk, order 0: table 3.2).
///
/// *Domain*: α > −1, order ≥ −1.
///
/// ```
/// use tribos_core::modes::inertia_interval;
/// // Uniform pressure and dry friction: from 1/4 to 2/3. A plain disk, 1/2, slides and spins to
/// // the end; a hoop, 1, only spins.
/// let (least, most) = inertia_interval(0.0, 0.0);
/// assert_eq!((least, most), (0.25, 2.0 / 3.0));
/// ```
pub fn inertia_interval<R: Real>(alpha: R, order: R) -> (R, R) {
    in_order(crate::coupling::inertia_ends(alpha, order))
}

fn in_order<R: Real>([spinning, sliding]: [R; 2]) -> (R, R) {
    if spinning < sliding {
        (spinning, sliding)
    } else {
        (sliding, spinning)
    }
}

/// The final motion of sliders that share a law and an inertia ratio.
///
/// ```
/// use tribos_core::{coupling::coulomb::CoulombDisk, modes::TerminalMotion};
/// let disk = TerminalMotion::new(CoulombDisk, 0.5_f64)?;
/// let ratio = disk.finite_fixed_point().unwrap_or(f64::NAN);
/// assert!((ratio - 0.653001789206).abs() < 1e-12);
/// // There C_α is the disk's own inertia, and the ratio does not change any more.
/// assert!((disk.inertia_ratio_of(ratio) - 0.5).abs() < 1e-13);
/// assert!(disk.growth(ratio).abs() < 1e-13);
/// assert!(disk.growth(0.5) > 0.0 && disk.growth(1.0) < 0.0);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TerminalMotion<R, P> {
    profile: P,
    inertia_ratio: R,
}

impl<R: Real, P: PowerLawFriction<R>> TerminalMotion<R, P> {
    /// *Domain*: 0 < `inertia_ratio` < ∞; 1/2 for a disk on its own face.
    pub fn new(profile: P, inertia_ratio: R) -> Result<Self, LawError> {
        Ok(Self {
            profile,
            inertia_ratio: validated_inertia_ratio(inertia_ratio)?,
        })
    }

    /// g(ε) = ε − C F/T, the growth of ε per e-fold of spin-down (3.27).
    ///
    /// *Domain*: ε ≥ 0. *Accuracy*: a few ulp of ε·max(1, C/C_α).
    pub fn growth(&self, ratio: R) -> R {
        ratio * (R::ONE - self.inertia_ratio / self.inertia_ratio_of(ratio))
    }

    /// C_α(ε) = ε T/F: the inertia ratio for which ε is a fixed point.
    ///
    /// *Domain*: 0 ≤ ε ≤ ∞.
    pub fn inertia_ratio_of(&self, ratio: R) -> R {
        let at = if ratio > R::ONE {
            Speeds::from_ratio(DominantSpeed::Sliding, R::ONE / ratio)
        } else {
            Speeds::from_ratio(DominantSpeed::Spinning, ratio)
        };
        let [phi, chi] = self.profile.factors(&at);
        chi / phi
    }

    /// The limits of C between which there is a finite fixed point, (c_min, c_max).
    pub fn inertia_interval(&self) -> (R, R) {
        in_order(self.profile.inertia_ends())
    }

    /// The finite fixed point ε₀, if C lies inside the interval of [`inertia_interval`].
    ///
    /// *Accuracy*: bracketed to neighbouring numbers; the last digits are those of Φ'/Φ divided by
    /// the slope of C_α (1e-13 for the disk with C = 1/2 and any α ≠ 1). *Cost*: about ten
    /// evaluations of C_α.
    pub fn finite_fixed_point(&self) -> Option<R> {
        let c = self.inertia_ratio;
        let (least, most) = self.inertia_interval();
        let inside = c > least && c < most;
        if !inside {
            return None;
        }
        let [spinning, sliding] = self.profile.inertia_ends().map(|end| end - c);
        let at_one = self.excess(DominantSpeed::Spinning, R::ONE);
        if at_one == R::ZERO {
            return Some(R::ONE);
        }
        if changes_sign(sliding, at_one) {
            let ratio =
                balanced_ratio(&self.profile, c, DominantSpeed::Sliding, [sliding, at_one]).0;
            Some(R::ONE / ratio)
        } else {
            let ends = [spinning, at_one];
            Some(balanced_ratio(&self.profile, c, DominantSpeed::Spinning, ends).0)
        }
    }

    /// C_α − C at the smaller over the larger speed.
    fn excess(&self, lead: DominantSpeed, ratio: R) -> R {
        let at = Speeds::from_ratio(lead, ratio);
        self.profile.inertia_excess(&at, self.inertia_ratio)
    }

    /// Stability of ε = 0, ε = ∞ and of ε₀ if it exists.
    pub fn fixed_points(&self) -> FixedPoints<R> {
        let alpha = self.profile.exponent();
        let c = self.inertia_ratio;
        let [spinning, sliding] = self.profile.inertia_ends();
        if alpha == R::ONE && c == spinning {
            let all = Stability::Semistable;
            return FixedPoints {
                spinning: all,
                finite: None,
                sliding: all,
            };
        }
        // g has the sign of C_α − C; on the border itself C_α's own fall or rise decides.
        let falls = alpha < R::ONE;
        let leaves_zero = if c == spinning { !falls } else { spinning > c };
        let reaches_infinity = if c == sliding { falls } else { sliding > c };
        let stability = |stable| {
            if stable {
                Stability::Stable
            } else {
                Stability::Unstable
            }
        };
        FixedPoints {
            spinning: stability(!leaves_zero),
            finite: self
                .finite_fixed_point()
                .map(|ratio| (ratio, stability(falls))),
            sliding: stability(reaches_infinity),
        }
    }

    /// The final motion that starts with the ratio `initial`.
    ///
    /// *Domain*: 0 ≤ `initial` ≤ ∞. An unstable fixed point is kept only if hit exactly.
    pub fn terminal_mode(&self, initial: R) -> TerminalMode<R> {
        if initial == R::ZERO {
            return TerminalMode::Spinning;
        }
        if initial == R::INFINITY {
            return TerminalMode::Sliding;
        }
        let points = self.fixed_points();
        match points.finite {
            Some((ratio, Stability::Stable)) => TerminalMode::Together { ratio },
            Some((ratio, _)) if initial == ratio => TerminalMode::Together { ratio },
            Some((ratio, _)) if initial < ratio => TerminalMode::Spinning,
            Some(_) => TerminalMode::Sliding,
            None if points.spinning == Stability::Semistable => {
                TerminalMode::Together { ratio: initial }
            }
            None if points.spinning == Stability::Stable => TerminalMode::Spinning,
            None => TerminalMode::Sliding,
        }
    }
}

/// True if the two have opposite signs, neither being zero.
pub(crate) fn changes_sign<R: Real>(a: R, b: R) -> bool {
    (a > R::ZERO && b < R::ZERO) || (a < R::ZERO && b > R::ZERO)
}

/// More steps than f64 or f32 can need: every other one at least halves the interval.
const MOST_STEPS: u32 = 2_200;

/// The smaller over the larger speed at which C_α = C, given C_α − C of opposite signs `at_ends` of
/// this ratio, 0 and 1; and the number of evaluations.
///
/// Inverse quadratic interpolation in its square, where C_α is smooth, guarded by bisection.
/// *Source*: Chandrupatla, Adv. Eng. Software 28 (1997) 145.
pub(crate) fn balanced_ratio<R: Real, P: PowerLawFriction<R>>(
    profile: &P,
    inertia_ratio: R,
    lead: DominantSpeed,
    at_ends: [R; 2],
) -> (R, u32) {
    let excess = |x: R| {
        let at = Speeds::from_ratio(lead, x.sqrt());
        profile.inertia_excess(&at, inertia_ratio)
    };
    let (mut b, mut a) = (R::ZERO, R::ONE);
    let [mut at_b, mut at_a] = at_ends;
    let mut part = R::HALF;
    for step in 0..MOST_STEPS {
        let x = a + part * (b - a);
        let at_x = excess(x);
        // The third point is the one that leaves the bracket.
        let (c, at_c) = if changes_sign(at_x, at_a) {
            let third = (b, at_b);
            (b, at_b) = (a, at_a);
            third
        } else {
            (a, at_a)
        };
        (a, at_a) = (x, at_x);
        let (best, at_best) = if at_a.abs() < at_b.abs() {
            (a, at_a)
        } else {
            (b, at_b)
        };
        let least = R::EPSILON * best / (b - a).abs();
        if at_best == R::ZERO || least >= R::HALF || least.is_nan() {
            return (best.sqrt(), step + 1);
        }
        let (place, level) = ((a - b) / (c - b), (at_a - at_b) / (at_c - at_b));
        let one_less = R::ONE - level;
        part = if level * level < place && one_less * one_less < R::ONE - place {
            at_a / (at_b - at_a) * at_c / (at_b - at_c)
                + (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b)
        } else {
            R::HALF
        };
        part = if part > least { part } else { least };
        part = if part < R::ONE - least {
            part
        } else {
            R::ONE - least
        };
    }
    (R::NAN, MOST_STEPS)
}
