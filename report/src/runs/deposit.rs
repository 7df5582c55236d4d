//! The porosity of ballistic deposits as a figure.

use crate::figure::{Axis, Color, Figure, Legend, Series};
use tribos::powder::deposit::curve::PorosityCurve;

/// Bulk porosity with error bars, and porosity below the highest point.
pub fn porosity(curve: &PorosityCurve) -> Figure {
    let points = |column: usize| curve.rows.iter().map(|row| (row[0], row[column])).collect();
    let mut figure = Figure::new(
        "Porosity of ballistic deposits",
        Axis::linear("1/r_capt [1/R]"),
        Axis::linear("porosity"),
    )
    .series(Series::line_points("bulk", points(4)).color(Color::palette(0)))
    .series(Series::dashed("below the highest point", points(2)).color(Color::palette(1)))
    .legend(Legend::BottomLeft);
    for row in &curve.rows {
        let bar = vec![(row[0], row[4] - row[5]), (row[0], row[4] + row[5])];
        figure = figure.series(Series::line("", bar).color(Color::palette(0)));
    }
    figure
}
