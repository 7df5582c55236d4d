//! The motion of a patch, as its friction needs it.

use super::PatchShape;
use crate::real::Real;
use crate::twist::Twist;
use nalgebra::Vector2;

/// A motion of the centre of pressure.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<R: Real> {
    /// Velocity of the centre.
    pub velocity: Vector2<R>,
    /// Spin times the radius of the patch.
    pub rim: R,
}

/// A motion as the closed forms about a centre of rotation need it, with lengths in radii.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SplitMotion<R: Real> {
    /// About a centre that is at most 3 radii away (f32 and power laws: 2).
    Turns {
        /// Where it lies.
        centre: Vector2<R>,
        /// Spin, in units of speed.
        spin: R,
    },
    /// Almost a translation.
    Slides {
        /// Direction of the velocity, of length 1.
        direction: Vector2<R>,
        /// Rim speed over speed, at most 1/3 (f32 and power laws: 1/2).
        turn: R,
        /// |velocity|
        speed: R,
    },
}

/// Distance of the centre of rotation, in radii, up to which the closed form serves. It loses the cube
/// of the distance in rounding errors of the torque.
const NEAR: f64 = 3.0;
/// The same in single precision, of which there are fewer digits to lose, and for power laws.
const NEAR_SINGLE: f64 = 2.0;

impl<R: Real> Motion<R> {
    /// The motion of `patch`, and the power of two that its speeds are multiplied by, almost always 1; or what
    /// every component of its friction is: 0 at rest, NaN for a twist that is infinite or NaN.
    #[inline(always)]
    pub(super) fn new(patch: &impl PatchShape<R>, twist: &Twist<R>) -> Result<(Self, R), R> {
        let motion = Self::at_centre(patch, twist);
        if is_ordinary(size(&motion.velocity, motion.rim)) {
            return Ok((motion, R::ONE));
        }
        Self::scaled(patch, twist)
    }

    /// The same where squares of the speeds may leave the range of numbers.
    #[cold]
    fn scaled(patch: &impl PatchShape<R>, twist: &Twist<R>) -> Result<(Self, R), R> {
        let Twist { velocity, spin } = *twist;
        if !(velocity.x.is_finite() && velocity.y.is_finite() && spin.is_finite()) {
            return Err(R::NAN);
        }
        // The twist first, so that its products with lengths have all digits, then what these make of it.
        let of_twist = to_ordinary(size(&velocity, spin));
        let Self { velocity, rim } = Self::at_centre(patch, &(*twist * of_twist));
        let of_speeds = to_ordinary(size(&velocity, rim));
        let motion = Self {
            velocity: velocity * of_speeds,
            rim: rim * of_speeds,
        };
        if motion.is_rest() {
            return Err(R::ZERO);
        }
        Ok((motion, of_twist * of_speeds))
    }

    #[inline(always)]
    fn at_centre(patch: &impl PatchShape<R>, twist: &Twist<R>) -> Self {
        let centre = patch.centre();
        let velocity = Vector2::new(
            twist.velocity.x - twist.spin * centre.y,
            twist.velocity.y + twist.spin * centre.x,
        );
        let rim = twist.spin * patch.radius();
        Self { velocity, rim }
    }

    pub(super) fn is_rest(&self) -> bool {
        self.velocity.x == R::ZERO && self.velocity.y == R::ZERO && self.rim == R::ZERO
    }

    /// As dry friction about a centre of rotation needs it.
    #[inline(always)]
    pub(super) fn split(&self) -> SplitMotion<R> {
        self.split_at(if R::IS_SINGLE { NEAR_SINGLE } else { NEAR })
    }

    /// The same for a power law, whose closed form ends at 2 radii.
    #[inline(always)]
    pub(super) fn split_for_power(&self) -> SplitMotion<R> {
        self.split_at(NEAR_SINGLE)
    }

