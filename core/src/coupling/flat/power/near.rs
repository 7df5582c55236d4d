//! Power laws where the centre of rotation is on the patch or not far away.
//!
//! In the notation of [`crate::coupling::flat`]'s dry friction, with β = 1 + α and div(ρ f) = (n + 2) f
//! for a function f of degree n,
//!
//! ```text
//! I = ∫r^β dt = ([t r^β] + β h E)/(1 + β),    E = h ∫r^(β−2) dt,    E₁ = ∫t r^(β−2) dt = [r^β]/β
//!
//! ∫r^β dA = Σ h I/(β+2),     ∫ρ r^(β−2) dA = Σ n I/β,     M = Σ (E n + E₁ τ) n
//! ```
//!
//! The force is ∫ρ r^(β−2) dA turned by a right angle, the torque ∫r^β dA, and the derivative of the
//! force is tr(M) − M, for every exponent. For β > 0 no term of I cancels another one on an edge that
//! has the centre's foot point on it. A linear pressure k = k(c) + g·ρ adds
//!
//! ```text
//! b = ∫ρ r^β dt,     ∫ρ r^β dA = Σ h b/(β+3),     ∫ρρ r^(β−2) dA = (Σ b n − ∫r^β dA)/β
//! derivative: g·Σ n I − Σ ∫ρ (g·ρ) r^(β−2) dt n + (Σ n I) g/β
//! ```

use super::prepared::{Corner, Line, PolygonPowerLaw};
use crate::coupling::flat::{Hessian, Reduced};
use crate::patch::outline::{Edge, PressureField};
use crate::real::Real;
use nalgebra::Vector2;

/// The integrals along one edge.
struct EdgeIntegrals<R> {
    h: R,
    /// E
    arc: R,
    /// E₁
    rise: R,
    /// I
    integral: R,
    /// ∫t r^β dt
    moment: R,
}

impl<R: Real> EdgeIntegrals<R> {
    #[inline(always)]
    fn new(power: &PolygonPowerLaw<R>, edge: &Edge<R>, centre: &Vector2<R>) -> Self {
        let (tangent, normal) = (edge.tangent(), edge.normal());
        let [of_beta, of_next, of_second] = power.inverses;
        let h = edge.offset() - (centre.x * normal.x + centre.y * normal.y);
        let t = edge.along() - (centre.x * tangent.x + centre.y * tangent.y);
        let from = Corner::new(power, h, t);
        let to = Corner::new(power, h, t + edge.length());
        let arc = match Line::new(power, h) {
            Some(line) => (power.arc(&line, &to) - power.arc(&line, &from)) * R::ONE.copysign(h),
            None => R::ZERO,
        };
        let rise = to.whole - from.whole;
        let ends = to.t * to.whole - from.t * from.whole;
        Self {
            h,
            arc,
            rise: rise * of_beta,
            integral: (ends + power.beta * h * arc) * of_next,
            moment: (to.sq * to.whole - from.sq * from.whole) * of_second,
        }
    }
}

/// Reduced friction about the centre of pressure for the spin `sense` (±1) about `centre`.
#[inline]
pub(super) fn friction<R: Real, K: PressureField<R>>(
    power: &PolygonPowerLaw<R>,
    (edges, pressure): (&[Edge<R>], &K),
    centre: &Vector2<R>,
    sense: R,
) -> Reduced<R> {
    let mut sums = WrenchSums::new();
    for edge in edges {
        sums.add::<K>(edge, &EdgeIntegrals::new(power, edge, centre));
    }
    sums.friction(power.beta, pressure, centre, sense)
}

/// The same, and minus its derivatives.
pub(super) fn friction_and_hessian<R: Real, K: PressureField<R>>(
    power: &PolygonPowerLaw<R>,
    (edges, pressure): (&[Edge<R>], &K),
    centre: &Vector2<R>,
    sense: R,
) -> (Reduced<R>, Hessian<R>) {
    let mut sums = WrenchSums::new();
    let mut across = DerivativeSums::new();
    for edge in edges {
        let seen = EdgeIntegrals::new(power, edge, centre);
        sums.add::<K>(edge, &seen);
        across.add(edge, pressure, &seen);
    }
    let reduced = sums.friction(power.beta, pressure, centre, sense);
    let [xx, xy, yy] = across.derivative(power.beta, pressure, centre, sums.pull());
    let hessian = about(centre, [xx, xy, yy], power.alpha * sense, &reduced);
    (reduced, hessian)
}

/// Minus the derivatives, given those of the force in the velocity. Times the twist they are α times
/// minus the wrench; `weight` is α times the sense of the spin.
fn about<R: Real>(
    centre: &Vector2<R>,
    [xx, xy, yy]: [R; 3],
    weight: R,
    reduced: &Reduced<R>,
) -> Hessian<R> {
    let (x, y) = (centre.x, centre.y);
    let xn = xy * x - xx * y - weight * reduced.force.x;
    let yn = yy * x - xy * y - weight * reduced.force.y;
    Hessian {
        xx,
        xy,
        yy,
        xn,
        yn,
        nn: yn * x - xn * y - weight * reduced.torque,
    }
}

/// Sums over the edges for the wrench.
struct WrenchSums<R: Real> {
    /// Σ τ I
    along: Vector2<R>,
    /// Σ I offset
    arm: R,
    /// Σ h I
    distance: R,
    /// Σ h b
    moment: Vector2<R>,
    /// Σ b n: xx, xy, yy
    spread: [R; 3],
}

