//! A row of rigid bodies that too few sweeps make elastic, and the sweeps that make it rigid (eq. 4.4).

use anyhow::{Result, ensure};
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos::cd::{
    ContactSolver, IterationOrder, SolverMethod, StepLimits, StopRule, Wall, World, WorldMaterials,
    WorldSetup, solid,
};
use tribos_core::contact::{Cohesion, Frictionless, IndependentFriction, NormalLaw};

type Smooth = IndependentFriction<f64, Frictionless>;

/// Bodies of the row, the last of them the piston, and sweeps of a step.
pub const BODIES: usize = 50;
pub const SWEEPS: usize = 40;
/// Half periods that are left out: the first front of the load, and contacts without force.
const FIRST: usize = 3;
/// Periods compared.
const PERIODS: usize = 3;
/// Velocity that the load alone gives the piston in the first step, in R a step.
const PUSH: f64 = 0.1;
/// A bound for a row that never swings.
const MOST_STEPS: usize = 2_000;
/// Share of the load that the wall at the other end may lack when a row counts as rigid.
const RIGID: f64 = 0.1;

/// A row between a wall and a piston of one sphere's mass that is pushed from time 0 on.
fn row(bodies: usize, order: IterationOrder, sweeps: usize) -> Result<World<Smooth>> {
    let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, Smooth::none());
    let count = bodies - 1;
    let sphere = solid(1.0, 1.0);
    let mass = 1.0 / sphere.inv_mass;
    let place = |index: usize| Vector3::new(1.0 + 2.0 * index as f64, 0.0, 0.0);
    let setup = WorldSetup {
        positions: (0..count).map(place).collect(),
        radii: vec![1.0; count],
        spheres: vec![sphere; count],
        walls: vec![
            Wall::fixed(Vector3::x(), 0.0),
            Wall::piston(-Vector3::x(), -2.0 * count as f64, mass, PUSH * mass),
        ],
        step_limits: StepLimits {
            longest: 1.0,
            motion: 0.3,
        },
        solver: ContactSolver {
            method: SolverMethod::GaussSeidel {
                order,
                stop: StopRule::Fixed,
            },
            most_sweeps: sweeps,
            warm_start: 1.0,
        },
        ..WorldSetup::new(laws)
    };
    Ok(World::new(setup)?)
}

fn speed(world: &World<Smooth>) -> f64 {
    -world.state().walls[1].plate.velocity.x
}

/// A wave of the row.
pub struct Wave {
    /// In steps.
    pub period: f64,
    /// In 1/step.
    pub damping: f64,
    /// Velocity of the piston, step by step.
    pub speeds: Vec<f64>,
}

impl Wave {
    /// What a row does with sweeps in the random order of a seed. The period is that of the zeros of the
    /// piston's velocity, the damping that of its swings between them.
    pub fn measured(seed: u64) -> Result<Self> {
        let mut world = row(BODIES, IterationOrder::Random { seed }, SWEEPS)?;
        let (mut zeros, mut swings, mut speeds) = (Vec::new(), Vec::new(), Vec::new());
        let (mut last, mut swing) = (0.0_f64, 0.0);
        while zeros.len() <= FIRST + 2 * PERIODS {
            ensure!(speeds.len() < MOST_STEPS, "the row does not swing");
            world.step()?;
            let now = speed(&world);
            speeds.push(now);
            if now * last < 0.0 {
                zeros.push(speeds.len() as f64 - now / (now - last));
                swings.push(swing);
                swing = 0.0;
            }
            swing += now;
            last = now;
        }
        let halves = 2.0 * PERIODS as f64;
        let end = FIRST + 2 * PERIODS;
        let period = 2.0 * (zeros[end] - zeros[FIRST]) / halves;
        let ratio: f64 = swings[FIRST] / swings[end];
        Ok(Self {
            period,
            damping: ratio.abs().ln() / (0.5 * period * halves),
            speeds,
        })
    }

    /// What diffusion gives: sweeps carry information as D = q N_I d² a step, q = (4√e − 5)/2 for random orders,
    /// and the row is a quarter of a wave with the speed √(q N_I) d a step and the damping D k²/2.
    pub fn expected() -> Self {
        let q = 0.5 * (4.0 * 0.5_f64.exp() - 5.0);
        let diffusion = q * SWEEPS as f64;
        let k = 0.5 * PI / BODIES as f64;
        let omega = k * (diffusion - 0.25 * (diffusion * k).powi(2)).sqrt();
        Self {
            period: 2.0 * PI / omega,
            damping: 0.5 * diffusion * k * k,
            speeds: Vec::new(),
        }
    }
}

/// Fewest sweeps, from zero forces and in random order, after which a row of so many bodies is rigid: the wall at its
/// other end bears 90 % of the load, and a tenth of its impulse moves the bodies.
pub fn sweeps_needed(bodies: usize) -> Result<usize> {
    let holds = |sweeps: usize| {
        let mut world = row(bodies, IterationOrder::Random { seed: 1 }, sweeps)?;
        world.step()?;
        let bodies = world
            .state()
            .spheres
            .iter()
            .map(|sphere| -sphere.velocity.x);
        let moved = bodies.sum::<f64>() + speed(&world);
        anyhow::Ok(moved.abs() < RIGID * PUSH)
    };
    let (mut low, mut high) = (0, 1);
    while !holds(high)? {
        (low, high) = (high, 2 * high);
    }
    while high - low > 1 {
        let middle = low.midpoint(high);
        if holds(middle)? {
            high = middle;
        } else {
            low = middle;
        }
    }
    Ok(high)
}
