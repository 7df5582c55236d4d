//! The names of everyday use, those of the kernel among them.
//!
//! ```
//! use tribos::prelude::*;
//! let puck = DiskScene { speed: 2.0, spin: 40.0, ..DiskScene::default() }; // m/s, rad/s
//! let rest = puck.run()?.outcome;
//! assert!(rest.distance > 0.0); // m
//! let hertz = AnyFriction::<f64>::new(&Patch::Hertz, &Law::coulomb(0.3)?, None)?;
//! let wrench = hertz.with_radius(0.01)?.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)); // m; N
//! assert!(wrench.torque < 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use crate::friction::{AnyFriction, Law, Patch, Tier};
pub use crate::gas::GasSimulation;
pub use crate::grains::GrainsSimulation;
pub use crate::powder::PowderSimulation;
pub use crate::run::{Session, run_to_end};
pub use crate::scene::Scene;
pub use crate::scene::scenes::*;
pub use crate::tip::TipSimulation;
pub use tribos_core::prelude::*;
