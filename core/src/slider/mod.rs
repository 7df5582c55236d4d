//! One body that slides and spins to rest on a plane under its own weight.
//!
//! The path is straight for an axisymmetric contact, so that four numbers are the whole motion.
//! With κ = γ g (deceleration per speed^α), w = |ω|R and C = I/(M R²), eq. 3.25 reads
//! dv/dt = −κ F(v, w), dw/dt = −κ T(v, w)/C.
//!
//! Three ways on from a state: [`Slider::to_rest`] goes to the end, [`Slider::advance`] a given
//! time, both to rounding accuracy; [`Slider::verlet_step`] is the fixed-step method of the
//! thesis.

mod advance;
mod eighth_order;
mod leg;
mod march;
mod rest;
mod rule;
pub mod runge_kutta;
mod single;
mod tail;
mod verlet;

pub use advance::Advance;
pub use rest::Rest;

use crate::coupling::{Coupling, Profile, ReducedWrench};
use crate::modes::InertiaError;
use crate::real::Real;

/// The state of a slider.
///
/// *Units*: consistent with the slider's deceleration and radius.
///
/// ```
/// use tribos_core::slider::Motion;
/// let thrown = Motion::launched(1.2, -30.0); // m/s, rad/s
/// assert!(!thrown.is_at_rest());
/// assert_eq!([thrown.time, thrown.distance, thrown.angle], [0.0; 3]);
/// assert!(Motion { speed: 0.0, spin: 0.0, ..thrown }.is_at_rest());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Motion<R> {
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

impl<R: Real> Motion<R> {
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

/// Why a slider was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SliderError {
    /// The deceleration γ g is not positive and finite.
    Deceleration {
        /// What was given.
        given: f64,
    },
    /// The contact radius is not positive and finite.
    Radius {
        /// What was given.
        given: f64,
    },
    /// The inertia ratio is not positive and finite.
    Inertia(InertiaError),
}

impl core::fmt::Display for SliderError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Deceleration { given } => write!(
                f,
                "the deceleration (coefficient x gravity) must be positive and finite, not {given}"
            ),
            Self::Radius { given } => {
                write!(
                    f,
                    "the contact radius must be positive and finite, not {given}"
                )
            }
            Self::Inertia(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for SliderError {}

/// A body on a uniform circular contact.
///
/// ```
/// use tribos_core::{coupling::table::Coulomb, slider::{Motion, Slider}};
/// // mu g = 0.3 x 9.81 m/s2, contact radius 8 cm, solid disk; launched at 1 m/s and 5 rad/s.
/// let puck = Slider::new(Coulomb, 0.3 * 9.81, 0.08, 0.5)?;
/// let rest = puck.to_rest(&Motion::launched(1.0_f64, 5.0)).ok_or("no rest")?;
/// assert!((rest.motion.time - 0.369017132104558).abs() < 1e-12);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Slider<R, P> {
    profile: P,
    deceleration: R,
    radius: R,
    inertia_ratio: R,
}

impl<R: Real, P: Profile<R> + Coupling<R>> Slider<R, P> {
    /// *Domain*: all positive and finite. `deceleration` is γ g (μ g for Coulomb), in
    /// speed^(1−α)/time; `inertia_ratio` is C = I/(M R²).
    pub fn new(
        profile: P,
        deceleration: R,
        radius: R,
        inertia_ratio: R,
    ) -> Result<Self, SliderError> {
        let valid = |x: R| x > R::ZERO && x.is_finite();
        if !valid(deceleration) {
            Err(SliderError::Deceleration {
                given: deceleration.to_f64(),
            })
        } else if !valid(radius) {
            Err(SliderError::Radius {
                given: radius.to_f64(),
            })
        } else if !valid(inertia_ratio) {
            Err(SliderError::Inertia(InertiaError {
                given: inertia_ratio.to_f64(),
            }))
        } else {
            Ok(Self {
                profile,
                deceleration,
                radius,
                inertia_ratio,
            })
        }
    }

    /// Kinetic energy per mass, (v² + C (ωR)²)/2.
    pub fn energy_per_mass(&self, motion: &Motion<R>) -> R {
        let rim = motion.spin * self.radius;
        R::HALF * (motion.speed * motion.speed + self.inertia_ratio * rim * rim)
    }

    /// Power lost to friction per mass, κ (v F + w T).
    ///
    /// ```
    /// use tribos_core::coupling::table::Coulomb;
    /// use tribos_core::slider::{Motion, Slider};
    /// let puck = Slider::new(Coulomb, 3.0_f64, 0.08, 0.5)?;
    /// let start = Motion::launched(1.0, 5.0); // m/s, rad/s
    /// let end = puck.advance(&start, 1e-4).motion; // s
    /// // What friction takes is what the energy loses.
    /// let lost = (puck.energy_per_mass(&start) - puck.energy_per_mass(&end)) / 1e-4;
    /// let mean = 0.5 * (puck.dissipation_per_mass(&start) + puck.dissipation_per_mass(&end));
    /// assert!((lost - mean).abs() < 1e-6);
    /// # Ok::<(), tribos_core::slider::SliderError>(())
    /// ```
    pub fn dissipation_per_mass(&self, motion: &Motion<R>) -> R {
        let rim = (motion.spin * self.radius).abs();
        let ReducedWrench { force, torque } = self.profile.reduced_wrench(motion.speed, rim);
        self.deceleration * (motion.speed * force + rim * torque)
    }

    /// Velocity ratio ε = v/(|ω|R); infinite without spin, NaN at rest.
    ///
    /// ```
    /// use tribos_core::coupling::table::Coulomb;
    /// use tribos_core::slider::{Motion, Slider};
    /// let puck = Slider::new(Coulomb, 3.0_f64, 0.08, 0.5)?;
    /// assert_eq!(puck.ratio(&Motion::launched(1.0, 5.0)), 1.0 / (5.0 * 0.08));
    /// assert_eq!(puck.ratio(&Motion::launched(1.0, 0.0)), f64::INFINITY);
    /// assert_eq!(*puck.profile(), Coulomb);
    /// # Ok::<(), tribos_core::slider::SliderError>(())
    /// ```
    pub fn ratio(&self, motion: &Motion<R>) -> R {
        motion.speed / (motion.spin * self.radius).abs()
    }

    /// The law and accuracy tier that the slider was made with.
    pub fn profile(&self) -> &P {
        &self.profile
    }
}
