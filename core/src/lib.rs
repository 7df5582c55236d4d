//! Coupled sliding and spinning friction: a kernel without standard library or allocator.
//!
//! A body that slides with velocity v and spins with ω on a flat contact meets one friction, not
//! two: every surface element resists along its own velocity v + ω × r. Everything here follows
//! from the power that this dissipates, the *dissipation potential*; force and torque are its
//! gradient, the Jacobian for controllers and implicit integrators its Hessian.
//!
//! ```
//! use tribos_core::coupling::{PatchFriction, table::Coulomb};
//! use tribos_core::twist::Twist;
//!
//! let puck = PatchFriction::new(Coulomb, 0.3_f32, 0.04)?; // mu, radius in m
//! let wrench = puck.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)); // load in N; m/s, m/s, rad/s
//! assert!(wrench.force.x < 0.0 && wrench.torque < 0.0);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! | module | what it knows |
//! |---|---|
//! | [`law`] | friction of one surface element: dry, power law, Stribeck, rate and state, LuGre, … |
//! | [`patch`] | the contact's shape and pressure: round patches, points, polygons |
//! | [`coupling`] | law × patch → force, torque and Jacobian, in accuracy tiers picked by type |
//! | [`limit_surface`] | all wrenches that dry friction can carry: gauge, normal, projection |
//! | [`modes`] | where the ratio of sliding to spinning goes |
//! | [`contact`] | contacts that open, slide, roll and spin: impulses under thresholds |
//! | [`manifold`] | a dozen such contacts solved together, in a fixed amount of memory |
//! | [`planar`] | a body pushed and turned on its patch: implicit steps that hold what friction holds |
//! | [`slider`] | a body followed to rest |
//! | [`twist`] | motion in, wrench out |
//! | [`special`], [`real`] | elliptic and hypergeometric functions; the scalar |
//!
//! # Contract
//!
//! - Constructors validate and return typed errors. All other functions are total: every bit
//!   pattern gives a documented result, NaN stays NaN, nothing panics.
//! - Same input, same bits: no platform mathematics, no fused multiply-add, and no feature that
//!   changes a result. Features only add conversions (`glam`, `mint`) and logging (`defmt`).
//! - A tier or law that is not named costs neither time nor flash.
#![no_std]
#![forbid(unsafe_code)]

pub mod contact;
pub mod coupling;
pub mod law;
pub mod limit_surface;
#[cfg(feature = "defmt")]
mod logging;
pub mod manifold;
pub mod modes;
pub mod patch;
pub mod planar;
pub mod real;
pub mod slider;
pub mod special;
pub mod twist;

pub use real::Real;
