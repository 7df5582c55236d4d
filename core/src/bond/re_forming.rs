//! Bonds that form again where they broke.

use super::BondLaw;
use super::renewal::{mean_age, steady_age};
use crate::law::{LawError, LocalLaw, validated_positive};
use crate::real::Real;
use core::num::NonZeroU32;

/// Springs that break and re-form at once, without strain: f(d) = k A(d), with the mean age A of a renewal
/// process in the displacement d.
///
/// ```text
/// A(d) = d S(d) + ∫ A(d − x) p(x) dx,     S(d) = ∫ p(x) dx from d on,     A(∞) = ⟨x²⟩/(2⟨x⟩)
/// ```
///
/// for the density p of breaking strains x. Steady sliding meets the dynamic friction k A(∞); before,
/// bonds that were formed together also break together, which is static friction.
/// The breaking strains have Erlang's distribution of n stages with the mean x0: relative width 1/√n,
/// exponential for n = 1. [`ReformingBond::one_strength`] is the limit of large n, a sawtooth.
///
/// | stages n | 1 to 4 | 8 | 16 | 64 | 256 | 1000 | one strength |
/// |---|---|---|---|---|---|---|---|
/// | static over dynamic friction | 1 | 1.0741 | 1.2246 | 1.5119 | 1.7131 | 1.8361 | 2 |
///
/// The law is that of a displacement in one direction: re-formed bonds are strained along it. Against
/// a small strain across, all bonds resist with k.
///
/// *Units*: k in 1/length (force per load and strain), x0 in length. *Accuracy*: force 1e-14 relative
/// (f32: 1e-5); slope 1e-14 n k (f32: 1e-5). *Cost*: up to the displacement 2 x0 some 30 √n products, then about
/// √n exponentials, sines and cosines, fewer the later. *Special values*: 0 at no strain, k A(∞) at
/// infinite strain; one strength is k x0 at every multiple of x0 and k x0/2 from 1/ε strains on.
/// *Source*: D. R. Cox, Renewal Theory (1962), for A; the sums are derived in this module.
///
/// ```
/// use tribos_core::bond::{BondLaw, ReformingBond};
/// use tribos_core::law::LocalLaw;
/// let bonds = ReformingBond::new(2.0_f64, 0.5, 64)?; // 1/m, m
/// let ratio = bonds.friction(bonds.peak()) / bonds.plateau(); // static over dynamic friction
/// assert!((ratio - 1.5119).abs() < 1e-4);
/// let broad = ReformingBond::new(2.0_f64, 0.5, 1)?;
/// assert!(broad.peak().is_infinite()); // it rises to the steady value and never falls
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReformingBond<R> {
    stiffness: R,
    strain: R,
    /// `None` for one strength.
    stages: Option<NonZeroU32>,
    peak: R,
}

/// Search of the first peak of the mean age, in mean strains: from here, in steps, to here.
const SEARCH: [f64; 3] = [0.3, 0.01, 2.0];
/// Up to so many stages the mean age never falls: the slowest pole decays no slower than exp(−n t).
const MONOTONE_STAGES: u32 = 4;
/// Halvings of a step to the last digit.
const HALVINGS: u32 = 60;

impl<R: Real> ReformingBond<R> {
    /// Most stages served.
    pub const MAX_STAGES: u32 = 1000;

    /// Bonds whose breaking strains have Erlang's distribution.
    ///
    /// *Domain*: 0 < `stiffness` < ∞ (k), 0 < `mean_strain` < ∞ (x0), 1 ≤ `stages` ≤
    /// [`ReformingBond::MAX_STAGES`] (n). *Cost*: some 200 evaluations, which find the peak.
    pub fn new(stiffness: R, mean_strain: R, stages: u32) -> Result<Self, LawError> {
        let given = NonZeroU32::new(stages);
        let Some(count) = given.filter(|_| stages <= Self::MAX_STAGES) else {
            return Err(match given {
                None => LawError::NotPositive {
                    parameter: "number of stages",
                    given: 0.0,
                },
                Some(_) => LawError::Order {
                    smaller: "number of stages",
                    larger: "largest number of stages, 1000,",
                },
            });
        };
        let strain = validated_positive("mean strain", mean_strain)?;
        Ok(Self {
            stiffness: validated_positive("stiffness", stiffness)?,
            strain,
            stages: given,
            peak: strain * first_peak(count),
        })
    }

