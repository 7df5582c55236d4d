//! Stopping rule for the impulses of a round of impacts: their tolerance, or rounding.
//!
//! Impulses of late rounds may be small compared with the momenta of the bodies. Each sweep then
//! changes them by the rounding of the bodies' velocities without end, and no tolerance relative to
//! the impulse can be met.

use super::gauss_seidel::{IterationOrder, Iterations, StopRule, Sweeper, solve};
use super::operator::{NoMonitor, Operator, Visit};
use super::spheres::{Link, Spheres};
use nalgebra::Vector3;
use tribos_core::contact::{ContactFriction, ContactModes};

/// Relative change of the impulses in a sweep at which a part of a round is solved.
pub(super) const TOLERANCE: f64 = 1e-13;
/// Rounding of a velocity after several impulses have been added, in units of ε: a sweep changes
/// impulses by up to 5.
const ROUNDING: f64 = 16.0;
/// Number of sweeps between two checks against rounding, each of which costs about a sweep.
const EACH: usize = 20;

/// Sweeps until every contact has converged, for at most `most` sweeps.
pub(super) fn settle<F: ContactFriction<f64>>(problem: &mut Spheres<F>, most: usize) -> Iterations {
    let mut sweeper = Sweeper::new(IterationOrder::Fixed, 0);
    let mut sweeps = 0;
    let mut met = false;
    while sweeps < most && !met {
        let some = EACH.min(most - sweeps);
        let iterations = solve(problem, &mut sweeper, StopRule::Local(TOLERANCE), some);
        sweeps += iterations.sweeps;
        met = iterations.met;
        if !met && sweeps < most {
            met = rests(problem);
            sweeps += 1;
        }
    }
    Iterations { sweeps, met }
}

/// Whether one more sweep changes every impulse by no more than its tolerance and rounding.
pub(super) fn rests<F: ContactFriction<f64>>(problem: &mut Spheres<F>) -> bool {
    let before: Vec<_> = problem
        .links()
        .map(|link| *link.contact.impulse())
        .collect();
    problem.sweep(Visit::Forward, &mut NoMonitor);
    let spheres = |link: &Link<F::Modes>| {
        let bodies = link.bodies.map(|body| &problem.spheres[body as usize]);
        let velocities = bodies.map(|sphere| [sphere.velocity, sphere.spin]);
        rounding(link, velocities)
    };
    let walls = |wall: usize, link: &Link<F::Modes>| {
        let [a, b] = link.bodies.map(|body| body as usize);
        let sphere = &problem.spheres[a];
        let moves = problem.surface(wall).map(|at| [at.velocity, at.spin]);
        let plate = || [problem.plates[b].velocity, Vector3::zeros()];
        let velocities = [[sphere.velocity, sphere.spin], moves.unwrap_or_else(plate)];
        rounding(link, velocities)
    };
    let pairs = problem.pairs.iter().map(|link| (link, spheres(&link)));
    let at_walls = problem.walls.iter().enumerate();
    let walls = at_walls.map(|(wall, link)| (*link, walls(wall, link)));
    pairs
        .chain(walls)
        .zip(before)
        .all(|((link, rounding), old)| {
            let contact = &link.contact;
            let change = contact.impulse().minus(&old);
            let change = change
                .dot_with_lever(&change, contact.effective_radius())
                .sqrt();
            // NaN has not converged.
            change <= TOLERANCE * contact.bound() + rounding
        })
}

/// Effect of the rounding of two bodies' velocities and spins on the impulse between them, with torques
/// counted as forces at the lever.
fn rounding<M: ContactModes<f64>>(link: &Link<M>, velocities: [[Vector3<f64>; 2]; 2]) -> f64 {
    let (block, lever) = (link.contact.block(), link.contact.effective_radius());
    let [speed, spin] = [0, 1].map(|of| velocities.iter().map(|body| body[of].norm()).sum::<f64>());
    let mass = block.mass_normal.max(block.mass_sliding);
    ROUNDING * f64::EPSILON * (mass * (speed + lever * spin) + block.inertia * spin / lever)
}

#[cfg(test)]
mod tests {
    use crate::cd::internals::Coefficients;
    use crate::cd::{
        ContactSolver, SolverMethod, StepLimits, StepReport, Wall, World, WorldMaterials,
        WorldSetup, solid,
    };
    use nalgebra::Vector3;
    use tribos_base::space::PeriodicBox;
    use tribos_core::contact::{
        Cohesion, ContactFriction, IndependentFriction, NormalLaw, SphereBody,
    };

    /// One step of a column of touching spheres that falls on the floor, the highest fastest, while sliding
    /// at speed 1: all contacts impact at once. Each part of a round is limited to this number of sweeps.
    fn step<F: ContactFriction<f64> + Coefficients>(
        count: usize,
        friction: F,
        most_sweeps: usize,
    ) -> Result<StepReport, Box<dyn std::error::Error>> {
        let up = Vector3::z();
        let thrown = |level: usize| SphereBody {
            velocity: Vector3::x() - up * (level + 1) as f64,
            ..solid(1.0, 1.0)
        };
        let mut world = World::new(WorldSetup {
            space: PeriodicBox::OPEN,
            positions: (0..count)
                .map(|level| up * (1.0 + 2.0 * level as f64))
                .collect(),
            radii: vec![1.0; count],
            spheres: (0..count).map(thrown).collect(),
            mesh: None,
            walls: vec![Wall::fixed(up, 0.0)],
            laws: WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 1.0)?, friction),
            mixture: None,
            gravity: Vector3::zeros(),
            shear_rate: 0.0,
            cell: None,
            step_limits: StepLimits {
                longest: 0.01,
                motion: 0.1,
            },
            solver: ContactSolver {
                method: SolverMethod::Accelerated { tolerance: 1e-9 },
                most_sweeps: 100,
                warm_start: 1.0,
            },
            sleep_speed: 0.0,
        })?;
        world.impacts.most_sweeps = most_sweeps;
        Ok(world.step()?)
    }

    #[test]
    fn parts_that_use_up_their_sweeps_are_counted() -> Result<(), Box<dyn std::error::Error>> {
        let smooth: IndependentFriction<f64, _> = IndependentFriction::none();
        let rough = IndependentFriction::sliding(0.3)?;
        for (count, most) in [(1, 1000), (5, 1000)] {
            let reports = [step(count, smooth, most)?, step(count, rough, most)?];
            assert!(
                reports
                    .iter()
                    .all(|report| report.is_met() && report.impacts > 0)
            );
            assert_eq!(reports.map(|report| report.impacts_unmet), [0, 0]);
        }
        // A reflection of five spheres takes more than two sweeps, and has no friction here.
        let reflected = step(5, smooth, 2)?;
        assert!(reflected.impacts_unmet > 0 && !reflected.is_met() && reflected.iterations.met);
        // A single impact is reflected in one sweep; friction needs a second one to detect convergence.
        let rubbed = step(1, rough, 1)?;
        assert_eq!((rubbed.impact_rounds, rubbed.impacts_unmet), (1, 1));
        assert!(!rubbed.is_met() && rubbed.iterations.met);
        Ok(())
    }
}
