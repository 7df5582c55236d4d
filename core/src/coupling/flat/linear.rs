//! Friction of a patch with straight edges under linear pressure: one form for every motion.
//!
//! The notation is that of [`super::uniform`]; the centre of pressure is the origin. The pressure, of its mean,
//! is k = k_c + g·x, and on an edge k_m + k_t t with the distance t from its middle. The divergence
//! theorem for k q and x k q gives
//!
//! ```text
//! force = −(v + w f/area),     torque = −w [3 + (Σ H γ + k_c P − 3 v·f″)/area]/4
//! f = Σ τ γ − (z × g) P,       γ = ∫k p dl = k_m β + k_t δ,       P = ∫p dA = Σ [H (β − l/2) + (v·τ) β″]/3
//! ```
//!
//! f″ is the rest of f over w in p = p₀ + w p″: the gradient of p₀ = ((v·x)² − 1)/2 has the direction of v, so
//! that v·f is w v·f″. Once more, p″ = w p‴ − α p₀ with p‴ = (x² − p²)/2 − α p″:
//!
//! ```text
//! f″ = Σ τ γ″ − (z × g) P″,    γ″ = k_m β″ + k_t δ″,    P″ = ∫p″ dA = [Σ (H β″ + (v·τ) β‴) + w P]/(3 + w²)
//! ```
//!
//! An edge's β, β″, β‴ are the trapezoid's rule and E, E″, E‴; with σ = ᾱ + w p̄ (S = 2 + 2 w σ), ε = α σ − p,
//! ζ = ζ₀ + w ζ₁, ζ₀ = v·τ/2, ζ₁ = H/2 − ζ σ, ζ₁₀ = (H − (v·τ) ᾱ)/2 and μ = ζ²/(1 − y²), C = μ − ζ² G, K = μ/3 − ζ² G
//!
//! ```text
//! β″: E″ = −(l²/S) [2/3 (ζ₁ (ζ + ζ₀) − ζ₀² σ) + w (l/S)² C]
//! β‴: E‴ = −(l²/S) [2/3 (ζ₀ (ζ₀ ε − 2 ζ₁₀ σ − 2 ζ p̄ − 2 ᾱ ζ₁) + ζ₁²) + (l/S)² C] − w H (v·τ) l²/6
//! δ  = (l³/S) [c (1/6 + y² K) + v·n (σ/6 − w (l/S)² K)],        c = middle·τ
//! δ″ = (l³/S) [c (w (l/S)² K + (w S/2 − σ)/6) − v·n (ε/6 + (l/S)² K)]
//! ```
//!
//! Nothing cancels, nothing is divided by a speed or a spin, and all terms are bounded.
//!
//! *Second derivatives* of the power. With ∫k ∂p/∂v dl = W and χ = (v·W)/w, whose parts along τ and n are
//!
//! ```text
//! W = k_m l [z × middle − 2 σ u/S] + 2 l (l/S)² g ζ (w k_m + k_t s) τ + k_t l E n,     u = ζ S τ + s n
//! χ = 2 (l/S) k_m (w ᾱ − p̄ V²) + 2 l (l/S)² g ζ (k_m v·τ − k_t H s) + k_t [c l E − 3 w s l² (l/S)³ K]
//! D_vv = [Σ τ ⊗ W − (z × g) ⊗ B]/area,     B = Σ τ β = ∫∂p/∂v dA
//! D_vw = [Σ H W − 3 f + k_c B]/area,       D_ww = [3 v·f″ − Σ H χ − k_c Σ (v·τ) β″]/area
//! ```
//!
//! *Steep pressure*. On a patch that is thin along g the area integrals P, P″ and B are small, but sums of long edges
//! that cancel unless the centre of rotation is close, and g multiplies them. The patch is a layer about the level line
//! of the centre of pressure: with e = g·x on an edge, and the points x_s on the way from that line to the edge,
//!
//! ```text
//! ∫f dA = Σ (g × τ)/g² ∫∫e f(x_s) ds dl,     s = 0 … 1
//! ```
//!
//! whose terms are as small as the layer is thin, by Gauss' rule in s and the closed forms along the squeezed edges.
//! Products with corners cancel there, too, and are taken with what rounding leaves of them.

