//! Hard cases of contact dynamics: expected result, actual result and cost of each.

use crate::packings::{Rough, accelerated, chain, column, dry, floor, jammed_box};
use crate::packings::{rough, spheres, tower, unequal_pair};
use nalgebra::Vector3;
use tribos::cd::internals::Coefficients;
use tribos::cd::{StepLimits, Wall, World, WorldError, WorldMaterials, WorldSetup};
use tribos::space::PeriodicBox;
use tribos_core::contact::{Attraction, Cohesion, ContactFriction, NormalLaw};

/// Result of one case.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name of the case.
    pub name: String,
    /// Tolerance of the solver, relative to P.
    pub tolerance: f64,
    /// Number of contacts in the last step.
    pub contacts: usize,
    /// Sweeps of the first step, which has no initial forces, and the mean over all other steps.
    pub sweeps: [f64; 2],
    /// Whether every step met the tolerance.
    pub met: bool,
    /// Whether a step was handed over to the solver for general contact problems.
    pub handed_over: bool,
    /// Largest relative residual of any step.
    pub residual: f64,
    /// Sum of the overlaps that the steps may have allowed, in R.
    pub overlap: f64,
    /// The quantity compared with theory.
    pub what: &'static str,
    /// Its error.
    pub error: f64,
}

/// Number of steps of a case.
const STEPS: usize = 20;
/// Tolerances: the usual one and one near rounding.
pub const TOLERANCES: [f64; 2] = [1e-4, 1e-10];

/// A setup, the number of steps, and the error of the result.
type Plan = (
    String,
    WorldSetup<Rough>,
    usize,
    &'static str,
    fn(&World<Rough>) -> f64,
);

/// Runs every case with every tolerance.
pub fn cases() -> Vec<Case> {
    let plans = plans();
    let each = plans
        .iter()
        .flat_map(|plan| TOLERANCES.map(|tolerance| run(plan, tolerance)));
    each.collect()
}

fn run((name, setup, steps, what, error): &Plan, tolerance: f64) -> Case {
    let mut setup = setup.clone();
    setup.solver = accelerated(tolerance);
    let mut world = World::new(setup).expect("the case is valid");
    let mut case = Case {
        name: name.clone(),
        tolerance,
        contacts: 0,
        sweeps: [0.0; 2],
        met: true,
        handed_over: false,
        residual: 0.0,
        overlap: 0.0,
        what,
        error: 0.0,
    };
    let smallest = world
        .setup()
        .radii
        .iter()
        .fold(f64::INFINITY, |a, b| a.min(*b));
    for step in 0..*steps {
        let report = world.step().expect("the case can step");
        let sweeps = report.iterations.sweeps as f64;
        if step == 0 {
            case.sweeps[0] = sweeps;
        } else {
            case.sweeps[1] += sweeps / (*steps - 1) as f64;
        }
        case.met &= report.is_met();
        case.handed_over |= report.handed_over;
        case.contacts = report.contacts;
        // A NaN must not hide behind the largest number.
        assert!(report.residual.relative.is_finite(), "{name}");
        case.residual = case.residual.max(report.residual.relative);
        case.overlap += report.residual.penetration * report.dt / smallest;
    }
    case.error = error(&world);
    case
}

fn plans() -> Vec<Plan> {
    let laws = WorldMaterials::uniform(dry(), rough(0.3, 0.1, 0.1));
    let mut plans: Vec<Plan> = vec![
        (
            String::from("chain of 200 under its weight"),
            chain(200, laws),
            STEPS,
            "force on the floor",
            floor_force,
        ),
        (
            String::from("column of 50, plate of 1e3 spheres"),
            column(50, 1e3, laws),
            STEPS,
            "force on the floor",
            floor_force,
        ),
        (
            String::from("one sphere, plate of 1e6 spheres"),
            column(1, 1e6, laws),
            STEPS,
            "force on the floor",
            floor_force,
        ),
        (
            String::from("two spheres, the upper 1e6 times denser"),
            tower(2, 1e6, laws),
            STEPS,
            "force on the floor",
            floor_force,
        ),
        (
            String::from("tower of 12, each 3 times denser"),
            tower(12, 3.0, laws),
            STEPS,
            "force on the floor",
            floor_force,
        ),
        (
            String::from("jammed box of 200, 3.5 contacts each"),
            jammed_box(200, 1, laws),
            STEPS,
            "way of the piston, R",
            piston_way,
        ),
        (
            String::from("pull of exactly F_coh"),
            hanging(),
            500,
            "way down, R",
            way_down,
        ),
        (
            String::from("push of exactly mu N"),
            at_threshold(),
            500,
            "speed after 10",
            speed,
        ),
        (
            String::from("pair with an overlap of 0.1"),
            overlapping(),
            STEPS,
            "change of the overlap, R",
            overlap_change,
        ),
    ];
    for ratio in [1e3, 1e6] {
        let name = format!("sliding on a sphere of radius {ratio:.0e}");
        plans.push((
            name,
            slider(ratio),
            300,
            "speed after sliding and rolling",
            rolling_speed,
        ));
    }
    for scale in [1e-30, 1e30] {
        let name = format!("chain of 20, radius {scale:.0e}");
        plans.push((
            name,
            scaled(scale),
            STEPS,
            "force on the floor",
            floor_force,
        ));
    }
    plans
}

