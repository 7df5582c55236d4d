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
use crate::patch::outline::Edge;
use crate::real::{InEach, Real};
use crate::special::log_quotient;
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

/// P and Q.
struct Bend;

impl InEach for Bend {
    type Input<R: Real> = R;
    type Output<R: Real> = [R; 2];
    #[inline(always)]
    fn single(gap: f32) -> [f32; 2] {
        crate::lanes::Laned::sums(&BEND_SINGLE, gap)
    }
    #[inline(always)]
    fn double(gap: f64) -> [f64; 2] {
        crate::lanes::Laned::sums(&BEND, gap)
    }
}

/// A motion with |velocity|² + rim² = 1.
#[derive(Clone, Copy)]
pub(super) struct UnitMotion<R> {
    pub(super) x: R,
    pub(super) y: R,
    pub(super) spin: R,
    /// 1 over the speed that is its unit.
    pub(super) rate: R,
}

impl<R: Real> UnitMotion<R> {
    #[inline(always)]
    pub(super) fn of(motion: &Motion<R>) -> Self {
        let (velocity, spin) = (&motion.velocity, motion.rim);
        let sq = velocity.x * velocity.x + velocity.y * velocity.y + spin * spin;
        if sq > R::MIN_POSITIVE / R::EPSILON && sq < R::INFINITY {
            let rate = R::ONE / sq.sqrt();
            return Self {
                x: velocity.x * rate,
                y: velocity.y * rate,
                spin: spin * rate,
                rate,
            };
        }
        Self::of_any(velocity, spin)
    }

    /// Of a motion whose square may leave the range of numbers.
    #[cold]
    fn of_any(velocity: &Vector2<R>, spin: R) -> Self {
        let size = velocity.x.hypot(velocity.y).hypot(spin);
        Self {
            x: velocity.x / size,
            y: velocity.y / size,
            spin: spin / size,
            rate: R::ONE / size,
        }
    }
}

/// Speed of a corner at rest, in rounding errors: the speed along its edges is not known better.
const LEAST_SPEED: f64 = 0.25;

/// A corner.
#[derive(Clone, Copy)]
pub(super) struct Corner<R> {
    /// Its velocity.
    u: [R; 2],
    /// |u|
    q: R,
    /// α
    pub(super) arm: R,
    /// p
    pub(super) p: R,
    /// p″
    pub(super) rest: R,
}

impl<R: Real> Corner<R> {
    #[inline(always)]
    pub(super) fn new(motion: &UnitMotion<R>, place: &Vector2<R>) -> Self {
        let (v_x, v_y, w) = (motion.x, motion.y, motion.spin);
        let (x, y) = (place.x, place.y);
        let u = [v_x - w * y, v_y + w * x];
        let rest = R::from_f64(LEAST_SPEED) * R::EPSILON;
        let q = (u[0] * u[0] + u[1] * u[1] + rest * rest).sqrt();
        let arm = v_y * x - v_x * y;
        let sq = x * x + y * y;
        let from_rim = sq - R::ONE;
        let inv = R::ONE / (q + R::ONE);
        let p = (from_rim - arm * ((arm + arm + w * from_rim) * inv)) * inv;
        let half = R::HALF * w;
        let rest = half * sq - p * (arm + half * p);
        Self { u, q, arm, p, rest }
    }
}

/// An edge under a motion.
#[derive(Clone, Copy)]
pub(super) struct MovingEdge<R> {
    pub(super) length: R,
    pub(super) tangent: Vector2<R>,
    /// H
    pub(super) offset: R,
    /// w
    pub(super) spin: R,
    /// v·τ
    pub(super) along: R,
    /// v·n
    pub(super) across: R,
    /// Middle · tangent.
    pub(super) middle: R,
    /// Means of p, α and p″ at the ends.
    pub(super) p: R,
    pub(super) arm: R,
    pub(super) rest: R,
    /// S
    pub(super) sum: R,
    /// l/S, ζ, y²
    pub(super) reach: R,
    pub(super) zeta: R,
    pub(super) y_sq: R,
    /// C
    pub(super) open: R,
    /// G
    pub(super) bend: R,
    /// 1/S
    pub(super) inv_sum: R,
}

