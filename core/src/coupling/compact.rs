//! Any exponent by its power series: no table, 1e-14, slow.

use super::family_member::FamilyMember;
use super::half_octave_table::Pair;
use super::pressure_family;
use super::profile::{PowerLawFriction, SmoothProfile};
use super::speeds::{DominantSpeed, Speeds};
use crate::law::{LawError, PowerLaw, validated_exponent};
use crate::patch::PowerPressure;
use crate::real::Real;

/// |v|^α for any −1 < α ≤ 128 under any pressure (1−r²)^q, from the power series and its
/// continuation.
///
/// Works in f64 inside, for f32 too: on a processor without f64 it is slow.
/// *Accuracy* on the uniform disk: at most 1e-14 relative in f64 for −0.99 ≤ α ≤ 50; in f32 5 ulp
/// for −0.75 ≤ α ≤ 8, 6 ulp up to 10. Other pressures: 1e-14 in f64 for α ≥ −0.9 (4e-13 towards
/// −0.99), 10 ulp in f32.
/// *Cost*: one series away from equal speeds; near them up to 52 expansions.
///
/// ```
/// use tribos_core::coupling::{ReducedFriction, compact::CompactPower};
/// use tribos_core::patch::PowerPressure;
/// let hertz = CompactPower::with_pressure(0.0_f64, PowerPressure::HERTZ)?;
/// let torque = hertz.reduced_wrench(0.0, 1.0).torque;
/// assert!((torque - 3.0 * core::f64::consts::PI / 16.0).abs() < 1e-14);
/// # Ok::<(), tribos_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CompactPower<R> {
    alpha: R,
    order: R,
    spinning: Pair,
    sliding: Pair,
}

impl<R: Real> CompactPower<R> {
    /// On a uniform disk. *Domain*: −1 < `alpha` ≤ [`PowerLaw::MAX_EXPONENT`].
    ///
    /// ```
    /// use tribos_core::coupling::{ReducedFriction, compact::CompactPower};
    /// // Viscous friction: force and torque do not know of each other.
    /// let wrench = CompactPower::new(1.0_f64)?.reduced_wrench(0.3, 0.4); // m/s
    /// assert!((wrench.force - 0.3).abs() < 1e-15 && (wrench.torque - 0.4 / 2.0).abs() < 1e-15);
    /// assert!(CompactPower::new(-1.0_f64).is_err());
    /// # Ok::<(), tribos_core::law::LawError>(())
    /// ```
    pub fn new(alpha: R) -> Result<Self, LawError> {
        Self::with_pressure(alpha, PowerPressure::UNIFORM)
    }

    /// Under another pressure.
    pub fn with_pressure(alpha: R, pressure: PowerPressure) -> Result<Self, LawError> {
        let member = FamilyMember {
            alpha: validated_exponent(alpha.to_f64(), PowerLaw::<R>::MAX_EXPONENT)?,
            order: pressure.order(),
        };
        Ok(Self {
            alpha,
            order: R::from_f64(pressure.order()),
            spinning: member.spinning(),
            sliding: member.sliding(),
        })
    }
}

impl<R: Real> PowerLawFriction<R> for CompactPower<R> {
    fn exponent(&self) -> R {
        self.alpha
    }
    fn factors(&self, at: &Speeds<R>) -> [R; 2] {
        let [phi, _, chi] = self.factors_and_slope(at);
        [phi, chi]
    }
    fn inertia_excess(&self, at: &Speeds<R>, inertia_ratio: R) -> R {
        pressure_family::inertia_excess(self, self.order, at, inertia_ratio)
    }
    fn inertia_ends(&self) -> [R; 2] {
        pressure_family::inertia_ends(self.exponent(), self.order)
    }
}

impl<R: Real> SmoothProfile<R> for CompactPower<R> {
    fn factors_and_slope(&self, at: &Speeds<R>) -> [R; 3] {
        let pair = match at.lead() {
            DominantSpeed::Spinning => &self.spinning,
            DominantSpeed::Sliding => &self.sliding,
        };
        let at = at.widened();
        let (x, z) = at.square_and_complement();
        let phi = pair.gauss.at(x, z);
        let [phi, slope] = [phi.value, phi.slope].map(|y| pair.scale * y);
        let [order, alpha] = [self.order, self.alpha].map(R::to_f64);
        let chi = pressure_family::torque_factor(order, alpha, &at, [phi, slope]);
        [phi, slope, chi].map(R::from_f64)
    }
}

pressure_family::coupled!([R: Real] CompactPower<R>, |power| power.order);
