//! Friction of a patch with straight edges under linear pressure: one form for every motion.
//!
//! The notation is that of [`super::moving_edge`]; the centre of pressure is the origin. The pressure, of its mean,
//! is k = k_c + g·x, and on an edge k_m + k_t t with the distance t from its middle. The divergence
//! theorem for k q and x k q gives
//!
//! ```text
//! force = −(v + w f/area),     torque = −w [3 + (Σ H γ + k_c P − 3 v·f″)/area]/4
//! f = Σ τ γ − (z × g) P,       γ = ∫k p dl = k_m β + k_t δ,       P = ∫p dA = Σ [H (β − l/2) + (v·τ) β″]/3
//! ```
//!
//! f″ is the rest of f over w in p = p₀ + w p″: the gradient of p₀ = ((v·x)² − 1)/2 has the direction of v, so
//! that v·f is w v·f″. Once more, p″ = w p‴ − α p₀:
//!
//! ```text
//! f″ = Σ τ γ″ − (z × g) P″,    γ″ = k_m β″ + k_t δ″,    P″ = ∫p″ dA = [Σ (H β″ + (v·τ) β‴) + w P]/(3 + w²)
//! ```
//!
//! An edge's β, β″, β‴ are the trapezoid's rule and E, E″, E‴; with ε = ᾱ σ − p̄, ζ₁₀ = (H − (v·τ) ᾱ)/2,
//! C = b − ζ² G and K = b/3 − ζ² G
//!
//! ```text
//! β‴: E‴ = −(l²/S) [2/3 (ζ₀ (ζ₀ ε − 2 ζ₁₀ σ − 2 ζ p̄ − 2 ᾱ ζ₁) + ζ₁²) + (l/S)² C] − w H (v·τ) l²/6
//! δ  = (l³/S) [c (1/6 + y² K) + v·n (σ/6 − w (l/S)² K)],        c = middle·τ
//! δ″ = (l³/S) [c (w (l/S)² K + (w + w² σ − σ)/6) − v·n (ε/6 + (l/S)² K)]
//! ```
//!
//! Nothing cancels, nothing is divided by a speed or a spin, and all terms are bounded.
//!
//! *Second derivatives* of the power. With ∫k ∂p/∂v dl = W and χ = (v·W)/w, whose parts along τ and n are
//!
//! ```text
//! W = k_m l [z × middle − 2 σ u/S] + 2 l (l/S)² g ζ (w k_m + k_t s) τ + k_t l E n,     u = ζ S τ + s n
//! χ = 2 (l/S) k_m (w ᾱ − p̄ V²) + 2 l (l/S)² g ζ (k_m v·τ − k_t H s) + k_t [c l E − 3 w s l² (l/S)³ K]
//! D_vv = [Σ τ ⊗ W − (z × g) ⊗ B]/area
//! D_vw = [Σ H W − 3 f + k_c B]/area,       D_ww = [3 v·f″ − Σ H χ − k_c Σ (v·τ) β″]/area
//! B = ∫∂p/∂v dA = Σ [H (W₁ + w l v/2) + (v·τ) W₁″]/2
//! W₁″ = 2 l ([(l/S)² g ζ − ζ p̄ − ᾱ ζ₁] τ − [s p̄/S + ᾱ s₁] n),       s₁ = −c/2 − σ s/S
//! ```
//!
//! where W₁ is W for the pressure 1, and W₁″ its rest over w.
//!
//! Pressure that is steep, as it is across a thin patch, takes the area integrals P, P″ and B from
//! [`super::steep_layer`] where the centre of rotation is away from the patch.

use super::motion::Motion;
use super::moving_edge::{MovingEdge, Sides, UnitMotion, splat};
use super::steep_layer::sharp;
use super::uniform::summed;
use super::{Hessian, Reduced};
use crate::lanes::{Numbers, Summed};
use crate::patch::outline::{Edge, PressureField};
use crate::real::Real;
use nalgebra::Vector2;

/// Slope, of the mean pressure over the radius, from which on sums over long edges may cancel as they do on a thin patch.
const STEEP: f64 = 4.0;
/// Pressure at the centre of rotation, of the largest one on the patch, up to which it is close: the sums over edges lose
/// little. The layer's rule needs a distance: among 12,000 motions of strips, wedges, L and T it errs by 2e-11 from 1 on,
/// 3e-14 from 1.25 on, and by no more than rounding from 1.5 on; at 4 its ellipse of convergence leaves 1e-18.
const CLOSE: f64 = 4.0;

