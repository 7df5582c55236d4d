//! The motion of a patch, as the closed forms need it.

use super::PatchShape;
use crate::real::Real;
use crate::twist::Twist;
use nalgebra::Vector2;

/// A motion with lengths in units of the patch's radius, at its centre of pressure.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion<R: Real> {
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
        Self::split_at(near::<R>(), patch, twist)
    }

    /// The motion with this velocity and rim speed, whose squares are numbers.
    #[inline(always)]
    pub(super) fn dry(velocity: &Vector2<R>, rim: R) -> Self {
        Self::of(near::<R>(), velocity, rim)
    }

    /// The same for a power law, whose closed form ends at 2 radii.
    #[inline(always)]
    pub(super) fn of_power(patch: &impl PatchShape<R>, twist: &Twist<R>) -> Result<Self, R> {
        Self::split_at(NEAR_SINGLE, patch, twist)
    }

    #[inline(always)]
    fn split_at(near: f64, patch: &impl PatchShape<R>, twist: &Twist<R>) -> Result<Self, R> {
        let (velocity, rim) = at_centre(patch, twist);
        let size = size(&velocity, rim);
        if is_ordinary(size) {
            return Ok(Self::of(near, &velocity, rim));
        }
        let scale = Self::unit(patch, twist);
        if !twist_size(twist).is_finite() {
            return Err(R::NAN);
        }
        let twist = *twist * scale;
        let (velocity, rim) = at_centre(patch, &twist);
        if velocity.x == R::ZERO && velocity.y == R::ZERO && rim == R::ZERO {
            return Err(R::ZERO);
        }
        Ok(Self::of(near, &velocity, rim))
    }

    /// The power of two that brings `twist` to speeds whose squares are numbers, almost always 1.
    #[inline]
    pub(super) fn unit(patch: &impl PatchShape<R>, twist: &Twist<R>) -> R {
        let (velocity, rim) = at_centre(patch, twist);
        let size = size(&velocity, rim);
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
    fn of(near: f64, velocity: &Vector2<R>, rim: R) -> Self {
        let speed = (velocity.x * velocity.x + velocity.y * velocity.y).sqrt();
        if speed <= R::from_f64(near) * rim.abs() {
            Self::Turns {
                centre: Vector2::new(-(velocity.y / rim), velocity.x / rim),
                spin: rim,
            }
        } else {
            Self::Slides {
                direction: Vector2::new(velocity.x / speed, velocity.y / speed),
                turn: rim / speed,
                speed,
            }
        }
    }
}

/// Radii up to which the closed form of dry friction serves.
#[inline(always)]
fn near<R: Real>() -> f64 {
    if R::IS_SINGLE { NEAR_SINGLE } else { NEAR }
}

/// Velocity of the centre of pressure, and rim speed.
#[inline(always)]
fn at_centre<R: Real>(patch: &impl PatchShape<R>, twist: &Twist<R>) -> (Vector2<R>, R) {
    let centre = patch.centre();
    let velocity = Vector2::new(
        twist.velocity.x - twist.spin * centre.y,
        twist.velocity.y + twist.spin * centre.x,
    );
    (velocity, twist.spin * patch.radius())
}

/// An upper bound of the speeds that is not larger than three times the largest one.
#[inline(always)]
fn size<R: Real>(velocity: &Vector2<R>, rim: R) -> R {
    velocity.x.abs() + velocity.y.abs() + rim.abs()
}

fn twist_size<R: Real>(twist: &Twist<R>) -> R {
    size(&twist.velocity, twist.spin)
}

/// True if the square is a normal number with digits to spare.
#[inline(always)]
fn is_ordinary<R: Real>(size: R) -> bool {
    let sq = size * size;
    sq > R::MIN_POSITIVE / R::EPSILON && sq < R::INFINITY
}
