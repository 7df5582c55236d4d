//! Simulations on top of `tribos-core`: everything that allocates or accesses files.
//!
//! A scene, plain data or read from a file ([`scene`]), becomes a simulation ([`slide`], [`powder`], [`tip`]), one driver runs it ([`run`]) and its results are kept
//! ([`record`]) or pinned to the bit ([`golden`]). The physics is in [`tribos_core`], re-exported
//! here as [`kernel`].
//!
//! ```
//! use tribos::scene::SliderScene;
//! use tribos::slide::run;
//! // A puck slides and spins to rest: 1 m/s and 5 rad/s end in the same moment.
//! let puck = SliderScene { speed: 1.0, spin: 5.0, coefficient: 0.3, ..SliderScene::default() };
//! let end = run(&puck, |_done| ())?.outcome;
//! assert!((end.time - 0.369017132104558).abs() < 1e-9); // s
//! # Ok::<(), tribos::slide::SlideError>(())
//! ```
//!
//! | module | what it has |
//! |---|---|
//! | [`friction`] | patch, law and accuracy tier chosen by name; the catalogue of laws |
//! | [`scene`] | scenes: plain data with defaults, their files, units and checks |
//! | [`slide`] | sliding bodies: disk, cylinder, pipe, curling rock; which launch ends at a wanted pose |
//! | [`cd`], [`powder`] | rigid spheres in contact; cohesive powders under a piston |
//! | [`md`], [`tip`] | atoms; a tip of them turned on a substrate |
//! | [`space`], [`random`] | places of many particles and who is near whom; seeded numbers |
//! | [`fit`] | parameters of friction laws from measurements |
//! | [`run`], [`record`], [`golden`] | the driver; files, checkpoints, frames; results pinned to the bit |

pub mod cd;
pub mod fit;
pub mod friction;
#[doc(hidden)]
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
pub use tribos_core::nalgebra;
