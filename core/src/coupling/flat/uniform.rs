//! Friction of a patch with straight edges under uniform pressure: one form for every motion.
//!
//! Lengths are in radii and the motion (v, w) of the centroid, the origin, has |v|² + w² = 1. An element
//! at x has the speed q, with α = v·(z × x),
//!
//! ```text
//! q² = 1 + 2 w α + w² (x² − 1),        q = 1 + w α + w² p,       p = (x² − 1 − α p − α (α + w p))/(q + 1)
//! ```
//!
//! (read with p on both sides as the quotient (x² − 1 − α m)/(q + 1), m = (2 α + w (x² − 1))/(q + 1)).
//! By the divergence theorem the integrals of p along the edges, β, give the force; the part of p that is left
//! at w = 0, (v·x)² − 1 over 2, has no share in the torque, where its line integral is that of an exact
//! differential, and p″ = w x²/2 − p (α + w p/2) is the rest of p over w:
//!
//! ```text
//! force = −(v + w Σ τ β/area),     torque = −w [2 + Σ (H β − 2 (v·τ) β″)/area]/3
//! ```
//!
//! An edge of length l with tangent τ, outward normal n and H = x·n has at its ends the speeds q₀, q₁; with
//! S = q₀ + q₁, y = w l/S, ζ = η/S, where η = v·τ + w H is the velocity along the edge,
//!
//! ```text
//! ∫q dl = l S/2 + w² l E,     E = −(l²/S) [2/3 ζ² + y² C],     C = ζ²/(1 − y²) − ζ² G
//! G(y²) = ((artanh y/y − 1)/y² − 1/3)/y² = Σ y²ⁿ/(2 n + 5)
//! β = l (p̄ + E),     β″ = l (p̄″ + E″)
//! E″ = −(l²/S) [(2/3 H (η + v·τ) − (v·τ)² σ (4 + 2 S + S²)/12)/S² + w (l/S)² C],     S = 2 + w σ
//! ```
//!
//! with means p̄ of both ends. Nothing cancels, nothing is divided by a speed or a spin, and all
//! terms are bounded: (1 − y²) S² is 2 (q₀ q₁ + u₀·u₁) with the velocities u of the ends, or, where these are
//! opposed, 2 (η w l)²/(q₀ q₁ − u₀·u₁).
//!
//! *Second derivatives* of the power follow from the integrals of 1/q along the edges, in which
//! g = 1/3 + y² G, κ̄ = 2 (ᾱ² − p̄ + w ᾱ p̄)/S and λ = l (κ̄ + 2 l² g/S³):
//!
//! ```text
//! D_vv = Σ τ ⊗ [(l (H − η ᾱ) + w η λ) τ − Δp n]/area,     Δp = (2 l/S) [v·n (ᾱ + w p̄) + x̄·τ]
//! D_vw = −w v − Σ τ ε/area,         ε = 2 l³ g η (v·τ)/S³ − 2 l (p̄ + w² (ᾱ² − p̄ + w ᾱ p̄))/S
//! D_ww = v² + Σ (v·τ) χ/area,       w χ = ε + the part of β that is left at w = 0
//! ```

use super::motion::Motion;
use super::{Hessian, Reduced};
use crate::lanes::{FOUR, Laned, Numbers};
use crate::patch::outline::Edge;
use crate::real::Real;
use crate::special::log;
use nalgebra::Vector2;

