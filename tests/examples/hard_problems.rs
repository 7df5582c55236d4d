//! Prints hard cases of contact dynamics as contact problems, solved to 1e-10: by the policy and by sweeps alone.

use std::error::Error;
use std::time::Instant;
use tribos::cd::WorldMaterials;
use tribos::cd::internals::{Coefficients, Spheres};
use tribos::powder::PowderSimulation;
use tribos::problem::{
    GlobalProblem, ProblemMethod, ReducedProblem, Solution, SolverOptions, SolverStatus, solve,
};
use tribos::run::Simulation;
use tribos::scene::PowderScene;
use tribos_core::contact::ContactFriction;
use tribos_tests::packings::{Smooth, chain, column, dry, first_problem, jammed_box, rough, tower};

const TOLERANCE: f64 = 1e-10;
/// Steps after which a powder ends that is not blocked before.
const MOST_STEPS: u64 = 20_000;

struct Case {
    name: String,
    problem: ReducedProblem,
    /// Normal impulse on the floor, where equilibrium gives it.
    floor: Option<f64>,
}

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| case | contacts | policy | residual | error of the floor's force | time, ms | sweeps alone | time, ms |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for case in cases()? {
        let by_policy = timed(&case.problem, ProblemMethod::Automatic);
        let swept = timed(&case.problem, ProblemMethod::Sweeps);
        let error = case.floor.map_or(String::from("–"), |floor| {
            let largest = by_policy.0.impulses.iter().copied().fold(0.0, f64::max);
            format!("{:.1e}", (largest / floor - 1.0).abs())
        });
        println!(
            "| {} | {} | {} | {:.1e} | {error} | {:.3} | {} | {:.3} |",
            case.name,
            case.problem.contacts(),
            told(&by_policy.0),
            by_policy.0.residual.largest(),
            by_policy.1,
            told(&swept.0),
            swept.1
        );
    }
    Ok(())
}

/// A solution and the time that it took, in ms.
fn timed(problem: &ReducedProblem, method: ProblemMethod) -> (Solution, f64) {
    let settings = SolverOptions {
        tolerance: TOLERANCE,
        method,
        ..SolverOptions::default()
    };
    let start = Instant::now();
    let end = solve(problem, &settings, |_| ());
    (end, start.elapsed().as_secs_f64() * 1e3)
}

fn told(end: &Solution) -> String {
    match end.ending {
        SolverStatus::Converged => format!(
            "{}: {} + {}",
            end.method.name(),
            end.sweeps,
            end.factorisations
        ),
        ending => format!("{} at {:.0e}", ending.name(), end.residual.largest()),
    }
}

fn cases() -> Result<Vec<Case>, Box<dyn Error>> {
    let laws = WorldMaterials::uniform(dry(), rough(0.3, 0.1, 0.1));
    let smooth = WorldMaterials::uniform(dry(), Smooth::none());
    let mut cases = Vec::new();
    for (count, ratio) in [(1, 1e6), (1, 1e8), (10, 1e8), (100, 1e8), (50, 1e3)] {
        let setup = column(count, ratio, laws);
        let masses = f64::from(count as u32) + ratio;
        cases.push(Case {
            name: format!("plate of {ratio:e} spheres on {count}"),
            floor: Some(masses * IMPULSE),
            problem: posed(&first_problem(&setup)?)?,
        });
    }
    for (count, growth) in [(8, 10.0_f64), (12, 3.0), (30, 2.0), (50, 2.0)] {
        let masses: f64 = (0..count).map(|level| growth.powi(level)).sum();
        cases.push(Case {
            name: format!("tower of {count}, each {growth} times as dense"),
            floor: Some(masses * IMPULSE),
            problem: posed(&first_problem(&tower(count as usize, growth, laws))?)?,
        });
    }
    for count in [200, 1000] {
        cases.push(Case {
            name: format!("chain of {count}"),
            floor: Some(count as f64 * IMPULSE),
            problem: posed(&first_problem(&chain(count, laws))?)?,
        });
    }
    for count in [200, 1000] {
        let name = |what: &str| format!("jammed box of {count}, {what}");
        cases.push(Case {
            name: name("frictionless"),
            floor: None,
            problem: posed(&first_problem(&jammed_box(count, 1, smooth))?)?,
        });
        cases.push(Case {
            name: name("all modes"),
            floor: None,
            problem: posed(&first_problem(&jammed_box(count, 1, laws))?)?,
        });
    }
    for (sliding, torsion) in [(0.05, 0.05), (0.1, 0.1), (0.3, 0.1)] {
        cases.push(Case {
            name: format!("blocked powder, friction {sliding}, torsion {torsion}"),
            floor: None,
            problem: powder(sliding, torsion)?.reduced()?,
        });
    }
    Ok(cases)
}

/// Weight of a sphere of radius and density 1 under gravity 1, times a step of 0.02.
const IMPULSE: f64 = 4.0 / 3.0 * std::f64::consts::PI * 0.02;

fn posed<F>(spheres: &Spheres<F>) -> Result<ReducedProblem, Box<dyn Error>>
where
    F: ContactFriction<f64> + Coefficients,
{
    let posed = spheres.to_problem().ok_or("these laws are no data")?;
    Ok(posed.problem.reduced()?)
}

/// The last step of a cohesive powder that has stopped the piston.
fn powder(sliding: f64, torsion: f64) -> Result<GlobalProblem, Box<dyn Error>> {
    let mut compaction = PowderSimulation::new(&PowderScene {
        width: 10.0,
        height: 16.0,
        pressure: 0.02,
        max_steps: MOST_STEPS,
        mu: sliding,
        mu_torsion: torsion,
        ..PowderScene::default()
    })?;
    while compaction.ending().is_none() {
        compaction.step()?;
    }
    compaction
        .problem()
        .ok_or_else(|| "no step was taken".into())
}
