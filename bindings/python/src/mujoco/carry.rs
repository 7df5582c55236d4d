//! How MuJoCo moves what is fixed to a body: by the whole turns of its joints, in a circle and not along the
//! tangent.

use nalgebra::Vector3;

/// A joint that carries a body.
pub struct Joint {
    pub index: usize,
    /// First of its degrees of freedom: those that shift, then those that turn about its anchor.
    pub first: usize,
    pub shifts: usize,
    pub turns: usize,
}

/// Joints as MuJoCo has them now, and how fast they move.
pub struct Joints<'a> {
    pub anchors: &'a [[f64; 3]],
    /// Axes of the degrees of freedom, angular and linear.
    pub axes: &'a [[f64; 6]],
    pub velocity: &'a [f64],
}

impl Joints<'_> {
    /// By how much a point of a body does not move straight in a time in which no velocity changes, by the body's
    /// joints from the innermost outwards.
    pub fn bend(&self, chain: &[Joint], dt: f64, point: &Vector3<f64>) -> Vector3<f64> {
        let [mut shift, mut straight] = [Vector3::zeros(); 2];
        for joint in chain {
            let middle = joint.first + joint.shifts;
            let turn = self.sum(middle, middle + joint.turns, 0, dt);
            let along = self.sum(joint.first, middle, 3, dt);
            let lever = point - Vector3::from(self.anchors[joint.index]);
            straight += turn.cross(&lever) + along;
            shift += turned_by(&turn, &(lever + shift)) + along;
        }
        shift - straight
    }

    /// What degrees of freedom do in a time along the axes' numbers from `at` on.
    fn sum(&self, from: usize, to: usize, at: usize, dt: f64) -> Vector3<f64> {
        let mut sum = Vector3::zeros();
        for (axis, velocity) in self.axes[from..to].iter().zip(&self.velocity[from..to]) {
            sum += Vector3::new(axis[at], axis[at + 1], axis[at + 2]) * (velocity * dt);
        }
        sum
    }
}

/// What a turn by a vector of angles adds to another vector (Rodrigues, in half angles without cancellation).
fn turned_by(turn: &Vector3<f64>, vector: &Vector3<f64>) -> Vector3<f64> {
    let angle = turn.norm();
    let half = sinc(0.5 * angle);
    let once = turn.cross(vector);
    once * sinc(angle) + turn.cross(&once) * (0.5 * half * half)
}

/// sin(x)/x
fn sinc(x: f64) -> f64 {
    if x.abs() > 0.0 { x.sin() / x } else { 1.0 }
}
