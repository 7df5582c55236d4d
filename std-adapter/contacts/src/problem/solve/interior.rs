//! Interior point method on De Saxcé's form.
//!
//! For each mode k of a contact, y_k = (P, r_k/m_k) and z_k = (t_k, w_k) are in second-order cones and
//! orthogonal, with w_k = m_k u_k and
//!
//! ```text
//! u_N + Σ |w_k| = Σ t_k
//! ```
//!
//! The derivative of |w_k| belongs in Newton's matrix W + T D A: D is the square of the scaling of Nesterov and
//! Todd (Math. Oper. Res. 22 (1997) 1), A the map from r to all y, and T = Aᵀ − θ e_N gᵀ with g = w/|w|.
//! Steps have Mehrotra's predictor and corrector (SIAM J. Optim. 2 (1992) 575). Acary, Armand, Nguyen and
//! Shpakovych (Comput. Optim. Appl. 2024) iterate on the convex problem with |w| held.

use super::cone::{Cone, Local, MOST, Square};
use super::prepared::Prepared;
use super::scaling::{Point, Scaling};
use super::system::{Linear, System};

/// θ, the part of the derivative of |w| in the matrix: with all of it the matrix is singular more often.
const CURVATURE: f64 = 0.95;
/// Part of the way to the boundary that a step takes.
const TO_BOUNDARY: f64 = 0.99;
/// Below this length a step is made anew, nearer to the centre: σ at least [`CENTRED`], without corrector.
const SHORT: f64 = 0.1;
const CENTRED: f64 = 0.3;

/// |w|/t below which w counts as rounding.
const NOTHING: f64 = 1e-6;
/// Added to W in the matrix: most W have no full rank. Steps become shorter where only impulses that move
/// nothing change.
const SHIFT: f64 = 1e-10;

/// Added to W for the first guess of P, and the largest guess.
const SOFT: f64 = 1e-17;
const LARGEST_START: f64 = 1e18;

/// The iteration's state.
#[derive(Clone, Debug)]
pub(super) struct Interior {
    pub r: Vec<f64>,
    pub u: Vec<f64>,
    /// t_k and w_k of each mode of each contact; contacts without modes have t alone.
    dual: Vec<Point>,
    /// First mode of each contact in `dual`.
    first: Vec<usize>,
    /// Length of the last step.
    pub step: f64,
}

/// The first guess of P of a laden start.
fn load(problem: &Prepared, system: &mut System) -> f64 {
    let mut held: Vec<f64> = problem.q.iter().map(|q| -q).collect();
    system.factorise(problem, &vec![softened(); problem.contacts()]);
    system.solve(problem, &mut held);
    let normals = problem
        .w
        .first
        .iter()
        .take(problem.contacts())
        .map(|&at| held[at]);
    let sum: f64 = normals.map(|x| x * x).sum();
    let load = (sum / problem.contacts().max(1) as f64).sqrt();
    if load.is_finite() {
        load.clamp(1.0, LARGEST_START)
    } else {
        1.0
    }
}

/// B and C of W + [`SOFT`] I.
fn softened() -> Linear {
    let mut linear = Linear::default();
    for at in 0..MOST {
        linear.impulse[at][at] = SOFT;
    }
    linear
}

/// Modes of a contact as pairs of cones; one without modes has the half-line of P.
fn cones(cone: &Cone) -> usize {
    cone.modes().len().max(1)
}

impl Interior {
    /// Starts from P = t = 1, in scaled unknowns.
    pub fn start_at_unit(problem: &Prepared) -> Self {
        Self::at(problem, 1.0)
    }

    /// Starts from a larger P: the root mean square of the normal impulses that would stop all contacts if they
    /// could pull. Long chains and heavy bodies on light ones take many short steps from P = 1.
    pub fn start_at_stopping_impulse(problem: &Prepared, system: &mut System) -> Self {
        Self::at(problem, load(problem, system))
    }

    fn at(problem: &Prepared, start: f64) -> Self {
        let mut first = vec![0];
        for cone in &problem.cones {
            first.push(first.last().copied().unwrap_or(0) + cones(cone));
        }
        let mut r = vec![0.0; problem.q.len()];
        for contact in 0..problem.contacts() {
            r[problem.w.first[contact]] = start;
        }
        let mut u = vec![0.0; r.len()];
        problem.velocities(&r, &mut u);
        Self {
            dual: vec![[1.0, 0.0, 0.0, 0.0]; first.last().copied().unwrap_or(0)],
            first,
            r,
            u,
            step: 1.0,
        }
    }

