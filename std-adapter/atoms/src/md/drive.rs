//! A torque on groups of atoms that gives all of them the same angular acceleration.

use nalgebra::Vector3;

/// F = m a n × (r − axis) on every atom of the driven groups during an interval of time; n points upwards.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::drive::TorqueDrive;
/// let drive = TorqueDrive {
///     axis: [1.0, 0.0],
///     acceleration: 0.02,
///     from: 50.0,
///     until: 250.0,
///     groups: vec![5],
/// };
/// assert!(!drive.is_on(49.9) && drive.is_on(50.0) && !drive.is_on(250.0));
/// // At a distance of 5 from the axis: 5 a, across the arm (3, 4).
/// let [x, y] = drive.acceleration_at(&Vector3::new(4.0, 4.0, 9.0));
/// assert!((x.hypot(y) - 5.0 * 0.02).abs() < 1e-15);
/// assert!((3.0 * x + 4.0 * y).abs() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TorqueDrive {
    /// x and y of the axis.
    pub axis: [f64; 2],
    /// Angular acceleration a, in 1/time².
    pub acceleration: f64,
    /// Time at which the torque begins.
    pub from: f64,
    /// Time at which the torque ends.
    pub until: f64,
    /// The driven groups.
    pub groups: Vec<usize>,
}

impl TorqueDrive {
    /// Whether the torque acts at `time`.
    pub fn is_on(&self, time: f64) -> bool {
        time >= self.from && time < self.until && self.acceleration != 0.0
    }

    /// Acceleration of an atom.
    #[inline]
    pub fn acceleration_at(&self, place: &Vector3<f64>) -> [f64; 2] {
        let [x, y] = [place.x - self.axis[0], place.y - self.axis[1]];
        [-self.acceleration * y, self.acceleration * x]
    }
}
