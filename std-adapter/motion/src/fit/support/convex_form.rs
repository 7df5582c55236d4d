//! Ellipsoid and convex quartic: limit surfaces on which a form of the wrench is 1.

use super::nnls::Normal;
use super::{Model, Row, size};
use nalgebra::{DVector, Matrix3, Vector3};
use tribos_core::Real;

/// H(w) = Σ c (d·w)ⁿ with n = 2 or 4 and c ≥ 0 over fixed directions d, which is convex; it has any positive
/// definite quadratic form up to the fineness of the directions, and a cone of convex quartics.
#[derive(Clone, Debug)]
pub struct ConvexForm {
    degree: i32,
    /// Unit of the wrench.
    mean: f64,
    /// Direction and coefficient.
    terms: Vec<(Vector3<f64>, f64)>,
}

/// Directions, evenly over half of the sphere.
const DIRECTIONS: usize = 300;
/// Weight of the normal's parts across the measured motion, beside that of H = 1.
const ACROSS: f64 = 0.5;
/// Keeps the normal equations regular: a form has 6 or 15 coefficients, fewer than there are directions.
const RIDGE: f64 = 1e-9;
/// Most steps of Newton's method, and the part of a wrench that may be left.
const MOST_STEPS: u32 = 60;
const LEFT: f64 = 1e-12;

impl ConvexForm {
    /// The form of degree 2 or 4 with the least squares of H − 1 and of the parts of its gradient across the
    /// measured motions, for wrenches in units of their mean; `None` if they are not found.
    pub fn fitted(degree: i32, rows: &[Row]) -> Option<Self> {
        let mean = rows.iter().map(|row| size(&row.wrench)).sum::<f64>() / rows.len() as f64;
        let directions: Vec<Vector3<f64>> = (0..DIRECTIONS).map(direction).collect();
        let mut normal = Normal::new(DIRECTIONS);
        for row in rows {
            let wrench = row.wrench / mean;
            let lines = directions.iter().map(|d| (*d, d.dot(&wrench)));
            let values = lines.clone().map(|(_, p)| power(p, degree));
            normal.add(&DVector::from_iterator(DIRECTIONS, values), 1.0);
            let across = lines.map(|(d, p)| {
                let slope = d * (f64::from(degree) * power(p, degree - 1));
                (slope - row.motion * slope.dot(&row.motion)) * ACROSS
            });
            let across: Vec<Vector3<f64>> = across.collect();
            for part in 0..3 {
                let line = across.iter().map(|slope| slope[part]);
                normal.add(&DVector::from_iterator(DIRECTIONS, line), 0.0);
            }
        }
        let found = normal.solve(RIDGE)?;
        let terms = directions.into_iter().zip(found);
        Some(Self {
            degree,
            mean,
            terms: terms.filter(|(_, c)| *c > 0.0).collect(),
        })
    }
}

impl ConvexForm {
    /// The wrench with H = 1 whose normal is along a motion: where the gradient of H/n is the motion, by Newton's
    /// method, scaled; NaN if that does not end.
    pub fn wrench(&self, motion: &Vector3<f64>) -> Vector3<f64> {
        let (mut at, mut is_met) = (*motion, false);
        for _ in 0..MOST_STEPS {
            let (mut slope, mut curvature) = (-motion, Matrix3::zeros());
            for (d, c) in &self.terms {
                let along = d.dot(&at);
                slope += d * (c * power(along, self.degree - 1));
                let bend = f64::from(self.degree - 1) * c * power(along, self.degree - 2);
                curvature += d * d.transpose() * bend;
            }
            let lift = Matrix3::identity() * (f64::EPSILON * curvature.trace());
            let Some(factors) = (curvature + lift).cholesky() else {
                break;
            };
            let step = factors.solve(&slope);
            at -= step;
            is_met = size(&step) <= LEFT * size(&at);
            if is_met {
                break;
            }
        }
        if !is_met {
            return Vector3::repeat(f64::NAN);
        }
        let value = |(d, c): &(Vector3<f64>, f64)| c * power(d.dot(&at), self.degree);
        let value: f64 = self.terms.iter().map(value).sum();
        at * (self.mean / Real::pow(value, 1.0 / f64::from(self.degree)))
    }
}

impl Model for ConvexForm {
    fn motion(&self, wrench: &Vector3<f64>) -> Vector3<f64> {
        let unit = wrench / size(wrench);
        let slope = |(d, c): &(Vector3<f64>, f64)| d * (c * power(d.dot(&unit), self.degree - 1));
        self.terms.iter().map(slope).sum()
    }
}

/// xⁿ for n from 0 to 4.
fn power(x: f64, degree: i32) -> f64 {
    (0..degree).fold(1.0, |power, _| power * x)
}

/// Direction `i`, on a spiral.
fn direction(i: usize) -> Vector3<f64> {
    let golden = std::f64::consts::PI * (1.0 + 5.0_f64.sqrt());
    let (part, height) = (i as f64 + 0.5, 1.0 - (i as f64 + 0.5) / DIRECTIONS as f64);
    let (rim, angle) = ((1.0 - height * height).sqrt(), golden * part);
    Vector3::new(rim * Real::cos(angle), rim * Real::sin(angle), height)
}
