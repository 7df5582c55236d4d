//! Spheres and walls, step by step: the library's contact dynamics.

use crate::arrays::refused;
use crate::threads::detached;
use crate::vectors::{rows, vectors};
use nalgebra::Vector3;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tribos::cd::{
    ContactMaterial, SolverMethod, StepLimits, StepReport, Wall, WorldMaterials, WorldSetup, solid,
};
use tribos::cd::{ContactSolver, World as Spheres};
use tribos::space::PeriodicBox;
use tribos_core::contact::{AllModes, Attraction, Cohesion, IndependentFriction, NormalLaw};

type Friction = IndependentFriction<f64, AllModes>;

/// Numbers of a law: sliding, rolling and torsion coefficients, restitution, cohesion and its range, and whether
/// cohesion pulls at a gap.
type LawNumbers = ([f64; 6], bool);

fn law(
    ([sliding, rolling, torsion, restitution, strength, range], pulls): LawNumbers,
) -> PyResult<ContactMaterial<Friction>> {
    let attraction = match pulls {
        true => Attraction::Pull,
        false => Attraction::Resistance,
    };
    let cohesion = Cohesion::new(strength, range, attraction).map_err(refused)?;
    Ok(ContactMaterial {
        normal: NormalLaw::new(cohesion, restitution).map_err(refused)?,
        friction: Friction::all(sliding, rolling, torsion).map_err(refused)?,
    })
}

/// A plane: unit normal, place along it, mass, force and speed along the normal.
type WallNumbers = ([f64; 3], f64, f64, f64, [f64; 3]);

fn wall((normal, place, mass, force, velocity): WallNumbers) -> Wall {
    let mut wall = Wall::piston(Vector3::from(normal), place, mass, force);
    wall.plate.velocity = Vector3::from(velocity);
    wall
}

/// Spheres between walls, in motion.
#[pyclass(frozen, module = "tribos._native")]
#[derive(Debug)]
pub struct World(Mutex<WorldVariant>);

#[derive(Debug)]
struct WorldVariant {
    world: Spheres<Friction>,
    last: StepReport,
}

