//! Speed against error: makes the fronts in docs/fronts. `--help` lists the options.

use clap::Parser;
use std::process::ExitCode;
use tribos_benches::args::Options;
use tribos_benches::fronts;

fn main() -> ExitCode {
    match fronts::run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("fronts: {message}");
            ExitCode::FAILURE
        }
    }
}