    /// Bonds that all break at `strain`, and re-form: f is a sawtooth, static friction twice the dynamic one.
    ///
    /// Under one displacement of the whole contact the sawtooth goes on for ever; the plateau is its
    /// mean. *Domain*: 0 < `stiffness` < ∞ (k), 0 < `strain` < ∞ (x0).
    ///
    /// ```
    /// use tribos_core::bond::{BondLaw, ReformingBond};
    /// use tribos_core::law::LocalLaw;
    /// let bonds = ReformingBond::one_strength(2.0, 0.5)?; // 1/m, m
    /// assert_eq!([0.25, 0.5, 0.75, 1.0].map(|strain| bonds.friction(strain)), [0.5, 1.0, 0.5, 1.0]);
    /// assert_eq!(bonds.plateau(), 0.5);
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn one_strength(stiffness: R, strain: R) -> Result<Self, LawError> {
        let strain = validated_positive("strain", strain)?;
        Ok(Self {
            stiffness: validated_positive("stiffness", stiffness)?,
            strain,
            stages: None,
            peak: strain,
        })
    }
}

/// Where the mean age first ceases to grow, in mean strains; infinite where it never does.
fn first_peak<R: Real>(stages: NonZeroU32) -> R {
    let [start, step, end] = SEARCH.map(R::from_f64);
    if stages.get() <= MONOTONE_STAGES {
        return R::INFINITY;
    }
    let (mut low, mut high) = (start, start + step);
    while mean_age(stages, high).rate > R::ZERO {
        if high > end {
            return R::INFINITY;
        }
        (low, high) = (high, high + step);
    }
    for _ in 0..HALVINGS {
        let middle = R::HALF * (low + high);
        if mean_age(stages, middle).rate > R::ZERO {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Place on the sawtooth of period 1, in (0, 1]; its mean where the period is lost in rounding.
fn sawtooth<R: Real>(turns: R) -> R {
    if turns > R::ONE / R::EPSILON {
        return R::HALF;
    }
    // The conversion to an integer is the integer part: 0 for NaN, which stays.
    let past = turns - R::from_f64(turns.to_f64() as u64 as f64);
    if past == R::ZERO && turns > R::ZERO {
        R::ONE
    } else {
        past
    }
}

impl<R: Real> LocalLaw<R> for ReformingBond<R> {
    fn friction(&self, speed: R) -> R {
        let turns = speed / self.strain;
        let age = match self.stages {
            Some(stages) => mean_age(stages, turns).age,
            None => sawtooth(turns),
        };
        self.stiffness * self.strain * age
    }
    /// k A'(d); k for one strength, whose teeth have no slope where they break.
    fn slope(&self, speed: R) -> R {
        match self.stages {
            Some(stages) => self.stiffness * mean_age(stages, speed / self.strain).rate,
            None => self.transverse_stiffness(speed),
        }
    }
}

impl<R: Real> BondLaw<R> for ReformingBond<R> {
    fn stiffness(&self) -> R {
        self.stiffness
    }
    fn peak(&self) -> R {
        self.peak
    }
    fn is_brittle(&self) -> bool {
        self.stages.is_none()
    }
    fn plateau(&self) -> R {
        let age = self.stages.map_or(R::HALF, steady_age);
        self.stiffness * self.strain * age
    }
    /// k: no bond is missing.
    #[inline]
    fn transverse_stiffness(&self, strain: R) -> R {
        if strain.is_nan() {
            strain
        } else {
            self.stiffness
        }
    }
}
