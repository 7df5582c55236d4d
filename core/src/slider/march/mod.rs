//! A motion followed through its directions, panel by panel.
//!
//! With v, w ≥ 0 the two speeds, m the larger and h the smaller over the larger one, friction of degree
//! α gives F = m^(α−1) v Φ(h) and T = m^(α−1) w Χ(h) ([`crate::coupling::PowerLawFriction`]). In the
//! time s with ds = κ m^(α−1) dt both speeds fade with rates that depend on the direction alone,
//!
//! ```text
//! d ln v/ds = −Φ,     d ln w/ds = −Χ/C,     d ln(v/w)/ds = Φ (C_α − C)/C
//! ```
//!
//! so that the direction is the one unknown. With its coordinate p ([`super::leg`]) as the variable,
//! s(p), ln v, ln w and then
//!
//! ```text
//! κ t = ∫ m^(1−α) ds,     κ x = ∫ v m^(1−α) ds,     κ θR = ∫ w m^(1−α) ds
//! ```
//!
//! are integrals of positive functions, each with its own relative accuracy however small it is. A
//! rounding error of C_α − C moves s(p), and with it everything alike, so that it is as harmless as
//! the same error in the law.

mod arcs;
mod finish;
mod panel;
mod rates;

use super::Slider;
use super::direction_arc::{ArcEnd, DirectionArc};
use super::gauss_legendre::{FEW_POINTS, POINTS};
use crate::coupling::{DominantSpeed, PowerLawFriction, ReducedFriction, Speeds};
use crate::real::Real;
use panel::Panel;

/// Largest exponent by which an integrand may fall within a panel: exp(−8x) on it is exact to
/// 1e-19 of its largest value with 16 nodes, to 1e-9 with 8.
const LARGEST_FADING: f64 = 8.0;
/// A panel in which it falls by this much more is made anew.
const FADING_LIMIT: f64 = 1.5;
/// Beyond this multiple of the limit a panel shrinks by more than a half.
const FAR_TOO_MUCH: f64 = 8.0;
const FAR_LESS: f64 = 0.125;
/// Growth of the panel after a shortened one: the kink behind it must not slip into one that is far
/// too long.
const GROWTH: f64 = 4.0;
/// Panels before a profile is called unfit: forty are enough for the pressures of the kernel.
const MOST_PANELS: u32 = 4_000;
/// Shortest panel in p: the kink of an annulus asks for 1e-3.
const SHORTEST: f64 = 1e-9;
/// An integral is complete when this fraction of a rounding error of it can be left.
const COMPLETE: f64 = 0.125;

/// What a march goes for.
#[derive(Clone, Copy, Debug)]
pub(super) enum IntegrationTarget<R> {
    /// Rest.
    Rest,
    /// A value of κ t in units of m₀^(1−α).
    Time(R),
}

/// How a march ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// At rest.
    Rest,
    /// At the time asked for.
    Time,
    /// A profile that is not smooth, or not finite.
    Unfit,
}

/// What a march has found.
#[derive(Clone, Copy, Debug)]
pub(super) struct PanelResult<R> {
    pub outcome: Outcome,
    /// ln v₀/v and ln w₀/w.
    pub faded: [R; 2],
    /// κt, κx/v₀ and κθR/w₀ in units of m₀^(1−α).
    pub sums: [R; 3],
    /// Where the motion leads; the ratio v/w.
    pub ratio: R,
    /// Evaluations of Φ and Χ.
    pub evaluations: u32,
}

/// Follows a motion from two speeds, not negative, finite, not both zero, with as many nodes as
/// the precision needs.
pub(super) fn march<R: Real, P: PowerLawFriction<R> + ReducedFriction<R>>(
    slider: &Slider<R, P>,
    speeds: [R; 2],
    until: IntegrationTarget<R>,
) -> PanelResult<R> {
    if R::IS_SINGLE {
        PanelIntegration::<R, P, FEW_POINTS>::new(slider, speeds).marched(until)
    } else {
        PanelIntegration::<R, P, POINTS>::new(slider, speeds).marched(until)
    }
}

/// Rates of fading of v and w, Φ and Χ/C.
pub(super) type DecayRates<R> = [R; 2];

/// The march, in panels of N nodes.
#[derive(Debug)]
struct PanelIntegration<'a, R, P, const N: usize> {
    slider: &'a Slider<R, P>,
    /// 1 − α
    beta: R,
    /// ln v₀/m₀ and ln w₀/m₀, one of them 0.
    offsets: [R; 2],
    /// ln v₀/v and ln w₀/w.
    faded: [R; 2],
    /// κt, κx/v₀ and κθR/w₀ in units of m₀^(1−α).
    sums: [R; 3],
    /// False for sums to which nothing can be added any more.
    growing: [bool; 3],
    /// Bounds of the rates of fading from here on.
    least: DecayRates<R>,
    most: DecayRates<R>,
    lead: DominantSpeed,
    rates: DecayRates<R>,
    /// The stretch ahead; none if the direction does not change.
    leg: Option<DirectionArc<R>>,
    /// ds/dp at the last node.
    slowness: R,
    /// Where the motion leads; the ratio v/w.
    ratio: R,
    /// Evaluations of Φ and Χ.
    evaluations: u32,
}