#[pymethods]
impl World {
    #[new]
    #[pyo3(signature = (positions, radii, *, densities, velocities, spins, pairs, at_walls, walls, gravity, periods, longest_step, largest_motion, tolerance, sweeps, sleep_speed))]
    #[expect(
        clippy::too_many_arguments,
        reason = "one for each of the library's settings"
    )]
    fn new(
        positions: &Bound<'_, PyAny>,
        radii: Vec<f64>,
        densities: Vec<f64>,
        velocities: Option<Bound<'_, PyAny>>,
        spins: Option<Bound<'_, PyAny>>,
        pairs: LawNumbers,
        at_walls: LawNumbers,
        walls: Vec<WallNumbers>,
        gravity: [f64; 3],
        periods: [Option<f64>; 3],
        longest_step: f64,
        largest_motion: f64,
        tolerance: f64,
        sweeps: usize,
        sleep_speed: f64,
    ) -> PyResult<Self> {
        let positions = vectors("positions", positions)?;
        let count = positions.len();
        let mut spheres: Vec<_> = radii
            .iter()
            .zip(&densities)
            .map(|(&radius, &density)| solid(radius, density))
            .collect();
        for (name, given) in [("velocities", velocities), ("spins", spins)] {
            let Some(given) = given else { continue };
            let given = vectors(name, &given)?;
            if given.len() != count {
                let text = format!("{name} must have shape ({count}, 3)");
                return Err(PyValueError::new_err(text));
            }
            for (sphere, value) in spheres.iter_mut().zip(given) {
                match name {
                    "spins" => sphere.spin = value,
                    _ => sphere.velocity = value,
                }
            }
        }
        let laws = WorldMaterials {
            pairs: law(pairs)?,
            walls: law(at_walls)?,
        };
        let setup = WorldSetup {
            space: PeriodicBox::new(periods).map_err(refused)?,
            positions,
            radii,
            spheres,
            walls: walls.into_iter().map(wall).collect(),
            gravity: Vector3::from(gravity),
            step_limits: StepLimits {
                longest: longest_step,
                motion: largest_motion,
            },
            solver: ContactSolver {
                method: SolverMethod::Accelerated { tolerance },
                most_sweeps: sweeps,
                warm_start: 1.0,
            },
            sleep_speed,
            ..WorldSetup::new(laws)
        };
        let inside = WorldVariant {
            world: Spheres::new(setup).map_err(refused)?,
            last: StepReport::default(),
        };
        Ok(Self(Mutex::new(inside)))
    }

    /// Takes steps; signals are looked for on the way.
    fn step(&self, py: Python<'_>, count: u64) -> PyResult<()> {
        /// Steps from one look for signals to the next.
        const PIECE: u64 = 64;
        let mut left = count;
        while left > 0 {
            let piece = left.min(PIECE);
            detached(py, || {
                let mut inside = self.lock();
                for _ in 0..piece {
                    inside.last = inside.world.step()?;
                }
                Ok(())
            })?
            .map_err(|error: tribos::cd::WorldError| PyRuntimeError::new_err(error.to_string()))?;
            left -= piece;
            py.check_signals()?;
        }
        Ok(())
    }

    /// Time and number of steps.
    fn clock(&self, py: Python<'_>) -> (f64, u64) {
        let inside = self.held(py);
        (inside.world.state().time, inside.world.state().steps)
    }

    /// Centres, not wrapped into the periodic box.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, &self.held(py).world.state().positions)
    }

    /// Velocities of the centres.
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let inside = self.held(py);
        let spheres = inside.world.state().spheres.iter();
        rows(py, spheres.map(|sphere| &sphere.velocity))
    }

    /// Angular velocities.
    fn spins<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let inside = self.held(py);
        let spheres = inside.world.state().spheres.iter();
        rows(py, spheres.map(|sphere| &sphere.spin))
    }

    /// Replaces velocities or spins between two steps.
    fn set(&self, py: Python<'_>, name: &str, given: &Bound<'_, PyAny>) -> PyResult<()> {
        let spins = name == "spins";
        let given = vectors(if spins { "spins" } else { "velocities" }, given)?;
        let mut inside = self.held(py);
        let spheres = &mut inside.world.state_mut().spheres;
        let is_finite = given.iter().flatten().all(|part| part.is_finite());
        if given.len() != spheres.len() || !is_finite {
            let count = spheres.len();
            let text = format!("{name} must be finite and of shape ({count}, 3)");
            return Err(PyValueError::new_err(text));
        }
        for (sphere, value) in spheres.iter_mut().zip(given) {
            if spins {
                sphere.spin = value;
            } else {
                sphere.velocity = value;
            }
        }
        Ok(())
    }

    /// Places of the walls along their normals, and their speeds along them.
    fn walls(&self, py: Python<'_>) -> Vec<(f64, f64)> {
        let inside = self.held(py);
        let walls = inside.world.state().walls.iter();
        walls
            .map(|wall| (wall.place, wall.outward.dot(&wall.plate.velocity)))
            .collect()
    }

    /// The contacts of the last step with their mean forces.
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let inside = self.held(py);
        let (problem, dt) = (inside.world.problem(), inside.last.dt);
        let all = PyDict::new(py);
        let spheres = problem.pairs.iter().map(|link| (link, false));
        let links: Vec<_> = spheres
            .chain(problem.walls.iter().map(|link| (*link, true)))
            .collect();
        let bodies: Vec<i64> = links
            .iter()
            .flat_map(|(link, is_wall)| {
                let [a, b] = link.bodies.map(i64::from);
                [a, if *is_wall { -1 - b } else { b }]
            })
            .collect();
        let bodies = PyArray1::from_vec(py, bodies).reshape([links.len(), 2])?;
        all.set_item("pairs", bodies)?;
        let normals: Vec<_> = links
            .iter()
            .map(|(link, _)| *link.contact.normal())
            .collect();
        let load = |angular: bool| -> Vec<Vector3<f64>> {
            let of = |(link, _): &(tribos::cd::internals::Link<AllModes>, bool)| {
                let (impulse, normal) = (link.contact.impulse(), link.contact.normal());
                let sum = match angular {
                    true => impulse.angular(normal),
                    false => impulse.linear(normal),
                };
                sum / dt
            };
            links.iter().map(of).collect()
        };
        all.set_item("normals", rows(py, &normals)?)?;
        all.set_item("forces", rows(py, &load(false))?)?;
        all.set_item("torques", rows(py, &load(true))?)?;
        Ok(all)
    }

    /// Report of the last step and the energy balance so far.
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let inside = self.held(py);
        let (last, energy) = (&inside.last, &inside.world.state().energy);
        let all = PyDict::new(py);
        all.set_item("dt", last.dt)?;
        all.set_item("contacts", last.contacts)?;
        all.set_item("sweeps", last.iterations.sweeps)?;
        all.set_item("is_met", last.is_met())?;
        for (name, value) in [
            ("work", energy.work),
            ("normal", energy.normal),
            ("sliding", energy.sliding),
            ("rolling", energy.rolling),
            ("torsion", energy.torsion),
            ("cohesion", energy.cohesion),
            ("stilled", energy.stilled),
            ("kinetic", energy.kinetic),
            ("imbalance", energy.imbalance()),
        ] {
            all.set_item(name, value)?;
        }
        Ok(all)
    }
}

impl World {
    fn lock(&self) -> MutexGuard<'_, WorldVariant> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The inside; a step of another thread is waited for without the interpreter's lock.
    fn held(&self, py: Python<'_>) -> MutexGuard<'_, WorldVariant> {
        loop {
            match self.0.try_lock() {
                Ok(inside) => return inside,
                Err(std::sync::TryLockError::Poisoned(broken)) => return broken.into_inner(),
                Err(std::sync::TryLockError::WouldBlock) => py.detach(|| drop(self.lock())),
            }
        }
    }
}
