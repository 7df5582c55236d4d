//! Coupled sliding and spinning friction: dry, rate-dependent and stateful laws on contact patches of
//! any shape, and the motion that follows from them; without standard library or allocator.
//!
//! A body that slides with velocity v and spins with ω on a flat contact meets one friction, not
//! two: every surface element resists along its own velocity v + ω × r. Force and torque are the
//! gradient of the dissipated power, the *dissipation potential*, and the Jacobian for controllers
//! and implicit integrators is its Hessian.
//!
//! # Examples
//!
//! Friction of a disk that slides and spins:
//!
//! ```
//! use tribos_core::prelude::*;
//! let puck = RoundFriction::new(CoulombDisk, 0.3_f32, 0.04)?; // coefficient μ, radius in m
//! let wrench = puck.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)); // load in N; m/s, m/s, rad/s
//! assert!(wrench.force.x < 0.0 && wrench.torque < 0.0); // N, N m
//! # Ok::<(), Error>(())
//! ```
//!
//! The wrenches that friction can carry, and the one of them nearest to a push:
//!
//! ```
//! use tribos_core::prelude::*;
//! let puck = RoundLimitSurface::new(CoulombDisk, 0.5_f64, 0.04)?; // force limit μN in N, radius in m
//! assert!(puck.contains(&Wrench::new(0.4, 0.0, 0.001))); // the puck sticks
//! let carried = puck.project(&Wrench::new(0.6, 0.0, 0.01)); // too much: it slides
//! assert!(puck.contains(&carried.wrench));
//! # Ok::<(), Error>(())
//! ```
//!
//! A body that slides and spins to rest:
//!
//! ```
//! use tribos_core::prelude::*;
//! let puck = SliderParameters { deceleration: 0.3_f64 * 9.81, radius: 0.04, inertia_ratio: 0.5 };
//! let puck = Slider::new(CoulombDisk, puck)?;
//! let rest = puck.to_rest(&SliderState::launched(1.0, 20.0)); // m/s, rad/s
//! assert!(rest.is_some_and(|rest| rest.motion.distance > 0.17)); // m: farther than without spin
//! # Ok::<(), Error>(())
//! ```
//!
//! The impulse of one contact in one time step, with sliding and spinning friction:
//!
//! ```
//! use tribos_core::{nalgebra::Vector3, prelude::*};
//! let (still, up) = (Vector3::new(0.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
//! let (velocity, spin) = (Vector3::new(1.0, 0.0, -0.01), Vector3::new(0.0, 0.0, 50.0));
//! let mut ball = SphereBody { velocity, spin, inv_mass: 1.0, inv_inertia: 1000.0 };
//! let mut table = WallBody { velocity: still, inv_mass: 0.0 };
//! let touch = ContactGeometry::plate(0.05, &up, 0.05)?; // a ball of 5 cm that touches the table
//! let mut contact = Contact::new(&touch, &NormalLaw::new(Cohesion::NONE, 0.0)?, &ball, &table, 1e-3);
//! contact.update(&IndependentFriction::sliding_torsion(0.3_f64, 0.01)?, &mut ball, &mut table);
//! assert!(ball.velocity.z == 0.0 && ball.velocity.x < 1.0 && ball.spin.z < 50.0);
//! # Ok::<(), Error>(())
//! ```
//!
//! A lubricated disk, whose friction depends on the sliding speed:
//!
//! ```
//! use tribos_core::prelude::*;
//! let dry = DryFriction::new(0.15_f64, 0.1)?; // static and dynamic coefficient
//! let oil = Stribeck::new(StribeckParameters { dry, speed: 0.01, exponent: 2.0, viscous: 0.5 })?;
//! let bearing = RoundFriction::new(DiskQuadrature::new(oil), 1.0, 0.04)?; // factor, radius in m
//! let [fast, slow] = [0.5, 0.05].map(|v| bearing.wrench(1.7, &Twist::new(v, 0.0, 0.0)));
//! assert!(fast.force.x < slow.force.x); // viscous: the faster, the larger
//! # Ok::<(), Error>(())
//! ```
//!
//! # Modules
//!
//! | module | contents |
//! |---|---|
//! | [`twist`] | planar twists (motion) and wrenches (load) |
//! | [`law`] | friction of one surface element: dry, power law, Stribeck, rate and state, LuGre, … |
//! | [`patch`] | shape and pressure of the contact: round patches, ellipses, polygons, points; two coefficients |
//! | [`coupling`] | law × patch → force, torque and Jacobian, in accuracy tiers chosen by type |
//! | [`limit_surface`] | all wrenches that dry friction can carry: gauge, normal, projection |
//! | [`modes`] | the ratio of sliding to spinning just before rest |
//! | [`bond`] | bonds of a body at rest, and the load under which they let go |
//! | [`slider`] | a body followed to rest |
//! | [`planar`] | a body pushed and turned on its patch: implicit time steps that stick and slip |
//! | [`floor`] | a body on several feet, each on a surface that moves: belts, treads, turntables |
//! | [`holding`] | whether a push at rest holds or slips, from what is certain and what is possible |
//! | [`presliding`] | elastic hold before sliding: exact, without creep, with micro-slip and its losses |
//! | [`contact`] | contacts of rigid bodies that open, slide, roll and spin: impulses under thresholds |
//! | [`manifold`] | a few such contacts solved together, in a fixed amount of memory |
//! | [`manifold_friction`] | friction of a contact manifold in a game engine: one projection in place of two clamps |
//!
//! Every typed error converts into [`Error`], [`Real`] is the scalar, and [`prelude`] has the names of
//! everyday use. Vectors are those of [`nalgebra`], re-exported here in the matching version.
//!
//! # Contract
//!
//! - Constructors validate and return typed errors. All other functions are total: every bit
//!   pattern gives a documented result, NaN stays NaN, nothing panics.
//! - Same input, same bits on every supported platform: no platform mathematics, no fused
//!   multiply-add, and no feature that changes a result. Features only add conversions (`glam`,
//!   `mint`) and logging (`defmt`).
//! - A tier or law that a program does not name costs neither time nor flash.
#![no_std]
#![forbid(unsafe_code)]

