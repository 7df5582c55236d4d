//! What the launcher can do, and how far that reaches.

use super::root::rising_root;
use super::{InverseError, RestMap};
use tribos_core::coupling::{Coupling, Profile};

/// The fastest launch: a solution is admissible if |velocity| ≤ `max_speed` and |spin| ≤ `max_spin`,
/// to the bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    max_speed: f64,
    max_spin: f64,
}

impl Limits {
    /// *Domain*: finite and not negative; m/s and rad/s.
    pub fn new(max_speed: f64, max_spin: f64) -> Result<Self, InverseError> {
        let limit = |name: &'static str, given: f64| {
            if given >= 0.0 && given.is_finite() {
                Ok(given)
            } else {
                Err(InverseError::Limit { name, given })
            }
        };
        Ok(Self {
            max_speed: limit("speed", max_speed)?,
            max_spin: limit("spin", max_spin)?,
        })
    }

    /// Largest speed, m/s.
    pub fn max_speed(&self) -> f64 {
        self.max_speed
    }

    /// Largest spin, rad/s.
    pub fn max_spin(&self) -> f64 {
        self.max_spin
    }
}

impl<P: Profile<f64> + Coupling<f64>> RestMap<P> {
    /// Distance and |angle| at rest for speed and |spin|. Neither falls if either argument grows.
    pub fn reach(&self, speed: f64, spin: f64) -> [f64; 2] {
        let landing = self.rest(&super::Launch {
            velocity: [speed, 0.0],
            spin: spin.abs(),
        });
        [landing.pose.x, landing.pose.angle]
    }

    /// Shortest and farthest distance within `limits` for a body that turns by |`angle`|; none
    /// if it cannot turn that far.
    ///
    /// Both ends are launches at a limit: the shortest spins fastest, the farthest slides
    /// fastest.
    pub fn distances(&self, angle: f64, limits: &Limits) -> Option<[f64; 2]> {
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
