//! Figure 3.19 and eq. 3.39: friction on ice, from rest to the speeds of curling.

use crate::exhibit::{Exhibit, geometric, points};
use crate::text::Text;
use anyhow::Result;
use tribos_core::law::{LocalLaw, PlateauPowerLaw, PlateauPowerLawParameters, PowerLaw};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Legend, ReferenceLine, Series};

const TEXT: Text = Text(include_str!("figure-3.19.md"));

/// γ and α of Penner's derivation, and the drop below the plateau (ours, m/s and share).
const PENNER: (f64, f64) = (0.0080, -0.5);
const DROP_SPEED: f64 = 1e-7;
const REST_SHARE: f64 = 0.5;
/// Measured laws of Shegelski et al. with the ends of the exponent of pure rotation.
const DRAW: (f64, f64) = (0.0076, -0.19);
const SLOW_SLIDE: (f64, f64) = (0.0103, -0.75);
const ROTATION: (f64, [f64; 2]) = (0.0094, [-0.52, -0.82]);
/// Bowden: aluminium on ice at −10 °C, at rest and at two speeds in m/s.
const ALUMINIUM_AT_REST: f64 = 0.38;
const ALUMINIUM: [(f64, f64); 2] = [(0.03, 0.34), (5.0, 0.04)];
/// Range of the plateau in the thesis, m/s.
const PLATEAU: (f64, f64) = (1e-6, 1e-4);

fn power((coefficient, alpha): (f64, f64)) -> Result<PowerLaw<f64>> {
    Ok(PowerLaw::new(alpha, coefficient)?)
}

fn granite() -> Result<PlateauPowerLaw<f64>> {
    let plateau = PlateauPowerLaw::<f64>::ICE_PLATEAU_SPEED;
    Ok(PlateauPowerLaw::new(PlateauPowerLawParameters {
        alpha: PENNER.1,
        coefficient: PENNER.0,
        plateau_speed: plateau,
        drop_speed: DROP_SPEED,
        rest_share: REST_SHARE,
    })?)
}

/// Friction on ice over the speed.
pub fn figure_3_19() -> Result<Exhibit> {
    let granite = granite()?;
    let laws = [
        ("Penner, v^(−1/2)", power(PENNER)?),
        ("draw shot, v^(−0.19)", power(DRAW)?),
        ("slow slide, fast spin, v^(−0.75)", power(SLOW_SLIDE)?),
        ("rotation, v^(−0.52)", power((ROTATION.0, ROTATION.1[0]))?),
        ("rotation, v^(−0.82)", power((ROTATION.0, ROTATION.1[1]))?),
    ];
    let rows: Vec<Vec<f64>> = geometric(1e-9, 1e1, 400)
        .into_iter()
        .map(|v| {
            let mut row = vec![v, granite.friction(v)];
            // The fits are for stones in motion; below 1 cm/s they are not drawn.
            row.extend(laws.iter().map(|(_, law)| {
                let is_shown = v > 1e-2;
                if is_shown { law.friction(v) } else { f64::NAN }
            }));
            row
        })
        .collect();
    let mut figure = Figure::new(
        "Friction on ice",
        Axis::log10("velocity [m/s]"),
        Axis::log10("coefficient of friction").range(1e-3, 2.0),
    )
    .series(Series::line("plateau and power", points(&rows, 0, 1)));
    for (column, (label, _)) in laws.iter().enumerate() {
        figure = figure.series(Series::dashed(*label, points(&rows, 0, column + 2)));
    }
    figure = figure
        .series(Series::points("aluminium, Bowden", ALUMINIUM.to_vec()))
        .guide(ReferenceLine::horizontal(
            ALUMINIUM_AT_REST,
            "aluminium at rest",
        ))
        .legend(Legend::Below);
    let mut claims = plateau_claims(&granite)?;
    claims.extend(fits()?);
    claims.extend(unchecked());
    Ok(Exhibit::new(
        TEXT.prose()
            .with(
                "plateau",
                format!("{:e}", PlateauPowerLaw::<f64>::ICE_PLATEAU_SPEED),
            )
            .with("share", REST_SHARE)
            .with("drop", format!("{DROP_SPEED:e}")),
        figure,
        &[
            "speed",
            "plateau_power",
            "penner",
            "draw",
            "slow_slide_fast_spin",
            "rotation_0.52",
            "rotation_0.82",
        ],
        rows,
        claims,
    ))
}

