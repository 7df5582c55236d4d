//! A motion over a given time: one Runge–Kutta step, or a few in single precision, if it is short;
//! the way to rest otherwise.

use super::eighth_order;
use super::march::{IntegrationTarget, Outcome, march};
use super::rest::SliderRest;
use super::runge_kutta;
use super::short_f32::ShortIntegration;
use super::{Slider, SliderState};
use crate::coupling::{PowerLawFriction, ReducedFriction, Speeds};
use crate::real::Real;

/// What [`Slider::advance`] returns.
///
/// ```
/// use tribos_core::prelude::*;
/// use tribos_core::slider::Advance;
/// let puck = SliderParameters { deceleration: 3.0_f64, radius: 0.08, inertia_ratio: 0.5 }; // m/s², m
/// let puck = Slider::new(CoulombDisk, puck)?;
/// // Without spin it slows down evenly: v = v₀ − μ g t, and stops after v₀/(μ g).
/// let start = SliderState::launched(1.2, 0.0); // m/s
/// let Advance { motion, rest, .. } = puck.advance(&start, 0.1); // s
/// assert!((motion.speed - 0.9).abs() < 1e-13 && (motion.distance - 0.105).abs() < 1e-14);
/// assert!(rest.is_none());
/// let stops = puck.advance(&start, 1.0);
/// assert!(stops.motion.is_at_rest());
/// assert!(stops.rest.is_some_and(|rest| (rest.motion.time - 0.4).abs() < 1e-13));
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Advance<R> {
    /// The motion at the end of the step.
    pub motion: SliderState<R>,
    /// Set in the step in which the body comes to rest.
    pub rest: Option<SliderRest<R>>,
    /// Evaluations of the wrench.
    pub evaluations: u32,
}

/// Fading of the faster speed up to which a step of order 5, and one of order 8, can be exact in f64.
const SHORT: f64 = 1.0 / 256.0;
const MIDDLING: f64 = 1.0 / 16.0;
/// Evaluations of a step of order 5 beside that at its start.
const STEP_EVALUATIONS: u32 = 6;
/// Truncation error of the logarithm of a speed, in rounding errors.
const SPEED_ULPS: f64 = 0.5;
/// Error of a path, which is relative, and of a change of speed: rounding errors of the estimate of order 8.
const CHANGE_ULPS: f64 = 16.0;
/// The error of a step of order 5 over its estimate, of order 4, in terms of the fading over the
/// distance from equal speeds; and if it comes near or passes them.
const SMOOTH_ERROR: f64 = 2.0;
const KINKED: f64 = 0.5;
const KINKED_ERROR: f64 = 16.0;

