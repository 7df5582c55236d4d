//! Bodies that are pushed and turned on their patch: implicit time steps.

use crate::arrays::{Batched, Column, Numbers, Output, Rows, View, broadcast, refused};
use crate::model::{Sets, numbers, twist_numbers, twist_of, wrench_of};
use crate::patch::Patch;
use crate::surface::LimitSurface;
use crate::threads::fill_together;
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use std::borrow::Cow;
use std::ops::Range;
use tribos::friction::SurfaceBatch;
use tribos_core::contact::TimeStep;
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

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
    /// Static over kinetic friction, at least 1.
    strength: f64,
}

/// The same as numbers.
struct BodyNumbers<'py>([Numbers<'py>; 4]);

/// The same for each body of a batch.
struct Columns<'py>([Column<'py, 1>; 4]);

/// The same without Python.
#[derive(Clone, Copy)]
struct Bodies<'a>([View<'a, 1>; 4]);

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
    /// True if all have one mass, inertia and time step.
    fn are_alike(&self) -> bool {
        let [_, given @ ..] = self.0;
        given.iter().all(|one| matches!(one, View::One(_)))
    }

    /// The bodies `of` with their time steps: one, if all are alike.
    fn with_steps(&self, mut of: Range<usize>) -> PyResult<Vec<(PlanarBody<f64>, TimeStep<f64>)>> {
        let [_, given @ ..] = self.0;
        if self.are_alike() {
            of.end = of.end.min(of.start + 1);
        }
        let one = |index| {
            let [mass, inertia, dt] = given.map(|one| one.at(index)[0]);
            let body = PlanarBody::new(mass, inertia).map_err(refused)?;
            Ok((body, TimeStep::new(dt).map_err(refused)?))
        };
        of.map(one).collect()
    }

    /// The force limits of the bodies `of`.
    fn limits(&self, of: Range<usize>) -> Cow<'_, [[f64; 1]]> {
        self.0[0].rows(of)
    }

    /// Half the time step of a body, in s.
    fn half_step(&self, index: usize) -> f64 {
        let [dt] = self.0[3].at(index);
        0.5 * dt
    }
}

/// A step to write over.
const BLANK: PlanarStep<f64> = PlanarStep {
    twist: Twist::ZERO,
    friction: Wrench::ZERO,
    is_at_rest: false,
};

/// Bodies that are stepped together.
struct Stepper<'a> {
    surfaces: SurfaceBatch<'a>,
    /// One by one, where static friction is above kinetic friction.
    alone: Option<Alone<'a>>,
    bodies: Vec<(PlanarBody<f64>, TimeStep<f64>)>,
    twists: Vec<Twist<f64>>,
    pushes: Vec<Wrench<f64>>,
    /// Sine and cosine of the angles by which patches are turned.
    turns: Vec<Option<[f64; 2]>>,
    steps: Vec<PlanarStep<f64>>,
}

/// What bodies are stepped one by one with.
struct Alone<'a> {
    sets: &'a Sets,
    limits: &'a [f64],
    strength: f64,
}

/// A body before a step: the angle by which its patch is turned, in rad, if that matters, its motion and its push.
type Before = (Option<f64>, [f64; 3], [f64; 3]);

