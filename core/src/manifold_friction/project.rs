//! The impulse of the friction set nearest to a candidate.

use core::f32::consts::FRAC_1_SQRT_2;

use super::{
    Curve, FrictionImpulse, FrictionLimits, InverseEffectiveMasses, Lanes, LimitCurve, TINY,
};

/// Weights of force and torque below this fraction of their sum act as this one in denominators.
const LEAST_WEIGHT: f32 = 1e-6;
/// Newton steps for the multiplier of the circle from which the search starts.
const STARTING_STEPS: usize = 2;
/// The start is the nearest point of the circle x² + y² = ρ², ρ = 1 + `WIDENING` (h₁ + h₂/2) σ (1 − σ) with
/// σ = y²/(x² + y²): close to the curve in between its ends. Least errors after two and three steps.
const WIDENING: f32 = 0.55;
/// Longest step along the curve, and the least one from which a second derivative is taken, in radians.
const LONGEST_STEP: f32 = 0.6;
const SHORT_STEP: f32 = 1e-4;
/// The candidate in units of the limits, and the metric in which the nearest point is looked for.
struct Scaled<T> {
    /// Weights of force and torque, and their products with the candidate.
    a: T,
    b: T,
    a_force: T,
    b_torque: T,
}

/// A step along the curve, and minus the derivative there of what it makes zero.
#[derive(Clone, Copy)]
struct Step<T> {
    angle: T,
    descent: T,
}

/// A point (s, c h(s²)) of the limit curve, s² + c² = 1, s and c ≥ 0.
#[derive(Clone, Copy)]
struct Point<T> {
    s: T,
    c: T,
}

#[inline(always)]
pub(super) fn project<T: Lanes, O: LimitCurve<T>>(
    candidate: &FrictionImpulse<T>,
    budget: &FrictionLimits<T>,
    inverse: &InverseEffectiveMasses<T>,
    outline: &O,
    steps: usize,
) -> FrictionImpulse<T> {
    let (zero, one, tiny) = (T::splat(0.0), T::splat(1.0), T::splat(TINY));
    let FrictionLimits {
        impulse: limit,
        torsion_radius: lever,
        dynamic_over_static: slip,
    } = *budget;

    // Without lever nothing turns; NaN passes.
    let [p1, p2] = candidate.tangential;
    let t = candidate.angular;
    let t = T::select(zero.below(lever), t, T::select(t.at_most(t), zero, t));
    let torque_limit = limit * lever;
    let force_sq = p1 * p1 + p2 * p2;
    let force = force_sq.sqrt();
    let torque = t.abs();

    // A candidate that static friction holds is left as it is.
    let inv_norm = one / (force + tiny);
    let mut direction = [p1 * inv_norm, p2 * inv_norm];
    let mut curve = outline.curve(direction);
    let (x, y) = (
        slip * force / (limit + tiny),
        slip * torque / (torque_limit + tiny),
    );
    let holds = curve.holds(x * x, y * y);
    if T::all(holds) {
        return FrictionImpulse {
            tangential: [p1, p2],
            angular: t,
        };
    }

    // Metric k |dp|² + kt dt² in units of the limits, as energies.
    let (force_weight, angular_weight) =
        (inverse.tangential * limit, inverse.angular * torque_limit);
    let (a, b) = (force_weight * limit, angular_weight * torque_limit);
    let sum = a + b;
    let least = T::splat(LEAST_WEIGHT) * sum;
    let (a, b) = (a.larger(least), b.larger(least));
    // Only the ratios of a, b, aP and bQ count: none may exceed 1.
    let start = force_weight * shorter_norm(p1, p2);
    let b_torque = angular_weight * torque;
    let unit = one / (start + b_torque + sum).larger(tiny);
    let force_weight = force_weight * unit;
    let mut scaled = Scaled {
        a: a * unit,
        b: b * unit,
        a_force: force_weight * force,
        b_torque: b_torque * unit,
    };

    let circle = scaled.nearest_of_circle(&curve, start * unit);
    let mut along = force;
    if O::TURNS {
        // The force turns towards the directions in which spin leaves more of it.
        let [multiplier, spinning_sq] = circle;
        let coupled = multiplier * spinning_sq;
        direction = outline.turned(direction, scaled.a + (multiplier - coupled), coupled);
        along = (p1 * direction[0] + p2 * direction[1]).larger(zero);
        scaled.a_force = force_weight * along;
        curve = outline.curve(direction);
    }
    let mut point = scaled.start(&curve, circle);
    let mut last = None;
    for _ in 0..steps {
        let step = scaled.step(&curve, point, last);
        point = point.turned(step.angle);
        last = Some(step);
    }
    let [h, ..] = curve.height(point.s * point.s);
    let carried = (point.s * limit).smaller(along);
    let angular = (point.c * h * torque_limit).smaller(torque);
    FrictionImpulse {
        tangential: [
            T::select(holds, p1, carried * direction[0]),
            T::select(holds, p2, carried * direction[1]),
        ],
        angular: T::select(holds, t, angular.signed_as(t)),
    }
}

