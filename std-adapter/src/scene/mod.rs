//! What is simulated, as plain data: a scene of each body, written in Rust or read from a TOML file.
//!
//! A scene is a struct whose fields are the keys of its files. One table a body declares both; the
//! reader, its messages, the JSON, the schema, the templates and the help are made from that table.
//!
//! All refusals happen before any work, and all at once: each names the file and line (or the
//! override, or the field), what is wrong and what would be valid. A scene that was made in Rust is
//! checked by the same rules when its run begins.
//!
//! To add a body, declare its scene beside its runs, in the crate that has them; implement there what a run of
//! it is (a body in motion: `MotionScene`; in the plane `PlanarScene`, and its name in the list of `slide/path.rs`,
//! which gives it `run`; another: `Measure` for golden files); and name it in the list of `body.rs`.

mod body;
mod library;
mod schema;
mod template;
#[cfg(test)]
mod tests;
mod vocabulary;

pub use body::Scene;
#[doc(hidden)]
pub use body::{RunBy, scenes};
#[doc(hidden)]
pub use library::{LIBRARY, LibraryScene, library_scene};
#[doc(hidden)]
pub use schema::schema;
#[doc(hidden)]
pub use template::{keys_page, results_page, template, toml_value, with_all_keys};
#[doc(hidden)]
pub use tribos_atoms::scene::StageSteps;
pub use tribos_atoms::scene::{
    DriveKind, DrivenHold, ThermostatBias, ThermostatKind, TipScene, TorqueNormalisation,
};
#[doc(hidden)]
pub use tribos_base::scene::{
    Body, Domain, Form, Key, MOST_BYTES, Need, UnknownWord, earlier_names, nearest, number_hint,
    present_name,
};
pub use tribos_base::scene::{InvalidScene, SceneError, SceneProblem};
#[doc(hidden)]
pub use tribos_grains::packing::Radii;
pub use tribos_grains::packing::{SettingError, SizeDistribution};
pub use tribos_grains::scene::{
    Adhesion, Axis, BlockedCriterion, ContactMethod, Container, EndBoundary, FrictionCoupling,
    GasMethod, GasScene, GrainsScene, NormalForce, PowderScene, SideBoundary, SweepMethod,
    SweepOrder, SweepStop, WallLaw,
};
pub use tribos_motion::scene::*;
#[doc(hidden)]
pub use vocabulary::{Vocabulary, bodies, vocabulary, with_present_names};

use tribos_base::scene::{DEFAULT_BODY, entries, key, problem, table, words};
