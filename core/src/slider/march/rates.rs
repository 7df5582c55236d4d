//! Rates of fading, and how fast the integrands fall with them.

use super::super::direction_arc::{ArcPoint, DirectionArc};
use super::{DecayRates, PanelIntegration};
use crate::coupling::{DominantSpeed, PowerLawFriction, ReducedFriction, Speeds};
use crate::real::Real;

/// Exponents this close to 1 leave C_α flat, so that all of C_α − C may be a small difference.
const NEARLY_LINEAR: f64 = 0.125;
/// C_α − C is a small difference below this part of C.
const CANCELS: f64 = 1.0 / 64.0;
/// |C_α − C| below this part of a rounding error of C is taken as if it were this large.
const LEAST_EXCESS: f64 = 1.0 / 16.0;

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>, const N: usize>
    PanelIntegration<'_, R, P, N>
{
    /// Rates of fading, and C_α − C.
    pub(super) fn rates_and_excess(&mut self, at: &Speeds<R>) -> (DecayRates<R>, R) {
        let (profile, c) = (&self.slider.profile, self.slider.inertia_ratio);
        let [phi, chi] = profile.factors(at);
        self.evaluations += 1;
        let plain = chi / phi - c;
        let excess = if plain.abs() > R::from_f64(CANCELS) * c {
            plain
        } else if self.beta.abs() < R::from_f64(NEARLY_LINEAR) {
            self.evaluations += 1;
            profile.inertia_excess(at, c)
        } else {
            plain
        };
        ([phi, chi / c], excess)
    }

    /// Rates, ds/|dp|, and C/|C_α − C|, the factor by which the last grows the error of the law.
    pub(super) fn measured(
        &mut self,
        leg: &DirectionArc<R>,
        place: &ArcPoint<R>,
    ) -> (DecayRates<R>, [R; 2]) {
        let ([slide, rim], excess) = self.rates_and_excess(&place.at);
        let c = self.slider.inertia_ratio;
        let least = R::from_f64(LEAST_EXCESS) * R::EPSILON * c;
        let along = leg.sign() * excess;
        let along = if along < least { least } else { along };
        let growth = c / along;
        ([slide, rim], [place.share * growth / slide, growth])
    }

    /// Rates at which the three integrands fall under rates of fading of v and w.
    pub(super) fn falls(&self, rates: DecayRates<R>) -> [R; 3] {
        let pace = self.beta * self.leading(rates);
        [pace, rates[0] + pace, rates[1] + pace]
    }

    /// The fastest of those that matter.
    pub(super) fn fastest(&self, rates: DecayRates<R>) -> R {
        let falls = self.falls(rates).into_iter().zip(self.growing);
        falls.fold(R::ZERO, |most, (fall, is_growing)| {
            let is_less = fall.abs() <= most;
            // NaN counts as the fastest.
            if is_less || !is_growing {
                most
            } else {
                fall.abs()
            }
        })
    }

    /// The one of v and w that leads.
    pub(super) fn leading(&self, [slide, rim]: [R; 2]) -> R {
        match self.lead {
            DominantSpeed::Sliding => slide,
            DominantSpeed::Spinning => rim,
        }
    }

    /// (m/m₀)^(1−α) after the given fading.
    pub(super) fn pace(&self, faded: [R; 2]) -> R {
        let ln_major = self.leading(self.offsets) - self.leading(faded);
        (self.beta * ln_major).exp()
    }
}
