//! Covariance at the minimum, and which readings it comes from.

use super::super::covariance::certainty;
use super::super::estimate::Uncertainty;
use super::super::minimise::{free, gradient};
use super::super::unknowns::Unknowns;
use super::weighted::Weighted;
use nalgebra::DMatrix;

/// Covariance of the coordinates at the minimum.
pub(super) struct Errors {
    /// Of all coordinates; rows of those without an error are 0.
    pub covariance: DMatrix<f64>,
    /// Parameters for which positions and angles pay: the parts of the trace of the projection on the Jacobian's columns.
    pub paid: [f64; 2],
    /// Parts of each coordinate's variance that the noise of positions and of angles makes.
    shares: Vec<[f64; 2]>,
    /// Coordinates inside their bounds.
    inside: Vec<usize>,
    /// Groups of coordinates that the frames do not tell apart.
    loose: Vec<Vec<usize>>,
}

impl Errors {
    /// At a minimum; `variance` is that of a residual over its noise. None where the motion has no derivatives.
    pub fn new(film: &Weighted<'_>, q: &[f64], variance: f64) -> Option<Self> {
        Self::of(film, &film.unknowns, q, variance)
    }

    /// The same for unknowns of which more are fixed.
    pub fn of(
        film: &Weighted<'_>,
        unknowns: &Unknowns<'_>,
        q: &[f64],
        variance: f64,
    ) -> Option<Self> {
        let (here, slopes) = film.slopes(unknowns, q)?;
        let bounds = film.bounds(unknowns);
        let inside = free(q, &bounds, &gradient(&slopes, &here));
        let lengths = film.lengths(unknowns);
        let sizes: Vec<f64> = inside.iter().map(|&k| lengths[k].least()).collect();
        let found = certainty(&slopes, &inside, &sizes, film.size());
        let mut covariance = DMatrix::zeros(q.len(), q.len());
        for (a, &i) in inside.iter().enumerate() {
            for (b, &j) in inside.iter().enumerate() {
                covariance[(i, j)] = variance * found.covariance[(a, b)];
            }
        }
        // How far each reading moves each coordinate.
        let pulls = slopes.select_columns(&inside) * &found.covariance;
        let (mut paid, mut shares) = ([0.0; 2], vec![[0.0; 2]; q.len()]);
        for (a, &k) in inside.iter().enumerate() {
            for reading in 0..pulls.nrows() {
                let (kind, pull) = (film.kind(reading), pulls[(reading, a)]);
                paid[kind] += pull * slopes[(reading, k)];
                shares[k][kind] += pull * pull;
            }
        }
        let outer = |direction: &Vec<f64>| {
            let places = inside.iter().zip(direction);
            places
                .filter(|(_, d)| **d != 0.0)
                .map(|(&k, _)| k)
                .collect()
        };
        let loose = found.loose.iter().map(outer).collect();
        Some(Self {
            covariance,
            paid,
            shares,
            inside,
            loose,
        })
    }

    /// 97.5 % quantiles of each coordinate's deviation over its standard error: the noise of each kind of reading is known
    /// from its own residuals (degrees of freedom after Satterthwaite 1946), or given.
    pub fn quantiles(&self, film: &Weighted<'_>, is_given: [bool; 2]) -> Vec<f64> {
        let left = [0, 1].map(|kind| {
            let readings = film.readings_of(kind) as f64;
            if is_given[kind] {
                f64::INFINITY
            } else {
                (readings - self.paid[kind]).max(1.0)
            }
        });
        let quantile = |[position, angle]: &[f64; 2]| {
            let whole = position + angle;
            if whole > 0.0 {
                let part = |share: f64, left: f64| (share / whole) * (share / whole) / left;
                student(1.0 / (part(*position, left[0]) + part(*angle, left[1])))
            } else {
                student(left[0].min(left[1]))
            }
        };
        self.shares.iter().map(quantile).collect()
    }

    /// Certainty of the parameter at coordinate `k`.
    pub fn known(&self, unknowns: &Unknowns<'_>, k: usize, values: &[f64]) -> Uncertainty {
        let parameter = |k: usize| &unknowns.model.parameters()[unknowns.sought[k]];
        if !self.inside.contains(&k) {
            return Uncertainty::AtBound;
        }
        let mut groups = self.loose.iter().filter(|group| group.contains(&k));
        if let Some(group) = groups.next() {
            let others = group.iter().filter(|&&other| other != k);
            return Uncertainty::Undetermined(others.map(|&other| parameter(other).name).collect());
        }
        let slope = parameter(k).range.derivative(values[unknowns.sought[k]]);
        Uncertainty::StandardError(self.covariance[(k, k)].sqrt() * slope)
    }

    /// Pairs of parameters that the frames hardly tell apart, and their correlation.
    pub fn entangled(&self, unknowns: &Unknowns<'_>) -> Vec<(&'static str, &'static str, f64)> {
        /// Correlation beyond which two parameters are hardly told apart.
        const ENTANGLED: f64 = 0.99;
        let name = |k: usize| unknowns.model.parameters()[unknowns.sought[k]].name;
        let c = &self.covariance;
        let mut pairs = Vec::new();
        for b in 0..c.nrows() {
            for a in 0..b {
                let correlation = c[(a, b)] / (c[(a, a)] * c[(b, b)]).sqrt();
                if correlation.abs() > ENTANGLED {
                    pairs.push((name(a), name(b), correlation));
                }
            }
        }
        pairs
    }
}

/// 97.5 % of a normal deviate lie below.
const NORMAL_QUANTILE: f64 = 1.959_963_984_540_054;

/// The 97.5 % quantile of Student's t (Cornish and Fisher 1937, to ν⁻³; 3e-3 from 5 degrees of freedom on).
fn student(freedoms: f64) -> f64 {
    let z = NORMAL_QUANTILE;
    let nu = freedoms.max(1.0);
    let (z3, z5) = (z * z * z, z * z * z * z * z);
    let z7 = z5 * z * z;
    z + (z3 + z) / (4.0 * nu)
        + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * nu * nu)
        + (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * nu * nu * nu)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (freedoms, table) in [
            (5.0, 2.5706),
            (10.0, 2.2281),
            (30.0, 2.0423),
            (f64::INFINITY, 1.96),
        ] {
            assert!((student(freedoms) - table).abs() < 3e-3, "{freedoms}");
        }
    }
}
