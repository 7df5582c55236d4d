//! The contact area that a manifold stands for, from its corners.

use super::outline::DirectionalLimitCurve;
use crate::real::Real;

/// A contact area under uniform pressure: friction centre, lever and limit curves.
///
/// Computed once when a manifold is made, from the clip polygon before it is reduced to a few points, or from
/// those points.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ManifoldArea<R> {
    /// Centre of the area, in m.
    pub centre: [R; 2],
    /// r̄, the mean distance of the area from its centre: largest torque over largest force, in m.
    pub torsion_radius: R,
    /// Limit curves of the area about its centre.
    pub outline: DirectionalLimitCurve<R>,
}

/// A polygon whose area is less than this fraction of its length squared is a line.
const LINE: f64 = 1e-4;
/// 1 + c₀ of a line along itself. The exact one falls with the logarithm of its length over its width: 0.66 at 10.
const LINE_ALONG: f64 = 0.6;
/// Steps that halve the argument of the inverse hyperbolic tangent, and coefficients of its series.
const HALVINGS: usize = 4;
const SERIES: [f64; 4] = [1.0 / 9.0, 1.0 / 7.0, 1.0 / 5.0, 1.0 / 3.0];

impl<R: Real> ManifoldArea<R> {
    /// The area bounded by these corners, clockwise or counterclockwise, in m.
    ///
    /// Two corners, or a polygon without area, are a line; one corner and none have no lever, their friction no
    /// torque.
    ///
    /// *Domain*: finite coordinates, edges that do not cross; else components may be NaN.
    ///
    /// *Accuracy*: moments 1e-5 in f32, 5e-5 where the width is 1 % of the length. Below 3e-10 m moments of areas
    /// leave the range of f32: components may be 0 or NaN.
    pub fn of_corners(corners: &[[R; 2]]) -> Self {
        let (farthest, ends) = longest(corners);
        let (area, centre) = area_and_centre(corners);
        if area.abs() <= R::from_f64(LINE) * farthest * farthest {
            return Self::of_line(ends);
        }
        let mut moments = Moments::default();
        for (from, to) in edges(corners) {
            moments.add(minus(from, centre), minus(to, centre));
        }
        moments.area(area, centre)
    }

    fn of_line([from, to]: [[R; 2]; 2]) -> Self {
        let [x, y] = minus(to, from);
        let length = (x * x + y * y).sqrt();
        let [x, y] = if length > R::ZERO {
            [x / length, y / length]
        } else {
            [R::ONE, R::ZERO]
        };
        let along = |along: R, across: R| {
            [
                along * x * x + across * y * y,
                (along - across) * x * y,
                along * y * y + across * x * x,
            ]
        };
        Self {
            centre: [R::HALF * (from[0] + to[0]), R::HALF * (from[1] + to[1])],
            torsion_radius: R::HALF * R::HALF * length,
            outline: DirectionalLimitCurve {
                spinning: along(R::from_f64(LINE_ALONG), R::TWO),
                slipping: along(R::from_f64(4.0 / 3.0), R::ZERO),
            },
        }
    }
}

/// Integrals over triangles between the origin and an edge.
struct Moments<R> {
    /// ∫ r dA.
    distance: R,
    /// ∫ r r dA: xx, xy, yy.
    inertia: [R; 3],
    /// ∫ r r/r³ dA.
    spinning: [R; 3],
}

impl<R: Real> Default for Moments<R> {
    fn default() -> Self {
        let (distance, inertia, spinning) = (R::ZERO, [R::ZERO; 3], [R::ZERO; 3]);
        Self {
            distance,
            inertia,
            spinning,
        }
    }
}

