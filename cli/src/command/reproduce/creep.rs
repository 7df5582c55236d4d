//! Figure 2.7: dry friction that first falls and then rises with the speed.

use super::exhibit::{Exhibit, claim, geometric, not_checked, points, statement};
use crate::failure::Failure;
use crate::report::figure::{Axis, Figure, Guide, Legend, Series};
use crate::report::page::Claim;
use tribos_core::law::{
    ContactAge, Dieterich, LocalLaw, RateState, RateStateParameters, Ruina, SteadyRateState,
};

/// Like paper on paper: memory length 1 µm (thesis), the rest ours. SI.
const PAPER: RateStateParameters<f64> = RateStateParameters {
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

fn steady() -> Result<SteadyRateState<f64>, Failure> {
    Ok(RateState::<f64, Dieterich>::new(PAPER)
        .map_err(Failure::run)?
        .steady())
}

/// Steady friction over the speed.
pub fn figure_2_7() -> Result<Exhibit, Failure> {
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
    .guide(Guide::vertical(minimum, "Cr | In"))
    .legend(Legend::Hidden);
    let mut claims = steady_claims(&law, minimum);
    claims.extend(memory()?);
    Ok(Exhibit {
        heading: "Figure 2.7: velocity weakening and strengthening".into(),
        text: vec![format!(
            "The steady state of rate-and-state friction stands for the creep model of Heslot et \
             al.: the same logarithmic ageing and memory length, with μ₀ = {}, a = {}, b = {}, \
             V₀ = {:e} m/s, D₀ = {:e} m and a viscous term of {} s/m. Only D₀ is the thesis'.",
            PAPER.mu, PAPER.a, PAPER.b, PAPER.reference_speed, PAPER.slip_distance, PAPER.viscous
        )],
        film: None,
        caption: "Friction falls with the logarithm of the speed (creep, Cr) and rises with the \
                  speed itself (inertial, In)."
            .into(),
        drawing: Box::new(figure),
        columns: vec!["speed", "friction"],
        rows,
        claims,
    })
}

fn minimum(law: &SteadyRateState<f64>) -> Result<f64, Failure> {
    law.minimum()
        .ok_or_else(|| Failure::run("steady friction of paper has no minimum"))
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
        statement(
            "Weakening: μ_d falls about linearly with ln v over three decades",
            "approximately linear",
            format!(
                "off the line by {:.2} % of the fall at most, {:e} to {:e} m/s",
                100.0 * creep,
                CREEP.0,
                CREEP.1
            ),
            creep < STRAIGHT,
        ),
        statement(
            "Strengthening: μ_d rises linearly with v",
            "linear",
            format!(
                "off the line by {:.2} % of the rise at most, {} to {} m/s",
                100.0 * inertial,
                INERTIAL.0,
                INERTIAL.1
            ),
            inertial < STRAIGHT,
        ),
        statement(
            "One crossing from weakening to strengthening",
            "from Cr to In",
            format!("minimum {:.6} at {minimum:.6e} m/s", law.friction(minimum)),
            falls && rises,
        ),
        statement(
            "Creep accelerates itself; the inertial regime does not",
            "self-acceleration",
            "a soft spring pulls unsteadily below the minimum only".into(),
            unstable(0.5 * minimum) && !unstable(2.0 * minimum),
        ),
        not_checked(
            "The measured points of paper on paper",
            "circles and crosses",
            "the measurements are not published as numbers",
        ),
        not_checked(
            "D₀ of paper on paper",
            "≈ 1 µm",
            "measured; taken over as a parameter",
        ),
    ]
}

/// Ageing at rest, and the memory length.
fn memory() -> Result<Vec<Claim>, Failure> {
    let paper = RateState::<f64, Dieterich>::new(PAPER).map_err(Failure::run)?;
    let slow = PAPER.reference_speed;
    let rested = |time: f64| paper.advance(ContactAge { theta: 1.0 }, 0.0, time);
    let strength = |time: f64| paper.coefficient(slow, rested(time));
    let decade = strength(1e5) - strength(1e4);
    let expected = PAPER.b * 10f64.ln();
    let slip_law = RateState::<f64, Ruina>::new(PAPER).map_err(Failure::run)?;
    // ln(θ/steady θ) before and after sliding by D₀ at a new speed.
    let fast = 10.0 * slow;
    let excess = |age: ContactAge<f64>| (age.theta / slip_law.steady_age(fast).theta).ln();
    let before = slip_law.steady_age(slow);
    let after = slip_law.advance(before, fast, PAPER.slip_distance / fast);
    Ok(vec![
        statement(
            "μ_s grows logarithmically with the time of stick",
            "∝ ln τ",
            format!("{decade:.6} from 1e4 s to 1e5 s, b ln 10 = {expected:.6}"),
            (decade / expected - 1.0).abs() < 1e-4,
        ),
        claim(
            "Sliding by D₀ resets the contacts: what is left of ln age (slip law)",
            ("1/e", (-1f64).exp()),
            excess(after) / excess(before),
            1e-14,
        ),
    ])
}
