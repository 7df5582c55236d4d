//! Bodies that slide and spin to rest on a round patch.

use crate::arrays::{Batched, Numbers, Output, View, broadcast, refused};
use crate::law::Law;
use crate::patch::Patch;
use crate::threads::fill;
use pyo3::prelude::*;
use tribos::friction::{self, Area, RoundPower, Tier};
use tribos_core::slider::{self, SliderParameters, SliderState};

/// Launches of a batch, and the bodies that are launched.
#[derive(Clone, Copy)]
struct Launches<'a> {
    /// In m/s, of either sign.
    speed: View<'a, 1>,
    /// In rad/s, of either sign.
    spin: View<'a, 1>,
    /// I/(M R²).
    inertia_ratio: View<'a, 1>,
    /// In m/s².
    gravity: View<'a, 1>,
}

/// Sliders of one friction, compiled for each type of the kernel.
trait Slides: Send + Sync {
    /// Time, distance, angle and last ratio of the launches from `from` on.
    fn rests(&self, launches: Launches<'_>, from: usize, out: &mut [[f64; 4]]) -> PyResult<()>;
    /// Speed, spin, distance and angle of the launches from `from` on, at `times`.
    fn motions(
        &self,
        launches: Launches<'_>,
        times: View<'_, 1>,
        from: usize,
        out: &mut [[f64; 4]],
    ) -> PyResult<()>;
}

/// Friction that is a power of the speed on a round patch.
struct Powered<P> {
    profile: P,
    /// γ, in (s/m)^α.
    coefficient: f64,
    /// In m.
    radius: f64,
}

impl<P: RoundPower<f64>> Powered<P> {
    fn slider(&self, launches: &Launches<'_>, at: usize) -> PyResult<slider::Slider<f64, &P>> {
        let parameters = SliderParameters {
            deceleration: self.coefficient * launches.gravity.at(at)[0],
            radius: self.radius,
            inertia_ratio: launches.inertia_ratio.at(at)[0],
        };
        slider::Slider::new(&self.profile, parameters).map_err(refused)
    }
}

impl<P: RoundPower<f64>> Slides for Powered<P> {
    fn rests(&self, launches: Launches<'_>, from: usize, out: &mut [[f64; 4]]) -> PyResult<()> {
        for (index, row) in (from..).zip(out) {
            let [speed] = launches.speed.at(index);
            let motion = SliderState::launched(speed.abs(), launches.spin.at(index)[0]);
            let rest = self.slider(&launches, index)?.to_rest(&motion);
            *row = rest.map_or([f64::NAN; 4], |rest| {
                let slider::SliderRest { motion, ratio, .. } = rest;
                let distance = motion.distance.copysign(speed);
                [motion.time, distance, motion.angle, ratio]
            });
        }
        Ok(())
    }

    fn motions(
        &self,
        launches: Launches<'_>,
        times: View<'_, 1>,
        from: usize,
        out: &mut [[f64; 4]],
    ) -> PyResult<()> {
        for (index, row) in (from..).zip(out) {
            let [speed] = launches.speed.at(index);
            let [spin] = launches.spin.at(index);
            let slider = self.slider(&launches, index)?;
            let [time] = times.at(index);
            if !(speed.is_finite() && spin.is_finite() && time.is_finite()) {
                *row = [f64::NAN; 4];
                continue;
            }
            let start = SliderState::launched(speed.abs(), spin);
            let motion = slider.advance(&start, time).motion;
            let [now, distance] = [motion.speed, motion.distance].map(|x| x.copysign(speed));
            *row = [now, motion.spin, distance, motion.angle];
        }
        Ok(())
    }
}

/// Puts the kernel's type behind a pointer.
struct BoxingVisitor {
    coefficient: f64,
    radius: f64,
}

impl friction::Visitor<f64> for BoxingVisitor {
    type Output = Box<dyn Slides>;
    fn visit<P: RoundPower<f64> + 'static>(self, profile: P) -> Self::Output {
        Box::new(Powered {
            profile,
            coefficient: self.coefficient,
            radius: self.radius,
        })
    }
}

/// γ and α of a law under which a body's whole motion is known.
pub fn power_of(law: &friction::Law) -> PyResult<[f64; 2]> {
    law.power_of_speed().ok_or_else(|| {
        refused(format!(
            "{} is not a power of the speed: this needs Coulomb's law or mu * speed**alpha; scenes \
             of disks follow other laws",
            law.name()
        ))
    })
}

