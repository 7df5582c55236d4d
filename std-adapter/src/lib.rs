//! Solid friction on a host: whatever allocates, reads files or writes them.
//!
//! A scene file becomes a validated scene ([`scene`]), an application turns it into a simulation
//! ([`slide`]), one driver runs it ([`run`]) and its results are kept ([`record`]) or pinned to the bit ([`golden`]). Places of many
//! particles and who is near whom are in [`space`], rigid spheres in contact in [`cd`],
//! parameters of laws from measurements in [`fit`], powders of them in [`powder`], atoms in [`md`], a tip of them on a substrate in [`tip`], seeded random numbers in [`random`]. The physics is in [`tribos_core`], re-exported here as [`kernel`].

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
