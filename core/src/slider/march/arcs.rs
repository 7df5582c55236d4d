//! The stretches of directions that a motion runs through, one after the other.

use super::super::Slider;
use super::super::direction_arc::{ArcEnd, DirectionArc};
use super::{DecayRates, PanelIntegration};
use crate::coupling::{DominantSpeed, PowerLawFriction, ReducedFriction, Speeds};
use crate::modes::{balanced_ratio, changes_sign};
use crate::real::Real;

/// |C_α − C| at equal speeds, in rounding errors of C, below which they stay equal.
const BALANCED_ULPS: f64 = 8.0;

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>, const N: usize>
    PanelIntegration<'_, R, P, N>
{
    /// Finds the first leg, from the ratio h with its logarithm and its distance from 1.
    pub(super) fn first_arc(&mut self, ratio: [R; 3], excess: R) {
        let lead = self.lead;
        let at_ends = self.at_ends(lead);
        for other in [DominantSpeed::Spinning, DominantSpeed::Sliding] {
            let (rates, _) = self.rates_and_excess(&Speeds::from_ratio(other, R::ZERO));
            self.bound(rates);
        }
        let rising = (excess > R::ZERO) == (lead == DominantSpeed::Spinning);
        let [at_zero, at_one] = at_ends;
        let balance = changes_sign(at_zero, at_one).then(|| self.balance(lead, at_ends));
        let (zero, one) = (R::ZERO, R::ONE);
        let ends = match balance {
            // The sign changes at the fixed point.
            Some(fixed) if changes_sign(excess, at_one) => [zero, fixed],
            Some(fixed) => [fixed, one],
            None => [zero, one],
        };
        let keeps_equal =
            at_one.abs() <= R::from_f64(BALANCED_ULPS) * R::EPSILON * self.slider.inertia_ratio;
        let end = if rising && ends[1] == one && !keeps_equal {
            ArcEnd::EqualSpeeds
        } else {
            ArcEnd::Settled
        };
        let leg = DirectionArc::new(lead, ends, rising, end, ratio);
        (_, [self.slowness, _]) = self.measured(&leg, &leg.place(leg.p));
        self.leg = Some(leg);
        self.target_ratio();
    }

    /// C_α − C at h = 0 and 1.
    pub(super) fn at_ends(&mut self, lead: DominantSpeed) -> [R; 2] {
        let c = self.slider.inertia_ratio;
        let [spinning, sliding] = self.slider.profile.inertia_ends();
        let (rates, at_one) = self.rates_and_excess(&Speeds::from_ratio(lead, R::ONE));
        self.bound(rates);
        let at_zero = match lead {
            DominantSpeed::Spinning => spinning - c,
            DominantSpeed::Sliding => sliding - c,
        };
        [at_zero, at_one]
    }

    /// The fixed point of a side.
    pub(super) fn balance(&mut self, lead: DominantSpeed, at_ends: [R; 2]) -> R {
        let Slider {
            profile,
            inertia_ratio,
            ..
        } = self.slider;
        let (ratio, evaluations) = balanced_ratio(profile, *inertia_ratio, lead, at_ends);
        self.evaluations += evaluations;
        ratio
    }

    /// Goes on beyond equal speeds.
    pub(super) fn cross(&mut self) {
        self.lead = match self.lead {
            DominantSpeed::Spinning => DominantSpeed::Sliding,
            DominantSpeed::Sliding => DominantSpeed::Spinning,
        };
        let at_ends = self.at_ends(self.lead);
        let bottom = if changes_sign(at_ends[0], at_ends[1]) {
            self.balance(self.lead, at_ends)
        } else {
            R::ZERO
        };
        self.leg = Some(DirectionArc::from_equal(self.lead, bottom));
        self.slowness = R::ZERO;
        self.target_ratio();
    }

    /// The ratio to which the present leg leads.
    pub(super) fn target_ratio(&mut self) {
        if let Some(leg) = &self.leg {
            let limit = leg.limit();
            self.ratio = match self.lead {
                DominantSpeed::Spinning => limit,
                DominantSpeed::Sliding => R::ONE / limit,
            };
        }
    }

    pub(super) fn bound(&mut self, rates: DecayRates<R>) {
        for ((least, most), rate) in self.least.iter_mut().zip(&mut self.most).zip(rates) {
            let (half, twice) = (R::HALF * rate, R::TWO * rate);
            *least = if half < *least { half } else { *least };
            *most = if twice > *most { twice } else { *most };
        }
    }
}
