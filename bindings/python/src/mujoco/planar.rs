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

/// The feet's motion in their contact planes, three rows a foot: along x, along y, about the normal.
pub struct Step<'a> {
    /// What each foot can carry.
    pub limits: &'a [Limits<'a>],
    /// Acceleration that unit friction gives, the response of the normal forces included.
    pub compliance: &'a DMatrix<f64>,
    /// Relative velocity now.
    pub velocity: &'a DVector<f64>,
    /// Relative acceleration without friction.
    pub acceleration: &'a DVector<f64>,
    /// Time step, in s.
    pub dt: f64,
}

/// Friction in a step.
pub struct Solution {
    /// Force along x and y, torque about the normal, of each foot.
    pub friction: DVector<f64>,
    /// Each foot is brought to rest relative to its floor, and stays there.
    pub is_held: Vec<bool>,
}

/// By how much friction must be exceeded to be exceeded beyond all rounding.
const BEYOND: f64 = 1.01;
/// Distance from the solution at which the iteration ends, in units of the largest friction.
const TOLERANCE: f64 = 1e-9;
/// Sweeps over the feet, and steps on one foot in a sweep.
const SWEEPS: usize = 200;
const STEPS: usize = 60;
/// Share of the largest compliance that is added to all, such that a mechanism without some of the
/// motions has an inverse.
const FLOOR: f64 = 1e-12;
/// Reversals of motions slower than this share of the foot's speed are rounding.
const REVERSAL: f64 = 1e-9;

