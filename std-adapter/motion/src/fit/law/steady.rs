//! Friction that has no memory: a curve over the speed.

use super::super::Measurements;
use super::super::parameter::{FitParameter, Model};
use super::form::Form;
use super::guess::Guess;
use std::borrow::Cow;
use std::marker::PhantomData;

/// A law of the speed.
pub(super) trait Curve: Sized + Send + Sync + 'static {
    /// Parameters and starts.
    const FORM: Form;

    /// The law with these values; `None` where it refuses them.
    fn new(values: &[f64]) -> Option<Self>;

    /// Friction at a speed ≥ 0 under a load.
    fn friction(&self, speed: f64, load: f64) -> f64;
}

/// A curve at all points; loads are 1 where there are none.
pub(super) struct Steady<'a, C> {
    velocities: Cow<'a, [f64]>,
    load: Option<Cow<'a, [f64]>>,
    guess: Guess,
    curve: PhantomData<C>,
}

impl<'a, C: Curve> Steady<'a, C> {
    pub fn new(data: &'a Measurements) -> Self {
        Self {
            velocities: Cow::Borrowed(data.velocities()),
            load: data.load().map(Cow::Borrowed),
            guess: Guess::of(data),
            curve: PhantomData,
        }
    }
}

impl<C: Curve> Model for Steady<'_, C> {
    fn parameters(&self) -> &[FitParameter] {
        C::FORM.parameters
    }

    fn reference(&self, parameter: usize) -> Option<f64> {
        C::FORM.reference(parameter, &self.guess)
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let law = C::new(values)?;
        let along = |(i, v): (usize, &f64)| {
            let load = self.load.as_ref().map_or(1.0, |load| load[i]);
            law.friction(v.abs(), load).copysign(*v)
        };
        Some(self.velocities.iter().enumerate().map(along).collect())
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        (C::FORM.start)(&self.guess, unit)
    }

    fn is_linear(&self, parameter: usize) -> bool {
        C::FORM.is_linear(parameter)
    }

    fn above(&self, parameter: usize) -> Option<usize> {
        C::FORM.above(parameter)
    }

    fn limits(&self, parameter: usize) -> [f64; 2] {
        C::FORM.limits(parameter, &self.guess)
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model + '_>> {
        let of = |values: &[f64]| Cow::Owned(points.iter().map(|&i| values[i]).collect());
        Some(Box::new(Steady::<C> {
            velocities: of(&self.velocities),
            load: self.load.as_deref().map(of),
            guess: self.guess.clone(),
            curve: PhantomData,
        }))
    }
}
