//! Four numbers side by side, with the best instructions that the processor has.
//!
//! A [`Task`] is written once, for any [`Four`]. [`run`] chooses: AVX2 where the processor has it, the
//! instructions of the target else. Only operations that round like the scalar ones are offered, so that the
//! bits are the same. This crate stands apart from a library that denies unsafe code.

#[cfg(target_arch = "x86_64")]
mod avx2;
mod portable;

use portable::Portable;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Four numbers; all operations lane by lane. Comparisons give masks for [`Four::select`].
pub trait Four:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// From four numbers.
    fn new(lanes: [f64; 4]) -> Self;
    /// The same number four times.
    fn splat(number: f64) -> Self;
    /// The four numbers.
    fn lanes(self) -> [f64; 4];
    /// √x
    #[must_use]
    fn sqrt(self) -> Self;
    /// |x|
    #[must_use]
    fn abs(self) -> Self;
    /// |x| with the sign of `other`.
    #[must_use]
    fn copysign(self, other: Self) -> Self;
    /// Where x < `other`, as a mask.
    #[must_use]
    fn less(self, other: Self) -> Self;
    /// Where x ≤ `other`, as a mask.
    #[must_use]
    fn less_or_equal(self, other: Self) -> Self;
    /// Where x = `other`, as a mask.
    #[must_use]
    fn equal(self, other: Self) -> Self;
    /// Where both masks hold.
    #[must_use]
    fn and(self, other: Self) -> Self;
    /// Where this mask holds and the other does not.
    #[must_use]
    fn and_not(self, other: Self) -> Self;
    /// Where either mask holds; of numbers, the bits that either has.
    #[must_use]
    fn or(self, other: Self) -> Self;
    /// `yes` where this mask holds, `no` elsewhere.
    #[must_use]
    fn select(self, yes: Self, no: Self) -> Self;
    /// Whether this mask holds anywhere.
    fn any(self) -> bool;
    /// The columns of four rows.
    #[inline(always)]
    fn columns([a, b, c, d]: [[f64; 4]; 4]) -> [Self; 4] {
        [
            Self::new([a[0], b[0], c[0], d[0]]),
            Self::new([a[1], b[1], c[1], d[1]]),
            Self::new([a[2], b[2], c[2], d[2]]),
            Self::new([a[3], b[3], c[3], d[3]]),
        ]
    }
    /// The rows of four columns.
    #[inline(always)]
    fn rows([x, y, z, w]: [Self; 4]) -> [[f64; 4]; 4] {
        let [x, y, z, w] = [x.lanes(), y.lanes(), z.lanes(), w.lanes()];
        [
            [x[0], y[0], z[0], w[0]],
            [x[1], y[1], z[1], w[1]],
            [x[2], y[2], z[2], w[2]],
            [x[3], y[3], z[3], w[3]],
        ]
    }
    /// The rows of two columns.
    #[inline(always)]
    fn pairs([x, y]: [Self; 2]) -> [[f64; 2]; 4] {
        let [x, y] = [x.lanes(), y.lanes()];
        [[x[0], y[0]], [x[1], y[1]], [x[2], y[2]], [x[3], y[3]]]
    }
}

/// Work that is written for any four lanes. Mark `run` and what it calls `#[inline(always)]`: instructions are
/// chosen for the function that they end up in.
pub trait Task {
    /// What it gives.
    type Output;
    /// Does the work.
    fn run<L: Four>(self) -> Self::Output;
}

/// Runs a task with the best instructions that the processor has.
///
/// ```
/// use tribos_lanes::{Four, Task, run};
/// struct Lengths([[f64; 4]; 2]);
/// impl Task for Lengths {
///     type Output = [f64; 4];
///     #[inline(always)]
///     fn run<L: Four>(self) -> [f64; 4] {
///         let [x, y] = self.0.map(L::new);
///         (x * x + y * y).sqrt().lanes()
///     }
/// }
/// let lengths = run(Lengths([[3.0, 5.0, 8.0, 7.0], [4.0, 12.0, 15.0, 24.0]]));
/// assert_eq!(lengths, [5.0, 13.0, 17.0, 25.0]);
/// ```
#[inline]
pub fn run<T: Task>(task: T) -> T::Output {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        return avx2::run(task);
    }
    task.run::<Portable>()
}

/// Runs a task with the instructions of the target.
#[inline]
pub fn run_portable<T: Task>(task: T) -> T::Output {
    task.run::<Portable>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every operation on every pair of awkward numbers, as bits.
    struct All([f64; 12]);

    impl Task for All {
        type Output = Vec<[u64; 4]>;

        #[inline(always)]
        fn run<L: Four>(self) -> Self::Output {
            let mut found = Vec::new();
            for a in self.0 {
                for b in self.0 {
                    let (x, y) = (L::new([a, b, 1.0, a]), L::new([b, a, a, 3.0]));
                    let less = x.less(y);
                    let chosen = [less, x.less_or_equal(y), x.equal(y), less.or(x.equal(y))];
                    let both = [less.and(x.equal(x)), x.equal(x).and_not(less)];
                    let numbers = [x + y, x - y, x * y, x / y, -x, x.sqrt(), x.abs()];
                    let masks = chosen.into_iter().chain(both);
                    let selected = masks.map(|mask| mask.select(x, y));
                    let all = selected.chain(numbers).chain([x.copysign(y)]);
                    found.extend(all.map(|lanes| lanes.lanes().map(bits)));
                    found.push([u64::from(less.any()); 4]);
                    let rows = L::rows([x, y, x + y, x * y]);
                    found.extend(rows.map(|row| row.map(bits)));
                    found.extend(L::columns(rows).map(|lanes| lanes.lanes().map(bits)));
                    found.extend(L::pairs([x, y]).map(|[x, y]| [x, y, x, y].map(bits)));
                }
            }
            found
        }
    }

    /// All NaN are the same.
    fn bits(number: f64) -> u64 {
        if number.is_nan() {
            f64::NAN.to_bits()
        } else {
            number.to_bits()
        }
    }

    #[test]
    fn all_instructions_give_the_same_bits() {
        let numbers = [
            0.0,
            -0.0,
            1.0,
            -1.5,
            1e-310,
            -5e-324,
            1e300,
            -1e-200,
            0.1,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
        ];
        assert_eq!(run(All(numbers)), run_portable(All(numbers)));
        // And those of the scalar operations.
        let found = run(All(numbers));
        let (a, b) = (numbers[8], numbers[3]);
        let at = 27 * (8 * 12 + 3) + 6;
        let wanted = [a + b, a - b, a * b, a / b, -a, a.sqrt(), a.abs()];
        for (lanes, wanted) in found[at..].iter().zip(wanted) {
            assert_eq!(lanes[0], wanted.to_bits());
        }
        let first = [a, b, a + b, a * b];
        assert_eq!(found[at + 9], first.map(f64::to_bits));
        assert_eq!(found[at + 13], [a, b, 1.0, a].map(f64::to_bits));
        assert_eq!(found[at + 17], [a, b, a, b].map(f64::to_bits));
    }
}
