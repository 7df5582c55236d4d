//! Section 5.1's open questions: final motion for other pressures and for negative exponents.

use super::pressure::PRESSURES;
use crate::exhibit::{Exhibit, geometric, linear, modes};
use crate::text::Text;
use anyhow::{Result, anyhow};
use tribos_core::coupling::round::RoundTable64;
use tribos_core::modes::{Stability, TerminalMode, TerminalMotion, inertia_interval};
use tribos_core::patch::PowerPressure;
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Color, Figure, Legend, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("section-5.1-modes.md"));

/// Exponents shown; the borders diverge or vanish at −1.
const ALPHA: (f64, f64) = (-0.99, 5.0);
/// Radius of a curling stone and of its running band, m (section 3.5.2).
const STONE: f64 = 0.145;
const BAND: f64 = 0.0625;
/// Exponents: Penner's, and those measured for a draw shot and for a slow slide with fast spin.
const PENNER: f64 = -0.5;
const DRAW: f64 = -0.19;
const SLOW_SLIDE: f64 = -0.75;

/// C = I/(M R²) of a stone as a solid cylinder on its band.
fn stone() -> f64 {
    0.5 * (STONE / BAND) * (STONE / BAND)
}

/// The phase diagram for five pressures.
pub fn section_5_1_modes() -> Result<Exhibit> {
    let rows: Vec<Vec<f64>> = linear(ALPHA.0, ALPHA.1, 240)
        .into_iter()
        .map(|alpha| {
            let borders = PRESSURES.iter().flat_map(|(_, pressure)| {
                let (low, high) = inertia_interval(alpha, pressure.order());
                [low, high]
            });
            std::iter::once(alpha).chain(borders).collect()
        })
        .collect();
    let mut figure = Figure::new(
        "Final motion for five pressures: between its two lines each has a finite ε₀",
        Axis::linear("exponent α").range(-1.0, ALPHA.1),
        Axis::log10("C = I/(M R²)").range(0.02, 20.0),
    );
    for (i, (name, _)) in PRESSURES.iter().enumerate() {
        let border = |column: usize| rows.iter().map(|row| (row[0], row[column])).collect();
        let color = Color::palette(i);
        figure = figure
            .series(Series::line(*name, border(1 + 2 * i)).color(color))
            .series(Series::line("", border(2 + 2 * i)).color(color));
    }
    let stones = [SLOW_SLIDE, PENNER, DRAW].map(|alpha| (alpha, stone()));
    figure = figure
        .series(
            Series::points("curling stone on its band", stones.to_vec()).color(Color(30, 30, 30)),
        )
        .guide(ReferenceLine::horizontal(0.5, "disk"))
        .guide(ReferenceLine::vertical(1.0, ""))
        .legend(Legend::Below);
    let mut claims = plane(&[-0.9, -0.5, -0.19, 0.0, 0.5, 1.5, 3.0, 5.0])?;
    claims.push(decoupled()?);
    claims.extend(negative()?);
    claims.extend(curling()?);
    Ok(Exhibit::new(
        TEXT.prose()
            .with("stone", STONE)
            .with("band", BAND)
            .with("inertia", format!("{:.4}", stone())),
        figure,
        &[
            "alpha",
            "ring_low",
            "ring_high",
            "punch_low",
            "punch_high",
            "uniform_low",
            "uniform_high",
            "hertz_low",
            "hertz_high",
            "paraboloid_low",
            "paraboloid_high",
        ],
        rows,
        claims,
    ))
}

fn round(alpha: f64, pressure: PowerPressure) -> Result<RoundTable64> {
    Ok(RoundTable64::new(alpha, pressure)?)
}

/// Signs of g for each pressure against the borders.
fn plane(exponents: &[f64]) -> Result<Vec<Claim>> {
    let ratios = geometric(1e-6, 1e6, 60);
    let (mut bodies, mut inside_right, mut fitting) = (0, 0, 0);
    for &alpha in exponents {
        for (_, pressure) in PRESSURES {
            let table = round(alpha, pressure)?;
            let (low, high) = inertia_interval(alpha, pressure.order());
            for c in geometric(0.031, 17.0, 20) {
                let modes = TerminalMotion::new(&table, c)?;
                let signs: Vec<bool> = ratios.iter().map(|&r| modes.growth(r) > 0.0).collect();
                let changes = signs.windows(2).filter(|w| w[0] != w[1]).count();
                let inside = c > low && c < high;
                bodies += 1;
                inside_right += usize::from(changes == usize::from(inside));
                let stable = matches!(modes.fixed_points().finite, Some((_, Stability::Stable)));
                // g falls through zero at a stable point.
                fitting += usize::from(!inside || (signs[0] == stable && stable == (alpha < 1.0)));
            }
        }
    }
    let all =
        |n: usize| format!("{n} of {bodies} bodies: five pressures, −0.9 ≤ α ≤ 5, 0.03 < C < 17");
    Ok(vec![
        Claim::own_statement(
            TEXT.said("plane"),
            all(inside_right),
            inside_right == bodies,
        ),
        Claim::own_statement(TEXT.said("stability"), all(fitting), fitting == bodies),
    ])
}