/// Functions P and Q of z = 1 − y² with G = P + Q ln z: joint least squares in 40 digits with Lawson's weights, G to
/// 2.8e-17 over (y² + 0.03)(√z + 0.001).
const BEND: [[f64; 2]; 12] = [
    [-0.640_186_152_773_286_2, -0.499_999_999_999_991_6],
    [-0.850_465_380_724_866_6, -1.249_999_999_850_792_7],
    [-1.019_563_395_878_982_8, -2.187_499_832_449_630_3],
    [-1.164_590_911_452_240_0, -3.281_213_547_399_995_5],
    [-1.285_295_944_233_070_8, -4.509_353_780_325_757_4],
    [-1.254_356_415_937_781_5, -5.807_985_534_896_961],
    [-0.367_953_988_603_442_8, -6.739_369_366_662_877],
    [1.963_064_951_581_770_9, -6.013_823_535_200_807],
    [3.151_395_337_692_600_5, -3.196_885_026_539_811],
    [1.486_713_005_272_929, -0.750_477_417_385_062_3],
    [0.179_937_335_275_320_7, -0.048_919_327_478_106_24],
    [0.001_301_559_781_050_569, 0.0],
];
/// The same to 1.7e-8.
const BEND_SINGLE: [[f32; 2]; 6] = [
    [-0.640_171_5, -0.499_998_4],
    [-0.841_706_9, -1.248_345],
    [-0.670_224_07, -2.078_882_7],
    [0.970_850_57, -2.041_481_5],
    [1.318_973_9, -0.591_809_65],
    [0.062_278_574, 0.0],
];

/// G, given 1 − y².
#[inline(always)]
fn bend<R: Real, L: Numbers<Real = R>>(gap: L) -> L {
    let [smooth, of_log] = L::sums(&BEND_SINGLE, &BEND, gap);
    smooth + log(gap) * of_log
}

/// A motion with |velocity|² + spin² = 1.
#[derive(Clone, Copy)]
pub(super) struct UnitMotion<L> {
    pub(super) x: L,
    pub(super) y: L,
    pub(super) spin: L,
}

impl<R: Real> UnitMotion<R> {
    /// The motion in units of a speed, and 1 over that.
    #[inline(always)]
    pub(super) fn of(motion: &Motion<R>) -> (Self, R) {
        let (velocity, spin) = (&motion.velocity, motion.rim);
        let sq = velocity.x * velocity.x + velocity.y * velocity.y + spin * spin;
        if sq > R::MIN_POSITIVE / R::EPSILON && sq < R::INFINITY {
            let rate = R::ONE / sq.sqrt();
            let (x, y) = (velocity.x * rate, velocity.y * rate);
            let spin = spin * rate;
            return (Self { x, y, spin }, rate);
        }
        Self::of_any(velocity, spin)
    }

    /// The same motion in every lane.
    #[inline(always)]
    pub(super) fn repeat<L: Numbers<Real = R>>(&self) -> UnitMotion<L> {
        UnitMotion {
            x: L::repeat(self.x),
            y: L::repeat(self.y),
            spin: L::repeat(self.spin),
        }
    }

    /// The same where the square leaves the range of numbers.
    #[cold]
    fn of_any(velocity: &Vector2<R>, spin: R) -> (Self, R) {
        let size = velocity.x.hypot(velocity.y).hypot(spin);
        let (x, y) = (velocity.x / size, velocity.y / size);
        let spin = spin / size;
        (Self { x, y, spin }, R::ONE / size)
    }
}

/// Speed of a corner at rest, in rounding errors: the speed along its edges is not known better.
const LEAST_SPEED: f64 = 0.25;

/// A corner.
struct Corner<L> {
    /// Its velocity.
    u: [L; 2],
    /// |u|
    q: L,
    /// α
    arm: L,
    /// p
    p: L,
    /// p″
    rest: L,
    /// p‴
    third: L,
}

impl<L: Numbers<Real: Real>> Corner<L> {
    #[inline(always)]
    fn new(motion: &UnitMotion<L>, [x, y]: [L; 2]) -> Self {
        let (v_x, v_y, w, one) = (motion.x, motion.y, motion.spin, L::splat(1.0));
        let u = [v_x - w * y, v_y + w * x];
        let least = L::repeat(L::Real::from_f64(LEAST_SPEED) * L::Real::EPSILON);
        let q = (u[0] * u[0] + u[1] * u[1] + least * least).sqrt();
        let arm = v_y * x - v_x * y;
        let sq = x * x + y * y;
        let from_rim = sq - one;
        let inv = one / (q + one);
        let p = (from_rim - arm * ((arm + arm + w * from_rim) * inv)) * inv;
        let half = L::splat(0.5) * w;
        let rest = half * sq - p * (arm + half * p);
        let third = L::splat(0.5) * (sq - p * p) - arm * rest;
        Self {
            u,
            q,
            arm,
            p,
            rest,
            third,
        }
    }
}

