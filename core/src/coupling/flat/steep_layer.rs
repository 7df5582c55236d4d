//! Linear pressure that is steep across a thin patch.
//!
//! The notation is that of [`super::linear`]. On a patch that is thin along g the area integrals P, P″ and B are small,
//! but sums of long edges that cancel unless the centre of rotation is close, and g multiplies them. The patch is a
//! layer about the level line of the centre of pressure: with e = g·x on an edge, and the points x_s on the way from
//! that line to the edge,
//!
//! ```text
//! ∫f dA = Σ (g × τ)/g² ∫∫e f(x_s) ds dl,     s = 0 … 1
//! ```
//!
//! whose terms are as small as the layer is thin, by Gauss' rule in s and the closed forms along the squeezed edges.
//! Products with corners cancel there, too, and are taken with what rounding leaves of them.

use super::linear::{AreaIntegrals, EdgeIntegrals, Loaded, Weight, turned_back};
use super::moving_edge::{Corner, MovingEdge, Sides, UnitMotion, splat};
use super::uniform::summed;
use crate::lanes::Summed;
use crate::real::Real;
use crate::special::legendre::FEW_HALF;

/// 2²⁷ + 1 for 53 digits, and 2¹² + 1 for the 24 of f32.
const HALVES: f64 = 134_217_729.0;
const HALVES_SINGLE: f64 = 4_097.0;

/// The scalar product in twice the digits, rounded once at the end: Dot2 of Ogita, Rump, Oishi 2005 (SIAM J. Sci.
/// Comput. 26, 1955) without what rounding takes from the one sum, which counts where the terms do not cancel.
#[inline(always)]
pub(super) fn sharp<L: Summed<Real: Real>>(a: [L; 2], b: [L; 2]) -> L {
    let (first, second) = (a[0] * b[0], a[1] * b[1]);
    first + second + (lost_in(first, a[0], b[0]) + lost_in(second, a[1], b[1]))
}

/// What cuts a number into halves of its digits: one more than a power of two.
#[inline(always)]
fn halves_at<R: Real>() -> f64 {
    if R::IS_SINGLE { HALVES_SINGLE } else { HALVES }
}

/// What rounding took from a product: the error of TwoProduct (Dekker 1971, Numer. Math. 18, 224).
#[inline(always)]
fn lost_in<L: Summed<Real: Real>>(product: L, a: L, b: L) -> L {
    let halves = |x: L| {
        let large = x * splat::<L>(halves_at::<L::Real>());
        let high = large - (large - x);
        (high, x - high)
    };
    let ((a, a_low), (b, b_low)) = (halves(a), halves(b));
    ((a * b - product) + a * b_low + a_low * b) + a_low * b_low
}

impl<L: Summed<Real: Real>> MovingEdge<L> {
    /// Its offset and its velocity along itself from products that keep their digits: long edges of a thin patch cancel
    /// each other.
    #[inline(always)]
    pub(super) fn sharpened(&self, motion: &UnitMotion<L>) -> Self {
        let mut moving = *self;
        let (from, to) = (moving.sides.from, moving.sides.to);
        let inv = L::splat(1.0) / (moving.sides.length + L::repeat(L::Real::MIN_POSITIVE));
        moving.sides.offset = sharp([from[0], -from[1]], [to[1], to[0]]) * inv;
        let velocity = [motion.x, motion.y];
        moving.along = (sharp(velocity, to) - sharp(velocity, from)) * inv;
        moving
    }
}

impl<R: Real> Loaded<'_, R> {
    /// The integrals over a layer about the level line of the centre of pressure.
    #[cold]
    pub(super) fn over_layer<L: Summed<Real = R>, const WITH_HESSIAN: bool>(
        &self,
    ) -> AreaIntegrals<R> {
        let ([x, y], motion) = (self.slope.map(L::repeat), self.motion.repeated::<L>());
        let inv_sq = L::splat(1.0) / (x * x + y * y);
        let [p, rest, slope_x, slope_y] = summed::<R, L, 4>(self.edges, &self.motion, |moving| {
            let sides = &moving.sides;
            let ends = [sides.from, sides.to];
            // Pressure above the level line.
            let above = ends.map(|end| sharp([x, y], end));
            let measure = (x * sides.tangent[1] - y * sides.tangent[0]) * inv_sq * sides.length;
            let mut sums = [L::splat(0.0); 4];
            for &[node, weight] in &FEW_HALF {
                for node in [-node, node] {
                    let back = splat::<L>(0.5 - 0.5 * node) * inv_sq;
                    let squeezed = [(ends[0], above[0]), (ends[1], above[1])]
                        .map(|(end, above)| [end[0] - back * above * x, end[1] - back * above * y]);
                    let corners = squeezed.map(|corner| Corner::new(&motion, corner));
                    let [from, to] = &corners;
                    let squeezed = MovingEdge::new(&motion, Sides::between(squeezed), [from, to]);
                    let own = EdgeIntegrals::new(&squeezed);
                    let length = squeezed.sides.length + L::repeat(R::MIN_POSITIVE);
                    let scale = splat::<L>(0.5 * weight) * measure / length;
                    let weight = Weight::between(above.map(|above| scale * above));
                    let [p, rest] = own.weighted(&weight);
                    let slope = if WITH_HESSIAN {
                        turned_back(squeezed.sides.tangent, own.slope(&weight))
                    } else {
                        [L::splat(0.0); 2]
                    };
                    for (sum, part) in sums.iter_mut().zip([p, rest, slope[0], slope[1]]) {
                        *sum = *sum + part;
                    }
                }
            }
            sums
        });
        AreaIntegrals {
            p,
            rest,
            slope: [slope_x, slope_y],
        }
    }
}

