//! Entry point: parses the arguments, runs the subcommand, maps its failure to an exit code.

use std::process::ExitCode;
use tribos_cli::command;
use tribos_cli::failure::Failure;

fn main() -> ExitCode {
    command::complete();
    match command::parse().execute() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure @ Failure::Interrupted(_)) => {
            command::warn(format_args!("{failure}"));
            failure.exit_code()
        }
        Err(failure) => {
            command::warn(format_args!("error: {failure}"));
            failure.exit_code()
        }
    }
}
