//! Figures 4.2 and 4.3: the laws of cohesive contacts, claims checked on two spheres step by step.

use super::contact_laws::ContactLaws;
use super::contact_thresholds::{
    FORCE_ACCURACY, LEVER, MOTION, levers, moving, own_velocities, threshold_claims,
};
use super::contact_trials::{
    FRICTION, Load, Mode, Pair, RANGE, STRENGTH, bearable, breaking_energy, force_at, reach,
    work_against,
};
use crate::exhibit::{Exhibit, linear};
use anyhow::Result;
use tribos_core::contact::Attraction;
use tribos_report::claim::Claim;

/// Both readings of cohesion at a gap.
const READINGS: [(&str, Attraction); 2] = [
    ("constant pull", Attraction::Pull),
    ("resistance", Attraction::Resistance),
];
/// Pushes that a contact has to bear, in F_coh.
const PUSHES: [f64; 3] = [1e-3, 1.0, 1e3];
/// A pull that opens a contact, in F_coh.
const OPENING: f64 = 1.5;
/// What 10⁴ steps across the range leave of its work.
const ENERGY_ACCURACY: f64 = 1e-5;
/// Intervals in the tables.
const SAMPLES: usize = 40;

/// The contact's laws in the drawings.
const DRAWN: ContactLaws = ContactLaws {
    mu: FRICTION[0],
    mu_rolling: FRICTION[1],
    mu_torsion: FRICTION[2],
    cohesion_force: STRENGTH,
    cohesion_range: RANGE,
    effective_radius: LEVER,
};

/// Normal force over the gap, friction over the sliding velocity.
pub fn figure_4_2() -> Result<Exhibit> {
    let mut rows = Vec::new();
    let gaps = linear(0.0, 2.0 * RANGE, SAMPLES);
    for (gap, speed) in gaps.into_iter().zip(linear(-MOTION, MOTION, SAMPLES)) {
        let mut row = vec![gap];
        for (_, attraction) in READINGS {
            row.push(force_at(attraction, gap, MOTION)?);
            row.push(force_at(attraction, gap, 0.0)?);
        }
        row.extend(moving(Mode::Sliding, speed)?);
        rows.push(row);
    }
    let mut claims = cohesion_claims()?;
    claims.extend(threshold_claims(
        Mode::Sliding,
        "4.1: F_t,max = μ(F_n + F_coh)",
    )?);
    Ok(Exhibit {
        heading: "Figure 4.2: normal force and sliding friction of a cohesive contact".into(),
        text: vec![
            "The thesis says what the force may be at a gap within the range of cohesion, \"up to \
             the cohesion strength\", not what it is where nothing pulls. A constant pull derives \
             from an energy; a resistance only answers. Powders here take the first unless told \
             otherwise; both are drawn."
                .into(),
            format!(
                "Claims are checked on two free spheres of radius 1 with F_coh = 1, d_c = {RANGE} \
                 that are pulled, pushed and thrown apart step by step. The table holds the \
                 forces measured so: at a gap that opens and at one that rests, and against the \
                 sliding speed under F_n = F_coh and 0."
            ),
        ],
        film: None,
        caption: "Normal force over the gap in both readings, and friction over the sliding \
                  velocity."
            .into(),
        drawing: Box::new(DRAWN.figure_4_2()),
        columns: vec![
            "gap",
            "pull_opening",
            "pull_at_rest",
            "resistance_opening",
            "resistance_at_rest",
            "sliding_velocity",
            "friction_pressed",
            "friction_unloaded",
        ],
        rows,
        claims,
    })
}

