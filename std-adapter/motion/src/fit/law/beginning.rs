//! Where a record begins, and begins anew after a gap: the state there is the one that suits the friction measured
//! after it best, so that neither its noise nor an unknown past changes the parameters.

use super::record::Memory;
use std::borrow::Cow;

/// Interval between two points over those before and after it that is a gap.
const GAP: f64 = 4.0;
/// Largest share of the points that are gaps; beyond, a record is sampled at random and has none.
const MOST_GAPS: f64 = 0.01;
/// Change of the state for its effect, over the largest state.
const CHANGE: f64 = 1e-4;
/// Share of the effect from which on the state counts as forgotten.
const FORGOTTEN: f64 = 1e-6;
/// Most points that tell a state.
const MOST_POINTS: usize = 400;
/// Most steps of the search for a state.
const MOST_STEPS: usize = 3;
/// Step that ends the search, over the largest state.
const CLOSE: f64 = 1e-9;

/// Points where a state begins: the first, and those after gaps.
pub(super) fn beginnings(times: &[f64]) -> Vec<usize> {
    let long = |i: &usize| {
        let dt = |i: usize| times.get(i).zip(times.get(i - 1)).map(|(b, a)| b - a);
        let around = [*i - 1, *i + 1].map(|i| if i == 0 { None } else { dt(i) });
        let [before, after] = around.map(|dt| dt.unwrap_or(0.0));
        // A point between two gaps tells of no state.
        after > 0.0 && before > 0.0 && dt(*i).is_some_and(|dt| dt > GAP * before.max(after))
    };
    let gaps: Vec<usize> = (1..times.len()).filter(long).collect();
    let first = std::iter::once(0);
    if gaps.len() as f64 > 1.0 + MOST_GAPS * times.len() as f64 {
        return first.collect();
    }
    first.chain(gaps).collect()
}

/// The points from a beginning on.
pub(super) struct Stretch<'a, M: Memory> {
    pub law: &'a M,
    pub velocities: &'a [f64],
    /// Friction measured at the points.
    pub measured: &'a Cow<'a, [f64]>,
    /// Friction that is not the law's.
    pub beside: &'a [f64],
    /// The first point, and the one after the last.
    pub points: [usize; 2],
}

impl<M: Memory> Stretch<'_, M> {
    /// Friction of the law that was measured at a point.
    fn measured(&self, point: usize) -> f64 {
        self.measured[point] - self.beside.get(point).unwrap_or(&0.0)
    }

    /// The state at the beginning with the least sum of squares after it, by Gauss–Newton steps.
    pub fn state(&self, advance: &impl Fn(M::State, usize) -> M::State) -> M::State {
        let begin = self.points[0];
        let velocity = self.velocities[begin];
        let mut state = self.law.first(velocity, self.measured(begin));
        for _ in 0..if M::IS_LINEAR { 1 } else { MOST_STEPS } {
            let (next, size) = self.step(state, advance);
            state = next;
            if size < CLOSE {
                break;
            }
        }
        state
    }

    /// One step, and its size.
    fn step(
        &self,
        state: M::State,
        advance: &impl Fn(M::State, usize) -> M::State,
    ) -> (M::State, f64) {
        let [begin, end] = self.points;
        let velocity = self.velocities[begin];
        // A state at its limit is moved inwards.
        let mut change = CHANGE;
        let mut there = self.law.shifted(state, change, velocity);
        if there == state {
            change = -CHANGE;
            there = self.law.shifted(state, change, velocity);
        }
        let mut here = state;
        let (mut square, mut along, mut strongest) = (0.0, 0.0, 0.0_f64);
        for point in begin..end.min(begin + MOST_POINTS) {
            if point > begin {
                here = advance(here, point);
                there = advance(there, point);
            }
            let velocity = self.velocities[point];
            let friction = self.law.friction(here, velocity);
            let effect = (self.law.friction(there, velocity) - friction) / change;
            strongest = strongest.max(effect.abs());
            if effect.abs() <= FORGOTTEN * strongest {
                break;
            }
            square += effect * effect;
            along += effect * (friction - self.measured(point));
        }
        let step = -along / square;
        if step.is_finite() {
            (self.law.shifted(state, step, velocity), step.abs())
        } else {
            (state, 0.0)
        }
    }
}