/// Force on the floor compared with the sum of weights and loads, relative.
fn floor_force(world: &World<Rough>) -> f64 {
    let (state, setup) = (world.state(), world.setup());
    let weight =
        |sphere: &tribos_core::contact::SphereBody<f64>| setup.gravity.norm() / sphere.inv_mass;
    let wanted: f64 = state.spheres.iter().map(weight).sum();
    let loads: f64 = state.walls.iter().map(|wall| wall.force).sum();
    let floor = state.memory.forces[1]
        .iter()
        .find(|(bodies, _)| bodies[1] == 0);
    floor.map_or(f64::NAN, |(_, force)| {
        (force.normal / (wanted + loads) - 1.0).abs()
    })
}

fn piston_way(world: &World<Rough>) -> f64 {
    let last = world.state().walls.len() - 1;
    (world.state().walls[last].place - world.setup().walls[last].place).abs()
}

fn way_down(world: &World<Rough>) -> f64 {
    (world.state().positions[0].z + 1.0).abs()
}

fn speed(world: &World<Rough>) -> f64 {
    world.state().spheres[0].velocity.norm()
}

fn overlap_change(world: &World<Rough>) -> f64 {
    let apart = |x: &[Vector3<f64>]| (x[1] - x[0]).norm();
    (apart(&world.state().positions) - apart(&world.setup().positions)).abs()
}

/// Pull and coefficients of the slider, and its initial speed.
const SLIDER: (f64, [f64; 2], f64) = (4.0, [0.3, 0.05], 1.0);

/// A cohesive sphere that slides on a large one, then rolls against rolling resistance.
fn slider(ratio: f64) -> WorldSetup<Rough> {
    let (strength, [mu, mu_rolling], speed) = SLIDER;
    let cohesion = Cohesion::new(strength, 0.1, Attraction::Pull).expect("cohesion is valid");
    let normal = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
    let mut setup = unequal_pair(
        ratio,
        WorldMaterials::uniform(normal, rough(mu, mu_rolling, 0.0)),
    );
    setup.spheres[1].velocity.x = speed;
    setup.step_limits = StepLimits {
        longest: 0.01,
        motion: 0.1,
    };
    setup
}

/// Speed of the slider compared with that on a plane, relative.
fn rolling_speed(world: &World<Rough>) -> f64 {
    let (strength, [mu, mu_rolling], speed) = SLIDER;
    let g = strength * world.setup().spheres[1].inv_mass;
    // Friction mu g decelerates it and spins it up at 5/2 (mu − mu_t) g until it rolls.
    let rolls = speed / (g * (mu + 2.5 * (mu - mu_rolling)));
    let wanted = speed - mu * g * rolls - 5.0 / 7.0 * mu_rolling * g * (world.state().time - rolls);
    (world.state().spheres[1].velocity.norm() / wanted - 1.0).abs()
}

/// A sphere under a ceiling whose cohesion equals its weight.
fn hanging() -> WorldSetup<Rough> {
    let mut setup = spheres(
        vec![-Vector3::z()],
        WorldMaterials::uniform(dry(), rough(0.3, 0.1, 0.1)),
    );
    let weight = 1.0 / setup.spheres[0].inv_mass;
    let cohesion = Cohesion::new(weight, 0.01, Attraction::Pull).expect("cohesion is valid");
    let normal = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
    setup.laws.pairs.normal = normal;
    setup.laws.walls.normal = normal;
    setup.walls = vec![Wall::fixed(-Vector3::z(), 0.0)];
    setup.gravity = -Vector3::z();
    setup
}

