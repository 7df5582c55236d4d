//! Files that a command reads and writes.

use crate::failure::Failure;
use std::path::Path;

/// Refuses an output that is one of the command's own inputs; `option` names the output.
pub fn refuse_input(option: &str, output: &Path, input: &Path) -> Result<(), Failure> {
    if !is_same(output, input) {
        return Ok(());
    }
    Err(Failure::input(format!(
        "{option} {} is what the command reads; name another file",
        output.display()
    )))
}

/// Whether both are one regular file, by whatever names.
#[cfg(unix)]
fn is_same(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let (Ok(one), Ok(other)) = (one.metadata(), other.metadata()) else {
        return false;
    };
    one.is_file() && (one.dev(), one.ino()) == (other.dev(), other.ino())
}

#[cfg(not(unix))]
fn is_same(one: &Path, other: &Path) -> bool {
    one.is_file()
        && matches!((one.canonicalize(), other.canonicalize()), (Ok(one), Ok(other)) if one == other)
}
