//! The phase diagram of final motion in the (alpha, C) plane (fig. 3.10).

use crate::figure::{Axis, Color, Figure, Legend, ReferenceLine, Region, Series};
use std::convert::Infallible;
use tribos::record::series_csv;
use tribos_core::modes::inertia_interval;

/// Range of exponents shown, and steps in it.
const ALPHA: (f64, f64) = (-0.99, 5.0);
const STEPS: usize = 240;
/// Upper end of C, if the borders stay below it.
const C_MOST: f64 = 1.5;

/// Points (alpha, C).
type Curve = Vec<(f64, f64)>;

/// The borders of one patch.
#[derive(Debug)]
pub struct Diagram {
    /// Name of the patch.
    name: String,
    from: f64,
    low: Curve,
    high: Curve,
}

impl Diagram {
    /// The borders from the interval of C at each exponent, starting at `from`.
    pub fn new<E>(
        name: impl Into<String>,
        from: f64,
        mut interval: impl FnMut(f64) -> Result<(f64, f64), E>,
    ) -> Result<Self, E> {
        let (mut low, mut high) = (Curve::new(), Curve::new());
        for i in 0..=STEPS {
            let alpha = from + (ALPHA.1 - from) * i as f64 / STEPS as f64;
            let (least, most) = interval(alpha)?;
            low.push((alpha, least));
            high.push((alpha, most));
        }
        Ok(Self {
            name: name.into(),
            from,
            low,
            high,
        })
    }

    /// The uniform disk for α ≥ 0 (fig. 3.10).
    pub fn uniform_disk() -> Self {
        let interval = |alpha| Ok::<_, Infallible>(inertia_interval(alpha, 0.0));
        let Ok(diagram) = Self::new("uniform disk", 0.0, interval);
        diagram
    }

    /// Exponents from just above −1.
    pub fn whole<E>(
        name: impl Into<String>,
        interval: impl FnMut(f64) -> Result<(f64, f64), E>,
    ) -> Result<Self, E> {
        Self::new(name, ALPHA.0, interval)
    }

    /// The diagram, with a body (alpha, C) marked if one is given.
    pub fn figure(&self, body: Option<(f64, f64)>) -> Figure {
        let (from, to) = (self.from, ALPHA.1);
        let top = body.map_or(C_MOST, |(_, c)| C_MOST.max(1.1 * c));
        let side = |curve: &Curve, left: bool| -> Curve {
            let chosen = curve.iter().copied();
            chosen.filter(|point| (point.0 < 1.0) == left).collect()
        };
        let (below, above) = ([(from, 0.0), (to, 0.0)], [(from, top), (to, top)]);
        let cut = |curve: &Curve| -> Curve { curve.iter().map(|p| (p.0, p.1.min(top))).collect() };
        let high = cut(&self.high);
        let mut figure = Figure::new(
            format!("Final motion of a sliding, spinning body: {}", self.name),
            Axis::linear("exponent α").range(from, to),
            Axis::linear("C = I/(M R²)").range(0.0, top),
        )
        .region(between(
            "ε → 0: spinning",
            &high,
            &above,
            Color::pale(0),
            (1.2, 0.92 * top),
        ))
        .region(between(
            "ε → ∞: sliding",
            &below,
            &self.low,
            Color::pale(1),
            (3.2, 0.05 * top),
        ))
        .region(between(
            "ε₀ stable",
            &side(&self.low, true),
            &side(&high, true),
            Color::pale(2),
            (0.3 + 0.3 * from, 0.31 * top),
        ))
        .region(between(
            "ε₀ unstable: the start decides",
            &side(&self.low, false),
            &side(&high, false),
            Color::pale(3),
            (3.4, 0.4 * top),
        ))
        .series(Series::line("lower bound of C", self.low.clone()))
        .series(Series::line("upper bound of C", self.high.clone()))
        .legend(Legend::Below);
        match body {
            Some(body) => figure = figure.series(Series::points("this body", vec![body])),
            None => figure = figure.guide(ReferenceLine::horizontal(0.5, "disk")),
        }
        figure
    }

    /// The borders as a table.
    pub fn csv(&self) -> String {
        let rows: Vec<[f64; 3]> = self
            .low
            .iter()
            .zip(&self.high)
            .map(|(low, high)| [low.0, low.1, high.1])
            .collect();
        series_csv(
            &["alpha", "c_min", "c_max"],
            rows.iter().map(|row| row.as_slice()),
        )
    }
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
