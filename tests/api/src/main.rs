//! Rewrites the kept surfaces: `cargo run -p tribos-api`.

use std::process::ExitCode;
use tribos_api::{LIBRARIES, Library, kept};

fn main() -> ExitCode {
    for package in LIBRARIES {
        let lines = Library::read(package, &[]).and_then(|library| library.lines());
        let written = lines.and_then(|lines| {
            println!("{package}: {}", lines[0].trim_start_matches("# "));
            std::fs::write(kept(package), lines.join("\n") + "\n")
                .map_err(|error| error.to_string())
        });
        if let Err(message) = written {
            eprintln!("{package}: {message}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