impl<L: Summed<Real: Real>> Sides<L> {
    /// From corners to corners.
    #[inline(always)]
    fn between([from, to]: [[L; 2]; 2]) -> Self {
        let (x, y) = (to[0] - from[0], to[1] - from[1]);
        let length = (x * x + y * y).sqrt();
        let inv = L::splat(1.0) / (length + L::repeat(L::Real::MIN_POSITIVE));
        let tangent = [x * inv, y * inv];
        Self {
            from,
            to,
            tangent,
            length,
            offset: from[0] * tangent[1] - from[1] * tangent[0],
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::coupling::flat::ShapeFriction;
    use crate::patch::outline::{Edge, Polygon};
    use crate::twist::Twist;

    /// A strip or a T of strips, its centre of pressure, a twist, and force and torque about the origin for a μN of 1.
    struct Strip {
        aspect: f64,
        corners: &'static [[f64; 2]],
        centre: [f64; 2],
        twist: [f64; 3],
        wrench: [f64; 3],
    }

    /// By line integrals about the centre of rotation with 50 digits (mpmath 1.3, in polar coordinates, the T
    /// `by_edges` of `generate_polygons.py`): centres on the strip, beside it, beyond three radii, and on the stem of a T
    /// and beyond its end, where the pressure is 8 and more times the mean.
    const STRIPS: &[Strip] = &[
        Strip {
            aspect: 1000.0,
            corners: &[
                [-0.969033930767656, -0.24692962766947554],
                [0.9695258514632127, 0.2449910678872447],
                [0.969033930767656, 0.24692962766947554],
                [-0.9695258514632127, -0.2449910678872447],
            ],
            centre: [0.1459956094817801, 0.03708292793076651],
            twist: [
                -0.010418496191435879,
                0.031759003650815056,
                0.4651433783184657,
            ],
            wrench: [
                0.10089806835528019,
                -0.2802363112912042,
                -0.4974244055788887,
            ],
        },
        Strip {
            aspect: 10000.0,
            corners: &[
                [0.17116487004046727, -0.9852424053318198],
                [-0.17096781813807405, 0.9852766186006376],
                [-0.17116487004046727, 0.9852424053318198],
                [0.17096781813807405, -0.9852766186006376],
            ],
            centre: [-0.007400133926319752, 0.04258907488345833],
            twist: [
                -0.23304764717836451,
                -0.04046752883627514,
                1.0602712684580482,
            ],
            wrench: [
                0.28048983296277435,
                0.04879777451198943,
                -0.4755955739971934,
            ],
        },
        Strip {
            aspect: 10000.0,
            corners: &[
                [-0.7677228816604734, -0.6407820120563145],
                [0.7678510227071457, 0.6406284546658777],
                [0.7677228816604734, 0.6407820120563145],
                [-0.7678510227071457, -0.6406284546658777],
            ],
            centre: [0.11442620725665044, 0.09547523687275052],
            twist: [1.3030334530414185, -1.5352026165047248, 2.3132504657364663],
            wrench: [
                -0.5588998188044645,
                0.5966660773082062,
                -0.022789576013526387,
            ],
        },
        Strip {
            aspect: 10000.0,
            corners: &[
                [0.17116487004046727, -0.9852424053318198],
                [-0.17096781813807405, 0.9852766186006376],
                [-0.17116487004046727, 0.9852424053318198],
                [0.17096781813807405, -0.9852766186006376],
            ],
            centre: [-0.007400133926319752, 0.04258907488345833],
            twist: [-2.944263026899032, 15.112344103640279, 2.2908882638982795],
            wrench: [0.1966564748553997, -0.976768965124603, -0.05011552904781815],
        },
        Strip {
            aspect: 50.0,
            corners: &[
                [-1.0, 0.0],
                [1.0, 0.0],
                [1.0, 0.04],
                [0.01, 0.04],
                [0.0, 1.04],
                [-0.01, 0.04],
                [-1.0, 0.04],
            ],
            centre: [0.0, 0.3734068916323732],
            twist: [0.624, 0.0, 1.0],
            wrench: [-0.43573712651915963, 0.0, -0.1180622684804576],
        },
        Strip {
            aspect: 10.0,
            corners: &[
                [-1.0, 0.0],
                [1.0, 0.0],
                [1.0, 0.2],
                [0.05, 0.2],
                [0.0, 1.2],
                [-0.05, 0.2],
                [-1.0, 0.2],
            ],
            centre: [0.0, 0.33497231824417006],
            twist: [1.32, -0.03, 1.0],
            wrench: [
                -0.9441149379490055,
                0.03250386685452329,
                0.18452255743858095,
            ],
        },
    ];

    #[test]
    fn linear_pressure_on_strips_loses_the_aspect_ratio_and_not_its_square() {
        for strip in STRIPS {
            let memory = [Edge::default(); 7];
            let even = Polygon::with_holes(&[strip.corners], memory).unwrap();
            let leaning = even.with_centre_of_pressure(strip.centre).unwrap();
            let friction = ShapeFriction::new(leaning, 1.0).unwrap();
            let [x, y, spin] = strip.twist;
            let found = friction.wrench(1.0, &Twist::new(x, y, spin));
            let [x, y, torque] = strip.wrench;
            // Torques about the origin, of at most twice the radius.
            let off =
                libm::hypot(found.force.x - x, found.force.y - y) + (found.torque - torque).abs();
            assert!(off < 1e-15 * strip.aspect, "{} {off:e}", strip.aspect);
        }
    }
}
