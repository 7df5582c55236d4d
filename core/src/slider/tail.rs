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
pub(super) struct Tail<R> {
    /// Rates of fading of both speeds, here.
    pub here: [R; 2],
    /// In the end.
    pub end: [R; 2],
    /// λ
    pub settling: R,
}

/// Newton's method for a time: the first guess is right to the small number.
const MOST_CORRECTIONS: u32 = 8;

impl<R: Real> Tail<R> {
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

    /// The s at which the integral is `wanted`.
    pub fn inverse(&self, here: R, end: R, wanted: R) -> R {
        let rate = if self.is_slow(end) { here } else { end };
        let product = rate * wanted;
        let mut s = if product == R::ZERO {
            wanted
        } else if product < R::ONE - R::EPSILON {
            -(-product).ln_1p() / rate
        } else {
            -R::EPSILON.ln() / rate
        };
        for _ in 0..MOST_CORRECTIONS {
            let off = wanted - self.until(here, end, s);
            let step = off * self.faded_at(here, end, s).exp();
            s += step;
            let is_met = step.abs() <= R::EPSILON * s.abs();
            if is_met {
                break;
            }
        }
        s
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