use super::motion::Motion;
use super::uniform::{Corner, MovingEdge, UnitMotion, each};
use super::{Hessian, Reduced};
use crate::patch::outline::{Edge, PressureField};
use crate::real::Real;
use crate::special::legendre::FEW_HALF;
use nalgebra::Vector2;

/// Slope, of the mean pressure over the radius, from which on a patch is a layer: pressure is nowhere negative,
/// so that all of it lies within half a radius.
const STEEP: f64 = 4.0;
/// Mean pressures at the centre of rotation up to which it is close: some widths of the layer away.
const CLOSE: f64 = 8.0;

/// One more than the power of two that cuts a number into halves of its digits, 2²⁷ and for f32 2¹².
const HALVES: f64 = 134_217_729.0;
const HALVES_SINGLE: f64 = 4_097.0;

/// A weight along an edge: that of its middle, and its rate along the tangent.
struct Weight<R> {
    middle: R,
    rate: R,
}

impl<R: Real> Weight<R> {
    /// That goes from one value to another one along a length.
    #[inline(always)]
    fn between([from, to]: [R; 2], length: R) -> Self {
        Self {
            middle: R::HALF * (from + to),
            rate: (to - from) / length,
        }
    }
}

/// The scalar product to rounding of itself, however much of its terms cancels.
#[inline(always)]
fn sharp<R: Real>(a: &Vector2<R>, b: &Vector2<R>) -> R {
    let (first, second) = (a.x * b.x, a.y * b.y);
    let lost = lost_in(first, a.x, b.x) + lost_in(second, a.y, b.y);
    first + second + lost
}

/// What rounding took from a product (Dekker 1971, Numer. Math. 18, 224).
#[inline(always)]
fn lost_in<R: Real>(product: R, a: R, b: R) -> R {
    let halves = |x: R| {
        let large = x * R::from_f64(if R::IS_SINGLE { HALVES_SINGLE } else { HALVES });
        let high = large - (large - x);
        (high, x - high)
    };
    let ((a, a_low), (b, b_low)) = (halves(a), halves(b));
    ((a * b - product) + a * b_low + a_low * b) + a_low * b_low
}

/// What an edge adds to integrals of p, p″ and p‴.
struct EdgeIntegrals<R> {
    /// β, β″, β‴
    even: [R; 3],
    /// δ, δ″
    odd: [R; 2],
    /// l E
    bent: R,
    /// 2 l (l/S)² g ζ
    turned: R,
    /// (l/S)² K
    part: R,
    /// s, the velocity of the middle along the normal.
    across: R,
}