impl<R: Real> Moments<R> {
    /// Adds the triangle between the origin, `a` and `b`.
    ///
    /// With the foot of the edge's line at the distance h and t along it, L = ∫dt/r, [·] the difference of the ends:
    /// ∫r dA = h/3 ∫r dt and ∫r r/r³ dA = h [t/r] nn − h² [1/r] (nt + tn) + h (L − [t/r]) tt.
    fn add(&mut self, a: [R; 2], b: [R; 2]) {
        let [side_x, side_y] = minus(b, a);
        let length = (side_x * side_x + side_y * side_y).sqrt();
        if length == R::ZERO {
            return;
        }
        let [x, y] = [side_x / length, side_y / length];
        let h = a[0] * y - a[1] * x;
        let (t0, t1) = (a[0] * x + a[1] * y, b[0] * x + b[1] * y);
        let tiny = R::MIN_POSITIVE;
        let (r0, r1) = ((h * h + t0 * t0).sqrt(), (h * h + t1 * t1).sqrt());
        let (r0, r1) = (
            if r0 > tiny { r0 } else { tiny },
            if r1 > tiny { r1 } else { tiny },
        );
        let (ends, mean) = (r0 + r1, t0 + t1);
        let log = twice_atanh(length / ends);
        let quarter = R::HALF * R::HALF;
        let line = quarter * length * (ends + mean * mean / ends) + R::HALF * h * h * log;
        self.distance += h * line / R::from_f64(3.0);
        let sines = t1 / r1 - t0 / r0;
        let (normal, mixed, along) = (h * sines, h * (h / r0 - h / r1), h * (log - sines));
        // n = (y, −x), t = (x, y).
        self.spinning[0] += normal * y * y + R::TWO * mixed * x * y + along * x * x;
        self.spinning[1] += (along - normal) * x * y + mixed * (y * y - x * x);
        self.spinning[2] += normal * x * x - R::TWO * mixed * x * y + along * y * y;
        let twelfth = (a[0] * b[1] - a[1] * b[0]) / R::from_f64(12.0);
        let product = |i: usize, j: usize| {
            let [(p, q), (u, v)] = [(a[i], a[j]), (b[i], b[j])];
            twelfth * (p * q + u * v + R::HALF * (p * v + u * q))
        };
        for (sum, part) in
            self.inertia
                .iter_mut()
                .zip([product(0, 0), product(0, 1), product(1, 1)])
        {
            *sum += part;
        }
    }

    fn area(&self, area: R, centre: [R; 2]) -> ManifoldArea<R> {
        let torsion_radius = self.distance / area;
        let lever_sq = torsion_radius * torsion_radius;
        let [xx, xy, yy] = self.spinning.map(|moment| moment / area);
        let scale = R::ONE / ((xx * yy - xy * xy) * torsion_radius);
        ManifoldArea {
            centre,
            torsion_radius,
            outline: DirectionalLimitCurve {
                spinning: [yy * scale, -xy * scale, xx * scale],
                slipping: self.inertia.map(|moment| moment / area / lever_sq),
            },
        }
    }
}

/// 2 artanh z by halving the result: no logarithm, the same bits in every language. *Domain*: 0 ≤ z ≤ 1.
///
/// *Accuracy*: 1e-7 for z < 0.999; finite at 1.
fn twice_atanh<R: Real>(z: R) -> R {
    let (mut z, mut factor) = (if z < R::ONE { z } else { R::ONE }, R::TWO);
    for _ in 0..HALVINGS {
        z /= R::ONE + ((R::ONE - z) * (R::ONE + z)).sqrt();
        factor *= R::TWO;
    }
    let z_sq = z * z;
    let mut sum = R::ZERO;
    for coefficient in SERIES {
        sum = (sum + R::from_f64(coefficient)) * z_sq;
    }
    factor * z * (R::ONE + sum)
}

/// Signed area and centre of area.
fn area_and_centre<R: Real>(corners: &[[R; 2]]) -> (R, [R; 2]) {
    let Some(&origin) = corners.first() else {
        return (R::ZERO, [R::ZERO; 2]);
    };
    let (mut twice, mut x, mut y) = (R::ZERO, R::ZERO, R::ZERO);
    for (from, to) in edges(corners) {
        let (a, b) = (minus(from, origin), minus(to, origin));
        let cross = a[0] * b[1] - a[1] * b[0];
        twice += cross;
        x += cross * (a[0] + b[0]);
        y += cross * (a[1] + b[1]);
    }
    let third = R::from_f64(3.0) * twice;
    (
        R::HALF * twice,
        [origin[0] + x / third, origin[1] + y / third],
    )
}

/// The largest distance of two corners, and these two.
fn longest<R: Real>(corners: &[[R; 2]]) -> (R, [[R; 2]; 2]) {
    let first = corners.first().copied().unwrap_or([R::ZERO; 2]);
    let (mut most_sq, mut ends) = (R::ZERO, [first; 2]);
    for (index, &from) in corners.iter().enumerate() {
        for &to in corners.iter().skip(index + 1) {
            let [x, y] = minus(to, from);
            let distance_sq = x * x + y * y;
            if distance_sq > most_sq {
                (most_sq, ends) = (distance_sq, [from, to]);
            }
        }
    }
    (most_sq.sqrt(), ends)
}

fn edges<R: Copy>(corners: &[[R; 2]]) -> impl Iterator<Item = ([R; 2], [R; 2])> {
    corners
        .iter()
        .copied()
        .zip(corners.iter().copied().cycle().skip(1))
}

fn minus<R: Real>([x, y]: [R; 2], [u, v]: [R; 2]) -> [R; 2] {
    [x - u, y - v]
}