impl<R: Real> MovingEdge<R> {
    #[inline(always)]
    pub(super) fn new(motion: &UnitMotion<R>, edge: &Edge<R>, [from, to]: [&Corner<R>; 2]) -> Self {
        let (tangent, length, offset) = (edge.tangent(), edge.length(), edge.offset());
        let (normal, w) = (edge.normal(), motion.spin);
        let (start, end) = (edge.start(), edge.end());
        let along = motion.x * tangent.x + motion.y * tangent.y;
        let sum = from.q + to.q;
        let inv_sum = R::ONE / sum;
        let reach = length * inv_sum;
        let zeta = (along + w * offset) * inv_sum;
        let zeta_sq = zeta * zeta;
        let y = w * reach;
        let y_sq = y * y;
        // ζ²/(1 − y²) and 1 − y² by the sum that does not cancel.
        let dot = from.u[0] * to.u[0] + from.u[1] * to.u[1];
        let is_ahead = dot >= R::ZERO;
        let both = (from.q * to.q + dot.abs()) * inv_sum * inv_sum;
        let twice = both + both;
        let inv = R::ONE / if is_ahead { twice } else { twice * y_sq };
        let part = if is_ahead { zeta_sq } else { both * both };
        let open = part * inv;
        let twice_turned = (zeta * y_sq) + (zeta * y_sq);
        let gap = if is_ahead {
            twice
        } else {
            twice_turned * twice_turned * inv
        };
        let gap = gap + R::MIN_POSITIVE;
        let [bend, of_log] = R::in_own::<Bend>(gap);
        let bend = bend - of_log * log_quotient(y_sq, gap);
        Self {
            length,
            tangent,
            offset,
            spin: w,
            along,
            across: motion.x * normal.x + motion.y * normal.y,
            middle: R::HALF * ((start.x + end.x) * tangent.x + (start.y + end.y) * tangent.y),
            p: R::HALF * (from.p + to.p),
            arm: R::HALF * (from.arm + to.arm),
            rest: R::HALF * (from.rest + to.rest),
            sum,
            reach,
            zeta,
            y_sq,
            open,
            bend,
            inv_sum,
        }
    }

    /// β
    #[inline(always)]
    fn beta(&self) -> R {
        let bent = self.open - self.zeta * self.zeta * self.log();
        self.length * (self.p - self.length * self.reach * bent)
    }

    /// β″
    #[inline(always)]
    fn beta_rest(&self) -> R {
        let eta = self.along + self.spin * self.offset;
        let two_thirds = R::from_f64(2.0 / 3.0);
        let turned =
            two_thirds * self.offset * (eta + self.along) - self.along * self.along * self.spread();
        let closed = self.open - self.zeta * self.zeta * self.bend;
        let bent =
            turned * self.inv_sum * self.inv_sum + self.spin * self.reach * self.reach * closed;
        self.length * (self.rest - self.length * self.reach * bent)
    }

    /// g
    #[inline(always)]
    pub(super) fn log(&self) -> R {
        R::from_f64(1.0 / 3.0) + self.y_sq * self.bend
    }

    /// σ (4 + 2 S + S²)/12
    #[inline(always)]
    fn spread(&self) -> R {
        let sigma = self.arm + self.spin * self.p;
        let sixth = R::from_f64(1.0 / 6.0);
        sixth * sigma * (R::TWO * R::TWO + self.sum * (R::TWO + self.sum))
    }
}

/// Sums over the edges for the wrench.
#[derive(Clone, Copy)]
struct WrenchSums<R> {
    x: R,
    y: R,
    turn: R,
}

/// Reduced friction of a patch with this area.
#[inline]
pub(super) fn friction<R: Real>(edges: &[Edge<R>], area: R, motion: &Motion<R>) -> Reduced<R> {
    let motion = UnitMotion::of(motion);
    let mut sums = WrenchSums {
        x: R::ZERO,
        y: R::ZERO,
        turn: R::ZERO,
    };
    each(edges, &motion, |_, _, edge| sums.add(edge));
    sums.friction(&motion, R::ONE / area)
}