    /// y_k of all modes.
    fn primal(&self, problem: &Prepared, r: &[f64]) -> Vec<Point> {
        let mut all = Vec::with_capacity(self.dual.len());
        for (contact, cone) in problem.cones.iter().enumerate() {
            let local = problem.local(contact, r);
            if cone.modes().is_empty() {
                all.push([local[0], 0.0, 0.0, 0.0]);
            }
            for mode in cone.modes() {
                let mut point = [local[0], 0.0, 0.0, 0.0];
                for (to, at) in point[1..].iter_mut().zip(mode.range()) {
                    *to = local[at] / mode.threshold;
                }
                all.push(point);
            }
        }
        all
    }

    /// One step; false if its direction is not finite.
    pub fn advance(&mut self, problem: &Prepared, system: &mut System) -> bool {
        let primal = self.primal(problem, &self.r);
        let scalings: Vec<Scaling> = primal
            .iter()
            .zip(&self.dual)
            .map(|(y, z)| Scaling::new(y, z))
            .collect();
        system.factorise(problem, &self.matrix(problem, &scalings));
        let gap = gap(&primal, &self.dual);
        // Predictor: towards complementarity itself.
        let target: Vec<Point> = self.dual.iter().map(|z| z.map(|x| -x)).collect();
        let (_, affine_y, affine_z) = self.direction(problem, system, &scalings, &target);
        let length = self.longest(&primal, &affine_y, &affine_z);
        let ahead = |from: &[Point], by: &[Point]| -> Vec<Point> {
            from.iter()
                .zip(by)
                .map(|(a, b)| std::array::from_fn(|at| a[at] + length * b[at]))
                .collect()
        };
        let left = self::gap(&ahead(&primal, &affine_y), &ahead(&self.dual, &affine_z)) / gap;
        let centring = if left > 0.0 {
            (left * left * left).min(1.0)
        } else {
            0.0
        };
        let corrected: Vec<Point> = (0..scalings.len())
            .map(|at| scalings[at].target(centring * gap, Some((&affine_y[at], &affine_z[at]))))
            .collect();
        let mut way = self.direction(problem, system, &scalings, &corrected);
        let mut length = TO_BOUNDARY * self.longest(&primal, &way.1, &way.2);
        if length < SHORT {
            let sigma = centring.max(CENTRED);
            let centred: Vec<Point> = scalings
                .iter()
                .map(|scaling| scaling.target(sigma * gap, None))
                .collect();
            way = self.direction(problem, system, &scalings, &centred);
            length = TO_BOUNDARY * self.longest(&primal, &way.1, &way.2);
        }
        if !length.is_finite() || !way.0.iter().all(|x| x.is_finite()) {
            return false;
        }
        let length = length.min(1.0);
        for (r, by) in self.r.iter_mut().zip(&way.0) {
            *r += length * by;
        }
        for (z, by) in self.dual.iter_mut().zip(&way.2) {
            for (z, by) in z.iter_mut().zip(by) {
                *z += length * by;
            }
        }
        self.step = length;
        problem.velocities(&self.r, &mut self.u);
        true
    }

    /// T D A at each contact.
    fn matrix(&self, problem: &Prepared, scalings: &[Scaling]) -> Vec<Linear> {
        let mut all = Vec::with_capacity(problem.contacts());
        for (contact, cone) in problem.cones.iter().enumerate() {
            let mut linear = Linear::default();
            for at in 0..cone.size() {
                linear.impulse[at][at] = SHIFT;
            }
            let start = self.first[contact];
            if cone.modes().is_empty() {
                linear.impulse[0][0] += scalings[start].square()[0][0];
            }
            for (number, mode) in cone.modes().iter().enumerate() {
                let square = scalings[start + number].square();
                let slope = unit(&self.dual[start + number]);
                add_mode(&mut linear.impulse, &square, &slope, mode);
            }
            all.push(linear);
        }
        all
    }

