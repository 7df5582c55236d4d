//! Figure 4.6: a deposit before and after its compaction.

use super::exhibit::{Exhibit, claim, statement};
use super::runs::{Case, Effort, Run, Runs, System};
use crate::command::deposit::curve::{Sample, statistics};
use crate::command::run::powder;
use crate::failure::Failure;
use crate::report::page::Claim;
use tribos::powder::Ending;
use tribos::powder::deposit::{Ballistic, Until};

/// Deposits of each system.
const SEEDS: std::ops::Range<u64> = 1..6;
/// Distance of centres at which spheres are captured, in R.
const CAPTURE_RADIUS: f64 = 3.0;
/// A piston this near to the highest sphere, in R, nearly touches it.
const NEAR: f64 = 0.5;

/// One system without torques, at both ends of its compaction.
pub fn figure_4_6(runs: &Runs) -> Result<Exhibit, Failure> {
    let system = match runs.effort() {
        Effort::Quick => System::Small,
        Effort::Full => System::Large,
    };
    let case = Case::new(system, [0.0, 0.0], 1);
    let run = runs.one(&case)?;
    let mut claims = Vec::new();
    for (system, spheres) in [(System::Small, 470.0), (System::Large, 1015.0)] {
        claims.extend(deposit_claims(system, spheres)?);
    }
    claims.extend(end_claims(&run));
    let [before, after] = &run.states;
    let pairs = before.positions.iter().zip(&after.positions);
    Ok(Exhibit {
        heading: "Figure 4.6: ballistic deposit before and after compaction".into(),
        text: vec![format!(
            "The {} system, {} spheres of the first seed, without rolling and torsion friction; \
             the thesis shows the large one and does not say with which torques. Colours are the \
             heights in the deposit; the third picture shows the forces that hold the blocked \
             packing{}.",
            system.name(),
            run.outcome.particles,
            runs.hint("; `--full` takes the large system")
        )],
        film: Some(case.film(runs)?),
        caption: "Initial and final packing, and the final forces.".into(),
        drawing: Box::new(powder::packing(&run.scene, &run.states, &run.outcome)?),
        columns: vec![
            "x_initial",
            "y_initial",
            "z_initial",
            "x_final",
            "y_final",
            "z_final",
        ],
        rows: pairs.map(|(x, y)| [*x, *y].concat()).collect(),
        claims,
    })
}

/// Spheres, porosity and height of five deposits.
fn deposit_claims(system: System, spheres: f64) -> Result<Vec<Claim>, Failure> {
    let [width, height] = system.size();
    let name = system.name();
    let ballistic = Ballistic::new(width, 1.0, CAPTURE_RADIUS).map_err(Failure::run)?;
    let sample = Sample::new(&ballistic, Until::Cut(height), SEEDS)?;
    let (count, scatter) = statistics(&sample.particles);
    let (porosity, of_porosity) = statistics(&sample.porosity);
    let mut tops = Vec::new();
    for seed in SEEDS {
        let deposit = ballistic.grow(Until::Cut(height), seed);
        tops.push(deposit.map_err(Failure::run)?.height);
    }
    let lowest = tops.into_iter().fold(height, f64::min);
    Ok(vec![
        statement(
            &format!("Spheres of the {name} system"),
            &format!("{spheres}"),
            format!("{count:.0}"),
            (spheres - count).abs() < 2.0 * scatter,
        )
        .uncertain(format!("± {scatter:.0}, five deposits")),
        claim(
            &format!("Initial porosity of the {name} system"),
            ("92 %", 0.92),
            porosity,
            0.01,
        )
        .uncertain(format!("± {of_porosity:.1e}, five deposits")),
        statement(
            &format!("Initially the piston of the {name} system nearly touches the highest sphere"),
            &format!("at {height}R"),
            format!("highest points from {lowest:.2}R on"),
            height - lowest < NEAR,
        )
        .uncertain("five deposits"),
    ])
}

/// The final state is blocked.
fn end_claims(run: &Run) -> [Claim; 2] {
    /// More than what is left of a volume exclusion that is solved to 10⁻⁴ and never pushed out.
    const OVERLAP: f64 = 1e-2;
    let (outcome, means) = (&run.outcome, &run.outcome.means);
    [
        statement(
            "The final configuration is blocked: the piston does not move any more, and (not in \
             the thesis) all forces balance",
            "blocked",
            format!(
                "piston moved {:.1e}R in the last window of 200 steps or more; mean net force \
                 {:.1e} of the mean contact force",
                means.moved,
                means.net / means.contact
            ),
            outcome.ending == Some(Ending::Blocked),
        ),
        statement(
            "Spheres are rigid (not in the thesis: how well)",
            "no overlap",
            format!("deepest overlap {:.1e}R", outcome.statistics.max_overlap),
            outcome.statistics.max_overlap < OVERLAP,
        ),
    ]
}
