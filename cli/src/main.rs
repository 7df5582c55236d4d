//! Entry point of the program.

use std::process::ExitCode;

fn main() -> ExitCode {
    tribos_cli::run(std::env::args_os()).into()
}