/// A weight along an edge: that of its middle, and the change from end to end.
pub(super) struct Weight<L> {
    middle: L,
    change: L,
}

impl<L: Summed<Real: Real>> Weight<L> {
    /// That goes from one value to another one.
    #[inline(always)]
    pub(super) fn between([from, to]: [L; 2]) -> Self {
        Self {
            middle: L::splat(0.5) * (from + to),
            change: to - from,
        }
    }
}

/// What edges add to integrals of p, p″ and p‴.
pub(super) struct EdgeIntegrals<'a, L> {
    moving: &'a MovingEdge<L>,
    /// β, β″, β‴
    even: [L; 3],
    /// δ/l, δ″/l
    odd: [L; 2],
    /// E
    bent: L,
    /// 2 (l/S)² g ζ
    turned: L,
    /// (l/S)² K
    part: L,
    /// s, the velocity of the middle along the normal.
    across: L,
}

impl<'a, L: Summed<Real: Real>> EdgeIntegrals<'a, L> {
    #[inline(always)]
    pub(super) fn new(moving: &'a MovingEdge<L>) -> Self {
        let MovingEdge {
            spin: w,
            along,
            across,
            p,
            arm,
            reach_sq,
            sigma,
            zeta,
            open,
            ..
        } = *moving;
        let (length, offset) = (moving.sides.length, moving.sides.offset);
        let [third, sixth] = [1.0 / 3.0, 1.0 / 6.0].map(splat::<L>);
        let (two, half, middle) = (L::splat(2.0), L::splat(0.5), moving.sides.middle());
        let of_log = moving.zeta_sq * moving.bend;
        let whole = reach_sq * (open - of_log);
        let part = reach_sq * (third * open - of_log);
        let fall = arm * sigma - p;
        let square = length * moving.reach;
        // ζ of a translation, and the rest over the spin, twice.
        let zeta_0 = half * along;
        let zeta_1 = half * offset - zeta * sigma;
        let zeta_10 = half * (offset - along * arm);
        let zeta_11 = zeta * p + arm * zeta_1;
        let bent = -(square * (open - moving.zeta_sq * moving.log));
        let twice = zeta_0 * (zeta_0 * fall - two * (zeta_10 * sigma + zeta_11)) + zeta_1 * zeta_1;
        let bent_3 = -(square * (two * third * twice + whole))
            - sixth * (length * length) * (w * offset * along);
        let w_part = w * part;
        Self {
            even: [
                length * (p + bent),
                moving.beta_rest(),
                length * (moving.third + bent_3),
            ],
            odd: [
                square * (middle * (sixth + w * w_part) + across * (sixth * sigma - w_part)),
                square
                    * (middle * (w_part + sixth * (w + w * w * sigma - sigma))
                        - across * (sixth * fall + part)),
            ],
            bent,
            turned: two * reach_sq * moving.log * zeta,
            part,
            across: across - w * middle,
            moving,
        }
    }

    /// γ and γ″
    #[inline(always)]
    pub(super) fn weighted(&self, weight: &Weight<L>) -> [L; 2] {
        let ([beta, beta_2, _], [delta, delta_2]) = (self.even, self.odd);
        let Weight { middle, change } = *weight;
        [
            middle * beta + change * delta,
            middle * beta_2 + change * delta_2,
        ]
    }

    /// What the force and the torque are made of: Σ τ γ, Σ τ γ″, Σ H γ, and of P and P″.
    #[inline(always)]
    fn wrench(&self, weight: &Weight<L>) -> [L; 7] {
        let ([beta, beta_2, beta_3], [gamma, gamma_2]) = (self.even, self.weighted(weight));
        let (sides, along) = (&self.moving.sides, self.moving.along);
        let ([x, y], offset) = (sides.tangent, sides.offset);
        [
            x * gamma,
            y * gamma,
            x * gamma_2,
            y * gamma_2,
            offset * gamma,
            offset * (beta - L::splat(0.5) * sides.length) + along * beta_2,
            offset * beta_2 + along * beta_3,
        ]
    }

    /// W along the tangent and the normal.
    #[inline(always)]
    pub(super) fn slope(&self, weight: &Weight<L>) -> [L; 2] {
        let Weight { middle, change } = *weight;
        let (sides, w) = (&self.moving.sides, self.moving.spin);
        let (double, load) = (self.moving.sigma + self.moving.sigma, middle * sides.length);
        let crossed = sides.middle() + double * self.across * self.moving.inv_sum;
        [
            load * (sides.offset - double * self.moving.zeta + self.turned * w)
                + self.turned * change * self.across,
            change * self.bent - load * crossed,
        ]
    }

