//! What a run adds up on its way: every step of the integrator counts, not the rows of the series alone.

use super::motion::SpringSample;

/// Least and largest value seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub least: f64,
    pub most: f64,
}

impl Range {
    const NONE: Self = Self {
        least: f64::INFINITY,
        most: f64::NEG_INFINITY,
    };

    fn see(&mut self, value: f64) {
        self.least = self.least.min(value);
        self.most = self.most.max(value);
    }

    /// Difference of the two; 0 of nothing.
    pub fn swing(&self) -> f64 {
        (self.most - self.least).max(0.0)
    }
}

/// Sums over a stretch of the run.
#[derive(Clone, Debug)]
pub(super) struct RunStatistics {
    /// The speed of the pull.
    speed: f64,
    holds_exactly: bool,
    pub time: f64,
    pub slip_time: f64,
    /// ∫F dt.
    pub impulse: f64,
    pub force: Range,
    pub velocity: Range,
    /// First and last start of a slip, and how many: of laws that never hold exactly the instants at which the
    /// body becomes faster than the pull.
    pub starts: Option<[f64; 2]>,
    pub slips: u64,
}

impl RunStatistics {
    /// Nothing yet, under a pull of this speed.
    pub fn new(speed: f64, holds_exactly: bool) -> Self {
        Self {
            speed,
            holds_exactly,
            time: 0.0,
            slip_time: 0.0,
            impulse: 0.0,
            force: Range::NONE,
            velocity: Range::NONE,
            starts: None,
            slips: 0,
        }
    }

    /// One step with the impulse of the spring.
    pub fn see(&mut self, before: &SpringSample, after: &SpringSample, impulse: f64) {
        let step = after.time - before.time;
        self.time += step;
        self.impulse += impulse;
        if before.slips {
            self.slip_time += step;
        }
        for moment in [before, after] {
            self.force.see(moment.spring_force);
            self.velocity.see(moment.velocity);
        }
        if let Some(time) = self.start(before, after) {
            self.slips += 1;
            let first = self.starts.map_or(time, |[first, _]| first);
            self.starts = Some([first, time]);
        }
    }

    /// When a slip begins in this step.
    fn start(&self, before: &SpringSample, after: &SpringSample) -> Option<f64> {
        if self.holds_exactly {
            return (!before.slips && after.slips).then_some(after.time);
        }
        let (low, high) = (before.velocity, after.velocity);
        let passes = low < self.speed && high >= self.speed;
        let share = (self.speed - low) / (high - low);
        passes.then_some(before.time + share * (after.time - before.time))
    }

    /// Mean time between starts of slips.
    pub fn period(&self) -> Option<f64> {
        let [first, last] = self.starts?;
        (self.slips > 1).then(|| (last - first) / (self.slips - 1) as f64)
    }
}
