//! Edges of a patch under a motion, four side by side.
//!
//! Lengths are in radii and the motion (v, w) of the origin has |v|² + w² = 1. An element at x has the speed q;
//! with α = v·(z × x), e = x² − 1 and m = (2 α + w e)/(q + 1),
//!
//! ```text
//! q² = 1 + 2 w α + w² e,        q = 1 + w α + w² p,        p = (e − α m)/(q + 1)
//! p = ((v·x)² − 1)/2 + w p″,    p″ = w x²/2 − p (α + w p/2),    p‴ = (x² − p²)/2 − α p″
//! ```
//!
//! The first part of p is that of w = 0, the line integral of which times v·τ is that of an exact differential.
//! An edge of length l with tangent τ, outward normal n and H = x·n has the velocity η = v·τ + w H along itself
//! and the speeds q₀ and q₁ at its ends; with means p̄ of both ends, σ = ᾱ + w p̄, S = q₀ + q₁ = 2 + 2 w σ, y = w l/S and
//! ζ = η/S = ζ₀ + w ζ₁, in which ζ₀ = v·τ/2 and ζ₁ = H/2 − ζ σ,
//!
//! ```text
//! G(y²) = ((artanh y/y − 1)/y² − 1/3)/y² = Σ y²ⁿ/(2 n + 5),      g = 1/3 + y² G,      b = ζ²/(1 − y²)
//! β = ∫p dl = l [p̄ − (l²/S) (b − ζ² g)]
//! β″ = ∫p″ dl = l [p̄″ − (l²/S) (2/3 (ζ₁ (ζ + ζ₀) − ζ₀² σ) + w (l/S)² (b − ζ² G))]
//! ```
//!
//! Nothing cancels, nothing is divided by a speed or a spin, and all terms are bounded: (1 − y²) S² is
//! 2 (q₀ q₁ + u₀·u₁) with the velocities u of the ends or, where these are opposed, 2 (η w l)²/(q₀ q₁ − u₀·u₁).

use super::motion::Motion;
use crate::lanes::Summed;
use crate::patch::outline::Edge;
use crate::real::Real;
use crate::special::log_part;
use nalgebra::Vector2;

/// Functions P and Q of z = 1 − y² with G = P + Q ln z, fitted together (`generate_polygons.py fit` of the
/// tests' tables): G to 9e-17 over (y² + 0.03)(√z + 0.001) for z > 1e-6; an edge's terms vanish as √z below.
pub const BEND: [[f64; 2]; 12] = [
    [-0.640_186_152_773_286_2, -0.499_999_999_999_991_6],
    [-0.850_465_380_724_866_5, -1.249_999_999_850_792_7],
    [-1.019_563_395_878_982_7, -2.187_499_832_449_630_4],
    [-1.164_590_911_452_24, -3.281_213_547_399_995_7],
    [-1.285_295_944_233_070_7, -4.509_353_780_325_758],
    [-1.254_356_415_937_781_6, -5.807_985_534_896_961],
    [-0.367_953_988_603_442_8, -6.739_369_366_662_877],
    [1.963_064_951_581_770_9, -6.013_823_535_200_807],
    [3.151_395_337_692_600_5, -3.196_885_026_539_811],
    [1.486_713_005_272_929, -0.750_477_417_385_062_4],
    [0.179_937_335_275_320_7, -0.048_919_327_478_106_24],
    [0.001_301_559_781_050_569, 0.0],
];
/// The same to 3.3e-8 (`fit 6`).
pub const BEND_SINGLE: [[f32; 2]; 6] = [
    [-0.640_171_5, -0.499_998_4],
    [-0.841_706_9, -1.248_345],
    [-0.670_224_1, -2.078_882_7],
    [0.970_850_6, -2.041_481_5],
    [1.318_973_9, -0.591_809_65],
    [0.062_278_574, 0.0],
];

