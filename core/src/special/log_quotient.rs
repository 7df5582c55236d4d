//! Logarithm of a quotient near or far from 1, with one division.

use crate::real::Real;
use core::ops::{Add, Mul};

/// 2 (atanh(f)/f − 1)/f² for f² ≤ 0.0402, from the constant term on: `chebyfit` of mpmath 1.3 with 7
/// terms, to 1.4e-15; the logarithm to 3e-17 of itself.
pub const ATANH: [f64; 7] = [
    0.666_666_666_666_669_4,
    0.399_999_999_993_253_34,
    0.285_714_288_394_464_1,
    0.222_221_823_694_774_1,
    0.181_846_320_054_238_32,
    0.152_831_733_202_977_24,
    0.151_232_952_086_141_02,
];
/// The same with 3 terms, to 2.5e-7; the logarithm to 5e-9.
pub const ATANH_SINGLE: [f32; 3] = [0.666_667_1, 0.399_788_02, 0.299_627_9];

/// ln(1 + `excess`/`base`), as if `excess` and `base` were exact.
///
/// *Domain*: `base` a positive normal number, 0 ≤ `excess` < ∞; a quotient beyond 2¹⁰⁰⁰ (f32: 2¹²⁰)
/// gives some number beyond the logarithm of that. *Accuracy*: 4 ulp.
#[inline(always)]
pub(crate) fn log_quotient<R: Real>(excess: R, base: R) -> R {
    let whole = base + excess;
    let octaves = whole.octaves_above(base);
    let reduced = whole * R::power_of_two(-octaves);
    // The difference that is known is used where it counts.
    let difference = if octaves == 0 { excess } else { reduced - base };
    let f = difference / (reduced + base);
    R::from_f64(f64::from(octaves)) * R::from_f64(core::f64::consts::LN_2)
        + f * twice_atanh(f * f, |constant: R| constant)
}

/// 2 atanh(f)/f of f², of one number or of several side by side; `repeat` makes a constant of each lane.
#[inline(always)]
pub(super) fn twice_atanh<R: Real, V: Copy + Add<Output = V> + Mul<Output = V>>(
    f_sq: V,
    repeat: impl Fn(R) -> V,
) -> V {
    let constant = |c: f64| repeat(R::from_f64(c));
    let pair = |low: V, high: V| low + high * f_sq;
    let four = f_sq * f_sq;
    let sum = if R::IS_SINGLE {
        let [a, b, c] = ATANH_SINGLE.map(|c| constant(f64::from(c)));
        pair(a, b) + c * four
    } else {
        let [a, b, c, d, e, g, h] = ATANH.map(constant);
        (pair(a, b) + four * pair(c, d)) + four * four * (pair(e, g) + four * h)
    };
    repeat(R::TWO) + f_sq * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_logarithm_of_one_plus_the_quotient() {
        let mut worst = [0.0_f64; 2];
        for i in 0..20_000 {
            let excess = libm::exp(f64::from(i) * 0.004 - 40.0);
            for base in [1e-9, 0.7, 1.0, 3.0, 1e5] {
                let expected = libm::log1p(excess / base);
                let error = (log_quotient(excess, base) / expected - 1.0).abs();
                worst[0] = worst[0].max(error);
                let [excess, base] = [excess, base].map(|part| part as f32);
                let expected = libm::log1p(f64::from(excess) / f64::from(base));
                let single = f64::from(log_quotient(excess, base));
                worst[1] = worst[1].max((single / expected - 1.0).abs());
            }
        }
        assert!(worst[0] < 9e-16 && worst[1] < 4.8e-7, "{worst:?}");
        assert_eq!(log_quotient(0.0, 2.0), 0.0);
        assert!(log_quotient(1e300, f64::MIN_POSITIVE).is_finite());
    }
}
