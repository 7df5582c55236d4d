//! The normal force of a contact over one step.
//!
//! Leapfrog takes half of a step's impulse from the force at its start and half from that at its end. Where a
//! contact begins or ends on the way, that is wrong by up to half a step's force, and by chance: a bounce would gain
//! or lose energy with the instant at which steps meet it. So the impulse is that of the path of the gap:
//!
//! - Springs and cohesion do the work of their energies, ∫ F dt = dt ΔU/Δδ, where they begin or end.
//! - A dashpot's impulse ∫ c δ' dt = Δ∫ c dδ depends on the path alone.
//! - A contact only pushes: where it stops to, its force is cut off on the line from its old value to what would
//!   pull.
//!
//! What the first half of the step has not taken yet is left to its second half.

use super::law::Law;

/// How a contact went through a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage {
    /// Gaps at its start and end.
    pub gaps: [f64; 2],
    /// Force of spring and dashpot at its start, which only push, and cohesion there.
    pub push: f64,
    pub pull: f64,
    /// Speed at which the surfaces parted between its halves.
    pub opening: f64,
    /// Effective mass and radius.
    pub mass: f64,
    pub lever: f64,
    pub dt: f64,
}

/// What it leads to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kick {
    /// Force of spring and dashpot at the end, and cohesion there.
    pub push: f64,
    pub pull: f64,
    /// Impulses of both in the second half of the step.
    pub pushed: f64,
    pub pulled: f64,
    /// How long friction acts in that half: with the force at the end, or with that at the start if nothing pushes
    /// at the end.
    pub time: f64,
    /// Energy that the dashpot has taken in the step.
    pub lost: f64,
}

/// Overlap of a gap.
fn overlap(gap: f64) -> f64 {
    if gap < 0.0 { -gap } else { 0.0 }
}

impl Passage {
    /// Part of the step within a gap, if exactly one of its ends is.
    fn part_within(&self, gap: f64) -> f64 {
        let [start, end] = self.gaps;
        let (inner, outer) = if end < start {
            (end, start)
        } else {
            (start, end)
        };
        let way = outer - inner;
        if way > 0.0 { (gap - inner) / way } else { 1.0 }
    }

    /// Impulse of cohesion in the second half of the step, and its force at the end.
    fn pulled<F>(&self, law: &Law<F>) -> [f64; 2] {
        let strength = law.cohesion.strength();
        let pull = law.pull(self.gaps[1]);
        let (was_held, is_held) = (self.pull > 0.0, pull > 0.0);
        let part = match (was_held, is_held) {
            (true, true) => 1.0,
            (false, false) => 0.0,
            _ => self.part_within(law.cohesion.range()),
        };
        [(strength * part - 0.5 * self.pull) * self.dt, pull]
    }

    /// Forces at the end of the step, and impulses in its second half.
    pub fn kick<F>(&self, law: &Law<F>) -> Kick {
        let [pulled, pull] = self.pulled(law);
        let [start, end] = self.gaps.map(overlap);
        let (springs, dt) = (&law.stiffness, self.dt);
        let at = |overlap: f64| {
            let [force, slope] = springs.force(overlap, self.lever);
            [force, slope, springs.dashpot(law.damping, slope, self.mass)]
        };
        let ([old_force, old_slope, old_c], [force, _, c]) = (at(start), at(end));
        let is_open = self.gaps.map(|gap| gap >= 0.0);
        let spring = if is_open[0] == is_open[1] {
            0.5 * dt * (old_force + force)
        } else {
            let energy = springs.energy(end, force) - springs.energy(start, old_force);
            dt * energy / (self.gaps[0] - self.gaps[1])
        };
        let dashpot = springs.dashpot_path() * (c * end - old_c * start);

        // Half of the force at the start has acted. The force at the end has the dashpot at the speed of half a step
        // before, which is none at rest: all loads act on it, those of other contacts too.
        let first = 0.5 * dt * self.push;
        let left = spring + dashpot - first;
        let raw = if is_open[1] {
            let line = -(old_slope * self.gaps[1] + old_c * self.opening);
            if line > 0.0 { 0.0 } else { line }
        } else {
            force - c * self.opening
        };
        let half = 0.5 * dt;
        let (push, pushed, time) = if is_open[1] || raw < 0.0 {
            let cut = first * (self.push / (self.push - raw));
            if self.push > 0.0 {
                (0.0, cut - first, (cut - first) / self.push)
            } else {
                (0.0, 0.0, 0.0)
            }
        } else if is_open[0] {
            (raw, left, if raw > 0.0 { left / raw } else { 0.0 })
        } else if self.push > 0.0 {
            (raw, left, half)
        } else {
            (raw, half * raw, half)
        };
        let opened = self.gaps[1] - self.gaps[0];
        let lost = (spring - first - pushed) / dt * opened;
        Kick {
            push,
            pull,
            pushed,
            pulled,
            time,
            lost: if dt > 0.0 { lost } else { 0.0 },
        }
    }
}
