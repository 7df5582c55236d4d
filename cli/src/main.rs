//! Entry point: parses the arguments, runs the subcommand, maps its failure to an exit code.

use clap::Parser;
use std::process::ExitCode;
use tribos_cli::command::Command;

/// Solid friction: laws, final motion, simulations and the thesis' results reproduced.
///
/// Exit codes: 0 done, 1 the run failed, 2 bad usage or bad input, 3 results
/// differ from those pinned.
#[derive(Parser)]
#[command(name = "tribos", version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    match Arguments::parse().command.execute() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("error: {failure}");
            failure.exit_code()
        }
    }
}
