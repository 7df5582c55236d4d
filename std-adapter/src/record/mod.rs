//! What a run leaves behind: numbers as text, whole files or none.

mod atomic;
mod number;
mod series;

pub use atomic::{WriteError, write_atomically};
pub use number::{json_number, number};
pub use series::series_csv;
