//! Two independent clamps: full Coulomb force and full drilling torque, independent of each other.
//!
//! *Source*: engines with separate sliding and torsional coefficients (Bullet, PhysX, Gazebo,
//! Box2D).

use super::PURE_SPIN_TORQUE;

/// `[1, 2/3]`, or zero where that motion is absent.
#[inline]
pub fn wrench(slide: f64, rim: f64) -> [f64; 2] {
    let force = if slide == 0.0 { 0.0 } else { 1.0 };
    let torque = if rim == 0.0 { 0.0 } else { PURE_SPIN_TORQUE };
    [force, torque]
}
