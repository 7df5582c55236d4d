//! A body on its patch in the plane, pushed and turned: implicit time steps with exact sticking.
//!
//! Dry friction is the dissipation potential's gradient only while the patch moves; at rest it is
//! whatever balances the push, up to the limit surface. One implicit step covers both. With the mass
//! matrix M, the push J (an impulse) and the set S of wrenches that friction carries,
//!
//! ```text
//! M (u⁺ − u) = J + Δt f,   f ∈ S opposes u⁺    ⇔    Δt f = the point of Δt S nearest to −(M u + J)
//! ```
//!
//! measured by kinetic energy (Moreau, Eur. J. Mech. A 13 (1994) 93). If that point is −(M u + J)
//! itself the body rests, to the last bit, for as long as the push stays within S. Otherwise the step
//! is taken by the implicit midpoint rule, which is of second order: friction opposes the mean of the
//! motions before and after, so that its work over the step, impulse · mean motion, is −Δt times the
//! dissipated power, and never positive.
//!
//! The midpoint rule may carry a motion beyond rest. Where velocity or spin turn about, the step is
//! that of the formula above instead, in which friction opposes the motion at the end, provided that
//! friction takes power in it. Without push it always does, and no step reverses the motion: with
//! p = M u the change is the projection P of p, and (p − P)·M⁻¹ p ≥ 0 for every convex S that
//! contains 0; for a round patch neither velocity nor spin changes its sense.
//!
//! [`PlanarBody::step_sticking`] is the step of a body that holds more at rest than in motion.
//!
//! ```
//! use tribos_core::contact::TimeStep;
//! use tribos_core::coupling::coulomb::CoulombDisk;
//! use tribos_core::limit_surface::RoundLimitSurface;
//! use tribos_core::planar::PlanarBody;
//! use tribos_core::twist::{Twist, Wrench};
//!
//! // A puck of 0.17 kg and 4 cm radius; friction carries up to 0.5 N.
//! let puck = PlanarBody::new(0.17_f64, 0.5 * 0.17 * 0.04 * 0.04)?;
//! let ice = RoundLimitSurface::new(CoulombDisk, 0.5, 0.04)?;
//! let dt = TimeStep::new(1.0 / 60.0)?;
//! let held = Wrench::new(0.4, 0.0, 0.0);
//! let rest = puck.step(&ice, &Twist::ZERO, &held, dt);
//! assert!(rest.is_at_rest && rest.twist == Twist::ZERO);
//! let slides = puck.step(&ice, &Twist::new(1.0, 0.0, 20.0), &Wrench::ZERO, dt);
//! assert!(slides.twist.speed() < 1.0 && slides.twist.spin < 20.0);
//! # Ok::<(), tribos_core::Error>(())
//! ```

mod balance;
mod batch;
mod elastic;
mod point_contacts;
mod step;
mod sticking;
#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;

pub use elastic::{ElasticState, ElasticStep};
pub use point_contacts::PointContacts;
pub use step::PlanarStep;

use crate::law::{LawError, validated_positive};
use crate::real::Real;

/// Mass, and moment of inertia about the normal, of a body that a patch carries.
///
/// Twist, push and friction refer to the centre of mass' foot on the plane; the patch of a
/// [`crate::limit_surface::FrictionSet`] is centred there.
///
/// ```
/// use tribos_core::law::LawError;
/// use tribos_core::planar::PlanarBody;
/// // A disk of 0.17 kg and 4 cm: half of its mass counts at its rim.
/// let puck = PlanarBody::new(0.17_f64, 0.5 * 0.17 * 0.04 * 0.04)?;
/// assert!((puck.inertia() - puck.mass() * puck.gyration() * puck.gyration()).abs() < 1e-18);
/// assert!((puck.gyration() - 0.04 / 2.0_f64.sqrt()).abs() < 1e-16);
/// let parameter = "moment of inertia";
/// let refused = PlanarBody::new(0.17, 0.0);
/// assert_eq!(refused, Err(LawError::NotPositive { parameter, given: 0.0 }));
/// # Ok::<(), LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlanarBody<R> {
    mass: R,
    inertia: R,
    /// √(inertia/mass)
    gyration: R,
}

impl<R: Real> PlanarBody<R> {
    /// *Units*: mass, mass × length². *Domain*: both positive and finite, and so their ratio.
    pub fn new(mass: R, inertia: R) -> Result<Self, LawError> {
        Ok(Self {
            mass: validated_positive("mass", mass)?,
            inertia: validated_positive("moment of inertia", inertia)?,
            gyration: validated_positive("radius of gyration", (inertia / mass).sqrt())?,
        })
    }

    /// The mass.
    pub fn mass(&self) -> R {
        self.mass
    }

    /// The moment of inertia about the normal.
    pub fn inertia(&self) -> R {
        self.inertia
    }

    /// The radius of gyration, √(inertia/mass).
    pub fn gyration(&self) -> R {
        self.gyration
    }
}
