//! Figure 4.5 and section 4.5: ballistic deposits.

use super::exhibit::{Exhibit, claim, not_checked, refutation, statement};
use crate::command::deposit::curve::{COLUMNS, PorosityCurve, Sample, statistics, straight_line};
use crate::failure::Failure;
use crate::report::page::Claim;
use tribos::powder::deposit::{Ballistic, Until};

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
pub fn figure_4_5() -> Result<Exhibit, Failure> {
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
        drawing: Box::new(curve.figure()),
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
        statement(
            "The density is reduced with increasing capture radius",
            "monotonic",
            format!("solid fraction of the bulk from {touching:.4} at 2R to {sparse:.4} at 10R"),
            solid.windows(2).all(|pair| pair[0].1 < pair[1].1),
        ),
        linearity(&solid),
        statement(
            "Spheres that stick where they touch fill about 15 % (not in the thesis: Lubachevsky, \
             Privman & Roy 1992, arXiv cond-mat/9207014)",
            "0.15",
            format!("{touching:.4}"),
            (touching - 0.15).abs() < 0.01,
        ),
        not_checked(
            "The points of the figure",
            "drawn",
            "no numbers in the text; size of the deposits unknown",
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
    refutation(
        "The density depends approximately linearly on 1/r_capt",
        "a + b/r_capt",
        format!(
            "the best line misses the solid fraction by up to {:.0} % and is zero at {:.1}R; \
             r_capt^−{power:.2} misses it by {:.0} %",
            100.0 * worst,
            -slope / intercept,
            100.0 * rest
        ),
        worst > SCATTER && rest < SCATTER && intercept < 0.0,
        "on the scale of the porosity the curve looks nearly straight, but the solid fraction is a \
         power of r_capt; a line serves a short piece only",
    )
}

/// Spheres and porosities of the three systems.
fn system_claims() -> Result<Vec<Claim>, Failure> {
    let mut claims = Vec::new();
    for (name, width, height, spheres) in SYSTEMS {
        let ballistic = Ballistic::new(width, 1.0, 3.0).map_err(Failure::run)?;
        let sample = Sample::new(
            &ballistic,
            Until::Cut(height),
            FIRST_SEED..FIRST_SEED + DEPOSITS,
        )?;
        let (count, scatter) = statistics(&sample.particles);
        let away = (spheres - count) / scatter;
        let spheres = statement(
            &format!("Spheres of the {name}, {width}R × {width}R × {height}R, r_capt = 3R"),
            &format!("{spheres}"),
            format!("{count:.0}; the thesis' is {away:.1} deviations away"),
            away.abs() < 2.0,
        );
        claims.push(spheres.uncertain(format!("± {scatter:.0}, {DEPOSITS} deposits")));
        // 92.3 % is stated for the last, "approximately 92 %" for all.
        let stated = if width < 40.0 {
            ("92 %", 0.92)
        } else {
            ("92.3 %", 0.923)
        };
        let (porosity, scatter) = statistics(&sample.porosity);
        let porosity = claim(&format!("Porosity of the {name}"), stated, porosity, 0.01);
        claims.push(porosity.uncertain(format!("± {scatter:.1e}, {DEPOSITS} deposits")));
    }
    Ok(claims)
}
