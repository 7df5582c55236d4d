//! Figure 2.7: dry friction that first falls and then rises with the speed.

use crate::exhibit::{Exhibit, geometric, points};
use crate::text::Text;
use anyhow::{Result, anyhow};
use tribos_core::law::{
    AgeingLaw, LocalLaw, RateState, RateStateParameters, SlipLaw, StateVariable, SteadyRateState,
};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Legend, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("figure-2.7.md"));

/// Like paper on paper: memory length 1 µm (thesis), the rest ours. SI.
pub(super) const PAPER: RateStateParameters<f64> = RateStateParameters {
    mu: 0.35,
    a: 0.01,
    b: 0.03,
    reference_speed: 1e-6,
    slip_distance: 1e-6,
    viscous: 20.0,
};
/// The three decades in which friction falls, and speeds far above its minimum, m/s.
const CREEP: (f64, f64) = (1e-7, 1e-4);
const INERTIAL: (f64, f64) = (1e-2, 1e-1);

fn steady() -> Result<SteadyRateState<f64>> {
    Ok(RateState::<f64, AgeingLaw>::new(PAPER)?.steady())
}

/// Steady friction over the speed.
pub fn figure_2_7() -> Result<Exhibit> {
    let law = steady()?;
    let rows: Vec<Vec<f64>> = geometric(CREEP.0, 1e-2, 300)
        .into_iter()
        .map(|v| vec![v, law.friction(v)])
        .collect();
    let minimum = minimum(&law)?;
    let figure = Figure::new(
        "Steady sliding, paper on paper",
        Axis::log10("velocity [m/s]"),
        Axis::linear("μ_d").range(0.15, 0.45),
    )
    .series(Series::line("rate and state", points(&rows, 0, 1)))
    .guide(ReferenceLine::vertical(minimum, "Cr | In"))
    .legend(Legend::Hidden);
    let mut claims = steady_claims(&law, minimum);
    claims.extend(memory()?);
    Ok(Exhibit::new(
        TEXT.prose()
            .with("mu", PAPER.mu)
            .with("a", PAPER.a)
            .with("b", PAPER.b)
            .with("speed", format!("{:e}", PAPER.reference_speed))
            .with("length", format!("{:e}", PAPER.slip_distance))
            .with("viscous", PAPER.viscous),
        figure,
        &["speed", "friction"],
        rows,
        claims,
    ))
}

fn minimum(law: &SteadyRateState<f64>) -> Result<f64> {
    law.minimum()
        .ok_or_else(|| anyhow!("steady friction of paper has no minimum"))
}

/// Largest distance of `law` from the chord over `range`, straight in `scale`, as a share of the
/// change over that range.
fn bend(law: &impl LocalLaw<f64>, range: (f64, f64), scale: impl Fn(f64) -> f64) -> f64 {
    let (start, end) = (law.friction(range.0), law.friction(range.1));
    let share = |v: f64| (scale(v) - scale(range.0)) / (scale(range.1) - scale(range.0));
    geometric(range.0, range.1, 300)
        .into_iter()
        .map(|v| (law.friction(v) - start - (end - start) * share(v)).abs())
        .fold(0.0, f64::max)
        / (end - start).abs()
}

fn steady_claims(law: &SteadyRateState<f64>, minimum: f64) -> Vec<Claim> {
    /// How far from straight "approximately linear" may be: ours.
    const STRAIGHT: f64 = 0.02;
    let (creep, inertial) = (bend(law, CREEP, f64::ln), bend(law, INERTIAL, |v: f64| v));
    let falls = geometric(CREEP.0, 0.99 * minimum, 300)
        .windows(2)
        .all(|v| law.friction(v[1]) < law.friction(v[0]));
    let rises = geometric(1.01 * minimum, INERTIAL.1, 300)
        .windows(2)
        .all(|v| law.friction(v[1]) > law.friction(v[0]));
    // A spring slower than this makes the slider stick and slip.
    let unstable = |v: f64| law.critical_stiffness_at(1.0, v) > 0.0;
    vec![
        Claim::trend(
            TEXT.said("weakening"),
            format!(
                "off the line by {:.2} % of the fall at most, {:e} to {:e} m/s",
                100.0 * creep,
                CREEP.0,
                CREEP.1
            ),
            creep < STRAIGHT,
        ),
        Claim::definition(
            TEXT.said("strengthening"),
            format!(
                "off the line by {:.2} % of the rise at most, {} to {} m/s",
                100.0 * inertial,
                INERTIAL.0,
                INERTIAL.1
            ),
            inertial < STRAIGHT,
        ),
        Claim::trend(
            TEXT.said("crossing"),
            format!(
                "minimum {:.4} at {:.2e} m/s",
                law.friction(minimum),
                minimum
            ),
            falls && rises,
        ),
        Claim::trend(
            TEXT.said("creep-accelerates"),
            "with a soft spring sliding is unsteady only below the minimum",
            unstable(0.5 * minimum) && !unstable(2.0 * minimum),
        ),
        Claim::not_checkable(TEXT.said("measured-paper")),
        Claim::definition(
            TEXT.said("memory-length"),
            format!("{}", 1e6 * PAPER.slip_distance),
            PAPER.slip_distance == 1e-6,
        )
        .printed("≈ 1"),
    ]
}

/// Ageing at rest, and the memory length.
fn memory() -> Result<Vec<Claim>> {
    let paper = RateState::<f64, AgeingLaw>::new(PAPER)?;
    let slow = PAPER.reference_speed;
    let rested = |time: f64| paper.advance(StateVariable { theta: 1.0 }, 0.0, time);
    let strength = |time: f64| paper.coefficient(slow, rested(time));
    let decade = strength(1e5) - strength(1e4);
    let expected = PAPER.b * 10f64.ln();
    let slip_law = RateState::<f64, SlipLaw>::new(PAPER)?;
    // ln(θ/steady θ) before and after sliding by D₀ at a new speed.
    let fast = 10.0 * slow;
    let excess = |age: StateVariable<f64>| (age.theta / slip_law.steady_age(fast).theta).ln();
    let before = slip_law.steady_age(slow);
    let after = slip_law.advance(before, fast, PAPER.slip_distance / fast);
    Ok(vec![
        Claim::trend(
            TEXT.said("stick-time"),
            format!("by {decade:.5} from 1e4 s to 1e5 s; b ln 10 = {expected:.5}"),
            (decade / expected - 1.0).abs() < 1e-4,
        ),
        Claim::own(
            TEXT.said("reset"),
            excess(after) / excess(before),
            (-1f64).exp(),
            1e-14,
        ),
    ])
}
