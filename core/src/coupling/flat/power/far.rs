//! Power laws on a patch that slides more than it turns, down to pure translation.
//!
//! The axes lie along the velocity of the centre of pressure, which is the unit of speed, and across
//! it. The velocity is (g, w x) with g = 1 − w y and q² = g² + w² x². Integrals over x at every y are
//!
//! ```text
//! ∫xʲ q^(α−1) dx = x^(j+1) g^(α−1) Sⱼ(z),     Sⱼ(z) = ∫₀¹ uʲ (1 + z u²)^((α−1)/2) du,     z = (w x/g)²
//! ```
//!
//! and those along the edges follow by Gauss' rule. Three functions serve for all, smooth ones of small
//! arguments: S₂, (S₁ − 1/2)/z, and A in g^α = 1 − w y A(w y). The others follow from them,
//!
//! ```text
//! S₀ = 1 + z S₀',   S₀' = β S₁ − (β+1) S₂,     S₃ = (β S₁ − 2 S₁')/(β+2)
//! q^(α−1) = g^(α−1) (1 + z E),   E = (β S₁ − 1)/(1 + z)
//! ```
//!
//! Since the pressure k has its centre at the origin, ∫k y = 0, and the torque is
//!
//! ```text
//! −∫k q^(α−1) (w x² − y g) = −∫k [w x² q^(α−1) − y (g q^(α−1) − 1)]
//! ```
//!
//! whose bracket is w times a function that has no difference of large numbers. Minus the
//! derivatives of force and torque are, with (f, e) = q^(α−1) (g, w x),
//!
//! ```text
//! across, across   ∂(x q^(α−1))/∂x
//! across, spin     x ∂(x q^(α−1))/∂x − (y/w) ∂f/∂x
//! spin, spin       x² ∂(x q^(α−1))/∂x − 2 (x y/w) ∂f/∂x + y² (β q^(α−1) − ∂(x q^(α−1))/∂x)
//! ```
//!
//! and the rest follows from Euler's theorem: the wrench is homogeneous of degree α in the twist.

use super::prepared::PolygonPowerLaw;
use crate::coupling::flat::pair_of_numbers::Pair2;
use crate::coupling::flat::pole_far::{EdgePairs, RotatedPressure, TranslatingMotion, by_rule};
use crate::coupling::flat::{Hessian, Reduced};
use crate::patch::outline::{Edge, PressureField};
use crate::real::Real;
use nalgebra::Vector2;

/// Distances of the centre of rotation, in half lengths of the longest edge, below which 16, 10, 8 and 6
/// points are taken and not 4.
const POINTS: [f64; 4] = [3.5, 6.0, 15.0, 300.0];

/// Integrals of a patch over x, at two points of an edge at once.
struct Point<'a, R: Real> {
    slide: &'a TranslatingMotion<'a, R>,
    power: &'a PolygonPowerLaw<R>,
    pressure: RotatedPressure<R>,
}

/// What the integrals at two points are made of.
struct Parts<R> {
    x: Pair2<R>,
    y: Pair2<R>,
    /// Pressure on the second axis, and its slope times x.
    here: Pair2<R>,
    slant: Pair2<R>,
    wy: Pair2<R>,
    z: Pair2<R>,
    /// 1/g and g^(α−1)
    inv_g: Pair2<R>,
    pace: Pair2<R>,
    /// S₁', S₁, S₂, S₃ and S₀'
    s1_rate: Pair2<R>,
    s1: Pair2<R>,
    s2: Pair2<R>,
    s3: Pair2<R>,
    s0_rate: Pair2<R>,
    /// g^α and A
    growth: [Pair2<R>; 2],
}

impl<R: Real> Point<'_, R> {
    #[inline(always)]
    fn parts<K: PressureField<R>>(&self, [x, y]: [Pair2<R>; 2]) -> Parts<R> {
        let one = Pair2::of(R::ONE);
        let (w, beta) = (Pair2::of(self.slide.spin), self.power.beta);
        let wy = w * y;
        let inv_g = (one - wy).inverse();
        let sigma = w * x * inv_g;
        let z = sigma * sigma;
        let rate = self.power.growth.at_two(wy);
        let speed = one - wy * rate;
        let s1_rate = self.power.first_rate.at_two(z);
        let s2 = self.power.second.at_two(z);
        let s1 = Pair2::of(R::HALF) + z * s1_rate;
        let s1_beta = Pair2::of(beta) * s1;
        Parts {
            x,
            y,
            here: self.pressure.at(y),
            slant: if K::IS_LINEAR {
                self.pressure.slope_x * x
            } else {
                Pair2::of(R::ZERO)
            },
            wy,
            z,
            inv_g,
            pace: speed * inv_g,
            s1_rate,
            s1,
            s2,
            s3: (s1_beta - s1_rate - s1_rate) * Pair2::of(R::ONE / (R::TWO + beta)),
            s0_rate: s1_beta - Pair2::of(R::ONE + beta) * s2,
            growth: [speed, rate],
        }
    }
}

