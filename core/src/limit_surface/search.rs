//! The twist at which a strictly convex function of the dissipated power is least.
//!
//! Newton's method with steps that are halved until they descend; the derivation stands in
//! [`super::patch`].

use super::quadratic::{Factors, dot, dot_of_sizes, norm, outer};
use crate::real::Real;
use nalgebra::{Matrix3, Vector3};

/// Least pivot of a matrix, in rounding errors of its diagonal.
const PIVOT_ULPS: f64 = 4.0;
/// A gradient of this many rounding errors of the wrench is none.
const DONE_ULPS: f64 = 8.0;
/// A gradient of so many may be.
const ROUGH_ULPS: f64 = 32.0;
/// Most Newton steps; 12 were seen, 20 on strips of 1000:1.
const MOST_STEPS: usize = 40;
/// Halvings of a step.
pub(crate) const MOST_HALVINGS: usize = 30;
/// Share of the linear decrease that a step must bring.
const ENOUGH: f64 = 1e-4;

/// Power, gradient and Hessian at a twist, in units of the force limit and the arm.
pub(crate) struct Power<R: Real> {
    pub(crate) value: R,
    pub(crate) gradient: Vector3<R>,
    pub(crate) hessian: Matrix3<R>,
}

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ended {
    /// The gradient is zero to rounding.
    Level,
    /// A full step of Newton's method no longer shortens the gradient, which is its own rounding, or what is left of
    /// it is small.
    Rounding,
    /// Neither, within the steps allowed or for want of numbers.
    Missed,
}

/// Where a function is least.
pub(crate) struct Minimiser<R: Real> {
    pub(crate) at: Vector3<R>,
    pub(crate) power: Power<R>,
    /// How many steps were tried.
    pub(crate) steps: usize,
    pub(crate) ended: Ended,
    /// True on a facet, whose normal is the same everywhere.
    pub(crate) is_flat: bool,
}

/// A convex function of the twist that is to be least.
pub(crate) trait TwistObjective<R: Real> {
    /// Its value without the constant, and its gradient.
    fn value(&self, at: &Vector3<R>, power: R) -> R;
    /// The sum of the magnitudes of the value's terms: the value is known to rounding errors of it.
    fn terms(&self, at: &Vector3<R>, power: R) -> R;
    fn gradient(&self, at: &Vector3<R>, power: &Power<R>) -> Vector3<R>;
    fn matrix(&self, power: &Power<R>) -> Matrix3<R>;

    /// The wrench that is asked for.
    fn wrench(&self) -> &Vector3<R>;
    /// What the wrench of the surface counts in the gradient.
    fn reach(&self, power: &Power<R>) -> R;
    /// What a spin counts in the goal's own size of a twist, where the velocities count 1.
    fn spin_weight(&self) -> R;
    /// Where the function is least along a twist, in units of it.
    fn length_along(&self, twist: &Vector3<R>, power: R) -> R;
}

/// φ
pub(crate) struct GaugeObjective<R: Real> {
    pub(crate) wrench: Vector3<R>,
}

/// ψ, with wrench and twist in units of 1/`reach`: a wrench of any size is one of order 1.
pub(crate) struct ProjectionObjective<R: Real> {
    pub(crate) wrench: Vector3<R>,
    /// What the force limit counts, of the unit of the wrench.
    pub(crate) reach: R,
    /// Squared length of the distance, in arms.
    pub(crate) length_sq: R,
}

impl<R: Real> TwistObjective<R> for GaugeObjective<R> {
    fn value(&self, at: &Vector3<R>, power: R) -> R {
        R::HALF * power * power - dot(&self.wrench, at)
    }
    fn terms(&self, at: &Vector3<R>, power: R) -> R {
        R::HALF * power * power + dot_of_sizes(&self.wrench, at)
    }
    fn gradient(&self, _: &Vector3<R>, power: &Power<R>) -> Vector3<R> {
        power.gradient * power.value - self.wrench
    }
    fn matrix(&self, power: &Power<R>) -> Matrix3<R> {
        let g = &power.gradient;
        outer(g) + power.hessian * power.value
    }
    fn wrench(&self) -> &Vector3<R> {
        &self.wrench
    }
    fn reach(&self, power: &Power<R>) -> R {
        power.value
    }
    fn spin_weight(&self) -> R {
        R::ONE
    }
    fn length_along(&self, twist: &Vector3<R>, power: R) -> R {
        dot(&self.wrench, twist) / (power * power)
    }
}

impl<R: Real> ProjectionObjective<R> {
    /// M t
    pub(crate) fn displacement(&self, at: &Vector3<R>) -> Vector3<R> {
        Vector3::new(at.x, at.y, self.length_sq * at.z)
    }

    /// M⁻¹ displacement
    pub(crate) fn twist_along(&self, displacement: &Vector3<R>) -> Vector3<R> {
        Vector3::new(
            displacement.x,
            displacement.y,
            displacement.z / self.length_sq,
        )
    }
}

