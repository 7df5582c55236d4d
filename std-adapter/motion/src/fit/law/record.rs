//! Friction that has a memory: a record over time.

use super::super::Measurements;
use super::super::parameter::{Between, FitParameter, Model};
use super::course::{Interval, merged, velocity_steps};
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
    /// What the law remembers.
    type State: Copy;

    /// The law with these values; `None` where it refuses them.
    fn new(values: &[f64]) -> Option<Self>;

    /// The state at a point with this velocity and measured friction, from which a record begins.
    fn first(&self, velocity: f64, friction: f64) -> Self::State;

    /// The state after the time `dt` at a constant velocity.
    fn advance(&self, state: Self::State, velocity: f64, dt: f64) -> Self::State;

    /// Friction.
    fn friction(&self, state: Self::State, velocity: f64) -> f64;
}

/// A record, or a sample of one.
pub(super) struct Record<'a, M> {
    times: Cow<'a, [f64]>,
    velocities: Cow<'a, [f64]>,
    /// Points where the state is made anew, the first among them, with the friction measured there.
    beginnings: Vec<(usize, f64)>,
    /// Means of a sample of points that are far apart.
    means: Option<Vec<Interval>>,
    path: Between,
    guess: Guess,
    law: PhantomData<M>,
}

impl<'a, M: Memory> Record<'a, M> {
    /// A whole record.
    pub fn new(data: &'a Measurements, times: &'a [f64]) -> Self {
        Self {
            times: Cow::Borrowed(times),
            velocities: Cow::Borrowed(data.velocities()),
            beginnings: vec![(0, data.per_load(0))],
            means: None,
            path: Between::PLAIN,
            guess: Guess::of(data),
            law: PhantomData,
        }
    }

    /// The state at a point from that at the point before.
    fn advance(&self, law: &M, mut state: M::State, point: usize) -> M::State {
        if let Some(means) = &self.means {
            let (dt, mean) = means[point - 1];
            return law.advance(state, mean, dt);
        }
        let velocities = &self.velocities;
        if self.path == Between::PLAIN && velocities[point - 1] * velocities[point] >= 0.0 {
            let mean = 0.5 * (velocities[point - 1] + velocities[point]);
            return law.advance(state, mean, self.times[point] - self.times[point - 1]);
        }
        velocity_steps(&self.times, velocities, point, self.path, |dt, mean| {
            state = law.advance(state, mean, dt);
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
        let law = M::new(values)?;
        let mut beginnings = self.beginnings.iter().peekable();
        let &(_, first) = *beginnings.peek()?;
        let mut state = law.first(*self.velocities.first()?, first);
        let mut friction = Vec::with_capacity(self.velocities.len());
        for (point, &velocity) in self.velocities.iter().enumerate() {
            match beginnings.next_if(|(begins, _)| *begins == point) {
                Some(&(_, measured)) => state = law.first(velocity, measured),
                None => state = self.advance(&law, state, point),
            }
            friction.push(law.friction(state, velocity));
        }
        Some(friction)
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        (M::FORM.start)(&self.guess, unit)
    }

    fn is_linear(&self, parameter: usize) -> bool {
        M::FORM.is_linear(parameter)
    }

    fn above(&self, parameter: usize) -> Option<usize> {
        M::FORM.above(parameter)
    }

    fn limits(&self, parameter: usize) -> [f64; 2] {
        M::FORM.limits(parameter, &self.guess)
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model + '_>> {
        let of = |values: &[f64]| points.iter().map(|&i| values[i]).collect::<Vec<f64>>();
        let mut sample = Record::<M> {
            times: Cow::Owned(of(&self.times)),
            velocities: Cow::Owned(of(&self.velocities)),
            beginnings: self.beginnings.clone(),
            means: None,
            path: self.path,
            guess: self.guess.clone(),
            law: PhantomData,
        };
        if !M::FORGETS {
            sample.means = Some(merged(&self.times, &self.velocities, points));
        }
        Some(Box::new(sample))
    }

    fn sample(&self, count: usize) -> Option<Vec<usize>> {
        M::FORGETS.then(|| super::course::pieces(&self.velocities, count))
    }

    fn along(&self, path: Between) -> Option<Box<dyn Model + '_>> {
        Some(Box::new(Record::<M> {
            times: Cow::Borrowed(&self.times),
            velocities: Cow::Borrowed(&self.velocities),
            beginnings: self.beginnings.clone(),
            means: self.means.clone(),
            path,
            guess: self.guess.clone(),
            law: PhantomData,
        }))
    }
}
