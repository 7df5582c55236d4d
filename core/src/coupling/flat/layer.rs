//! Linear pressure on a patch that is thin along the pressure's slope.
//!
//! There the slope g is steep and the pressure k far from the patch large: sums over cones from the centre
//! of rotation, or over the order of the pressure's terms, would cancel to the square of the aspect ratio.
//! The patch is a layer about the level line of the pressure k_c at the centre of pressure: with e = k − k_c
//! on an edge of direction τ, and the points x_s on the way from that line to the edge, s = 0 … 1,
//!
//! ```text
//! ∫f dA = Σ (g × τ)/g² ∫∫e f(x_s) ds dl
//! ```
//!
//! whose terms are as small as the layer is thin. About a centre of rotation at some widths of the layer, with
//! ρ the place from there, r = |ρ| and the divergences of k r and k r ρ,
//!
//! ```text
//! ∫k ρ/r dA = Σ n ∫k r dl − g ∫r dA,     ∫k r dA = [Σ h ∫k r dl + k(centre) ∫r dA]/4
//! ∫k ∇∇r dA = Σ n ∫k ρ/r dl − g ∫ρ/r dA
//! ```
//!
//! need but integrals of r and ρ/r over the layer, by Gauss' rule in s and in closed form along the squeezed
//! edges. Where the centre is nearer, k there is a few mean pressures, and the cones of [`super::cone`] do.

use super::cone::over_edge;
use super::pair_of_numbers::Pair2;
use super::pole_far::{EdgeQuadrature, FOR_HESSIAN, FOR_WRENCH, TranslatingMotion, by_rule};
use super::pole_near::EdgeFromPole;
use super::sums::{bent, slid};
use super::{Hessian, Reduced};
use crate::patch::outline::{Edge, PressureField};
use crate::real::Real;
use crate::special::legendre::FEW_HALF;
use nalgebra::Vector2;

/// Slope, of the mean pressure over the radius, from which on a patch is a layer: pressure is nowhere negative,
/// so that all of it lies within half a radius.
const STEEP: f64 = 4.0;
/// Mean pressures at the centre of rotation up to which cones lose no more than the layer has lost.
const CLOSE: f64 = 8.0;

/// A patch under a steep pressure.
pub(super) struct Layer<'a, R: Real, K> {
    edges: &'a [Edge<R>],
    pressure: &'a K,
    slope: Vector2<R>,
    inv_slope_sq: R,
}

impl<'a, R: Real, K: PressureField<R>> Layer<'a, R, K> {
    /// None if the pressure is not steep.
    #[inline(always)]
    pub(super) fn of(edges: &'a [Edge<R>], pressure: &'a K) -> Option<Self> {
        let [x, y] = pressure.slope();
        let sq = x * x + y * y;
        (sq > R::from_f64(STEEP * STEEP)).then(|| Self {
            edges,
            pressure,
            slope: Vector2::new(x, y),
            inv_slope_sq: R::ONE / sq,
        })
    }

    /// Pressure above that at the centre of pressure.
    #[inline(always)]
    fn above(&self, place: &Vector2<R>) -> R {
        self.slope.x * place.x + self.slope.y * place.y
    }

    /// What an area counts for each pressure above the level line and length of an edge.
    #[inline(always)]
    fn measure(&self, edge: &Edge<R>) -> R {
        let tangent = edge.tangent();
        (self.slope.x * tangent.y - self.slope.y * tangent.x) * self.inv_slope_sq
    }

    /// A place moved to the share `s` of its distance from the level line.
    #[inline(always)]
    fn squeezed(&self, place: &Vector2<R>, above: R, s: R) -> Vector2<R> {
        place - self.slope * ((R::ONE - s) * above * self.inv_slope_sq)
    }

    /// Friction about the centre of pressure for the spin `sense` (±1) about `centre`, and second derivatives
    /// of the dissipated power at a rim speed of 1.
    #[inline(never)]
    pub(super) fn turns<const WITH_HESSIAN: bool>(
        &self,
        centre: &Vector2<R>,
        sense: R,
    ) -> (Reduced<R>, Hessian<R>) {
        let here = self.pressure.at_centre() + self.above(centre);
        let [x, y, turn, xx, xy, yy] = if here.abs() <= R::from_f64(CLOSE) {
            self.by_cones::<WITH_HESSIAN>(centre, here)
        } else {
            self.by_squeezing::<WITH_HESSIAN>(centre, here)
        };
        let force = Vector2::new(sense * y, -(sense * x));
        let torque = centre.x * force.y - centre.y * force.x - sense * turn;
        let hessian = Hessian::about(centre, [xx, xy, yy]);
        (Reduced { force, torque }, hessian)
    }

