//! Evenly spaced points on a ring.

/// Number of points of the rule, a power of two.
pub(crate) const POINTS: usize = 256;

/// (cos, sin) of the points at (k + ½) 2π/[`POINTS`], computed with square roots and products only, so
/// that the bits are the same on every platform.
pub(super) fn points() -> Vec<[f64; 2]> {
    // Start with half a turn; each rotation by half the angle doubles the number of points.
    let mut points = vec![[1.0, 0.0]];
    let mut turn: [f64; 2] = [-1.0, 0.0];
    while points.len() < POINTS {
        let more: Vec<_> = points.iter().map(|&p| product(p, turn)).collect();
        points.extend(more);
        turn = half(turn);
    }
    // The last half angle is half the spacing.
    points.iter().map(|&p| product(p, turn)).collect()
}

/// The angle of `a` plus that of `b`.
fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// Half the angle of a unit vector in the upper half plane.
fn half([cos, _]: [f64; 2]) -> [f64; 2] {
    [(0.5 * (1.0 + cos)).sqrt(), (0.5 * (1.0 - cos)).sqrt()]
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests {
    use super::*;

    #[test]
    fn points_stand_evenly_on_the_circle() {
        let points = points();
        let mut angles: Vec<f64> = points.iter().map(|p| p[1].atan2(p[0])).collect();
        angles.sort_by(f64::total_cmp);
        let spacing = std::f64::consts::TAU / POINTS as f64;
        for (k, angle) in angles.iter().enumerate() {
            let expected = spacing * (k as f64 + 0.5) - std::f64::consts::PI;
            assert!((angle - expected).abs() < 1e-14, "{k}");
        }
        for [cos, sin] in points {
            assert!((cos * cos + sin * sin - 1.0).abs() < 1e-14);
        }
    }
}
