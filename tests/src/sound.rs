//! Too few sweeps make a row of rigid spheres elastic: a damped sound wave with known speed.
//!
//! Information diffuses by D = q N_I d²/dt in a step of N_I sweeps, q = (4√e − 5)/2 for random
//! orders, which gives waves c = √(q N_I) d/dt with the rate of damping D k²/2 (Unger, Brendel,
//! Wolf and Kertész 2002).

use crate::packings::{Smooth, dry, row};
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos::cd::{
    ContactSolver, IterationOrder, SolverMethod, StepLimits, StopRule, Wall, World, WorldMaterials,
    WorldSetup,
};

/// Number of spheres in the row; the piston at its end is one more body of the same mass.
const SPHERES: usize = 49;
/// Number of sweeps per step.
const SWEEPS: usize = 40;
/// Half periods that are left out: the first front of the load, and contacts with zero force.
const FIRST: usize = 3;
/// Number of periods compared.
const PERIODS: usize = 3;

/// A row between a wall and a piston of one sphere's mass, pushed from time 0 by 0.05 m d/dt².
pub fn pushed(order: IterationOrder) -> WorldSetup<Smooth> {
    let mut setup = row(SPHERES, 0.0, WorldMaterials::uniform(dry(), Smooth::none()));
    let mass = 1.0 / setup.spheres[0].inv_mass;
    let end = Wall::piston(-Vector3::x(), -2.0 * SPHERES as f64, mass, 0.1 * mass);
    setup.walls.push(end);
    setup.step_limits = StepLimits {
        longest: 1.0,
        motion: 0.3,
    };
    setup.solver = ContactSolver {
        method: SolverMethod::GaussSeidel {
            order,
            stop: StopRule::Fixed,
        },
        most_sweeps: SWEEPS,
        warm_start: 1.0,
    };
    setup
}

/// Period and damping rate of the last body's velocity, in steps: from its zeros, and from its
/// amplitude between them, which is that of the fundamental mode once the others have decayed.
pub fn measured(order: IterationOrder) -> (f64, f64) {
    let mut world = World::new(pushed(order)).expect("the setup is valid");
    let (mut zeros, mut swings) = (Vec::new(), Vec::new());
    let (mut last, mut swing) = (0.0_f64, 0.0);
    for step in 1.. {
        let report = world.step().expect("the row can step");
        assert_eq!(report.dt, 1.0, "the step must not shrink");
        let speed = -world.state().walls[1].plate.velocity.x;
        if speed * last < 0.0 {
            zeros.push(f64::from(step) - speed / (speed - last));
            swings.push(swing);
            swing = 0.0;
        }
        if zeros.len() > FIRST + 2 * PERIODS {
            break;
        }
        swing += speed;
        last = speed;
    }
    let halves = 2.0 * PERIODS as f64;
    let period = 2.0 * (zeros[FIRST + 2 * PERIODS] - zeros[FIRST]) / halves;
    let ratio: f64 = swings[FIRST] / swings[FIRST + 2 * PERIODS];
    (period, ratio.abs().ln() / (0.5 * period * halves))
}

/// Theoretical period and damping rate, in steps.
pub fn expected(q: f64) -> (f64, f64) {
    let diffusion = q * SWEEPS as f64;
    let speed = diffusion.sqrt();
    // The row is a quarter of the wavelength, from the wall to the free end.
    let k = 0.5 * PI / (SPHERES + 1) as f64;
    let omega = k * (diffusion - 0.25 * (diffusion * k).powi(2)).sqrt();
    assert!(k < 2.0 * speed / diffusion, "the wave is not overdamped");
    (2.0 * PI / omega, 0.5 * diffusion * k * k)
}

/// Factor q of random orders.
pub fn random_q() -> f64 {
    0.5 * (4.0 * 0.5_f64.exp() - 5.0)
}