/// A lower bound of the norm: at least 92 % of it, without root.
#[inline(always)]
fn shorter_norm<T: Lanes>(x: T, y: T) -> T {
    let (x, y) = (x.abs(), y.abs());
    x.larger(y).larger(T::splat(FRAC_1_SQRT_2) * (x + y))
}

impl<T: Lanes> Scaled<T> {
    /// The multiplier λ of the nearest point of a circle like the curve, (x, y) = (aP/(a + λ), bQ/(b + λ)), and
    /// nearly its share of spin, y²/(x² + y²).
    ///
    /// Newton's method for 1/|(x, y)|, which is nearly linear in λ, from below; its root by a Padé approximant,
    /// which errs to the same side. `start` ≤ aP.
    #[inline(always)]
    fn nearest_of_circle(&self, curve: &Curve<T>, start: T) -> [T; 2] {
        let (zero, one, tiny) = (T::splat(0.0), T::splat(1.0), T::splat(TINY));
        let Self {
            a,
            b,
            a_force: p,
            b_torque: q,
        } = *self;
        let diagonal = T::splat(FRAC_1_SQRT_2);
        let between = diagonal * start + (diagonal * q - a.larger(b));
        let mut multiplier = (start - a).larger(q - b).larger(between.larger(zero));
        let widening = T::splat(WIDENING) * (curve.h1 + T::splat(0.5) * curve.h2);
        let (mut spinning_sq, mut radius) = (zero, one);
        for _ in 0..STARTING_STEPS {
            let (over_a, over_b) = (a + multiplier, b + multiplier);
            let (x, y) = (p * over_b, q * over_a);
            let (x_sq, y_sq) = (x * x, y * y);
            let (sum, circle) = (x_sq + y_sq, (over_a * over_b) * radius);
            let circle_sq = circle * circle;
            let rise = (sum * (circle + circle)) * (sum - circle_sq);
            let slope = (sum + T::splat(3.0) * circle_sq) * (x_sq * over_b + y_sq * over_a);
            multiplier = (multiplier + rise / slope.larger(tiny)).larger(zero);
            spinning_sq = y_sq / sum.larger(tiny);
            radius = one + widening * (spinning_sq * (one - spinning_sq));
        }
        [multiplier, spinning_sq]
    }

    /// The point of the curve that has the multiplier of the circle, with h and q of the circle's point.
    #[inline(always)]
    fn start(&self, curve: &Curve<T>, [multiplier, spinning_sq]: [T; 2]) -> Point<T> {
        let (one, tiny) = (T::splat(1.0), T::splat(TINY));
        let (p, q) = (self.a_force, self.b_torque);
        let over_a = self.a + multiplier;
        let [h, slope, _] = curve.height(one - spinning_sq);
        let steep = h - (spinning_sq + spinning_sq) * slope;
        let (s, c) = (p * (multiplier + steep * h * self.b), steep * q * over_a);
        let scale = one / (s * s + c * c).larger(tiny).sqrt();
        Point {
            s: s * scale,
            c: c * scale,
        }
    }

