//! x^α for one exponent α, prepared once.
//!
//! With x = 2^e m and a tabulated c near 1/m,
//!
//! ```text
//! x^α = 2^(eα) · c^(−α) · (1 + t)^α,      t = m c − 1
//! ```
//!
//! Both powers in front are kept as a head of half the digits and a tail: the product of the heads
//! is exact, so that the last sum alone rounds visibly. t is exact up to its last digit, because c
//! has 11 binary digits and m is split in two. (1 + t)^α − 1 = t q(t) with a short polynomial q.

mod build;

pub(crate) use build::halved;

use crate::real::{Real, STEPS};
use core::ops::{Add, Mul, Sub};

/// Octaves of x in the table: 2⁻³² ≤ x < 2³², about.
const OCTAVES: usize = 64;
/// The octave of x = 1.
const OCTAVE_OF_ONE: usize = OCTAVES / 2;
/// Terms of q.
const COEFFICIENTS: usize = 8;
/// Terms of q in single precision.
const COEFFICIENTS_F32: usize = 5;

/// c, and c^(−α) as head and tail.
#[derive(Clone, Copy, Debug)]
struct Cell<R> {
    inverse: R,
    head: R,
    tail: R,
}

/// The factors of a power: a number, or one for each of several powers at once.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Parts<V> {
    /// The upper digits of m.
    pub head: V,
    /// The lower digits of m.
    pub tail: V,
    /// c
    pub inverse: V,
    /// 2^(eα) as head and tail.
    pub octave: [V; 2],
    /// c^(−α) as head and tail.
    pub cell: [V; 2],
}

/// x^α and x^(α−1) for a fixed α in 1.9 KiB (f32: 0.9 KiB).
///
/// *Domain*: −1 < α ≤ 10 and any x. *Accuracy* between 2⁻³² and 2³²: in f64 0.52 ulp for |α| ≤ 1,
/// 0.6 ulp up to α = 5, 0.9 ulp up to 10; in f32 1 ulp. Beyond, and where the power is near the end
/// of the number range, that of [`Real::pow`]. 1^α is exactly 1. *Special values*: those of
/// [`Real::pow`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct FixedPower<R> {
    alpha: R,
    /// 2^(eα) as head and tail; NaN where it is near the end of the number range.
    octaves: [[R; 2]; OCTAVES],
    cells: [Cell<R>; STEPS],
    terms: [R; COEFFICIENTS],
}

impl<R: Real> FixedPower<R> {
    /// `x`^α
    #[inline]
    pub fn of(&self, x: R) -> R {
        if self.alpha == R::ZERO {
            return R::ONE;
        }
        let power = self.inside(x);
        if power.is_nan() {
            return far(x, self.alpha);
        }
        power
    }

    /// `x`^(α−1). *Accuracy*: half a unit in the last place more than that of [`FixedPower::of`].
    #[inline]
    pub fn rate(&self, x: R) -> R {
        if self.alpha == R::ZERO {
            return R::ONE / x;
        }
        let power = self.inside(x);
        if power.is_nan() {
            return far(x, self.alpha - R::ONE);
        }
        power / x
    }

    /// `x`^α, NaN where the table does not reach.
    #[inline]
    fn inside(&self, x: R) -> R {
        match self.parts(x) {
            Some(parts) => parts.joined(&self.terms, R::ONE, R::IS_SINGLE),
            None => R::NAN,
        }
    }

    /// What the table has for `x`.
    #[inline]
    pub fn parts(&self, x: R) -> Option<Parts<R>> {
        let split = x.split();
        let octave = *self
            .octaves
            .get(split.exponent.wrapping_add(OCTAVE_OF_ONE))?;
        let cell = &self.cells[split.cell % STEPS];
        Some(Parts {
            head: split.head,
            tail: split.tail,
            inverse: cell.inverse,
            octave,
            cell: [cell.head, cell.tail],
        })
    }

    /// α
    #[allow(dead_code, reason = "for targets with vectors")]
    #[inline]
    pub fn alpha(&self) -> R {
        self.alpha
    }

    /// The coefficients of q.
    #[allow(dead_code, reason = "for targets with vectors")]
    #[inline]
    pub fn terms(&self) -> [R; COEFFICIENTS] {
        self.terms
    }
}

impl<V: Copy + Add<Output = V> + Sub<Output = V> + Mul<Output = V>> Parts<V> {
    /// The power, with the coefficients of q, 1, and whether the precision is single.
    #[inline(always)]
    pub fn joined(&self, terms: &[V; COEFFICIENTS], one: V, is_single: bool) -> V {
        let ([high, low], [head, tail]) = (self.octave, self.cell);
        let t = (self.head * self.inverse - one) + self.tail * self.inverse;
        let front = high * head;
        let rest = high * tail + low * (head + tail);
        front + (rest + (front + rest) * (t * bend(terms, t, is_single)))
    }
}

/// q(t)
#[inline(always)]
fn bend<V: Copy + Add<Output = V> + Mul<Output = V>>(
    &[a, b, c, d, e, f, g, h]: &[V; COEFFICIENTS],
    t: V,
    is_single: bool,
) -> V {
    let square = t * t;
    let lower = (a + b * t) + (c + d * t) * square;
    let upper = if is_single {
        e
    } else {
        (e + f * t) + (g + h * t) * square
    };
    lower + upper * (square * square)
}

/// Powers beyond the table.
#[cold]
#[inline(never)]
fn far<R: Real>(x: R, exponent: R) -> R {
    x.pow(exponent)
}

#[cfg(test)]
mod tests;