impl<R: Real> EdgeIntegrals<R> {
    #[inline(always)]
    fn new(edge: &Edge<R>, ends: [&Corner<R>; 2], moving: &MovingEdge<R>) -> Self {
        let MovingEdge {
            length,
            offset,
            spin: w,
            along,
            across,
            middle,
            p,
            arm,
            sum,
            reach,
            zeta,
            ..
        } = *moving;
        let [third, sixth] = [1.0 / 3.0, 1.0 / 6.0].map(R::from_f64);
        let two_thirds = third + third;
        let (zeta_sq, reach_sq) = (zeta * zeta, reach * reach);
        let of_log = zeta_sq * moving.bend;
        let whole = reach_sq * (moving.open - of_log);
        let part = reach_sq * (third * moving.open - of_log);
        let sigma = arm + w * p;
        let fall = arm * sigma - p;
        let unit = -(length * reach);
        // ζ of a translation, and the rest over the spin, twice.
        let zeta_0 = R::HALF * along;
        let zeta_1 = R::HALF * offset - zeta * sigma;
        let zeta_10 = R::HALF * (offset - along * arm);
        let zeta_11 = zeta * p + arm * zeta_1;
        let e = unit * (moving.open - zeta_sq * moving.log());
        let e_2 =
            unit * (two_thirds * (zeta_1 * (zeta + zeta_0) - zeta_0 * zeta_0 * sigma) + w * whole);
        let once = zeta_0 * fall - R::TWO * (zeta_10 * sigma + zeta_11);
        let e_3 = unit * (two_thirds * (zeta_0 * once + zeta_1 * zeta_1) + whole)
            - sixth * (length * length) * (w * offset * along);
        // p‴ of a corner.
        let [from, to] = [(edge.start(), ends[0]), (edge.end(), ends[1])].map(|(at, corner)| {
            R::HALF * (at.x * at.x + at.y * at.y - corner.p * corner.p) - corner.arm * corner.rest
        });
        let third_order = R::HALF * (from + to);
        let cube = -(unit * length);
        let w_part = w * part;
        Self {
            even: [
                length * (p + e),
                length * (moving.rest + e_2),
                length * (third_order + e_3),
            ],
            odd: [
                cube * (middle * (sixth + w * w_part) + across * (sixth * sigma - w_part)),
                cube * (middle * (w_part + sixth * (R::HALF * w * sum - sigma))
                    - across * (sixth * fall + part)),
            ],
            bent: length * e,
            turned: R::TWO * length * reach_sq * moving.log() * zeta,
            part,
            across: across - w * middle,
        }
    }

    /// γ and γ″
    #[inline(always)]
    fn weighted(&self, weight: &Weight<R>) -> [R; 2] {
        let ([beta, beta_2, _], [delta, delta_2]) = (self.even, self.odd);
        let Weight { middle, rate } = *weight;
        [
            middle * beta + rate * delta,
            middle * beta_2 + rate * delta_2,
        ]
    }

    /// W along the tangent and the normal.
    #[inline(always)]
    fn slope(&self, moving: &MovingEdge<R>, weight: &Weight<R>) -> [R; 2] {
        let Weight { middle, rate } = *weight;
        let sigma = moving.arm + moving.spin * moving.p;
        let (double, load) = (R::TWO * sigma, middle * moving.length);
        let lengthwise = load * (moving.offset - double * moving.zeta)
            + self.turned * (moving.spin * middle + rate * self.across);
        let crosswise =
            rate * self.bent - load * (moving.middle + double * self.across * moving.inv_sum);
        [lengthwise, crosswise]
    }

    /// χ
    #[inline(always)]
    fn spin_slope(&self, moving: &MovingEdge<R>, weight: &Weight<R>, speed_sq: R) -> R {
        let Weight { middle, rate } = *weight;
        let MovingEdge {
            spin: w,
            reach,
            length,
            ..
        } = *moving;
        let three = R::from_f64(3.0);
        let lever = length * length * reach * self.part;
        R::TWO * reach * middle * (w * moving.arm - moving.p * speed_sq)
            + self.turned * (middle * moving.along - rate * moving.offset * self.across)
            + rate * (moving.middle * self.bent - three * w * self.across * lever)
    }
}

/// Integrals over the area: P, P″ and B.
struct AreaIntegrals<R: Real> {
    p: R,
    rest: R,
    slope: Vector2<R>,
}

/// Sums over the edges.
struct LinearSums<R: Real> {
    /// Σ τ γ and Σ τ γ″
    pull: Vector2<R>,
    rest: Vector2<R>,
    /// Σ H γ
    turn: R,
    /// Σ [H (β − l/2) + (v·τ) β″], Σ (H β″ + (v·τ) β‴) and Σ (v·τ) β″
    area: [R; 3],
    /// B
    slope: Vector2<R>,
    /// Σ τ ⊗ W: xx, xy and yy; Σ H W, Σ H χ
    bend: [R; 3],
    mixed: Vector2<R>,
    spin: R,
}

