//! Data with the fitted law and its interval, and what is left.

use crate::failure::Failure;
use tribos::fit::{Fit, FitLaw, Measurements, Motion};
use tribos_report::figure::{Axis, Figure, Panels, ReferenceLine, Series};

/// Most measurements that are drawn: more of them hide each other, and fill files.
const MOST_DRAWN: usize = 4000;
/// Points of a curve.
const POINTS: usize = 400;
/// Standard deviations that 95 of 100 residuals do not exceed.
const BAND: f64 = 1.96;

/// Friction above, residuals below; of a record friction over the velocity between them.
pub fn panels(law: FitLaw, data: &Measurements, fit: &Fit) -> Result<Panels, Failure> {
    let plot = Plot {
        data,
        fit,
        stride: data.friction().len().div_ceil(MOST_DRAWN),
    };
    let panels = Panels::new("Measured and fitted friction", 1).cell(900, 380);
    Ok(match data.motion() {
        Motion::Steady { .. } => panels.figure(plot.steady(law)?).figure(plot.left()),
        Motion::Series { .. } => panels
            .figure(plot.over_time(law))
            .figure(plot.over_velocity(law))
            .figure(plot.left()),
    })
}

struct Plot<'a> {
    data: &'a Measurements,
    fit: &'a Fit,
    /// One point of so many is drawn.
    stride: usize,
}

impl Plot<'_> {
    /// Times of a record, or velocities.
    fn places(&self) -> &[f64] {
        self.data.times().unwrap_or(self.data.velocities())
    }

    fn drawn(&self, values: &[f64]) -> Vec<f64> {
        values.iter().copied().step_by(self.stride).collect()
    }

    fn pairs(&self, x: &[f64], y: &[f64]) -> Vec<(f64, f64)> {
        self.drawn(x).into_iter().zip(self.drawn(y)).collect()
    }

    /// Measured friction with its deviations.
    fn measured(&self, x: &[f64]) -> Series {
        let name = match self.stride {
            1 => "measured".to_owned(),
            stride => format!("measured, one point of {stride}"),
        };
        let points = Series::points(name, self.pairs(x, self.data.friction()));
        match self.data.sigma() {
            Some(sigma) => points.errors(self.drawn(sigma)),
            None => points,
        }
    }

    /// Speeds, of steady sliding in one direction on a logarithmic scale.
    fn speeds(&self) -> Axis {
        if self.data.times().is_none() && self.is_one_way() {
            Axis::log10("speed [m/s]")
        } else {
            Axis::linear("velocity [m/s]")
        }
    }

    fn is_one_way(&self) -> bool {
        self.data.velocities().iter().all(|v| *v > 0.0)
    }

    /// The curve over the speed, and the interval of the measured points about it.
    fn steady(&self, law: FitLaw) -> Result<Figure, Failure> {
        let curve = self.curve(law)?;
        let reach = BAND * self.fit.deviation();
        let mut figure = Figure::new("", self.speeds(), Axis::linear("friction"))
            .series(self.measured(self.data.velocities()));
        if !self.fit.is_weighted && !curve.is_empty() {
            for (name, shift) in [("95 % of the points", reach), ("", -reach)] {
                let moved = curve.iter().map(|(v, f)| (*v, f + shift)).collect();
                figure = figure.series(Series::dashed(name, moved));
            }
        }
        Ok(figure.series(Series::line(law.name(), curve)))
    }

    fn over_time(&self, law: FitLaw) -> Figure {
        let times = self.places();
        Figure::new("", Axis::linear("time [s]"), Axis::linear("friction"))
            .series(self.measured(times))
            .series(Series::line(
                law.name(),
                self.pairs(times, &self.fit.predictions),
            ))
    }

    fn over_velocity(&self, law: FitLaw) -> Figure {
        let velocities = self.data.velocities();
        Figure::new("", self.speeds(), Axis::linear("friction"))
            .series(self.measured(velocities))
            .series(Series::line(
                law.name(),
                self.pairs(velocities, &self.fit.predictions),
            ))
    }

    /// Residuals with the band of 95 %.
    fn left(&self) -> Figure {
        let axis = match self.data.motion() {
            Motion::Steady { .. } => self.speeds(),
            Motion::Series { .. } => Axis::linear("time [s]"),
        };
        let pairs = self.data.friction().iter().zip(&self.fit.predictions);
        let residuals: Vec<f64> = pairs.map(|(f, p)| f - p).collect();
        let left = Series::points("", self.pairs(self.places(), &residuals));
        let left = match self.data.sigma() {
            Some(sigma) => left.errors(self.drawn(sigma)),
            None => left,
        };
        let mut figure = Figure::new("", axis, Axis::linear("measured − fitted"))
            .series(left)
            .guide(ReferenceLine::horizontal(0.0, ""));
        if !self.fit.is_weighted {
            let reach = BAND * self.fit.deviation();
            figure = figure
                .guide(ReferenceLine::horizontal(reach, "95 %"))
                .guide(ReferenceLine::horizontal(-reach, ""));
        }
        figure
    }

    /// The law between the slowest and the fastest speed, where it needs nothing but the speed.
    fn curve(&self, law: FitLaw) -> Result<Vec<(f64, f64)>, Failure> {
        let velocities = self.data.velocities();
        let own = law.model(self.data).map_err(Failure::run)?;
        if own.parameters().len() != self.fit.parameters.len() || self.data.load().is_some() {
            // Inertia and loads differ from point to point.
            return Ok(Vec::new());
        }
        let low = velocities.iter().copied().fold(f64::INFINITY, f64::min);
        let high = velocities.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let at = |k: usize| {
            let share = k as f64 / POINTS as f64;
            if low > 0.0 {
                low * (high / low).powf(share)
            } else {
                low + (high - low) * share
            }
        };
        let all: Vec<f64> = (0..=POINTS).map(at).filter(|v| *v != 0.0).collect();
        let values: Vec<f64> = self
            .fit
            .parameters
            .iter()
            .map(|estimate| estimate.value)
            .collect();
        let friction = all.iter().map(|v| v.signum()).collect();
        let places = Measurements::steady(all.clone(), friction, None).map_err(Failure::run)?;
        let model = law.model(&places).map_err(Failure::run)?;
        let friction = model.predict(&values).unwrap_or_default();
        Ok(all.into_iter().zip(friction).collect())
    }
}