    /// Newton's step for the angle φ, s = sin φ, at which a(P − x) x′ + b(Q − y) y′ = 0, corrected by the change
    /// of the slope since the step before.
    #[inline(always)]
    fn step(&self, curve: &Curve<T>, Point { s, c }: Point<T>, last: Option<Step<T>>) -> Step<T> {
        let (one, half) = (T::splat(1.0), T::splat(0.5));
        let (tiny, most) = (T::splat(TINY), T::splat(LONGEST_STEP));
        let (s_sq, c_sq, sc) = (s * s, c * c, s * c);
        let [h, h_slope, h_bend] = curve.height(s_sq);
        // y = c h, y′ = −s q, y″ = −c q − s q′, ′ = d/dφ.
        let double = c_sq + c_sq;
        let y = c * h;
        let q = h - double * h_slope;
        let half_q_slope = sc * (T::splat(3.0) * h_slope - double * h_bend);
        let y_slope = s * q;
        let y_bend = c * q + s * (half_q_slope + half_q_slope);
        let (from_x, from_y) = (self.a_force - self.a * s, self.b_torque - self.b * y);
        let residual = from_x * c - from_y * y_slope;
        let along = self.a * c_sq + from_x * s;
        let descent = (along + ((self.b * s_sq) * (q * q) + from_y * y_bend)).larger(tiny);
        let mut angle = (residual / descent).smaller(most).larger(-most);
        if let Some(last) = last {
            // Second derivative by the difference of the first ones; none after a step too short for it.
            let short = last.angle.abs().below(T::splat(SHORT_STEP));
            let change = T::select(short, T::splat(0.0), descent - last.descent);
            let over = T::select(short, one, last.angle) * descent;
            let factor = one - half * angle * (change / over);
            angle = angle * factor.smaller(T::splat(1.5)).larger(half);
        }
        Step { angle, descent }
    }
}

impl<T: Lanes> Point<T> {
    /// (s, c) + angle (c, −s), on the unit circle to the fourth power of the angle; the step after corrects the rest.
    #[inline(always)]
    fn turned(self, angle: T) -> Self {
        let Self { s, c } = self;
        let (one, half) = (T::splat(1.0), T::splat(0.5));
        let onto = T::splat(1.5) - half * (s * s + c * c);
        let (s, c) = (s * onto, c * onto);
        let scale = one - half * (angle * angle);
        Self {
            s: ((s + angle * c) * scale).abs(),
            c: ((c - angle * s) * scale).abs(),
        }
    }
}

impl<T: Lanes> Curve<T> {
    /// h and its first two derivatives at X. *Domain*: 0 ≤ X ≤ 1.
    #[inline(always)]
    fn height(&self, x_sq: T) -> [T; 3] {
        let Self { h1, h2, h4 } = *self;
        let (x_fourth, twice) = (x_sq * x_sq, h2 + h2);
        let four = T::splat(4.0) * h4;
        [
            (T::splat(1.0) + h1 * x_sq) + x_fourth * (h2 + h4 * x_fourth),
            (h1 + twice * x_sq) + (four * x_sq) * x_fourth,
            twice + (T::splat(3.0) * four) * x_fourth,
        ]
    }

    /// True where (x, y) is inside of the curve or on it, from x² and y².
    #[inline(always)]
    fn holds(&self, x_sq: T, y_sq: T) -> T::Mask {
        let one = T::splat(1.0);
        let [h, ..] = self.height(x_sq.smaller(one));
        y_sq.at_most((one - x_sq) * h * h)
    }
}