/// Edges side by side.
#[derive(Clone, Copy)]
pub(super) struct Sides<L> {
    pub(super) from: [L; 2],
    pub(super) to: [L; 2],
    pub(super) tangent: [L; 2],
    pub(super) length: L,
    /// H
    pub(super) offset: L,
}

impl<L: Numbers<Real: Real>> Sides<L> {
    /// Edges without length where there are no more.
    #[inline(always)]
    fn of(edges: &[Edge<L::Real>]) -> Self {
        let none = Edge::default();
        let of = |part: fn(&Edge<L::Real>) -> L::Real| {
            L::of(|lane| part(edges.get(lane).unwrap_or(&none)))
        };
        let from = [of(|edge| edge.start().x), of(|edge| edge.start().y)];
        let tangent = [of(|edge| edge.tangent().x), of(|edge| edge.tangent().y)];
        Self {
            from,
            to: [of(|edge| edge.end().x), of(|edge| edge.end().y)],
            tangent,
            length: of(|edge| edge.length()),
            offset: from[0] * tangent[1] - from[1] * tangent[0],
        }
    }

    /// Middle · tangent.
    #[inline(always)]
    pub(super) fn middle(&self) -> L {
        let (from, to, [x, y]) = (self.from, self.to, self.tangent);
        L::splat(0.5) * ((from[0] + to[0]) * x + (from[1] + to[1]) * y)
    }
}

/// Edges under a motion.
#[derive(Clone, Copy)]
pub(super) struct MovingEdge<L> {
    pub(super) sides: Sides<L>,
    /// w
    pub(super) spin: L,
    /// v·τ and v·n
    pub(super) along: L,
    pub(super) across: L,
    /// η
    pub(super) eta: L,
    /// Means of p, α, p″ and, where pressure is linear, p‴ at the ends.
    pub(super) p: L,
    pub(super) arm: L,
    pub(super) rest: L,
    pub(super) third: L,
    /// 1/S
    pub(super) inv_sum: L,
    /// l/S
    pub(super) reach: L,
    /// (l/S)²
    pub(super) reach_sq: L,
    /// ζ²
    pub(super) zeta_sq: L,
    /// ζ²/(1 − y²)
    pub(super) open: L,
    /// G
    pub(super) bend: L,
    /// g
    pub(super) log: L,
    /// σ (4 + 2 S + S²)/12
    pub(super) spread: L,
}

impl<L: Numbers<Real: Real>> MovingEdge<L> {
    #[inline(always)]
    pub(super) fn new(motion: &UnitMotion<L>, sides: Sides<L>) -> Self {
        let (w, half) = (motion.spin, L::splat(0.5));
        let from = Corner::new(motion, sides.from);
        let to = Corner::new(motion, sides.to);
        let along = motion.x * sides.tangent[0] + motion.y * sides.tangent[1];
        let eta = along + w * sides.offset;
        let sum = from.q + to.q;
        let inv_sum = L::splat(1.0) / sum;
        let reach = sides.length * inv_sum;
        let zeta = eta * inv_sum;
        let (reach_sq, zeta_sq) = (reach * reach, zeta * zeta);
        let y_sq = w * w * reach_sq;
        let (open, gap) = opened([zeta_sq, y_sq], [&from, &to], inv_sum);
        let bend = bend(gap);
        let (p, arm) = (half * (from.p + to.p), half * (from.arm + to.arm));
        Self {
            spin: w,
            along,
            across: motion.x * sides.tangent[1] - motion.y * sides.tangent[0],
            eta,
            p,
            arm,
            rest: half * (from.rest + to.rest),
            third: half * (from.third + to.third),
            inv_sum,
            reach,
            reach_sq,
            zeta_sq,
            open,
            bend,
            log: splat::<L>(1.0 / 3.0) + y_sq * bend,
            spread: splat::<L>(1.0 / 6.0)
                * (arm + w * p)
                * (L::splat(4.0) + sum * (L::splat(2.0) + sum)),
            sides,
        }
    }

