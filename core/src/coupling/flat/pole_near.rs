//! An edge seen from a centre of rotation that is on the patch or not far away.
//!
//! With the centre c, ρ = x − c and r = |ρ|, an edge with tangent τ and outward normal n lies h = ρ·n away from
//! c and reaches from t₀ to t₁ = t₀ + l, at the distances r₀ and r₁:
//!
//! ```text
//! L = ∫dt/r = ln((r₀ + r₁ + l)/(r₀ + r₁ − l))
//! I = ∫r dt = l/4 [r₀ + r₁ + (t₀ + t₁)²/(r₀ + r₁)] + h² L/2
//! ```
//!
//! No term of I cancels another one. r₀ + r₁ − l is the sum of r + t at the first corner and r − t at
//! the second one, of which the one that cancels is h²/(r + |t|). Where h = 0 only h L occurs, which
//! is 0.

use crate::patch::outline::Edge;
use crate::real::Real;
use crate::special::log_quotient;
use nalgebra::Vector2;

/// One edge seen from the centre of rotation.
pub(super) struct EdgeFromPole<R> {
    /// Distance of the edge's line, positive where the patch lies on this side of it.
    pub(super) h: R,
    pub(super) t0: R,
    pub(super) t1: R,
    pub(super) r0: R,
    pub(super) r1: R,
    /// r₁ − r₀
    pub(super) rise: R,
    /// L, or a large number where it is infinite.
    pub(super) log: R,
    /// I
    pub(super) integral: R,
}

impl<R: Real> EdgeFromPole<R> {
    #[inline(always)]
    pub(super) fn new(edge: &Edge<R>, centre: &Vector2<R>) -> Self {
        let (tangent, normal, length) = (edge.tangent(), edge.normal(), edge.length());
        let h = edge.offset() - (centre.x * normal.x + centre.y * normal.y);
        let t0 = edge.along() - (centre.x * tangent.x + centre.y * tangent.y);
        let t1 = t0 + length;
        let h_sq = h * h;
        let ends = [t0, t1].map(|t| (h_sq + t * t).sqrt());
        Self::between(h, [t0, t1], ends, length)
    }

    /// An edge at the distance `h` from `t0` to `t1`, whose ends are as far away as `ends` says.
    #[inline(always)]
    pub(super) fn between(h: R, [t0, t1]: [R; 2], ends: [R; 2], length: R) -> Self {
        let (h_sq, [r0, r1]) = (h * h, ends);
        let (sum, middle) = (r0 + r1, t0 + t1);
        // r + t at the first corner and r − t at the second one without cancellation, as quotients.
        let (a0, a1) = (r0 + t0.abs(), r1 + t1.abs());
        let (n0, d0) = if t0 > R::ZERO {
            (a0, R::ONE)
        } else {
            (h_sq, a0)
        };
        let (n1, d1) = if t1 < R::ZERO {
            (a1, R::ONE)
        } else {
            (h_sq, a1)
        };
        let gap = n0 * d1 + n1 * d0 + R::MIN_POSITIVE * R::from_f64(LEAST_GAP);
        let log = log_quotient(R::TWO * length * (d0 * d1), gap);
        let mean = middle / sum;
        let quarter = R::HALF * R::HALF;
        Self {
            h,
            t0,
            t1,
            r0,
            r1,
            rise: length * mean,
            log,
            integral: quarter * length * (sum + middle * mean) + R::HALF * h_sq * log,
        }
    }
}

/// Smallest gap, where the centre lies on the edge, in smallest normal numbers.
const LEAST_GAP: f64 = 8.0;
