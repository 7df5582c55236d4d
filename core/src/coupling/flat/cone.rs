//! A triangle under linear pressure, about a centre of rotation that lies on it or near it.
//!
//! The triangle is the sum of the cones from the centre of rotation over its edges, each with the sign
//! of its side. Along a ray of such a cone the pressure goes from k₀, that at the centre of rotation, to
//! k(t) on the edge, which is linear in t, so that the integral along the ray is known:
//!
//! ```text
//! ∫k ρ/r dA = Σ h ∫(k₀/6 + k/3) ρ/r dt,     ∫k r dA = Σ h ∫(k₀/12 + k/4) r dt,
//! ∫k ρρ/r³ dA = Σ h ∫(k₀ + k)/2 ρρ/r³ dt,     ρ = h n + t τ
//! ```
//!
//! with the notation of [`super::pole_near`]; all integrals over t follow from L, I and the ends.

use super::pole_near::EdgeFromPole;
use crate::patch::mesh::Triangle;
use crate::real::Real;
use nalgebra::Vector2;

/// ∫k ρ/r, ∫k r and, if asked for, ∫k ρρ/r³ over a triangle.
#[inline]
pub(super) fn about_centre<R: Real, const WITH_HESSIAN: bool>(
    triangle: &Triangle<R>,
    centre: &Vector2<R>,
) -> [R; 6] {
    let (start, [second, third]) = (triangle.corner() - centre, triangle.sides());
    let [p, q, r] = triangle.pressures();
    let [a, b, c] = [(start, p), (start + second, q), (start + third, r)]
        .map(|(from, k)| (from, k, (from.x * from.x + from.y * from.y).sqrt()));
    let [slope_x, slope_y] = triangle.slope();
    let here = p - slope_x * start.x - slope_y * start.y;
    let mut sums = [R::ZERO; 6];
    for ((tangent, length, inv_length), ends) in
        triangle
            .directions()
            .into_iter()
            .zip([(a, b), (b, c), (c, a)])
    {
        let ((from, k0, r0), (to, k1, r1)) = ends;
        // From the nearer end, of which more digits are known.
        let across = |end: Vector2<R>| end.x * tangent.y - end.y * tangent.x;
        let along = |end: Vector2<R>| end.x * tangent.x + end.y * tangent.y;
        let is_first = r0 < r1;
        let nearer = |first: R, second: R| if is_first { first } else { second };
        let h = nearer(across(from), across(to));
        let (t0, t1) = (along(from), along(to));
        let span = [nearer(t0, t1 - length), nearer(t0 + length, t1)];
        let seen = EdgeFromPole::between(h, span, [r0, r1], length);
        // The pressure on the edge, base + rate · t.
        let rate = (k1 - k0) * inv_length;
        let base = nearer(k0 - rate * t0, k1 - rate * t1);
        let parts = over_edge::<R, WITH_HESSIAN>(&seen, &tangent, [here, base, rate]);
        for (sum, part) in sums.iter_mut().zip(parts) {
            *sum += part;
        }
    }
    sums
}

/// The share of one cone.
#[inline(always)]
fn over_edge<R: Real, const WITH_HESSIAN: bool>(
    seen: &EdgeFromPole<R>,
    tangent: &Vector2<R>,
    [here, base, rate]: [R; 3],
) -> [R; 6] {
    let third = R::from_f64(1.0 / 3.0);
    let (h, log, rise) = (seen.h, seen.log, seen.rise);
    let h_log = h * log;
    // ∫(k₀/6 + k/3) dt/r, times h, and the same with t; no part of it is infinite where h = 0.
    let even = third * (R::HALF * here + base);
    let odd = third * rate;
    let over_r = even * h_log + odd * (h * rise);
    let over_r_t = even * rise + odd * (seen.integral - h * h_log);
    let (out, on) = (h * over_r, h * over_r_t);
    let (x, y) = (tangent.x, tangent.y);
    let pull = [out * y + on * x, on * y - out * x];
    // ∫(k₀/12 + k/4) r dt
    let quarter = R::HALF * R::HALF;
    let moment = third * rise * (seen.r1 * seen.r1 + seen.r1 * seen.r0 + seen.r0 * seen.r0);
    let turn = h * quarter * ((third * here + base) * seen.integral + rate * moment);
    if !WITH_HESSIAN {
        return [pull[0], pull[1], turn, R::ZERO, R::ZERO, R::ZERO];
    }
    let (even, odd) = (R::HALF * (here + base), R::HALF * rate);
    // No corner's r is below |h| but by rounding.
    let inverse = |r: R| R::ONE / (r + R::MIN_POSITIVE);
    let (i0, i1) = (inverse(seen.r0), inverse(seen.r1));
    let h_turn = h * (seen.t1 * i1 - seen.t0 * i0);
    let fall = (h * i1) * h - (h * i0) * h;
    let left = h_log - h_turn;
    let nn = even * h_turn - odd * (h * fall);
    let nt = odd * (h * left) - even * fall;
    let tt = even * left + odd * (h * (rise + fall));
    let (nx, ny) = (y, -x);
    [
        pull[0],
        pull[1],
        turn,
        nx * nx * nn + R::TWO * nx * x * nt + x * x * tt,
        nx * ny * nn + (nx * y + ny * x) * nt + x * y * tt,
        ny * ny * nn + R::TWO * ny * y * nt + y * y * tt,
    ]
}
