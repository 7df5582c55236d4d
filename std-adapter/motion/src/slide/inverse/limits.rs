//! Limits of the launcher, and their reach.

use super::root::rising_root;
use super::{MotionError, RestMap};
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};

/// The fastest launch: a solution is admissible if |velocity| ≤ `max_speed` and |spin| ≤ `max_spin`,
/// compared exactly.
///
/// ```
/// use tribos::slide::inverse::{MotionError, LaunchLimits, RestMap};
/// use tribos::kernel::coupling::coulomb::CoulombDisk;
/// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
/// let limits = LaunchLimits::new(3.0, 50.0)?;
/// assert_eq!((limits.max_speed(), limits.max_spin()), (3.0, 50.0));
/// // Alone, v²/(2 mu g) and ω²/2 over (2/3) mu g/(C R); together both go on for longer.
/// let (way, angle) = (9.0 / (2.0 * 0.3 * 9.81), 2500.0 * 0.08 * 3.0 / (8.0 * 0.3 * 9.81));
/// assert!((disk.reach(3.0, 0.0)[0] - way).abs() < 1e-13);
/// assert!((disk.reach(0.0, 50.0)[1] - angle).abs() < 1e-12);
/// let [far, most] = disk.reach(3.0, 50.0);
/// assert!(far > way && most > angle);
/// assert_eq!(disk.distances(0.0, &limits), Some([0.0, disk.reach(3.0, 0.0)[0]]));
/// assert_eq!(disk.distances(2.0 * most, &limits), None);
/// assert!(matches!(LaunchLimits::new(-3.0, 50.0), Err(MotionError::Limit { name: "speed", .. })));
/// # Ok::<(), tribos::slide::inverse::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaunchLimits {
    max_speed: f64,
    max_spin: f64,
}

impl LaunchLimits {
    /// *Domain*: finite and not negative; m/s and rad/s.
    pub fn new(max_speed: f64, max_spin: f64) -> Result<Self, MotionError> {
        let limit = |name: &'static str, given: f64| {
            if given >= 0.0 && given.is_finite() {
                Ok(given)
            } else {
                Err(MotionError::Limit { name, given })
            }
        };
        Ok(Self {
            max_speed: limit("speed", max_speed)?,
            max_spin: limit("spin", max_spin)?,
        })
    }

    /// Largest speed, in m/s.
    pub fn max_speed(&self) -> f64 {
        self.max_speed
    }

    /// Largest spin, in rad/s.
    pub fn max_spin(&self) -> f64 {
        self.max_spin
    }
}

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> RestMap<P> {
    /// Distance and |angle| at rest for speed and |spin|. Neither decreases if either argument grows.
    pub fn reach(&self, speed: f64, spin: f64) -> [f64; 2] {
        let landing = self.rest(&super::Launch {
            velocity: [speed, 0.0],
            spin: spin.abs(),
        });
        [landing.pose.x, landing.pose.angle]
    }

    /// Shortest and longest distance within `limits` for a body that turns by |`angle`|; `None` if it
    /// cannot turn that far.
    ///
    /// Both ends are launches at a limit: the shortest has the fastest spin, the longest the highest
    /// speed.
    pub fn distances(&self, angle: f64, limits: &LaunchLimits) -> Option<[f64; 2]> {
        let (angle, speed, spin) = (angle.abs(), limits.max_speed, limits.max_spin);
        let turned = |speed: f64, spin: f64| self.reach(speed, spin)[1];
        let most = turned(speed, spin);
        if angle > most {
            return None;
        }
        let in_place = turned(0.0, spin);
        let nearest = if angle <= in_place {
            0.0
        } else {
            let ends = ((0.0, in_place - angle), (speed, most - angle));
            let slowest = rising_root(ends.0, ends.1, 0.0, |v| turned(v, spin) - angle);
            self.reach(slowest, spin)[0]
        };
        let ends = ((0.0, -angle), (spin, most - angle));
        let least_spin = match angle {
            0.0 => 0.0,
            _ => rising_root(ends.0, ends.1, 0.0, |w| turned(speed, w) - angle),
        };
        Some([nearest, self.reach(speed, least_spin)[0]])
    }
}
