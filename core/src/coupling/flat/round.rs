//! Friction of a round patch in a place of its own.

use super::motion::Motion;
use super::{Hessian, PatchShape, Reduced};
use crate::coupling::DryReducedFriction;
use crate::patch::round::RoundPatch;
use crate::real::Real;
use nalgebra::Vector2;

impl<R: Real, C: DryReducedFriction<R>> PatchShape<R> for RoundPatch<R, C> {
    fn centre(&self) -> Vector2<R> {
        RoundPatch::centre(self)
    }

    fn radius(&self) -> R {
        RoundPatch::radius(self)
    }

    #[inline]
    fn reduced(&self, motion: &Motion<R>) -> Reduced<R> {
        let (slide, [cos, sin]) = heading(&motion.velocity);
        let found = self.coupling().reduced_wrench(slide, motion.rim);
        Reduced {
            force: Vector2::new(-(found.force * cos), -(found.force * sin)),
            torque: -found.torque.abs().copysign(motion.rim),
        }
    }

    fn reduced_with_hessian(&self, motion: &Motion<R>) -> (Reduced<R>, Hessian<R>) {
        let (slide, [cos, sin]) = heading(&motion.velocity);
        let found = self.coupling().reduced_jacobian(slide, motion.rim);
        // Along the velocity the force changes with the speed, across it its direction turns; alike at rest.
        let (along, across) = (found.force_slide, found.force_per_slide);
        let mixed = found.mixed * R::ONE.copysign(motion.rim);
        let hessian = Hessian {
            xx: along * (cos * cos) + across * (sin * sin),
            xy: (along - across) * (cos * sin),
            yy: along * (sin * sin) + across * (cos * cos),
            xn: mixed * cos,
            yn: mixed * sin,
            nn: found.torque_rim,
        };
        (self.reduced(motion), hessian)
    }
}

/// Speed and direction of a velocity; any direction at rest.
#[inline]
fn heading<R: Real>(velocity: &Vector2<R>) -> (R, [R; 2]) {
    let speed = velocity.x.hypot(velocity.y);
    if speed == R::ZERO {
        return (speed, [R::ONE, R::ZERO]);
    }
    (speed, [velocity.x / speed, velocity.y / speed])
}