    /// χ
    #[inline(always)]
    fn spin_slope(&self, weight: &Weight<L>, speed_sq: L) -> L {
        let Weight { middle, change } = *weight;
        let MovingEdge {
            spin: w,
            along,
            p,
            arm,
            reach,
            ..
        } = *self.moving;
        let Sides { length, offset, .. } = self.moving.sides;
        let lever = w * self.across * (length * reach * self.part);
        L::splat(2.0) * reach * middle * (w * arm - p * speed_sq)
            + self.turned * (middle * length * along - change * offset * self.across)
            + change * (self.moving.sides.middle() * self.bent - L::splat(3.0) * lever)
    }

    /// What the second derivatives are made of: B, Σ (v·τ) β″, Σ τ ⊗ W, Σ H W and Σ H χ.
    #[inline(always)]
    fn hessian(&self, weight: &Weight<L>, speed_sq: L) -> [L; 9] {
        let sides = &self.moving.sides;
        let ([x, y], offset, [_, beta_2, _]) = (sides.tangent, sides.offset, self.even);
        let [lengthwise, crosswise] = self.slope(weight);
        let [to_x, to_y] = turned_back(sides.tangent, [lengthwise, crosswise]);
        let [over_x, over_y] = turned_back(sides.tangent, self.slope_over_area());
        [
            over_x,
            over_y,
            self.moving.along * beta_2,
            x * to_x,
            lengthwise * x * y + L::splat(0.5) * crosswise * (y * y - x * x),
            y * to_y,
            offset * to_x,
            offset * to_y,
            offset * self.spin_slope(weight, speed_sq),
        ]
    }

    /// What the edge adds to B, along the tangent and the normal.
    #[inline(always)]
    fn slope_over_area(&self) -> [L; 2] {
        let MovingEdge {
            spin: w,
            along,
            across,
            p,
            arm,
            ..
        } = *self.moving;
        let (half, two) = (L::splat(0.5), L::splat(2.0));
        let Sides { length, offset, .. } = self.moving.sides;
        let one = Weight {
            middle: L::splat(1.0),
            change: L::splat(0.0),
        };
        let [lengthwise, crosswise] = self.slope(&one);
        // s/S as ζ.
        let crossing = self.across * self.moving.inv_sum;
        let zeta_1 = half * offset - self.moving.zeta * self.moving.sigma;
        let crossing_1 = -(half * self.moving.sides.middle() + crossing * self.moving.sigma);
        let rest = [
            self.turned - two * (self.moving.zeta * p + arm * zeta_1),
            -(two * (crossing * p + arm * crossing_1)),
        ];
        let turned = half * length * w;
        [
            half * (offset * (lengthwise + turned * along) + along * length * rest[0]),
            half * (offset * (crosswise + turned * across) + along * length * rest[1]),
        ]
    }
}

/// The vector with these parts along a tangent and the normal to its right.
#[inline(always)]
pub(super) fn turned_back<L: Summed>([x, y]: [L; 2], [along, across]: [L; 2]) -> [L; 2] {
    [along * x + across * y, along * y - across * x]
}

/// A patch under linear pressure, and its motion.
pub(super) struct Loaded<'a, R: Real> {
    pub(super) edges: &'a [Edge<R>],
    pub(super) slope: [R; 2],
    at_centre: R,
    pub(super) motion: UnitMotion<R>,
    is_steep: bool,
}

/// Integrals over the area: P, P″ and B.
pub(super) struct AreaIntegrals<R> {
    pub(super) p: R,
    pub(super) rest: R,
    pub(super) slope: [R; 2],
}

/// Reduced friction of a patch with this area.
#[inline]
pub(super) fn friction<R: Real, K: PressureField<R>>(
    edges: &[Edge<R>],
    pressure: &K,
    area: R,
    motion: &Motion<R>,
) -> Reduced<R> {
    let (loaded, _) = Loaded::new(edges, pressure, motion);
    let wrench = loaded.summed::<R::Several, 7>(|own, weight| own.wrench(weight));
    let over = loaded.over_area::<false>(wrench, [R::ZERO; 2]);
    loaded.reduced(wrench, &over, area).0
}

