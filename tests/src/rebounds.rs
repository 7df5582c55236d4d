//! A gas with restitution and friction: its energy balance and largest impulse.

use crate::gas::{SIDE, gas};
use crate::packings::rough;
use nalgebra::Vector3;
use tribos::cd::{EnergyBalance, StepLimits, Wall, World};
use tribos::space::PeriodicBox;
use tribos_core::contact::{Cohesion, NormalLaw};

/// Restitution, friction and time step of a run.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Coefficient of restitution of spheres and walls.
    pub restitution: f64,
    /// Sliding coefficient.
    pub mu: f64,
    /// Rolling and torsion coefficient.
    pub rolling: f64,
    /// Length of a step.
    pub dt: f64,
}

/// Results of a run, with energies in units of the initial one.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    /// Losses by collisions, sliding, rolling and torsion.
    pub lost: [f64; 4],
    /// Kinetic energy at the end.
    pub kept: f64,
    /// Smallest loss of any of the four in a step: negative if one gained energy.
    pub least: f64,
    /// Imbalance of the energy balance.
    pub imbalance: f64,
    /// Largest impulse of a contact in a step, along its normal or across it.
    pub largest: f64,
    /// Steps whose impacts were cut off or whose solver missed its tolerance.
    pub unmet: usize,
}

/// 64 spheres between six walls, for a time in which about 100 pairs collide. No motion is fast enough
/// to shorten a step.
pub fn run(cell: Cell, time: f64) -> Answer {
    let mut world = World::new(setup(cell)).expect("the setup is valid");
    let (mut largest, mut least, mut unmet) = (0.0_f64, 0.0_f64, 0);
    while world.state().time < time * (1.0 - 1e-9) {
        let before = losses(&world.state().energy);
        let report = world.step().expect("the gas can step");
        unmet += usize::from(!report.is_met());
        for (old, new) in before.into_iter().zip(losses(&world.state().energy)) {
            least = least.min(new - old);
        }
        for link in world.problem().links() {
            let impulse = link.contact.impulse();
            let across = impulse.sliding().norm();
            largest = largest.max(impulse.normal).max(across);
        }
    }
    let book = world.state().energy;
    let scale = book.kinetic_initial.unwrap_or(f64::NAN);
    Answer {
        lost: losses(&book).map(|energy| energy / scale),
        kept: book.kinetic / scale,
        least: least / scale,
        imbalance: book.imbalance() / scale,
        largest,
        unmet,
    }
}

/// The gas with the parameters of one run.
pub fn setup(cell: Cell) -> tribos::cd::WorldSetup<crate::packings::Rough> {
    let normal = NormalLaw::new(Cohesion::NONE, cell.restitution).expect("the law is valid");
    let friction = rough(cell.mu, cell.rolling, cell.rolling);
    let mut setup = gas(PeriodicBox::OPEN, normal, friction);
    for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
        setup.walls.push(Wall::fixed(axis, 0.0));
        setup.walls.push(Wall::fixed(-axis, -SIDE));
    }
    setup.step_limits = StepLimits {
        longest: cell.dt,
        motion: 1.0,
    };
    setup
}

/// Losses, none of which may decrease.
fn losses(book: &EnergyBalance) -> [f64; 4] {
    [book.normal, book.sliding, book.rolling, book.torsion]
}
