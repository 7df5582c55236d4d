//! Figure 4.6: a deposit before and after its compaction.

use crate::exhibit::Exhibit;
use crate::runs::{Case, Effort, Run, Runs, System};
use crate::text::Text;
use anyhow::Result;
use tribos::powder::PowderStopReason;
use tribos::powder::deposit::{Ballistic, DepositTarget};
use tribos_report::claim::Claim;
use tribos_report::runs::powder::packing;

const TEXT: Text = Text(include_str!("figure-4.6.md"));

/// Deposits of each system.
const SEEDS: std::ops::Range<u64> = 1..6;
/// Distance of centres at which spheres are captured, in R.
const CAPTURE_RADIUS: f64 = 3.0;
/// A piston this near to the highest sphere, in R, nearly touches it.
const NEAR: f64 = 0.5;

/// One system without torques, at both ends of its compaction.
pub fn figure_4_6(runs: &Runs) -> Result<Exhibit> {
    let system = match runs.effort() {
        Effort::Quick => System::Small,
        Effort::Full => System::Large,
    };
    let case = Case::new(system, [0.0, 0.0], 1);
    let run = runs.one(&case)?;
    let mut claims = Vec::new();
    for (id, system) in [
        ("small-piston", System::Small),
        ("large-piston", System::Large),
    ] {
        claims.push(piston_claim(id, system)?);
    }
    claims.extend(end_claims(&run));
    let [before, after] = &run.states;
    let pairs = before.positions.iter().zip(&after.positions);
    Ok(Exhibit {
        film: Some(case.film(runs)?),
        seeds: SEEDS.collect(),
        ..Exhibit::new(
            TEXT.prose_of(runs.effort())
                .with("system", system.name())
                .with("spheres", run.outcome.particles),
            packing(&run.scene, &run.states, &run.outcome)?,
            &[
                "x_initial",
                "y_initial",
                "z_initial",
                "x_final",
                "y_final",
                "z_final",
            ],
            pairs.map(|(x, y)| [*x, *y].concat()).collect(),
            claims,
        )
    })
}

/// Heights of five deposits; figure 4.5 has their spheres and porosities.
fn piston_claim(id: &str, system: System) -> Result<Claim> {
    let [width, height] = system.size();
    let ballistic = Ballistic::new(width, 1.0, CAPTURE_RADIUS)?;
    let mut lowest = height;
    for seed in SEEDS {
        let deposit = ballistic.grow(DepositTarget::Cut(height), seed);
        lowest = lowest.min(deposit?.height);
    }
    let claim = Claim::trend(
        TEXT.said(id).with("height", height),
        format!("highest points at {lowest:.2}R and above"),
        height - lowest < NEAR,
    );
    Ok(claim.uncertain("five deposits"))
}

/// The final state is blocked.
fn end_claims(run: &Run) -> [Claim; 2] {
    /// More than what is left of a volume exclusion that is solved to 10⁻⁴ and never pushed out.
    const OVERLAP: f64 = 1e-2;
    let (outcome, balance) = (&run.outcome, &run.outcome.balance);
    [
        Claim::trend(
            TEXT.said("blocked"),
            format!(
                "piston moved {:.1e}R in the last window of 200 steps or more; mean net force \
                 {:.1e} of the mean contact force",
                balance.piston_moved, balance.net_force
            ),
            outcome.ending == Some(PowderStopReason::Blocked),
        ),
        Claim::own_statement(
            TEXT.said("rigid"),
            format!("{:.1e}R", outcome.max_overlap),
            outcome.max_overlap < OVERLAP,
        ),
    ]
}
