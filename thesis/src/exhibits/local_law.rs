//! Figure 3.3: the local law for several exponents.

use crate::exhibit::{Exhibit, linear};
use anyhow::Result;
use tribos_core::law::{LocalLaw, PowerLaw};
use tribos_report::claim::Claim;
use tribos_report::figure::{Axis, Figure, Series};

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
    Ok(Exhibit {
        heading: "Figure 3.3: local friction law".into(),
        text: vec![
            "Only the direction of the velocity counts for α = 0; for α = 1 the law is viscous. \
             At rest dynamic friction is undetermined; the kernel returns zero there."
                .into(),
        ],
        film: None,
        caption: "Friction of one surface element against its velocity.".into(),
        drawing: Box::new(figure),
        columns: vec![
            "velocity",
            "alpha_0",
            "alpha_0.1",
            "alpha_0.5",
            "alpha_1",
            "alpha_2",
            "alpha_3",
        ],
        rows,
        claims: vec![Claim::definition(
            "fig. 3.3",
            "All curves meet at |v| = 1 with |f| = 1, and f is opposite to v",
            format!("for {count} of {count} exponents"),
            meet && against,
            "the power law −v|v|^(α−1)",
        )],
    })
}
