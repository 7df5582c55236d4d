//! The place where a condition begins to hold, by halving.

/// An interval on whose lower end a condition fails and on whose upper end it holds, as its maker has checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// Where the condition fails.
    pub low: f64,
    /// Where it holds.
    pub high: f64,
}

impl Bracket {
    /// Between two places.
    pub const fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// Halved so many times, or until no number lies between the ends: a bracket of the condition still.
    pub fn halved(mut self, times: usize, mut holds: impl FnMut(f64) -> bool) -> Self {
        for _ in 0..times {
            let middle = self.middle();
            if !(middle > self.low && middle < self.high) {
                break;
            }
            if holds(middle) {
                self.high = middle;
            } else {
                self.low = middle;
            }
        }
        self
    }

    /// The middle.
    pub fn middle(self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bracket_keeps_what_it_brackets_and_ends_at_neighbours() {
        let root = |x: f64| x * x >= 2.0;
        let Bracket { low, high } = Bracket::new(1.0, 2.0).halved(200, root);
        assert!(!root(low) && root(high) && high == low.next_up());
        let coarse = Bracket::new(1.0, 2.0).halved(3, root);
        assert_eq!(coarse, Bracket::new(1.375, 1.5));
        assert_eq!(coarse.middle(), 1.4375);
    }
}
