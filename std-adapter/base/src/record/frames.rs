//! Frames of a run, for films: selected states, each a small file that is complete or absent.
//!
//! A folder of frames contains `bodies.json` with the constant data, and one file `<step>.frame` per
//! state.
//!
//! ```
//! use nalgebra::Vector3;
//! use tribos::record::frames::{Bodies, Frame, FrameFolder, Kind};
//!
//! // A sphere of radius 1 that sinks from 8 to 3 in 1000 steps; at most 20 frames of it.
//! let bodies = Bodies {
//!     kind: Kind::Powder,
//!     scene: serde_json::json!({"pressure": 0.01}),
//!     limit: 20,
//!     stride: 1,
//!     sides: [10.0; 2],
//!     periods: [Some(10.0), Some(10.0), None],
//!     radii: vec![1.0],
//!     materials: Vec::new(),
//!     densities: Vec::new(),
//!     layers: Vec::new(),
//!     parts: Vec::new(),
//!     marked: Vec::new(),
//! };
//! let state = |step: u64| Frame {
//!     step,
//!     corners: [[0.0; 3], [10.0; 3]],
//!     places: vec![Vector3::new(5.0, 5.0, 8.0 - 0.005 * step as f64)],
//!     speeds: vec![0.005],
//!     ..Frame::default()
//! };
//! # let home = tempfile::tempdir()?;
//! # let path = home.path().join("frames");
//! let mut film = FrameFolder::begin(&path, &bodies)?;
//! for step in 0..1000 {
//!     if film.wants(step) {
//!         film.add(&state(step));
//!     }
//! }
//! film.finish(&state(1000))?;
//!
//! let steps = FrameFolder::steps(&path)?;
//! assert!(steps.len() <= 20 && steps.contains(&0) && steps.contains(&1000));
//! let last = FrameFolder::read(&path, &bodies, 1000)?;
//! assert!((last.places[0].z - 3.0).abs() <= 0.51 * 10.0 / 65535.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Format
//!
//! `bodies.json`: `format` (3), `body` (`powder`, `grains`, `gas` or `tip`), `scene`, `frames` (largest number that
//! is kept), `stride` (steps between states that may be kept), `sides` (of the cell along x and y), `periods` (along
//! x, y and z, null along an open axis), `radii` and, if they are known, `densities` (one for all or one each),
//! `materials` if there are several (numbers from 1); of a tip also `layers` and `parts` (one number an atom) and `marked`
//! (atoms drawn in another colour); at the end `digest`, see [`sealed`](crate::record::with_digest).
//!
//! `<step>.frame`, all numbers little-endian, n particles and m contacts:
//!
//! | bytes | what |
//! |---|---|
//! | 4 | `TrFr` |
//! | 4 | u32, version: 4, or 3 without vectors |
//! | 8 | u64, step |
//! | 8 | f64, time |
//! | 8 | f64, height: of the piston's face, or the mean of the driven atoms |
//! | 8 | f64, measure: porosity of a powder, angle of the driven layers in degrees |
//! | 8 | f64, tilt: displacement along x of the images one period higher along z |
//! | 4, 4 | u32, n and m |
//! | 12, 12 | f32, low and high corner of the box in which places are counted |
//! | 6 n | u16, places: 0 is the low side, 65535 the high one |
//! | 6 n | velocities: the upper half of an f32 each; in version 3 speeds, 2 n |
//! | 4 m, 4 m | u32, the sphere of a contact and its partner; 2³² − 1 − w for wall w |
//! | 2 m | normal forces, positive for pressure: the upper half of an f32 |
//! | m | u8, what the contact does: see [`ContactStateFlags`] |
//! | 6 m | forces across the contacts on their partners: the upper half of an f32 each; absent in version 3 |
//! | 16 | u128, the [`digest`](crate::record::digest) of all bytes before, xor that of what the run is about |
//!
//! *Accuracy*: positions to half a 65535th of the box's side (a millionth of the side more where
//! an end is no f32), velocities and forces to 2⁻⁸ of each component. Any consistent units.
//!
//! Which states are kept depends on the number of steps alone ([`spacing`]), so that an interrupted
//! and resumed run leaves the same files.

mod bodies;
mod bytes;
mod folder;
mod frame;
mod schedule;

pub use bodies::{Bodies, Kind};
pub use folder::FrameFolder;
pub use frame::{ContactStateFlags, Frame, FrameContact};
pub use schedule::{FEWEST, spacing};
