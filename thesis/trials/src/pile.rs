//! A few spheres on a floor, moved by contact dynamics or soft particles.

use super::Method;
use anyhow::{Result, bail};
use nalgebra::Vector3;
use tribos::cd::internals::Coefficients;
use tribos::cd::{self, ContactSolver, StepLimits, Wall, WorldMaterials};
use tribos::soft::{self, Stiffness};
use tribos_core::contact::{Cohesion, ContactFriction, NormalLaw, SphereBody};

/// Largest motion of a step of contact dynamics, in R: steps are to bound it.
const MOTION: f64 = 1.0;
/// Longest step of soft particles whose contacts are open.
const LONGEST: f64 = 1.0;

/// Spheres of radius 1 over a floor at height 0 of the vertical axis `up`.
#[derive(Clone, Debug)]
pub struct Pile<F> {
    pub up: Vector3<f64>,
    pub gravity: Vector3<f64>,
    pub friction: F,
    pub spheres: Vec<(Vector3<f64>, SphereBody<f64>)>,
}

/// The state after a step.
#[derive(Clone, Copy, Debug)]
pub struct StepObservation<'a> {
    pub time: f64,
    pub positions: &'a [Vector3<f64>],
    pub spheres: &'a [SphereBody<f64>],
    /// Sum of the normal forces on the floor.
    pub floor: f64,
}

impl<F: ContactFriction<f64> + Coefficients> Pile<F> {
    /// Runs for a time and shows every step; the number of updates of contacts.
    pub fn run(
        self,
        method: Method,
        until: f64,
        see: impl FnMut(&StepObservation<'_>),
    ) -> Result<f64> {
        match method {
            Method::Events => bail!("events know no lasting contacts"),
            Method::ContactDynamics { .. } => self.rigid(method, until, see),
            Method::Soft { stiffness, steps } => self.soft([stiffness, steps], until, see),
        }
    }

    fn laws(&self) -> Result<WorldMaterials<F>> {
        Ok(WorldMaterials::uniform(
            NormalLaw::new(Cohesion::NONE, 0.0)?,
            self.friction,
        ))
    }

    fn rigid(
        self,
        method: Method,
        until: f64,
        mut see: impl FnMut(&StepObservation<'_>),
    ) -> Result<f64> {
        let Method::ContactDynamics {
            tolerance,
            sweeps,
            step,
        } = method
        else {
            bail!("not contact dynamics");
        };
        let mut setup = cd::WorldSetup::new(self.laws()?)
            .wall(Wall::fixed(self.up, 0.0))
            .gravity(self.gravity);
        setup.step_limits = StepLimits {
            longest: step,
            motion: MOTION,
        };
        setup.solver = ContactSolver {
            method: cd::SolverMethod::Accelerated { tolerance },
            most_sweeps: sweeps,
            warm_start: 1.0,
        };
        for (place, sphere) in &self.spheres {
            setup = setup.sphere(*place, 1.0, *sphere);
        }
        let mut world = cd::World::new(setup)?;
        let mut updates = 0.0;
        while world.state().time < until {
            let report = world.step()?;
            updates += (report.contacts * report.iterations.sweeps.max(1)) as f64;
            let state = world.state();
            let [_, floor] = &state.memory.forces;
            see(&StepObservation {
                time: state.time,
                positions: &state.positions,
                spheres: &state.spheres,
                floor: floor.iter().map(|(_, force)| force.normal.abs()).sum(),
            });
        }
        Ok(updates)
    }

    fn soft(
        self,
        [stiffness, steps]: [f64; 2],
        until: f64,
        mut see: impl FnMut(&StepObservation<'_>),
    ) -> Result<f64> {
        let mut setup = soft::SoftSetup::new(self.laws()?, Stiffness::Linear(stiffness))
            .wall(Wall::fixed(self.up, 0.0))
            .gravity(self.gravity);
        setup.longest = LONGEST;
        setup.steps_per_collision = steps;
        for (place, sphere) in &self.spheres {
            setup = setup.sphere(*place, 1.0, *sphere);
        }
        let mut world = soft::SoftWorld::new(setup)?;
        let mut updates = 0.0;
        while world.state().time < until {
            updates += world.step()?.contacts.max(1) as f64;
            let state = world.state();
            let [_, floor] = &state.contacts;
            see(&StepObservation {
                time: state.time,
                positions: &state.positions,
                spheres: &state.spheres,
                floor: floor.iter().map(|contact| contact.force.normal.abs()).sum(),
            });
        }
        Ok(updates)
    }
}

/// Deepest overlap of spheres and floor.
pub fn deepest(look: &StepObservation<'_>, up: &Vector3<f64>) -> f64 {
    let floor = look.positions.iter().map(|x| 1.0 - up.dot(x));
    let pairs = look.positions.iter().enumerate().flat_map(|(i, a)| {
        let others = look.positions.iter().take(i);
        others.map(move |b| 2.0 - (a - b).norm())
    });
    floor.chain(pairs).fold(0.0, f64::max)
}
