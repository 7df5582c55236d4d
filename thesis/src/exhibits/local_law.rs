//! Figure 3.3: the local law for several exponents.

use crate::exhibit::{Exhibit, linear};
use crate::text::Text;
use anyhow::Result;
use tribos_core::law::{LocalLaw, PowerLaw};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Series};

const TEXT: Text = Text(include_str!("figure-3.3.md"));

const EXPONENTS: [f64; 6] = [0.0, 0.1, 0.5, 1.0, 2.0, 3.0];

/// Friction of a surface element over its velocity.
pub fn figure_3_3() -> Result<Exhibit> {
    let mut figure = Figure::new(
        "Local friction −v|v|^(α−1)",
        Axis::linear("velocity v").range(-1.5, 1.5),
        Axis::linear("friction per γ and load").range(-1.6, 1.6),
    );
    let velocities = linear(-1.5, 1.5, 300);
    let mut rows: Vec<Vec<f64>> = velocities.iter().map(|&v| vec![v]).collect();
    let mut meet = true;
    let mut against = true;
    for alpha in EXPONENTS {
        let law = PowerLaw::new(alpha, 1.0)?;
        let friction = |v: f64| {
            if v == 0.0 {
                0.0
            } else {
                -law.friction(v.abs()).copysign(v)
            }
        };
        let points: Vec<_> = velocities.iter().map(|&v| (v, friction(v))).collect();
        for (row, (_, f)) in rows.iter_mut().zip(&points) {
            row.push(*f);
        }
        figure = figure.series(Series::line(format!("α = {alpha}"), points));
        meet &= friction(1.0) == -1.0;
        against &= velocities.iter().all(|&v| friction(v) * v <= 0.0);
    }
    let count = EXPONENTS.len();
    Ok(Exhibit::new(
        TEXT.prose(),
        figure,
        &[
            "velocity",
            "alpha_0",
            "alpha_0.1",
            "alpha_0.5",
            "alpha_1",
            "alpha_2",
            "alpha_3",
        ],
        rows,
        vec![Claim::definition(
            TEXT.said("meet"),
            format!("for {count} of {count} exponents"),
            meet && against,
        )],
    ))
}