/// A round patch and its radius.
pub fn round(area: &Area) -> PyResult<(&friction::Patch, f64)> {
    match area {
        Area::Round(patch, radius) => Ok((patch, *radius)),
        _ => Err(refused(
            "only a round patch slides straight: give a disk, ring, annulus or the like; the rollout \
             of a tribos.PlanarBody follows the others",
        )),
    }
}

/// Bodies on one friction, followed to rest or over a time.
#[pyclass(frozen, module = "tribos._native")]
pub struct Slider {
    slides: Box<dyn Slides>,
    alpha: f64,
}

/// Nanoseconds that a motion takes, about.
const COST: usize = 10_000;

#[pymethods]
impl Slider {
    #[new]
    #[pyo3(signature = (patch, law, tier=None))]
    fn new(patch: &Patch, law: &Law, tier: Option<&str>) -> PyResult<Self> {
        let (patch, radius) = round(&patch.0)?;
        let [coefficient, alpha] = power_of(&law.0)?;
        let tier: Option<Tier> = tier.map(|name| name.parse().map_err(refused)).transpose()?;
        let tier = Tier::choose::<f64>(patch, &law.0, tier).map_err(refused)?;
        let boxed = BoxingVisitor {
            coefficient,
            radius,
        };
        let slides = friction::visit(patch, alpha, tier, boxed).map_err(refused)?;
        Ok(Self { slides, alpha })
    }

    /// Times in s, distances in m, angles in rad and last velocity ratios, in the last axis.
    fn to_rest<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        spin: &Bound<'py, PyAny>,
        inertia_ratio: &Bound<'py, PyAny>,
        gravity: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if self.alpha >= 1.0 {
            let alpha = self.alpha;
            return Err(refused(format!(
                "a body under |v|^{alpha} never comes to rest, because friction fades with the \
                 speed: this needs alpha < 1; tribos.slide_path follows it over a given time"
            )));
        }
        let given = [
            Numbers::new("speed", speed)?,
            Numbers::new("spin", spin)?,
            Numbers::new("inertia_ratio", inertia_ratio)?,
            Numbers::new("gravity", gravity)?,
        ];
        let batch = broadcast(&given.each_ref().map(|one| one as &dyn Batched))?;
        let [speed, spin, inertia_ratio, gravity] = given.map(|one| one.over(&batch));
        let (speed, spin, inertia_ratio, gravity) = (speed?, spin?, inertia_ratio?, gravity?);
        let launches = Launches {
            speed: speed.view()?,
            spin: spin.view()?,
            inertia_ratio: inertia_ratio.view()?,
            gravity: gravity.view()?,
        };
        let mut output = Output::new(py, &batch, &[4], None)?;
        fill(py, output.rows::<4>()?, COST, |from, piece| {
            self.slides.rests(launches, from, piece)
        })?;
        output.finish()
    }

    /// Speeds in m/s, spins in rad/s, distances in m and angles in rad at times in s, in the last axis.
    fn advance<'py>(
        &self,
        py: Python<'py>,
        speed: &Bound<'py, PyAny>,
        spin: &Bound<'py, PyAny>,
        times: &Bound<'py, PyAny>,
        inertia_ratio: &Bound<'py, PyAny>,
        gravity: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = [
            Numbers::new("speed", speed)?,
            Numbers::new("spin", spin)?,
            Numbers::new("times", times)?,
            Numbers::new("inertia_ratio", inertia_ratio)?,
            Numbers::new("gravity", gravity)?,
        ];
        let batch = broadcast(&given.each_ref().map(|one| one as &dyn Batched))?;
        let [speed, spin, times, inertia_ratio, gravity] = given.map(|one| one.over(&batch));
        let (speed, spin, times) = (speed?, spin?, times?);
        let (inertia_ratio, gravity) = (inertia_ratio?, gravity?);
        let launches = Launches {
            speed: speed.view()?,
            spin: spin.view()?,
            inertia_ratio: inertia_ratio.view()?,
            gravity: gravity.view()?,
        };
        let times = times.view()?;
        let mut output = Output::new(py, &batch, &[4], None)?;
        fill(py, output.rows::<4>()?, COST, |from, piece| {
            self.slides.motions(launches, times, from, piece)
        })?;
        output.finish()
    }
}
