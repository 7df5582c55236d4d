//! Friction of several feet in one time step: each block of the impulses on its own limit surface.

use crate::model::{Sets, numbers, twist_of, wrench_of};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use pyo3::PyResult;
use tribos_core::limit_surface::FrictionSet;

/// What a foot can carry in this step.
pub struct Limits<'a> {
    /// Its limit surfaces.
    pub sets: &'a dyn Sets,
    /// μN, in N.
    pub force: f64,
    /// Largest torque per force, in m.
    pub arm: f64,
}

/// The largest torque per force of a patch about its origin, in m.
pub fn arm(sets: &dyn Sets) -> PyResult<f64> {
    let mut arm = f64::NAN;
    let turn = twist_of([0.0, 0.0, 1.0]);
    sets.with(1.0, &mut |set| arm = set.support(&turn))?;
    Ok(arm)
}

/// Motions or friction of the feet in their contact planes: along x, along y, about the normal.
pub type Rows = Vec<Vector3<f64>>;

/// A step of the feet.
pub struct Step<'a> {
    /// What each foot can carry.
    pub limits: &'a [Limits<'a>],
    /// Acceleration of each foot, row by row, that unit friction of each foot gives, the response of the
    /// normal forces included.
    pub compliance: &'a [Matrix3<f64>],
    /// Relative motion of the step if no velocity changes, as a mean velocity.
    pub velocity: &'a [Vector3<f64>],
    /// Relative acceleration without friction.
    pub acceleration: &'a [Vector3<f64>],
    /// Time step, in s.
    pub dt: f64,
}

/// Friction in a step.
pub struct Solution {
    /// Friction on each foot.
    pub friction: Rows,
    /// Each foot is brought to rest relative to its floor, and stays there.
    pub is_held: Vec<bool>,
}

/// By how much friction must be exceeded to be exceeded beyond all rounding.
const BEYOND: f64 = 1.01;
/// Distance from the solution at which iterations end, in units of the largest friction: less than the time
/// step's own error while feet slide.
const TOLERANCE: f64 = 1e-7;
/// Acceleration that counts as none, in units of what the largest friction gives.
const REST: f64 = 1e-9;
/// Sweeps over the feet, at most.
const SWEEPS: usize = 200;
/// Steps on one foot in a sweep, at most.
const STEPS: usize = 60;
/// Share of the largest compliance that is added to all, such that a mechanism without some of the
/// motions has an inverse.
const FLOOR: f64 = 1e-12;
/// Share of each foot's own compliance that is added to that of several feet of one body, which has no
/// inverse, and how often the solution is refined for that.
const REGULARISATION: f64 = 1e-7;
const REFINEMENTS: usize = 3;
/// Reversals of motions slower than this share of the foot's speed are rounding.
const REVERSAL: f64 = 1e-9;

