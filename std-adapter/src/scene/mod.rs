//! What is simulated, as plain data: a scene of each body, written in Rust or read from a TOML file.
//!
//! A scene is a struct whose fields are the keys of its files. One table a body declares both; the
//! reader, its messages, the JSON, the schema, the templates and the help are made from that table.
//!
//! All refusals happen before any work, and all at once: each names the file and line (or the
//! override, or the field), what is wrong and what would be valid. A scene that was made in Rust is
//! checked by the same rules when its run begins.
//!
//! To add a body, declare its scene in a file of this folder, implement `golden::Measure` for it beside
//! its runs, and name it in the list of `body.rs`; a body in the plane implements `PlanarScene` only.

mod body;
mod clamp;
mod curling;
mod cylinder;
mod entries;
mod gas;
mod grains;
mod hint;
mod incline;
mod key;
mod library;
mod method;
mod pipe;
mod planar;
mod plate;
mod powder;
mod problem;
mod push;
mod reader;
mod schema;
mod slider;
mod spring;
mod table;
mod template;
#[cfg(test)]
mod tests;
mod tip;
mod turntable;
mod vocabulary;
mod words;

pub use crate::packing::{Radii, Sizes, SizesError};
pub use body::{Scene, parse_scene, read_scene};
pub use clamp::ClampScene;
pub use curling::{CurlingScene, IceModel};
pub use cylinder::CylinderScene;
pub use gas::{GasMethod, GasScene};
pub use grains::{Axis, Container, Ends, GrainsScene, Sides};
#[doc(hidden)]
pub use hint::{nearest, number_hint};
pub use incline::InclineScene;
#[doc(hidden)]
pub use key::{Domain, Key, Need};
#[doc(hidden)]
pub use library::{LIBRARY, LibraryScene, library_scene};
pub use method::{ContactMethod, NormalForce};
pub use pipe::PipeScene;
pub use planar::{FootPressure, Tipping};
pub use plate::PlateScene;
pub use powder::{Coupling, Criterion, PowderScene, SweepMethod, SweepOrder, SweepStop, WallLaw};
pub use problem::{InvalidScene, Problem, SceneError};
pub use push::PushScene;
#[doc(hidden)]
pub use schema::schema;
pub use slider::{SliderScene, Stepper, Units};
pub use spring::{SpringFriction, SpringScene};
#[doc(hidden)]
pub use table::Body;
#[doc(hidden)]
pub use template::{keys_page, template, toml_value, with_all_keys};
pub use tip::{BathKind, BathSpin, DriveKind, DrivenHold, Reading, StageSteps, TipScene};
pub use turntable::TurntableScene;
#[doc(hidden)]
pub use vocabulary::{Vocabulary, bodies, vocabulary};
#[doc(hidden)]
pub use words::UnknownWord;

use body::DEFAULT_BODY;

/// Bytes of a scene file at most; those of this crate have a thousand.
///
/// ```
/// use tribos::scene::{LIBRARY, MOST_BYTES};
/// assert!(LIBRARY.iter().all(|scene| 1000 * (scene.text.len() as u64) < MOST_BYTES));
/// ```
#[doc(hidden)]
pub const MOST_BYTES: u64 = 16 << 20;