impl<R: Real> WrenchSums<R> {
    fn new() -> Self {
        let zero = Vector2::new(R::ZERO, R::ZERO);
        Self {
            along: zero,
            arm: R::ZERO,
            distance: R::ZERO,
            moment: zero,
            spread: [R::ZERO; 3],
        }
    }

    #[inline(always)]
    fn add<K: PressureField<R>>(&mut self, edge: &Edge<R>, seen: &EdgeIntegrals<R>) {
        let (tangent, integral, h) = (edge.tangent(), seen.integral, seen.h);
        self.along += tangent * integral;
        self.distance += h * integral;
        if !K::IS_LINEAR {
            self.arm += integral * edge.offset();
            return;
        }
        let normal = edge.normal();
        let b = normal * (h * integral) + tangent * seen.moment;
        self.moment += b * h;
        for (sum, part) in self.spread.iter_mut().zip(symmetric(&b, &normal)) {
            *sum += part;
        }
    }

    /// Σ n I
    #[inline(always)]
    fn pull(&self) -> Vector2<R> {
        Vector2::new(self.along.y, -self.along.x)
    }

    #[inline(always)]
    fn friction<K: PressureField<R>>(
        &self,
        beta: R,
        pressure: &K,
        centre: &Vector2<R>,
        sense: R,
    ) -> Reduced<R> {
        let share = sense / beta;
        let distance = self.distance / (R::TWO + beta);
        if !K::IS_LINEAR {
            return Reduced {
                force: self.along * -share,
                torque: -(share * (self.arm - R::TWO * distance)),
            };
        }
        let ([slope_x, slope_y], here) = (pressure.slope(), at(pressure, centre));
        let [xx, xy, yy] = self.spread;
        let (xx, yy) = (xx - distance, yy - distance);
        // ∫k ρ r^(β−2)
        let pull = self.pull() * here
            + Vector2::new(slope_x * xx + slope_y * xy, slope_x * xy + slope_y * yy);
        let force = Vector2::new(share * pull.y, -(share * pull.x));
        let slanted = slope_x * self.moment.x + slope_y * self.moment.y;
        let torque = here * distance + slanted / (R::ONE + R::TWO + beta);
        Reduced {
            force,
            torque: centre.x * force.y - centre.y * force.x - sense * torque,
        }
    }
}

/// Pressure at a place.
#[inline(always)]
fn at<R: Real, K: PressureField<R>>(pressure: &K, place: &Vector2<R>) -> R {
    let [x, y] = pressure.slope();
    pressure.at_centre() + x * place.x + y * place.y
}

/// xx, xy and yy of the symmetric part of a product.
#[inline(always)]
fn symmetric<R: Real>(a: &Vector2<R>, b: &Vector2<R>) -> [R; 3] {
    [a.x * b.x, R::HALF * (a.x * b.y + a.y * b.x), a.y * b.y]
}

/// Sums over the edges for the derivatives.
struct DerivativeSums<R> {
    /// M: xx, xy, yy
    uniform: [R; 3],
    /// Σ ∫ρ (g·ρ) r^(β−2) dt n
    linear: [R; 3],
}

impl<R: Real> DerivativeSums<R> {
    fn new() -> Self {
        Self {
            uniform: [R::ZERO; 3],
            linear: [R::ZERO; 3],
        }
    }

    #[inline(always)]
    fn add<K: PressureField<R>>(&mut self, edge: &Edge<R>, pressure: &K, seen: &EdgeIntegrals<R>) {
        let (tangent, normal) = (edge.tangent(), edge.normal());
        let b = normal * seen.arc + tangent * seen.rise;
        for (sum, part) in self.uniform.iter_mut().zip(symmetric(&b, &normal)) {
            *sum += part;
        }
        if !K::IS_LINEAR {
            return;
        }
        let [x, y] = pressure.slope();
        let (out, on) = (x * normal.x + y * normal.y, x * tangent.x + y * tangent.y);
        // ∫h² r^(β−2), ∫h t r^(β−2) and ∫t² r^(β−2)
        let (nn, nt) = (seen.h * seen.arc, seen.h * seen.rise);
        let tt = seen.integral - nn;
        let b = normal * (out * nn + on * nt) + tangent * (out * nt + on * tt);
        for (sum, part) in self.linear.iter_mut().zip(symmetric(&b, &normal)) {
            *sum += part;
        }
    }

    /// Minus the derivative of the force in the velocity, given Σ n I.
    fn derivative<K: PressureField<R>>(
        &self,
        beta: R,
        pressure: &K,
        centre: &Vector2<R>,
        pull: Vector2<R>,
    ) -> [R; 3] {
        let here = at(pressure, centre);
        let [xx, xy, yy] = self.uniform;
        let uniform = [here * yy, -(here * xy), here * xx];
        if !K::IS_LINEAR {
            return uniform;
        }
        let [x, y] = pressure.slope();
        let even = x * pull.x + y * pull.y;
        let [sxx, sxy, syy] = symmetric(&pull, &Vector2::new(x / beta, y / beta));
        let [lxx, lxy, lyy] = self.linear;
        let [xx, xy, yy] = uniform;
        [
            xx + (even - lxx + sxx),
            xy + (sxy - lxy),
            yy + (even - lyy + syy),
        ]
    }
}