/// The same, and second derivatives of the dissipated power.
pub(super) fn friction_and_hessian<R: Real, K: PressureField<R>>(
    edges: &[Edge<R>],
    pressure: &K,
    area: R,
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let (loaded, rate) = Loaded::new(edges, pressure, motion);
    let UnitMotion { x, y, spin: w } = loaded.motion;
    let speed_sq = R::Several::repeat(x * x + y * y);
    let [
        a,
        b,
        c,
        d,
        e,
        f,
        g,
        along_x,
        along_y,
        lost,
        xx,
        xy,
        yy,
        xn,
        yn,
        spin,
    ] = loaded.summed::<R::Several, 16>(|own, weight| {
        let [a, b, c, d, e, f, g] = own.wrench(weight);
        let [h, i, j, k, l, m, n, o, p] = own.hessian(weight, speed_sq);
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p]
    });
    let wrench = [a, b, c, d, e, f, g];
    let over = loaded.over_area::<true>(wrench, [along_x, along_y]);
    let (reduced, [pull_x, pull_y, along]) = loaded.reduced(wrench, &over, area);
    let (at_centre, three) = (loaded.at_centre, R::from_f64(3.0));
    // −(z × g) ⊗ B
    let ([slope_x, slope_y], [to_x, to_y]) = (loaded.slope, over.slope);
    let hessian = Hessian {
        xx: xx + slope_y * to_x,
        xy: xy + R::HALF * (slope_y * to_y - slope_x * to_x),
        yy: yy - slope_x * to_y,
        xn: xn - three * pull_x + at_centre * to_x,
        yn: yn - three * pull_y + at_centre * to_y,
        nn: three * along - spin - at_centre * lost,
    };
    (reduced, hessian.across([x, y, w]).scaled(rate / area))
}

impl<'a, R: Real> Loaded<'a, R> {
    /// The patch, and 1 over the speed that is its motion's unit.
    #[inline(always)]
    fn new<K: PressureField<R>>(
        edges: &'a [Edge<R>],
        pressure: &K,
        motion: &Motion<R>,
    ) -> (Self, R) {
        let (slope, (motion, rate)) = (pressure.slope(), UnitMotion::of(motion));
        let slope_sq = slope[0] * slope[0] + slope[1] * slope[1];
        let loaded = Self {
            edges,
            slope,
            at_centre: pressure.at_centre(),
            motion,
            is_steep: slope_sq > R::from_f64(STEEP * STEEP),
        };
        (loaded, rate)
    }

