//! The limit surface as an ellipsoid with the exact semi-axes 1 and 2/3.
//!
//! *Source*: R. D. Howe and M. R. Cutkosky, Int. J. Robotics Res. 15 (1996) 557; the same set is
//! the elliptic friction cone of MuJoCo with a torsional coefficient.

use super::PURE_SPIN_TORQUE;

/// `[F, T]` of greatest dissipation on the ellipsoid.
#[inline]
pub fn wrench(slide: f64, rim: f64) -> [f64; 2] {
    let lever = PURE_SPIN_TORQUE * rim;
    let norm = (slide * slide + lever * lever).sqrt();
    [slide / norm, PURE_SPIN_TORQUE * lever / norm]
}