/// Calls `add` with each edge and its corners.
#[inline(always)]
pub(super) fn each<R: Real>(
    edges: &[Edge<R>],
    motion: &UnitMotion<R>,
    mut add: impl FnMut(&Edge<R>, [&Corner<R>; 2], &MovingEdge<R>),
) {
    let mut last: Option<(Vector2<R>, Corner<R>)> = None;
    for edge in edges {
        // The corner that two edges share is computed once.
        let from = match &last {
            Some((place, corner)) if *place == edge.start() => *corner,
            _ => Corner::new(motion, &edge.start()),
        };
        let to = Corner::new(motion, &edge.end());
        let ends = [&from, &to];
        add(edge, ends, &MovingEdge::new(motion, edge, ends));
        last = Some((edge.end(), to));
    }
}

impl<R: Real> WrenchSums<R> {
    #[inline(always)]
    fn add(&mut self, edge: &MovingEdge<R>) {
        let beta = edge.beta();
        self.x += edge.tangent.x * beta;
        self.y += edge.tangent.y * beta;
        self.turn += edge.offset * beta - R::TWO * edge.along * edge.beta_rest();
    }

    #[inline(always)]
    fn friction(&self, motion: &UnitMotion<R>, share: R) -> Reduced<R> {
        let w = motion.spin;
        let by = w * share;
        let third = R::from_f64(1.0 / 3.0);
        Reduced {
            force: Vector2::new(-(motion.x + by * self.x), -(motion.y + by * self.y)),
            torque: -(third * w * (R::TWO + share * self.turn)),
        }
    }
}

/// The same, and second derivatives of the dissipated power.
pub(super) fn friction_and_hessian<R: Real>(
    edges: &[Edge<R>],
    area: R,
    motion: &Motion<R>,
) -> (Reduced<R>, Hessian<R>) {
    let motion = UnitMotion::of(motion);
    let zero = R::ZERO;
    let mut sums = WrenchSums {
        x: zero,
        y: zero,
        turn: zero,
    };
    let mut bent = Hessian {
        xx: zero,
        xy: zero,
        yy: zero,
        xn: zero,
        yn: zero,
        nn: zero,
    };
    each(edges, &motion, |_, _, edge| {
        sums.add(edge);
        edge.add_hessian(&mut bent);
    });
    let share = R::ONE / area;
    let (x, y, w) = (motion.x, motion.y, motion.spin);
    let whole = bent.scaled(share);
    let whole = Hessian {
        xn: whole.xn - w * x,
        yn: whole.yn - w * y,
        nn: whole.nn + (x * x + y * y),
        ..whole
    };
    let hessian = whole.across([x, y, w]).scaled(motion.rate);
    (sums.friction(&motion, share), hessian)
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

impl<R: Real> MovingEdge<R> {
    /// Adds what the edge contributes to the second derivatives, of the area.
    #[inline(always)]
    fn add_hessian(&self, sum: &mut Hessian<R>) {
        let Self {
            length,
            spin: w,
            along,
            offset,
            p,
            arm,
            reach,
            inv_sum,
            ..
        } = *self;
        let (x, y) = (self.tangent.x, self.tangent.y);
        let eta = along + w * offset;
        let reach_sq = reach * reach;
        let log = self.log();
        // κ̄ S/2
        let kappa = arm * arm - p + w * arm * p;
        let twice = inv_sum + inv_sum;
        // Velocities.
        let lambda = twice * (kappa + reach_sq * log);
        let lengthwise = length * (offset - eta * arm + w * eta * lambda);
        let rise = length * twice * (self.across * (arm + w * p) + self.middle);
        sum.xx += lengthwise * x * x - rise * x * y;
        sum.xy += lengthwise * x * y - R::HALF * rise * (y * y - x * x);
        sum.yy += lengthwise * y * y + rise * x * y;
        // Velocities and spin: ε.
        let mixed = length * twice * (reach_sq * log * eta * along - (p + w * w * kappa));
        sum.xn -= mixed * x;
        sum.yn -= mixed * y;
        // Spin: χ.
        let left = R::from_f64(2.0 / 3.0) * offset - along * self.spread();
        let turned = left + R::TWO * w * reach_sq * self.bend * eta;
        let chi = length
            * (arm * p - self.rest - w * twice * kappa * (R::ONE + p)
                + reach_sq * inv_sum * along * turned);
        sum.nn += along * chi;
    }
}
