//! The machine that a sample was measured on, as parameters beside those of the law.

use super::data::Measurements;
use super::error::FitError;
use super::parameter::{Between, FitParameter, Model, Range};
use super::slopes::Accelerated;
use std::borrow::Cow;

/// What the machine adds to friction.
///
/// ```
/// use tribos::fit::{Apparatus, FitLaw, FitOptions, Measurements};
/// // A joint driven to and fro: f = mu sgn v + k v + inertia a + offset, without noise.
/// let times: Vec<f64> = (0..200).map(|k| 0.01 * f64::from(k) + 0.005).collect();
/// let v: Vec<f64> = times.iter().map(|t| (7.0 * t).sin()).collect();
/// let a: Vec<f64> = times.iter().map(|t| 7.0 * (7.0 * t).cos()).collect();
/// let f = v.iter().zip(&a).map(|(v, a)| v.signum() + 0.5 * v + 0.2 * a + 0.1).collect();
/// let data = Measurements::series(times, v, f, None)?.with_acceleration(a)?;
/// let joint = Apparatus { inertia: true, offset: true, ..Apparatus::default() };
/// let found = data.fit(FitLaw::Viscous.model_on(&data, joint)?.as_ref(), &FitOptions::default())?;
/// for (name, truth) in [("mu", 1.0), ("k", 0.5), ("inertia", 0.2), ("offset", 0.1)] {
///     assert!(found.value(name).is_some_and(|value| (value - truth).abs() < 1e-9));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Apparatus {
    /// A mass or moment of inertia that is accelerated with the surface; needs accelerations.
    pub inertia: bool,
    /// A constant force, such as a sensor's zero or friction that differs between the directions.
    pub offset: bool,
    /// A spring between the load point, whose motion was recorded, and the contact; under rate and state.
    pub spring: bool,
}

const INERTIA: FitParameter = FitParameter {
    name: "inertia",
    unit: "kg",
    meaning: "inertia that is accelerated: force over acceleration",
    range: Range::Any,
};
const OFFSET: FitParameter = FitParameter {
    name: "offset",
    unit: "N",
    meaning: "constant force beside friction",
    range: Range::Any,
};

/// A law on an apparatus, under the loads of the data.
pub(super) struct Mounted<'a> {
    law: Box<dyn Model + 'a>,
    parameters: Vec<FitParameter>,
    load: Option<Cow<'a, [f64]>>,
    acceleration: Option<Cow<'a, [f64]>>,
    has_offset: bool,
    /// Number of points.
    count: usize,
}

impl<'a> Mounted<'a> {
    /// The law itself where the apparatus adds nothing.
    pub fn of(
        law: Box<dyn Model + 'a>,
        data: &'a Measurements,
        apparatus: Apparatus,
    ) -> Result<Box<dyn Model + 'a>, FitError> {
        const ACCELERATION: &str =
            "an inertia needs accelerations: a record over time, or a column a";
        let acceleration = match (apparatus.inertia, &data.acceleration) {
            (false, _) => None,
            (true, Some(given)) => Some(Cow::Borrowed(given.as_slice())),
            (true, None) => {
                let record = Accelerated::of(data, data.friction());
                let record = record.ok_or(FitError::Form(ACCELERATION))?;
                Some(Cow::Owned(record.slopes(|_| true).0))
            }
        };
        if data.load.is_none() && acceleration.is_none() && !apparatus.offset {
            return Ok(law);
        }
        let mut parameters = law.parameters().to_vec();
        parameters.extend(acceleration.is_some().then_some(INERTIA));
        parameters.extend(apparatus.offset.then_some(OFFSET));
        Ok(Box::new(Mounted {
            law,
            parameters,
            load: data.load().map(Cow::Borrowed),
            acceleration,
            has_offset: apparatus.offset,
            count: data.friction().len(),
        }))
    }

    /// Number of the law's own parameters.
    fn own(&self) -> usize {
        self.law.parameters().len()
    }

    /// The force that the machine adds at each point, if it adds any.
    fn machine(&self, values: &[f64]) -> Option<Option<Vec<f64>>> {
        let inertial = match &self.acceleration {
            None => None,
            Some(acceleration) => {
                let inertia = values.first()?;
                Some(acceleration.iter().map(|a| inertia * a).collect())
            }
        };
        if !self.has_offset {
            return Some(inertial);
        }
        let offset = values.last()?;
        let count = self.count;
        let mut force: Vec<f64> = inertial.unwrap_or_else(|| vec![0.0; count]);
        for f in &mut force {
            *f += offset;
        }
        Some(Some(force))
    }

    fn around<'b>(&'b self, law: Box<dyn Model + 'b>) -> Mounted<'b> {
        Mounted {
            law,
            parameters: self.parameters.clone(),
            load: self.load.as_deref().map(Cow::Borrowed),
            acceleration: self.acceleration.as_deref().map(Cow::Borrowed),
            has_offset: self.has_offset,
            count: self.count,
        }
    }
}

