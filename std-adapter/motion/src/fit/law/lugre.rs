//! LuGre: its steady curve, and its bristles over time.

use super::super::Measurements;
use super::super::parameter::{FitParameter, Model, Range};
use super::{
    DataRange, Interval, between, distances, intervals, log_between, merged, order, picked,
};
use std::borrow::Cow;
use tribos_core::law::{Bristle, LuGre, LuGreParameters};

const PARAMETERS: [FitParameter; 6] = [
    FitParameter {
        name: "fc",
        unit: "N",
        meaning: "Coulomb force",
        range: Range::Positive,
    },
    FitParameter {
        name: "fs",
        unit: "N",
        meaning: "static force",
        range: Range::Positive,
    },
    FitParameter {
        name: "vs",
        unit: "m/s",
        meaning: "Stribeck speed",
        range: Range::Positive,
    },
    FitParameter {
        name: "s2",
        unit: "N s/m",
        meaning: "viscous damping",
        range: Range::NotNegative,
    },
    FitParameter {
        name: "s0",
        unit: "N/m",
        meaning: "stiffness of the bristles",
        range: Range::Positive,
    },
    FitParameter {
        name: "s1",
        unit: "N s/m",
        meaning: "damping of the bristles",
        range: Range::NotNegative,
    },
];
/// The first four describe steady sliding.
const STEADY: usize = 4;

fn law(values: &[f64]) -> Option<LuGre<f64>> {
    // Steady sliding does not depend on the bristles.
    let at = |index: usize| values.get(index).copied().unwrap_or(1.0);
    LuGre::new(LuGreParameters {
        coulomb_force: at(0),
        static_force: at(1),
        stribeck_speed: at(2),
        viscous_damping: at(3),
        stiffness: at(4),
        bristle_damping: at(5),
    })
    .ok()
}

/// Starts of the parameters of steady sliding.
fn steady_start(unit: &[f64], scales: &DataRange) -> Vec<f64> {
    let [low, high] = scales.forces;
    vec![
        between(unit[0], [0.5 * low, low]),
        between(unit[1], [0.5 * (low + high), 1.5 * high]),
        log_between(unit[2], scales.speeds),
        unit[3] * high / scales.speeds[1],
    ]
}

/// Steady friction.
pub(super) struct Steady<'a> {
    pub speeds: Cow<'a, [f64]>,
    pub scales: DataRange,
}

impl Model for Steady<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &PARAMETERS[..STEADY]
    }

    fn reference(&self, _: usize) -> Option<f64> {
        None
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let law = law(values)?;
        Some(self.speeds.iter().map(|&v| law.steady_force(v)).collect())
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        steady_start(unit, &self.scales)
    }

    fn project_to_valid(&self, values: &mut [f64], is_free: &[bool]) {
        order(values, is_free, [0, 1]);
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model>> {
        Some(Box::new(Steady {
            speeds: Cow::Owned(picked(&self.speeds, points)),
            scales: self.scales,
        }))
    }
}

/// A record over time.
pub(super) struct Series<'a> {
    velocities: Cow<'a, [f64]>,
    intervals: Vec<Interval>,
    /// Forces from half of the largest to the largest.
    scales: DataRange,
    slid: [f64; 2],
}

impl<'a> Series<'a> {
    pub fn new(data: &Measurements, times: &'a [f64], velocities: &'a [f64]) -> Self {
        let [_, largest] = data.forces();
        let intervals = intervals(times, velocities);
        Self {
            slid: distances(&intervals),
            velocities: Cow::Borrowed(velocities),
            intervals,
            scales: DataRange {
                speeds: data.speeds(),
                forces: [0.5 * largest, largest],
            },
        }
    }
}

impl Model for Series<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &PARAMETERS
    }

    fn reference(&self, _: usize) -> Option<f64> {
        None
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let law = law(values)?;
        let first = *self.velocities.first()?;
        let mut bristle = Bristle::RELAXED;
        if first != 0.0 {
            bristle.deflection = law.steady_bristle_force(first).copysign(first) / values[4];
        }
        let mut forces = vec![law.force(bristle, first)];
        for (&(dt, mean), &velocity) in self.intervals.iter().zip(&self.velocities[1..]) {
            bristle = law.step(bristle, mean, dt).0;
            forces.push(law.force(bristle, velocity));
        }
        Some(forces)
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        let mut start = steady_start(unit, &self.scales);
        let force = self.scales.forces[1];
        // The bristles yield at a distance between the shortest and the whole one.
        let [shortest, whole] = self.slid;
        start.push(log_between(unit[4], [force / whole, force / shortest]));
        /// Damping of bristles, over the largest force at the largest speed.
        const DAMPING: [f64; 2] = [1e-3, 1.0];
        start.push(log_between(unit[5], DAMPING) * force / self.scales.speeds[1]);
        start
    }

    fn project_to_valid(&self, values: &mut [f64], is_free: &[bool]) {
        order(values, is_free, [0, 1]);
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model>> {
        Some(Box::new(Series {
            velocities: Cow::Owned(picked(&self.velocities, points)),
            intervals: merged(&self.intervals, points),
            scales: self.scales,
            slid: self.slid,
        }))
    }
}
