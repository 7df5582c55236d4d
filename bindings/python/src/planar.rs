//! Bodies that are pushed and turned on their patch: implicit time steps.

use crate::arrays::{Batched, Column, Numbers, Output, Rows, View, broadcast, refused};
use crate::model::{numbers, twist_numbers, twist_of, wrench_of};
use crate::patch::Patch;
use crate::surface::LimitSurface;
use crate::threads::fill;
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use tribos_core::contact::TimeStep;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Twist, friction and whether friction holds the body, after a step.
#[derive(Clone, Copy, Default)]
struct StepResult {
    twist: [f64; 3],
    friction: [f64; 3],
    is_at_rest: bool,
}

impl StepResult {
    fn of(step: &PlanarStep<f64>) -> Self {
        Self {
            twist: twist_numbers(&step.twist),
            friction: numbers(&step.friction),
            is_at_rest: step.is_at_rest,
        }
    }
}

/// What the bodies of a batch are, as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct BodyArguments<'py> {
    /// μN, in N.
    force_limit: Bound<'py, PyAny>,
    /// In kg.
    mass: Bound<'py, PyAny>,
    /// In kg m².
    inertia: Bound<'py, PyAny>,
    /// In s.
    dt: Bound<'py, PyAny>,
}

/// The same as numbers.
struct BodyNumbers<'py>([Numbers<'py>; 4]);

/// The same for each body of a batch.
struct Columns<'py>([Column<'py, 1>; 4]);

/// The same without Python.
#[derive(Clone, Copy)]
struct Bodies<'a>([View<'a, 1>; 4]);

/// A body with its time step.
#[derive(Clone, Copy)]
struct Stepper {
    body: PlanarBody<f64>,
    dt: TimeStep<f64>,
}

impl<'py> BodyArguments<'py> {
    fn numbered(&self) -> PyResult<BodyNumbers<'py>> {
        Ok(BodyNumbers([
            Numbers::new("load", &self.force_limit)?,
            Numbers::new("mass", &self.mass)?,
            Numbers::new("inertia", &self.inertia)?,
            Numbers::new("dt", &self.dt)?,
        ]))
    }
}

impl<'py> BodyNumbers<'py> {
    fn batched(&self) -> [&dyn Batched; 4] {
        self.0.each_ref().map(|one| one as &dyn Batched)
    }

    fn over(self, batch: &[usize]) -> PyResult<Columns<'py>> {
        let [limit, mass, inertia, dt] = self.0.map(|one| one.over(batch));
        Ok(Columns([limit?, mass?, inertia?, dt?]))
    }
}

impl Columns<'_> {
    fn view(&self) -> PyResult<Bodies<'_>> {
        let [limit, mass, inertia, dt] = self.0.each_ref().map(Column::view);
        Ok(Bodies([limit?, mass?, inertia?, dt?]))
    }
}

impl Bodies<'_> {
    /// The force limit of body `index`.
    fn limit(&self, index: usize) -> f64 {
        let [limit] = self.0[0].at(index);
        limit
    }

    /// The force limit of all bodies, if there is one.
    fn limit_of_all(&self) -> Option<f64> {
        match self.0[0] {
            View::One([limit]) => Some(limit),
            View::Each(_) => None,
        }
    }

    /// True if all bodies are alike.
    fn are_alike(&self) -> bool {
        self.0.iter().all(|one| matches!(one, View::One(_)))
    }

    fn stepper(&self, index: usize) -> PyResult<Stepper> {
        let [_, mass, inertia, dt] = self.0.map(|one| one.at(index)[0]);
        Ok(Stepper {
            body: PlanarBody::new(mass, inertia).map_err(refused)?,
            dt: TimeStep::new(dt).map_err(refused)?,
        })
    }
}

impl Stepper {
    /// A step of a body whose patch is turned by `angle`, in rad, if its turning matters.
    fn step(
        &self,
        set: &dyn FrictionSet<f64>,
        angle: Option<f64>,
        twist: [f64; 3],
        push: [f64; 3],
    ) -> StepResult {
        let Some(angle) = angle.filter(|angle| *angle != 0.0) else {
            return self.step_along_axes(set, twist, push);
        };
        let (sin, cos) = (Real::sin(angle), Real::cos(angle));
        let into = |[x, y, turn]: [f64; 3]| [cos * x + sin * y, cos * y - sin * x, turn];
        let back = |[x, y, turn]: [f64; 3]| [cos * x - sin * y, cos * y + sin * x, turn];
        let step = self.step_along_axes(set, into(twist), into(push));
        StepResult {
            twist: if step.is_at_rest {
                [0.0; 3]
            } else {
                back(step.twist)
            },
            friction: back(step.friction),
            ..step
        }
    }

