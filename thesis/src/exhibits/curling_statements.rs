//! What section 3.5.2 says of models of the curling rock, and of draws.

use super::curling::{SPINS, TEXT, short_metres};
use super::heat;
use super::rock::{DRAW, SLOW, dry, pivot, shot, spin_for_a_metre};
use crate::reference_integration::Points;
use anyhow::Result;
use std::f64::consts::{PI, TAU};
use tribos::slide::curling::{BackHeavy, CurlingModel, CurlingRock, IceLaw, LeftRight};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::verdict::Allowance;

const ICE: IceLaw = IceLaw::PENNER;
/// Launch of a draw that stops after 28.35 m without spin under the law measured in draws, m/s.
const DRAW_LAW_LAUNCH: f64 = 2.0131;
/// 28 m in 20 s, m/s.
const MEAN: f64 = 1.4;
/// Rounding of a sum over 720 points, of the force.
const ROUNDING: f64 = 1e-13;

/// All statements.
pub(super) fn statements() -> Result<Vec<Claim>> {
    let mut claims = asymmetries()?;
    claims.extend([no_lateral_force(), pivots()?]);
    claims.extend(draws()?);
    claims.extend([launch_ratios(), unit_of_coefficient()]);
    claims.extend(heat_balance());
    Ok(claims)
}

fn curl(model: &dyn CurlingModel, spin: f64) -> Result<f64> {
    Ok(shot(model, (DRAW, spin))?.position[1])
}

/// Friction that differs between front and back.
fn asymmetries() -> Result<Vec<Claim>> {
    let [_, half, fast] = SPINS;
    let heavy = |back_to_front: f64| BackHeavy {
        ice: ICE,
        back_to_front,
    };
    let (by_dry, ten_fold) = (dry(), heavy(10.0));
    let side = curl(&by_dry, fast)?;
    let [dry_factor, heavy_factor] = [
        side / curl(&by_dry, half)?,
        curl(&ten_fold, fast)? / curl(&ten_fold, half)?,
    ];
    let needed = [10.0, 100.0, f64::INFINITY].map(|ratio| spin_for_a_metre(&heavy(ratio)));
    let [ten, hundred, all] = needed;
    let (ten, hundred, all) = (ten?, hundred?, all?);
    let doubles = |factor: f64| (factor - 2.0).abs() < 0.1;
    Ok(vec![
        Claim::trend(
            TEXT.said("opposite"),
            format!("{} m", short_metres(side)),
            side < 0.0,
        ),
        Claim::trend(
            TEXT.said("linear"),
            format!("dry {dry_factor:.3}, heavier at the back {heavy_factor:.3} times as much"),
            doubles(dry_factor) && doubles(heavy_factor),
        ),
        Claim::trend(
            TEXT.said("back-factor"),
            format!("{ten:.1}, {hundred:.1} and, with none in front, {all:.1} rad/s"),
            all > fast && hundred > all && ten > hundred,
        )
        .printed("10 – 100"),
    ])
}

/// Left and right alone, for exponents of either sign, on points.
fn no_lateral_force() -> Claim {
    let ring = Points::ring(720);
    let mut none = true;
    for alpha in [-0.75, -0.5, -0.19, 0.5, 1.0, 2.0, 3.0] {
        for rim in [0.01, 0.1, 0.5, 2.0] {
            let [along, across, _] = ring.friction([1.0, 0.0, rim], alpha, [0.0; 2]);
            none &= (across / along).abs() < ROUNDING;
        }
    }
    Claim::trend(
        TEXT.said("no-lateral"),
        "less than 1e-13 of the force, seven exponents from −0.75 to 3",
        none,
    )
}

/// Pivoting about the slow side.
fn pivots() -> Result<Claim> {
    let [_, half, fast] = SPINS;
    let [slower, faster] = [curl(&pivot(), half)?, curl(&pivot(), fast)?];
    Ok(Claim::contradiction(
        TEXT.said("pivot-grows"),
        format!("{} m and {} m", short_metres(slower), short_metres(faster)),
        faster < slower,
    ))
}

