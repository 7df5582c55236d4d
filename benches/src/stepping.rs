//! Stops of a sliding, spinning disk by steppers with a fixed step.

use crate::baselines::PURE_SPIN_TORQUE;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::ReducedFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::planar::PlanarBody;
use tribos_core::slider::{Slider, SliderState};
use tribos_core::twist::{Twist, Wrench};

/// Number of steps after which a stepper is considered never to stop.
const MAX_STEPS: u32 = 20_000_000;
/// Newton's rounds and relative tolerance of the ellipsoid's multiplier.
const NEWTON_ROUNDS: usize = 20;
const NEWTON_TOLERANCE: f64 = 1e-12;

/// The disk of the comparison with engines: R = 8 cm, μ = 0.3, C = 1/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// Contact radius in m.
    pub radius: f64,
    /// μ g in m/s².
    pub deceleration: f64,
    /// C = I/(M R²).
    pub inertia_ratio: f64,
}

/// The disk of the front.
pub const DISK: Disk = Disk {
    radius: 0.08,
    deceleration: 0.3 * 9.81,
    inertia_ratio: 0.5,
};
/// Launch speed in m/s.
pub const SPEED: f64 = 1.0;
/// Launch spins in rad/s.
pub const SPINS: [f64; 3] = [5.0, 12.5, 50.0];

/// Time and distance until nothing moves; NaN if it never came to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Time to rest in s.
    pub time: f64,
    /// Distance to rest in m.
    pub distance: f64,
}

impl Stop {
    const NEVER: Self = Self {
        time: f64::NAN,
        distance: f64::NAN,
    };

    fn of(motion: &SliderState<f64>) -> Self {
        Self {
            time: motion.time,
            distance: motion.distance,
        }
    }
}

/// A method of following a stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepper {
    /// `Slider::to_rest`.
    ToRest,
    /// `Slider::advance` in steps of dt.
    Advance(f64),
    /// `Slider::verlet_step` of dt.
    Verlet(f64),
    /// `PlanarBody::step` of dt on the disk's limit surface.
    Implicit(f64),
    /// Explicit Euler with the exact friction at the start of the step, clamped at zero speed.
    Explicit(f64),
    /// Semi-implicit Euler with independent clamps.
    Decoupled(f64),
    /// Implicit Euler with the friction ellipsoid, as MuJoCo's elliptic cone has it.
    Ellipsoid(f64),
}

impl Stepper {
    /// Name of the method in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::ToRest => "to_rest",
            Self::Advance(_) => "advance",
            Self::Verlet(_) => "verlet",
            Self::Implicit(_) => "implicit step",
            Self::Explicit(_) => "explicit Euler",
            Self::Decoupled(_) => "decoupled clamps",
            Self::Ellipsoid(_) => "ellipsoid",
        }
    }

    /// The step, if there is one.
    pub fn step(self) -> Option<f64> {
        match self {
            Self::ToRest => None,
            Self::Advance(dt)
            | Self::Verlet(dt)
            | Self::Implicit(dt)
            | Self::Explicit(dt)
            | Self::Decoupled(dt)
            | Self::Ellipsoid(dt) => Some(dt),
        }
    }

    /// Follows `slider`, which must be that of [`DISK`], from its launch to rest.
    pub fn stop(self, slider: &Slider<f64, CoulombDisk>, launch: &SliderState<f64>) -> Stop {
        match self {
            Self::ToRest => {
                let rest = slider.to_rest(launch);
                rest.map_or(Stop::NEVER, |rest| Stop::of(&rest.motion))
            }
            Self::Advance(dt) => advanced(slider, launch, dt),
            Self::Verlet(dt) => stepped(launch, |motion| slider.verlet_step(motion, dt)),
            Self::Implicit(dt) => held(launch, dt).unwrap_or(Stop::NEVER),
            Self::Explicit(dt) => stepped(launch, |motion| pushed(motion, dt)),
            Self::Decoupled(dt) => stepped(launch, |motion| clamped(motion, dt)),
            Self::Ellipsoid(dt) => stepped(launch, |motion| dissipated(motion, dt)),
        }
    }
}

