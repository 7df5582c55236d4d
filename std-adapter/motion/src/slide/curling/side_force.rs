//! Ice friction with an additional lateral acceleration.

use crate::slide::planar::{Resistance, TallBody};
use tribos_core::Real;

/// Contribution of a mechanism beyond the friction of the upright rock.
pub(super) trait Mechanism: std::fmt::Debug {
    /// Acceleration to the left of the velocity for counterclockwise spin, and the deceleration of the rim
    /// speed by the same mechanism, divided by C; both ≥ 0, in m/s².
    fn added(&self, slide: f64, rim: f64) -> [f64; 2];
}

/// An upright rock with an additional mechanism.
#[derive(Debug)]
pub(super) struct RockWithSideForce<M> {
    pub body: TallBody,
    pub mechanism: M,
}

impl<M: Mechanism> Resistance for RockWithSideForce<M> {
    fn deceleration(&self, velocity: [f64; 3]) -> [f64; 3] {
        let [x, y, rim] = velocity;
        let [ax, ay, aw] = self.body.deceleration(velocity);
        let slide = Real::hypot(x, y);
        if rim == 0.0 || slide == 0.0 {
            return [ax, ay, aw];
        }
        let [left, spin_down] = self.mechanism.added(slide, rim.abs());
        let sense = Real::copysign(1.0, rim);
        let side = left * sense / slide;
        [ax + side * y, ay - side * x, aw + spin_down * sense]
    }

    fn exponent(&self) -> f64 {
        self.body.exponent()
    }
    fn inertia_ratio(&self) -> f64 {
        self.body.inertia_ratio()
    }
    fn radius(&self) -> f64 {
        self.body.radius()
    }
}
