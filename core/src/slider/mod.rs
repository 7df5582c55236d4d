//! One body that slides and spins to rest on a plane under its own weight.
//!
//! The path is straight for an axisymmetric contact, so that four numbers are the whole motion.
//! With κ = γ g (deceleration per speed^α), w = |ω|R and C = I/(M R²), eq. 3.25 reads
//! dv/dt = −κ F(v, w), dw/dt = −κ T(v, w)/C.
//!
//! [`Slider::to_rest`] follows a motion to its end, [`Slider::advance`] over a given time, both to
//! rounding accuracy; [`Slider::verlet_step`] is the fixed-step method of the
//! thesis.

mod advance;
mod direction_arc;
mod eighth_order;
mod final_decay;
mod gauss_legendre;
mod march;
mod rest;
#[doc(hidden)]
pub mod runge_kutta;
mod short_f32;
mod verlet;

pub use advance::Advance;
pub use rest::SliderRest;

use crate::coupling::{PowerLawFriction, ReducedFriction, ReducedWrench};
use crate::error::Error;
use crate::law::validated_positive;
use crate::modes::validated_inertia_ratio;
use crate::patch::validated_radius;
use crate::real::Real;

/// The state of a slider.
///
/// *Units*: consistent with the slider's deceleration and radius.
///
/// ```
/// use tribos_core::slider::SliderState;
/// let thrown = SliderState::launched(1.2, -30.0); // m/s, rad/s
/// assert!(!thrown.is_at_rest());
/// assert_eq!([thrown.time, thrown.distance, thrown.angle], [0.0; 3]);
/// assert!(SliderState { speed: 0.0, spin: 0.0, ..thrown }.is_at_rest());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SliderState<R> {
    /// Time since the start.
    pub time: R,
    /// Sliding speed, not negative.
    pub speed: R,
    /// Spin, of either sign.
    pub spin: R,
    /// Distance covered.
    pub distance: R,
    /// Angle turned, in radians, with the sign of the spin.
    pub angle: R,
}

impl<R: Real> SliderState<R> {
    /// A motion that starts at time 0.
    pub fn launched(speed: R, spin: R) -> Self {
        Self {
            time: R::ZERO,
            speed,
            spin,
            distance: R::ZERO,
            angle: R::ZERO,
        }
    }

    /// True if nothing moves.
    pub fn is_at_rest(&self) -> bool {
        self.speed == R::ZERO && self.spin == R::ZERO
    }
}

/// Parameters of [`Slider`].
///
/// *Domain*: all positive and finite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SliderParameters<R> {
    /// Friction coefficient × gravity: γ g, or μ g for Coulomb friction. *Units*: speed^(1−α)/time.
    pub deceleration: R,
    /// Radius R of the contact. *Units*: length.
    pub radius: R,
    /// Moment of inertia over mass × radius², C = I/(M R²). Dimensionless: 1/2 for a solid disk.
    pub inertia_ratio: R,
}

/// A body on a round contact.
///
/// ```
/// use tribos_core::prelude::*;
/// let puck = Slider::new(CoulombDisk, SliderParameters {
///     deceleration: 0.3 * 9.81, // μ g in m/s²
///     radius: 0.08,             // m
///     inertia_ratio: 0.5,       // a solid disk
/// })?;
/// let rest = puck.to_rest(&SliderState::launched(1.0_f64, 5.0)); // m/s, rad/s
/// assert!(rest.is_some_and(|rest| (rest.motion.time - 0.369017132104558).abs() < 1e-12)); // s
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slider<R, P> {
    profile: P,
    deceleration: R,
    radius: R,
    inertia_ratio: R,
}

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>> Slider<R, P> {
    /// From the coupling of its contact. *Domain*: that of [`SliderParameters`].
    pub fn new(profile: P, parameters: SliderParameters<R>) -> Result<Self, Error> {
        let SliderParameters {
            deceleration,
            radius,
            inertia_ratio,
        } = parameters;
        let named = "deceleration (coefficient x gravity)";
        Ok(Self {
            profile,
            deceleration: validated_positive(named, deceleration)?,
            radius: validated_radius(radius)?,
            inertia_ratio: validated_inertia_ratio(inertia_ratio)?,
        })
    }

    /// Kinetic energy per mass, (v² + C (ωR)²)/2.
    pub fn energy_per_mass(&self, motion: &SliderState<R>) -> R {
        let rim = motion.spin * self.radius;
        R::HALF * (motion.speed * motion.speed + self.inertia_ratio * rim * rim)
    }

    /// Power lost to friction per mass, κ (v F + w T).
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::slider::{SliderState, Slider};
    /// # use tribos_core::slider::SliderParameters;
    /// # let parameters = SliderParameters { deceleration: 3.0_f64, radius: 0.08, inertia_ratio: 0.5 };
    /// let puck = Slider::new(CoulombDisk, parameters)?; // μ g = 3 m/s², R = 0.08 m, C = 1/2
    /// let start = SliderState::launched(1.0, 5.0); // m/s, rad/s
    /// let end = puck.advance(&start, 1e-4).motion; // s
    /// // What friction takes is what the energy loses.
    /// let lost = (puck.energy_per_mass(&start) - puck.energy_per_mass(&end)) / 1e-4;
    /// let mean = 0.5 * (puck.dissipation_per_mass(&start) + puck.dissipation_per_mass(&end));
    /// assert!((lost - mean).abs() < 1e-6);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn dissipation_per_mass(&self, motion: &SliderState<R>) -> R {
        let rim = (motion.spin * self.radius).abs();
        let ReducedWrench { force, torque } = self.profile.reduced_wrench(motion.speed, rim);
        self.deceleration * (motion.speed * force + rim * torque)
    }

    /// Velocity ratio ε = v/(|ω|R); infinite without spin, NaN at rest.
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::slider::{SliderState, Slider};
    /// # use tribos_core::slider::SliderParameters;
    /// # let parameters = SliderParameters { deceleration: 3.0_f64, radius: 0.08, inertia_ratio: 0.5 };
    /// let puck = Slider::new(CoulombDisk, parameters)?; // μ g = 3 m/s², R = 0.08 m, C = 1/2
    /// assert_eq!(puck.ratio(&SliderState::launched(1.0, 5.0)), 1.0 / (5.0 * 0.08));
    /// assert_eq!(puck.ratio(&SliderState::launched(1.0, 0.0)), f64::INFINITY);
    /// assert_eq!(*puck.profile(), CoulombDisk);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn ratio(&self, motion: &SliderState<R>) -> R {
        motion.speed / (motion.spin * self.radius).abs()
    }

    /// The law and accuracy tier that the slider was made with.
    pub fn profile(&self) -> &P {
        &self.profile
    }
}