impl<'a, R: Real, P: PowerLawFriction<R> + ReducedFriction<R>, const N: usize>
    PanelIntegration<'a, R, P, N>
{
    /// From two speeds, not negative, finite, not both zero.
    fn new(slider: &'a Slider<R, P>, speeds: [R; 2]) -> Self {
        let at = Speeds::new(speeds[0], speeds[1]);
        let lead = at.lead();
        let [minor, major] = match lead {
            DominantSpeed::Sliding => [speeds[1], speeds[0]],
            DominantSpeed::Spinning => speeds,
        };
        let ln_ratio = if at.ratio() >= R::MIN_POSITIVE {
            at.ratio().ln()
        } else {
            minor.ln() - major.ln()
        };
        let mut march = Self {
            slider,
            beta: R::ONE - slider.profile.exponent(),
            offsets: match lead {
                DominantSpeed::Sliding => [R::ZERO, ln_ratio],
                DominantSpeed::Spinning => [ln_ratio, R::ZERO],
            },
            faded: [R::ZERO; 2],
            sums: [R::ZERO; 3],
            growing: [true; 3],
            least: [R::ZERO; 2],
            most: [R::ZERO; 2],
            lead,
            rates: [R::ZERO; 2],
            leg: None,
            slowness: R::ZERO,
            ratio: speeds[0] / speeds[1],
            evaluations: 0,
        };
        let (rates, excess) = march.rates_and_excess(&at);
        march.rates = rates;
        march.least = rates.map(|rate| R::HALF * rate);
        march.most = rates.map(|rate| R::TWO * rate);
        if minor > R::ZERO && excess != R::ZERO {
            march.first_arc([at.ratio(), ln_ratio, at.gap()], excess);
        }
        march
    }

    /// Follows the motion, and says what came of it.
    fn marched(mut self, until: IntegrationTarget<R>) -> PanelResult<R> {
        let outcome = self.go(until);
        PanelResult {
            outcome,
            faded: self.faded,
            sums: self.sums,
            ratio: self.ratio,
            evaluations: self.evaluations,
        }
    }

    /// Follows the motion.
    fn go(&mut self, until: IntegrationTarget<R>) -> Outcome {
        let mut size = R::INFINITY;
        let mut is_careful = false;
        for _ in 0..MOST_PANELS {
            let Some(leg) = self.leg else {
                return self.close(None, until);
            };
            if leg.is_complete() {
                match leg.end {
                    ArcEnd::Settled => return self.close(Some(&leg), until),
                    ArcEnd::EqualSpeeds => self.cross(),
                }
                continue;
            }
            if !self.growing.contains(&true) {
                if leg.end == ArcEnd::EqualSpeeds {
                    // For the ratio in which it would go on.
                    self.cross();
                }
                return Outcome::Rest;
            }
            let longest = self.longest(&leg);
            size = if size < longest { size } else { longest };
            let panel = self.panel(&leg, size);
            let limit = R::from_f64(FADING_LIMIT * LARGEST_FADING);
            // False for NaN.
            let fades_well = panel.fading <= limit;
            if !(fades_well && panel.is_resolved) {
                // Half, or less if it fades far too much; not by all of it, since an exponential may.
                let much = R::from_f64(FAR_TOO_MUCH) * limit;
                size *= if panel.fading > much {
                    R::from_f64(FAR_LESS)
                } else {
                    R::HALF
                };
                is_careful = true;
                // Also if the size is not finite.
                let goes_on = size > R::from_f64(SHORTEST) * longest;
                if !goes_on {
                    return Outcome::Unfit;
                }
                continue;
            }
            if let IntegrationTarget::Time(time) = until
                && self.sums[0] + panel.sums[0] >= time
            {
                return self.stop_within(&leg, size, &panel, time);
            }
            self.take(&leg, size, &panel);
            size = if is_careful {
                R::from_f64(GROWTH) * size
            } else {
                R::INFINITY
            };
            is_careful = false;
        }
        Outcome::Unfit
    }

    /// Goes over a panel.
    fn take(&mut self, leg: &DirectionArc<R>, size: R, panel: &Panel<R, N>) {
        let p = if leg.rising {
            leg.p - size
        } else {
            leg.p + size
        };
        // A panel that ends where the leg does must not stop short of it by rounding.
        let is_last = size >= (leg.goal - leg.p).abs();
        self.leg = Some(DirectionArc {
            p: if is_last { leg.goal } else { p },
            ..*leg
        });
        for (faded, more) in self.faded.iter_mut().zip(panel.faded) {
            *faded += more;
        }
        for (sum, more) in self.sums.iter_mut().zip(panel.sums) {
            *sum += more;
        }
        (self.rates, self.slowness) = (panel.rates, panel.slowness);
        self.mark_converged_sums();
    }

    /// Finds the sums that are complete.
    fn mark_converged_sums(&mut self) {
        let pace = self.pace(self.faded);
        let [slide, rim] = self.least;
        // The slowest fall of the pace, or its fastest growth.
        let slowing = if self.beta > R::ZERO {
            self.beta * if slide < rim { slide } else { rim }
        } else {
            let [slide, rim] = self.most;
            self.beta * if slide > rim { slide } else { rim }
        };
        let enough = R::from_f64(COMPLETE) * R::EPSILON;
        let falls = [slowing, slide + slowing, rim + slowing];
        let [slide, rim] = self.faded.map(|faded| (-faded).exp());
        let values = [pace, pace * slide, pace * rim];
        let ends = falls.into_iter().zip(values).zip(self.sums);
        for (is_growing, ((fall, value), sum)) in self.growing.iter_mut().zip(ends) {
            let is_complete = fall > R::ZERO && value / fall <= enough * sum;
            *is_growing = !is_complete;
        }
    }
}
