//! Cost of the ticks of a controller.

use tribos_boards::instructions;

/// Instructions of many ticks.
#[derive(Default)]
pub struct Cost {
    ticks: u64,
    sum: u64,
    pub worst: u64,
}

impl Cost {
    /// Executes a tick and counts.
    pub fn count(&mut self, tick: &mut dyn FnMut()) {
        // Without -icount there is no count, and the budget below fails.
        let count = instructions(tick).unwrap_or(u64::MAX / 1_000_000);
        self.ticks += 1;
        self.sum += count;
        self.worst = self.worst.max(count);
    }

    pub fn mean(&self) -> u64 {
        self.sum.checked_div(self.ticks).unwrap_or(0)
    }
}