impl<'a> Stepper<'a> {
    /// For the bodies `of`, which have these force limits.
    fn new(
        surfaces: &'a Sets,
        (limits, strength): (&'a [f64], f64),
        bodies: &Bodies<'_>,
        of: Range<usize>,
    ) -> PyResult<Self> {
        Ok(Self {
            surfaces: surfaces.0.under_each(limits).map_err(refused)?,
            alone: (strength > 1.0).then_some(Alone {
                sets: surfaces,
                limits,
                strength,
            }),
            twists: Vec::with_capacity(of.len()),
            pushes: Vec::with_capacity(of.len()),
            turns: Vec::with_capacity(of.len()),
            steps: vec![BLANK; of.len()],
            bodies: bodies.with_steps(of)?,
        })
    }

    /// One step of all bodies.
    fn step(&mut self, all: impl Iterator<Item = Before>) -> PyResult<&[PlanarStep<f64>]> {
        self.twists.clear();
        self.pushes.clear();
        self.turns.clear();
        for (angle, twist, push) in all {
            let angle = angle.filter(|angle| *angle != 0.0);
            let turn = angle.map(|angle| [Real::sin(angle), Real::cos(angle)]);
            // Along the axes of the patch.
            self.twists.push(twist_of(turned(twist, turn)));
            self.pushes.push(wrench_of(turned(push, turn)));
            self.turns.push(turn.map(|[sin, cos]| [-sin, cos]));
        }
        match &self.alone {
            None => {
                self.surfaces
                    .step_batch(&self.bodies, &self.twists, &self.pushes, &mut self.steps);
            }
            Some(alone) => {
                let all = self
                    .steps
                    .iter_mut()
                    .zip(self.twists.iter().zip(&self.pushes));
                // One load, and one body, stand for all.
                let last = |of: usize, index: usize| index.min(of.saturating_sub(1));
                for (index, (step, (twist, push))) in all.enumerate() {
                    let limit = alone.limits[last(alone.limits.len(), index)];
                    let (body, dt) = self.bodies[last(self.bodies.len(), index)];
                    *step = alone.sets.with(limit, |set| {
                        body.step_sticking(set, alone.strength, twist, push, dt)
                    })?;
                }
            }
        }
        for (step, turn) in self.steps.iter_mut().zip(&self.turns) {
            if turn.is_some() {
                step.friction = wrench_of(turned(numbers(&step.friction), *turn));
            }
            if turn.is_some() && !step.is_at_rest {
                step.twist = twist_of(turned(twist_numbers(&step.twist), *turn));
            }
        }
        Ok(&self.steps)
    }
}

/// Numbers of a twist or a wrench along axes that are turned by an angle with this sine and cosine.
fn turned([x, y, turning]: [f64; 3], turn: Option<[f64; 2]>) -> [f64; 3] {
    match turn {
        Some([sin, cos]) => [cos * x + sin * y, cos * y - sin * x, turning],
        None => [x, y, turning],
    }
}

/// Bodies that are stepped together, if there are as many for each thread.
const TOGETHER: usize = 64;

/// Nanoseconds that a step takes, about.
fn cost(patch: &Patch, bodies: &Bodies<'_>) -> usize {
    match (patch.0.is_round(), bodies.are_alike()) {
        (true, true) => 250,
        (true, false) => 800,
        (false, _) => 3_000,
    }
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
    let arguments = bodies.extract::<BodyArguments<'py>>()?;
    let (given, strength) = (arguments.numbered()?, arguments.strength);
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

    let mut steps = vec![BLANK; batch.iter().product()];
    let cost = cost(patch, &bodies);
    fill_together(py, &mut steps, cost, TOGETHER, |from, piece| {
        let all = from..from + piece.len();
        let limits = bodies.limits(all.clone());
        let limits = (limits.as_flattened(), strength);
        let mut stepper = Stepper::new(&surface.sets, limits, &bodies, all.clone())?;
        let before = |index| {
            let angle = turns.then(|| angle.at(index)[0]);
            (angle, start.at(index), pushes.at(index))
        };
        piece.copy_from_slice(stepper.step(all.map(before))?);
        Ok(())
    })?;

    let mut twists = Output::new(py, &batch, &[3], out)?;
    let mut friction = Output::new(py, &batch, &[3], None)?;
    let rests = PyArrayDyn::<bool>::zeros(py, batch, false);
    let rows = twists.rows::<3>()?.iter_mut().zip(friction.rows::<3>()?);
    let mut memory = rests.readwrite();
    let flags = memory.as_slice_mut().map_err(refused)?;
    for (((twist, friction), rest), step) in rows.zip(flags).zip(&steps) {
        *twist = twist_numbers(&step.twist);
        *friction = numbers(&step.friction);
        *rest = step.is_at_rest;
    }
    drop(memory);
    Ok([twists.finish()?, friction.finish()?, rests.into_any()])
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
    let arguments = bodies.extract::<BodyArguments<'py>>()?;
    let (given, strength) = (arguments.numbered()?, arguments.strength);
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
    let whole = cost(patch, &bodies).saturating_mul(each);
    fill_together(py, &mut courses, whole, TOGETHER, |from, piece| {
        let all = from..from + piece.len();
        let limits = bodies.limits(all.clone());
        let limits = (limits.as_flattened(), strength);
        let mut stepper = Stepper::new(&surface.sets, limits, &bodies, all.clone())?;
        let state = |index| [start.at(index), origin.at(index)];
        let mut states: Vec<_> = all.clone().map(state).collect();
        for step in 0..count {
            let before = |(index, [twist, pose]): (usize, &[[f64; 3]; 2])| {
                // A patch that turns is taken at its angle at half time.
                let angle = turns.then(|| pose[2] + bodies.half_step(index) * twist[2]);
                (angle, *twist, pushes.at(index * count + step))
            };
            let done = stepper.step(all.clone().zip(&states).map(before))?;
            let bodies_after = all.clone().zip(&mut states).zip(done);
            for (((index, state), done), course) in bodies_after.zip(piece.iter_mut()) {
                *state = moved(*state, twist_numbers(&done.twist), bodies.half_step(index));
                [course.twists[step], course.poses[step]] = *state;
                course.rests[step] = done.is_at_rest;
            }
        }
        Ok(())
    })?;
    drop(courses);
    drop(memory);
    Ok([twists.finish()?, poses.finish()?, rests.into_any()])
}

/// The motion and the pose after a step: the trapezoidal rule, which is exact under the mean friction of a step.
fn moved([twist, mut pose]: [[f64; 3]; 2], after: [f64; 3], half_step: f64) -> [[f64; 3]; 2] {
    for axis in 0..3 {
        pose[axis] += half_step * (twist[axis] + after[axis]);
    }
    [after, pose]
}