impl<R: Real> Parts<R> {
    /// Force along, force across over w, and torque over w, all negative.
    #[inline(always)]
    fn wrench<K: PressureField<R>>(&self, w: Pair2<R>) -> [Pair2<R>; 3] {
        let Self { x, y, here, .. } = *self;
        let [speed, rate] = self.growth;
        let x_sq = x * x;
        let along = here * (Pair2::of(R::ONE) + self.z * self.s0_rate);
        let across = here * self.s1;
        let out = here * self.s2;
        // (g q^(α−1) − 1)/w
        let missing = self.pace * self.inv_g * w * x_sq;
        let lost = y * rate;
        let turned = here * (missing * self.s0_rate - lost);
        let (along, across, out, turned) = if K::IS_LINEAR {
            let slant = self.slant;
            (
                along + slant * self.s1,
                across + slant * self.s2,
                out + slant * self.s3,
                turned + slant * (missing * self.s1_rate - Pair2::of(R::HALF) * lost),
            )
        } else {
            (along, across, out, turned)
        };
        [
            x * speed * along,
            x_sq * self.pace * across,
            x * (self.pace * x_sq * out - y * turned),
        ]
    }

    /// Minus the derivatives: across and across, across and spin, spin and spin.
    #[inline(always)]
    fn derivatives<K: PressureField<R>>(&self, beta: R) -> [Pair2<R>; 3] {
        let Self { x, y, here, z, .. } = *self;
        let one = Pair2::of(R::ONE);
        let e = (Pair2::of(beta) * self.s1 - one) * (one + z).inverse();
        let full = one + z * e;
        let double = |a: Pair2<R>| a + a;
        // w y g^(α−2) over g^(α−1)
        let lean = self.wy * self.inv_g;
        let yy = full;
        let yn = full - self.s1 - lean * e;
        let nn = full - double(self.s2) - double(lean * (e - self.s0_rate));
        let even = Pair2::of(beta) * (one + z * self.s0_rate) - full;
        let (yy, yn, nn, even) = if K::IS_LINEAR {
            let slant = self.slant;
            let third = full - double(self.s2) - lean * (e - self.s0_rate);
            let fourth =
                full - (double(self.s3) + self.s3) - double(lean * (e - double(self.s1_rate)));
            (
                here * yy + slant * (full - self.s1),
                here * yn + slant * third,
                here * nn + slant * fourth,
                here * even + slant * (Pair2::of(R::ONE + beta) * self.s1 - full),
            )
        } else {
            (here * yy, here * yn, here * nn, here * even)
        };
        let unit = x * self.pace;
        [unit * yy, unit * x * yn, unit * (x * x * nn + y * y * even)]
    }
}

/// Friction at a speed of 1, given half the length of the longest edge.
#[inline]
pub(super) fn friction<R: Real, K: PressureField<R>>(
    slide: &TranslatingMotion<'_, R>,
    power: &PolygonPowerLaw<R>,
    (edges, pressure): (&[Edge<R>], &K),
    half: R,
) -> Reduced<R> {
    let point = Point {
        slide,
        power,
        pressure: RotatedPressure::new(slide, pressure),
    };
    let w = Pair2::of(slide.spin);
    let at = |place: [Pair2<R>; 2]| point.parts::<K>(place).wrench::<K>(w);
    let along = None;
    let sums = EdgePairs {
        slide,
        edges,
        along,
        at,
    };
    reduced(slide, by_rule(&sums, half * slide.spin.abs(), POINTS))
}

/// The same with minus its derivatives.
pub(super) fn friction_and_hessian<R: Real, K: PressureField<R>>(
    slide: &TranslatingMotion<'_, R>,
    power: &PolygonPowerLaw<R>,
    (edges, pressure): (&[Edge<R>], &K),
    half: R,
) -> (Reduced<R>, Hessian<R>) {
    let point = Point {
        slide,
        power,
        pressure: RotatedPressure::new(slide, pressure),
    };
    let w = Pair2::of(slide.spin);
    let at = |place: [Pair2<R>; 2]| {
        let parts = point.parts::<K>(place);
        let [along, across, torque] = parts.wrench::<K>(w);
        let [yy, yn, nn] = parts.derivatives::<K>(power.beta);
        [along, across, torque, yy, yn, nn]
    };
    let along = None;
    let sums = EdgePairs {
        slide,
        edges,
        along,
        at,
    };
    let [along, across, torque, yy, yn, nn] = by_rule(&sums, half * slide.spin.abs(), POINTS);
    // Times the twist (1, 0, w) the matrix is α times minus the wrench.
    let (w, alpha) = (slide.spin, power.alpha);
    let xn = w * (alpha * torque - nn);
    let xy = w * (alpha * across - yn);
    let xx = alpha * along - w * xn;
    let hessian = slide.turned_back(&Hessian {
        xx,
        xy,
        yy,
        xn,
        yn,
        nn,
    });
    (reduced(slide, [along, across, torque]), hessian)
}

#[inline(always)]
fn reduced<R: Real>(
    slide: &TranslatingMotion<'_, R>,
    [along, across, torque]: [R; 3],
) -> Reduced<R> {
    let (e, spin) = (slide.direction, slide.spin);
    let across = spin * across;
    Reduced {
        force: Vector2::new(-(along * e.x - across * e.y), -(along * e.y + across * e.x)),
        torque: -(spin * torque),
    }
}