impl<R: Real> LinearSums<R> {
    fn new() -> Self {
        let (zero, none) = (R::ZERO, Vector2::new(R::ZERO, R::ZERO));
        Self {
            pull: none,
            rest: none,
            turn: zero,
            area: [zero; 3],
            slope: none,
            bend: [zero; 3],
            mixed: none,
            spin: zero,
        }
    }

    #[inline(always)]
    fn add(&mut self, moving: &MovingEdge<R>, own: &EdgeIntegrals<R>, weight: &Weight<R>) {
        let (tangent, offset, along) = (moving.tangent, moving.offset, moving.along);
        let ([beta, beta_2, beta_3], [gamma, gamma_2]) = (own.even, own.weighted(weight));
        self.pull += tangent * gamma;
        self.rest += tangent * gamma_2;
        self.turn += offset * gamma;
        let parts = [
            offset * (beta - R::HALF * moving.length) + along * beta_2,
            offset * beta_2 + along * beta_3,
            along * beta_2,
        ];
        for (sum, part) in self.area.iter_mut().zip(parts) {
            *sum += part;
        }
        self.slope += tangent * beta;
    }

    #[inline(always)]
    fn add_hessian(
        &mut self,
        moving: &MovingEdge<R>,
        own: &EdgeIntegrals<R>,
        weight: &Weight<R>,
        speed_sq: R,
    ) {
        let (x, y) = (moving.tangent.x, moving.tangent.y);
        let [lengthwise, crosswise] = own.slope(moving, weight);
        let parts = [
            x * (lengthwise * x + crosswise * y),
            lengthwise * x * y + R::HALF * crosswise * (y * y - x * x),
            y * (lengthwise * y - crosswise * x),
        ];
        for (sum, part) in self.bend.iter_mut().zip(parts) {
            *sum += part;
        }
        self.mixed += turned_back(&moving.tangent, [lengthwise, crosswise]) * moving.offset;
        self.spin += moving.offset * own.spin_slope(moving, weight, speed_sq);
    }

    /// The integrals over the area by the divergence theorem.
    #[inline(always)]
    fn over_area(&self, w: R) -> AreaIntegrals<R> {
        let [first, second, _] = self.area;
        let three = R::from_f64(3.0);
        let p = first / three;
        AreaIntegrals {
            p,
            rest: (second + w * p) / (three + w * w),
            slope: self.slope,
        }
    }
}

/// The vector with these parts along a tangent and the normal to its right.
#[inline(always)]
fn turned_back<R: Real>(tangent: &Vector2<R>, [along, across]: [R; 2]) -> Vector2<R> {
    let (x, y) = (tangent.x, tangent.y);
    Vector2::new(along * x + across * y, along * y - across * x)
}