    /// β
    #[inline(always)]
    pub(super) fn beta(&self) -> L {
        let bent = self.open - self.zeta_sq * self.log;
        self.sides.length * (self.p - self.sides.length * self.reach * bent)
    }

    /// β″
    #[inline(always)]
    fn beta_rest(&self) -> L {
        let Self { along, eta, .. } = *self;
        let turned =
            splat::<L>(2.0 / 3.0) * self.sides.offset * (eta + along) - along * along * self.spread;
        let closed = self.open - self.zeta_sq * self.bend;
        let bent = turned * (self.inv_sum * self.inv_sum) + self.spin * self.reach_sq * closed;
        self.sides.length * (self.rest - self.sides.length * self.reach * bent)
    }
}

/// A number in every lane.
#[inline(always)]
pub(super) fn splat<L: Numbers<Real: Real>>(number: f64) -> L {
    L::repeat(L::Real::from_f64(number))
}

/// ζ²/(1 − y²) and 1 − y², by the sum that does not cancel.
#[inline(always)]
fn opened<L: Numbers<Real: Real>>(
    [zeta_sq, y_sq]: [L; 2],
    [from, to]: [&Corner<L>; 2],
    inv_sum: L,
) -> (L, L) {
    let dot = from.u[0] * to.u[0] + from.u[1] * to.u[1];
    let is_ahead = L::splat(0.0).at_most(dot);
    let both = (from.q * to.q + dot.abs()) * (inv_sum * inv_sum);
    let twice = both + both;
    let inv = L::splat(1.0) / L::select(is_ahead, twice, twice * y_sq);
    let open = L::select(is_ahead, zeta_sq, both * both) * inv;
    let turned = y_sq + y_sq;
    let gap = L::select(is_ahead, twice, zeta_sq * (turned * turned) * inv);
    (open, gap + L::repeat(L::Real::MIN_POSITIVE))
}

/// Reduced friction of a patch with this area.
#[inline]
pub(super) fn friction<R: Real>(edges: &[Edge<R>], area: R, motion: &Motion<R>) -> Reduced<R> {
    let (motion, _) = UnitMotion::of(motion);
    let sums = summed::<R, <R as Laned>::Some, 3>(edges, &motion, |edge| edge.wrench());
    reduced(sums, &motion, R::ONE / area)
}

/// Sums over the edges, four of which are formed side by side.
#[inline(always)]
pub(super) fn summed<R: Real, L: Numbers<Real = R>, const N: usize>(
    edges: &[Edge<R>],
    motion: &UnitMotion<R>,
    of: impl Fn(&MovingEdge<L>) -> [L; N],
) -> [R; N] {
    let motion = motion.repeat();
    let mut sums = [L::none(); N];
    for four in edges.chunks(FOUR) {
        for (first, group) in four.chunks(L::COUNT).enumerate() {
            let parts = of(&MovingEdge::new(&motion, Sides::of(group)));
            for (sum, part) in sums.iter_mut().zip(parts) {
                part.add_to(sum, first);
            }
        }
    }
    let mut totals = [R::ZERO; N];
    for (total, sum) in totals.iter_mut().zip(&sums) {
        *total = L::total(sum);
    }
    totals
}

/// Friction of the sums of [`MovingEdge::wrench`].
#[inline(always)]
fn reduced<R: Real>([x, y, turn]: [R; 3], motion: &UnitMotion<R>, share: R) -> Reduced<R> {
    let w = motion.spin;
    let by = w * share;
    let third = R::from_f64(1.0 / 3.0);
    Reduced {
        force: Vector2::new(-(motion.x + by * x), -(motion.y + by * y)),
        torque: -(third * w * (R::TWO + share * turn)),
    }
}

