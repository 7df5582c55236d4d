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
const MOST_POINTS: usize = 2000;
/// Most steps of the search for a state.
const MOST_STEPS: usize = 6;
/// Step that ends the search, over the largest state.
const CLOSE: f64 = 1e-11;
/// Effects of two parts of a state that are told apart: squared effect left over the whole.
const APART: f64 = 1e-10;

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
            let (next, largest) = self.step(state, advance);
            state = next;
            if largest < CLOSE {
                break;
            }
        }
        state
    }

    /// One step, and its largest part.
    fn step(
        &self,
        state: M::State,
        advance: &impl Fn(M::State, usize) -> M::State,
    ) -> (M::State, f64) {
        let [begin, end] = self.points;
        let velocity = self.velocities[begin];
        // A state at its limit is moved inwards.
        let changed = |part: usize| {
            let moved = |change: f64| self.law.shifted(state, part, change, velocity);
            let there = moved(CHANGE);
            if there == state {
                (moved(-CHANGE), -CHANGE)
            } else {
                (there, CHANGE)
            }
        };
        let changed: Vec<(M::State, f64)> = (0..M::PARTS).map(changed).collect();
        let (mut here, mut there) = (state, changed.clone());
        let (mut products, mut along) = ([[0.0; 3]; 3], [0.0; 3]);
        let mut strongest = 0.0_f64;
        for point in begin..end.min(begin + MOST_POINTS) {
            if point > begin {
                here = advance(here, point);
                for (state, _) in &mut there {
                    *state = advance(*state, point);
                }
            }
            let friction = self.law.friction(here, self.velocities[point]);
            let mut effect = [0.0; 3];
            for (effect, (state, change)) in effect.iter_mut().zip(&there) {
                *effect = (self.law.friction(*state, self.velocities[point]) - friction) / change;
            }
            let most = effect.iter().fold(0.0_f64, |most, e| e.abs().max(most));
            strongest = strongest.max(most);
            if most <= FORGOTTEN * strongest {
                break;
            }
            let left = friction - self.measured(point);
            for a in 0..M::PARTS {
                along[a] += effect[a] * left;
                for b in 0..M::PARTS {
                    products[a][b] += effect[a] * effect[b];
                }
            }
        }
        let steps = solved(products, along, M::PARTS);
        let (mut next, mut largest) = (state, 0.0_f64);
        for (part, step) in steps.iter().enumerate().take(M::PARTS) {
            if step.is_finite() {
                next = self.law.shifted(next, part, -step, velocity);
                largest = largest.max(step.abs());
            }
        }
        (next, largest)
    }
}

/// The solution of normal equations by elimination; parts that the points do not tell stay.
fn solved(mut a: [[f64; 3]; 3], mut b: [f64; 3], parts: usize) -> [f64; 3] {
    let whole: [f64; 3] = std::array::from_fn(|k| a[k][k]);
    let mut told = [false; 3];
    for k in 0..parts {
        told[k] = a[k][k] > APART * whole[k] && a[k][k] > 0.0;
        if !told[k] {
            continue;
        }
        for i in k + 1..parts {
            let factor = a[i][k] / a[k][k];
            for j in k..parts {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    let mut x = [0.0; 3];
    for k in (0..parts).rev().filter(|&k| told[k]) {
        let known: f64 = (k + 1..parts).map(|j| a[k][j] * x[j]).sum();
        x[k] = (b[k] - known) / a[k][k];
    }
    x
}
