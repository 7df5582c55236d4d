//! Interface of a contact problem for global solvers, independent of the type of its bodies.

/// An impulse of one contact: an element of a vector space.
///
/// See [`Operator`] for an example.
pub trait Impulse: Copy + Default {
    /// `self` + `factor` · `other`
    #[must_use]
    fn plus_scaled(&self, factor: f64, other: &Self) -> Self;
}

/// Observer of a sweep over the contacts.
pub trait Monitor: Send {
    /// False if it records nothing.
    const WATCHES: bool = true;
    /// A new monitor of the same kind, without data.
    fn fork(&self) -> Self;
    /// Records one contact: the square of its impulse's change, P (the force scale of its friction), and
    /// the change of its normal speed.
    fn record(&mut self, change_sq: f64, bound: f64, speed: f64);
    /// Records the product of a contact's change with its step before, in [`Operator::sweep_on`].
    fn follow(&mut self, along: f64) {
        let _ = along;
    }
    /// Adds the data of a monitor that observed the contacts after those of this one.
    fn join(&mut self, later: &Self);
}

/// The order in which a sweep visits contacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Visit<'a> {
    /// In the order of their numbers.
    Forward,
    /// In reverse order.
    Backward,
    /// In the order of a list.
    Listed(&'a [u32]),
}

/// A contact problem: impulses at contacts, and bodies that respond to them.
///
/// The operator holds the current impulses and the velocities that follow from them.
///
/// ```
/// use tribos::cd::{IterationOrder, StopRule};
/// use tribos::cd::internals::{Impulse, Operator, Sweeper, Visit, Monitor, solve};
///
/// /// Wagons of 1 t in a row; their buffers push and do not pull.
/// struct Train {
///     free: [f64; 3], // m/s, without contacts
///     speeds: [f64; 3],
///     pushes: [Push; 2],
/// }
/// #[derive(Clone, Copy, Default)]
/// struct Push(f64); // t m/s
///
/// impl Impulse for Push {
///     fn plus_scaled(&self, factor: f64, other: &Self) -> Self {
///         Self(self.0 + factor * other.0)
///     }
/// }
/// impl Operator for Train {
///     type Impulse = Push;
///     fn contacts(&self) -> usize {
///         2
///     }
///     fn impulse(&self, contact: usize) -> Push {
///         self.pushes[contact]
///     }
///     fn dot(&self, _: usize, a: &Push, b: &Push) -> f64 {
///         a.0 * b.0
///     }
///     fn guess(&mut self, contact: usize, push: &Push) {
///         self.pushes[contact] = if push.0 < 0.0 { Push(0.0) } else { *push };
///     }
///     fn refresh(&mut self) {
///         let [first, second] = self.pushes.map(|push| push.0);
///         let [a, b, c] = self.free;
///         self.speeds = [a - first, b + first - second, c + second];
///     }
///     fn sweep<W: Monitor>(&mut self, _: Visit<'_>, watch: &mut W) {
///         for contact in 0..2 {
///             // Half the closing speed: a wagon meets another of the same mass.
///             let closing = self.speeds[contact] - self.speeds[contact + 1];
///             let old = self.pushes[contact];
///             self.guess(contact, &Push(old.0 + 0.5 * closing));
///             let change = self.pushes[contact].0 - old.0;
///             self.refresh();
///             watch.record(change * change, self.pushes[contact].0, 2.0 * change.abs());
///         }
///     }
/// }
///
/// // One wagon runs into two at rest, and takes them along.
/// let free = [3.0, 0.0, 0.0];
/// let mut train = Train { free, speeds: free, pushes: [Push(0.0); 2] };
/// solve(&mut train, &mut Sweeper::new(IterationOrder::Fixed, 0), StopRule::Local(1e-12), 100);
/// for speed in train.speeds {
///     assert!((speed - 1.0).abs() < 1e-9);
/// }
/// ```
pub trait Operator {
    /// Impulse of one contact.
    type Impulse: Impulse;

