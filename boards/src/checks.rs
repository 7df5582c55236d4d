//! What must hold in a program: told line by line, and by the way that the program ends.

use crate::{exit, println};

/// Counts what did not hold.
#[derive(Debug, Default)]
pub struct Checks {
    failed: u32,
}

impl Checks {
    /// Tells whether something holds.
    pub fn check(&mut self, what: &str, holds: bool) {
        let verdict = if holds { "holds " } else { "FAILS " };
        println!("{verdict} {what}");
        self.failed += u32::from(!holds);
    }

    /// Ends the program as failed unless everything held.
    pub fn finish(self) {
        if self.failed > 0 {
            println!("{} checks failed", self.failed);
            exit(1);
        }
    }
}
