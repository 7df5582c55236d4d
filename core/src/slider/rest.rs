//! A motion followed to rest.

use super::march::{IntegrationTarget, Outcome, PanelResult, march};
use super::{Slider, SliderState};
use crate::coupling::{PowerLawFriction, ReducedFriction};
use crate::real::Real;

/// The end of a motion.
///
/// ```
/// use tribos_core::prelude::*;
/// use tribos_core::{modes::TerminalMotion, slider::SliderRest};
/// let deceleration = 0.3 * 9.81; // m/s²
/// let puck = SliderParameters { deceleration, radius: 0.08, inertia_ratio: 0.5_f64 };
/// let puck = Slider::new(CoulombDisk, puck)?;
/// let last = TerminalMotion::new(CoulombDisk, 0.5)?.finite_fixed_point().unwrap_or(f64::NAN);
/// // However it is thrown, sliding and spinning end together, in one ratio.
/// for (speed, spin) in [(2.0, 1.0), (0.1, 40.0)] {
///     let rest: Option<SliderRest<f64>> = puck.to_rest(&SliderState::launched(speed, spin)); // m/s, rad/s
///     assert!(rest.is_some_and(|rest| (rest.ratio - last).abs() < 1e-12));
/// }
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SliderRest<R> {
    /// Time, distance and angle at rest; speeds zero.
    pub motion: SliderState<R>,
    /// Velocity ratio ε in the limit of rest: the finite fixed point of [`crate::modes::TerminalMotion`], 0 or ∞.
    pub ratio: R,
    /// Evaluations of the wrench.
    pub evaluations: u32,
}

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>> Slider<R, P> {
    /// Follows the motion to rest. `None` for α ≥ 1, which never rests in finite time, for a motion
    /// that is not finite, and for a profile of one's own that is too rough to be integrated.
    ///
    /// *Accuracy*: 1e-13 relative in each of time, distance and angle, whichever of the two motions
    /// dies first and however small it is (f64; tested for −0.9 ≤ α < 1, 1e-4 ≤ C ≤ 1e4 and speeds
    /// of any ratio); 1e-8 for an annulus, whose inner edge is one more kink of the law (tested to 1e-11 for
    /// inner radii of 0.1 to 0.99 and the same launches). In f32 5e-6 (tested for 0.01 ≤ C ≤ 100), 1e-5
    /// where C is within 1e-3 of C_α at equal speeds. The ratio is that of [`crate::modes::TerminalMotion`].
    /// *Cost*: 160 evaluations of the wrench at the median of random launches, seldom more than 500; up to
    /// 2,200 where α is within 1e-2 of 1 or −1 is near, and for an annulus, whose inner edge is one more
    /// kink. In f32, whose panels have 8 nodes instead of 16, 90 on average and seldom more than 300.
    pub fn to_rest(&self, motion: &SliderState<R>) -> Option<SliderRest<R>> {
        let speeds = [motion.speed.abs(), (motion.spin * self.radius).abs()];
        let is_finite = speeds[0].is_finite() && speeds[1].is_finite();
        if self.profile.exponent() >= R::ONE || !is_finite {
            return None;
        }
        if speeds == [R::ZERO; 2] {
            return Some(SliderRest {
                motion: *motion,
                ratio: speeds[0] / speeds[1],
                evaluations: 0,
            });
        }
        let marched = march(self, speeds, IntegrationTarget::Rest);
        match marched.outcome {
            Outcome::Rest => Some(self.rest_of(motion, &marched)),
            Outcome::Time | Outcome::Unfit => None,
        }
    }

    /// The rest to which a march has come.
    pub(super) fn rest_of(
        &self,
        motion: &SliderState<R>,
        marched: &PanelResult<R>,
    ) -> SliderRest<R> {
        let after = self.after(motion, marched.faded, marched.sums);
        SliderRest {
            motion: SliderState {
                speed: R::ZERO,
                spin: R::ZERO,
                ..after
            },
            ratio: marched.ratio,
            evaluations: marched.evaluations,
        }
    }

    /// The motion after the speeds have faded from `motion` by these logarithms, with these sums.
    pub(super) fn after(
        &self,
        motion: &SliderState<R>,
        faded: [R; 2],
        sums: [R; 3],
    ) -> SliderState<R> {
        self.moved(motion, faded.map(|faded| (-faded).exp()), sums)
    }

    /// The motion of which these parts of the speeds are left, with these sums.
    pub(super) fn moved(
        &self,
        motion: &SliderState<R>,
        kept: [R; 2],
        sums: [R; 3],
    ) -> SliderState<R> {
        let [time, distance, angle] = sums;
        let [slide, rim] = kept;
        let unit = self.time_unit(motion);
        SliderState {
            time: motion.time + unit.of(time),
            speed: motion.speed * slide,
            spin: motion.spin * rim,
            distance: motion.distance + unit.of(motion.speed * distance),
            angle: motion.angle + unit.of(motion.spin * angle),
        }
    }

    /// m^(1−α)/κ, where m is the larger speed.
    pub(super) fn time_unit(&self, motion: &SliderState<R>) -> TimeUnit<R> {
        let rim = (motion.spin * self.radius).abs();
        let major = if motion.speed > rim {
            motion.speed
        } else {
            rim
        };
        let beta = R::ONE - self.profile.exponent();
        let power = if beta == R::ONE {
            major
        } else {
            major.pow(beta)
        };
        if power >= R::MIN_POSITIVE && power.is_finite() {
            TimeUnit([power, R::ONE, R::ONE / self.deceleration])
        } else {
            let half = if beta == R::ONE {
                major.sqrt()
            } else {
                major.pow(R::HALF * beta)
            };
            TimeUnit([half, half, R::ONE / self.deceleration])
        }
    }
}

/// Factors of a unit of time, whose product may leave the number range where a time does not.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeUnit<R>([R; 3]);

impl<R: Real> TimeUnit<R> {
    /// `x` in this unit, as a time.
    fn of(self, x: R) -> R {
        let [a, b, c] = self.0;
        x * a * c * b
    }

    /// A time in this unit.
    pub fn measure(self, time: R) -> R {
        let [a, b, c] = self.0;
        time / a / c / b
    }
}