    /// Sums over the edges under the pressure.
    #[inline(always)]
    fn summed<L: Summed<Real = R>, const N: usize>(
        &self,
        of: impl Fn(&EdgeIntegrals<'_, L>, &Weight<L>) -> [L; N],
    ) -> [R; N] {
        let [slope, at_centre] = [self.slope, [self.at_centre; 2]].map(|pair| pair.map(L::repeat));
        if !self.is_steep {
            return summed::<R, L, N>(self.edges, &self.motion, |moving| {
                let ends = [moving.sides.from, moving.sides.to];
                let pressure = ends.map(|[x, y]| at_centre[0] + (slope[0] * x + slope[1] * y));
                of(&EdgeIntegrals::new(moving), &Weight::between(pressure))
            });
        }
        let motion = self.motion.repeated::<L>();
        summed::<R, L, N>(self.edges, &self.motion, |moving| {
            let moving = moving.sharpened(&motion);
            let ends = [moving.sides.from, moving.sides.to];
            let pressure = ends.map(|end| at_centre[0] + sharp(slope, end));
            of(&EdgeIntegrals::new(&moving), &Weight::between(pressure))
        })
    }

    /// Integrals over the area, given sums over the edges and B.
    #[inline(always)]
    fn over_area<const WITH_HESSIAN: bool>(&self, sums: [R; 7], slope: [R; 2]) -> AreaIntegrals<R> {
        let UnitMotion { x, y, spin: w } = self.motion;
        // Pressure at the centre of rotation times the spin.
        let there = self.at_centre * w + (self.slope[1] * x - self.slope[0] * y);
        if self.is_steep && there.abs() > R::from_f64(CLOSE) * self.largest_pressure() * w.abs() {
            return self.over_layer::<R::Several, WITH_HESSIAN>();
        }
        let [.., first, second] = sums;
        let three = R::from_f64(3.0);
        let p = first / three;
        AreaIntegrals {
            p,
            rest: (second + w * p) / (three + w * w),
            slope,
        }
    }

    /// The largest pressure on the patch, which is that of a corner.
    fn largest_pressure(&self) -> R {
        let mut largest = R::ZERO;
        for edge in self.edges {
            let corner = edge.start();
            let above = self.slope[0] * corner.x + self.slope[1] * corner.y;
            if self.at_centre + above > largest {
                largest = self.at_centre + above;
            }
        }
        largest
    }

    /// Reduced friction, f and v·f″.
    #[inline(always)]
    fn reduced(
        &self,
        [pull_x, pull_y, rest_x, rest_y, turn, ..]: [R; 7],
        over: &AreaIntegrals<R>,
        area: R,
    ) -> (Reduced<R>, [R; 3]) {
        let (UnitMotion { x, y, spin: w }, [slope_x, slope_y]) = (self.motion, self.slope);
        let (pull_x, pull_y) = (pull_x + slope_y * over.p, pull_y - slope_x * over.p);
        let (rest_x, rest_y) = (rest_x + slope_y * over.rest, rest_y - slope_x * over.rest);
        let (share, three) = (R::ONE / area, R::from_f64(3.0));
        let along = x * rest_x + y * rest_y;
        let turn = turn + self.at_centre * over.p - three * along;
        let by = w * share;
        let reduced = Reduced {
            force: Vector2::new(-(x + by * pull_x), -(y + by * pull_y)),
            torque: -(R::HALF * R::HALF * w * (three + share * turn)),
        };
        (reduced, [pull_x, pull_y, along])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coupling::flat::ShapeFriction;
    use crate::patch::outline::{LinearPressure, Polygon};
    use crate::twist::Twist;

    #[test]
    fn the_small_torque_of_a_slow_spin_keeps_its_digits() {
        // A square of side 2 whose centre of pressure is the origin, a quarter beside its middle: pressure
        // 1 + 3 (x + 1/4)/4, mean squares 13/48 and 1/3.
        let square = [[-1.25, -1.0], [0.75, -1.0], [0.75, 1.0], [-1.25, 1.0]];
        let leaning = Polygon::new(square)
            .unwrap()
            .with_centre_of_pressure([0.0; 2]);
        let friction = ShapeFriction::new(leaning.unwrap(), 1.0).unwrap();
        for [x, y] in [[1.0, 0.0], [0.0, 1.0], [0.6, 0.8]] {
            for spin in [1e-18, -1e-60, 1e-290] {
                let torque = friction.wrench(1.0, &Twist::new(x, y, spin)).torque;
                let expected = -spin * (13.0 / 48.0 * x * x + y * y / 3.0);
                assert!((torque / expected - 1.0).abs() < 4e-15, "{x} {y} {spin}");
            }
        }
    }

    fn bits_agree<R: Real, L: Summed<Real = R>>() {
        let ell = [
            [0.0, 0.0],
            [2.0, 0.125],
            [2.0, 1.0],
            [1.0, 1.0],
            [0.875, 2.0],
            [0.0, 2.0],
        ];
        let ell = Polygon::new(ell.map(|corner| corner.map(R::from_f64))).unwrap();
        for slope in [[0.25, -0.375], [0.5, 9.5]] {
            let pressure = LinearPressure::new(R::ONE, slope.map(R::from_f64));
            for [x, y, spin] in [[0.5, 0.25, 1.0], [-3.0, 2.0, 0.125], [0.25, 8.0, -0.5]] {
                let motion = Motion {
                    velocity: Vector2::new(R::from_f64(x), R::from_f64(y)),
                    rim: R::from_f64(spin),
                };
                let (loaded, _) = Loaded::new(ell.edges(), &pressure, &motion);
                let speed_sq = R::from_f64(0.75);
                let one =
                    loaded.summed::<L, 9>(|own, weight| own.hessian(weight, L::repeat(speed_sq)));
                let several = loaded.summed::<R::Several, 9>(|own, weight| {
                    own.hessian(weight, R::Several::repeat(speed_sq))
                });
                assert_eq!(one, several);
                let one = loaded.summed::<L, 7>(|own, weight| own.wrench(weight));
                assert_eq!(
                    one,
                    loaded.summed::<R::Several, 7>(|own, weight| own.wrench(weight))
                );
                let (one, several) = (
                    loaded.over_layer::<L, true>(),
                    loaded.over_layer::<R::Several, true>(),
                );
                assert_eq!([one.p, one.rest], [several.p, several.rest]);
                assert_eq!(one.slope, several.slope);
            }
        }
    }

    #[test]
    fn edges_side_by_side_give_the_bits_of_one_by_one() {
        bits_agree::<f64, f64>();
        bits_agree::<f32, f32>();
    }
}
