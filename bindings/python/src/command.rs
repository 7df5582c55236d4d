//! The command `tribos`, as the wheel installs it.

use pyo3::prelude::*;
use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use tribos::run::program::{self, Program};

/// Runs the command with the arguments of this process, the program's name first: its exit code.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| {
        let code = tribos_cli::run(arguments);
        // The interpreter, which ends this process, does not know of this buffer.
        let _ = std::io::stdout().flush();
        code
    })
}

/// Says which program runs here: its command line, the file of the command `tribos`, and this library.
#[pyfunction]
pub fn host(line: Vec<OsString>, command: Option<PathBuf>, library: PathBuf) {
    program::host(Program {
        line,
        command,
        library,
    });
}
