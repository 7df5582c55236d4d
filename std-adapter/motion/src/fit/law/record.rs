//! Friction that has a memory: a record over time.

use super::super::Measurements;
use super::super::abrupt::beginnings;
use super::super::parameter::{Between, FitParameter, Model};
use super::beginning::Stretch;
use super::course::Motion;
use super::form::Form;
use super::guess::Guess;
use std::borrow::Cow;
use std::marker::PhantomData;

/// A law with a state.
pub(super) trait Memory: Sized + Send + Sync + 'static {
    /// Parameters and starts.
    const FORM: Form;
    /// Whether the state is soon forgotten: then pieces of a record serve as a sample of it.
    const FORGETS: bool;
    /// Whether friction is linear in its first state.
    const IS_LINEAR: bool = false;
    /// Whether a record begins in the state of [`Memory::first`], rather than in one that is sought.
    const BEGINS_STEADY: bool = false;
    /// Number of parts of the state that are sought on their own.
    const PARTS: usize = 1;
    /// What the law remembers.
    type State: Copy + PartialEq;

    /// The law with these values; `None` where it refuses them.
    fn new(values: &[f64]) -> Option<Self>;

    /// Puts the values of parts that are alike in their order.
    fn put_in_order(_values: &mut [f64]) {}

    /// The state at a point with this velocity and measured friction, roughly.
    fn first(&self, velocity: f64, friction: f64) -> Self::State;

    /// The state with a part changed by a share of its largest value, as far as the law admits.
    fn shifted(&self, state: Self::State, part: usize, share: f64) -> Self::State;

    /// The state after the time `dt` at a constant velocity.
    fn advance(&self, state: Self::State, velocity: f64, dt: f64) -> Self::State;

    /// Friction.
    fn friction(&self, state: Self::State, velocity: f64) -> f64;
}

/// A record, or a sample of one.
pub(super) struct Record<'a, M> {
    motion: Motion<'a>,
    /// Friction as it was measured, per load.
    measured: Cow<'a, [f64]>,
    /// Points where the state begins anew, the first among them.
    beginnings: Vec<usize>,
    guess: Guess,
    law: PhantomData<M>,
}

impl<'a, M: Memory> Record<'a, M> {
    /// A whole record.
    pub fn new(data: &'a Measurements, times: &'a [f64]) -> Self {
        Self {
            motion: Motion::new(times, data.velocities()),
            measured: data.all_per_load(),
            beginnings: beginnings(times),
            guess: Guess::of(data),
            law: PhantomData,
        }
    }

    /// The state at a point from that at the point before.
    fn advance(&self, law: &M, mut state: M::State, point: usize) -> M::State {
        self.motion.steps(point, |dt, mean| {
            state = law.advance(state, mean, dt);
        });
        state
    }

    /// The same where the velocity jumps after a share of the time.
    fn jump(&self, law: &M, mut state: M::State, (point, share): (usize, f64)) -> M::State {
        self.motion.jump(point, share, |dt, velocity| {
            state = law.advance(state, velocity, dt);
        });
        state
    }
}

impl<M: Memory> Model for Record<'_, M> {
    fn parameters(&self) -> &[FitParameter] {
        M::FORM.parameters
    }

    fn reference(&self, parameter: usize) -> Option<f64> {
        M::FORM.reference(parameter, &self.guess)
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        self.predict_beside(values, &[])
    }

    fn predict_beside(&self, values: &[f64], beside: &[f64]) -> Option<Vec<f64>> {
        let law = M::new(values)?;
        let velocities = &self.motion.velocities;
        let count = velocities.len();
        let advance = |state: M::State, point: usize| self.advance(&law, state, point);
        let mut friction = Vec::with_capacity(count);
        let ends = self.beginnings.iter().skip(1).copied().chain([count]);
        for (&begin, end) in self.beginnings.iter().zip(ends) {
            let stretch = |begin| Stretch {
                law: &law,
                velocities,
                measured: &self.measured,
                beside,
                points: [begin, self.motion.next_jump(begin, end)],
            };
            let mut state = if begin == 0 && M::BEGINS_STEADY {
                law.first(velocities[0], self.measured[0])
            } else {
                stretch(begin).state(&advance)
            };
            for point in begin..end {
                if point > begin {
                    state = if self.motion.jumps_before(point) {
                        let jump = |share| self.jump(&law, state, (point, share));
                        stretch(point).after_jump(&jump, &advance)
                    } else {
                        advance(state, point)
                    };
                }
                friction.push(law.friction(state, velocities[point]));
            }
        }
        Some(friction)
    }

    fn foretell(&self, values: &[f64]) -> Option<Vec<f64>> {
        /// Friction that no state carries.
        const LARGE: f64 = 1e100;
        let law = M::new(values)?;
        let velocities = &self.motion.velocities;
        let first = *velocities.first()?;
        let carried = if first == 0.0 {
            0.0
        } else {
            LARGE.copysign(first)
        };
        let mut state = law.first(first, carried);
        let at = |(point, velocity): (usize, &f64)| {
            if point > 0 {
                state = self.advance(&law, state, point);
            }
            law.friction(state, *velocity)
        };
        Some(velocities.iter().enumerate().map(at).collect())
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        (M::FORM.start)(&self.guess, unit)
    }

    fn is_linear(&self, parameter: usize) -> bool {
        M::FORM.is_linear(parameter)
    }

    fn put_in_order(&self, values: &mut [f64]) {
        M::put_in_order(values);
    }

    fn above(&self, parameter: usize) -> Option<usize> {
        M::FORM.above(parameter)
    }

    fn limits(&self, parameter: usize) -> [f64; 2] {
        M::FORM.limits(parameter, &self.guess)
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model + '_>> {
        let motion = self.motion.at(points, !M::FORGETS);
        Some(Box::new(Record::<M> {
            measured: points.iter().map(|&i| self.measured[i]).collect(),
            beginnings: if M::FORGETS {
                beginnings(&motion.times)
            } else {
                vec![0]
            },
            motion,
            guess: self.guess.clone(),
            law: PhantomData,
        }))
    }

    fn sample(&self, count: usize) -> Option<Vec<usize>> {
        M::FORGETS.then(|| super::course::pieces(&self.motion.velocities, count))
    }

    fn along(&self, path: Between) -> Option<Box<dyn Model + '_>> {
        Some(Box::new(Record::<M> {
            motion: self.motion.along(path),
            measured: Cow::Borrowed(&self.measured),
            beginnings: self.beginnings.clone(),
            guess: self.guess.clone(),
            law: PhantomData,
        }))
    }
}