    /// ∫k ρ/r, ∫k r and ∫k ρρ/r³ about a centre next to the layer.
    fn by_cones<const WITH_HESSIAN: bool>(&self, centre: &Vector2<R>, here: R) -> [R; 6] {
        let mut sums = [R::ZERO; 6];
        for edge in self.edges {
            let seen = EdgeFromPole::new(edge, centre);
            let [first, second] = [edge.start(), edge.end()].map(|end| self.above(&end));
            let rate = (second - first) / edge.length();
            let base = self.pressure.at_centre() + first - rate * seen.t0;
            let parts = over_edge::<R, WITH_HESSIAN>(&seen, &edge.tangent(), [here, base, rate]);
            for (sum, part) in sums.iter_mut().zip(parts) {
                *sum += part;
            }
        }
        sums
    }

    /// The same about a centre farther away.
    fn by_squeezing<const WITH_HESSIAN: bool>(&self, centre: &Vector2<R>, here: R) -> [R; 6] {
        let zero = R::ZERO;
        let (g, level) = (&self.slope, self.pressure.at_centre());
        // ∫r and ∫ρ/r over the layer, and the line integrals.
        let mut inner = [zero; 3];
        let (mut pull, mut turn) = (Vector2::new(zero, zero), zero);
        let mut bend = [zero; 3];
        for edge in self.edges {
            let [first, second] = [edge.start(), edge.end()];
            let above = [first, second].map(|end| self.above(&end));
            let [low, high] = above;
            let measure = self.measure(edge);
            for_shares(|s, weight| {
                let from = self.squeezed(&first, low, s);
                let squeezed = Edge::new(from, self.squeezed(&second, high, s));
                let parts = Along::of(&squeezed, centre).weighted(above);
                let scale = measure * weight * edge.length() / squeezed.length();
                for (sum, part) in inner.iter_mut().zip(parts) {
                    *sum += scale * part;
                }
            });
            let along = Along::of(edge, centre);
            let [distance, x, y] = along.weighted(above.map(|above| level + above));
            let normal = edge.normal();
            pull += normal * distance;
            turn += along.seen.h * distance;
            if WITH_HESSIAN {
                let mixed = R::HALF * (normal.x * y + normal.y * x);
                for (sum, part) in bend.iter_mut().zip([normal.x * x, mixed, normal.y * y]) {
                    *sum += part;
                }
            }
        }
        let [distance, x, y] = inner;
        let pull = pull - g * distance;
        let turn = R::HALF * R::HALF * (turn + here * distance);
        let [xx, xy, yy] = bend;
        let mixed = xy - R::HALF * (g.x * y + g.y * x);
        // ρρ/r² is 1 − r ∇∇r.
        [pull.x, pull.y, turn, yy - g.y * y, -mixed, xx - g.x * x]
    }

    /// Friction of a patch that slides, given the pressure's integral and half the length of the longest edge.
    #[inline(never)]
    pub(super) fn slides(
        &self,
        slide: &TranslatingMotion<'_, R>,
        [load, half]: [R; 2],
    ) -> Reduced<R> {
        let sums = InLayer {
            layer: self,
            slide,
            at: slid,
        };
        slide.reduced_of(by_rule(&sums, half * slide.spin.abs(), FOR_WRENCH), load)
    }

    /// SecondMaterial derivatives of the power at a speed of 1.
    #[inline(never)]
    pub(super) fn bends(&self, slide: &TranslatingMotion<'_, R>, half: R) -> Hessian<R> {
        let sums = InLayer {
            layer: self,
            slide,
            at: bent,
        };
        slide.hessian_of(by_rule(&sums, half * slide.spin.abs(), FOR_HESSIAN))
    }
}

/// Calls `each` with the shares s of Gauss' rule on 0 … 1 and their weights.
#[inline(always)]
fn for_shares<R: Real>(mut each: impl FnMut(R, R)) {
    for &[node, weight] in &FEW_HALF {
        for node in [-node, node] {
            each(R::from_f64(0.5 + 0.5 * node), R::from_f64(0.5 * weight));
        }
    }
}

