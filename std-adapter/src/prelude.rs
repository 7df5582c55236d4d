//! The names of everyday use, those of the kernel among them.
//!
//! ```
//! use tribos::prelude::*;
//! let puck = SliderScene { speed: 2.0, spin: 40.0, ..SliderScene::default() }; // m/s, rad/s
//! let rest = slide::run(&puck, |_| ())?.outcome;
//! assert!(rest.distance > 0.0); // m
//! let hertz = Friction::<f64>::new(&Patch::Hertz, &Law::coulomb(0.3)?, None)?;
//! let wrench = hertz.with_radius(0.01)?.wrench(1.7, &Twist::new(1.0, 0.0, 20.0)); // m; N
//! assert!(wrench.torque < 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use crate::friction::{Friction, Law, Patch, Tier};
pub use crate::gas::Gas;
pub use crate::powder::Compaction;
pub use crate::run::{Session, drive};
pub use crate::scene::{
    ClampScene, CurlingScene, CylinderScene, GasScene, InclineScene, PipeScene, PlateScene,
    PowderScene, Scene, SliderScene, SpringScene, TipScene, TurntableScene, parse_scene,
    read_scene,
};
pub use crate::slide;
pub use crate::tip::TipRun;
pub use tribos_core::prelude::*;