    /// Number of contacts.
    fn contacts(&self) -> usize;

    /// The current impulse.
    fn impulse(&self, contact: usize) -> Self::Impulse;

    /// Inner product of two impulses of a contact, with torques counted as forces at a lever.
    fn dot(&self, contact: usize, a: &Self::Impulse, b: &Self::Impulse) -> f64;

    /// Replaces the impulse by the nearest admissible one; velocities are invalid until
    /// [`Operator::refresh`].
    fn guess(&mut self, contact: usize, impulse: &Self::Impulse);

    /// Recomputes the velocities from all impulses, in the order of the contacts.
    fn refresh(&mut self);

    /// Solves the laws of every contact in turn, with all other contacts held fixed.
    fn sweep<W: Monitor>(&mut self, visit: Visit<'_>, watch: &mut W);

    /// A sweep forward from impulses y to x, with `swept` x₋ those after the sweep before. The monitor follows
    /// (x − y)·(y − x₋), contact by contact: a negative sum says that the sweep leads back.
    fn sweep_on<W: Monitor>(&mut self, swept: &[Self::Impulse], watch: &mut W) {
        let start: Vec<_> = (0..self.contacts()).map(|at| self.impulse(at)).collect();
        self.sweep(Visit::Forward, watch);
        for (contact, (start, swept)) in start.iter().zip(swept).enumerate() {
            let change = self.impulse(contact).plus_scaled(-1.0, start);
            let before = start.plus_scaled(-1.0, swept);
            watch.follow(self.dot(contact, &change, &before));
        }
    }

    /// Goes on to x + β (x − x₋), as far as admissible, from the impulses x now and `swept` x₋, which become x;
    /// velocities follow. An operator may keep the list and give another one of the same length.
    fn extrapolate(&mut self, beta: f64, swept: &mut Vec<Self::Impulse>) {
        for (contact, swept) in swept.iter_mut().enumerate() {
            let now = self.impulse(contact);
            let step = now.plus_scaled(-1.0, swept);
            self.guess(contact, &now.plus_scaled(beta, &step));
            *swept = now;
        }
        self.refresh();
    }
}

/// A monitor that records nothing and has no cost.
///
/// ```
/// use tribos::cd::internals::{NoMonitor, Monitor};
/// NoMonitor.record(1.0, 1.0, 1.0);
/// assert_eq!(size_of::<NoMonitor>(), 0);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct NoMonitor;

impl Monitor for NoMonitor {
    const WATCHES: bool = false;
    fn fork(&self) -> Self {
        Self
    }
    #[inline(always)]
    fn record(&mut self, _: f64, _: f64, _: f64) {}
    fn join(&mut self, _: &Self) {}
}

/// Change of the impulses in one sweep.
///
/// ```
/// use tribos::cd::internals::{GlobalChange, Monitor};
/// // Two contacts: |Δp| of 3 and 4 where P is 10 each, and no speed but 0.2 at the second.
/// let mut change = GlobalChange::default();
/// change.record(9.0, 10.0, 0.0);
/// let mut other = change.fork(); // on another thread
/// other.record(16.0, 10.0, 0.2);
/// change.join(&other);
/// assert!((change.relative() - (25.0_f64 / 200.0).sqrt()).abs() < 1e-15);
/// assert_eq!((change.relative_mean(), change.speed), (7.0 / 20.0, 0.2));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GlobalChange {
    /// Sum of squares Σ |Δp|².
    pub change_sq: f64,
    /// Sum of squares Σ P².
    pub bound_sq: f64,
    /// Sums Σ |Δp| and Σ P, for the mean.
    pub mean: [f64; 2],
    /// Largest correction of the normal speed at a contact.
    pub speed: f64,
    /// Sum of the products that [`Monitor::follow`] records.
    pub along: f64,
}

