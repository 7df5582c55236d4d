//! The unique launch that covers a given distance while turning through a given angle.

use super::RestMap;
use super::root::rising_root;
use tribos_core::Real;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};

/// Magnitudes of a launch, and its time to rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaunchMagnitudes {
    /// Speed v.
    pub speed: f64,
    /// Spin |ω|.
    pub spin: f64,
    pub time: f64,
}

/// If the logarithms of the paths differ by more than this, the motion is pure: the other part is far
/// below every rounding error.
const PURE: f64 = 230.0;
/// The farthest rim path is limited to this logarithm of the ratio of the paths, just below [`PURE`].
const SPUN: f64 = 229.0;
/// Tolerance of the ratio of the paths, a tenth of its rounding errors.
const ENOUGH: f64 = 1e-15;
/// Factor by which a bracket is widened if it does not contain the root.
const WIDEN: f64 = 2.0;

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> RestMap<P> {
    /// The launch for `distance` ≥ 0 and `angle` ≥ 0; it exists and is unique.
    pub(super) fn throw(&self, distance: f64, angle: f64) -> LaunchMagnitudes {
        let rim_path = angle * self.radius();
        if distance == 0.0 && rim_path == 0.0 {
            return LaunchMagnitudes {
                speed: 0.0,
                spin: 0.0,
                time: 0.0,
            };
        }
        let direction = self.direction(distance, rim_path);
        let paths = self.reduced(direction);
        // Both paths together give the scale: s^p hypot(X, Y) = κ hypot(d, R angle).
        let wanted = self.deceleration() * Real::hypot(distance, rim_path);
        let scale = Real::pow(
            wanted / Real::hypot(paths.centre, paths.rim),
            1.0 / self.degree(),
        );
        let pace = Real::pow(scale, self.degree() - 1.0);
        let [c, n] = direction;
        LaunchMagnitudes {
            speed: scale * c,
            spin: scale * n / self.radius(),
            time: pace * paths.time / self.deceleration(),
        }
    }

    /// The largest angle for which a launch over `distance` has a positive speed; `None` if the distance is 0.
    pub(super) fn farthest_turn(&self, distance: f64) -> f64 {
        match distance {
            0.0 => f64::INFINITY,
            _ => distance * Real::exp(SPUN) / self.radius(),
        }
    }

    /// The direction (c, n) whose paths have the requested ratio: ln(Y/X) rises with ln(n/c).
    fn direction(&self, distance: f64, rim_path: f64) -> [f64; 2] {
        let wanted = Real::ln(rim_path) - Real::ln(distance);
        if wanted < -PURE {
            return [1.0, 0.0];
        }
        if wanted > PURE {
            return [0.0, 1.0];
        }
        let excess = |log_ratio: f64| {
            let paths = self.reduced(direction_of(log_ratio));
            Real::ln(paths.rim / paths.centre) - wanted
        };
        let near = (wanted, excess(wanted));
        // A slope of one would put the root here; the bracket grows outwards until the sign changes.
        let mut step = -near.1;
        let mut inner = near;
        loop {
            let at = wanted + step;
            let outer = (at, excess(at));
            if (outer.1 > 0.0) != (near.1 > 0.0) || outer.1 == 0.0 || !outer.1.is_finite() {
                let (below, above) = if near.1 > 0.0 {
                    (outer, inner)
                } else {
                    (inner, outer)
                };
                return direction_of(rising_root(below, above, ENOUGH, excess));
            }
            if step == 0.0 {
                return direction_of(wanted);
            }
            inner = outer;
            step *= WIDEN;
        }
    }
}

/// (c, n) with n/c = e^`log_ratio`.
fn direction_of(log_ratio: f64) -> [f64; 2] {
    let ratio = Real::exp(log_ratio);
    let length = Real::hypot(ratio, 1.0);
    [1.0 / length, ratio / length]
}
