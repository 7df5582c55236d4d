//! An input: where a subject's numbers come from, where its answers go, and what is judged of them.

use crate::Source;
use core::fmt;
use core::ops::{Deref, DerefMut};
use tribos_core::real::Real;

/// The judgement of one input, or of a part of it.
pub type Verdict<T = ()> = Result<T, Stop>;

/// Why an input ends early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// The kernel refused arguments.
    Refused,
    /// A property does not hold.
    Broken(Broken),
}

/// The random numbers of one input and the receiver of its answers.
pub struct Input<'a> {
    source: Source,
    out: &'a mut dyn FnMut(u64),
}

/// A broken property and the numbers that break it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Broken {
    what: &'static str,
    fault: &'static str,
    values: [f64; KEPT],
    count: usize,
}

/// Numbers that a broken property keeps: a Jacobian.
const KEPT: usize = 9;
/// All NaN count as this one: their payload and sign are not part of any promise.
const CANONICAL_NAN: u64 = 0x7ff8_0000_0000_0000;
/// Rounding errors by which an inequality of sums and products may be violated.
const ROUNDING: f64 = 256.0;

impl<'a> Input<'a> {
    /// The input of one seed; `out` receives the bits of its answers.
    pub fn new(seed: u64, out: &'a mut dyn FnMut(u64)) -> Self {
        let source = Source::new(seed);
        Self { source, out }
    }

    /// Gives bits.
    pub fn give_bits(&mut self, bits: u64) {
        (self.out)(bits);
    }

    /// Gives answers of which nothing is promised but their bits: those of their f64, which is exact for
    /// f32, subnormals and −0 included.
    pub fn give<R: Real>(&mut self, values: impl IntoIterator<Item = R>) {
        for x in values {
            let wide = x.to_f64();
            let is_nan = wide.is_nan();
            self.give_bits(if is_nan {
                CANONICAL_NAN
            } else {
                wide.to_bits()
            });
        }
    }

    /// Gives whether a constructor took its arguments, and what it made.
    pub fn taken<T, E>(&mut self, made: Result<T, E>) -> Verdict<T> {
        self.give_bits(u64::from(made.is_ok()));
        made.map_err(|_| Stop::Refused)
    }

    /// Gives whether the kernel has what it must have, and that.
    pub fn present<T>(&mut self, what: &'static str, found: Option<T>) -> Verdict<T> {
        self.give_bits(u64::from(found.is_some()));
        found.ok_or(Stop::Broken(Broken::of([what, "is not there"])))
    }

    /// Gives answers that are finite if the input is mild.
    pub fn finite<R: Real>(
        &mut self,
        what: &'static str,
        values: impl IntoIterator<Item = R>,
    ) -> Verdict {
        let is_mild = self.is_mild();
        self.each([what, "is not finite"], values, |x| {
            x.is_finite() || !is_mild
        })
    }

    /// Gives answers that are not NaN, whatever the input.
    pub fn numbers<R: Real>(
        &mut self,
        what: &'static str,
        values: impl IntoIterator<Item = R>,
    ) -> Verdict {
        self.each([what, "is NaN"], values, |x| !x.is_nan())
    }

    /// Gives answers that are NaN because an argument is.
    pub fn all_nan<R: Real>(
        &mut self,
        what: &'static str,
        values: impl IntoIterator<Item = R>,
    ) -> Verdict {
        self.each([what, "is a number for NaN"], values, |x| x.is_nan())
    }

    fn each<R: Real>(
        &mut self,
        said: [&'static str; 2],
        values: impl IntoIterator<Item = R>,
        is_fine: impl Fn(R) -> bool,
    ) -> Verdict {
        let (mut broken, mut are_fine) = (Broken::of(said), true);
        for x in values {
            self.give([x]);
            broken.keep(x);
            are_fine &= is_fine(x);
        }
        if are_fine {
            Ok(())
        } else {
            Err(Stop::Broken(broken))
        }
    }

    /// Gives `values`, at least one, which are reported if the condition does not hold.
    pub fn holds<R: Real>(&mut self, condition: bool, what: &'static str, values: &[R]) -> Verdict {
        let said = [what, "does not hold"];
        self.each(said, values.iter().copied(), |_| condition)
    }

    /// Judges `part` ≤ `whole` up to the rounding of `scale`.
    pub fn at_most<R: Real>(&mut self, what: &'static str, part: R, whole: R, scale: R) -> Verdict {
        let most = whole + rounding::<R>() * scale.abs();
        self.holds(part <= most, what, &[part, whole, scale])
    }

    /// Judges `part` ≤ `whole` up to the accuracy of searches, of `scale`, and gives nothing if it holds: what is
    /// pinned are answers.
    pub fn accurate<R: Real>(
        &mut self,
        what: &'static str,
        part: R,
        whole: R,
        scale: R,
    ) -> Verdict {
        if part <= whole + accuracy::<R>() * scale {
            return Ok(());
        }
        self.holds(false, what, &[part, whole, scale])
    }
}

/// What an inequality of numbers of order 1 may be violated by.
pub fn rounding<R: Real>() -> R {
    R::from_f64(ROUNDING) * R::EPSILON
}

/// Searches are accurate to 1e-8 (f32: 1e-5), and ten times as inaccurate is what follows from them.
pub fn accuracy<R: Real>() -> R {
    R::from_f64(if size_of::<R>() == 4 { 1e-4 } else { 1e-7 })
}

impl Deref for Input<'_> {
    type Target = Source;

    fn deref(&self) -> &Source {
        &self.source
    }
}

impl DerefMut for Input<'_> {
    fn deref_mut(&mut self) -> &mut Source {
        &mut self.source
    }
}

impl fmt::Debug for Input<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.source.fmt(f)
    }
}

impl Broken {
    fn of([what, fault]: [&'static str; 2]) -> Self {
        Self {
            what,
            fault,
            values: [0.0; KEPT],
            count: 0,
        }
    }

    fn keep<R: Real>(&mut self, x: R) {
        if let Some(value) = self.values.get_mut(self.count) {
            (*value, self.count) = (x.to_f64(), self.count + 1);
        }
    }
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let values = self.values.get(..self.count).unwrap_or_default();
        write!(f, "{} {}: {values:?}", self.what, self.fault)
    }
}
