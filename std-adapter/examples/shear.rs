//! Steady shear of spheres with friction at constant volume: stress ratio μ and solid fraction φ over the inertial
//! number I = rate · d √(ρ/P).
//!
//! Arguments: sliding coefficient, restitution, number of spheres, strain measured, solid fractions.

use std::f64::consts::PI;
use tribos::cd::internals::Coefficients;
use tribos::cd::{
    ContactSolver, SolverMethod, StepLimits, World, WorldMaterials, WorldSetup, solid,
};
use tribos::kernel::contact::{Cohesion, ContactFriction, IndependentFriction, NormalLaw};
use tribos::kernel::nalgebra::{Matrix3, Vector3};
use tribos::random::Random;
use tribos::space::{PeriodicBox, pairs::neighbours};

type Failure = Box<dyn std::error::Error>;

/// Radii are uniform within this distance from 1: equal spheres would order.
const SPREAD: f64 = 0.1;
/// Mean diameter.
const DIAMETER: f64 = 2.0;
/// Rate; rigid spheres have no time scale of their own, so that any is as good.
const RATE: f64 = 1.0;
/// Strain before the measurement.
const START: f64 = 3.0;
/// Parts of the measurement, of which the scatter is told.
const PARTS: usize = 5;

fn main() -> Result<(), Failure> {
    let given: Result<Vec<f64>, _> = std::env::args().skip(1).map(|a| a.parse()).collect();
    let given = given?;
    let value = |at: usize, default: f64| given.get(at).copied().unwrap_or(default);
    let (mu, restitution) = (value(0, 0.5), value(1, 0.5));
    let (count, strain) = (value(2, 200.0) as usize, value(3, 5.0));
    let fractions = given.get(4..).filter(|given| !given.is_empty());

    println!("sliding {mu}, restitution {restitution}, {count} spheres, strain {strain}");
    println!("  phi       I      mu   +-     P/(rho d^2 rate^2)  contacts  unmet  residual");
    for &fraction in fractions.unwrap_or(&[0.50, 0.56]) {
        let row = measure(mu, restitution, count, strain, fraction)?;
        println!("{row}");
    }
    Ok(())
}

/// One line of the table.
fn measure(mu: f64, e: f64, count: usize, strain: f64, phi: f64) -> Result<String, Failure> {
    let laws = WorldMaterials::uniform(
        NormalLaw::new(Cohesion::NONE, e)?,
        IndependentFriction::sliding(mu)?,
    );
    let mut world = World::new(packed(laws, count, phi)?)?;
    let mut parts = [Matrix3::zeros(); PARTS];
    let (mut steps, mut unmet, mut contacts, mut residual) = (0, 0, 0, 0.0_f64);
    while RATE * world.state().time < START {
        world.step()?;
    }
    let start = world.state().time;
    for (part, sum) in parts.iter_mut().enumerate() {
        let begun = world.state().time;
        while RATE * (world.state().time - start) < strain * (part + 1) as f64 / PARTS as f64 {
            let report = world.step()?;
            *sum += momentum_flux(&world, report.dt);
            steps += 1;
            unmet += usize::from(!report.is_met());
            contacts += report.contacts;
            residual = residual.max(report.residual.relative);
        }
        *sum /= world.state().time - begun;
    }
    let ratios = parts.map(|stress| -stress.m13 / (stress.trace() / 3.0));
    let mean = ratios.iter().sum::<f64>() / PARTS as f64;
    let scatter = ratios.iter().map(|r| (r - mean) * (r - mean)).sum::<f64>();
    let error = (scatter / (PARTS * (PARTS - 1)) as f64).sqrt();
    let pressure = parts.iter().map(|s| s.trace() / 3.0).sum::<f64>() / PARTS as f64;
    let inertial = RATE * DIAMETER / pressure.sqrt();
    let scaled = pressure / (DIAMETER * RATE * DIAMETER * RATE);
    let per_step = contacts as f64 / steps as f64;
    Ok(format!(
        "{phi:.3} {inertial:9.4} {mean:7.4} {error:.4} {scaled:14.3} {per_step:14.1} {unmet:4}/{steps} {residual:.0e}"
    ))
}

/// Momentum carried in a step through the cell by contacts and by the spheres' own motions, over its
/// volume: stress times step, positive for compression.
fn momentum_flux<F: ContactFriction<f64> + Coefficients>(
    world: &World<F>,
    dt: f64,
) -> Matrix3<f64> {
    let sides = world
        .setup()
        .space
        .lengths()
        .map(|side| side.unwrap_or(1.0));
    let mut flux = Matrix3::zeros();
    for link in world.problem().pairs.iter() {
        let (contact, normal) = (&link.contact, link.contact.normal());
        let [a, b] = contact.centre_distances();
        flux += contact.impulse().linear(normal) * (normal * (a + b)).transpose();
    }
    let state = world.state();
    for (sphere, x) in state.spheres.iter().zip(&state.positions) {
        let flow = Vector3::x() * (RATE * (x.z - 0.5 * sides[2]));
        let own = sphere.velocity - flow;
        flux += own * own.transpose() * (dt / sphere.inv_mass);
    }
    flux / sides.iter().product::<f64>()
}

/// Random spheres in a cube of this solid fraction, pushed apart until they hardly overlap.
fn packed<F>(
    laws: WorldMaterials<F>,
    count: usize,
    fraction: f64,
) -> Result<WorldSetup<F>, Failure> {
    let mut random = Random::new(1, 0);
    let radii: Vec<_> = (0..count)
        .map(|_| 1.0 + SPREAD * (2.0 * random.unit() - 1.0))
        .collect();
    let solids: f64 = radii.iter().map(|r| 4.0 / 3.0 * PI * r * r * r).sum();
    let side = libm::cbrt(solids / fraction);
    let space = PeriodicBox::new([Some(side); 3])?;
    let mut place = || side * random.unit();
    let mut centres: Vec<_> = (0..count)
        .map(|_| Vector3::new(place(), place(), place()))
        .collect();
    for _ in 0..10_000 {
        let mut deepest = 0.0_f64;
        for [a, b] in neighbours(&space, &centres, &radii, 0.0)? {
            let [a, b] = [a as usize, b as usize];
            let way = space.displacement(&centres[a], &centres[b]);
            let overlap = radii[a] + radii[b] - way.norm();
            deepest = deepest.max(overlap);
            let push = way.normalize() * (0.3 * overlap + 1e-4);
            centres[a] -= push;
            centres[b] += push;
        }
        if deepest < 1e-3 {
            break;
        }
    }
    let mut setup = WorldSetup::new(laws);
    setup.space = space;
    for (x, &r) in centres.iter().zip(&radii) {
        setup = setup.sphere(space.wrap(x), r, solid(r, 1.0));
    }
    setup.step_limits = StepLimits {
        longest: 0.02 / RATE,
        motion: 0.05,
    };
    setup.solver = ContactSolver {
        method: SolverMethod::Accelerated { tolerance: 1e-4 },
        most_sweeps: 2_000,
        warm_start: 1.0,
    };
    Ok(setup.sheared(RATE))
}