impl Step<'_> {
    /// Friction that would end the step at rest where the feet can carry it; otherwise that of the
    /// motion at half time, or at the end where a foot turns about, as in
    /// [`tribos_core::planar::PlanarBody::step`]. `start` is the friction of the step before.
    pub fn solve(&self, start: &[Vector3<f64>]) -> PyResult<Solution> {
        let metrics: Vec<Metric> = (0..self.limits.len())
            .map(|foot| Metric::new(&self.block(foot)))
            .collect();
        let at_end = self.rate(1.0 / self.dt);
        let ended = if self.is_beyond(&metrics, &at_end, start) {
            None
        } else {
            if let Some(held) = self.held_together(&metrics, &at_end, start)? {
                return Ok(held);
            }
            let ended = self.nearest(&metrics, &at_end, start)?;
            if ended.is_held.iter().all(|held| *held) {
                return Ok(ended);
            }
            Some(ended)
        };
        let midway = self.nearest(&metrics, &self.rate(2.0 / self.dt), start)?;
        if !self.turns_about(&self.after(&midway.friction)) {
            return Ok(midway);
        }
        let ended = match ended {
            Some(ended) => ended,
            None => self.nearest(&metrics, &at_end, start)?,
        };
        let after = self.after(&ended.friction);
        let motion = self
            .velocity
            .iter()
            .zip(&after)
            .map(|(now, then)| now + then);
        let power: f64 = motion.zip(&ended.friction).map(|(u, f)| u.dot(f)).sum();
        Ok(if power > 0.0 { midway } else { ended })
    }

    /// Friction that brings several feet to rest at once, if they can carry it: the change from `start` is
    /// the least one, as internal forces of feet of one body are not determined.
    fn held_together(
        &self,
        metrics: &[Metric],
        rate: &[Vector3<f64>],
        start: &[Vector3<f64>],
    ) -> PyResult<Option<Solution>> {
        let count = self.limits.len();
        if count == 1 {
            return Ok(None);
        }
        let mut system = DMatrix::from_fn(3 * count, 3 * count, |i, j| {
            self.compliance[i / 3 * count + j / 3][(i % 3, j % 3)]
        });
        for (foot, metric) in metrics.iter().enumerate() {
            for row in 0..3 {
                system[(3 * foot + row, 3 * foot + row)] +=
                    REGULARISATION * metric.compliance[(row, row)];
            }
        }
        let Some(factors) = system.cholesky() else {
            return Ok(None);
        };
        let mut friction = start.to_vec();
        for _ in 0..REFINEMENTS {
            let mut left = DVector::zeros(3 * count);
            for (foot, rate) in rate.iter().enumerate() {
                let rest = rate + self.response(foot, &friction);
                left.fixed_rows_mut::<3>(3 * foot).copy_from(&rest);
            }
            factors.solve_mut(&mut left);
            for (foot, friction) in friction.iter_mut().enumerate() {
                *friction -= left.fixed_rows::<3>(3 * foot);
            }
        }
        for (foot, metric) in metrics.iter().enumerate() {
            let (limits, friction_here) = (&self.limits[foot], &friction[foot]);
            let left = rate[foot] + self.response(foot, &friction);
            let scale = REST * metric.bound * limits.force;
            let is_at_rest = left.xy().norm() <= scale && left.z.abs() * limits.arm <= scale;
            let mut is_carried = false;
            if is_at_rest {
                limits.sets.with(limits.force, &mut |set| {
                    is_carried = metric.project(set, friction_here) == *friction_here;
                })?;
            }
            if !is_carried {
                return Ok(None);
            }
        }
        Ok(Some(Solution {
            friction,
            is_held: vec![true; count],
        }))
    }

    /// The acceleration that friction must take for rest after a time.
    fn rate(&self, inv_time: f64) -> Rows {
        let both = self.acceleration.iter().zip(self.velocity);
        both.map(|(acceleration, velocity)| acceleration + velocity * inv_time)
            .collect()
    }

    /// The acceleration of a foot by friction of all.
    fn response(&self, foot: usize, friction: &[Vector3<f64>]) -> Vector3<f64> {
        let row = &self.compliance[foot * friction.len()..];
        let each = row.iter().zip(friction);
        each.fold(Vector3::zeros(), |sum, (block, friction)| {
            sum + block * friction
        })
    }

    /// The velocity after the step.
    fn after(&self, friction: &[Vector3<f64>]) -> Rows {
        let both = self.acceleration.iter().zip(self.velocity).enumerate();
        both.map(|(foot, (acceleration, velocity))| {
            velocity + (acceleration + self.response(foot, friction)) * self.dt
        })
        .collect()
    }

    /// True if surely no foot comes to rest.
    fn is_beyond(&self, metrics: &[Metric], rate: &[Vector3<f64>], start: &[Vector3<f64>]) -> bool {
        if let ([limits], [metric]) = (self.limits, metrics) {
            let slope = rate[0] + self.compliance[0] * start[0];
            return !metric.needed(&start[0], &slope, limits).1;
        }
        // More acceleration of each foot than all of them can give it.
        let rows = self.compliance.chunks_exact(self.limits.len());
        rows.zip(rate).all(|(row, rate)| {
            let each = row.iter().zip(self.limits).map(|(block, limits)| {
                let force = block.fixed_view::<2, 2>(0, 0).norm();
                let torque = block.m13.hypot(block.m23) * limits.arm;
                (force + torque) * limits.force
            });
            rate.x.hypot(rate.y) > BEYOND * each.sum::<f64>()
        })
    }

    /// True if a foot's velocity or spin has another sense `after`.
    fn turns_about(&self, after: &[Vector3<f64>]) -> bool {
        let both = self.velocity.iter().zip(after).zip(self.limits);
        both.into_iter().any(|((u, v), limits)| {
            let arm_sq = limits.arm * limits.arm;
            let speed_sq = u.x * u.x + u.y * u.y + arm_sq * u.z * u.z;
            let least = -REVERSAL * REVERSAL * speed_sq;
            u.x * v.x + u.y * v.y < least || arm_sq * u.z * v.z < least
        })
    }

    /// A foot's own compliance.
    fn block(&self, foot: usize) -> Matrix3<f64> {
        let mut block = self.compliance[foot * self.limits.len() + foot];
        let arm_sq = self.limits[foot].arm.powi(2).max(f64::MIN_POSITIVE);
        let scale = FLOOR * (block.m11 + block.m22 + block.m33 * arm_sq);
        block.m11 += scale;
        block.m22 += scale;
        block.m33 += scale / arm_sq;
        block
    }

    /// Friction f of the sets with the least f·(½ compliance·f + rate): sweeps over the feet.
    fn nearest(
        &self,
        metrics: &[Metric],
        rate: &[Vector3<f64>],
        start: &[Vector3<f64>],
    ) -> PyResult<Solution> {
        let count = self.limits.len();
        let mut friction = start.to_vec();
        let mut is_held = vec![false; count];
        let scale = self.limits.iter().map(|l| l.force).fold(0.0, f64::max);
        for _ in 0..SWEEPS {
            let mut change: f64 = 0.0;
            for (foot, (metric, limits)) in metrics.iter().zip(self.limits).enumerate() {
                let before = friction[foot];
                let slope = rate[foot] + self.response(foot, &friction);
                let mut found = (before, false);
                limits.sets.with(limits.force, &mut |set| {
                    found = metric.nearest(set, &before, &slope, limits);
                })?;
                (friction[foot], is_held[foot]) = found;
                let moved = found.0 - before;
                let arm = limits.arm.max(f64::MIN_POSITIVE);
                change = change.max(moved.xy().norm()).max(moved.z.abs() / arm);
            }
            if count == 1 || change <= TOLERANCE * scale {
                break;
            }
        }
        Ok(Solution { friction, is_held })
    }
}