/// A sphere that cannot roll, on a slope whose tangent is its coefficient.
fn at_threshold() -> WorldSetup<Rough> {
    WorldSetup {
        gravity: Vector3::new(0.5, 0.0, -1.0),
        ..chain(1, WorldMaterials::uniform(dry(), rough(0.5, 4.0, 0.0)))
    }
}

/// Two spheres that overlap by 0.1, pressed against the floor.
fn overlapping() -> WorldSetup<Rough> {
    let mut setup = chain(2, WorldMaterials::uniform(dry(), rough(0.3, 0.1, 0.1)));
    setup.positions[1].z -= 0.1;
    setup
}

/// A chain of another size: lengths and gravity are multiplied by `scale`.
fn scaled(scale: f64) -> WorldSetup<Rough> {
    let mut setup = chain(20, WorldMaterials::uniform(dry(), rough(0.3, 0.1, 0.1)));
    setup.positions.iter_mut().for_each(|x| *x *= scale);
    setup.radii.fill(scale);
    setup.spheres.fill(tribos::cd::solid(scale, 1.0));
    setup.gravity *= scale;
    setup.step_limits.motion *= scale;
    setup
}

/// Invalid input, and the error of a world at construction or in its first step; `None` if there is none.
pub fn refusals() -> Vec<(&'static str, Option<WorldError>)> {
    let base = || chain(2, WorldMaterials::uniform(dry(), rough(0.3, 0.1, 0.1)));
    let with = |change: fn(&mut WorldSetup<Rough>)| {
        let mut setup = base();
        change(&mut setup);
        first_step(setup)
    };
    let mut crowded = base();
    crowded.space = PeriodicBox::new([Some(3.0), None, None]).expect("the box is valid");
    vec![
        ("longest step 0", with(|s| s.step_limits.longest = 0.0)),
        (
            "longest step NaN",
            with(|s| s.step_limits.longest = f64::NAN),
        ),
        ("motion 0", with(|s| s.step_limits.motion = 0.0)),
        (
            "coincident centres",
            with(|s| s.positions[1] = s.positions[0]),
        ),
        ("centre in a wall", with(|s| s.positions[0].z = 0.0)),
        ("position NaN", with(|s| s.positions[1].x = f64::NAN)),
        ("gravity NaN", with(|s| s.gravity.z = f64::NAN)),
        (
            "gravity infinite",
            with(|s| s.gravity.z = f64::NEG_INFINITY),
        ),
        ("gravity 1e300", with(|s| s.gravity.z = -1e300)),
        (
            "wall's load infinite",
            with(|s| s.walls[0].force = f64::INFINITY),
        ),
        (
            "wall's normal of length 2",
            with(|s| s.walls[0].outward *= 2.0),
        ),
        ("radius 0", with(|s| s.radii[0] = 0.0)),
        ("radius NaN", with(|s| s.radii[0] = f64::NAN)),
        ("a radius missing", with(|s| s.radii.truncate(1))),
        ("speed of stillness NaN", with(|s| s.sleep_speed = f64::NAN)),
        ("velocity 1e300", with(|s| s.spheres[1].velocity.z = -1e300)),
        ("pull of 1e30 across a gap", with(far_pull)),
        ("lengths of 1e-60", first_step(scaled(1e-60))),
        ("lengths of 1e60", first_step(scaled(1e60))),
        ("lengths of 1e-300", first_step(scaled(1e-300))),
        ("lengths of 1e300", first_step(scaled(1e300))),
        ("period too short for two spheres", first_step(crowded)),
    ]
}

/// A pull for which no step is short enough.
fn far_pull(setup: &mut WorldSetup<Rough>) {
    let cohesion = Cohesion::new(1e30, 1.0, Attraction::Pull).expect("cohesion is valid");
    let normal = NormalLaw::new(cohesion, 0.0).expect("the law is valid");
    (setup.laws.pairs.normal, setup.laws.walls.normal) = (normal, normal);
    setup.positions[1].z += 0.5;
    setup.walls = vec![floor()];
}

fn first_step<F: ContactFriction<f64> + Coefficients>(setup: WorldSetup<F>) -> Option<WorldError> {
    match World::new(setup) {
        Ok(mut world) => world.step().err(),
        Err(error) => Some(error),
    }
}
