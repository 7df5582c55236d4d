//! `tribos reproduce`: starts the program `tribos-thesis`.

use super::output_options;
use crate::failure::Failure;
use std::env::consts::EXE_SUFFIX;
use std::ffi::OsString;
use std::io;
use std::path::PathBuf;
use std::process::Command;
use tribos::run::program;

/// The program that makes the report.
const PROGRAM: &str = "tribos-thesis";

/// Reproduce the results of the thesis, claim by claim: every figure and table as CSV, SVG and PNG, and
/// index.html with the thesis' claims, our numbers, their uncertainty, a verdict and its grounds.
///
/// The report is made by a program of its own, `tribos-thesis`, which is looked for beside this one and then
/// on the PATH, and gets these arguments; `tribos-thesis --help` explains them all.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// What `tribos-thesis` takes: --out DIR, --full, --list, names such as 3.4 or table-3.1.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

const EXAMPLES: &str = "\
Examples:
  tribos reproduce --out out/thesis
  tribos reproduce --out out/thesis 3.4 3.13 table-3.1
  tribos reproduce --out out/porosity 4.7 --full
  tribos reproduce --list";

impl Arguments {
    /// Makes the report, and ends with the program's exit code.
    pub fn execute(self) -> Result<(), Failure> {
        let mut thesis = thesis();
        if output_options::is_quiet() {
            thesis.arg("--quiet");
        }
        Err(missing(&become_program(thesis.args(self.arguments))))
    }
}

/// The program beside this one, or else on the PATH.
fn thesis() -> Command {
    let own = program::command().ok();
    let beside = own.and_then(|own| Some(own.parent()?.join(format!("{PROGRAM}{EXE_SUFFIX}"))));
    Command::new(
        beside
            .filter(|file| file.is_file())
            .unwrap_or_else(|| PathBuf::from(PROGRAM)),
    )
}

/// The names that can be reproduced; none where the program is missing.
pub fn names() -> Vec<String> {
    let output = thesis().arg("--list").output();
    let listed = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    listed
        .unwrap_or_default()
        .lines()
        .map(String::from)
        .collect()
}

/// Replaces this process, so that signals and the exit code are the program's; returns if that fails.
#[cfg(unix)]
fn become_program(program: &mut Command) -> io::Error {
    std::os::unix::process::CommandExt::exec(program)
}

/// Runs the program and ends as it does; returns if it does not start.
#[cfg(not(unix))]
fn become_program(program: &mut Command) -> io::Error {
    match program.status() {
        Ok(status) => std::process::exit(status.code().unwrap_or(1)),
        Err(error) => error,
    }
}

fn missing(error: &io::Error) -> Failure {
    Failure::run(match error.kind() {
        io::ErrorKind::NotFound => format!(
            "`tribos reproduce` needs the program {PROGRAM}, which is neither beside this one nor on the PATH; in a \
             clone, `cargo install --path thesis` installs it, and `cargo run --release -p {PROGRAM} -- --out DIR` runs it"
        ),
        _ => format!("cannot start {PROGRAM}: {error}"),
    })
}
