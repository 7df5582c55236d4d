//! Contact problems as data: solved, or said not to be.

use super::cd_solvers::{cohesive, shaken};
use tribos::cd::WorldMaterials;
use tribos::cd::internals::residual as judged;
use tribos::problem::{
    ProblemMethod, ReducedProblem, Solution, SolverOptions, SolverStatus, residual, solve,
};
use tribos_core::contact::CoupledFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface};
use tribos_tests::packings::{dry, rough};
use tribos_tests::problems::{CHANGES, changed, random};

/// A solution whose ending is what its impulses say.
fn honest(name: &str, problem: &ReducedProblem, settings: &SolverOptions) -> Solution {
    let end = solve(problem, settings, |_| ());
    let judged = residual(problem, &end.impulses);
    assert_eq!(judged, end.residual, "{name}");
    let meets = judged.meets(settings.tolerance);
    assert_eq!(meets, end.ending == SolverStatus::Converged, "{name}");
    end
}

#[test]
fn random_problems_are_solved() {
    for number in 0..500 {
        let (kind, problem) = random(number);
        let problem = problem.reduced().expect("masses are positive");
        let name = format!("{kind} {number}");
        let end = honest(&name, &problem, &SolverOptions::default());
        assert_eq!(
            end.ending,
            SolverStatus::Converged,
            "{name}: {:?}",
            end.residual
        );
    }
}

#[test]
fn changed_problems_are_solved() {
    let settings = SolverOptions::default();
    let (mut unsymmetric, mut unsolved) = (0, Vec::new());
    for number in 0..20 {
        let (kind, problem) = random(number);
        let problem = problem.reduced().expect("masses are positive");
        for (change, what) in CHANGES.iter().enumerate() {
            let name = format!("{kind} {number}, {what}");
            let end = honest(&name, &changed(&problem, change), &settings);
            let is_solved = end.ending == SolverStatus::Converged;
            if what.starts_with("W unsymmetric") {
                // Without full rank such a W need not have a solution: no method solves the eight others.
                unsymmetric += usize::from(is_solved);
            } else if what.starts_with("q changed") && !is_solved {
                unsolved.push((name, end.ending, end.residual));
            } else {
                assert!(is_solved, "{name}: {:?} {:?}", end.ending, end.residual);
            }
        }
    }
    assert!(unsymmetric >= 32, "{unsymmetric} of 40");
    // One jam: large impulses leave contacts that close, and whether others would not is not known.
    let is_known = |name: &str| name.starts_with("wedge 12, ");
    assert!(
        unsolved.iter().all(|(name, ..)| is_known(name)),
        "{unsolved:?}"
    );
}

/// Solutions to 1e-10 of a jammed, shaken box of 30: from no impulses, and from normal ones of 10.
fn solutions(seed: u64) -> [Solution; 2] {
    let laws = WorldMaterials::uniform(cohesive(), rough(0.3, 0.2, 0.2));
    let posed = shaken(30, seed, laws, 0.3).to_problem();
    let problem = posed.expect("thresholds are separate").problem.reduced();
    let problem = problem.expect("masses are positive");
    [0.0, 10.0].map(|pushed| {
        let mut start = vec![0.0; problem.q().len()];
        let normals = start.iter_mut().step_by(problem.layout().size());
        normals.for_each(|r| *r = pushed);
        let settings = SolverOptions {
            tolerance: 1e-10,
            method: ProblemMethod::Sweeps,
            start: Some(start),
            ..SolverOptions::default()
        };
        let end = honest(&format!("box {seed}"), &problem, &settings);
        assert_eq!(end.ending, SolverStatus::Converged, "{:?}", end.residual);
        end
    })
}

fn farthest(a: &[f64], b: &[f64]) -> f64 {
    let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    apart.fold(0.0, f64::max)
}

#[test]
fn a_jammed_box_may_have_one_motion_under_many_forces_or_two_motions() {
    let [rest, pressed] = solutions(1);
    assert!(farthest(&rest.impulses, &pressed.impulses) > 1.0);
    assert!(farthest(&rest.velocities, &pressed.velocities) < 1e-6);
    let [rest, pressed] = solutions(0);
    assert!(farthest(&rest.velocities, &pressed.velocities) > 0.1);
}

#[test]
fn a_box_under_ellipsoids_is_data_and_one_under_exact_surfaces_is_not() {
    let usual = LimitEllipsoid::new(0.3, 0.5, 2.0 / 3.0).expect("valid");
    let usual = CoupledFriction::all(usual, 0.1).expect("valid");
    let mut jammed = shaken(30, 0, WorldMaterials::uniform(dry(), usual), 0.3);
    let posed = jammed.to_problem().expect("an ellipsoid is data");
    let problem = posed.problem.reduced().expect("masses are positive");
    let end = honest("ellipsoids", &problem, &SolverOptions::default());
    assert_eq!(end.ending, SolverStatus::Converged, "{:?}", end.residual);
    jammed.apply_solution(&posed, &end.impulses);
    assert!(judged(&jammed).relative < 1e-6, "{:?}", judged(&jammed));
    let exact = RoundLimitSurface::new(CoulombDisk, 0.3, 0.5).expect("valid");
    let exact = CoupledFriction::all(exact, 0.1).expect("valid");
    let jammed = shaken(30, 0, WorldMaterials::uniform(dry(), exact), 0.3);
    assert!(jammed.to_problem().is_none());
}
