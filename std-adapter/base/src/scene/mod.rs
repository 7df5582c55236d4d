//! Scenes as data: a table of keys for each body, from which its reader, messages, JSON, schema,
//! templates and help are made.
//!
//! A scene is a struct whose fields are the keys of its files; [`scene!`](crate::scene!) declares both. All
//! refusals happen before any work, and all at once: each names the file and line (or the override, or
//! the field), what is wrong and what would be valid. A scene that was made in Rust is checked by the
//! same rules when its run begins.
//!
//! The scenes themselves stand in the crates whose bodies they describe.

pub mod entries;
mod hint;
pub mod key;
pub mod problem;
pub mod reader;
pub mod table;
pub mod words;

#[doc(hidden)]
pub use hint::finite_number;
pub use hint::{nearest, number_hint};
pub use key::{BODY, Domain, Form, Key, Need, present_name};
pub use problem::{InvalidScene, SceneError, SceneProblem};
pub use reader::earlier_names;
pub use table::Body;
pub use words::UnknownWord;

/// The body of a file that names none.
pub const DEFAULT_BODY: &str = "disk";

/// Bytes of a scene file at most; those of the library have a thousand.
pub const MOST_BYTES: u64 = 16 << 20;
