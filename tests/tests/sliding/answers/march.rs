//! Motion of a body on a plane to rest, over the time s with dt = σ ds, in which friction changes slowly.

use tribos_core::internals::runge_kutta;
use tribos_core::twist::{Twist, Wrench};

/// Local error of a step, relative to the velocity and to the whole motion.
const TOLERANCE: f64 = 1e-15;
/// Fraction of the initial velocity from which on the deceleration is constant.
const END: f64 = 1e-13;

/// Velocity (2), spin, place (2), angle, time.
pub type State = [f64; 7];

/// What resists, per mass.
pub trait Body {
    /// Friction in axes of the body.
    fn friction(&self, twist: &Twist<f64>) -> Wrench<f64>;

    /// σ
    fn scale(&self, twist: &Twist<f64>) -> f64;

    /// Squared radius of gyration.
    fn gyration_sq(&self) -> f64;

    /// μ g
    fn strength(&self) -> f64;

    /// The rest, if it is known from here.
    fn rest(&self, _state: &State) -> Option<Vec<f64>> {
        None
    }
}

/// Velocity in axes of the body.
pub fn twist([x, y, spin, _, _, angle, _]: &State) -> Twist<f64> {
    let (sin, cos) = angle.sin_cos();
    Twist::new(cos * x + sin * y, cos * y - sin * x, *spin)
}

/// Displacement, angle and time at rest.
pub fn to_rest(body: &impl Body, speed: f64, spin: f64) -> Vec<f64> {
    let mut state = [speed, 0.0, spin, 0.0, 0.0, 0.0, 0.0];
    let gyration = body.gyration_sq().sqrt();
    let size = |[x, y, spin, ..]: &State| x.hypot(*y).hypot(gyration * spin);
    let start = size(&state);
    let time = start / body.strength();
    let [way, turn] = [time * start, time * start / gyration];
    let mut step = 1e-3 / body.strength();
    while size(&state) > END * start {
        let (next, error) = runge_kutta::step(&state, step, |state| slope(body, state));
        let here = size(&state);
        let units = [here, here, here / gyration, way, way, turn, time];
        let worst = error
            .iter()
            .zip(units)
            .fold(0.0, |worst: f64, (error, unit)| {
                worst.max(error.abs() / unit)
            });
        let (is_good, factor) = runge_kutta::judge(worst, TOLERANCE, true);
        step *= factor;
        if !is_good {
            continue;
        }
        state = next;
        if let Some(rest) = body.rest(&state) {
            return rest;
        }
    }
    let [x, y, turning] = acceleration(body, &state);
    let here = size(&state);
    let power = state[0] * x + state[1] * y + body.gyration_sq() * state[2] * turning;
    let left = here * here / -power;
    vec![state[3], state[4], state[5], state[6] + left]
}

fn acceleration(body: &impl Body, state: &State) -> [f64; 3] {
    let Wrench { force, torque } = body.friction(&twist(state));
    let (sin, cos) = state[5].sin_cos();
    [
        cos * force.x - sin * force.y,
        sin * force.x + cos * force.y,
        torque / body.gyration_sq(),
    ]
}

fn slope(body: &impl Body, state: &State) -> State {
    let scale = body.scale(&twist(state));
    let [x, y, turning] = acceleration(body, state);
    [x, y, turning, state[0], state[1], state[2], 1.0].map(|rate| rate * scale)
}