pub mod bond;
pub mod contact;
pub mod coupling;
mod error;
pub mod floor;
pub mod holding;
mod lanes;
pub mod law;
pub mod limit_surface;
#[cfg(feature = "defmt")]
mod logging;
pub mod manifold;
pub mod manifold_friction;
pub mod modes;
pub mod patch;
pub mod planar;
mod power;
pub mod prelude;
pub mod presliding;
pub mod real;
pub mod slider;
mod special;
pub mod twist;

/// What other crates of this repository share with the kernel. It is no part of the promise: these
/// items change or go without notice.
#[doc(hidden)]
pub mod internals {
    pub use crate::contact::internals::*;
    pub use crate::coupling::internals::*;
    pub use crate::coupling::load_transfer::{LeaningWrench, leaning_wrench};
    pub use crate::limit_surface::COLLAR_ULPS;
    pub use crate::limit_surface::meridian::CurveNumbers;
    pub use crate::patch::tripod::tripod_shares;
    pub use crate::slider::runge_kutta;
    pub use crate::special::{ATANH, ATANH_SINGLE, CompleteElliptic, Gauss, Jet};
}

pub use nalgebra;

pub use contact::{Contact, IndependentFriction};
pub use coupling::{RoundFriction, coulomb::CoulombDisk};
pub use error::Error;
pub use limit_surface::{FrictionSet, RoundLimitSurface};
pub use manifold::ContactSystem;
pub use planar::PlanarBody;
pub use real::Real;
pub use slider::Slider;
pub use twist::{Twist, Wrench};
