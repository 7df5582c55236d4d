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
    /// The motion of `patch`, or what every component of its friction is: 0 at rest, NaN for a twist
    /// that is infinite or NaN.
    #[inline(always)]
    pub(super) fn new(patch: &impl PatchShape<R>, twist: &Twist<R>) -> Result<Self, R> {
        let motion = Self::at_centre(patch, twist);
        if is_ordinary(motion.size()) {
            return Ok(motion);
        }
        let scale = Self::unit(patch, twist);
        if !size(&twist.velocity, twist.spin).is_finite() {
            return Err(R::NAN);
        }
        let motion = Self::at_centre(patch, &(*twist * scale));
        if motion.is_rest() {
            return Err(R::ZERO);
        }
        Ok(motion)
    }

    /// The power of two that brings `twist` to speeds whose squares are numbers, almost always 1.
    #[inline]
    pub(super) fn unit(patch: &impl PatchShape<R>, twist: &Twist<R>) -> R {
        let size = Self::at_centre(patch, twist).size();
        if is_ordinary(size) {
            R::ONE
        } else if size < R::ONE {
            // Exact: the smallest normal numbers are even powers of two.
            let up = R::ONE / R::MIN_POSITIVE.sqrt();
            if is_ordinary(size * up) { up } else { up * up }
        } else {
            R::MIN_POSITIVE.sqrt()
        }
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

    #[inline(always)]
    fn size(&self) -> R {
        size(&self.velocity, self.rim)
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
