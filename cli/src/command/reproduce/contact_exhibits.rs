//! Figures 4.2 and 4.3: the laws of cohesive contacts, claims checked on two spheres step by step.

use super::contact_laws::ContactLaws;
use super::contact_trials::{
    FRICTION, Load, Mode, Pair, RANGE, STRENGTH, answer, bearable, breaking_energy, force_at,
    reach, work_against,
};
use super::exhibit::{Exhibit, claim, linear, short, statement};
use crate::failure::Failure;
use crate::report::page::Claim;
use tribos_core::contact::Attraction;

/// Both readings of cohesion at a gap.
const READINGS: [(&str, Attraction); 2] = [
    ("constant pull", Attraction::Pull),
    ("resistance", Attraction::Resistance),
];
/// Normal forces under which thresholds are measured, in F_coh: nearly open, pulled, free, pressed.
const LOADS: [f64; 5] = [-0.9, -0.5, 0.0, 1.0, 10.0];
/// Pushes that a contact has to bear, in F_coh.
const PUSHES: [f64; 3] = [1e-3, 1.0, 1e3];
/// A pull that opens a contact, in F_coh.
const OPENING: f64 = 1.5;
/// r_eff of two spheres of radius 1.
const LEVER: f64 = 0.5;
/// A moving mode, either way: any speed whose stop would take more than the threshold.
const MOTION: f64 = 1.0;
/// What 10⁴ steps across the range leave of its work, and bisection of a threshold.
const ENERGY_ACCURACY: f64 = 1e-5;
const FORCE_ACCURACY: f64 = 1e-6;
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
pub fn figure_4_2() -> Result<Exhibit, Failure> {
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
pub fn figure_4_3() -> Result<Exhibit, Failure> {
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
    claims.extend([unequal_radii()?, own_velocities()?]);
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
fn cohesion_claims() -> Result<Vec<Claim>, Failure> {
    let mut claims = vec![pushed()?];
    for (name, attraction) in READINGS {
        let pair = Pair::equal(attraction)?;
        let pull = bearable(&pair, 2.0 * STRENGTH, pulled)?;
        claims.push(claim(
            &format!("{name}: a pull that is stronger than F_coh cannot be compensated"),
            ("F_coh = 1", STRENGTH),
            pull,
            FORCE_ACCURACY,
        ));
        claims.push(claim(
            &format!("{name}: beyond the gap d_c the normal force is zero"),
            ("d_c = 0.01", RANGE),
            reach(attraction, 2.0 * RANGE)?,
            FORCE_ACCURACY * RANGE,
        ));
        let energy = ("E_c = F_coh d_c = 0.01", STRENGTH * RANGE);
        claims.push(claim(
            &format!("{name}: the energy that breaks a contact"),
            energy,
            breaking_energy(attraction, 2.0 * energy.1)?,
            ENERGY_ACCURACY,
        ));
        claims.push(claim(
            &format!("{name}: the work that the contact takes from a pull of {OPENING} F_coh"),
            energy,
            work_against(attraction, OPENING * STRENGTH)?,
            ENERGY_ACCURACY,
        ));
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
fn pushed() -> Result<Claim, Failure> {
    let (mut worst, mut overlap) = (0.0_f64, 0.0_f64);
    for (_, attraction) in READINGS {
        for push in PUSHES {
            let mut pair = Pair::equal(attraction)?;
            let force = pair.step(pulled(-push), 1e-3)?.normal;
            worst = worst.max((force / push - 1.0).abs());
            overlap = overlap.max(pair.gap.abs());
        }
    }
    Ok(statement(
        "At direct contact F_n takes any value to avoid overlapping",
        "gap = 0",
        format!("pushed with 10⁻³ to 10³ F_coh: F_n off by {worst:.1e}, gap {overlap:.1e} at most"),
        worst < FORCE_ACCURACY && overlap < 1e-12,
    ))
}

/// Spheres at rest at half the range, without a load.
fn let_go() -> Result<Claim, Failure> {
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
    Ok(statement(
        "Let go at half the range (not in the thesis): a constant pull closes the gap, a \
         resistance leaves it",
        "either fits",
        format!("gap {closed:.1e} and {kept:.1e}"),
        closed.abs() < 1e-12 && (kept - 0.5 * RANGE).abs() < 1e-12,
    ))
}

/// Answer to a speed of the mode, pressed with F_coh and without load; the speed stands first.
fn moving(mode: Mode, speed: f64) -> Result<Vec<f64>, Failure> {
    let pair = pair_for(mode)?;
    let mut row = vec![speed];
    for normal in [STRENGTH, 0.0] {
        let velocity = Load::new(0.0, mode, speed);
        row.push(answer(&pair, normal, velocity)?.modes[mode as usize]);
    }
    Ok(row)
}

/// Spheres that slide cannot turn: otherwise they would roll.
fn pair_for(mode: Mode) -> Result<Pair, Failure> {
    let pair = Pair::equal(Attraction::Pull)?;
    Ok(if mode == Mode::Sliding {
        pair.stiff()
    } else {
        pair
    })
}

/// Largest load at rest, answer in motion, and where both vanish.
fn threshold_claims(mode: Mode, law: &str) -> Result<Vec<Claim>, Failure> {
    let pair = pair_for(mode)?;
    let lever = if mode == Mode::Sliding { 1.0 } else { LEVER };
    let (mut at_rest, mut in_motion) = (0.0_f64, 0.0_f64);
    let mut against = true;
    for normal in LOADS {
        let most = FRICTION[mode as usize] * (normal + STRENGTH) * lever;
        let borne = bearable(&pair, 2.0 * most, |size| Load::new(normal, mode, size))?;
        at_rest = at_rest.max((borne / most - 1.0).abs());
        for speed in [-MOTION, MOTION] {
            let velocity = Load::new(0.0, mode, speed);
            let answer = answer(&pair, normal, velocity)?.modes[mode as usize];
            in_motion = in_motion.max((answer.abs() / most - 1.0).abs());
            against &= answer * speed < 0.0;
        }
    }
    let open = answer(&pair, -STRENGTH, Load::new(0.0, mode, MOTION))?.modes[mode as usize];
    let range = "F_n from −0.9 to 10 F_coh";
    Ok(vec![
        statement(
            &format!("Eq. {law}: what a contact at rest bears"),
            "any value up to it",
            format!("largest relative deviation {at_rest:.1e} for {range}"),
            at_rest < FORCE_ACCURACY,
        ),
        statement(
            &format!("Eq. {law}: in motion the same, against the motion"),
            "μ_s = μ_d",
            format!("largest relative deviation {in_motion:.1e} for {range}"),
            in_motion < FORCE_ACCURACY && against,
        ),
        statement(
            &format!("Eq. {law}: vanishes when the contact opens"),
            "0 at F_n = −F_coh",
            short(open.abs()),
            open.abs() < 1e-12,
        ),
    ])
}

/// Torsion of spheres of radius 1 and 2.
fn unequal_radii() -> Result<Claim, Failure> {
    let pair = Pair::new(Attraction::Pull, [1.0, 2.0])?;
    let spinning = Load::new(0.0, Mode::Torsion, MOTION);
    let [_, _, torque] = answer(&pair, STRENGTH, spinning)?.modes;
    let lever = torque.abs() / (FRICTION[2] * 2.0 * STRENGTH);
    Ok(claim(
        "r_eff = (1/R₁ + 1/R₂)⁻¹, for radii 1 and 2",
        ("2/3", 2.0 / 3.0),
        lever,
        1e-12,
    ))
}

/// Rolling and torsion at once answer as they do alone.
fn own_velocities() -> Result<Claim, Failure> {
    let pair = pair_for(Mode::Rolling)?;
    let both = Load {
        normal: 0.0,
        modes: [0.0, MOTION, MOTION],
    };
    let [_, rolling, torsion] = answer(&pair, STRENGTH, both)?.modes;
    let alone = |mode| moving(mode, MOTION).map(|row| row[1]);
    let (rolls, spins) = (alone(Mode::Rolling)?, alone(Mode::Torsion)?);
    let apart = (rolling - rolls).abs() + (torsion - spins).abs();
    Ok(statement(
        "The rolling torque is coupled to ω_t and the torsion torque to ω_n",
        "each to its own",
        format!("both at once differ from each alone by {apart:.1e}"),
        apart < 1e-12 && rolls != 0.0 && spins != 0.0,
    ))
}
