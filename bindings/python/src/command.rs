//! The command `tribos`, as the wheel installs it.

use pyo3::prelude::*;

/// Runs the command with the arguments of this process, the program's name first; ends with its exit code.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<String>) -> u8 {
    py.detach(|| tribos_cli::run(arguments))
}