impl Step<'_> {
    /// Friction that would end the step at rest where the feet can carry it; otherwise that of the
    /// motion at half time, or at the end where a foot turns about, as in
    /// [`tribos_core::planar::PlanarBody::step`]. `start` is the friction of the step before.
    pub fn solve(&self, start: &DVector<f64>) -> PyResult<Solution> {
        let at_end = self.acceleration + self.velocity / self.dt;
        let ended = if self.is_beyond(&at_end) {
            None
        } else {
            Some(self.nearest(&at_end, start)?)
        };
        if let Some(held) = ended
            .as_ref()
            .filter(|end| end.is_held.iter().all(|held| *held))
        {
            return Ok(Solution {
                friction: held.friction.clone(),
                is_held: held.is_held.clone(),
            });
        }
        let at_half = self.acceleration + self.velocity * (2.0 / self.dt);
        let midway = self.nearest(&at_half, start)?;
        if !self.turns_about(&self.after(&midway.friction)) {
            return Ok(midway);
        }
        let ended = match ended {
            Some(ended) => ended,
            None => self.nearest(&at_end, start)?,
        };
        let power = ended
            .friction
            .dot(&(self.velocity + self.after(&ended.friction)));
        Ok(if power > 0.0 { midway } else { ended })
    }

    /// The velocity after the step.
    fn after(&self, friction: &DVector<f64>) -> DVector<f64> {
        self.velocity + (self.acceleration + self.compliance * friction) * self.dt
    }

    /// True if a lone foot surely does not come to rest.
    fn is_beyond(&self, rate: &DVector<f64>) -> bool {
        let [limits] = self.limits else {
            return false;
        };
        self.block(0).try_inverse().is_some_and(|inverse| {
            let needed = inverse * rate.fixed_rows::<3>(0);
            let most = BEYOND * limits.force;
            needed.x.hypot(needed.y) > most || needed.z.abs() > most * limits.arm
        })
    }

    /// True if a foot's velocity or spin has another sense `after`.
    fn turns_about(&self, after: &DVector<f64>) -> bool {
        (0..self.limits.len()).any(|foot| {
            let (u, v) = (
                self.velocity.fixed_rows::<3>(3 * foot),
                after.fixed_rows::<3>(3 * foot),
            );
            let arm = self.limits[foot].arm;
            let speed_sq = u.x * u.x + u.y * u.y + (arm * u.z).powi(2);
            let least = -REVERSAL * REVERSAL * speed_sq;
            u.x * v.x + u.y * v.y < least || arm * arm * u.z * v.z < least
        })
    }

    /// A foot's own compliance.
    fn block(&self, foot: usize) -> Matrix3<f64> {
        let mut block: Matrix3<f64> = self
            .compliance
            .fixed_view::<3, 3>(3 * foot, 3 * foot)
            .into_owned();
        let arm = self.limits[foot].arm;
        let scale = block.m11 + block.m22 + block.m33 * arm * arm;
        block.m11 += FLOOR * scale;
        block.m22 += FLOOR * scale;
        block.m33 += FLOOR * scale / (arm * arm).max(f64::MIN_POSITIVE);
        block
    }

    /// Friction f of the sets with the least f·(½ compliance·f + rate): sweeps over the feet.
    fn nearest(&self, rate: &DVector<f64>, start: &DVector<f64>) -> PyResult<Solution> {
        let count = self.limits.len();
        let mut solution = Solution {
            friction: start.clone(),
            is_held: vec![false; count],
        };
        let metrics: Vec<Metric> = (0..count)
            .map(|foot| Metric::new(self.block(foot)))
            .collect();
        let scale = self.limits.iter().map(|l| l.force).fold(0.0, f64::max);
        for _ in 0..SWEEPS {
            let mut change: f64 = 0.0;
            for (foot, metric) in metrics.iter().enumerate() {
                let limits = &self.limits[foot];
                let before: Vector3<f64> = solution.friction.fixed_rows::<3>(3 * foot).into_owned();
                let slope = rate.fixed_rows::<3>(3 * foot)
                    + self.compliance.rows(3 * foot, 3) * &solution.friction;
                let mut found = (before, false);
                limits.sets.with(limits.force, &mut |set| {
                    found = metric.nearest(set, &before, &slope, limits);
                })?;
                solution
                    .friction
                    .fixed_rows_mut::<3>(3 * foot)
                    .copy_from(&found.0);
                solution.is_held[foot] = found.1;
                let moved = found.0 - before;
                let arm = limits.arm.max(f64::MIN_POSITIVE);
                change = change.max(moved.xy().norm()).max(moved.z.abs() / arm);
            }
            if count == 1 || change <= TOLERANCE * scale {
                break;
            }
        }
        Ok(solution)
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
    fn new(compliance: Matrix3<f64>) -> Self {
        // Equal diagonals: largest compliance of forces in the plane, and that of torques.
        let (a, b, c) = (compliance.m11, compliance.m22, compliance.m12);
        let largest = 0.5 * (a + b) + (0.5 * (a - b)).hypot(c);
        let length = (largest / compliance.m33).sqrt();
        let scaling = Vector3::new(1.0, 1.0, length) / largest.sqrt();
        let scaled = Matrix3::from_fn(|i, j| compliance[(i, j)] * scaling[i] * scaling[j]);
        let values = scaled.symmetric_eigenvalues();
        let top = values.max();
        Self {
            compliance,
            inverse: compliance.try_inverse(),
            bound: largest * top,
            length,
            contraction: (1.0 - values.min() / top).clamp(0.0, 1.0 - f64::EPSILON),
        }
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
        let project = |wrench: &Vector3<f64>| -> Vector3<f64> {
            let wrench = wrench_of([wrench.x, wrench.y, wrench.z]);
            numbers(&set.project_with_length(&wrench, self.length).wrench).into()
        };
        // The friction that is needed, if it can be carried.
        if let Some(inverse) = &self.inverse {
            let needed = start - inverse * slope;
            let is_near = needed.x.hypot(needed.y) <= BEYOND * limits.force
                && needed.z.abs() <= BEYOND * limits.force * limits.arm;
            if is_near && project(&needed) == needed {
                return (needed, true);
            }
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

/// The largest torque per force of a patch about its origin, in m.
pub fn arm(sets: &dyn Sets) -> PyResult<f64> {
    let mut arm = f64::NAN;
    let turn = twist_of([0.0, 0.0, 1.0]);
    sets.with(1.0, &mut |set| arm = set.support(&turn))?;
    Ok(arm)
}
