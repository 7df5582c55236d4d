//! What every command is told of how to speak: digits, and whether to tell of progress.

use super::digits::Digits;
use std::sync::atomic::{AtomicBool, Ordering};

/// Options that every command has.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct OutputOptions {
    /// Significant digits of printed numbers, or `full` [default: 6]; files keep all bits.
    #[arg(long, global = true, value_name = "N", help_heading = "Every command")]
    digits: Option<Digits>,
    /// Do not report progress; results, warnings and errors are still written.
    #[arg(long, short, global = true, help_heading = "Every command")]
    quiet: bool,
}

/// Whether this process tells of its progress.
static QUIET: AtomicBool = AtomicBool::new(false);

impl OutputOptions {
    /// Holds for the rest of this process.
    pub fn set_global(self) {
        if let Some(digits) = self.digits {
            digits.choose();
        }
        QUIET.store(self.quiet, Ordering::Relaxed);
    }
}

/// Whether nobody wants to hear of progress.
pub fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}