/// Line integrals along an edge.
struct Along<R: Real> {
    seen: EdgeFromPole<R>,
    length: R,
    /// ∫(r, ρ/r) dt and ∫(t − t₀)(r, ρ/r) dt
    even: [R; 3],
    odd: [R; 3],
}

impl<R: Real> Along<R> {
    #[inline(always)]
    fn of(edge: &Edge<R>, centre: &Vector2<R>) -> Self {
        let seen = EdgeFromPole::new(edge, centre);
        let (tangent, normal, h) = (edge.tangent(), edge.normal(), seen.h);
        let third = R::from_f64(1.0 / 3.0);
        let moment =
            seen.rise * (seen.r1 * seen.r1 + seen.r1 * seen.r0 + seen.r0 * seen.r0) * third;
        let h_log = h * seen.log;
        let even = normal * h_log + tangent * seen.rise;
        let odd = normal * (h * seen.rise) + tangent * (seen.integral - h * h_log);
        let t0 = seen.t0;
        Self {
            even: [seen.integral, even.x, even.y],
            odd: [
                moment - t0 * seen.integral,
                odd.x - t0 * even.x,
                odd.y - t0 * even.y,
            ],
            seen,
            length: edge.length(),
        }
    }

    /// The integrals with a weight that goes linearly from one value to another one.
    #[inline(always)]
    fn weighted(&self, [first, second]: [R; 2]) -> [R; 3] {
        let rate = (second - first) / self.length;
        let ([a, b, c], [d, e, f]) = (self.even, self.odd);
        [
            first * a + rate * d,
            first * b + rate * e,
            first * c + rate * f,
        ]
    }
}

/// Integrals over a layer of functions at two points at once.
struct InLayer<'a, 'b, R: Real, K, F> {
    layer: &'a Layer<'b, R, K>,
    slide: &'a TranslatingMotion<'a, R>,
    at: F,
}

impl<R: Real, K: PressureField<R>, F> EdgeQuadrature<R> for InLayer<'_, '_, R, K, F>
where
    F: Fn(Pair2<R>, [Pair2<R>; 2]) -> [Pair2<R>; 3],
{
    type Sum = [R; 3];

    fn sum(&self, rule: &[[f64; 2]]) -> [R; 3] {
        let (layer, slide) = (self.layer, self.slide);
        let (level, w) = (layer.pressure.at_centre(), Pair2::of(slide.spin));
        let mut sums = [Pair2::of(R::ZERO); 3];
        for edge in layer.edges {
            let half = R::HALF * edge.length();
            let middle = edge.start() + edge.tangent() * half;
            let unit = layer.measure(edge) * half;
            for &[node, weight] in rule {
                let by = edge.tangent() * (R::from_f64(node) * half);
                let weight = R::from_f64(weight) * unit;
                let [one, other] = [middle + by, middle - by];
                let [first, second] = [one, other].map(|point| layer.above(&point));
                for_shares(|s, share| {
                    let [a, b] = slide.turned(&layer.squeezed(&one, first, s));
                    let [c, d] = slide.turned(&layer.squeezed(&other, second, s));
                    let at = [Pair2([a, c]), Pair2([b, d])];
                    let count = |above: R| weight * share * above * (level + s * above);
                    let counts = Pair2([count(first), count(second)]);
                    for (sum, part) in sums.iter_mut().zip((self.at)(w, at)) {
                        *sum = *sum + counts * part;
                    }
                });
            }
        }
        sums.map(Pair2::sum)
    }
}

#[cfg(test)]
mod tests {
    use crate::coupling::flat::ShapeFriction;
    use crate::patch::outline::Polygon;
    use crate::twist::Twist;

    /// A strip, its centre of pressure, a twist, and force and torque about the origin for a μN of 1.
    struct Strip {
        aspect: f64,
        corners: [[f64; 2]; 4],
        centre: [f64; 2],
        twist: [f64; 3],
        wrench: [f64; 3],
    }