/// What short steps find, if they are exact.
struct ShortStepResult<R> {
    end: Option<ShortIntegration<R>>,
    evaluations: u32,
}

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>> Slider<R, P> {
    /// Advances by `duration`, through rest if it comes.
    ///
    /// *Domain*: `duration` ≥ 0 and finite; a body at rest stays there. Where speeds, rates or
    /// their ratios leave the number range, or a profile of one's own is too rough to be
    /// integrated, speed and spin are NaN.
    /// *Accuracy*: as [`Slider::to_rest`], 1e-13 relative in each of distance and angle; speed and
    /// spin 1e-13 times the time to rest over the time left. In f32 5e-6, and where it takes few steps
    /// 1e-6.
    /// *Cost*: 7 evaluations of the wrench while the speeds change by less than some thousandths, as in a
    /// controller; 12 up to a few hundredths; some 50 to 250 otherwise, and up to 20 more next to
    /// equal speeds. In f32 7 for each eighth by which the speeds change, some 50 to 150 for motions that
    /// come near to rest, and up to 110 more next to equal speeds.
    pub fn advance(&self, motion: &SliderState<R>, duration: R) -> Advance<R> {
        let speeds = [motion.speed.abs(), (motion.spin * self.radius).abs()];
        let moves = (speeds[0] > R::ZERO || speeds[1] > R::ZERO) && duration > R::ZERO;
        let later = motion.time + duration;
        if !moves {
            let motion = SliderState {
                time: later,
                ..*motion
            };
            return Advance {
                motion,
                rest: None,
                evaluations: 0,
            };
        }
        let time = self.time_unit(motion).measure(duration);
        let ShortStepResult { end, evaluations } = if R::IS_SINGLE {
            let (end, evaluations) = self.integrate_briefly(speeds, time);
            ShortStepResult { end, evaluations }
        } else {
            self.short_step(speeds, time)
        };
        if let Some(ShortIntegration { kept, paths }) = end {
            let motion = self.moved(motion, kept, [time, paths[0], paths[1]]);
            return Advance {
                motion: SliderState {
                    time: later,
                    ..motion
                },
                rest: None,
                evaluations,
            };
        }
        let is_finite = speeds[0].is_finite() && speeds[1].is_finite() && time.is_finite();
        if !is_finite {
            return out_of_range(motion, later, evaluations);
        }
        let mut marched = march(self, speeds, IntegrationTarget::Time(time));
        marched.evaluations += evaluations;
        match marched.outcome {
            Outcome::Time => Advance {
                motion: SliderState {
                    time: later,
                    ..self.after(motion, marched.faded, marched.sums)
                },
                rest: None,
                evaluations: marched.evaluations,
            },
            Outcome::Rest => {
                let rest = self.rest_of(motion, &marched);
                Advance {
                    motion: SliderState {
                        time: later,
                        ..rest.motion
                    },
                    rest: Some(rest),
                    evaluations: marched.evaluations,
                }
            }
            Outcome::Unfit => out_of_range(motion, later, marched.evaluations),
        }
    }

    /// Tries one Runge–Kutta step over a time in units of m₀^(1−α)/κ, in double precision.
    fn short_step(&self, speeds: [R; 2], time: R) -> ShortStepResult<R> {
        let at = Speeds::new(speeds[0], speeds[1]);
        let [slide, rim] = self.fading_rates(&at);
        let fastest = if slide > rim { slide } else { rim };
        let fading = fastest * time;
        let mut tried = ShortStepResult {
            end: None,
            evaluations: 1,
        };
        // False for NaN.
        let is_middling = fading <= R::from_f64(MIDDLING);
        if !is_middling {
            return tried;
        }
        let alpha = self.profile.exponent();
        let derivative = |y: &[R; 4]| {
            let [v, w] = [(-y[0]).exp(), (-y[1]).exp()];
            let now = Speeds::new(speeds[0] * v, speeds[1] * w);
            let [slide, rim] = self.fading_rates(&now);
            let pace = (now.major() / at.major()).pow(alpha - R::ONE);
            [slide * pace, rim * pace, v, w]
        };
        let first = [slide, rim, R::ONE, R::ONE];
        if fading <= R::from_f64(SHORT) {
            let (end, error) = runge_kutta::step_along(&[R::ZERO; 4], first, time, derivative);
            let nearness = R::from_f64(SMOOTH_ERROR) * fading / at.gap();
            let share = if nearness < R::from_f64(KINKED) {
                nearness
            } else {
                R::from_f64(KINKED_ERROR)
            };
            tried.evaluations += STEP_EVALUATIONS;
            if is_exact(&end, &error.map(|error| error * share)) {
                tried.end = Some(remaining_motion(end));
                return tried;
            }
        }
        let (end, error) = eighth_order::step(first, time, derivative);
        tried.evaluations += eighth_order::STAGES as u32 - 1;
        if is_exact(&end, &error) {
            tried.end = Some(remaining_motion(end));
        }
        tried
    }

    /// Φ and Χ/C.
    pub(super) fn fading_rates(&self, at: &Speeds<R>) -> [R; 2] {
        let [phi, chi] = self.profile.factors(at);
        [phi, chi / self.inertia_ratio]
    }
}

/// From ln v₀/v, ln w₀/w and the two paths in units of v₀ and w₀.
fn remaining_motion<R: Real>([slide, rim, distance, angle]: [R; 4]) -> ShortIntegration<R> {
    ShortIntegration {
        kept: [(-slide).exp(), (-rim).exp()],
        paths: [distance, angle],
    }
}

/// True if the error does not matter to any of the four.
fn is_exact<R: Real>(end: &[R; 4], error: &[R; 4]) -> bool {
    let speed = R::from_f64(SPEED_ULPS) * R::EPSILON;
    let change = R::from_f64(CHANGE_ULPS) * R::EPSILON;
    let bounds = [
        speed + change * end[0],
        speed + change * end[1],
        change * end[2],
        change * end[3],
    ];
    error
        .iter()
        .zip(bounds)
        .all(|(error, most)| error.abs() <= most)
}

/// Out of range: no number rather than a wrong one.
fn out_of_range<R: Real>(motion: &SliderState<R>, later: R, evaluations: u32) -> Advance<R> {
    Advance {
        motion: SliderState {
            time: later,
            speed: R::NAN,
            spin: R::NAN,
            ..*motion
        },
        rest: None,
        evaluations,
    }
}