/// Calls of the exact stepper with a fixed step; the last one gives the time of rest.
fn advanced(slider: &Slider<f64, CoulombDisk>, launch: &SliderState<f64>, dt: f64) -> Stop {
    let mut motion = *launch;
    for _ in 0..MAX_STEPS {
        let after = slider.advance(&motion, dt);
        if let Some(rest) = after.rest {
            return Stop::of(&rest.motion);
        }
        motion = after.motion;
    }
    Stop::NEVER
}

/// Steps until nothing moves.
fn stepped(
    launch: &SliderState<f64>,
    step: impl Fn(&SliderState<f64>) -> SliderState<f64>,
) -> Stop {
    let mut motion = *launch;
    for _ in 0..MAX_STEPS {
        motion = step(&motion);
        if motion.is_at_rest() {
            return Stop::of(&motion);
        }
    }
    Stop::NEVER
}

/// Implicit steps of a body of unit mass; distance by the trapezoid rule.
///
/// The fraction of the friction limit in the last step gives the time of rest within it.
fn held(launch: &SliderState<f64>, dt: f64) -> Option<Stop> {
    let inertia = DISK.inertia_ratio * DISK.radius * DISK.radius;
    let body = PlanarBody::new(1.0, inertia).ok()?;
    let set = RoundLimitSurface::new(CoulombDisk, DISK.deceleration, DISK.radius).ok()?;
    let step = TimeStep::new(dt).ok()?;
    let mut twist = Twist::new(launch.speed, 0.0, launch.spin);
    let mut stop = Stop::of(launch);
    for _ in 0..MAX_STEPS {
        let after = body.step(&set, &twist, &Wrench::ZERO, step);
        let share = if after.is_at_rest {
            set.gauge(&after.friction)
        } else {
            1.0
        };
        stop.distance += 0.5 * share * dt * (twist.velocity.x + after.twist.velocity.x);
        stop.time += share * dt;
        if after.is_at_rest {
            return Some(stop);
        }
        twist = after.twist;
    }
    None
}

/// Friction at the speeds before the step slows the motion; the position also moves with these speeds.
fn pushed(motion: &SliderState<f64>, dt: f64) -> SliderState<f64> {
    let impulse = DISK.deceleration * dt;
    let rim = motion.spin * DISK.radius;
    let friction = CoulombDisk.reduced_wrench(motion.speed, rim);
    let speed = (motion.speed - impulse * friction.force).max(0.0);
    let rim = (rim - impulse * friction.torque / DISK.inertia_ratio).max(0.0);
    SliderState {
        time: motion.time + dt,
        speed,
        spin: rim / DISK.radius,
        distance: motion.distance + motion.speed * dt,
        angle: motion.angle + motion.spin * dt,
    }
}

/// The motion after a step that ends with the given speeds; positions move with them.
fn moved(motion: &SliderState<f64>, speed: f64, rim: f64, dt: f64) -> SliderState<f64> {
    let spin = rim / DISK.radius;
    SliderState {
        time: motion.time + dt,
        speed,
        spin,
        distance: motion.distance + speed * dt,
        angle: motion.angle + spin * dt,
    }
}

/// Each speed loses its own full friction and stops at zero.
fn clamped(motion: &SliderState<f64>, dt: f64) -> SliderState<f64> {
    let impulse = DISK.deceleration * dt;
    let rim = motion.spin * DISK.radius;
    let speed = (motion.speed - impulse).max(0.0);
    let rim = (rim - impulse * PURE_SPIN_TORQUE / DISK.inertia_ratio).max(0.0);
    moved(motion, speed, rim, dt)
}