/// The law with a plateau against what the thesis says of ice.
fn plateau_claims(granite: &PlateauPowerLaw<f64>) -> Result<Vec<Claim>> {
    /// What "constant" may mean over two decades: ours. The power alone would change tenfold.
    const CONSTANT: f64 = 0.2;
    let values = geometric(PLATEAU.0, PLATEAU.1, 200);
    let (low, high) = values
        .into_iter()
        .map(|v| granite.friction(v))
        .fold((f64::MAX, 0.0_f64), |(l, h), f| (l.min(f), h.max(f)));
    let (rest, slow) = (granite.friction(0.0), granite.friction(PLATEAU.0));
    let pure = power(PENNER)?;
    let at_one = granite.friction(1.0);
    Ok(vec![
        Claim::definition(
            TEXT.said("plateau"),
            format!(
                "from {low:.3} to {high:.3}, by {:.0} %",
                100.0 * (1.0 - low / high)
            ),
            low / high > 1.0 - CONSTANT,
        ),
        Claim::definition(
            TEXT.said("drop"),
            format!("{rest:.3} at rest, {slow:.3} at 1e-6 m/s"),
            rest > 0.0 && rest < slow,
        ),
        Claim::trend(
            TEXT.said("divergence"),
            format!(
                "Penner's law gives {:.0} at 1e-12 m/s",
                pure.friction(1e-12)
            ),
            pure.friction(1e-12) > 1e3 && pure.friction(1e-24) > 1e9,
        ),
        Claim::definition(
            TEXT.said("decreasing"),
            "at 200 speeds from 1e-4 to 10 m/s",
            geometric(PLATEAU.1, 1e1, 200)
                .windows(2)
                .all(|v| granite.friction(v[1]) < granite.friction(v[0])),
        ),
        Claim::definition(
            TEXT.said("penner"),
            short(at_one),
            (at_one - PENNER.0).abs() < 5e-5,
        )
        .printed("0.0080"),
        Claim::formula(
            TEXT.said("plateau-far-away"),
            (at_one / pure.friction(1.0) - 1.0).abs(),
            1e-7,
        ),
    ])
}

/// The quoted fits side by side.
fn fits() -> Result<Vec<Claim>> {
    let at_one: Vec<f64> = [PENNER, DRAW, SLOW_SLIDE, (ROTATION.0, ROTATION.1[0])]
        .into_iter()
        .map(|law| Ok(power(law)?.friction(1.0)))
        .collect::<Result<_>>()?;
    let highest = at_one.iter().copied().fold(0.0, f64::max);
    let [(slow, more), (fast, less)] = ALUMINIUM;
    let exponent = (more / less).ln() / (slow / fast).ln();
    Ok(vec![
        Claim::definition(
            TEXT.said("slippery"),
            format!("at most {highest} at 1 m/s in the four fits"),
            highest < 0.1,
        )
        .printed("0.0076, 0.0080, 0.0094, 0.0103"),
        Claim::trend(
            TEXT.said("aluminium"),
            format!("between the two speeds like v^{exponent:.2}, inside the fits' −0.19 to −0.82"),
            ALUMINIUM_AT_REST > more && exponent < DRAW.1 && exponent > ROTATION.1[1],
        )
        .printed("0.38, 0.34, 0.04"),
    ])
}

/// Measurements.
fn unchecked() -> Vec<Claim> {
    vec![
        Claim::not_checkable(TEXT.said("measured-ice")),
        Claim::not_checkable(TEXT.said("material")).printed("0.0080"),
        Claim::not_checkable(TEXT.said("back-and-front")).printed("10 – 100"),
    ]
}