impl GlobalChange {
    /// Relative change √(Σ|Δp|²/ΣP²); 0 without contacts.
    pub fn relative(&self) -> f64 {
        ratio(self.change_sq, self.bound_sq).sqrt()
    }

    /// Relative mean change ⟨|Δp|⟩/⟨P⟩, the global criterion of Unger and Kertész (2003).
    pub fn relative_mean(&self) -> f64 {
        ratio(self.mean[0], self.mean[1])
    }
}

/// `change`/`scale`, and 0 for a zero change whatever the scale.
fn ratio(change: f64, scale: f64) -> f64 {
    if change == 0.0 { 0.0 } else { change / scale }
}

/// The larger of two numbers; NaN if either is NaN.
#[inline(always)]
pub(super) fn largest(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

impl Monitor for GlobalChange {
    fn fork(&self) -> Self {
        Self::default()
    }

    #[inline(always)]
    fn record(&mut self, change_sq: f64, bound: f64, speed: f64) {
        self.speed = largest(self.speed, speed);
        self.change_sq += change_sq;
        self.bound_sq += bound * bound;
        self.mean[0] += change_sq.sqrt();
        self.mean[1] += bound;
    }

    #[inline(always)]
    fn follow(&mut self, along: f64) {
        self.along += along;
    }

    fn join(&mut self, later: &Self) {
        self.change_sq += later.change_sq;
        self.bound_sq += later.bound_sq;
        self.mean[0] += later.mean[0];
        self.mean[1] += later.mean[1];
        self.along += later.along;
        self.speed = largest(self.speed, later.speed);
    }
}

/// Changes below this share of the problem's largest P are rounding: bodies sum the impulses of all their contacts.
/// Forces that are less than that are not resolved.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Whether every impulse changed by less than a fraction of its P, or by what rounding leaves of the largest one.
///
/// ```
/// use tribos::cd::internals::{LocalChange, Monitor};
/// let mut watch = LocalChange::above(0.1);
/// watch.record(0.5 * 0.5, 10.0, 0.0); // |Δp| is a twentieth of P
/// watch.record(1e-30, 0.0, 0.0); // the rounding of the other
/// assert!(watch.is_at_rest());
/// watch.record(1e-20, 0.0, 0.0); // more than that
/// assert!(!watch.is_at_rest());
/// let mut broken = watch.fork();
/// broken.record(f64::NAN, 10.0, 0.0); // never at rest
/// assert!(!broken.is_at_rest());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalChange {
    tolerance_sq: f64,
    /// Largest change², among the contacts above the tolerance.
    moved_sq: f64,
    /// Largest P².
    bound_sq: f64,
}

impl LocalChange {
    /// Judges changes above `tolerance`·P.
    pub fn above(tolerance: f64) -> Self {
        Self {
            tolerance_sq: tolerance * tolerance,
            moved_sq: 0.0,
            bound_sq: 0.0,
        }
    }

    /// Whether no recorded contact changed by more.
    pub fn is_at_rest(&self) -> bool {
        self.moved_sq <= ROUNDING * ROUNDING * self.bound_sq && self.bound_sq < f64::INFINITY
    }
}

impl Monitor for LocalChange {
    fn fork(&self) -> Self {
        Self {
            moved_sq: 0.0,
            bound_sq: 0.0,
            ..*self
        }
    }

    #[inline(always)]
    fn record(&mut self, change_sq: f64, bound: f64, _: f64) {
        let bound_sq = bound * bound;
        // A zero change has converged for any bound; NaN has not.
        let rests = change_sq <= self.tolerance_sq * bound_sq;
        if !rests {
            self.moved_sq = largest(self.moved_sq, change_sq);
        }
        self.bound_sq = largest(self.bound_sq, bound_sq);
    }

    fn join(&mut self, later: &Self) {
        self.moved_sq = largest(self.moved_sq, later.moved_sq);
        self.bound_sq = largest(self.bound_sq, later.bound_sq);
    }
}
