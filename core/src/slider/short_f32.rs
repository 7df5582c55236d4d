//! Short motions in single precision: Runge–Kutta steps of order 5, one after the other.
//!
//! In units of the speeds v₁, w₁ at the start of a step, and with speeds in units of the larger one at the start of
//! the motion and times accordingly, the equations of motion are
//!
//! ```text
//! v = v₁ (1 − y₀),     dy₀/dt = (1 − y₀) Φ m^(α−1),     ∫v dt = v₁ (t − y₂),     dy₂/dt = y₀
//! ```
//!
//! and the same for w with Χ/C, y₁ and y₃. No exponential is needed, and no power for α = 0. A step that changes the
//! speeds by an eighth is exact to rounding where force and torque are smooth.

use super::Slider;
use super::runge_kutta;
use crate::coupling::{PowerLawFriction, ReducedFriction, Speeds};
use crate::real::Real;

/// Fading of the faster speed in one step, and in the whole time at the rate of its start: beyond, rest
/// is near.
const LONGEST: f64 = 0.125;
const FARTHEST: f64 = 0.75;
/// Steps, refused ones included, after which the way to rest costs less.
const MOST_STEPS: u32 = 16;
/// Change of the step's size after one that was refused or taken.
const SHRINK: f64 = 0.25;
const GROW: f64 = 2.0;
/// Truncation error of a step in speeds and paths, in rounding errors.
const ULPS: f64 = 0.5;
/// The error of a step of order 5 over its estimate, of order 4, in terms of the fading over the
/// distance from equal speeds; and if it comes near or passes them. Measured against f64: a quarter of
/// either lets errors of ten rounding errors through.
const SMOOTH_ERROR: f64 = 1.0;
const KINKED: f64 = 0.5;
const KINKED_ERROR: f64 = 4.0;
/// Evaluations of a step beside that at its start.
const STEP_EVALUATIONS: u32 = 6;

/// What a motion has come to.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortIntegration<R> {
    /// v/v₀ and w/w₀.
    pub kept: [R; 2],
    /// Distance and angle in units of the first speeds.
    pub paths: [R; 2],
}

/// Rates at which speeds fade.
struct DecayRates<R> {
    rates: [R; 2],
    fastest: R,
    /// Distance of the speeds from each other over the larger one.
    gap: R,
}

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>> Slider<R, P> {
    /// Follows a motion for a time in units of m₀^(1−α)/κ, if a few steps do; and the evaluations.
    pub(super) fn integrate_briefly(
        &self,
        speeds: [R; 2],
        time: R,
    ) -> (Option<ShortIntegration<R>>, u32) {
        let major = Speeds::new(speeds[0], speeds[1]).major();
        let first = speeds.map(|speed| speed / major);
        let mut now = ShortIntegration {
            kept: [R::ONE; 2],
            paths: [R::ZERO; 2],
        };
        let mut fading = self.fading(first);
        let mut evaluations = 1;
        // False for NaN.
        let is_short = fading.fastest * time <= R::from_f64(FARTHEST);
        if !is_short {
            return (None, evaluations);
        }
        let (mut left, mut size) = (time, time);
        for _ in 0..MOST_STEPS {
            let longest = R::from_f64(LONGEST) / fading.fastest;
            size = if size < longest { size } else { longest };
            let is_last = size >= left;
            size = if is_last { left } else { size };
            let at = [first[0] * now.kept[0], first[1] * now.kept[1]];
            let step = self.one_step(at, &fading, size);
            evaluations += STEP_EVALUATIONS;
            let Some([slide, rim, distance, angle]) = step else {
                size *= R::from_f64(SHRINK);
                continue;
            };
            now.paths[0] += now.kept[0] * (size - distance);
            now.paths[1] += now.kept[1] * (size - angle);
            now.kept[0] *= R::ONE - slide;
            now.kept[1] *= R::ONE - rim;
            if is_last {
                return (Some(now), evaluations);
            }
            left -= size;
            size *= R::from_f64(GROW);
            fading = self.fading([first[0] * now.kept[0], first[1] * now.kept[1]]);
            evaluations += 1;
        }
        (None, evaluations)
    }

    /// y₀ to y₃ after one step, if it is exact.
    fn one_step(&self, at: [R; 2], fading: &DecayRates<R>, size: R) -> Option<[R; 4]> {
        let [slide, rim] = fading.rates;
        let start = [slide, rim, R::ZERO, R::ZERO];
        let (end, error) = runge_kutta::step_along(&[R::ZERO; 4], start, size, |y| {
            let [v, w] = [R::ONE - y[0], R::ONE - y[1]];
            let [slide, rim] = self.fading([at[0] * v, at[1] * w]).rates;
            [v * slide, w * rim, y[0], y[1]]
        });
        let nearness = R::from_f64(SMOOTH_ERROR) * fading.fastest * size;
        let share = if nearness < R::from_f64(KINKED) * fading.gap {
            nearness / fading.gap
        } else {
            R::from_f64(KINKED_ERROR)
        };
        let most = R::from_f64(ULPS) * R::EPSILON;
        let path = most * size;
        let [slide, rim, distance, angle] = error.map(|error| (error * share).abs());
        // False for NaN.
        let is_exact = slide <= most && rim <= most && distance <= path && angle <= path;
        is_exact.then_some(end)
    }

    fn fading(&self, [slide, rim]: [R; 2]) -> DecayRates<R> {
        let at = Speeds::new(slide, rim);
        let pace = self.profile.rate_scale(at.major());
        let rates = self.fading_rates(&at).map(|rate| rate * pace);
        let fastest = if rates[0] > rates[1] {
            rates[0]
        } else {
            rates[1]
        };
        DecayRates {
            rates,
            fastest,
            gap: at.gap(),
        }
    }
}
