//! Feet in a MuJoCo simulation: the step of `tribos-mujoco` on any patch.

use crate::arrays::refused;
use crate::model::{Sets, numbers, twist_of, wrench_of};
use crate::patch::Patch;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::ffi::c_void;
use tribos_mujoco::{Carry, Contacts, Feet, FootModel, FootReport, LinkError, Simulation, arrays};

/// What a foot is.
#[derive(FromPyObject)]
struct FootArguments<'py> {
    name: String,
    patch: Bound<'py, Patch>,
    mu: f64,
    geoms: Vec<i32>,
    floor: i32,
    bodies: [i32; 2],
    frame: [i32; 2],
}

/// A simulation, by the addresses of its parts.
#[derive(FromPyObject)]
struct SimulationArguments {
    arrays: Vec<usize>,
    solve: usize,
    model: usize,
    data: usize,
    awake: usize,
    counts: [i32; 3],
    /// Width of a contact in bytes, and where in it the fields lie.
    layout: [i32; 9],
}

/// Feet of one simulation.
#[pyclass(module = "tribos._native")]
pub struct MujocoFeet(Feet);

type Triple = [f64; 3];
type FootState = (f64, Triple, Triple, [Triple; 3], Triple, bool, u64);

#[pymethods]
impl MujocoFeet {
    /// The package keeps the simulation alive, and asks MuJoCo for addresses and types.
    #[new]
    #[expect(unsafe_code, reason = "addresses of MuJoCo's arrays")]
    fn new(simulation: SimulationArguments, feet: Vec<FootArguments<'_>>) -> PyResult<Self> {
        let names: Vec<_> = feet.iter().map(|foot| foot.name.clone()).collect();
        let name = |foot: usize| names.get(foot).map_or("", String::as_str);
        let feet = feet.into_iter().map(FootArguments::foot);
        let feet = feet.collect::<PyResult<Vec<_>>>()?;
        let SimulationArguments {
            arrays: addresses,
            solve,
            model,
            data,
            awake,
            counts,
            layout,
        } = simulation;
        if addresses.len() != arrays().split_terminator(';').count() {
            return Err(refused("one address for each array"));
        }
        let simulation = Simulation {
            arrays: addresses.as_ptr(),
            solve,
            model,
            data,
            awake,
            counts,
            layout,
        };
        // SAFETY: the package's promise.
        let made = unsafe { Feet::new(&simulation, feet) };
        made.map(Self).map_err(|error| match error {
            LinkError::NoMemory => refused("there is no memory for the feet"),
            LinkError::NeverMoves { foot } => refused(format!(
                "foot {} never moves on its floor: neither body has a joint",
                name(foot)
            )),
            LinkError::ClaimedTwice { foot, other } => refused(format!(
                "feet {} and {} have a geom on the same floor",
                name(other),
                name(foot)
            )),
        })
    }

    /// Types and names of the arrays whose addresses are wanted.
    #[staticmethod]
    fn arrays() -> Vec<(&'static str, &'static str)> {
        let each = arrays().split_terminator(';');
        each.filter_map(|array| array.rsplit_once(' ')).collect()
    }

    /// Adds this step's friction to the passive forces, from the contacts, the stiffness and the springs of
    /// their rows.
    #[expect(unsafe_code, reason = "addresses of MuJoCo's arrays")]
    fn step(
        &mut self,
        time: f64,
        dt: f64,
        contacts: (usize, usize),
        stiffness: &Bound<'_, PyArray1<f64>>,
        springs: &Bound<'_, PyArray2<f64>>,
    ) -> PyResult<()> {
        let rows = stiffness.len();
        let is_whole = stiffness.is_c_contiguous() && springs.is_c_contiguous();
        if !is_whole || springs.shape() != [rows, 4] {
            return Err(refused("MuJoCo's constraints are laid out in another way"));
        }
        let (first, count) = contacts;
        let contacts = Contacts {
            first: first as *const c_void,
            count,
            stiffness: stiffness.data(),
            springs: springs.data(),
            rows,
        };
        // SAFETY: the package's promise.
        unsafe { self.0.step(time, dt, &contacts) }.map_err(refused)
    }

    /// Of a foot: load, friction on it, its twist before the step, axes, centre, whether it is held, and how many
    /// searches for its friction stopped at their count.
    fn state(&self, foot: usize) -> PyResult<FootState> {
        let found = self.0.report(foot);
        let FootReport {
            load,
            friction,
            twist,
            axes: [a, b, c, d, e, f, g, h, i],
            centre,
            is_held,
            missed,
        } = found.ok_or_else(|| refused("no such foot"))?;
        let axes = [[a, b, c], [d, e, f], [g, h, i]];
        let is_held = is_held > 0.0;
        Ok((load, friction, twist, axes, centre, is_held, missed as u64))
    }
}

impl FootArguments<'_> {
    fn foot(self) -> PyResult<(FootModel, Box<dyn Carry>)> {
        let sets = Sets::new(&self.patch.get().0)?;
        let model = FootModel {
            geoms: self.geoms,
            ground: self.floor,
            bodies: self.bodies,
            frame: self.frame,
            mu: self.mu,
        };
        Ok((model, Box::new(sets)))
    }
}

/// NaN under a force limit that is none.
impl Carry for Sets {
    fn arm(&self) -> f64 {
        let turn = twist_of([0.0, 0.0, 1.0]);
        self.with(1.0, |set| set.support(&turn)).unwrap_or(f64::NAN)
    }

    fn project(&self, force_limit: f64, wrench: [f64; 3], length: f64) -> [f64; 3] {
        let wrench = wrench_of(wrench);
        self.with(force_limit, |set| set.project_with_length(&wrench, length))
            .map_or([f64::NAN; 3], |nearest| numbers(&nearest.wrench))
    }

    fn oppose(&self, force_limit: f64, motion: [f64; 3]) -> [f64; 3] {
        let twist = twist_of(motion);
        self.with(force_limit, |set| set.wrench(&twist))
            .map_or([f64::NAN; 3], |wrench| numbers(&wrench))
    }
}