impl Model for Mounted<'_> {
    fn parameters(&self) -> &[FitParameter] {
        &self.parameters
    }

    fn reference(&self, parameter: usize) -> Option<f64> {
        let is_own = parameter < self.own();
        is_own.then(|| self.law.reference(parameter)).flatten()
    }

    fn predict(&self, values: &[f64]) -> Option<Vec<f64>> {
        let (own, more) = values.split_at_checked(self.own())?;
        let machine = self.machine(more)?;
        let load = self.load.as_deref();
        let mut force = match (&machine, load) {
            (Some(machine), Some(load)) => {
                let beside = machine.iter().zip(load).map(|(f, load)| f / load);
                self.law
                    .predict_beside(own, &beside.collect::<Vec<f64>>())?
            }
            (Some(machine), None) => self.law.predict_beside(own, machine)?,
            (None, _) => self.law.predict(own)?,
        };
        if let Some(load) = load {
            for (f, load) in force.iter_mut().zip(load) {
                *f *= load;
            }
        }
        if let Some(machine) = &machine {
            for (f, machine) in force.iter_mut().zip(machine) {
                *f += machine;
            }
        }
        Some(force)
    }

    fn start(&self, unit: &[f64]) -> Vec<f64> {
        let mut start = self.law.start(unit.get(..self.own()).unwrap_or(unit));
        start.resize(self.parameters.len(), 0.0);
        start
    }

    fn is_linear(&self, parameter: usize) -> bool {
        parameter >= self.own() || self.law.is_linear(parameter)
    }

    fn put_in_order(&self, values: &mut [f64]) {
        if let Some(own) = values.get_mut(..self.own()) {
            self.law.put_in_order(own);
        }
    }

    fn above(&self, parameter: usize) -> Option<usize> {
        let is_own = parameter < self.own();
        is_own.then(|| self.law.above(parameter)).flatten()
    }

    fn limits(&self, parameter: usize) -> [f64; 2] {
        if parameter < self.own() {
            self.law.limits(parameter)
        } else {
            [f64::NEG_INFINITY, f64::INFINITY]
        }
    }

    fn subsample(&self, points: &[usize]) -> Option<Box<dyn Model + '_>> {
        let law = self.law.subsample(points)?;
        let of = |values: &[f64]| Cow::Owned(points.iter().map(|&i| values[i]).collect());
        Some(Box::new(Mounted {
            load: self.load.as_deref().map(of),
            acceleration: self.acceleration.as_deref().map(of),
            count: points.len(),
            ..self.around(law)
        }))
    }

    fn sample(&self, count: usize) -> Option<Vec<usize>> {
        self.law.sample(count)
    }

    fn along(&self, path: Between) -> Option<Box<dyn Model + '_>> {
        Some(Box::new(self.around(self.law.along(path)?)))
    }
}
