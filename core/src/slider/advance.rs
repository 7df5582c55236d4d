//! The exact stepper in time: step sizes that shrink with the motion.
//!
//! Friction of degree α makes the equations invariant under a common scale s of all speeds with
//! times measured in s^(1−α)/κ. Each substep starts at (v, w)/s, a unit vector, and covers at most
//! half of what is left; where rest comes within the step the way to rest takes over.

use super::rest::Rest;
use super::runge_kutta;
use super::{Motion, Slider};
use crate::coupling::{Coupling, Profile, ReducedWrench};
use crate::real::Real;

/// What [`Slider::advance`] returns.
///
/// ```
/// use tribos_core::coupling::table::Coulomb;
/// use tribos_core::slider::{Advance, Motion, Slider};
/// let puck = Slider::new(Coulomb, 3.0_f64, 0.08, 0.5)?; // μ g in m/s², m
/// // Without spin it slows down evenly: v = v₀ − μ g t, and stops after v₀/(μ g).
/// let start = Motion::launched(1.2, 0.0); // m/s
/// let Advance { motion, rest, .. } = puck.advance(&start, 0.1); // s
/// assert!((motion.speed - 0.9).abs() < 1e-13 && (motion.distance - 0.105).abs() < 1e-14);
/// assert!(rest.is_none());
/// let stops = puck.advance(&start, 1.0);
/// assert!(stops.motion.is_at_rest());
/// assert!(stops.rest.is_some_and(|rest| (rest.motion.time - 0.4).abs() < 1e-13));
/// # Ok::<(), tribos_core::slider::SliderError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Advance<R> {
    /// The motion at the end of the step.
    pub motion: Motion<R>,
    /// Set in the step in which the body comes to rest.
    pub rest: Option<Rest<R>>,
    /// Substeps taken.
    pub substeps: u32,
}

/// First substep in units of s^(1−α)/κ.
const FIRST: f64 = 1.0 / 16.0;
/// Largest substep as a fraction of the fading time along the present direction.
const LARGEST_FRACTION: f64 = 0.5;
/// More substeps than a step can need: about 150 for each e-fold of the speeds, of which f64
/// holds 1,400.
const MAX_SUBSTEPS: u32 = 250_000;
/// A substep that must be shorter than this makes no progress: the rates are not finite.
const SHORTEST: f64 = 1e-30;

impl<R: Real, P: Profile<R> + Coupling<R>> Slider<R, P> {
    /// Advances by `duration`, to rounding accuracy, through rest if it comes.
    ///
    /// *Domain*: `duration` ≥ 0 and finite; a body at rest stays there. Where speeds, rates or
    /// their ratios leave the number range, speed and spin are NaN.
    /// *Accuracy*: about 1e-14 relative for each e-fold of the speeds (f64).
    /// *Cost*: one substep (7 wrenches) if `duration` is short against the time to rest.
    pub fn advance(&self, motion: &Motion<R>, duration: R) -> Advance<R> {
        let mut run = Run::new(self, motion, duration);
        let rest = run.go();
        let mut after = match &rest {
            Some(rest) => rest.motion,
            None => run.motion,
        };
        after.time = motion.time + duration;
        Advance {
            motion: after,
            rest,
            substeps: run.substeps,
        }
    }
}

/// One call's progress.
struct Run<'a, R, P> {
    slider: &'a Slider<R, P>,
    motion: Motion<R>,
    /// Time still to go.
    left: R,
    /// False once the way to rest has been found longer than the time left.
    may_rest: bool,
    size: R,
    substeps: u32,
}

impl<'a, R: Real, P: Profile<R> + Coupling<R>> Run<'a, R, P> {
    fn new(slider: &'a Slider<R, P>, motion: &Motion<R>, duration: R) -> Self {
        Self {
            slider,
            motion: *motion,
            left: duration,
            may_rest: slider.profile.exponent() < R::ONE,
            size: R::from_f64(FIRST),
            substeps: 0,
        }
    }

    /// Goes on until the time is over or the body rests.
    fn go(&mut self) -> Option<Rest<R>> {
        let beta = R::ONE - self.slider.profile.exponent();
        while self.substeps < MAX_SUBSTEPS && self.size > R::from_f64(SHORTEST) {
            let rim = (self.motion.spin * self.slider.radius).abs();
            let scale = self.motion.speed.hypot(rim);
            // False for NaN too.
            let moving = self.left > R::ZERO && scale > R::ZERO;
            if !moving {
                return None;
            }
            let unit = [self.motion.speed / scale, rim / scale];
            let time_unit = scale.pow(beta) / self.slider.deceleration;
            let [a, b] = self.rates(&unit);
            let fading = -R::ONE / (a * unit[0] + b * unit[1]);
            if self.may_rest && time_unit * fading <= beta * self.left {
                let rest = self.slider.to_rest(&self.motion)?;
                self.substeps += rest.substeps;
                if rest.motion.time - self.motion.time <= self.left {
                    return Some(rest);
                }
                self.may_rest = false;
            }
            if scale < R::MIN_POSITIVE / R::EPSILON {
                return None;
            }
            let limit = R::from_f64(LARGEST_FRACTION) * fading;
            self.size = if self.size > limit { limit } else { self.size };
            self.substep(scale, unit, time_unit);
        }
        // Out of range: no number rather than a wrong one.
        self.motion.speed = R::NAN;
        self.motion.spin = self.motion.speed;
        None
    }

    /// Derivatives of the scaled velocities.
    fn rates(&self, v: &[R; 2]) -> [R; 2] {
        let ReducedWrench { force, torque } = self.slider.profile.reduced_wrench(v[0], v[1]);
        [-force, -torque / self.slider.inertia_ratio]
    }

    /// Tries a substep of the present size, or of the time left.
    fn substep(&mut self, scale: R, unit: [R; 2], time_unit: R) {
        self.substeps += 1;
        let left = self.left / time_unit;
        let last = left <= self.size;
        let h = if last { left } else { self.size };
        let from = [unit[0], unit[1], R::ZERO, R::ZERO];
        let (to, error) = runge_kutta::step(&from, h, |y| {
            let [a, b] = self.rates(&[y[0], y[1]]);
            [a, b, y[0], y[1]]
        });
        let (a, b) = (error[0].abs(), error[1].abs());
        let largest = if a > b || a.is_nan() { a } else { b };
        let admissible = to[0] >= R::ZERO && to[1] >= R::ZERO;
        let (accepted, factor) = runge_kutta::judge(largest, runge_kutta::tolerance(), admissible);
        if accepted {
            let radius = self.slider.radius;
            let path = scale * time_unit;
            self.motion.speed = scale * to[0];
            self.motion.distance += path * to[2];
            self.motion.angle += (path * to[3] / radius).copysign(self.motion.spin);
            self.motion.spin = (scale * to[1] / radius).copysign(self.motion.spin);
            let elapsed = h * time_unit;
            self.motion.time += elapsed;
            self.left = if last { R::ZERO } else { self.left - elapsed };
        }
        self.size = h * factor;
    }
}