/// Greatest dissipation on the ellipsoid with the speeds after the step.
///
/// With the multiplier λ the impulses are λ v' and λ T₀² w', hence v' = v/(1 + λ) and
/// w' = w/(1 + λT₀²/C); λ follows from λ √(v'² + T₀² w'²) = μ g dt. The left side is concave in
/// λ, so that Newton's method from the smallest λ never oversteps.
fn dissipated(motion: &SliderState<f64>, dt: f64) -> SliderState<f64> {
    let impulse = DISK.deceleration * dt;
    let (speed, rim) = (motion.speed, motion.spin * DISK.radius);
    let stiffness = PURE_SPIN_TORQUE * PURE_SPIN_TORQUE / DISK.inertia_ratio;
    // The impulse that stops everything lies inside: λ is infinite.
    if speed.hypot(rim * DISK.inertia_ratio / PURE_SPIN_TORQUE) <= impulse {
        return moved(motion, 0.0, 0.0, dt);
    }
    let mut multiplier = impulse / speed.hypot(PURE_SPIN_TORQUE * rim);
    for _ in 0..NEWTON_ROUNDS {
        let (slow, slow_rim) = (1.0 + multiplier, 1.0 + multiplier * stiffness);
        let (a, b) = (speed / slow, PURE_SPIN_TORQUE * rim / slow_rim);
        let norm = a.hypot(b);
        let missing = impulse - multiplier * norm;
        let slope = (a * a / slow + b * b / slow_rim) / norm;
        multiplier += missing / slope;
        if missing <= NEWTON_TOLERANCE * impulse {
            break;
        }
    }
    let (slow, slow_rim) = (1.0 + multiplier, 1.0 + multiplier * stiffness);
    moved(motion, speed / slow, rim / slow_rim, dt)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_core::slider::SliderParameters;

    fn slider() -> Slider<f64, CoulombDisk> {
        Slider::new(
            CoulombDisk,
            SliderParameters {
                deceleration: DISK.deceleration,
                radius: DISK.radius,
                inertia_ratio: DISK.inertia_ratio,
            },
        )
        .unwrap()
    }

    #[test]
    fn exact_and_small_steps_meet() {
        let launch = SliderState::launched(SPEED, 12.5);
        let exact = Stepper::ToRest.stop(&slider(), &launch);
        assert!((exact.time - 0.45542).abs() < 1e-5 && (exact.distance - 0.21658).abs() < 1e-5);
        let advanced = Stepper::Advance(1e-3).stop(&slider(), &launch);
        assert!((advanced.distance - exact.distance).abs() < 1e-11);
        let verlet = Stepper::Verlet(1e-4).stop(&slider(), &launch);
        assert!((verlet.distance - exact.distance).abs() < 1e-5);
        let implicit = Stepper::Implicit(1e-3).stop(&slider(), &launch);
        assert!((implicit.distance - exact.distance).abs() < 1e-6);
        assert!((implicit.time - exact.time).abs() < 1e-6);
        let explicit = Stepper::Explicit(1e-4).stop(&slider(), &launch);
        assert!((explicit.distance - exact.distance).abs() < 1e-4);
    }

    #[test]
    fn comparators_stop_where_their_own_laws_say() {
        // Without spin all laws agree: v²/(2 μ g), v/(μ g).
        let launch = SliderState::launched(SPEED, 0.0);
        for stepper in [
            Stepper::Explicit(1e-5),
            Stepper::Decoupled(1e-5),
            Stepper::Ellipsoid(1e-5),
        ] {
            let stop = stepper.stop(&slider(), &launch);
            assert!((stop.distance - 0.5 / DISK.deceleration).abs() < 1e-5);
            assert!((stop.time - 1.0 / DISK.deceleration).abs() < 3e-5);
        }
    }

    #[test]
    fn the_ellipsoid_keeps_its_impulse_on_the_boundary() {
        let before = SliderState::launched(SPEED, 12.5);
        let after = dissipated(&before, 1e-3);
        let force = before.speed - after.speed;
        let torque = DISK.inertia_ratio * DISK.radius * (before.spin - after.spin);
        let impulse = DISK.deceleration * 1e-3;
        let norm = force.hypot(torque / PURE_SPIN_TORQUE);
        assert!((norm / impulse - 1.0).abs() < 1e-9, "{norm} {impulse}");
    }
}
