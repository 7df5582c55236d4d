//! Friction of several feet in one time step: each block of the impulses on its own limit surface.

use crate::model::{Sets, numbers, twist_of, wrench_of};
use nalgebra::{Matrix3, Vector3};
use pyo3::PyResult;
use tribos_core::limit_surface::FrictionSet;

/// What a foot can carry in this step.
pub struct Limits<'a> {
    /// Its limit surfaces.
    pub sets: &'a Sets,
    /// μN, in N.
    pub force: f64,
    /// Largest torque per force, in m.
    pub arm: f64,
}

/// The largest torque per force of a patch about its origin, in m.
pub fn arm(sets: &Sets) -> PyResult<f64> {
    let turn = twist_of([0.0, 0.0, 1.0]);
    sets.with(1.0, |set| set.support(&turn))
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
    /// A search for each foot's friction stopped at its count: friction is in its set and gives no power all the same.
    pub is_missed: Vec<bool>,
}

/// By how much friction must be exceeded to be exceeded beyond all rounding.
const BEYOND: f64 = 1.01;
/// Distance from the solution at which iterations end, in units of the largest friction: less than the time
/// step's own error while feet slide.
const TOLERANCE: f64 = 1e-7;
/// Velocity that counts as none after sweeps, in units of what the largest friction changes in a step.
const STILL: f64 = 1e-6;
/// The same for friction that is found for all feet at once, which is accurate to rounding.
const REST: f64 = 1e-12;
/// The same for velocities of feet against each other, which friction does not change: a body that tilts on its contacts'
/// springs moves feet of different heights.
const GIVE: f64 = 1e-3;
/// Forces that move the feet together by less than this share of what each would do to a foot alone are forces between
/// feet: their heights differ by less than a hundredth of their distances.
const BETWEEN: f64 = 1e-4;
/// Sweeps over the feet, at most.
const SWEEPS: usize = 200;
/// Steps on one foot in a sweep, at most.
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
    pub fn solve(&self, start: &[Vector3<f64>]) -> PyResult<Solution> {
        let count = self.limits.len();
        let metrics: Vec<Metric> = (0..count)
            .map(|foot| Metric::new(&self.block(foot)))
            .collect();
        let at_end = self.rate(1.0 / self.dt);
        let mut is_missed = vec![false; count];
        let mut ended = None;
        if !self.is_beyond(&metrics, &at_end, start) {
            let is_held = vec![true; count];
            let none = vec![Vector3::zeros(); count];
            let mut together = self.held_together(&metrics, &at_end, &none)?;
            if together.is_none() {
                together = self.held_together(&metrics, &at_end, start)?;
            }
            if let Some(friction) = together {
                return Ok(Solution {
                    friction,
                    is_held,
                    is_missed,
                });
            }
            let (friction, are_held) = self.nearest(&metrics, &at_end, start, &mut is_missed)?;
            // A foot alone was held exactly; of several the last sweep moves those before.
            if are_held && (count == 1 || self.held(&metrics, &friction) == is_held) {
                return Ok(Solution {
                    friction,
                    is_held,
                    is_missed,
                });
            }
            ended = Some(friction);
        }
        let friction = self.sliding(&metrics, &at_end, start, ended, &mut is_missed)?;
        Ok(Solution {
            is_held: self.held(&metrics, &friction),
            friction,
            is_missed,
        })
    }

    /// Friction where not all feet come to rest at the end of the step: of the motion at half time, or of its end,
    /// which may be `ended` already.
    fn sliding(
        &self,
        metrics: &[Metric],
        at_end: &[Vector3<f64>],
        start: &[Vector3<f64>],
        ended: Option<Rows>,
        is_missed: &mut [bool],
    ) -> PyResult<Rows> {
        let at_half = self.rate(2.0 / self.dt);
        let (midway, _) = self.nearest(metrics, &at_half, start, is_missed)?;
        if !self.turns_about(&self.after(&midway)) {
            return Ok(self.without_power(midway));
        }
        let ended = match ended {
            Some(ended) => ended,
            None => self.nearest(metrics, at_end, start, is_missed)?.0,
        };
        Ok(if self.power(&ended) > 0.0 {
            self.without_power(midway)
        } else {
            ended
        })
    }

    /// Power that friction would give to the feet's mean motion.
    fn power(&self, friction: &[Vector3<f64>]) -> f64 {
        let after = self.after(friction);
        let motion = self
            .velocity
            .iter()
            .zip(&after)
            .map(|(now, then)| now + then)
            .collect::<Rows>();
        dot(&motion, friction)
    }

    /// Less friction, along itself, where a search that stopped at its count would have it give power.
    fn without_power(&self, friction: Rows) -> Rows {
        let power = self.power(&friction);
        if power <= 0.0 {
            return friction;
        }
        // The part that grows with the square of friction.
        let feet = 0..friction.len();
        let response: Rows = feet.map(|foot| self.response(foot, &friction)).collect();
        let own = self.dt * dot(&response, &friction);
        let share = if own > 0.0 {
            (1.0 - power / own).max(0.0)
        } else {
            0.0
        };
        friction.iter().map(|f| f * share).collect()
    }

    /// Which feet are at rest at the end.
    fn held(&self, metrics: &[Metric], friction: &[Vector3<f64>]) -> Vec<bool> {
        let after = self.after(friction);
        let each = after.iter().zip(metrics).zip(self.limits);
        each.map(|((after, metric), limits)| {
            let none = STILL * metric.bound * limits.force * self.dt;
            after.xy().norm() <= none && after.z.abs() * limits.arm <= none
        })
        .collect()
    }

    /// Friction that brings several feet to rest at the end of the step, if they can carry it. Of the many that do
    /// where feet belong to one body, it is the one with the least sum of squares in units of each foot's limit: forces
    /// between feet, which nothing determines, are none and do not wander. Conjugate residuals from no friction
    /// (Stiefel, Comment. Math. Helv. 29 (1955) 157) meet such forces last; what they leave is judged at each step.
    /// Where feet cannot carry them, friction without them is enough. From the friction of the step before it is
    /// the least change instead.
    fn held_together(
        &self,
        metrics: &[Metric],
        rate: &[Vector3<f64>],
        from: &[Vector3<f64>],
    ) -> PyResult<Option<Rows>> {
        let count = self.limits.len();
        if count == 1 {
            return Ok(None);
        }
        let limits = self.limits.iter();
        let units: Rows = limits
            .map(|l| Vector3::new(l.force, l.force, l.force * l.arm))
            .collect();
        let in_units = |rows: &[Vector3<f64>]| -> Rows {
            let each = rows.iter().zip(&units);
            each.map(|(row, unit)| row.component_mul(unit)).collect()
        };
        let feet = rate.iter().enumerate();
        let left: Rows = feet
            .map(|(foot, rate)| -(rate + self.response(foot, from)))
            .collect();
        let (mut left, none) = (in_units(&left), vec![Vector3::zeros(); count]);
        let (mut friction, mut along, mut change) = (from.to_vec(), none.clone(), none);
        let (mut before, mut enough) = (f64::INFINITY, None);
        // As many steps as unknowns are exact but for rounding.
        for _ in 0..=6 * count {
            // What friction along the acceleration that is left would change of it.
            let force = in_units(&left);
            let response: Rows = (0..count).map(|foot| self.response(foot, &force)).collect();
            let power = dot(&response, &force);
            let each = force.iter().zip(metrics);
            let alone: f64 = each
                .map(|(f, metric)| f.dot(&(metric.compliance * f)))
                .sum();
            let moved = in_units(&response);
            if self.is_rest(metrics, [&left, &moved], REST) {
                if self.are_inside(metrics, &friction)? {
                    return Ok(Some(friction));
                }
                break;
            }
            let is_between = power <= BETWEEN * alone;
            if enough.is_none() && is_between && self.is_rest(metrics, [&left, &moved], STILL) {
                enough = Some(friction.clone());
            }
            for foot in 0..count {
                along[foot] = force[foot] + along[foot] * (power / before);
                change[foot] = moved[foot] + change[foot] * (power / before);
            }
            let square = dot(&change, &change);
            if power.is_nan() || power <= 0.0 || square <= 0.0 {
                break;
            }
            for foot in 0..count {
                friction[foot] += along[foot] * (power / square);
                left[foot] -= change[foot] * (power / square);
            }
            before = power;
        }
        match enough {
            Some(friction) if self.are_inside(metrics, &friction)? => Ok(Some(friction)),
            _ => Ok(None),
        }
    }

    /// Whether all feet can carry their friction.
    fn are_inside(&self, metrics: &[Metric], friction: &[Vector3<f64>]) -> PyResult<bool> {
        let mut are_inside = true;
        for ((metric, limits), friction) in metrics.iter().zip(self.limits).zip(friction) {
            limits.sets.with(limits.force, |set| {
                are_inside = are_inside && metric.project(set, friction) == *friction;
            })?;
        }
        Ok(are_inside)
    }

    /// Whether the acceleration that is left is rest: each foot's velocity is none but for the give of contacts, and
    /// friction would change none of it, to this share of what the largest friction does. Both are in units of each
    /// foot's limit.
    fn is_rest(&self, metrics: &[Metric], [left, moved]: [&Rows; 2], share: f64) -> bool {
        let most = |row: &Vector3<f64>| row.xy().norm().max(row.z.abs());
        let each = left.iter().zip(moved).zip(metrics).zip(self.limits);
        each.into_iter().all(|(((left, moved), metric), limits)| {
            let full = metric.bound * limits.force;
            let unit = limits.force;
            most(left) / unit <= GIVE * full && most(moved) / (unit * unit) <= share * full * full
        })
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

    /// Friction f of the sets with the least f·(½ compliance·f + rate), by sweeps over the feet; true if the last one
    /// left all of them held.
    fn nearest(
        &self,
        metrics: &[Metric],
        rate: &[Vector3<f64>],
        start: &[Vector3<f64>],
        is_missed: &mut [bool],
    ) -> PyResult<(Rows, bool)> {
        let count = self.limits.len();
        let mut friction = start.to_vec();
        let mut found = vec![FootFriction::default(); count];
        let scale = self.limits.iter().map(|l| l.force).fold(0.0, f64::max);
        let mut is_met = false;
        for _ in 0..SWEEPS {
            let mut change: f64 = 0.0;
            for (foot, (metric, limits)) in metrics.iter().zip(self.limits).enumerate() {
                let before = friction[foot];
                let slope = rate[foot] + self.response(foot, &friction);
                found[foot] = limits.sets.with(limits.force, |set| {
                    metric.nearest(set, &before, &slope, limits)
                })?;
                friction[foot] = found[foot].friction;
                let moved = friction[foot] - before;
                let arm = limits.arm.max(f64::MIN_POSITIVE);
                change = change.max(moved.xy().norm()).max(moved.z.abs() / arm);
            }
            is_met = count == 1 || change <= TOLERANCE * scale;
            if is_met {
                break;
            }
        }
        for (missed, found) in is_missed.iter_mut().zip(&found) {
            *missed = *missed || found.is_cut || !is_met;
        }
        Ok((friction, found.iter().all(|found| found.is_held)))
    }
}

