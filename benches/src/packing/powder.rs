//! A cohesive powder in the middle of its compaction.

use super::jammed::NotJammed;
use super::problems::cool;
use nalgebra::Vector3;
use tribos::cd::internals::{Coefficients, Spheres};
use tribos::cd::{
    ContactSolver, SolverMethod, StepLimits, Wall, World, WorldError, WorldMaterials, WorldSetup,
    solid,
};
use tribos::powder::deposit::{Ballistic, DepositTarget};
use tribos::space::PeriodicBox;
use tribos_core::contact::{Attraction, Cohesion, ContactFriction, NormalLaw};

/// Width and height of the deposit, about 900 spheres; seed.
const WIDTH: f64 = 20.0;
const HEIGHT: f64 = 61.5;
const SEED: u64 = 1;
/// Capture radius of the deposit (thesis, section 4.5).
const CAPTURE: f64 = 3.0;
/// Range of cohesion.
const RANGE: f64 = 1e-2;
/// Load of the piston on an area R², and the piston's mass.
const PRESSURE: f64 = 1.0 / 400.0;
const PISTON: f64 = 1000.0;
/// Tolerance of the steps before the problem is taken.
const TOLERANCE: f64 = 1e-4;
const MOST_SWEEPS: usize = 1000;

/// The contact problem after `steps` steps under the piston, with impulses set to zero.
pub fn compacting<F>(friction: F, steps: usize) -> Result<Spheres<F>, NotJammed>
where
    F: ContactFriction<f64> + Coefficients,
{
    let refused = |error: WorldError| NotJammed(error.to_string());
    let mut world = World::new(setup(friction)?).map_err(refused)?;
    for _ in 0..steps {
        world.step().map_err(refused)?;
    }
    let mut problem = world.problem().clone();
    cool(&mut problem);
    Ok(problem)
}

fn setup<F>(friction: F) -> Result<WorldSetup<F>, NotJammed>
where
    F: ContactFriction<f64>,
{
    let deposit = Ballistic::new(WIDTH, 1.0, CAPTURE)
        .and_then(|ballistic| ballistic.grow(DepositTarget::Height(HEIGHT), SEED))
        .map_err(|error| NotJammed(error.to_string()))?;
    let cohesive = Cohesion::new(1.0, RANGE, Attraction::Pull)
        .and_then(|cohesion| NormalLaw::new(cohesion, 0.0))
        .map_err(|error| NotJammed(error.to_string()))?;
    let up = Vector3::z();
    Ok(WorldSetup {
        space: PeriodicBox::new([Some(WIDTH), Some(WIDTH), None])?,
        spheres: deposit.radii.iter().map(|&r| solid(r, 1.0)).collect(),
        positions: deposit.positions,
        radii: deposit.radii,
        walls: vec![
            Wall::fixed(up, 0.0),
            Wall::piston(-up, -deposit.height, PISTON, PRESSURE * WIDTH * WIDTH),
        ],
        laws: WorldMaterials::uniform(cohesive, friction),
        gravity: Vector3::zeros(),
        shear_rate: 0.0,
        cell: None,
        mixture: None,
        mesh: None,
        step_limits: StepLimits {
            longest: 0.2,
            motion: 0.05,
        },
        solver: ContactSolver {
            method: SolverMethod::Accelerated {
                tolerance: TOLERANCE,
            },
            most_sweeps: MOST_SWEEPS,
            warm_start: 1.0,
        },
        sleep_speed: 0.0,
    })
}
