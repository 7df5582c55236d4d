//! Derivatives of the rest pose.

use super::{Launch, RestMap};
use tribos_core::Real;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};

/// ∂(x, y, angle)/∂(v_x, v_y, ω), with one row each for x, y and angle.
pub type PoseJacobian = [[f64; 3]; 3];

impl<P: PowerLawFriction<f64> + ReducedFriction<f64>> RestMap<P> {
    /// Sensitivity of the rest pose to small changes of the launch.
    ///
    /// With distance d(v, w), w = |ω|R, and the unit vector e of the velocity
    ///
    /// ```text
    /// ∂(x,y)/∂(v_x,v_y) = ∂d/∂v e eᵀ + d/v (1 − e eᵀ)
    /// ∂d/∂v = s^(1−α)/κ (p X c − X' n),   ∂d/∂w = s^(1−α)/κ (p X n + X' c),   p = 2 − α
    /// ```
    ///
    /// and the path of the rim with Y. *Units*: s for x and y by velocity, m s/rad by spin, rad s/m and
    /// s for the angle.
    ///
    /// *Special values*: smooth in every direction; at v = 0 with spin the block is ∂d/∂v times the unit
    /// matrix, without spin the angle decouples, and at rest the Jacobian is zero. NaN for a launch that is
    /// not finite.
    ///
    /// *Accuracy*: within 1e-9 of extrapolated differences, which is the error of these differences for unit
    /// scales; near v = ωR the differences lose their order and confirm only 2e-4.
    ///
    /// ```
    /// use tribos::slide::inverse::{Launch, PoseJacobian, RestMap};
    /// use tribos::kernel::coupling::coulomb::CoulombDisk;
    /// let disk = RestMap::new(CoulombDisk, 0.3 * 9.81, 0.08, 0.5)?; // mu g, R, C = I/(M R^2)
    /// let by: PoseJacobian = disk.jacobian(&Launch { velocity: [1.0, 0.0], spin: 0.0 });
    /// // x = v²/(2 mu g), and a small turn of the velocity turns the way.
    /// assert!((by[0][0] - 1.0 / (0.3 * 9.81)).abs() < 1e-13);
    /// assert!((by[1][1] - 0.5 / (0.3 * 9.81)).abs() < 1e-13);
    /// assert_eq!([by[0][1], by[0][2], by[2][0]], [0.0; 3]); // the rest is even or odd in the spin
    /// # Ok::<(), tribos::slide::inverse::MotionError>(())
    /// ```
    pub fn jacobian(&self, launch: &Launch) -> PoseJacobian {
        let [x, y] = launch.velocity;
        let (v, w) = (Real::hypot(x, y), launch.spin.abs() * self.radius());
        let s = Real::hypot(v, w);
        if s == 0.0 || !s.is_finite() {
            return [[0.0 * s; 3]; 3];
        }
        let (c, n) = (v / s, w / s);
        let paths = self.reduced([c, n]);
        let [dx, dy] = self.slopes([c, n]);
        let p = self.degree();
        let unit = Real::pow(s, p - 1.0) / self.deceleration();
        let by_speed = |path: f64, slope: f64| unit * (p * path * c - slope * n);
        let by_rim = |path: f64, slope: f64| unit * (p * path * n + slope * c);
        let along = by_speed(paths.centre, dx);
        // d/v; its limit for v → 0 is the derivative itself.
        let (across, [ex, ey]) = if v == 0.0 {
            (along, [1.0, 0.0])
        } else {
            (unit * paths.centre / c, [x / v, y / v])
        };
        // Without spin neither distance nor angle depends on the other motion.
        let sense = if w == 0.0 { 0.0 } else { launch.spin.signum() };
        let distance_by_spin = match v {
            0.0 => 0.0,
            _ => sense * self.radius() * by_rim(paths.centre, dx),
        };
        let angle_by_speed = match v {
            0.0 => 0.0,
            _ => sense * by_speed(paths.rim, dy) / self.radius(),
        };
        let skew = (along - across) * ex * ey;
        [
            [
                along * ex * ex + across * ey * ey,
                skew,
                distance_by_spin * ex,
            ],
            [
                skew,
                along * ey * ey + across * ex * ex,
                distance_by_spin * ey,
            ],
            [
                angle_by_speed * ex,
                angle_by_speed * ey,
                by_rim(paths.rim, dy),
            ],
        ]
    }
}
