//! The end of a motion, where the direction is nearly constant.
//!
//! The rate k at which an integrand falls tends to its limit like a small number that itself fades with a rate
//! λ, k(s) = k_e + (k − k_e) e^(−λs). To first order in k − k_e
//!
//! ```text
//! ∫ exp(−∫k) ds = (1/k_e) (1 − (k − k_e)/(k_e + λ))      from 0 to infinity
//! ```

use crate::real::Real;

/// Rates here and in the end.
#[derive(Clone, Copy, Debug)]
pub(super) struct FinalDecay<R> {
    /// Rates of fading of both speeds, here.
    pub here: [R; 2],
    /// In the end.
    pub end: [R; 2],
    /// λ
    pub settling: R,
}

/// Newton's method for a time. The first guess is right to the small number; next to rest, where what is left is
/// smaller than that, a step is worth 1/k, and after 36 of these all that is left is rounding.
const MOST_CORRECTIONS: u32 = 48;
/// Rounding errors of the integral, two differences of exponentials, within which a time is met.
const MET_ULPS: f64 = 16.0;

impl<R: Real> FinalDecay<R> {
    /// The whole integral of an integrand that falls at the rate `here` and in the end at `end`.
    pub fn all(&self, here: R, end: R) -> R {
        if self.is_slow(end) {
            return R::ONE / here;
        }
        (R::ONE - (here - end) / (end + self.settling)) / end
    }

    /// The integral up to `s`.
    pub fn until(&self, here: R, end: R, s: R) -> R {
        if self.is_slow(end) {
            return faded_time(here, s);
        }
        let (plain, settled) = (faded_time(end, s), faded_time(end + self.settling, s));
        plain - (here - end) * ((plain - settled) / self.settling)
    }

    /// By how much both speeds fade up to `s`, as logarithms.
    pub fn faded(&self, s: R) -> [R; 2] {
        let [slide, rim] = self.end;
        [
            self.faded_at(self.here[0], slide, s),
            self.faded_at(self.here[1], rim, s),
        ]
    }

    /// The s at which the integral is `wanted`; `None` if none was found, and for NaN.
    pub fn inverse(&self, here: R, end: R, wanted: R) -> Option<R> {
        let rate = if self.is_slow(end) { here } else { end };
        let product = rate * wanted;
        let mut s = if product == R::ZERO {
            wanted
        } else if product < R::ONE - R::EPSILON {
            -(-product).ln_1p() / rate
        } else {
            -R::EPSILON.ln() / rate
        };
        let (mut low, mut high) = (R::ZERO, R::INFINITY);
        for _ in 0..MOST_CORRECTIONS {
            let off = wanted - self.until(here, end, s);
            if off > R::ZERO {
                low = s;
            } else {
                high = s;
            }
            let newton = off * self.faded_at(here, end, s).exp();
            // From beyond, where the integral hardly grows, it would lead far back.
            let step = if s + newton < low {
                R::HALF * (low + high) - s
            } else {
                newton
            };
            s += step;
            let is_met = s.is_finite() && step.abs() <= R::EPSILON * s.abs();
            if is_met {
                return Some(s);
            }
        }
        // Where the integral hardly grows any more a rounding error of it is a long step.
        let off = wanted - self.until(here, end, s);
        (off.abs() <= R::from_f64(MET_ULPS) * R::EPSILON * wanted.abs()).then_some(s)
    }

    /// ∫k from 0 to `s`.
    fn faded_at(&self, here: R, end: R, s: R) -> R {
        if self.is_slow(end) {
            return here * s;
        }
        end * s + (here - end) * faded_time(self.settling, s)
    }

    /// True if the direction keeps while the motion fades.
    fn is_slow(&self, end: R) -> bool {
        let fast = self.settling > R::EPSILON.sqrt() * end.abs();
        !fast
    }
}

/// ∫ e^(−ks) from 0 to `s`.
fn faded_time<R: Real>(k: R, s: R) -> R {
    let product = k * s;
    if product == R::ZERO {
        s
    } else {
        s * (-(-product).exp_m1() / product)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_that_is_found_is_the_one_asked_for_and_a_miss_is_told() {
        let tail = |settling: f64| FinalDecay {
            here: [1.0; 2],
            end: [1.0; 2],
            settling,
        };
        for (here, end, settling) in [(1.01, 1.0, 0.7), (2.0, 2.1, 3.0), (0.5, 0.5, 0.0)] {
            for share in [1e-9, 0.1, 0.5, 0.9, 0.999, 1.0 - 1e-12] {
                let tail = tail(settling);
                let wanted = share * tail.all(here, end);
                let s = tail.inverse(here, end, wanted).unwrap();
                assert!(
                    (tail.until(here, end, s) / wanted - 1.0).abs() < 1e-14,
                    "{share}"
                );
            }
        }
        // Beyond all that there is.
        let endless = tail(0.7).inverse(1.01, 1.0, 2.0);
        assert_eq!(endless, None);
        assert_eq!(tail(0.7).inverse(f64::NAN, 1.0, 0.5), None);
    }
}
