//! Products, logarithms and minima that stay right at the ends of the number range.

use super::LocalLaw;
use crate::real::Real;

/// `coefficient` × `value`, where a coefficient of zero switches an infinite value off.
#[inline]
pub(super) fn scaled<R: Real>(coefficient: R, value: R) -> R {
    if coefficient == R::ZERO && !value.is_nan() {
        R::ZERO
    } else {
        coefficient * value
    }
}

/// ln(`over`/`under`), also where the quotient leaves the number range.
#[inline]
pub(super) fn ln_ratio<R: Real>(over: R, under: R) -> R {
    let ratio = over / under;
    if ratio.is_finite() && ratio >= R::MIN_POSITIVE {
        ratio.ln()
    } else {
        over.ln() - under.ln()
    }
}

/// Bound of the bisection: 53 bits of mantissa after at most 200 octaves.
const HALVINGS: usize = 256;

/// Where friction turns from falling to rising in (`falling`, `rising`], by bisection of the
/// slope's sign.
pub(super) fn minimum_between<R: Real>(law: &impl LocalLaw<R>, falling: R, rising: R) -> R {
    let (mut low, mut high) = (falling, rising);
    for _ in 0..HALVINGS {
        let middle = low + (high - low) * R::HALF;
        if middle <= low || middle >= high {
            break;
        }
        if law.slope(middle) < R::ZERO {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}