/// How long and how far a rock slides and turns.
fn draws() -> Result<Vec<Claim>> {
    let plain = LeftRight { ice: ICE };
    let [straight, spinner] = [0.0, 3.0].map(|spin| shot(&plain, (DRAW, spin)));
    let (straight, spinner) = (straight?, spinner?);
    let [few, _, many] = SPINS.map(|spin| shot(&plain, (DRAW, spin)));
    let (few, many) = (few?.angle / TAU, many?.angle / TAU);
    let measured = shot(&LeftRight { ice: IceLaw::DRAW }, (DRAW_LAW_LAUNCH, 0.0))?;
    let [near, far] = [straight.position[0], spinner.position[0]];
    let slower = shot(&plain, (MEAN, 0.0))?.position[0];
    Ok(vec![
        Claim::refutation(
            TEXT.said("launch"),
            format!("{slower:.1} m from 1.4 m/s, {near:.1} m from {DRAW:.2} m/s"),
            slower < 14.0 && near > 28.0,
        )
        .printed("1.4"),
        Claim::trend(
            TEXT.said("spinner"),
            format!("{near:.2} m and {far:.2} m"),
            far > near,
        ),
        Claim::contradiction(
            TEXT.said("turns"),
            format!("{few:.1} and {many:.1} turns"),
            few > 1.0 && few < 1.5 && many > 4.5,
        )
        .printed("1 – 4"),
        Claim::contradiction(
            TEXT.said("draw-time"),
            format!("{:.1} s and {:.1} s", straight.time, measured.time),
            straight.time > 22.0 && measured.time > 22.0,
        )
        .printed("≈ 20 s"),
        Claim::not_checkable(TEXT.said("polished")),
    ])
}

/// v/(ωR) of both shots at their launch, on the band.
fn launch_ratios() -> Claim {
    let ratio = |(speed, spin): (f64, f64)| speed / (spin * CurlingRock::STANDARD.band_radius);
    let (draw, slow) = (ratio((DRAW, SPINS[2])), ratio(SLOW));
    Claim::trend(
        TEXT.said("launch-ratios"),
        format!("{draw:.0} or more, and {slow:.2}"),
        draw > 10.0 && slow < 0.2,
    )
}

/// γ of the slow shots, 0.0103 with v in m/s and α = −0.75, taken to km/h.
fn unit_of_coefficient() -> Claim {
    const SLOW_LAW: (f64, f64) = (0.0103, -0.75);
    /// km/h of one m/s.
    const UNIT: f64 = 3.6;
    let (gamma, alpha) = SLOW_LAW;
    // μ at 1 m/s, where the unit of γ is that of v to this power.
    let with_unit = |power: f64| gamma * UNIT.powf(power) * UNIT.powf(alpha);
    let (right, printed) = (with_unit(-alpha), with_unit(alpha));
    Claim::refutation(
        TEXT.said("unit"),
        format!(
            "{} and, with the unit as printed, {}",
            short(right),
            short(printed)
        ),
        (right / gamma - 1.0).abs() < 1e-14 && printed < 0.2 * gamma,
    )
}

/// Eq. 3.39's exponent, and what its coefficient would need.
fn heat_balance() -> Vec<Claim> {
    /// Passing times of a contact, a decade apart in speed, and the error of the cells.
    const TIMES: [f64; 2] = [0.25, 2.5];
    const CELLS: f64 = 2e-3;
    // Ice at −5 °C: warming in K, conductivity in W/(m K), heat capacity in J/(m³ K); band in m.
    let (warming, conductivity, capacity, band) = (5.0, 2.2, 1.9e6, 5e-3);
    let seen = heat::surface(&TIMES);
    // Flux μ P v over the time ℓ/v warms the surface by a fixed amount: μ = ΔT/(P v S(ℓ/v)).
    let exponent = match seen.as_slice() {
        [short, long] => (long / short).ln() / (TIMES[1] / TIMES[0]).ln() - 1.0,
        _ => f64::NAN,
    };
    let pressure = warming * f64::sqrt(PI * conductivity * capacity)
        / (2.0 * ICE.coefficient * f64::sqrt(band));
    vec![
        Claim::stated(
            TEXT.said("exponent"),
            ("−1/2", -0.5),
            exponent,
            Allowance::Exact(CELLS),
        ),
        Claim::not_checkable(
            TEXT.said("coefficient")
                .with("pressure", format!("{:.0}", 1e-6 * pressure)),
        )
        .printed("0.0080"),
    ]
}
