//! Figures 4.2 and 4.3: what a contact bears at rest and answers in motion.

use super::contact_exhibits::{FIGURE_4_2, FIGURE_4_3};
use super::contact_trials::{FRICTION, Load, Mode, Pair, STRENGTH, answer, bearable};
use anyhow::Result;
use tribos_core::contact::Attraction;
use tribos_report::claim::Claim;
use tribos_report::digits::short;

/// Normal forces under which thresholds are measured, in F_coh: nearly open, pulled, free, pressed.
const LOADS: [f64; 5] = [-0.9, -0.5, 0.0, 1.0, 10.0];
/// r_eff of two spheres of radius 1.
pub const LEVER: f64 = 0.5;
/// A moving mode, either way: any speed whose stop would take more than the threshold.
pub const MOTION: f64 = 1.0;
/// What bisection leaves of a threshold.
pub const FORCE_ACCURACY: f64 = 1e-6;

/// Answer to a speed of the mode, pressed with F_coh and without load; the speed stands first.
pub fn moving(mode: Mode, speed: f64) -> Result<Vec<f64>> {
    let pair = pair_for(mode)?;
    let mut row = vec![speed];
    for normal in [STRENGTH, 0.0] {
        let velocity = Load::new(0.0, mode, speed);
        row.push(answer(&pair, normal, velocity)?.modes[mode as usize]);
    }
    Ok(row)
}

/// Spheres that slide cannot turn: otherwise they would roll.
fn pair_for(mode: Mode) -> Result<Pair> {
    let pair = Pair::equal(Attraction::Pull)?;
    Ok(if mode == Mode::Sliding {
        pair.stiff()
    } else {
        pair
    })
}

/// Largest load at rest, answer in motion, and where both vanish.
pub fn threshold_claims(mode: Mode, law: &str) -> Result<Vec<Claim>> {
    let pair = pair_for(mode)?;
    let lever = if mode == Mode::Sliding { 1.0 } else { LEVER };
    let (mut at_rest, mut in_motion) = (0.0_f64, 0.0_f64);
    let mut against_motion = true;
    for normal in LOADS {
        let most = FRICTION[mode as usize] * (normal + STRENGTH) * lever;
        let borne = bearable(&pair, 2.0 * most, |size| Load::new(normal, mode, size))?;
        at_rest = at_rest.max((borne / most - 1.0).abs());
        for speed in [-MOTION, MOTION] {
            let velocity = Load::new(0.0, mode, speed);
            let answer = answer(&pair, normal, velocity)?.modes[mode as usize];
            in_motion = in_motion.max((answer.abs() / most - 1.0).abs());
            against_motion &= answer * speed < 0.0;
        }
    }
    let open = answer(&pair, -STRENGTH, Load::new(0.0, mode, MOTION))?.modes[mode as usize];
    let range = "F_n from −0.9 to 10 F_coh";
    let said = |id| FIGURE_4_2.said(id).with("law", law);
    Ok(vec![
        Claim::own_statement(
            said("at-rest"),
            format!("deviation {at_rest:.1e} at most, relative, for {range}"),
            at_rest < FORCE_ACCURACY,
        ),
        Claim::own_statement(
            said("in-motion"),
            format!("deviation {in_motion:.1e} at most, relative, for {range}"),
            in_motion < FORCE_ACCURACY && against_motion,
        ),
        Claim::own_statement(said("opening"), short(open.abs()), open.abs() < 1e-12),
    ])
}

/// Lever of torsion between spheres of these radii, from the torque.
fn lever(radii: [f64; 2]) -> Result<f64> {
    let pair = Pair::new(Attraction::Pull, radii)?;
    let spinning = Load::new(0.0, Mode::Torsion, MOTION);
    let [_, _, torque] = answer(&pair, STRENGTH, spinning)?.modes;
    Ok(torque.abs() / (FRICTION[2] * 2.0 * STRENGTH))
}

/// r_eff of equal and of unequal spheres.
pub fn levers() -> Result<[Claim; 2]> {
    let equal = lever([1.0, 1.0])?;
    Ok([
        Claim::definition(
            FIGURE_4_3.said("lever-of-equals"),
            short(equal),
            (equal - 0.5).abs() <= 1e-12,
        )
        .printed("1/2"),
        Claim::own(
            FIGURE_4_3.said("lever"),
            lever([1.0, 2.0])?,
            2.0 / 3.0,
            1e-12,
        ),
    ])
}

/// Rolling and torsion at once answer as they do alone.
pub fn own_velocities() -> Result<Claim> {
    let pair = pair_for(Mode::Rolling)?;
    let both = Load {
        normal: 0.0,
        modes: [0.0, MOTION, MOTION],
    };
    let [_, rolling, torsion] = answer(&pair, STRENGTH, both)?.modes;
    let alone = |mode| moving(mode, MOTION).map(|row| row[1]);
    let (rolls, spins) = (alone(Mode::Rolling)?, alone(Mode::Torsion)?);
    let apart = (rolling - rolls).abs() + (torsion - spins).abs();
    Ok(Claim::own_statement(
        FIGURE_4_3.said("own-velocities"),
        format!("both at once and each alone differ by {apart:.1e}"),
        apart < 1e-12 && rolls != 0.0 && spins != 0.0,
    ))
}
