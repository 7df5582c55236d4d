//! Springs that turn with their contact.

use nalgebra::Vector3;

/// How a contact's plane has turned in a step: its normal from `before` to `after`, and then by the
/// mean spin of the two bodies about it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Transport {
    axis: Vector3<f64>,
    cosine: f64,
    normal: Vector3<f64>,
    /// Cosine and sine of the angle about the normal.
    about: [f64; 2],
}

impl Transport {
    /// The turn between two unit normals, and by an angle about the second.
    #[inline]
    pub fn new(before: &Vector3<f64>, after: &Vector3<f64>, angle: f64) -> Self {
        // Cayley's form of cos and sin: a rotation to the last bit, by the angle to third order.
        let t = 0.5 * angle;
        let t_sq = t * t;
        Self {
            axis: before.cross(after),
            cosine: before.dot(after),
            normal: *after,
            about: [(1.0 - t_sq) / (1.0 + t_sq), 2.0 * t / (1.0 + t_sq)],
        }
    }

    /// A vector of the old plane in the new one. Its length stays.
    #[inline]
    pub fn carry(&self, spring: &Vector3<f64>) -> Vector3<f64> {
        let a = &self.axis;
        // The rotation that takes the first normal to the second (Rodrigues).
        let tilted =
            spring * self.cosine + a.cross(spring) + a * (a.dot(spring) / (1.0 + self.cosine));
        let [cosine, sine] = self.about;
        let turned = tilted * cosine + self.normal.cross(&tilted) * sine;
        // Rounding leaves a component along the normal.
        turned - self.normal * self.normal.dot(&turned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn springs_keep_their_length_and_stay_in_the_plane() {
        let before = Vector3::new(0.6, 0.0, 0.8);
        let spring = Vector3::new(0.8, 0.3, -0.6);
        for (x, y, angle) in [(0.61, 0.02, 0.1), (0.0, -1.0, -0.4), (0.6, 0.0, 0.0)] {
            let after = Vector3::new(x, y, 0.8_f64).normalize();
            let carried = Transport::new(&before, &after, angle).carry(&spring);
            assert!(carried.dot(&after).abs() < 1e-15);
            assert!((carried.norm() / spring.norm() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn a_turn_about_the_normal_turns_the_spring_by_the_angle() {
        let z = Vector3::z();
        let carried = Transport::new(&z, &z, 0.01).carry(&Vector3::x());
        let expected = Vector3::new(libm::cos(0.01), libm::sin(0.01), 0.0);
        assert!((carried - expected).norm() < 1e-7);
    }
}
