//! Packings of spheres for contact dynamics: chains, towers, plates, pairs and a jammed box.
//!
//! Units: radius 1 and density 1 unless stated otherwise. Every packing is bit-reproducible.

use nalgebra::Vector3;
use tribos::cd::internals::{Coefficients, Spheres};
use tribos::cd::{
    ContactSolver, SolverMethod, StepLimits, Wall, World, WorldError, WorldMaterials, WorldSetup,
    solid,
};
use tribos::random::Random;
use tribos::space::{PeriodicBox, pairs::Cells};
use tribos_core::contact::{AllModes, Cohesion, ContactFriction, Frictionless};
use tribos_core::contact::{IndependentFriction, NormalLaw};

/// Friction coefficients of all modes.
pub type Rough = IndependentFriction<f64, AllModes>;
/// Zero friction in all modes.
pub type Smooth = IndependentFriction<f64, Frictionless>;

/// Sliding, rolling and torsion coefficients.
pub fn rough(mu: f64, mu_rolling: f64, mu_torsion: f64) -> Rough {
    IndependentFriction::all(mu, mu_rolling, mu_torsion).expect("coefficients are valid")
}

/// Hard contact without cohesion and restitution.
pub fn dry() -> NormalLaw<f64> {
    NormalLaw::new(Cohesion::NONE, 0.0).expect("the law is valid")
}

/// Sweeps with momentum to a tolerance, starting from the last step's forces.
pub fn accelerated(tolerance: f64) -> ContactSolver {
    ContactSolver {
        method: SolverMethod::Accelerated { tolerance },
        most_sweeps: 5_000,
        warm_start: 1.0,
    }
}

/// Solver of the packings below, in units of P: far more accurate than the tests require.
const TOLERANCE: f64 = 1e-10;
/// Step limits of the packings below.
const STEP_LIMITS: StepLimits = StepLimits {
    longest: 0.02,
    motion: 0.02,
};

/// Spheres of radius 1 at rest in open space, without gravity and walls.
pub fn spheres<F>(positions: Vec<Vector3<f64>>, laws: WorldMaterials<F>) -> WorldSetup<F> {
    let count = positions.len();
    WorldSetup {
        space: PeriodicBox::OPEN,
        positions,
        radii: vec![1.0; count],
        spheres: vec![solid(1.0, 1.0); count],
        walls: Vec::new(),
        laws,
        gravity: Vector3::zeros(),
        shear_rate: 0.0,
        cell: None,
        mixture: None,
        mesh: None,
        step_limits: STEP_LIMITS,
        solver: accelerated(TOLERANCE),
        sleep_speed: 0.0,
    }
}

/// The plane z = 0 with the spheres above it.
pub fn floor() -> Wall {
    Wall::fixed(Vector3::z(), 0.0)
}

/// A vertical chain on the floor under its own weight, with gravity 1 and gaps of 0.
pub fn chain<F>(count: usize, laws: WorldMaterials<F>) -> WorldSetup<F> {
    let height = |level: usize| Vector3::new(0.0, 0.0, 1.0 + 2.0 * level as f64);
    WorldSetup {
        walls: vec![floor()],
        gravity: Vector3::new(0.0, 0.0, -1.0),
        ..spheres((0..count).map(height).collect(), laws)
    }
}

/// A chain under a plate that is `ratio` times as heavy as one sphere.
pub fn column<F>(count: usize, ratio: f64, laws: WorldMaterials<F>) -> WorldSetup<F> {
    let mass = ratio / solid(1.0, 1.0).inv_mass;
    let mut setup = chain(count, laws);
    // Gravity 1 acts only on spheres, so the plate's weight is a load.
    let plate = Wall::piston(-Vector3::z(), -2.0 * count as f64, mass, mass);
    setup.walls.push(plate);
    setup
}

/// A chain in which every sphere is `growth` times as dense as the one below.
pub fn tower<F>(count: usize, growth: f64, laws: WorldMaterials<F>) -> WorldSetup<F> {
    let mut setup = chain(count, laws);
    for (level, sphere) in setup.spheres.iter_mut().enumerate() {
        *sphere = solid(1.0, growth.powi(level as i32));
    }
    setup
}

/// A row along x whose first sphere is a `gap` away from a wall; the spheres touch each other.
pub fn row<F>(count: usize, gap: f64, laws: WorldMaterials<F>) -> WorldSetup<F> {
    let place = |index: usize| Vector3::new(1.0 + gap + 2.0 * index as f64, 0.0, 0.0);
    WorldSetup {
        walls: vec![Wall::fixed(Vector3::x(), 0.0)],
        ..spheres((0..count).map(place).collect(), laws)
    }
}

