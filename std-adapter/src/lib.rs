//! Solid friction on a host: whatever allocates, reads files or writes them.
//!
//! A scene file becomes a validated scene ([`scene`]), an application turns it into a simulation
//! ([`slide`]), one driver runs it ([`run`]) and its results are kept ([`record`]). The physics is
//! in [`tribos_core`], re-exported here as [`kernel`].

pub mod record;
pub mod run;
pub mod scene;
pub mod slide;

pub use tribos_core as kernel;
