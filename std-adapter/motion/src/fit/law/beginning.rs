//! Where a record begins, and begins anew after a gap or a jump of the velocity: the state there is the one that suits
//! the friction measured after it best, so that neither its noise nor an unknown past changes the parameters.

use super::course::MIDWAY;
use super::record::Memory;
use std::borrow::Cow;

/// Change of an unknown for its effect: of a state over the largest one, of an instant over the interval.
const CHANGE: f64 = 1e-4;
/// Share of the effect from which on the state counts as forgotten.
const FORGOTTEN: f64 = 1e-6;
/// Most points that tell an unknown.
const MOST_POINTS: usize = 400;
/// Most rounds of the search for each part of a state, and for the instant of a jump.
const MOST_ROUNDS: usize = 3;
const MOST_OF_JUMPS: usize = 8;
/// Step that ends the search.
const CLOSE: f64 = 1e-9;

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

    /// The state at the beginning with the least sum of squares after it.
    pub fn state(&self, advance: &impl Fn(M::State, usize) -> M::State) -> M::State {
        let begin = self.points[0];
        let first = self.law.first(self.velocities[begin], self.measured(begin));
        let shifted = |state, part, share| self.law.shifted(state, part, share);
        let search = Sought {
            first,
            parts: M::PARTS,
            rounds: if M::IS_LINEAR {
                1
            } else {
                MOST_ROUNDS * M::PARTS
            },
            points: self.points,
            change: CHANGE,
        };
        search.state(|state| state, shifted, advance, &self.misfit())
    }

    /// The state at the beginning after a jump of the velocity, as it follows from the instant of the jump, at the
    /// instant with the least sum of squares after it.
    pub fn after_jump(
        &self,
        jump: &impl Fn(f64) -> M::State,
        advance: &impl Fn(M::State, usize) -> M::State,
    ) -> M::State {
        after_jump((self.points, CHANGE), jump, advance, &self.misfit())
    }

    /// Friction in a state less what was measured.
    fn misfit(&self) -> impl Fn(&M::State, usize) -> f64 {
        |state, point| self.law.friction(*state, self.velocities[point]) - self.measured(point)
    }
}

/// The state at the first of some points after a jump of the velocity, as it follows from the share of the interval at
/// which the jump lies, with the least sum of squares of the misfit. Effects are those of a change of this share.
pub(super) fn after_jump<S: Clone>(
    (points, change): ([usize; 2], f64),
    jump: &impl Fn(f64) -> S,
    advance: &impl Fn(S, usize) -> S,
    misfit: &impl Fn(&S, usize) -> f64,
) -> S {
    let search = Sought {
        first: MIDWAY,
        parts: 1,
        rounds: MOST_OF_JUMPS,
        points,
        change,
    };
    let shifted = |share: f64, _, change: f64| (share + change).clamp(0.0, 1.0);
    search.state(jump, shifted, advance, misfit)
}

/// An unknown of some parts that is sought at the first of some points, by rounds of Gauss–Newton steps of each part.
struct Sought<X> {
    first: X,
    parts: usize,
    rounds: usize,
    points: [usize; 2],
    /// Change of a part for its effect.
    change: f64,
}

impl<X: Copy + PartialEq> Sought<X> {
    /// The state that the unknown brings about at the value with the least sum of squares of the misfit.
    fn state<S: Clone>(
        &self,
        state: impl Fn(X) -> S,
        shifted: impl Fn(X, usize, f64) -> X,
        advance: &impl Fn(S, usize) -> S,
        misfit: &impl Fn(&S, usize) -> f64,
    ) -> S {
        let mut x = self.first;
        for _ in 0..self.rounds {
            let (before, mut longest) = (x, 0.0_f64);
            for part in 0..self.parts {
                // A part at its limit is moved inwards.
                let mut change = self.change;
                let mut beside = shifted(x, part, change);
                if beside == x {
                    change = -change;
                    beside = shifted(x, part, change);
                }
                let step = self.step([state(x), state(beside)], change, advance, misfit);
                x = shifted(x, part, step);
                longest = longest.max(step.abs());
            }
            if x == before || longest < CLOSE {
                break;
            }
        }
        state(x)
    }

    /// The step of the unknown, from the state that it brings about and that after a change.
    fn step<S: Clone>(
        &self,
        [mut here, mut there]: [S; 2],
        change: f64,
        advance: &impl Fn(S, usize) -> S,
        misfit: &impl Fn(&S, usize) -> f64,
    ) -> f64 {
        let [begin, end] = self.points;
        let (mut square, mut along, mut strongest) = (0.0, 0.0, 0.0_f64);
        for point in begin..end.min(begin + MOST_POINTS) {
            if point > begin {
                here = advance(here, point);
                there = advance(there, point);
            }
            let left = misfit(&here, point);
            let effect = (misfit(&there, point) - left) / change;
            strongest = strongest.max(effect.abs());
            if effect.abs() <= FORGOTTEN * strongest {
                break;
            }
            square += effect * effect;
            along += effect * left;
        }
        let step = -along / square;
        if step.is_finite() { step } else { 0.0 }
    }
}
