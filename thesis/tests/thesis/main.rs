//! The program as a reader of the thesis meets it.

#[path = "../../../cli/tests/command/browser/mod.rs"]
#[allow(dead_code)] // The command's own pages are driven further.
mod browser;
mod report;
