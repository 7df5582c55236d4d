//! Conversions of twists and wrenches from and to other vector types: (x, y, normal), component by component.

use super::{Twist, Wrench};
use crate::real::Real;
use nalgebra::Vector3;

impl<R: Real> From<Vector3<R>> for Twist<R> {
    fn from(v: Vector3<R>) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl<R: Real> From<Twist<R>> for Vector3<R> {
    fn from(t: Twist<R>) -> Self {
        Vector3::new(t.velocity.x, t.velocity.y, t.spin)
    }
}

impl<R: Real> From<Vector3<R>> for Wrench<R> {
    fn from(v: Vector3<R>) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl<R: Real> From<Wrench<R>> for Vector3<R> {
    fn from(w: Wrench<R>) -> Self {
        Vector3::new(w.force.x, w.force.y, w.torque)
    }
}

/// glam's vectors are not generic: the same for both precisions.
#[cfg(feature = "glam")]
macro_rules! glam_vectors {
    ($real:ty, $plane:ty, $space:ty) => {
        impl From<$space> for Twist<$real> {
            fn from(v: $space) -> Self {
                Self::new(v.x, v.y, v.z)
            }
        }

        impl From<Twist<$real>> for $space {
            fn from(t: Twist<$real>) -> Self {
                Self::new(t.velocity.x, t.velocity.y, t.spin)
            }
        }

        impl From<($plane, $real)> for Wrench<$real> {
            fn from((force, torque): ($plane, $real)) -> Self {
                Self::new(force.x, force.y, torque)
            }
        }

        impl From<Wrench<$real>> for ($plane, $real) {
            fn from(w: Wrench<$real>) -> Self {
                (<$plane>::new(w.force.x, w.force.y), w.torque)
            }
        }
    };
}

#[cfg(feature = "glam")]
glam_vectors!(f32, glam::Vec2, glam::Vec3);
#[cfg(feature = "glam")]
glam_vectors!(f64, glam::DVec2, glam::DVec3);

#[cfg(feature = "mint")]
mod mint_vectors {
    use super::{Real, Twist, Wrench};
    use mint::Vector3;

    impl<R: Real> From<Vector3<R>> for Twist<R> {
        fn from(v: Vector3<R>) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }

    impl<R: Real> From<Twist<R>> for Vector3<R> {
        fn from(t: Twist<R>) -> Self {
            [t.velocity.x, t.velocity.y, t.spin].into()
        }
    }

    impl<R: Real> From<Vector3<R>> for Wrench<R> {
        fn from(v: Vector3<R>) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }

    impl<R: Real> From<Wrench<R>> for Vector3<R> {
        fn from(w: Wrench<R>) -> Self {
            [w.force.x, w.force.y, w.torque].into()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triples that tell order, sign and scale apart, with all that a float can be.
    macro_rules! triples {
        ($real:ty) => {{
            let odd = [
                0.0,
                -0.0,
                1.5,
                -2.25,
                <$real>::MIN_POSITIVE / 8.0,
                -<$real>::MAX,
                <$real>::INFINITY,
                <$real>::NEG_INFINITY,
                <$real>::NAN,
            ];
            (0..odd.len()).map(move |i| [0, 1, 2].map(|j| odd[(i + j * (i + 1)) % odd.len()]))
        }};
    }

    /// There and back through `$other`: the same bits, and x, y, normal where they belong.
    macro_rules! assert_round_trip {
        ($real:ty, $other:ty, $from:expr) => {
            for [x, y, z] in triples!($real) {
                let bits = [x, y, z].map(<$real>::to_bits);
                let other: $other = $from([x, y, z]);
                let twist = Twist::<$real>::from(other);
                let parts = [twist.velocity.x, twist.velocity.y, twist.spin];
                assert_eq!(parts.map(<$real>::to_bits), bits);
                let back = Twist::<$real>::from(<$other>::from(twist));
                let parts = [back.velocity.x, back.velocity.y, back.spin];
                assert_eq!(parts.map(<$real>::to_bits), bits);
            }
        };
    }

    macro_rules! assert_wrench_round_trip {
        ($real:ty, $other:ty, $from:expr) => {
            for [x, y, z] in triples!($real) {
                let bits = [x, y, z].map(<$real>::to_bits);
                let other: $other = $from([x, y, z]);
                let wrench = Wrench::<$real>::from(other);
                let parts = [wrench.force.x, wrench.force.y, wrench.torque];
                assert_eq!(parts.map(<$real>::to_bits), bits);
                let back = Wrench::<$real>::from(<$other>::from(wrench));
                let parts = [back.force.x, back.force.y, back.torque];
                assert_eq!(parts.map(<$real>::to_bits), bits);
            }
        };
    }

    #[test]
    fn nalgebra_keeps_every_bit() {
        assert_round_trip!(f32, Vector3<f32>, Vector3::from);
        assert_round_trip!(f64, Vector3<f64>, Vector3::from);
        assert_wrench_round_trip!(f32, Vector3<f32>, Vector3::from);
        assert_wrench_round_trip!(f64, Vector3<f64>, Vector3::from);
    }

    #[cfg(feature = "glam")]
    #[test]
    fn glam_keeps_every_bit() {
        use glam::{DVec2, DVec3, Vec2, Vec3};
        assert_round_trip!(f32, Vec3, Vec3::from_array);
        assert_round_trip!(f64, DVec3, DVec3::from_array);
        assert_wrench_round_trip!(f32, (Vec2, f32), |[x, y, z]: [f32; 3]| (Vec2::new(x, y), z));
        assert_wrench_round_trip!(f64, (DVec2, f64), |[x, y, z]: [f64; 3]| (
            DVec2::new(x, y),
            z
        ));
    }

    #[cfg(feature = "mint")]
    #[test]
    fn mint_keeps_every_bit() {
        assert_round_trip!(f32, mint::Vector3<f32>, mint::Vector3::from);
        assert_round_trip!(f64, mint::Vector3<f64>, mint::Vector3::from);
        assert_wrench_round_trip!(f32, mint::Vector3<f32>, mint::Vector3::from);
        assert_wrench_round_trip!(f64, mint::Vector3<f64>, mint::Vector3::from);
    }

    #[cfg(all(feature = "glam", feature = "mint"))]
    #[test]
    fn one_vector_to_another_through_a_twist() {
        let twist = Twist::from(glam::Vec3::new(1.0, -2.0, 3.0));
        let mint: mint::Vector3<f32> = twist.into();
        assert_eq!([mint.x, mint.y, mint.z], [1.0, -2.0, 3.0]);
        assert_eq!(twist.velocity.y, -2.0);
    }
}
