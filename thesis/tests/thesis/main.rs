//! The program as a reader of the thesis meets it, and what its texts, tables and formulas promise.

#[path = "../../../cli/tests/command/browser/mod.rs"]
#[allow(dead_code)] // The command's own pages are driven further.
mod browser;
mod coverage;
mod formulas;
mod kept;
mod outlook;
mod page;
mod report;
mod rows;

use browser::Error;

type Outcome = Result<(), Error>;