/// Sum of the products of all rows.
fn dot(first: &[Vector3<f64>], second: &[Vector3<f64>]) -> f64 {
    first.iter().zip(second).map(|(a, b)| a.dot(b)).sum()
}

/// Friction of one foot in a sweep.
#[derive(Clone, Default)]
struct FootFriction {
    friction: Vector3<f64>,
    /// It lies inside the set, where it brings the foot to rest.
    is_held: bool,
    /// The search stopped at its count.
    is_cut: bool,
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

    /// The friction of `set` with the least energy, from `start` where the energy has this `slope`.
    fn nearest(
        &self,
        set: &dyn FrictionSet<f64>,
        start: &Vector3<f64>,
        slope: &Vector3<f64>,
        limits: &Limits<'_>,
    ) -> FootFriction {
        let project = |wrench: &Vector3<f64>| self.project(set, wrench);
        let (needed, is_near) = self.needed(start, slope, limits);
        if is_near && project(&needed) == needed {
            return FootFriction {
                friction: needed,
                is_held: true,
                is_cut: false,
            };
        }
        // Steps in the isotropic metric, each pulled back to the surface.
        let rates = Vector3::new(1.0, 1.0, self.length * self.length) / self.bound;
        let left = self.contraction / (1.0 - self.contraction);
        let (mut friction, mut is_cut) = (*start, true);
        for _ in 0..STEPS {
            let here = slope + self.compliance * (friction - start);
            let next = project(&(friction - here.component_mul(&rates)));
            let moved = next - friction;
            friction = next;
            let moved = moved.xy().norm().max(moved.z.abs() / self.length);
            if left * moved <= TOLERANCE * limits.force {
                is_cut = false;
                break;
            }
        }
        FootFriction {
            friction,
            is_held: false,
            is_cut,
        }
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
