//! A motion over a given time: one Runge–Kutta step if it is short, the way to rest otherwise.

use super::march::{March, Outcome, Until};
use super::rest::Rest;
use super::runge_kutta;
use super::{Motion, Slider};
use crate::coupling::{Coupling, Profile, Speeds};
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
    /// Evaluations of the wrench.
    pub evaluations: u32,
}

/// Fading of the faster speed up to which one Runge–Kutta step can be exact.
const SHORT: f64 = 1.0 / 64.0;
/// Evaluations of a Runge–Kutta step and of the rates before it.
const STEP_EVALUATIONS: u32 = 8;
/// Its local error, in rounding errors.
const STEP_ULPS: f64 = 0.5;

impl<R: Real, P: Profile<R> + Coupling<R>> Slider<R, P> {
    /// Advances by `duration`, through rest if it comes.
    ///
    /// *Domain*: `duration` ≥ 0 and finite; a body at rest stays there. Where speeds, rates or
    /// their ratios leave the number range, or a profile of one's own is too rough to be
    /// integrated, speed and spin are NaN.
    /// *Accuracy*: as [`Slider::to_rest`], 1e-13 relative in each of distance and angle; speed and
    /// spin 1e-13 times the time to rest over the time left.
    /// *Cost*: 8 evaluations of the wrench while the speeds change by less than about a hundredth, as in
    /// a controller; some 50 to 250 otherwise.
    pub fn advance(&self, motion: &Motion<R>, duration: R) -> Advance<R> {
        let speeds = [motion.speed.abs(), (motion.spin * self.radius).abs()];
        let moves = (speeds[0] > R::ZERO || speeds[1] > R::ZERO) && duration > R::ZERO;
        let later = motion.time + duration;
        if !moves {
            let motion = Motion {
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
        if let Some([slide, rim, distance, angle]) = self.short_step(speeds, time) {
            let motion = self.after(motion, [slide, rim], [time, distance, angle]);
            return Advance {
                motion: Motion {
                    time: later,
                    ..motion
                },
                rest: None,
                evaluations: STEP_EVALUATIONS,
            };
        }
        let is_finite = speeds[0].is_finite() && speeds[1].is_finite() && time.is_finite();
        if !is_finite {
            return lost(motion, later, 0);
        }
        let mut march = March::new(self, speeds);
        match march.go(Until::Time(time)) {
            Outcome::Time => Advance {
                motion: Motion {
                    time: later,
                    ..self.after(motion, march.faded, march.sums)
                },
                rest: None,
                evaluations: march.evaluations,
            },
            Outcome::Rest => {
                let rest = self.rest_of(motion, &march);
                Advance {
                    motion: Motion {
                        time: later,
                        ..rest.motion
                    },
                    rest: Some(rest),
                    evaluations: march.evaluations,
                }
            }
            Outcome::Unfit => lost(motion, later, march.evaluations),
        }
    }

    /// What one Runge–Kutta step over a time in units of m₀^(1−α)/κ gives, if it is exact: ln v₀/v, ln w₀/w
    /// and the two paths in units of v₀ and w₀.
    fn short_step(&self, speeds: [R; 2], time: R) -> Option<[R; 4]> {
        let at = Speeds::new(speeds[0], speeds[1]);
        let [slide, rim] = self.fading_rates(&at);
        let fastest = if slide > rim { slide } else { rim };
        // False for NaN.
        let is_short = fastest * time <= R::from_f64(SHORT);
        if !is_short {
            return None;
        }
        let major = if speeds[0] > speeds[1] {
            speeds[0]
        } else {
            speeds[1]
        };
        let alpha = self.profile.exponent();
        let derivative = |y: &[R; 4]| {
            let [v, w] = [(-y[0]).exp(), (-y[1]).exp()];
            let at = Speeds::new(speeds[0] * v, speeds[1] * w);
            let [slide, rim] = self.fading_rates(&at);
            let pace = (at.major() / major).pow(alpha - R::ONE);
            [slide * pace, rim * pace, v, w]
        };
        let (end, error) = runge_kutta::step(&[R::ZERO; 4], time, derivative);
        let most = R::from_f64(STEP_ULPS) * R::EPSILON;
        let is_exact = error[0].abs() <= most
            && error[1].abs() <= most
            && error[2].abs() <= most * end[2]
            && error[3].abs() <= most * end[3];
        is_exact.then_some(end)
    }

    /// Φ and Χ/C.
    fn fading_rates(&self, at: &Speeds<R>) -> [R; 2] {
        let [phi, chi] = self.profile.factors(at);
        [phi, chi / self.inertia_ratio]
    }
}

/// Out of range: no number rather than a wrong one.
fn lost<R: Real>(motion: &Motion<R>, later: R, evaluations: u32) -> Advance<R> {
    Advance {
        motion: Motion {
            time: later,
            speed: R::NAN,
            spin: R::NAN,
            ..*motion
        },
        rest: None,
        evaluations,
    }
}
