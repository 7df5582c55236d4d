//! Contact dynamics: rigid spheres and plates with constraint forces (thesis, section 4.4).
//!
//! A billiard ball that is struck through its centre slides at first, and in the end rolls with 5/7
//! of its speed, whatever the friction:
//!
//! ```
//! use nalgebra::Vector3;
//! use tribos::cd::{Laws, Method, Pace, Setup, Solver, Wall, World, solid};
//! use tribos::kernel::contact::{Cohesion, NormalLaw, Sphere, Thresholds};
//! use tribos::space::PeriodicBox;
//!
//! let (up, radius) = (Vector3::z(), 0.028); // m
//! let ball = Sphere { velocity: Vector3::x(), ..solid(radius, 1700.0) }; // m/s, kg/m³
//! let setup = Setup {
//!     space: PeriodicBox::OPEN,
//!     positions: vec![up * radius],
//!     radii: vec![radius],
//!     spheres: vec![ball],
//!     walls: vec![Wall::fixed(up, 0.0)],
//!     laws: Laws::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, Thresholds::sliding(0.2)?),
//!     gravity: up * -9.81,
//!     pace: Pace { longest: 1e-3, motion: 0.01 }, // s, m
//!     solver: Solver {
//!         method: Method::Accelerated { tolerance: 1e-9 },
//!         most_sweeps: 100,
//!         warm_start: true,
//!     },
//!     still_speed: 0.0,
//! };
//! let mut world = World::new(setup)?;
//! for _ in 0..200 {
//!     world.step()?;
//! }
//! let ball = &world.state().spheres[0];
//! assert!((ball.velocity.x - 5.0 / 7.0).abs() < 1e-12);
//! assert!((ball.spin.y * radius - ball.velocity.x).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod accelerated;
mod assemble;
mod book;
mod impact;
mod impact_rest;
mod impact_round;
mod island;
mod memory;
mod nsgs;
mod operator;
mod residual;
mod schedule;
mod setup;
mod solver;
mod spheres;
mod world;

pub use accelerated::{Accelerated, Goal};
pub use book::Book;
pub use island::Rest;
pub use memory::{Kept, Memory};
pub use nsgs::{Effort, Order, Stop, Sweeper, solve};
pub use operator::{Blind, Change, Impulse, Operator, Restless, Visit, Watch};
pub use residual::{Coefficients, Residual, residual};
pub use setup::{Laws, Pace, Setup, Wall, WorldError, solid};
pub use solver::{Method, Solver};
pub use spheres::{Link, Spheres};
pub use world::{State, StepReport, World};