/// G, given 1 − y².
#[inline(always)]
fn bend<R: Real, L: Summed<Real = R>>(gap: L) -> L {
    let [smooth, of_log] = L::sums(&BEND_SINGLE, &BEND, gap);
    smooth + log_part(gap, gap.octaves(), L::repeat) * of_log
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

    /// The same where the square leaves the range of numbers.
    #[cold]
    fn of_any(velocity: &Vector2<R>, spin: R) -> (Self, R) {
        let size = velocity.x.hypot(velocity.y).hypot(spin);
        let (x, y) = (velocity.x / size, velocity.y / size);
        let spin = spin / size;
        (Self { x, y, spin }, R::ONE / size)
    }

    /// In every lane.
    #[inline(always)]
    pub(super) fn repeated<L: Summed<Real = R>>(&self) -> UnitMotion<L> {
        UnitMotion {
            x: L::repeat(self.x),
            y: L::repeat(self.y),
            spin: L::repeat(self.spin),
        }
    }
}

/// Speed of a corner at rest, in rounding errors: the speed along its edges is not known better.
const LEAST_SPEED: f64 = 0.25;

/// A corner.
#[derive(Clone, Copy)]
pub(super) struct Corner<L> {
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

impl<L: Summed<Real: Real>> Corner<L> {
    #[inline(always)]
    pub(super) fn new(motion: &UnitMotion<L>, [x, y]: [L; 2]) -> Self {
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

impl<L: Summed<Real: Real>> Sides<L> {
    /// Edges without length where there are no more.
    #[inline(always)]
    pub(super) fn of(edges: &[Edge<L::Real>]) -> Self {
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
    /// Means of p, α, p″ and p‴ at the ends.
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
    /// σ
    pub(super) sigma: L,
    /// ζ
    pub(super) zeta: L,
    /// ζ²
    pub(super) zeta_sq: L,
    /// ζ²/(1 − y²)
    pub(super) open: L,
    /// G
    pub(super) bend: L,
    /// g
    pub(super) log: L,
}

impl<L: Summed<Real: Real>> MovingEdge<L> {
    #[inline(always)]
    pub(super) fn new(
        motion: &UnitMotion<L>,
        sides: Sides<L>,
        [from, to]: [&Corner<L>; 2],
    ) -> Self {
        let (w, half) = (motion.spin, L::splat(0.5));
        let along = motion.x * sides.tangent[0] + motion.y * sides.tangent[1];
        let eta = along + w * sides.offset;
        let sum = from.q + to.q;
        let inv_sum = L::splat(1.0) / sum;
        let reach = sides.length * inv_sum;
        let zeta = eta * inv_sum;
        let (reach_sq, zeta_sq) = (reach * reach, zeta * zeta);
        let y_sq = w * w * reach_sq;
        let (open, gap) = opened([zeta_sq, y_sq], [from, to], inv_sum);
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
            sigma: arm + w * p,
            zeta,
            zeta_sq,
            open,
            bend,
            log: splat::<L>(1.0 / 3.0) + y_sq * bend,
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
    pub(super) fn beta_rest(&self) -> L {
        let half = L::splat(0.5);
        let zeta_0 = half * self.along;
        let zeta_1 = half * self.sides.offset - self.zeta * self.sigma;
        let once = zeta_1 * (self.zeta + zeta_0) - zeta_0 * zeta_0 * self.sigma;
        let closed = self.open - self.zeta_sq * self.bend;
        let bent = splat::<L>(2.0 / 3.0) * once + self.spin * self.reach_sq * closed;
        self.sides.length * (self.rest - self.sides.length * self.reach * bent)
    }
}

/// A number in every lane.
#[inline(always)]
pub(super) fn splat<L: Summed<Real: Real>>(number: f64) -> L {
    L::repeat(L::Real::from_f64(number))
}

/// ζ²/(1 − y²) and 1 − y², by the sum that does not cancel.
#[inline(always)]
fn opened<L: Summed<Real: Real>>(
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
