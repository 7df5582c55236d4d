//! Derivatives of the way to rest.

use super::part;
use crate::arrays::{Numbers, View, broadcast, refused};
use crate::law::Law;
use crate::patch::Patch;
use crate::slide::{power_of, round};
use crate::threads::fill;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use tribos::friction::{RoundPower, upright};
use tribos::slide::inverse::{self, Launch};

/// Nanoseconds that a way to rest takes, about.
const COST: usize = 200_000;
/// Columns of the derivatives: speed, spin, gravity, radius.
const BY: usize = 4;
/// Time, distance and angle, and their derivatives.
const ALL: usize = 3 + 3 * BY;

/// How bodies on a round patch come to rest under a power of the speed.
#[pyclass(frozen, module = "tribos._native")]
pub struct RestMap {
    friction: Box<dyn RoundPower<f64>>,
    coefficient: f64,
}

/// A throw, in SI units.
struct Throw {
    speed: f64,
    spin: f64,
    gravity: f64,
    deceleration: f64,
    radius: f64,
    inertia_ratio: f64,
}

/// The arguments of a batch.
struct Throws<'a>([View<'a, 1>; 5]);

impl Throws<'_> {
    fn at(&self, index: usize, coefficient: f64) -> PyResult<Throw> {
        let [[speed], [spin], [gravity], [radius], [inertia_ratio]] =
            self.0.map(|view| view.at(index));
        let deceleration = coefficient * gravity;
        for (name, value) in [("mu * gravity", deceleration), ("radius", radius)] {
            if !(value > 0.0 && value.is_finite()) {
                let text = format!("{name} must be > 0 and finite, not {value}");
                return Err(refused(text));
            }
        }
        Ok(Throw {
            speed,
            spin,
            gravity,
            deceleration,
            radius,
            inertia_ratio,
        })
    }
}

impl RestMap {
    /// The same throw where deceleration and radius are 1: the speed of the rim is the spin.
    fn unit(&self, throw: &Throw) -> PyResult<(inverse::RestMap<&dyn RoundPower<f64>>, Launch)> {
        let map = inverse::RestMap::new(&*self.friction, 1.0, 1.0, throw.inertia_ratio);
        let launch = Launch {
            velocity: [throw.speed, 0.0],
            spin: throw.spin * throw.radius,
        };
        Ok((map.map_err(refused)?, launch))
    }

    fn rested(&self, throw: &Throw) -> PyResult<[f64; 3]> {
        let (map, launch) = self.unit(throw)?;
        let landing = map.rest(&launch);
        let all = [
            landing.time,
            landing.pose.x,
            landing.pose.angle / throw.radius,
        ];
        Ok(all.map(|x| x / throw.deceleration))
    }

    fn rested_by(&self, throw: &Throw) -> PyResult<[f64; ALL]> {
        let (map, launch) = self.unit(throw)?;
        let (landing, pose, time) = map.landing_derivatives(&launch);
        let Throw {
            gravity,
            deceleration,
            radius,
            ..
        } = *throw;
        let mut all = [0.0; ALL];
        let rows = [
            (landing.time, [time[0], time[2]]),
            (landing.pose.x, [pose[0][0], pose[0][2]]),
            (landing.pose.angle, [pose[2][0], pose[2][2]]),
        ];
        for (row, (path, [by_speed, by_rim])) in rows.into_iter().enumerate() {
            // The angle is the rim's path over the radius.
            let is_angle = row == 2;
            let unit = deceleration * if is_angle { radius } else { 1.0 };
            let value = path / unit;
            all[row] = value;
            let own = if is_angle { value / radius } else { 0.0 };
            all[3 + BY * row..3 + BY * (row + 1)].copy_from_slice(&[
                by_speed / unit,
                by_rim * radius / unit,
                -value / gravity,
                by_rim * throw.spin / unit - own,
            ]);
        }
        Ok(all)
    }

    /// What `of` makes of every throw.
    fn each<'py, const M: usize>(
        &self,
        [speed, spin, gravity, radius, inertia_ratio]: [&Bound<'py, PyAny>; 5],
        of: impl Fn(&Throw) -> PyResult<[f64; M]> + Sync,
    ) -> PyResult<(Vec<usize>, Vec<[f64; M]>)> {
        let py = speed.py();
        let given = [
            Numbers::new("speed", speed)?,
            Numbers::new("spin", spin)?,
            Numbers::new("gravity", gravity)?,
            Numbers::new("radius", radius)?,
            Numbers::new("inertia ratio", inertia_ratio)?,
        ];
        let [a, b, c, d, e] = &given;
        let batch = broadcast(&[a, b, c, d, e])?;
        let [a, b, c, d, e] = given.map(|numbers| numbers.over(&batch));
        let [a, b, c, d, e] = [a?, b?, c?, d?, e?];
        let throws = Throws([a.view()?, b.view()?, c.view()?, d.view()?, e.view()?]);
        let mut rows = vec![[0.0; M]; batch.iter().product()];
        fill(py, &mut rows, COST, |from, piece| {
            for (index, row) in (from..).zip(piece.iter_mut()) {
                *row = of(&throws.at(index, self.coefficient)?)?;
            }
            Ok(())
        })?;
        Ok((batch, rows))
    }
}

#[pymethods]
impl RestMap {
    #[new]
    fn new(patch: &Patch, law: &Law) -> PyResult<Self> {
        let (patch, _) = round(&patch.0)?;
        let [coefficient, alpha] = power_of(&law.0)?;
        let friction = upright(patch, alpha).map_err(refused)?;
        inverse::RestMap::new(&*friction, 1.0, 1.0, 0.5).map_err(refused)?;
        Ok(Self {
            friction,
            coefficient,
        })
    }

    /// Times, distances and angles to rest, as rows.
    fn rest<'py>(
        &self,
        speed: &Bound<'py, PyAny>,
        spin: &Bound<'py, PyAny>,
        gravity: &Bound<'py, PyAny>,
        radius: &Bound<'py, PyAny>,
        inertia_ratio: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = [speed, spin, gravity, radius, inertia_ratio];
        let (batch, rows) = self.each(given, |throw| self.rested(throw))?;
        part::<3, 3>(speed.py(), &batch, &[3], &rows, 0)
    }

    /// The same, and their derivatives by speed, spin, gravity and radius.
    fn rest_and_jacobian<'py>(
        &self,
        speed: &Bound<'py, PyAny>,
        spin: &Bound<'py, PyAny>,
        gravity: &Bound<'py, PyAny>,
        radius: &Bound<'py, PyAny>,
        inertia_ratio: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyTuple>> {
        let py = speed.py();
        let given = [speed, spin, gravity, radius, inertia_ratio];
        let (batch, rows) = self.each(given, |throw| self.rested_by(throw))?;
        let parts = [
            part::<ALL, 3>(py, &batch, &[3], &rows, 0)?,
            part::<ALL, { 3 * BY }>(py, &batch, &[3, BY], &rows, 3)?,
        ];
        PyTuple::new(py, parts)
    }
}
