//! A tabulated function as cubics between equidistant knots.

/// Smallest number of knots for the five-point slopes.
pub(super) const FEWEST_KNOTS: usize = 5;

/// Position of a number between the knots.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnotPosition {
    segment: usize,
    /// Fraction of the distance to the next knot.
    t: f64,
}

/// Knots from 0 on, equally far apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grid {
    inv_step: f64,
    segments: usize,
}

impl Grid {
    /// *Domain*: `step` > 0, `knots` ≥ 2.
    pub fn new(step: f64, knots: usize) -> Self {
        Self {
            inv_step: 1.0 / step,
            segments: knots - 1,
        }
    }

    /// Position of `x`: at the last knot beyond it, before the first knot below 0, none for NaN.
    #[inline]
    pub fn spot(&self, x: f64) -> KnotPosition {
        let steps = x * self.inv_step;
        let segment = (steps as usize).min(self.segments - 1);
        let t = steps - segment as f64;
        let t = if t > 1.0 { 1.0 } else { t };
        KnotPosition { segment, t }
    }
}

/// The cubic between two knots; a pair reads a single cache line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
struct Segment {
    /// Coefficients of t³, t², t and 1.
    value: [f64; 4],
    /// Coefficients of t², t and 1.
    slope: [f64; 3],
}

/// Cubics with continuous slopes, as LAMMPS interpolates tables of embedded atoms: slopes at the
/// knots are differences of fourth order, of second order next to the ends and of first at them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Spline {
    segments: Vec<Segment>,
}

impl Spline {
    /// Through `values` at knots `step` apart. *Domain*: at least [`FEWEST_KNOTS`] values.
    pub fn through(values: &[f64], step: f64) -> Self {
        let slopes: Vec<f64> = (0..values.len()).map(|k| slope_at(values, k)).collect();
        let segment = |(f, d): (&[f64], &[f64])| {
            let rise = f[1] - f[0];
            let value = [
                d[0] + d[1] - 2.0 * rise,
                3.0 * rise - 2.0 * d[0] - d[1],
                d[0],
                f[0],
            ];
            let slope = [
                3.0 * value[0] / step,
                2.0 * value[1] / step,
                value[2] / step,
            ];
            Segment { value, slope }
        };
        Self {
            segments: values
                .windows(2)
                .zip(slopes.windows(2))
                .map(segment)
                .collect(),
        }
    }

    #[inline]
    pub fn value(&self, KnotPosition { segment, t }: KnotPosition) -> f64 {
        let [a, b, c, d] = self.segments[segment].value;
        ((a * t + b) * t + c) * t + d
    }

    #[inline]
    pub fn jet(&self, spot: KnotPosition) -> [f64; 2] {
        let [a, b, c] = self.segments[spot.segment].slope;
        [self.value(spot), (a * spot.t + b) * spot.t + c]
    }
}

/// Slope at a knot, per step.
fn slope_at(f: &[f64], k: usize) -> f64 {
    let last = f.len() - 1;
    match k {
        0 => f[1] - f[0],
        _ if k == last => f[k] - f[k - 1],
        _ if k == 1 || k + 1 == last => 0.5 * (f[k + 1] - f[k - 1]),
        _ => ((f[k - 2] - f[k + 2]) + 8.0 * (f[k + 1] - f[k - 1])) / 12.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_met_exactly_away_from_the_ends() {
        let f = |x: f64| 2.0 - x + 0.5 * x * x - 0.25 * x * x * x;
        let slope = |x: f64| -1.0 + x - 0.75 * x * x;
        let knots: Vec<f64> = (0..12).map(|k| f(0.25 * f64::from(k))).collect();
        let (grid, spline) = (Grid::new(0.25, 12), Spline::through(&knots, 0.25));
        for k in 0..100 {
            let x = 0.5 + 0.0175 * f64::from(k);
            let [value, rate] = spline.jet(grid.spot(x));
            assert!(
                (value - f(x)).abs() < 1e-14 && (rate - slope(x)).abs() < 1e-13,
                "{x}"
            );
        }
    }

    #[test]
    fn beyond_the_last_knot_the_last_value_stays() {
        let (grid, spline) = (
            Grid::new(1.0, 6),
            Spline::through(&[0.0, 1.0, 4.0, 9.0, 16.0, 25.0], 1.0),
        );
        assert_eq!(spline.value(grid.spot(7.5)), 25.0);
        assert_eq!(spline.value(grid.spot(f64::INFINITY)), 25.0);
        assert!(spline.value(grid.spot(f64::NAN)).is_nan());
    }
}