/// α = 1.
fn decoupled() -> Result<Claim> {
    let mut holds = true;
    for (_, pressure) in PRESSURES {
        let table = round(1.0, pressure)?;
        let modes = TerminalMotion::new(&table, pressure.mean_square_radius())?;
        let points = modes.fixed_points();
        holds &= points.spinning == Stability::Semistable && points.finite.is_none();
        holds &= geometric(1e-3, 1e3, 60)
            .into_iter()
            .all(|ratio| modes.growth(ratio).abs() <= 1e-14 * ratio);
    }
    Ok(Claim::own_statement(
        TEXT.said("decoupled"),
        "ring 1, punch 2/3, uniform 1/2, Hertz 2/5, paraboloid 1/3",
        holds,
    ))
}

/// The disk with negative exponents.
fn negative() -> Result<Vec<Claim>> {
    // Roots of ε T/F = 1/2 from the hypergeometric series at 30 digits.
    let known = [
        (-0.9, 0.700_450_301_609_642_8),
        (-0.75, 0.691_074_203_099_252_9),
        (-0.5, 0.676_893_274_376_780_2),
        (-0.19, 0.661_457_584_203_123),
    ];
    known
        .into_iter()
        .map(|(alpha, value)| {
            let ratio = modes(alpha, 0.5)?.finite_fixed_point().unwrap_or(f64::NAN);
            Ok(Claim::own(
                TEXT.said("disk").with("alpha", alpha),
                ratio,
                value,
                1e-12,
            ))
        })
        .collect()
}

/// Stones on their band.
fn curling() -> Result<Vec<Claim>> {
    let end = |alpha: f64| -> Result<TerminalMode<f64>> {
        let ring = round(alpha, PowerPressure::RING)?;
        let modes = TerminalMotion::new(&ring, stone())?;
        Ok(modes.terminal_mode(1.0))
    };
    let (penner, draw, slow_slide) = (end(PENNER)?, end(DRAW)?, end(SLOW_SLIDE)?);
    let in_words = |mode: &TerminalMode<f64>| match mode {
        TerminalMode::Spinning => "ε → 0, spinning takes over".to_owned(),
        TerminalMode::Sliding => "ε → ∞, sliding takes over".to_owned(),
        TerminalMode::Together { ratio } => format!("together, ε₀ = {}", short(*ratio)),
    };
    let TerminalMode::Together { ratio } = penner else {
        return Err(anyhow!("a stone with α = −1/2 has no common stop"));
    };
    let bounds = inertia_interval(DRAW, PowerPressure::RING.order());
    Ok(vec![
        Claim::own(TEXT.said("penner"), ratio, 0.781_502_820_849_875_1, 1e-12),
        Claim::own_statement(
            TEXT.said("draw"),
            format!("{}; C is above c_max = {:.4}", in_words(&draw), bounds.1),
            draw == TerminalMode::Spinning,
        ),
        Claim::contradiction(
            TEXT.said("draw-stops"),
            format!(
                "with the measured exponent −0.19 a thin band has none: C is {:.0} % above the \
                 border; after a launch at ε = 1 both motions still end at the same instant",
                100.0 * (stone() / bounds.1 - 1.0)
            ),
            draw == TerminalMode::Spinning && stops_together(DRAW)?,
        ),
        Claim::not_checkable(TEXT.said("slow-slide").with("mode", in_words(&slow_slide))),
    ])
}

/// True if a stone that slides as fast as its band spins does both until it rests.
fn stops_together(alpha: f64) -> Result<bool> {
    let ring = round(alpha, PowerPressure::RING)?;
    let slider = Slider::new(
        ring,
        SliderParameters {
            deceleration: 1.0,
            radius: 1.0,
            inertia_ratio: stone(),
        },
    )?;
    let mut motion = SliderState::launched(1.0, 1.0);
    // With fixed steps: the last moving state still slides and spins.
    loop {
        let step = slider.advance(&motion, 0.01);
        if step.rest.is_some() {
            return Ok(motion.speed > 0.0 && motion.spin > 0.0);
        }
        motion = step.motion;
    }
}