    #[inline(always)]
    fn split_at(&self, near: f64) -> SplitMotion<R> {
        let Self { velocity, rim } = *self;
        let speed = (velocity.x * velocity.x + velocity.y * velocity.y).sqrt();
        if speed <= R::from_f64(near) * rim.abs() {
            SplitMotion::Turns {
                centre: Vector2::new(-(velocity.y / rim), velocity.x / rim),
                spin: rim,
            }
        } else {
            SplitMotion::Slides {
                direction: Vector2::new(velocity.x / speed, velocity.y / speed),
                turn: rim / speed,
                speed,
            }
        }
    }
}

/// An upper bound of the speeds that is not larger than three times the largest one.
#[inline(always)]
fn size<R: Real>(velocity: &Vector2<R>, rim: R) -> R {
    velocity.x.abs() + velocity.y.abs() + rim.abs()
}

/// True if the square is a normal number with digits to spare.
#[inline(always)]
fn is_ordinary<R: Real>(size: R) -> bool {
    let sq = size * size;
    sq > R::MIN_POSITIVE / R::EPSILON && sq < R::INFINITY
}

/// The power of two that brings speeds of this size to ordinary ones: 1 for those that are.
fn to_ordinary<R: Real>(size: R) -> R {
    // Exact: the smallest normal numbers are even powers of two.
    let down = R::MIN_POSITIVE.sqrt();
    if is_ordinary(size) {
        R::ONE
    } else if size < R::ONE {
        let up = R::ONE / down;
        if is_ordinary(size * up) { up } else { up * up }
    } else {
        // The largest number becomes 2 or less over this root: three squares of it have a sum.
        down * R::from_f64(0.125)
    }
}

#[cfg(test)]
mod tests {
    use crate::coupling::flat::{PolygonPowerLaw, ShapeFriction, ShapePowerFriction};
    use crate::patch::outline::Polygon;
    use crate::real::Real;
    use crate::twist::Twist;
    use nalgebra::Vector3;

    /// Wrenches of a square under dry friction and under a power of 0, with the side as the unit of length.
    fn wrenches<R: Real>(side: R, [x, y, spin]: [R; 3]) -> [Vector3<R>; 2] {
        let half = side * R::HALF;
        let square = [[-half, -half], [half, -half], [half, half], [-half, half]];
        let square = Polygon::new(square).unwrap();
        let power = PolygonPowerLaw::new(R::ZERO).unwrap();
        let dry = ShapeFriction::new(square, R::ONE).unwrap();
        let power = ShapePowerFriction::new(square, R::ONE, power).unwrap();
        let (load, twist) = (R::ONE, Twist::new(x, y, spin));
        [dry.wrench(load, &twist), power.wrench(load, &twist)]
            .map(|found| Vector3::new(found.force.x, found.force.y, found.torque / side))
    }

    fn ends_of_the_range<R: Real>(most: R) {
        let (zero, one, hundred) = (R::ZERO, R::ONE, R::from_f64(100.0));
        let small = R::MIN_POSITIVE * R::from_f64(512.0);
        for (side, twist, usual) in [
            (one, [most, zero, zero], [one, zero, zero]),
            (one, [most, most, zero], [one, one, zero]),
            (one, [most, -most, most], [one, -one, one]),
            (small, [zero, zero, hundred], [zero, zero, one]),
            (small, [small, zero, one], [one, zero, one]),
        ] {
            let (found, expected) = (wrenches(side, twist), wrenches(one, usual));
            for (found, expected) in found.iter().zip(&expected) {
                for (found, expected) in found.iter().zip(expected) {
                    let off = (*found - *expected).abs();
                    assert!(off < R::from_f64(8.0) * R::EPSILON, "{side:?} {twist:?}");
                }
            }
        }
    }

    #[test]
    fn ends_of_the_range_have_the_friction_of_ordinary_motions() {
        ends_of_the_range(f64::MAX);
        ends_of_the_range(f32::MAX);
    }
}