    /// By line integrals about the centre of rotation with 50 digits (mpmath 1.3, in polar coordinates):
    /// centres on the strip, beside it, and beyond three radii.
    const STRIPS: &[Strip] = &[
        Strip {
            aspect: 100.0,
            corners: [
                [0.04553088619556628, -0.9990129820989547],
                [-0.02554351911305632, 0.999723726152041],
                [-0.04553088619556628, 0.9990129820989547],
                [0.02554351911305632, -0.999723726152041],
            ],
            centre: [-0.0038531203324228126, 0.0815094995960308],
            twist: [
                0.0011611921188251723,
                -0.003315576466182502,
                0.11947027467571233,
            ],
            wrench: [
                0.1088617419398144,
                0.12646134581595167,
                -0.49856915570316834,
            ],
        },
        Strip {
            aspect: 100.0,
            corners: [
                [-0.9936203843153004, -0.11321895544967131],
                [0.9956858328025822, 0.09332589327849247],
                [0.9936203843153004, 0.11321895544967131],
                [-0.9956858328025822, -0.09332589327849247],
            ],
            centre: [-0.06407096264324223, -0.007614974382717597],
            twist: [-4.528819062326565, 3.661127678358835, 2.7824464505870696],
            wrench: [
                0.7962655296699999,
                -0.5686281959872659,
                -0.04603699889566099,
            ],
        },
        Strip {
            aspect: 100.0,
            corners: [
                [-0.9010461666831089, -0.4338384555403947],
                [0.9095418769895496, 0.4157325751036681],
                [0.9010461666831089, 0.4338384555403947],
                [-0.9095418769895496, -0.4157325751036681],
            ],
            centre: [-0.09342326981537856, -0.042901060188437264],
            twist: [2.818039078741285, 0.8039349087069008, 0.3848651002717206],
            wrench: [
                -0.9623761796124092,
                -0.2616685944832145,
                -0.05785077471765321,
            ],
        },
        Strip {
            aspect: 1000.0,
            corners: [
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
            aspect: 1000.0,
            corners: [
                [-0.969033930767656, -0.24692962766947554],
                [0.9695258514632127, 0.2449910678872447],
                [0.969033930767656, 0.24692962766947554],
                [-0.9695258514632127, -0.2449910678872447],
            ],
            centre: [0.1459956094817801, 0.03708292793076651],
            twist: [-7.134075406931558, -3.791132544954862, 2.066840399715809],
            wrench: [0.8934038142617708, 0.4276379248753957, -0.04547123975099742],
        },
        Strip {
            aspect: 1000.0,
            corners: [
                [0.9263429461765654, -0.37668255344377305],
                [-0.9255877291390026, 0.3785344841190886],
                [-0.9263429461765654, 0.37668255344377305],
                [0.9255877291390026, -0.3785344841190886],
            ],
            centre: [0.0899089275478409, -0.03670841621317927],
            twist: [103.61645596382502, -27.424031360973974, 9.470547327830857],
            wrench: [-0.9675741347330822, 0.247643248124675, -0.0413040023770366],
        },
        Strip {
            aspect: 10000.0,
            corners: [
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
            corners: [
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
            corners: [
                [0.17116487004046727, -0.9852424053318198],
                [-0.17096781813807405, 0.9852766186006376],
                [-0.17116487004046727, 0.9852424053318198],
                [0.17096781813807405, -0.9852766186006376],
            ],
            centre: [-0.007400133926319752, 0.04258907488345833],
            twist: [-2.944263026899032, 15.112344103640279, 2.2908882638982795],
            wrench: [0.1966564748553997, -0.976768965124603, -0.05011552904781815],
        },
    ];

    #[test]
    fn linear_pressure_on_strips_loses_the_aspect_ratio_and_not_its_square() {
        for strip in STRIPS {
            let even = Polygon::new(strip.corners).unwrap();
            let leaning = even.with_centre_of_pressure(strip.centre).unwrap();
            let friction = ShapeFriction::new(leaning, 1.0).unwrap();
            let [x, y, spin] = strip.twist;
            let found = friction.wrench(1.0, &Twist::new(x, y, spin));
            let [x, y, torque] = strip.wrench;
            // Torques about the origin, of at most twice the radius.
            let off =
                libm::hypot(found.force.x - x, found.force.y - y) + (found.torque - torque).abs();
            assert!(
                off < 5e-14 * strip.aspect / 10.0,
                "{} {off:e}",
                strip.aspect
            );
        }
    }
}
