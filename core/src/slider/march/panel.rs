//! One panel: sixteen directions, eight in single precision, and what they say of the time and the
//! paths between its ends.

use super::super::direction_arc::DirectionArc;
use super::super::gauss_legendre::{self, Rule, rule};
use super::{DecayRates, LARGEST_FADING, PanelIntegration};
use crate::coupling::{DominantSpeed, PowerLawFriction, ReducedFriction};
use crate::real::Real;

/// Truncation error of a panel, in rounding errors.
const TOLERANCE_ULPS: f64 = 4.0;
/// Coefficients that do not fall off are noise if they are this small: a rounding error to the power 0.6.
static NOISE_LEVEL: [[f64; 1]; 1] = [[4.05381695970951e-10]];
static NOISE_LEVEL_SINGLE: [[f32; 1]; 1] = [[7.011_098e-5]];
/// Noise of C_α − C beyond this part of it is not excused.
const MOST_NOISE: f64 = 0.03125;

/// What the nodes of a panel say.
pub(super) struct Panel<R, const N: usize> {
    /// Increments of `faded`.
    pub faded: [R; 2],
    /// Increments of `sums`.
    pub sums: [R; 3],
    /// Time integrand at the nodes.
    pub times: [R; N],
    /// Rates and ds/dp at the last node.
    pub rates: DecayRates<R>,
    pub slowness: R,
    /// Largest exponent by which an integrand would fall over the panel, as steep as at its worst node.
    pub fading: R,
    pub is_resolved: bool,
}

impl<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>, const N: usize>
    PanelIntegration<'_, R, P, N>
{
    /// Longest panel that may fit.
    pub(super) fn longest(&self, leg: &DirectionArc<R>) -> R {
        let smooth = leg.smooth_length();
        let fastest = self.fastest(self.rates);
        let by_fading = R::from_f64(LARGEST_FADING) / (fastest * self.slowness);
        if by_fading < smooth {
            by_fading
        } else {
            smooth
        }
    }

    /// Evaluates the panel of length `size` ahead.
    pub(super) fn panel(&mut self, leg: &DirectionArc<R>, size: R) -> Panel<R, N> {
        let Rule { nodes, weights, .. } = rule::<R, N>();
        let half = R::HALF * size;
        let step = if leg.rising { -half } else { half };
        let [mut slides, mut rims] = [[R::ZERO; N]; 2];
        let mut times = [R::ZERO; N];
        let (mut rates, mut slowness, mut growth) = (self.rates, self.slowness, R::ONE);
        for (((slide, rim), time), node) in
            slides.iter_mut().zip(&mut rims).zip(&mut times).zip(nodes)
        {
            let place = leg.place(leg.p + step * (R::ONE + *node));
            let here;
            (rates, [slowness, here]) = self.measured(leg, &place);
            growth = if here > growth { here } else { growth };
            *time = slowness * half;
            *slide = *time * rates[0];
            *rim = *time * rates[1];
        }
        let faded = [
            gauss_legendre::integral(&slides),
            gauss_legendre::integral(&rims),
        ];
        let fading = slides
            .iter()
            .zip(&rims)
            .fold(R::ZERO, |most, (slide, rim)| {
                let steepest = R::TWO * self.fastest([*slide, *rim]);
                // True for NaN too.
                if steepest <= most { most } else { steepest }
            });
        let is_resolved = self.is_resolved(&[slides, rims], faded, growth);
        let mut sums = [R::ZERO; 3];
        // The pace of α = 0 is the larger speed itself, (m/m₀) = (m₁/m₀) e^(−fading).
        let start = self.leading(self.offsets).exp();
        let (at_slides, at_rims) = (
            gauss_legendre::running(&slides),
            gauss_legendre::running(&rims),
        );
        for (((time, weight), slide), rim) in
            times.iter_mut().zip(weights).zip(at_slides).zip(at_rims)
        {
            let faded = [self.faded[0] + slide, self.faded[1] + rim];
            let [slide, rim] = faded.map(|faded| (-faded).exp());
            let pace = if R::IS_SINGLE && self.beta == R::ONE {
                start * self.leading([slide, rim])
            } else {
                self.pace(faded)
            };
            *time *= pace;
            let part = *time * *weight;
            sums[0] += part;
            for ((sum, left), is_growing) in sums
                .iter_mut()
                .skip(1)
                .zip([slide, rim])
                .zip(self.growing.iter().skip(1))
            {
                if *is_growing {
                    *sum += part * left;
                }
            }
        }
        Panel {
            faded,
            sums,
            times,
            rates,
            slowness,
            fading,
            is_resolved,
        }
    }

    /// True if the nodes resolve the rates of the speeds that still matter, or all but the
    /// rounding errors of the law times `growth`.
    pub(super) fn is_resolved(&self, rates: &[[R; N]; 2], faded: [R; 2], growth: R) -> bool {
        let ulps = R::from_f64(TOLERANCE_ULPS) * R::EPSILON;
        let [[noise_level]] = *R::pick(&NOISE_LEVEL_SINGLE, &NOISE_LEVEL);
        let leads = [
            self.lead == DominantSpeed::Sliding,
            self.lead == DominantSpeed::Spinning,
        ];
        let matters = [self.growing[1] || leads[0], self.growing[2] || leads[1]];
        rates
            .iter()
            .zip(faded)
            .zip(matters)
            .all(|((rates, total), matters)| {
                let [middle, end] = gauss_legendre::decay(rates);
                let scale = if total > R::ONE { total } else { R::ONE };
                let is_small = end < noise_level * total;
                let fall = if end < middle { end / middle } else { R::ONE };
                let error = end * fall * fall;
                let is_noise = end > R::HALF * R::HALF * middle && is_small;
                let part = ulps * growth;
                let most = R::from_f64(MOST_NOISE);
                let noise = (if part < most { part } else { most }) * total;
                // Few nodes tell noise, which is in all coefficients, from a slow fall by its size alone.
                let noisy = if R::IS_SINGLE { end } else { error };
                !matters || error <= ulps * scale || noisy <= noise || is_noise
            })
    }
}