    /// Solves for Δr with Δz = target − D Δy; returns Δr, Δy and Δz.
    fn direction(
        &self,
        problem: &Prepared,
        system: &System,
        scalings: &[Scaling],
        target: &[Point],
    ) -> (Vec<f64>, Vec<Point>, Vec<Point>) {
        let mut right = vec![0.0; self.r.len()];
        for (contact, cone) in problem.cones.iter().enumerate() {
            let u = problem.local(contact, &self.u);
            let start = self.first[contact];
            let mut sum = Local::default();
            // T target, less what u lacks of T z.
            sum[0] = -u[0];
            if cone.modes().is_empty() {
                sum[0] += target[start][0] + self.dual[start][0];
            }
            for (number, mode) in cone.modes().iter().enumerate() {
                let (z, aim) = (&self.dual[start + number], &target[start + number]);
                let slope = unit(z);
                sum[0] += z[0] + aim[0];
                for (at, place) in mode.range().enumerate() {
                    let (w, slope, aim) = (z[at + 1], slope[at + 1], aim[at + 1]);
                    sum[0] -= slope * w + CURVATURE * slope * aim;
                    sum[place] = (w + aim) / mode.threshold - u[place];
                }
            }
            problem.put(contact, &sum, &mut right);
        }
        system.solve(problem, &mut right);
        let by_y = self.primal(problem, &right);
        let by_z = scalings
            .iter()
            .zip(&by_y)
            .zip(target)
            .map(|((scaling, y), aim)| {
                let moved = scaling.apply_square(y);
                std::array::from_fn(|at| aim[at] - moved[at])
            })
            .collect();
        (right, by_y, by_z)
    }

    /// The longest step, up to 1, that stays in all cones.
    fn longest(&self, primal: &[Point], by_y: &[Point], by_z: &[Point]) -> f64 {
        let mut longest = 1.0_f64;
        for (from, by) in primal.iter().zip(by_y).chain(self.dual.iter().zip(by_z)) {
            longest = longest.min(to_boundary(from, by));
        }
        longest
    }
}

/// Mean of y · z.
fn gap(primal: &[Point], dual: &[Point]) -> f64 {
    let sum: f64 = primal
        .iter()
        .zip(dual)
        .map(|(y, z)| y.iter().zip(z).map(|(a, b)| a * b).sum::<f64>())
        .sum();
    sum / primal.len().max(1) as f64
}

/// w/|w| behind a zero; less where w is nothing beside t, so that rounding has no direction.
fn unit(point: &Point) -> Point {
    let [t, a, b, c] = *point;
    let length = (a * a + b * b + c * c).sqrt() + NOTHING * t;
    [0.0, a / length, b / length, c / length]
}

/// Adds T D A of one mode.
fn add_mode(sum: &mut Square, square: &[[f64; 4]; 4], slope: &Point, mode: &super::cone::Mode) {
    let size = mode.end - mode.start;
    // Rows of T D: of the normal, then of the mode's unknowns.
    let mut rows = *square;
    for column in 0..=size {
        for at in 1..=size {
            rows[0][column] -= CURVATURE * slope[at] * square[at][column];
        }
    }
    let place = |at: usize| if at == 0 { 0 } else { mode.start + at - 1 };
    let factor = |at: usize| if at == 0 { 1.0 } else { 1.0 / mode.threshold };
    for row in 0..=size {
        for column in 0..=size {
            sum[place(row)][place(column)] += factor(row) * rows[row][column] * factor(column);
        }
    }
}

/// The step at which a point leaves its cone; infinite if it never does.
fn to_boundary(from: &Point, by: &Point) -> f64 {
    let product = |a: &Point, b: &Point| a[0] * b[0] - (a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
    let length = (from[1] * from[1] + from[2] * from[2] + from[3] * from[3]).sqrt();
    // Zeros of a s² + 2 b s + c, with c > 0 inside the cone.
    let (a, b) = (product(by, by), product(from, by));
    let c = (from[0] - length) * (from[0] + length);
    let root_sq = b * b - a * c;
    let mut first = f64::INFINITY;
    if a < 0.0 || (b < 0.0 && root_sq >= 0.0) {
        let root = root_sq.max(0.0).sqrt();
        first = if b > 0.0 {
            -(b + root) / a
        } else {
            c / (root - b)
        };
    }
    // The other nappe is behind the apex.
    if by[0] < 0.0 {
        first = first.min(-from[0] / by[0]);
    }
    first
}
