//! Simulations on top of `tribos-core`: everything that allocates or accesses files.
//!
//! A scene file becomes a validated scene ([`scene`]), an application turns it into a simulation
//! ([`slide`], [`powder`], [`tip`]), one driver runs it ([`run`]) and its results are recorded
//! ([`record`]) or pinned to the bit ([`golden`]). The physics is in [`tribos_core`], re-exported
//! here as [`kernel`].
//!
//! ```
//! use tribos::scene::{Scene, parse_scene};
//! use tribos::slide::run;
//! // A puck slides and spins to rest: 1 m/s and 5 rad/s end in the same moment.
//! let text = "body = \"disk\"\nspeed = 1.0\nspin = 5.0\ncoefficient = 0.3\nalpha = 0\n\
//!             gravity = 9.81\nradius = 0.08\nmass = 0.1\ninertia_ratio = 0.5";
//! let Scene::Disk(puck) = parse_scene("puck.toml", text, &[])? else { unreachable!() };
//! let end = run(&puck, |_done| ())?.outcome;
//! assert!((end.time - 0.369017132104558).abs() < 1e-9); // s
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | module | what it has |
//! |---|---|
//! | [`scene`] | scene files: keys, units, defaults, checks, overrides |
//! | [`slide`] | sliding bodies: disk, cylinder, pipe, curling rock; which launch ends at a wanted pose |
//! | [`cd`], [`powder`] | rigid spheres in contact; cohesive powders under a piston |
//! | [`md`], [`tip`] | atoms; a tip of them turned on a substrate |
//! | [`space`], [`random`] | places of many particles and who is near whom; seeded numbers |
//! | [`fit`] | parameters of friction laws from measurements |
//! | [`run`], [`record`], [`golden`] | the driver; files, checkpoints, frames; results pinned to the bit |

pub mod cd;
pub mod fit;
pub mod golden;
pub mod md;
pub mod powder;
pub mod random;
pub mod record;
pub mod run;
pub mod scene;
pub mod slide;
pub mod space;
pub mod tip;

pub use tribos_core as kernel;