    fn step_along_axes(
        &self,
        set: &dyn FrictionSet<f64>,
        twist: [f64; 3],
        push: [f64; 3],
    ) -> StepResult {
        let (twist, push) = (twist_of(twist), wrench_of(push));
        StepResult::of(&self.body.step(set, &twist, &push, self.dt))
    }
}

/// Bodies that are stepped together.
const CHUNK: usize = 256;

/// One step of bodies that are alike, on a set that their turning does not change; their motions and pushes come by
/// index, from `first` on.
fn step_alike(
    stepper: &Stepper,
    set: &dyn FrictionSet<f64>,
    first: usize,
    [twists, pushes]: [View<'_, 3>; 2],
    results: &mut [StepResult],
) {
    let blank = PlanarStep {
        twist: Twist::ZERO,
        friction: Wrench::ZERO,
        is_at_rest: false,
    };
    let mut given = ([Twist::ZERO; CHUNK], [Wrench::ZERO; CHUNK]);
    let mut steps = [blank; CHUNK];
    for (from, results) in (first..).step_by(CHUNK).zip(results.chunks_mut(CHUNK)) {
        let slots = given.0.iter_mut().zip(&mut given.1);
        for (index, (twist, push)) in (from..from + results.len()).zip(slots) {
            *twist = twist_of(twists.at(index));
            *push = wrench_of(pushes.at(index));
        }
        let (twists, pushes) = (&given.0[..results.len()], &given.1);
        stepper
            .body
            .step_batch(set, twists, pushes, stepper.dt, &mut steps);
        for (result, step) in results.iter_mut().zip(&steps) {
            *result = StepResult::of(step);
        }
    }
}

/// Nanoseconds that a step takes, about.
fn cost(patch: &Patch) -> usize {
    if patch.0.is_round() { 800 } else { 3_000 }
}

/// One step of each body: twists, friction, and whether it rests.
#[pyfunction]
#[pyo3(signature = (patch, surface, bodies, twists, pushes, angle, out=None))]
#[allow(clippy::too_many_arguments)] // Python's own names them.
pub fn planar_step<'py>(
    patch: &Bound<'py, Patch>,
    surface: &LimitSurface,
    bodies: &Bound<'py, PyAny>,
    twists: &Bound<'py, PyAny>,
    pushes: &Bound<'py, PyAny>,
    angle: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<[Bound<'py, PyAny>; 3]> {
    let (py, patch) = (patch.py(), patch.get());
    let given = bodies.extract::<BodyArguments<'py>>()?.numbered()?;
    let twists = Rows::<3>::new("twists", twists)?;
    let pushes = Rows::<3>::new("pushes", pushes)?;
    let angle = Numbers::new("angle", angle)?;
    let [limit, mass, inertia, dt] = given.batched();
    let batch = broadcast(&[&twists, &pushes, &angle, limit, mass, inertia, dt])?;
    let given = given.over(&batch)?;
    let (twists, pushes) = (twists.over(&batch)?, pushes.over(&batch)?);
    let angle = angle.over(&batch)?;
    let bodies = given.view()?;
    let (start, pushes, angle) = (twists.view()?, pushes.view()?, angle.view()?);
    let turns = !patch.0.is_round();

    let step = |set: &dyn FrictionSet<f64>, index: usize| {
        let stepper = bodies.stepper(index)?;
        let angle = turns.then(|| angle.at(index)[0]);
        Ok(stepper.step(set, angle, start.at(index), pushes.at(index)))
    };
    let mut steps = vec![StepResult::default(); batch.iter().product()];
    fill(py, &mut steps, cost(patch), |from, piece| {
        if let Some(limit) = bodies.limit_of_all() {
            return surface.sets.with(limit, |set| {
                if bodies.are_alike() && !turns {
                    let given = [start, pushes];
                    step_alike(&bodies.stepper(from)?, set, from, given, piece);
                    return Ok(());
                }
                let all = (from..).zip(piece.iter_mut());
                store_all(all, |index| step(set, index))
            })?;
        }
        for (index, row) in (from..).zip(piece) {
            *row = surface
                .sets
                .with(bodies.limit(index), |set| step(set, index))??;
        }
        Ok(())
    })?;

    let mut twists = Output::new(py, &batch, &[3], out)?;
    let mut friction = Output::new(py, &batch, &[3], None)?;
    let rests = PyArrayDyn::<bool>::zeros(py, batch, false);
    let rows = twists.rows::<3>()?.iter_mut().zip(friction.rows::<3>()?);
    let mut memory = rests.readwrite();
    let flags = memory.as_slice_mut().map_err(refused)?;
    for (((twist, friction), rest), step) in rows.zip(flags).zip(&steps) {
        (*twist, *friction, *rest) = (step.twist, step.friction, step.is_at_rest);
    }
    drop(memory);
    Ok([twists.finish()?, friction.finish()?, rests.into_any()])
}

/// Stores what `of` gives for each row.
fn store_all<'a>(
    all: impl Iterator<Item = (usize, &'a mut StepResult)>,
    of: impl Fn(usize) -> PyResult<StepResult>,
) -> PyResult<()> {
    for (index, row) in all {
        *row = of(index)?;
    }
    Ok(())
}

/// Rows of shape (…, steps, 3), whose leading axes end before the steps.
struct StepRows<'a, 'py>(&'a Rows<'py, 3>);

impl Batched for StepRows<'_, '_> {
    fn leading(&self) -> &[usize] {
        self.0.leading().split_last().map_or(&[], |(_, rest)| rest)
    }
    fn called(&self) -> &'static str {
        self.0.called()
    }
}

