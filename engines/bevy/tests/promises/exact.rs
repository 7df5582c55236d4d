//! Exact throws, without the crate under test.

use crate::table::{GRAVITY, MU, RADIUS};
use tribos_core::coupling::closed::CoulombRing;
use tribos_core::coupling::table::CoulombDisk;
use tribos_core::slider::{Slider, SliderParameters, SliderState};

/// How far in metres, and when in seconds, a body comes to rest.
#[derive(Clone, Copy, Debug)]
pub struct Throw {
    pub travel: f64,
    pub stop: f64,
}

impl Throw {
    pub fn assert_near(&self, exact: &Self, tolerance: f64, what: &str) {
        for (is, should) in [(self.travel, exact.travel), (self.stop, exact.stop)] {
            let error = is / should - 1.0;
            assert!(
                error.abs() < tolerance,
                "{what}: {is} for {should}, {error:+.5}"
            );
        }
    }
}

fn parameters() -> SliderParameters<f64> {
    SliderParameters {
        deceleration: f64::from(MU) * f64::from(GRAVITY),
        radius: f64::from(RADIUS),
        inertia_ratio: 0.5,
    }
}

/// A disk thrown at 1 m/s.
pub fn disk(spin: f32) -> Throw {
    let slider = Slider::new(CoulombDisk, parameters()).expect("valid parameters");
    let end = slider.to_rest(&SliderState::launched(1.0, f64::from(spin)));
    let end = end.expect("it stops").motion;
    Throw {
        travel: end.distance,
        stop: end.time,
    }
}

/// A solid cylinder that stands on a ring, thrown at 1 m/s.
pub fn ring(spin: f32) -> Throw {
    let slider = Slider::new(CoulombRing, parameters()).expect("valid parameters");
    let end = slider.to_rest(&SliderState::launched(1.0, f64::from(spin)));
    let end = end.expect("it stops").motion;
    Throw {
        travel: end.distance,
        stop: end.time,
    }
}

/// A body of mass 1 kg on `points`, each with its share of the load, thrown at 1 m/s along x: the sum over the
/// points, each resisting along its own velocity, in steps of 0.1 ms.
pub fn on_points(points: &[([f64; 2], f64)], inertia: f64, spin: f64) -> Throw {
    let dt = 1e-4;
    let limit = f64::from(MU) * f64::from(GRAVITY);
    let (mut velocity, mut spin, mut place, mut angle) = ([1.0, 0.0], spin, [0.0, 0.0], 0.0_f64);
    let mut time = 0.0;
    loop {
        let (sin, cos) = angle.sin_cos();
        let (mut force, mut torque) = ([0.0, 0.0], 0.0);
        for &([x, y], share) in points {
            let [x, y] = [cos * x - sin * y, sin * x + cos * y];
            let u = [velocity[0] - spin * y, velocity[1] + spin * x];
            let speed = u[0].hypot(u[1]).max(1e-9);
            let f = u.map(|u| -limit * share * u / speed);
            force = [force[0] + f[0], force[1] + f[1]];
            torque += x * f[1] - y * f[0];
        }
        let before = (velocity, spin);
        velocity = [velocity[0] + dt * force[0], velocity[1] + dt * force[1]];
        spin += dt * torque / inertia;
        for i in [0, 1] {
            place[i] += 0.5 * dt * (before.0[i] + velocity[i]);
        }
        angle += 0.5 * dt * (before.1 + spin);
        time += dt;
        if velocity[0].hypot(velocity[1]) < 2.0 * limit * dt {
            return Throw {
                travel: f64::hypot(place[0], place[1]),
                stop: time,
            };
        }
    }
}
