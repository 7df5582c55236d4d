//! Final motion: what is left of sliding and spinning just before rest.

use crate::exchange::Refused;
use tribos_core::coupling::PowerLawFriction;
use tribos_core::modes::{Stability, TerminalMode, TerminalMotion};

/// Fixed points of the ratio of sliding to spinning, and the last motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FinalMotion {
    /// Interval of the inertia ratio with a fixed point between spinning and sliding.
    pub interval: (f64, f64),
    /// Stability of spinning, ratio and stability of the point between (NaN if there is none), stability of
    /// sliding.
    pub points: [f64; 4],
    /// The ratio in the limit of rest; NaN if it depends on the launch.
    pub last: f64,
}

impl FinalMotion {
    /// Of a body with I/(M R²); `initial_ratio` is NaN if it is not known.
    pub fn new<P: PowerLawFriction<f64>>(
        profile: P,
        inertia_ratio: f64,
        initial_ratio: f64,
    ) -> Result<Self, Refused> {
        let modes = TerminalMotion::new(profile, inertia_ratio)?;
        let points = modes.fixed_points();
        // Without a start the end is known only where it does not depend on it.
        let depends = match points.finite {
            Some((_, stability)) => stability != Stability::Stable,
            None => points.spinning == Stability::Semistable,
        };
        let start = if initial_ratio.is_nan() {
            (!depends).then_some(1.0)
        } else {
            Some(initial_ratio)
        };
        let last = start.map_or(f64::NAN, |start| match modes.terminal_mode(start) {
            TerminalMode::Spinning => 0.0,
            TerminalMode::Sliding => f64::INFINITY,
            TerminalMode::Together { ratio } => ratio,
        });
        let (ratio, between) = points.finite.map_or((f64::NAN, f64::NAN), |(ratio, kind)| {
            (ratio, number_of(kind))
        });
        Ok(Self {
            interval: modes.inertia_interval(),
            points: [
                number_of(points.spinning),
                ratio,
                between,
                number_of(points.sliding),
            ],
            last,
        })
    }

    /// As numbers.
    pub fn row(&self) -> [f64; 7] {
        let [spinning, ratio, between, sliding] = self.points;
        let (least, most) = self.interval;
        [least, most, spinning, ratio, between, sliding, self.last]
    }
}

fn number_of(stability: Stability) -> f64 {
    match stability {
        Stability::Stable => 0.0,
        Stability::Semistable => 1.0,
        Stability::Unstable => 2.0,
    }
}
