//! Figure 4.5 and section 4.5: ballistic deposits.

use crate::exhibit::Exhibit;
use anyhow::Result;
use tribos::powder::deposit::curve::{COLUMNS, PorosityCurve, Sample, statistics, straight_line};
use tribos::powder::deposit::{Ballistic, Until};
use tribos_report::claim::{Claim, Otherwise};
use tribos_report::runs::deposit::porosity;
use tribos_report::verdict::Allowance;

/// Base and height of the curve's deposits, in radii: large enough for 10R, and all of them grow
/// in a second. The thesis does not state its own.
const CURVE: [f64; 2] = [40.0, 200.0];
const FIRST_SEED: u64 = 1;

/// The thesis' systems at 3R: name, width, height, spheres. The width of the last follows from its
/// spheres, porosity and aspect ratio of 3.5.
const SYSTEMS: [(&str, f64, f64, f64); 3] = [
    ("small system", 20.0, 61.5, 470.0),
    ("large system", 25.0, 87.5, 1015.0),
    ("larger system", 40.0, 140.0, 4193.0),
];
/// Deposits of each system, so that the mean is good to a sixth of the scatter.
const DEPOSITS: u64 = 40;

/// Porosity over 1/r_capt.
pub fn figure_4_5() -> Result<Exhibit> {
    let [width, height] = CURVE;
    let curve = PorosityCurve::new(width, Until::Cut(height), FIRST_SEED)?;
    let mut claims = curve_claims(&curve);
    claims.extend(system_claims()?);
    Ok(Exhibit {
        heading: "Figure 4.5: porosity of ballistic deposits".into(),
        text: vec![
            "Spheres fall one by one and are captured as soon as the distance of centres to a \
             deposited sphere falls to r_capt, which is the only reading of \"closer than a \
             capture radius\" that gives the porosities of the thesis. A captured sphere goes the \
             shortest way to the sphere or substrate that captured it."
                .into(),
            format!(
                "Each point is the mean of five deposits on a base of {width}R × {width}R, \
                 cut at {height}R, with the standard deviation of one of them as bar. Small bases \
                 give denser deposits: on 20R × 20R the solid fraction is 5 % larger. Bulk means \
                 the middle half of the height."
            ),
            format!(
                "The thesis does not say how its deposits ended at the desired height. A deposit \
                 that grows higher and is cut there, spheres above being taken away, has the \
                 thesis' number of spheres in all three systems ({DEPOSITS} deposits of each \
                 here), and its highest sphere nearly touches a piston at the cut. A deposit that \
                 ends with the first sphere at that height is loose below it and has 9 % less."
            ),
        ],
        film: None,
        caption: "Porosity against inverse capture radius.".into(),
        drawing: Box::new(porosity(&curve)),
        columns: COLUMNS.to_vec(),
        rows: curve.rows.iter().map(|row| row.to_vec()).collect(),
        claims,
    })
}

fn curve_claims(curve: &PorosityCurve) -> Vec<Claim> {
    let solid = curve.solid();
    let (sparse, touching) = match (solid.first(), solid.last()) {
        (Some(first), Some(last)) => (first.1, last.1),
        _ => (f64::NAN, f64::NAN),
    };
    vec![
        Claim::trend(
            "4.5",
            "With increasing capture radius the density is reduced",
            format!("solid fraction of the bulk from {touching:.4} at 2R to {sparse:.4} at 10R"),
            solid.windows(2).all(|pair| pair[0].1 < pair[1].1),
            "monotony",
        ),
        linearity(&solid),
        Claim::own(
            "Solid fraction of spheres that stick where they touch",
            touching,
            (
                "0.15 of Lubachevsky, Privman and Roy 1992, arXiv cond-mat/9207014",
                0.15,
            ),
            0.01,
        ),
        Claim::not_checkable(
            "fig. 4.5",
            "The points of the figure",
            "no numbers in the text; the size of the deposits is not stated",
        ),
    ]
}

/// The density as a straight line and as a power.
fn linearity(solid: &[(f64, f64)]) -> Claim {
    /// Several times what five deposits scatter by.
    const SCATTER: f64 = 0.25;
    let (intercept, slope) = straight_line(solid);
    let miss = |&(x, y): &(f64, f64)| ((intercept + slope * x) / y - 1.0).abs();
    let worst = solid.iter().map(miss).fold(0.0, f64::max);
    let logs: Vec<(f64, f64)> = solid.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let (factor, power) = straight_line(&logs);
    let off = |&(x, y): &(f64, f64)| ((factor + power * x - y).exp() - 1.0).abs();
    let rest = logs.iter().map(off).fold(0.0, f64::max);
    Claim::contradiction(
        "4.5",
        "The density depends approximately linearly on 1/r_capt",
        format!(
            "the best line misses the solid fraction by up to {:.0} % and is zero at {:.1}R; \
             r_capt^−{power:.2} misses it by {:.0} %",
            100.0 * worst,
            -slope / intercept,
            100.0 * rest
        ),
        worst > SCATTER && rest < SCATTER && intercept < 0.0,
        "on the scale of the porosity the curve looks nearly straight, but the solid fraction is a \
         power of r_capt; a line serves a short piece only. Ours goes from 2R to 10R; the thesis' \
         range is in its figure alone",
    )
}

/// Spheres and porosities of the three systems.
fn system_claims() -> Result<Vec<Claim>> {
    let mut claims = Vec::new();
    for (name, width, height, spheres) in SYSTEMS {
        let ballistic = Ballistic::new(width, 1.0, 3.0)?;
        let sample = Sample::new(
            &ballistic,
            Until::Cut(height),
            FIRST_SEED..FIRST_SEED + DEPOSITS,
        )?;
        let (count, scatter) = statistics(&sample.particles);
        let consistent = "size. The thesis has one deposit and states no error; its number lies";
        let away = |stated: f64, mean: f64, scatter: f64| (stated - mean).abs() / scatter;
        let far = away(spheres, count, scatter);
        let inferred = if width < 40.0 { "" } else { " (inferred)" };
        let claim = Claim::trend(
            "4.5, 4.7",
            &format!(
                "Spheres of the {name}, {width}R × {width}R × {height}R{inferred}, r_capt = 3R"
            ),
            format!("{count:.0}"),
            far < 2.0,
            &format!("{consistent} {far:.1} deviations of one of ours from our mean"),
        );
        let uncertainty = format!("± {scatter:.0}, one of {DEPOSITS} deposits");
        claims.push(claim.printed(&format!("{spheres}")).uncertain(uncertainty));

        let (porosity, scatter) = statistics(&sample.porosity);
        let place = "4.5, 4.7";
        let what = format!("Initial porosity of the {name}");
        let shown = format!("{:.1} %", 100.0 * porosity);
        // 92.3 % belongs to one deposit, "approximately 92 %" to all at this capture radius.
        let claim = if width < 40.0 {
            Claim::compared(
                (place, &what),
                ("≈ 92 %", 92.0),
                (shown, 100.0 * porosity),
                Allowance::Digits(0.5),
                Otherwise::Failure,
            )
        } else {
            let far = away(0.923, porosity, scatter);
            let what_of_it =
                format!("{consistent} {far:.1} deviations of one of ours from our mean");
            Claim::trend(place, &what, shown, far < 2.0, &what_of_it).printed("92.3 %")
        };
        let uncertainty = format!("± {:.1} %, one of {DEPOSITS} deposits", 100.0 * scatter);
        claims.push(claim.uncertain(uncertainty));
    }
    Ok(claims)
}
