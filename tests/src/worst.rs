//! The largest error and the argument at which it occurs.

use crate::tolerance::Bound;

/// Accumulates the largest of many errors.
#[derive(Clone, Debug)]
pub struct Worst {
    quantity: String,
    error: f64,
    place: String,
    seen: usize,
}

impl Worst {
    /// No errors so far.
    pub fn of(quantity: impl Into<String>) -> Self {
        Self {
            quantity: quantity.into(),
            error: 0.0,
            place: String::new(),
            seen: 0,
        }
    }

    /// Adds one error; NaN counts as infinite.
    pub fn see(&mut self, error: f64, place: impl FnOnce() -> String) {
        self.seen += 1;
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if error > self.error {
            self.error = error;
            self.place = place();
        }
    }

    /// The largest error so far.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Fails if the largest error exceeds `bound`; prints it as a row, which docs/tables/accuracy.csv keeps.
    ///
    /// # Panics
    /// If it does, or if nothing was seen.
    #[track_caller]
    pub fn assert_within(&self, bound: &Bound) {
        assert!(self.seen > 0, "{}: nothing was checked", self.quantity);
        println!(
            "| {} | {:.2e} | {:.1e} | {} | {} |",
            self.quantity, self.error, bound.limit, self.place, self.seen
        );
        assert!(
            self.error <= bound.limit,
            "{}: {:.3e} exceeds {:.1e} ({}) at {}",
            self.quantity,
            self.error,
            bound.limit,
            bound.reason,
            self.place
        );
    }

    /// [`Worst::assert_within`] where something was seen.
    ///
    /// # Panics
    /// If the largest error exceeds `bound`.
    #[track_caller]
    pub fn assert_if_seen(&self, bound: &Bound) {
        if self.seen > 0 {
            self.assert_within(bound);
        }
    }

    /// Like [`Worst::assert_within`] for a tolerance that is looser than the `general` one: also fails
    /// if the general one would be met.
    ///
    /// # Panics
    /// If the error exceeds `bound` or stays below `general`.
    #[track_caller]
    pub fn assert_excused(&self, bound: &Bound, general: &Bound) {
        self.assert_within(bound);
        assert!(
            self.error > general.limit,
            "{}: {:.3e} no longer needs more than {:.1e}",
            self.quantity,
            self.error,
            general.limit
        );
    }
}
