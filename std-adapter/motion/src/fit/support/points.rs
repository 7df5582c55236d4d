//! A foot that stands on points: the limit surface is the sum of their discs.

use super::nnls::Normal;
use super::{Model, Row, size};
use nalgebra::{DVector, Matrix3, Vector2, Vector3};
use tribos_core::Real;
use tribos_core::patch::nodes::Node;

/// Points and the largest friction force of each.
#[derive(Clone, Debug)]
pub struct Points {
    places: Vec<[f64; 2]>,
    loads: Vec<f64>,
}

/// Where pushes do not decide, load is spread: so much of the mean diagonal of the normal equations for each
/// unknown. Medians of angles do not depend on it between 0 and ten times as much.
const RIDGE: f64 = 1e-4;
/// Load of a point, of the sum, below which it is left out.
const NO_LOAD: f64 = 1e-9;
/// A facet of the surface is a rotation about a point: there the friction of a point is made smooth over these
/// parts of the motion, one after the other.
const ROUNDING: [f64; 6] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
/// Most steps for one of them, and halvings of a step.
const MOST_STEPS: u32 = 40;
const MOST_HALVINGS: u32 = 30;
/// Part of the wrench at which a search ends, and that may be left at most at the end of the last one.
const LEFT: f64 = 1e-9;
const MOST_LEFT: f64 = 1e-6;

/// Velocity of a place.
fn velocity([x, y]: [f64; 2], motion: &Vector3<f64>) -> Vector2<f64> {
    Vector2::new(motion.x - motion.z * y, motion.y + motion.z * x)
}

/// The wrench of a force.
fn wrench([x, y]: [f64; 2], force: &Vector2<f64>) -> Vector3<f64> {
    Vector3::new(force.x, force.y, x * force.y - y * force.x)
}

impl Points {
    /// Points with loads.
    pub fn new(places: Vec<[f64; 2]>, loads: Vec<f64>) -> Self {
        Self { places, loads }
    }

    /// The loads with the least squares; `None` if they are not found.
    pub fn fitted(places: &[[f64; 2]], rows: &[Row]) -> Option<Self> {
        let mut normal = Normal::new(places.len());
        for row in rows {
            let unit = |place: &[f64; 2]| {
                let q = velocity(*place, &row.motion);
                let speed = Real::hypot(q.x, q.y);
                if speed > 0.0 {
                    wrench(*place, &(q / speed))
                } else {
                    Vector3::zeros()
                }
            };
            let columns: Vec<Vector3<f64>> = places.iter().map(unit).collect();
            for part in 0..3 {
                let line = DVector::from_iterator(columns.len(), columns.iter().map(|c| c[part]));
                normal.add(&line, row.wrench[part]);
            }
        }
        let loads = normal.solve(RIDGE * places.len() as f64)?;
        let least = NO_LOAD * loads.iter().sum::<f64>();
        let kept = places.iter().zip(loads).filter(|(_, load)| *load > least);
        let (places, loads) = kept.map(|(place, load)| (*place, load)).unzip();
        Some(Self { places, loads })
    }

    /// The points, with places in units of 1/`length`.
    pub fn nodes(&self, length: f64) -> Vec<Node<f64>> {
        let node = |([x, y], weight): (&[f64; 2], &f64)| Node {
            x: x * length,
            y: y * length,
            weight: *weight,
        };
        self.places.iter().zip(&self.loads).map(node).collect()
    }

    /// Power, its gradient and its second derivatives, with speeds √(q² + `smooth`²).
    fn power(&self, motion: &Vector3<f64>, smooth: f64) -> (f64, Vector3<f64>, Matrix3<f64>) {
        let (mut power, mut gradient) = (0.0, Vector3::zeros());
        let mut hessian = Matrix3::zeros();
        for (place, load) in self.places.iter().zip(&self.loads) {
            let q = velocity(*place, motion);
            let speed = (q.norm_squared() + smooth * smooth).sqrt();
            let (direction, rate) = (q / speed, load / speed);
            let along = wrench(*place, &direction);
            let [x, y] = [wrench(*place, &Vector2::x()), wrench(*place, &Vector2::y())];
            power += load * speed;
            gradient += along * *load;
            hessian += (x * x.transpose() + y * y.transpose() - along * along.transpose()) * rate;
        }
        (power, gradient, hessian)
    }
}

impl Model for Points {
    /// The motion with the least D²/2 − wrench·motion, by Newton's method with ever less smoothing; NaN if friction at
    /// the end does not balance the wrench.
    fn motion(&self, wanted: &Vector3<f64>) -> Vector3<f64> {
        let total: f64 = self.loads.iter().sum();
        let (mut at, mut smooth) = (wanted / total, 0.0);
        for part in ROUNDING {
            smooth = part * size(&at);
            for _ in 0..MOST_STEPS {
                let (power, gradient, hessian) = self.power(&at, smooth);
                let slope = gradient * power - wanted;
                if size(&slope) <= LEFT * size(wanted) {
                    break;
                }
                let curvature = gradient * gradient.transpose() + hessian * power;
                let lift = Matrix3::identity() * (f64::EPSILON * curvature.trace());
                let Some(factors) = (curvature + lift).cholesky() else {
                    break;
                };
                let step = -factors.solve(&slope);
                let here = 0.5 * power * power - wanted.dot(&at);
                let fall = slope.dot(&step);
                let mut share = 1.0;
                for _ in 0..MOST_HALVINGS {
                    let next = at + step * share;
                    let power = self.power(&next, smooth).0;
                    if 0.5 * power * power - wanted.dot(&next) <= here + 1e-4 * share * fall {
                        break;
                    }
                    share *= 0.5;
                }
                at += step * share;
            }
        }
        let (power, gradient, _) = self.power(&at, smooth);
        if size(&(gradient * power - wanted)) <= MOST_LEFT * size(wanted) {
            at
        } else {
            Vector3::repeat(f64::NAN)
        }
    }
}
