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
use crate::text::Text;
use anyhow::Result;
use tribos_core::contact::Attraction;
use tribos_report::claim::Claim;

pub const FIGURE_4_2: Text = Text(include_str!("figure-4.2.md"));
pub const FIGURE_4_3: Text = Text(include_str!("figure-4.3.md"));

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
    Ok(Exhibit::new(
        FIGURE_4_2.prose().with("range", RANGE),
        DRAWN.figure_4_2(),
        &[
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
    ))
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
    Ok(Exhibit::new(
        FIGURE_4_3.prose(),
        DRAWN.figure_4_3(),
        &[
            "angular_velocity",
            "rolling_pressed",
            "rolling_unloaded",
            "torsion_pressed",
            "torsion_unloaded",
        ],
        rows,
        claims,
    ))
}

/// What Signorini's condition with cohesion promises.
fn cohesion_claims() -> Result<Vec<Claim>> {
    let mut claims = vec![pushed()?];
    for (name, attraction) in READINGS {
        let pair = Pair::equal(attraction)?;
        let pull = bearable(&pair, 2.0 * STRENGTH, pulled)?;
        let energy = STRENGTH * RANGE;
        let rows = [
            ("strongest-pull", pull, STRENGTH, FORCE_ACCURACY),
            (
                "reach",
                reach(attraction, 2.0 * RANGE)?,
                RANGE,
                FORCE_ACCURACY * RANGE,
            ),
            (
                "breaking-energy",
                breaking_energy(attraction, 2.0 * energy)?,
                energy,
                ENERGY_ACCURACY,
            ),
            (
                "work",
                work_against(attraction, OPENING * STRENGTH)?,
                energy,
                ENERGY_ACCURACY,
            ),
        ];
        claims.extend(rows.map(|(id, ours, law, tolerance)| {
            Claim::own(
                FIGURE_4_2.said(id).with("reading", name),
                ours,
                law,
                tolerance,
            )
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
        FIGURE_4_2.said("pushed"),
        format!("pushed with 10⁻³ to 10³ F_coh: F_n off by {worst:.1e}, gap {overlap:.1e} at most"),
        worst < FORCE_ACCURACY && overlap < 1e-12,
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
        FIGURE_4_2.said("released"),
        format!("gap {closed:.1e} and {kept:.1e}"),
        closed.abs() < 1e-12 && (kept - 0.5 * RANGE).abs() < 1e-12,
    ))
}
