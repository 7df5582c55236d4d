//! The twist at which inertia and the friction of all feet of a body balance.
//!
//! An implicit step of a body with mass matrix M, whose twist would be u₀ without friction, ends at
//! the smallest point of the convex function
//!
//! ```text
//! φ(u) = (u − u₀)ᵀ M (u − u₀)/2 + Δt Σ hᵢ(u + dᵢ)
//! ```
//!
//! with the dissipation hᵢ of each element ([`crate::area`]) and the motion dᵢ of its ground relative to the
//! reference ground of u (Moreau, Eur. J. Mech. A 13 (1994) 93). Newton's method finds it for one smoothing
//! σ after another, each a fraction of the last. It counts as rest where u shrinks with σ. All arithmetic is
//! in double precision, with roots and products only, so that results are bit-identical on every platform.

use crate::area::{Element, Response};
use crate::symmetric::{dot, minus, plus, solved, times};

/// First smoothing, in units of the speed without friction.
const FIRST: f64 = 0.25;
/// Ratio of successive smoothings.
const SHRINK: f64 = 1.0 / 64.0;
/// A step shorter than this fraction of u or σ is the last for its σ.
const CONVERGED: f64 = 1e-3;
/// σ/|u| at which σ no longer shows in single precision.
const SHARP: f64 = 1e-9;
/// Rounding errors of the speed without friction below which a motion counts as none.
const HELD_ULPS: f64 = 16.0;
/// Newton steps in all, and halvings of each. Fewer than 60 and 20 were seen.
const MOST_STEPS: usize = 120;
const MOST_HALVINGS: usize = 40;
/// Fraction of the linear decrease that a step must achieve.
const ENOUGH: f64 = 0.1;
/// Rounding of φ, in rounding errors of its terms.
const ROUNDING_ULPS: f64 = 32.0;
/// Least arm of spin in metres for comparing speeds with spins.
const LEAST_ARM: f64 = 1e-6;

/// A body with its feet.
#[derive(Debug)]
pub(crate) struct Balance<'a> {
    /// Components xx, xy, yy, xn, yn, nn of the mass matrix.
    pub(crate) mass: [f64; 6],
    pub(crate) elements: &'a [Element<'a>],
    /// Motion of each foot's ground relative to the first one's, as added to u.
    pub(crate) drifts: &'a [[f64; 3]],
}

/// The twist at the end, and its remaining smoothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Balanced {
    pub(crate) twist: [f64; 3],
    pub(crate) smoothing: f64,
}

impl Balance<'_> {
    /// The twist after a time `dt`, which without friction would be `free`.
    pub(crate) fn solve(&self, free: &[f64; 3], dt: f64) -> Balanced {
        let arm = self.arm();
        let drifts = self.drifts.iter().map(|drift| size(drift, arm));
        let scale = drifts.fold(size(free, arm), f64::max);
        let none = HELD_ULPS * f64::from(f32::EPSILON) * scale;
        let mut twist = *free;
        let mut smoothing = FIRST * scale;
        for _ in 0..MOST_STEPS {
            let (next, step) = self.newton(&twist, free, smoothing, dt, arm);
            twist = next;
            let length = size(&twist, arm);
            if length <= none {
                break;
            }
            if step > CONVERGED * length && step > CONVERGED * smoothing {
                continue;
            }
            if smoothing > SHARP * length {
                smoothing *= SHRINK;
            } else if step <= HELD_ULPS * f64::EPSILON * scale {
                break;
            }
        }
        Balanced {
            twist: self.held(twist, none, arm),
            smoothing,
        }
    }

    /// The twist, or that of a ground from which it does not differ.
    fn held(&self, twist: [f64; 3], none: f64, arm: f64) -> [f64; 3] {
        for element in self.elements {
            let drift = self.drift(element);
            if size(&plus(&twist, &drift), arm) <= none {
                return drift.map(|x| 0.0 - x);
            }
        }
        twist
    }

    /// Motion of an element's ground.
    pub(crate) fn drift(&self, element: &Element) -> [f64; 3] {
        self.drifts.get(element.foot).copied().unwrap_or([0.0; 3])
    }

    /// Mean distance of the elements from the centre of mass, in metres.
    fn arm(&self) -> f64 {
        let (mut sum, mut weight) = (0.0, 0.0);
        for element in self.elements {
            let [x, y] = element.place;
            sum += element.limit * ((x * x + y * y).sqrt() + element.area.radius());
            weight += element.limit;
        }
        if weight > 0.0 {
            (sum / weight).max(LEAST_ARM)
        } else {
            LEAST_ARM
        }
    }

    /// One damped step; returns its end and its length.
    fn newton(
        &self,
        from: &[f64; 3],
        free: &[f64; 3],
        smoothing: f64,
        dt: f64,
        arm: f64,
    ) -> ([f64; 3], f64) {
        let away = minus(from, free);
        let mut gradient = times(&self.mass, &away);
        let mut matrix = self.mass;
        for element in self.elements {
            let twist = plus(from, &self.drift(element));
            let Response { wrench, slope, .. } = element.response(&twist, smoothing);
            add(&mut gradient, &wrench, dt);
            add(&mut matrix, &slope, dt);
        }
        let step = solved(&matrix, &gradient.map(|x| -x));
        let slope = dot(&gradient, &step);
        let start = self.potential(from, free, smoothing, dt);
        let rounding = ROUNDING_ULPS * f64::EPSILON * start.abs();
        let mut share = 1.0;
        for _ in 0..MOST_HALVINGS {
            let at = plus(from, &step.map(|x| x * share));
            if self.potential(&at, free, smoothing, dt) <= start + ENOUGH * share * slope + rounding
            {
                break;
            }
            share *= 0.5;
        }
        let step = step.map(|x| x * share);
        (plus(from, &step), size(&step, arm))
    }

    /// φ
    fn potential(&self, at: &[f64; 3], free: &[f64; 3], smoothing: f64, dt: f64) -> f64 {
        let away = minus(at, free);
        let own = 0.5 * dot(&away, &times(&self.mass, &away));
        let power = |element: &Element| element.power(&plus(at, &self.drift(element)), smoothing);
        own + dt * self.elements.iter().map(power).sum::<f64>()
    }
}

/// Speed of a twist, with its spin at an arm.
fn size(twist: &[f64; 3], arm: f64) -> f64 {
    let rim = arm * twist[2];
    (twist[0] * twist[0] + twist[1] * twist[1] + rim * rim).sqrt()
}

fn add<const N: usize>(sum: &mut [f64; N], part: &[f64; N], factor: f64) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += factor * part;
    }
}
