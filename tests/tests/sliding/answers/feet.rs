//! A rigid body that slides on three points, whose loads follow from statics with the friction itself.
//!
//! 1/σ is the sum of the feet's inverse speeds. If a foot comes to rest before the others and friction holds it, the body
//! turns about it from there on.

use super::march::{Body, State, twist};
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::internals::tripod_shares;
use tribos_core::patch::nodes::{Node, Nodes};
use tribos_core::patch::points::PointPatch;
use tribos_core::twist::{Twist, Wrench};

/// A foot this much slower than the others rests.
const RESTS: f64 = 1e-11;
/// Intervals of Simpson's rule over the spin of a body that turns about a foot.
const INTERVALS: u32 = 64;

/// The body, per mass.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    pub feet: [[f64; 2]; 3],
    pub mu: f64,
    pub gravity: f64,
    /// Of the centre of mass.
    pub height: f64,
    pub gyration_sq: f64,
}

impl Standing {
    fn speeds(&self, twist: &Twist<f64>) -> [f64; 3] {
        self.feet.map(|[x, y]| {
            (twist.velocity.x - twist.spin * y).hypot(twist.velocity.y + twist.spin * x)
        })
    }

    /// Friction under the loads of a resultant that meets the ground at `centre`.
    fn friction_at(
        &self,
        centre: [f64; 2],
        twist: &Twist<f64>,
        without: Option<usize>,
    ) -> Wrench<f64> {
        let mut shares = tripod_shares(self.feet, centre).expect("no foot lifts off");
        if let Some(foot) = without {
            shares[foot] = 0.0;
        }
        let nodes = [0, 1, 2].map(|i| Node {
            x: self.feet[i][0],
            y: self.feet[i][1],
            weight: shares[i],
        });
        let points = PointPatch::new(Nodes::new(nodes).expect("three nodes")).expect("points");
        let friction = ShapeFriction::new(points, self.mu).expect("a coefficient");
        friction.wrench(self.gravity * shares.iter().sum::<f64>(), twist)
    }

    fn resting(&self, state: &State) -> Option<usize> {
        let speeds = self.speeds(&twist(state));
        let fastest = speeds.iter().fold(0.0, |a: f64, &b| a.max(b));
        speeds.iter().position(|&speed| speed < RESTS * fastest)
    }

    /// Angular acceleration about a foot at rest, and the force on that foot over its limit.
    fn turning(&self, foot: usize, spin: f64) -> [f64; 2] {
        let [x, y] = self.feet[foot];
        let twist = Twist::new(spin * y, -spin * x, spin);
        let mut rate = 0.0;
        let mut used = 0.0;
        // The loads depend on the acceleration, weakly.
        for _ in 0..100 {
            let acceleration = [rate * y + spin * spin * x, -rate * x + spin * spin * y];
            let centre = acceleration.map(|a| -self.height * a / self.gravity);
            let Wrench { force, torque } = self.friction_at(centre, &twist, Some(foot));
            let about = torque - (x * force.y - y * force.x);
            rate = about / (self.gyration_sq + x * x + y * y);
            let held = (acceleration[0] - force.x).hypot(acceleration[1] - force.y);
            let share = tripod_shares(self.feet, centre).expect("no foot lifts off")[foot];
            used = held / (self.mu * self.gravity * share);
        }
        [rate, used]
    }

    /// The force on the foot is convex in the squared spin: both ends decide.
    fn is_held(&self, foot: usize, spin: f64) -> bool {
        [spin, 1e-9 * spin]
            .iter()
            .all(|&spin| self.turning(foot, spin)[1] < 1.0)
    }

    /// Turns about the foot to rest.
    fn about(&self, foot: usize, state: &State) -> Vec<f64> {
        let [_, _, spin, x, y, angle, time] = *state;
        let (mut turned, mut lasted) = (0.0, 0.0);
        for i in 0..=INTERVALS {
            let weight = match i {
                0 | INTERVALS => 1.0,
                _ => f64::from(2 + 2 * (i % 2)),
            };
            let here = spin * f64::from(INTERVALS - i) / f64::from(INTERVALS);
            let moving = if here == 0.0 { 1e-9 * spin } else { here };
            let step = -weight * spin / f64::from(3 * INTERVALS) / self.turning(foot, moving)[0];
            lasted += step;
            turned += step * here;
        }
        let [px, py] = self.feet[foot];
        let turn = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            [cos * px - sin * py, sin * px + cos * py]
        };
        let ([ax, ay], [bx, by]) = (turn(angle), turn(angle + turned));
        vec![x + ax - bx, y + ay - by, angle + turned, time + lasted]
    }
}

impl Body for Standing {
    /// The resultant meets the ground at −h F/(m g). Friction is linear in that place.
    fn friction(&self, twist: &Twist<f64>) -> Wrench<f64> {
        let arm = self.height / self.gravity;
        let upright = self.friction_at([0.0; 2], twist, None);
        if arm == 0.0 {
            return upright;
        }
        let step = 0.01 * self.feet[0][0].hypot(self.feet[0][1]);
        let along = (self.friction_at([step, 0.0], twist, None) - upright) * (1.0 / step);
        let across = (self.friction_at([0.0, step], twist, None) - upright) * (1.0 / step);
        // F = F₀ + (∂F/∂c) c with c = −arm F.
        let [a, b] = [1.0 + arm * along.force.x, arm * across.force.x];
        let [c, d] = [arm * along.force.y, 1.0 + arm * across.force.y];
        let det = a * d - b * c;
        let x = (d * upright.force.x - b * upright.force.y) / det;
        let y = (a * upright.force.y - c * upright.force.x) / det;
        self.friction_at([-arm * x, -arm * y], twist, None)
    }

    fn scale(&self, twist: &Twist<f64>) -> f64 {
        let inverse: f64 = self.speeds(twist).iter().map(|speed| 1.0 / speed).sum();
        1.0 / inverse
    }

    fn gyration_sq(&self) -> f64 {
        self.gyration_sq
    }

    fn strength(&self) -> f64 {
        self.mu * self.gravity
    }

    fn rest(&self, state: &State) -> Option<Vec<f64>> {
        let foot = self.resting(state)?;
        self.is_held(foot, state[2])
            .then(|| self.about(foot, state))
    }
}