/// Torques over the angular velocities.
pub fn figure_4_3() -> Result<Exhibit> {
    let mut rows = Vec::new();
    for speed in linear(-MOTION, MOTION, SAMPLES) {
        let mut row = moving(Mode::Rolling, speed)?;
        row.extend_from_slice(&moving(Mode::Torsion, speed)?[1..]);
        rows.push(row);
    }
    let mut claims = threshold_claims(Mode::Torsion, "4.2: T_n,max = μ_n(F_n + F_coh) r_eff")?;
    claims.extend(threshold_claims(
        Mode::Rolling,
        "4.3: T_t,max = μ_t(F_n + F_coh) r_eff",
    )?);
    claims.extend(levers()?);
    claims.push(own_velocities()?);
    Ok(Exhibit {
        heading: "Figure 4.3: rolling and torsion torque of a contact".into(),
        text: vec![
            "Measured on the spheres of figure 4.2, which are turned against each other. The \
             lever is r_eff = (1/R₁ + 1/R₂)⁻¹, half the radius of two equal spheres."
                .into(),
        ],
        film: None,
        caption: "Rolling and torsion torque over their angular velocities.".into(),
        drawing: Box::new(DRAWN.figure_4_3()),
        columns: vec![
            "angular_velocity",
            "rolling_pressed",
            "rolling_unloaded",
            "torsion_pressed",
            "torsion_unloaded",
        ],
        rows,
        claims,
    })
}

/// What Signorini's condition with cohesion promises.
fn cohesion_claims() -> Result<Vec<Claim>> {
    let mut claims = vec![pushed()?];
    for (name, attraction) in READINGS {
        let pair = Pair::equal(attraction)?;
        let pull = bearable(&pair, 2.0 * STRENGTH, pulled)?;
        let energy = STRENGTH * RANGE;
        let rows = [
            (
                "the strongest pull that the contact bears, in F_coh",
                pull,
                ("the law: F_coh", STRENGTH),
                FORCE_ACCURACY,
            ),
            (
                "the gap beyond which the normal force is zero, in R",
                reach(attraction, 2.0 * RANGE)?,
                ("the law: d_c = 0.01R, ours", RANGE),
                FORCE_ACCURACY * RANGE,
            ),
            (
                "the energy that breaks a contact, in F_coh R",
                breaking_energy(attraction, 2.0 * energy)?,
                ("the law: E_c = F_coh d_c", energy),
                ENERGY_ACCURACY,
            ),
            (
                "the work that it takes from a pull of 1.5 F_coh, in F_coh R",
                work_against(attraction, OPENING * STRENGTH)?,
                ("the law: E_c = F_coh d_c", energy),
                ENERGY_ACCURACY,
            ),
        ];
        claims.extend(rows.map(|(what, ours, against, tolerance)| {
            Claim::own(&format!("{name}: {what}"), ours, against, tolerance)
        }));
    }
    claims.push(let_go()?);
    Ok(claims)
}

fn pulled(size: f64) -> Load {
    Load {
        normal: -size,
        ..Load::default()
    }
}

/// Any push, no overlap.
fn pushed() -> Result<Claim> {
    let (mut worst, mut overlap) = (0.0_f64, 0.0_f64);
    for (_, attraction) in READINGS {
        for push in PUSHES {
            let mut pair = Pair::equal(attraction)?;
            let force = pair.step(pulled(-push), 1e-3)?.normal;
            worst = worst.max((force / push - 1.0).abs());
            overlap = overlap.max(pair.gap.abs());
        }
    }
    Ok(Claim::own_statement(
        "At direct contact F_n takes any value to avoid overlapping",
        format!("pushed with 10⁻³ to 10³ F_coh: F_n off by {worst:.1e}, gap {overlap:.1e} at most"),
        worst < FORCE_ACCURACY && overlap < 1e-12,
        "the law of fig. 4.2",
    ))
}

/// Spheres at rest at half the range, without a load.
fn let_go() -> Result<Claim> {
    /// Long enough for a pull of F_coh to close half the range: √(m d_c/F_coh) ≈ 0.15.
    const STEPS: usize = 500;
    let mut gaps = [0.0; 2];
    for (gap, (_, attraction)) in gaps.iter_mut().zip(READINGS) {
        let mut pair = Pair::equal(attraction)?;
        pair.gap = 0.5 * RANGE;
        for _ in 0..STEPS {
            pair.step(Load::default(), 1e-3)?;
        }
        *gap = pair.gap;
    }
    let [closed, kept] = gaps;
    Ok(Claim::own_statement(
        "Let go at half the range: a constant pull closes the gap, a resistance leaves it; both fit \
         the thesis",
        format!("gap {closed:.1e} and {kept:.1e}"),
        closed.abs() < 1e-12 && (kept - 0.5 * RANGE).abs() < 1e-12,
        "gaps 0 and d_c/2",
    ))
}
