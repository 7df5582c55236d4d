//! The end of a march: rest, or the time asked for.

use super::super::direction_arc::DirectionArc;
use super::super::final_decay::FinalDecay;
use super::super::gauss_legendre::{self};
use super::panel::Panel;
use super::{IntegrationTarget, Outcome, PanelIntegration};
use crate::coupling::{PowerLawFriction, ReducedFriction, Speeds};
use crate::real::Real;

/// Newton's method for a time within a panel: two are enough.
const MOST_CORRECTIONS: u32 = 8;
/// Fading, in units of the root of a rounding error, over which the rates count as constant.
const LINEAR: f64 = 0.125;
/// And where rounding errors of C_α − C next to a fixed point keep the time from being met: the square
/// of this, halved, in rounding errors is what it costs.
const NEARLY_LINEAR: f64 = 2.0;
/// Rounding errors of the fading itself, beyond which no correction helps.
const ROUNDING_ULPS: f64 = 64.0;

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>, const N: usize>
    PanelIntegration<'_, R, P, N>
{
    /// The rest of the motion, at or next to the ratio that stays.
    pub(super) fn close(
        &mut self,
        leg: Option<&DirectionArc<R>>,
        until: IntegrationTarget<R>,
    ) -> Outcome {
        let tail = match leg {
            Some(leg) => self.tail(leg),
            None => FinalDecay {
                here: self.rates,
                end: self.rates,
                settling: R::ZERO,
            },
        };
        let pace = self.pace(self.faded);
        let factors = [
            pace,
            pace * (-self.faded[0]).exp(),
            pace * (-self.faded[1]).exp(),
        ];
        let (here, end) = (self.falls(tail.here), self.falls(tail.end));
        let added = |to: [R; 3], parts: [R; 3]| {
            let [t, x, y] = to;
            let [a, b, c] = factors;
            [t + a * parts[0], x + b * parts[1], y + c * parts[2]]
        };
        let pairs = [[here[0], end[0]], [here[1], end[1]], [here[2], end[2]]];
        let whole = added(self.sums, pairs.map(|[here, end]| tail.all(here, end)));
        let time = match until {
            IntegrationTarget::Time(time) => time,
            IntegrationTarget::Rest => R::INFINITY,
        };
        let rests = self.beta > R::ZERO && whole[0] <= time;
        if rests {
            self.sums = whole;
            return Outcome::Rest;
        }
        let left = (time - self.sums[0]) / pace;
        let Some(s) = tail.inverse(here[0], end[0], left) else {
            return Outcome::Unfit;
        };
        let parts = pairs.map(|[here, end]| tail.until(here, end, s));
        self.sums = added(self.sums, parts);
        for (faded, more) in self.faded.iter_mut().zip(tail.faded(s)) {
            *faded += more;
        }
        Outcome::Time
    }

    /// Rates here and in the end of the leg, and how fast the one become the other.
    pub(super) fn tail(&mut self, leg: &DirectionArc<R>) -> FinalDecay<R> {
        let place = leg.place(leg.p);
        let (here, [slowness, _]) = self.measured(leg, &place);
        let limit = leg.limit();
        let at = Speeds::from_ratio(leg.lead, limit);
        let (end, _) = self.rates_and_excess(&at);
        // ds/d ln h: h² vanishes, or the distance from h₀ does.
        let turning = place.share / slowness;
        let settling = if limit == R::ZERO {
            R::TWO * turning
        } else {
            turning * place.at.ratio() / place.distance
        };
        FinalDecay {
            here,
            end,
            settling,
        }
    }

    /// Stops at a time within the panel of length `size`.
    pub(super) fn stop_within(
        &mut self,
        leg: &DirectionArc<R>,
        size: R,
        panel: &Panel<R, N>,
        time: R,
    ) -> Outcome {
        let left = time - self.sums[0];
        let node = gauss_legendre::inverse_integral(&panel.times, left);
        let mut size = R::HALF * (R::ONE + node) * size;
        for correction in 1..=MOST_CORRECTIONS {
            let panel = self.panel(leg, size);
            let faded = [
                self.faded[0] + panel.faded[0],
                self.faded[1] + panel.faded[1],
            ];
            let p = if leg.rising {
                leg.p - size
            } else {
                leg.p + size
            };
            let (rates, [slowness, _]) = self.measured(leg, &leg.place(p));
            let pace = self.pace(faded);
            let missing = (left - panel.sums[0]) / pace;
            let turn = missing * (rates[0] + rates[1] + self.falls(rates)[0].abs());
            let rounding = R::from_f64(ROUNDING_ULPS) * R::EPSILON * (faded[0] + faded[1]);
            let limit = if correction < MOST_CORRECTIONS {
                LINEAR
            } else {
                NEARLY_LINEAR
            };
            let linear = R::from_f64(limit) * R::EPSILON.sqrt() + rounding;
            // Not for NaN.
            if turn.abs() <= linear {
                self.sums = [
                    time,
                    self.sums[1] + panel.sums[1] + missing * pace * (-faded[0]).exp(),
                    self.sums[2] + panel.sums[2] + missing * pace * (-faded[1]).exp(),
                ];
                self.faded = [faded[0] + missing * rates[0], faded[1] + missing * rates[1]];
                return Outcome::Time;
            }
            size += missing / slowness;
        }
        Outcome::Unfit
    }
}