/// A foot's compliance as a metric for its friction.
struct Metric {
    compliance: Matrix3<f64>,
    inverse: Option<Matrix3<f64>>,
    /// The isotropic metric above it: acceleration per force, and the length that makes a force of a
    /// torque.
    bound: f64,
    length: f64,
    /// By which factor a step with the isotropic metric reduces the error, at least.
    contraction: f64,
}

impl Metric {
    fn new(compliance: &Matrix3<f64>) -> Self {
        // Equal diagonals: largest compliance of forces in the plane, and that of torques.
        let (a, b, c) = (compliance.m11, compliance.m22, compliance.m12);
        let largest = 0.5 * (a + b) + (0.5 * (a - b)).hypot(c);
        let length = (largest / compliance.m33).sqrt();
        let scaling = Vector3::new(1.0, 1.0, length);
        let scaled =
            Matrix3::from_fn(|i, j| compliance[(i, j)] * scaling[i] * scaling[j] / largest);
        let [least, most] = eigenvalues(&scaled);
        Self {
            compliance: *compliance,
            inverse: compliance.try_inverse(),
            bound: largest * most,
            length,
            contraction: (1.0 - least / most).clamp(0.0, 1.0 - f64::EPSILON),
        }
    }

    /// The nearest friction in the isotropic metric.
    fn project(&self, set: &dyn FrictionSet<f64>, wrench: &Vector3<f64>) -> Vector3<f64> {
        let wrench = wrench_of([wrench.x, wrench.y, wrench.z]);
        numbers(&set.project_with_length(&wrench, self.length).wrench).into()
    }

    /// The friction that would bring the foot to rest, and false if it is surely too large.
    fn needed(
        &self,
        start: &Vector3<f64>,
        slope: &Vector3<f64>,
        limits: &Limits<'_>,
    ) -> (Vector3<f64>, bool) {
        let Some(inverse) = &self.inverse else {
            return (*start, false);
        };
        let needed = start - inverse * slope;
        let most = BEYOND * limits.force;
        let is_near = needed.x * needed.x + needed.y * needed.y <= most * most
            && needed.z.abs() <= most * limits.arm;
        (needed, is_near)
    }

    /// The friction of `set` with the least energy, from `start` where the energy has this `slope`; true
    /// if it lies inside, where it brings the foot to rest.
    fn nearest(
        &self,
        set: &dyn FrictionSet<f64>,
        start: &Vector3<f64>,
        slope: &Vector3<f64>,
        limits: &Limits<'_>,
    ) -> (Vector3<f64>, bool) {
        let project = |wrench: &Vector3<f64>| self.project(set, wrench);
        let (needed, is_near) = self.needed(start, slope, limits);
        if is_near && project(&needed) == needed {
            return (needed, true);
        }
        // Steps in the isotropic metric, each pulled back to the surface.
        let rates = Vector3::new(1.0, 1.0, self.length * self.length) / self.bound;
        let left = self.contraction / (1.0 - self.contraction);
        let mut at = *start;
        for _ in 0..STEPS {
            let here = slope + self.compliance * (at - start);
            let next = project(&(at - here.component_mul(&rates)));
            let moved = next - at;
            at = next;
            let moved = moved.xy().norm().max(moved.z.abs() / self.length);
            if left * moved <= TOLERANCE * limits.force {
                break;
            }
        }
        (at, false)
    }
}

/// Off-diagonal elements up to which circles about the diagonal tell the eigenvalues well enough.
const NEARLY_DIAGONAL: f64 = 1e-2;

/// Bounds of the eigenvalues of a symmetric matrix.
fn eigenvalues(matrix: &Matrix3<f64>) -> [f64; 2] {
    let [xy, xz, yz] = [matrix.m12.abs(), matrix.m13.abs(), matrix.m23.abs()];
    if xy + xz + yz > NEARLY_DIAGONAL {
        let values = matrix.symmetric_eigenvalues();
        return [values.min(), values.max()];
    }
    let [x, y, z] = [matrix.m11, matrix.m22, matrix.m33];
    [
        (x - xy - xz).min(y - xy - yz).min(z - xz - yz),
        (x + xy + xz).max(y + xy + yz).max(z + xz + yz),
    ]
}