/// A sphere of radius 1 on top of one of radius `ratio`, both of density 1, touching.
pub fn unequal_pair<F>(ratio: f64, laws: WorldMaterials<F>) -> WorldSetup<F> {
    let mut setup = spheres(
        vec![Vector3::zeros(), Vector3::new(0.0, 0.0, ratio + 1.0)],
        laws,
    );
    setup.radii[0] = ratio;
    setup.spheres[0] = solid(ratio, 1.0);
    setup
}

/// Volume fraction of the initial random positions: dilute enough to relax in a few rounds.
const LOOSE: f64 = 0.4;
/// Factor by which the box shrinks in one stage.
const SHRINK: f64 = 0.998;
/// Mean overlap per sphere, in radii, below which a box is relaxed.
const RELAXED: f64 = 1e-4;
/// Largest number of relaxation rounds after each shrinking.
const ROUNDS: usize = 1000;
/// Contacts per sphere at which the box is finished; 3 would give as many forces as translations.
const CONTACTS: f64 = 3.5;
/// Fraction of an overlap removed in a round: below 1/2, because a body with a dozen neighbours sums them.
const RELAX: f64 = 0.2;

/// A jammed cube of `count` equal spheres between five walls and a piston (the last wall) with
/// pressure 1 and 3.5 contacts per sphere: hyperstatic even without friction.
///
/// Random positions are relaxed as soft spheres while the box shrinks, until there are enough contacts.
/// Overlaps of about 1e-2 remain, which rigid contacts treat as gaps of 0.
pub fn jammed_box<F>(count: usize, seed: u64, laws: WorldMaterials<F>) -> WorldSetup<F> {
    let mut random = Random::new(seed, 0);
    let volume = 4.0 / 3.0 * std::f64::consts::PI * count as f64;
    let mut side = (volume / LOOSE).cbrt();
    let mut place = || 1.0 + (side - 2.0) * random.unit();
    let mut positions: Vec<_> = (0..count)
        .map(|_| Vector3::new(place(), place(), place()))
        .collect();
    let mut cells = Cells::default();
    while (relax(&mut positions, side, &mut cells) as f64) < CONTACTS * count as f64 {
        side *= SHRINK;
        positions.iter_mut().for_each(|x| *x *= SHRINK);
    }
    let load = side * side;
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let low = axes.map(|axis| Wall::fixed(axis, 0.0));
    let high = [axes[0], axes[1]].map(|axis| Wall::fixed(-axis, -side));
    let piston = Wall::piston(-axes[2], -side, volume, load);
    WorldSetup {
        walls: low.into_iter().chain(high).chain([piston]).collect(),
        ..spheres(positions, laws)
    }
}

/// Moves overlapping soft spheres apart; returns the number of remaining contacts.
fn relax(positions: &mut [Vector3<f64>], side: f64, cells: &mut Cells) -> usize {
    let radii = vec![1.0; positions.len()];
    let mut contacts = 0;
    for _ in 0..ROUNDS {
        let mut moves = vec![Vector3::zeros(); positions.len()];
        let mut overlap = 0.0;
        let pairs = cells.find(&PeriodicBox::OPEN, positions, &radii, 0.0);
        let pairs = pairs.expect("soft spheres stay finite");
        contacts = pairs.len();
        for &[a, b] in pairs {
            let [a, b] = [a as usize, b as usize];
            let apart = positions[b] - positions[a];
            let depth = 2.0 - apart.norm();
            let push = apart.normalize() * (RELAX * depth);
            moves[a] -= push;
            moves[b] += push;
            overlap += depth;
        }
        for (x, by) in positions.iter().zip(&mut moves) {
            for axis in 0..3 {
                let depths = [1.0 - x[axis], x[axis] - (side - 1.0)].map(|depth| depth.max(0.0));
                by[axis] += 2.0 * RELAX * (depths[0] - depths[1]);
                overlap += depths[0] + depths[1];
                contacts += depths.iter().filter(|depth| **depth > 0.0).count();
            }
        }
        if overlap < RELAXED * positions.len() as f64 {
            return 0;
        }
        positions
            .iter_mut()
            .zip(&moves)
            .for_each(|(x, by)| *x += by);
    }
    contacts
}

/// The unsolved contact problem of the first step: free velocities and zero impulses.
pub fn first_problem<F>(setup: &WorldSetup<F>) -> Result<Spheres<F>, WorldError>
where
    F: ContactFriction<f64> + Coefficients,
{
    let mut unsolved = setup.clone();
    unsolved.solver.most_sweeps = 0;
    unsolved.solver.warm_start = 0.0;
    let mut world = World::new(unsolved)?;
    world.step()?;
    Ok(world.problem().clone())
}
