//! Entry point: parses the arguments, runs the subcommand, maps its failure to an exit code.

use std::process::ExitCode;
use tribos_cli::command;

fn main() -> ExitCode {
    command::complete();
    match command::parse().execute() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            command::warn(format_args!("error: {failure}"));
            failure.exit_code()
        }
    }
}
