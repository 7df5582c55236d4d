//! Speed against error: makes the fronts in docs/fronts. `--help` lists the options.

use std::process::ExitCode;
use tribos_benches::args::{HELP, Request};
use tribos_benches::fronts;

fn main() -> ExitCode {
    let request = Request::read(std::env::args().skip(1));
    let done = request.and_then(|request| match request {
        Request::Help => {
            print!("{HELP}");
            Ok(())
        }
        Request::Fronts(options) => fronts::run(&options),
    });
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("fronts: {message}");
            ExitCode::FAILURE
        }
    }
}
