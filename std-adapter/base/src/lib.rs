//! What the simulators of Tribos share: scenes as tables, files, runs with checkpoints, periodic
//! boxes, random numbers.
//!
//! Users take it through the crate `tribos`, whose paths are the promise; what else is public here
//! serves the crates beside it and changes without notice.

pub mod bracket;
pub mod exchange;
pub mod golden;
pub mod random;
pub mod record;
pub mod results;
pub mod run;
pub mod scene;
pub mod space;
pub mod statistics;

#[doc(hidden)]
pub use serde_json;
