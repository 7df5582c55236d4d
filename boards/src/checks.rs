//! Checks of a program, reported line by line and by the exit status.

use crate::{exit, println};

/// Counts failed checks.
#[derive(Debug, Default)]
pub struct Checks {
    failed: u32,
}

impl Checks {
    /// Prints whether a check holds.
    pub fn check(&mut self, what: &str, holds: bool) {
        let verdict = if holds { "holds " } else { "FAILS " };
        println!("{verdict} {what}");
        self.failed += u32::from(!holds);
    }

    /// Ends the program with an error unless all checks held.
    pub fn finish(self) {
        if self.failed > 0 {
            println!("{} checks failed", self.failed);
            exit(1);
        }
    }
}