/// The same, and second derivatives of the dissipated power.
pub(super) fn friction_and_hessian<R: Real>(
    edges: &[Edge<R>],
    area: R,
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let (motion, rate) = UnitMotion::of(motion);
    let [fx, fy, turn, xx, xy, yy, xn, yn, nn] =
        summed::<R, <R as Laned>::Some, 9>(edges, &motion, |edge| {
            let ([a, b, c], [d, e, f, g, h, i]) = (edge.wrench(), edge.hessian());
            [a, b, c, d, e, f, g, h, i]
        });
    let share = R::ONE / area;
    let (x, y, w) = (motion.x, motion.y, motion.spin);
    let hessian = Hessian {
        xx: share * xx,
        xy: share * xy,
        yy: share * yy,
        xn: share * xn - w * x,
        yn: share * yn - w * y,
        nn: share * nn + (x * x + y * y),
    };
    let hessian = hessian.across([x, y, w]).scaled(rate);
    (reduced([fx, fy, turn], &motion, share), hessian)
}

impl<R: Real> Hessian<R> {
    /// The part across a twist of length 1, along which dry friction does not change.
    fn across(&self, [x, y, n]: [R; 3]) -> Self {
        let to_x = self.xx * x + self.xy * y + self.xn * n;
        let to_y = self.xy * x + self.yy * y + self.yn * n;
        let to_n = self.xn * x + self.yn * y + self.nn * n;
        let half = R::HALF * (to_x * x + to_y * y + to_n * n);
        let (to_x, to_y, to_n) = (to_x - half * x, to_y - half * y, to_n - half * n);
        Self {
            xx: self.xx - (to_x * x + to_x * x),
            xy: self.xy - (to_x * y + to_y * x),
            yy: self.yy - (to_y * y + to_y * y),
            xn: self.xn - (to_x * n + to_n * x),
            yn: self.yn - (to_y * n + to_n * y),
            nn: self.nn - (to_n * n + to_n * n),
        }
    }
}

impl<L: Numbers<Real: Real>> MovingEdge<L> {
    /// τ β and H β − 2 (v·τ) β″
    #[inline(always)]
    fn wrench(&self) -> [L; 3] {
        let (beta, [x, y]) = (self.beta(), self.sides.tangent);
        let rest = self.along * self.beta_rest();
        [x * beta, y * beta, self.sides.offset * beta - (rest + rest)]
    }

    /// What the edge contributes to the second derivatives xx, xy, yy, xn, yn and nn, of the area.
    #[inline(always)]
    fn hessian(&self) -> [L; 6] {
        let Self {
            spin: w,
            along,
            eta,
            p,
            arm,
            reach_sq,
            log,
            ..
        } = *self;
        let Sides {
            tangent: [x, y],
            length,
            offset,
            ..
        } = self.sides;
        let (half, twice) = (L::splat(0.5), self.inv_sum + self.inv_sum);
        // κ̄ S/2
        let kappa = arm * arm - p + w * arm * p;
        // Velocities.
        let lambda = twice * (kappa + reach_sq * log);
        let lengthwise = length * (offset - eta * arm + w * eta * lambda);
        let rise = length * twice * (self.across * (arm + w * p) + self.sides.middle());
        let xx = lengthwise * x * x - rise * x * y;
        let xy = lengthwise * x * y - half * rise * (y * y - x * x);
        let yy = lengthwise * y * y + rise * x * y;
        // Velocities and spin: ε.
        let mixed = length * twice * (reach_sq * log * eta * along - (p + w * w * kappa));
        // Spin: χ.
        let left = splat::<L>(2.0 / 3.0) * offset - along * self.spread;
        let turned = left + L::splat(2.0) * w * reach_sq * self.bend * eta;
        let chi = arm * p - self.rest - w * twice * kappa * (L::splat(1.0) + p)
            + reach_sq * self.inv_sum * along * turned;
        [
            xx,
            xy,
            yy,
            -(mixed * x),
            -(mixed * y),
            along * (length * chi),
        ]
    }
}