impl<R: Real> TwistObjective<R> for ProjectionObjective<R> {
    fn value(&self, at: &Vector3<R>, power: R) -> R {
        R::HALF * dot(at, &self.displacement(at)) + power * self.reach - dot(&self.wrench, at)
    }
    fn terms(&self, at: &Vector3<R>, power: R) -> R {
        let linear = power * self.reach + dot_of_sizes(&self.wrench, at);
        R::HALF * dot(at, &self.displacement(at)) + linear
    }
    fn gradient(&self, at: &Vector3<R>, power: &Power<R>) -> Vector3<R> {
        self.displacement(at) + power.gradient * self.reach - self.wrench
    }
    fn matrix(&self, power: &Power<R>) -> Matrix3<R> {
        let mut matrix = power.hessian * self.reach;
        matrix.m11 += R::ONE;
        matrix.m22 += R::ONE;
        matrix.m33 += self.length_sq;
        matrix
    }
    fn wrench(&self) -> &Vector3<R> {
        &self.wrench
    }
    fn reach(&self, _: &Power<R>) -> R {
        self.reach
    }
    fn spin_weight(&self) -> R {
        self.length_sq
    }
    fn length_along(&self, twist: &Vector3<R>, power: R) -> R {
        (dot(&self.wrench, twist) - power * self.reach) / dot(twist, &self.displacement(twist))
    }
}

/// A twist that a step leads to.
struct Trial<R: Real> {
    at: Vector3<R>,
    power: Power<R>,
    value: R,
    gradient: Vector3<R>,
}

impl<R: Real> Trial<R> {
    fn of(
        goal: &impl TwistObjective<R>,
        at: Vector3<R>,
        power_at: &impl Fn(&Vector3<R>) -> Power<R>,
    ) -> Self {
        let power = power_at(&at);
        Self {
            value: goal.value(&at, power.value),
            gradient: goal.gradient(&at, &power),
            at,
            power,
        }
    }
}

/// The twist at which `goal` is least, from `start` on, of a power whose `rounding` is given.
pub(crate) fn minimise<R: Real>(
    goal: &impl TwistObjective<R>,
    start: Vector3<R>,
    rounding: R,
    power_at: impl Fn(&Vector3<R>) -> Power<R>,
) -> Minimiser<R> {
    let noise = R::from_f64(DONE_ULPS) * rounding;
    let mut at = start;
    let mut power = power_at(&at);
    let mut steps = 0;
    let ended = loop {
        let gradient = goal.gradient(&at, &power);
        let size = norm(&gradient);
        if size <= noise {
            break Ended::Level;
        }
        if steps == MOST_STEPS || size.is_nan() {
            break ended_at(size);
        }
        steps += 1;
        let step = Factors::of(&goal.matrix(&power), pivot()).solve(&gradient);
        let descent = dot(&gradient, &step);
        let before = goal.value(&at, power.value);
        let slack = noise * (R::ONE + before.abs());
        let mut factor = R::ONE;
        let mut trial = Trial::of(goal, at - step, &power_at);
        // Where rounding hides what a step gains, its slope at the end decides.
        let most = -(R::from_f64(1.0 - 2.0 * ENOUGH) * descent);
        for _ in 0..MOST_HALVINGS {
            let enough = before - R::from_f64(ENOUGH) * factor * descent;
            let is_level = trial.value <= before + slack && dot(&trial.gradient, &step) >= most;
            if trial.value <= enough || is_level {
                break;
            }
            factor = R::HALF * factor;
            trial = Trial::of(goal, at - step * factor, &power_at);
        }
        let gains = norm(&trial.gradient) < size || trial.value < before - slack;
        // A step into a narrow bend levels the slope along it before it shortens the gradient.
        let is_level = dot(&trial.gradient, &step).abs() < R::HALF * descent;
        let bends = size > R::from_f64(ROUGH_ULPS) * rounding && is_level;
        if factor == R::ONE && size < rounding.sqrt() && !(gains || bends) {
            break Ended::Rounding;
        }
        (at, power) = (trial.at, trial.power);
    };
    Minimiser {
        at,
        power,
        steps,
        ended,
        is_flat: false,
    }
}

/// Least pivot, of its diagonal.
pub(crate) fn pivot<R: Real>() -> R {
    R::from_f64(PIVOT_ULPS) * R::EPSILON
}

/// What a gradient may leave where a search has ended otherwise, in units of the square root of a rounding error:
/// values are right to its square.
const MISSED: f64 = 64.0;

/// The end of a search whose gradient has this size.
pub(crate) fn ended_at<R: Real>(size: R) -> Ended {
    if size <= R::from_f64(MISSED) * rounding_gradient() {
        Ended::Rounding
    } else {
        Ended::Missed
    }
}

/// A gradient below which a full step that does not shrink it shows rounding.
pub(crate) fn rounding_gradient<R: Real>() -> R {
    R::EPSILON.sqrt()
}
