//! The phase diagram of final motion in the (alpha, C) plane (fig. 3.10).

use crate::report::figure::{Axis, Color, Figure, Guide, Legend, Region, Series};
use tribos::record::series_csv;
use tribos_core::modes::inertia_interval;

/// Range of exponents shown, and steps in it.
const ALPHA: (f64, f64) = (0.0, 5.0);
const STEPS: usize = 200;
/// Upper end of C.
const C_MOST: f64 = 1.5;

/// Points (alpha, C).
type Curve = Vec<(f64, f64)>;

/// The two borders, from `from` to `to`.
fn borders(from: f64, to: f64) -> (Curve, Curve) {
    let alphas = (0..=STEPS).map(|i| from + (to - from) * i as f64 / STEPS as f64);
    alphas
        .map(|alpha| {
            let (low, high) = inertia_interval(alpha, 0.0);
            ((alpha, low), (alpha, high))
        })
        .unzip()
}

/// Region between two curves.
fn between(
    label: &str,
    low: &[(f64, f64)],
    high: &[(f64, f64)],
    fill: Color,
    label_at: (f64, f64),
) -> Region {
    let outline = low.iter().chain(high.iter().rev()).copied().collect();
    Region {
        label: label.into(),
        outline,
        fill,
        label_at,
    }
}

/// The diagram, with a body marked if one is given.
pub fn figure(body: Option<(f64, f64)>) -> Figure {
    let from = body.map_or(ALPHA.0, |(alpha, _)| alpha.min(ALPHA.0));
    let to = body.map_or(ALPHA.1, |(alpha, _)| alpha.max(ALPHA.1));
    let top = body.map_or(C_MOST, |(_, c)| C_MOST.max(1.1 * c));
    let (low, high) = borders(from, to);
    let below = [(from, 0.0), (to, 0.0)];
    let above = [(from, top), (to, top)];
    let (low_left, high_left) = borders(from, 1.0);
    let (low_right, high_right) = borders(1.0, to);
    let mut figure = Figure::new(
        "Final motion of a sliding, spinning body",
        Axis::linear("exponent α").range(from, to),
        Axis::linear("C = I/(M R²)").range(0.0, top),
    )
    .region(between(
        "ε → 0: spinning",
        &high,
        &above,
        Color::pale(0),
        (1.2, 0.85 * top),
    ))
    .region(between(
        "ε → ∞: sliding",
        &below,
        &low,
        Color::pale(1),
        (3.2, 0.12),
    ))
    .region(between(
        "ε₀ stable",
        &low_left,
        &high_left,
        Color::pale(2),
        (0.35, 0.46),
    ))
    .region(between(
        "ε₀ unstable: the start decides",
        &low_right,
        &high_right,
        Color::pale(3),
        (3.4, 0.62),
    ))
    .series(Series::line("lower bound of C", low))
    .series(Series::line("upper bound of C", high))
    .guide(Guide::horizontal(0.5, "disk"))
    .legend(Legend::Below);
    if let Some(body) = body {
        figure = figure.series(Series::points("this body", vec![body]));
    }
    figure
}

/// The borders as a table.
pub fn csv() -> String {
    let (low, high) = borders(-0.99, ALPHA.1);
    let rows: Vec<[f64; 3]> = low
        .iter()
        .zip(&high)
        .map(|(low, high)| [low.0, low.1, high.1])
        .collect();
    series_csv(
        &["alpha", "c_min", "c_max"],
        rows.iter().map(|row| row.as_slice()),
    )
}
