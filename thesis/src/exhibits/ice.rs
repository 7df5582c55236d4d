//! Figure 3.19 and eq. 3.39: friction on ice, from rest to the speeds of curling.

use crate::exhibit::{Exhibit, geometric, points};
use anyhow::Result;
use tribos_core::law::{LocalLaw, PlateauPower, PlateauPowerParameters, PowerLaw};
use tribos_report::claim::Claim;
use tribos_report::digits::short;
use tribos_report::figure::{Axis, Figure, Guide, Legend, Series};

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

fn granite() -> Result<PlateauPower<f64>> {
    let plateau = PlateauPower::<f64>::ICE_PLATEAU_SPEED;
    Ok(PlateauPower::new(PlateauPowerParameters {
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
        .guide(Guide::horizontal(ALUMINIUM_AT_REST, "aluminium at rest"))
        .legend(Legend::Below);
    let mut claims = plateau_claims(&granite)?;
    claims.extend(fits()?);
    claims.extend(unchecked());
    Ok(Exhibit {
        heading: "Figure 3.19: friction on ice".into(),
        text: vec![format!(
            "Penner's law 0.0080 v^(−1/2), made finite below {:e} m/s: a plateau, and a drop to \
             the share {REST_SHARE} of it at rest, half way at {DROP_SPEED:e} m/s. Drop and share \
             are ours: the thesis shows the measurements as a picture only. The other lines are the \
             fits that it quotes, with v in m/s.",
            PlateauPower::<f64>::ICE_PLATEAU_SPEED
        )],
        film: None,
        caption: "Friction on ice: the law with a plateau, the fits for curling stones, and two \
                  measured points of aluminium."
            .into(),
        drawing: Box::new(figure),
        columns: vec![
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
    })
}

/// The law with a plateau against what the thesis says of ice.
fn plateau_claims(granite: &PlateauPower<f64>) -> Result<Vec<Claim>> {
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
    let own_law = "our law with a plateau, made for it";
    Ok(vec![
        Claim::definition(
            "3.5.2",
            "Friction is constant for about two decades below 1e-4 m/s, down to 1e-6 m/s",
            format!(
                "from {low:.3} to {high:.3}, by {:.0} %",
                100.0 * (1.0 - low / high)
            ),
            low / high > 1.0 - CONSTANT,
            own_law,
        ),
        Claim::definition(
            "3.5.2",
            "and decreases for vanishing velocities to a finite value",
            format!("{rest:.3} at rest, {slow:.3} at 1e-6 m/s"),
            rest > 0.0 && rest < slow,
            own_law,
        ),
        Claim::trend(
            "3.5.2",
            "A negative exponent gives a diverging friction force for vanishing velocities",
            format!(
                "Penner's law gives {:.0} at 1e-12 m/s",
                pure.friction(1e-12)
            ),
            pure.friction(1e-12) > 1e3 && pure.friction(1e-24) > 1e9,
            "divergence",
        ),
        Claim::definition(
            "3.5.2",
            "Friction decreases with increasing velocity above the plateau",
            "at 200 speeds from 1e-4 to 10 m/s".into(),
            geometric(PLATEAU.1, 1e1, 200)
                .windows(2)
                .all(|v| granite.friction(v[1]) < granite.friction(v[0])),
            "the power −1/2, put in",
        ),
        Claim::definition(
            "eq. 3.39",
            "Penner: μ_d at 1 m/s, with the plateau",
            short(at_one),
            (at_one - PENNER.0).abs() < 5e-5,
            "the coefficient γ, put in",
        )
        .printed("0.0080"),
        Claim::formula(
            "eq. 3.39",
            "The plateau does not change μ_d at 1 m/s",
            (at_one / pure.friction(1.0) - 1.0).abs(),
            1e-7,
            "relative",
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
            "3.5.2",
            "Ice: friction can be an order of magnitude lower than on most other solids",
            format!("at most {highest} at 1 m/s in the four fits"),
            highest < 0.1,
            "the thesis' fits, put in",
        )
        .printed("0.0076, 0.0080, 0.0094, 0.0103"),
        Claim::trend(
            "3.5.2",
            "Aluminium at −10 °C: friction falls from rest to 0.03 and to 5 m/s",
            format!("between the two speeds like v^{exponent:.2}, inside the fits' −0.19 to −0.82"),
            ALUMINIUM_AT_REST > more && exponent < DRAW.1 && exponent > ROTATION.1[1],
            "sign and size of the exponent, from the thesis' three numbers",
        )
        .printed("0.38, 0.34, 0.04"),
    ])
}

/// Measurements.
fn unchecked() -> Vec<Claim> {
    vec![
        Claim::not_checkable(
            "fig. 3.19",
            "The measured friction of ice on granite and glass",
            "the measurements are not published as numbers",
        ),
        Claim::not_checkable(
            "3.5.2",
            "γ of eq. 3.39 from the material parameters of a curling stone",
            "the parameters are not in the thesis",
        )
        .printed("0.0080"),
        Claim::not_checkable(
            "3.5.2",
            "Penner: friction at the back would have to be so many times that in front",
            "the model's dimensions are not in the thesis",
        )
        .printed("10 – 100"),
    ]
}
