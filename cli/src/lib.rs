//! The `tribos` command: arguments in, reports out. The physics is in `tribos` and `tribos-core`.

pub mod command;
pub mod failure;
#[doc(hidden)]
pub mod library;

use failure::Failure;
use std::ffi::OsString;

/// Runs the command with `arguments`, the program's name first; answers its exit code. Help and refused
/// arguments end the process.
pub fn run(arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>) -> u8 {
    let arguments: Vec<OsString> = arguments.into_iter().map(Into::into).collect();
    command::complete(&arguments);
    match command::parse(arguments).execute() {
        Ok(()) => 0,
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
