//! The data to be fitted in a scaled unit, and a sample of them.

use super::parameter::Model;
use super::reduce::power_of_two;
use super::unknowns::Unknowns;
use super::{Measurements, Motion};

/// Number of points in a sample; up to twice as many points are used without one.
const SAMPLE: usize = 2000;

/// Friction with its weights, in a unit in which neither overflows when squared.
pub(super) struct WeightedData {
    /// Friction as it was measured.
    pub friction: Vec<f64>,
    /// Smallest standard deviation over that of each point; empty if they are all alike.
    weights: Vec<f64>,
    /// A power of two that brings weighted friction to the order of 1.
    scale: f64,
    /// Factor of (prediction − friction)/σ.
    pub unit: f64,
}

impl WeightedData {
    pub fn new(data: &Measurements) -> Self {
        let friction = data.friction().to_vec();
        let sigma = data.sigma().unwrap_or_default();
        let least = sigma.iter().copied().fold(f64::INFINITY, f64::min);
        let least = if sigma.is_empty() { 1.0 } else { least };
        let least = power_of_two(least);
        let weights: Vec<f64> = sigma.iter().map(|s| least / s).collect();
        let weighted = friction.iter().enumerate();
        let weighted = weighted.map(|(i, f)| f.abs() * weights.get(i).unwrap_or(&1.0));
        let scale = 1.0 / power_of_two(weighted.fold(0.0, f64::max));
        Self {
            friction,
            weights,
            scale,
            unit: least * scale,
        }
    }

    /// Some of the points, in the same unit.
    pub fn thinned(&self, points: &[usize]) -> Self {
        let of = |values: &[f64]| {
            let picked = points.iter().filter_map(|&point| values.get(point));
            picked.copied().collect()
        };
        Self {
            friction: of(&self.friction),
            weights: of(&self.weights),
            ..*self
        }
    }

    /// The same without the points of a part, which weigh nothing.
    pub fn without(&self, is_left_out: impl Fn(usize) -> bool) -> Self {
        let weight = |point: usize| match is_left_out(point) {
            true => 0.0,
            false => self.weights.get(point).copied().unwrap_or(1.0),
        };
        Self {
            friction: self.friction.clone(),
            weights: (0..self.friction.len()).map(weight).collect(),
            ..*self
        }
    }

    /// (prediction − friction)/σ in the unit; `None` where the model refuses the coordinates.
    pub fn residuals(&self, unknowns: &Unknowns<'_>, q: &[f64]) -> Option<Vec<f64>> {
        self.residuals_of(unknowns.model, &unknowns.values(q))
    }

    /// The same for values of all parameters.
    pub fn residuals_of(&self, model: &dyn Model, values: &[f64]) -> Option<Vec<f64>> {
        let mut residuals = model.predict(values)?;
        for (r, f) in residuals.iter_mut().zip(&self.friction) {
            *r = (*r - f) * self.scale;
        }
        for (r, w) in residuals.iter_mut().zip(&self.weights) {
            *r *= w;
        }
        Some(residuals)
    }

    /// The largest friction.
    pub fn largest(&self) -> f64 {
        self.friction.iter().fold(0.0, |most, f| f.abs().max(most))
    }

    /// √Σ (friction/σ)² in the unit.
    pub fn size(&self) -> f64 {
        let weighted = self.friction.iter().enumerate().map(|(i, f)| {
            let x = f * self.scale * self.weights.get(i).unwrap_or(&1.0);
            x * x
        });
        weighted.sum::<f64>().sqrt()
    }

    /// The same in the unit of friction.
    pub fn floor_of_squares(&self) -> f64 {
        self.floor() / self.unit / self.unit
    }

    /// Sum of squares below which residuals are rounding.
    pub fn floor(&self) -> f64 {
        let grain = f64::EPSILON * self.size();
        grain * grain
    }
}

/// Rising indices of a sample, the first among them, if there are many points. Of steady sliding half
/// of it is spread over the points and half over the logarithm of the speed, so that sparse points
/// at the ends are not lost; of a record it is spread over the points, unless the model knows better.
pub(super) fn sample(data: &Measurements, model: &dyn Model) -> Option<Vec<usize>> {
    let count = data.friction().len();
    if count <= 2 * SAMPLE {
        return None;
    }
    let spread = |k: usize, parts: usize| k * (count - 1) / (parts - 1);
    let speeds = match data.motion() {
        Motion::Series { .. } => {
            let even = || (0..SAMPLE).map(|k| spread(k, SAMPLE)).collect();
            return Some(model.sample(SAMPLE).unwrap_or_else(even));
        }
        Motion::Steady { speeds } => speeds.iter().map(|v| v.abs()).collect::<Vec<f64>>(),
    };
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| speeds[a].total_cmp(&speeds[b]).then(a.cmp(&b)));
    let half = SAMPLE / 2;
    let ends = [order[0], order[count - 1]].map(|point| libm::log(speeds[point]));
    let near = |k: usize| {
        let share = k as f64 / (half - 1) as f64;
        let speed = libm::exp(ends[0] + share * (ends[1] - ends[0]));
        let place = order.partition_point(|&point| speeds[point] < speed);
        place.min(count - 1)
    };
    let places = (0..half).flat_map(|k| [spread(k, half), near(k)]);
    let points = places.map(|place| order[place]).chain([0]);
    let points: std::collections::BTreeSet<usize> = points.collect();
    Some(points.into_iter().collect())
}

#[cfg(test)]
mod tests {
    use super::super::FitLaw;
    use super::*;

    #[test]
    fn a_sample_reaches_from_end_to_end_and_keeps_rare_speeds() -> Result<(), super::super::FitError>
    {
        // Ten slow points among 50,000 that are alike.
        let speed = |k: usize| {
            if k < 10 {
                1e-3 * (k + 1) as f64
            } else {
                1.0 + 1e-6 * k as f64
            }
        };
        let speeds: Vec<f64> = (0..50_000).map(speed).collect();
        let data = Measurements::steady(speeds, vec![0.3; 50_000], None)?;
        let points = sample(&data, FitLaw::Coulomb.model(&data)?.as_ref()).unwrap_or_default();
        assert!(points.windows(2).all(|pair| pair[0] < pair[1]));
        assert!((0..10).all(|slow| points.contains(&slow)));
        assert!(points.contains(&49_999) && (SAMPLE / 2..=SAMPLE + 1).contains(&points.len()));

        let times = (0..50_000).map(f64::from).collect();
        let data = Measurements::series(times, vec![1.0; 50_000], vec![0.3; 50_000], None)?;
        let points = sample(&data, FitLaw::Coulomb.model(&data)?.as_ref()).unwrap_or_default();
        assert_eq!(
            (points.len(), points[0], points[SAMPLE - 1]),
            (SAMPLE, 0, 49_999)
        );
        Ok(())
    }
}