/// Reduced friction of a patch with this area, and second derivatives of the dissipated power, if asked for.
#[inline]
pub(super) fn friction<R: Real, K: PressureField<R>, const WITH_HESSIAN: bool>(
    edges: &[Edge<R>],
    pressure: &K,
    area: R,
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let motion = UnitMotion::of(motion);
    let (x, y, w) = (motion.x, motion.y, motion.spin);
    let speed_sq = x * x + y * y;
    let (slope, at_centre) = (Vector2::from(pressure.slope()), pressure.at_centre());
    let is_steep = slope.x * slope.x + slope.y * slope.y > R::from_f64(STEEP * STEEP);
    let velocity = Vector2::new(x, y);
    let mut sums = LinearSums::new();
    let mut last = None;
    each(edges, &motion, |edge, ends, moving| {
        let (start, end) = (edge.start(), edge.end());
        let mut moving = *moving;
        let pressure = |place: &Vector2<R>| {
            at_centre
                + if is_steep {
                    sharp(&slope, place)
                } else {
                    slope.x * place.x + slope.y * place.y
                }
        };
        if is_steep {
            // Of a thin patch's long edges, whose sums cancel.
            let inv = R::ONE / moving.length;
            let across = [Vector2::new(start.x, -start.y), Vector2::new(end.y, end.x)];
            moving.offset = sharp(&across[0], &across[1]) * inv;
            moving.along = (sharp(&velocity, &end) - sharp(&velocity, &start)) * inv;
        }
        let own = EdgeIntegrals::new(edge, ends, &moving);
        let from = match last {
            Some((place, pressure)) if place == start => pressure,
            _ => pressure(&start),
        };
        let to = pressure(&end);
        last = Some((end, to));
        let weight = Weight::between([from, to], moving.length);
        sums.add(&moving, &own, &weight);
        if WITH_HESSIAN {
            sums.add_hessian(&moving, &own, &weight, speed_sq);
        }
    });
    // Pressure at the centre of rotation times the spin.
    let there = at_centre * w + (slope.y * x - slope.x * y);
    let over = if is_steep && there.abs() > R::from_f64(CLOSE) * w.abs() {
        over_layer::<R, WITH_HESSIAN>(edges, &slope, &motion)
    } else {
        sums.over_area(w)
    };
    // −(z × g)
    let aside = Vector2::new(slope.y, -slope.x);
    let (pull, rest) = (sums.pull + aside * over.p, sums.rest + aside * over.rest);
    let (share, three) = (R::ONE / area, R::from_f64(3.0));
    let along = x * rest.x + y * rest.y;
    let turn = sums.turn + at_centre * over.p - three * along;
    let by = w * share;
    let reduced = Reduced {
        force: Vector2::new(-(x + by * pull.x), -(y + by * pull.y)),
        torque: -(R::HALF * R::HALF * w * (three + share * turn)),
    };
    let [xx, xy, yy] = sums.bend;
    let slope = over.slope;
    let mixed = sums.mixed - pull * three + slope * at_centre;
    let [_, _, lost] = sums.area;
    let hessian = Hessian {
        xx: xx + aside.x * slope.x,
        xy: xy + R::HALF * (aside.x * slope.y + aside.y * slope.x),
        yy: yy + aside.y * slope.y,
        xn: mixed.x,
        yn: mixed.y,
        nn: three * along - sums.spin - at_centre * lost,
    };
    (reduced, hessian.scaled(share * motion.rate))
}

/// The integrals over a layer about the level line of a steep pressure with this slope.
#[cold]
fn over_layer<R: Real, const WITH_HESSIAN: bool>(
    edges: &[Edge<R>],
    slope: &Vector2<R>,
    motion: &UnitMotion<R>,
) -> AreaIntegrals<R> {
    let inv_sq = R::ONE / (slope.x * slope.x + slope.y * slope.y);
    let mut over = AreaIntegrals {
        p: R::ZERO,
        rest: R::ZERO,
        slope: Vector2::new(R::ZERO, R::ZERO),
    };
    for edge in edges {
        let (ends, tangent) = ([edge.start(), edge.end()], edge.tangent());
        // Pressure above the level line.
        let [low, high] = ends.map(|end| sharp(slope, &end));
        let measure = (slope.x * tangent.y - slope.y * tangent.x) * inv_sq * edge.length();
        for_shares(|s, share| {
            let [from, to] = [(ends[0], low), (ends[1], high)]
                .map(|(end, above)| end - slope * ((R::ONE - s) * above * inv_sq));
            let squeezed = Edge::new(from, to);
            let corners = [from, to].map(|corner| Corner::new(motion, &corner));
            let corners = [&corners[0], &corners[1]];
            let moving = MovingEdge::new(motion, &squeezed, corners);
            let own = EdgeIntegrals::new(&squeezed, corners, &moving);
            let scale = measure * share / squeezed.length();
            let weight = Weight::between([scale * low, scale * high], squeezed.length());
            let [p, rest] = own.weighted(&weight);
            over.p += p;
            over.rest += rest;
            if WITH_HESSIAN {
                over.slope += turned_back(&moving.tangent, own.slope(&moving, &weight));
            }
        });
    }
    over
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
            assert!(off < 1e-15 * strip.aspect, "{} {off:e}", strip.aspect);
        }
    }
}