/// The course of one body: a row a step.
struct BodyTrajectory<'a> {
    twists: &'a mut [[f64; 3]],
    poses: &'a mut [[f64; 3]],
    rests: &'a mut [bool],
}

/// Many steps of each body: twists, poses, and whether it rests, after each step.
#[pyfunction]
pub fn planar_rollout<'py>(
    patch: &Bound<'py, Patch>,
    surface: &LimitSurface,
    bodies: &Bound<'py, PyAny>,
    twists: &Bound<'py, PyAny>,
    pushes: &Bound<'py, PyAny>,
    poses: &Bound<'py, PyAny>,
) -> PyResult<[Bound<'py, PyAny>; 3]> {
    let (py, patch) = (patch.py(), patch.get());
    let given = bodies.extract::<BodyArguments<'py>>()?.numbered()?;
    let twists = Rows::<3>::new("twists", twists)?;
    let poses = Rows::<3>::new("poses", poses)?;
    let pushes = Rows::<3>::new("pushes", pushes)?;
    let Some(&count) = pushes.leading().last() else {
        return Err(refused("pushes must have shape (..., steps, 3), not (3,)"));
    };
    let [limit, mass, inertia, dt] = given.batched();
    let before = StepRows(&pushes);
    let batch = broadcast(&[&twists, &before, &poses, limit, mass, inertia, dt])?;
    let steps = [batch.as_slice(), &[count]].concat();
    let given = given.over(&batch)?;
    let (twists, poses) = (twists.over(&batch)?, poses.over(&batch)?);
    let pushes = pushes.over(&steps)?;
    let bodies = given.view()?;
    let (start, origin, pushes) = (twists.view()?, poses.view()?, pushes.view()?);
    let turns = !patch.0.is_round();

    let mut twists = Output::new(py, &steps, &[3], None)?;
    let mut poses = Output::new(py, &steps, &[3], None)?;
    let rests = PyArrayDyn::<bool>::zeros(py, steps, false);
    let mut memory = rests.readwrite();
    let flags = memory.as_slice_mut().map_err(refused)?;
    let each = count.max(1);
    let rows = twists.rows::<3>()?.chunks_mut(each);
    let rows = rows.zip(poses.rows::<3>()?.chunks_mut(each));
    let rows = rows.zip(flags.chunks_mut(each));
    let course = |((twists, poses), rests)| BodyTrajectory {
        twists,
        poses,
        rests,
    };
    let mut courses: Vec<BodyTrajectory<'_>> = rows.map(course).collect();
    let whole = cost(patch).saturating_mul(each);
    fill(py, &mut courses, whole, |from, piece| {
        for (index, course) in (from..).zip(piece) {
            let stepper = bodies.stepper(index)?;
            let begin = [start.at(index), origin.at(index)];
            let push = |step: usize| pushes.at(index * count + step);
            surface.sets.with(bodies.limit(index), |set| {
                course.follow(set, &stepper, turns, begin, push);
            })?;
        }
        Ok(())
    })?;
    drop(courses);
    drop(memory);
    Ok([twists.finish()?, poses.finish()?, rests.into_any()])
}

impl BodyTrajectory<'_> {
    /// Steps from a twist and a pose. Position and angle are integrated by the trapezoidal rule, which is
    /// exact under the mean friction of a step; a patch that `turns` is taken at its angle at half time.
    fn follow(
        &mut self,
        set: &dyn FrictionSet<f64>,
        stepper: &Stepper,
        turns: bool,
        [mut twist, mut pose]: [[f64; 3]; 2],
        push: impl Fn(usize) -> [f64; 3],
    ) {
        let half = 0.5 * stepper.dt.dt();
        let rows = self.twists.iter_mut().zip(&mut *self.poses);
        for (step, ((after, place), rest)) in rows.zip(&mut *self.rests).enumerate() {
            let angle = turns.then(|| pose[2] + half * twist[2]);
            let done = stepper.step(set, angle, twist, push(step));
            for axis in 0..3 {
                pose[axis] += half * (twist[axis] + done.twist[axis]);
            }
            twist = done.twist;
            (*after, *place, *rest) = (twist, pose, done.is_at_rest);
        }
    }
}
