//! A motion followed through its directions, panel by panel.
//!
//! With v, w ≥ 0 the two speeds, m the larger and h the smaller over the larger one, friction of degree
//! α gives F = m^(α−1) v Φ(h) and T = m^(α−1) w Χ(h) ([`crate::coupling::Profile`]). In the
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

use super::Slider;
use super::leg::{End, Leg, Place};
use super::rule::{self, POINTS, RULE};
use super::tail::Tail;
use crate::coupling::{Coupling, Lead, Profile, Speeds};
use crate::modes::{balanced_ratio, changes_sign};
use crate::real::Real;

/// Largest exponent by which an integrand may fall within a panel: exp(−8x) on it is exact to
/// 1e-19 of its largest value with 16 nodes.
const LARGEST_FADING: f64 = 8.0;
/// A panel in which it falls by this much more is made anew.
const FADING_LIMIT: f64 = 1.5;
/// Beyond this multiple of the limit a panel shrinks by more than a half.
const FAR_TOO_MUCH: f64 = 8.0;
const FAR_LESS: f64 = 0.125;
/// Panels before a profile is called unfit: forty are enough for the pressures of the kernel.
const MOST_PANELS: u32 = 4_000;
/// Shortest panel in p: the kink of an annulus asks for 1e-3.
const SHORTEST: f64 = 1e-9;
/// Truncation error of a panel, in rounding errors.
const TOLERANCE_ULPS: f64 = 4.0;
/// Coefficients that do not fall off are noise if they are as small as this power of a rounding error.
const NOISE_POWER: f64 = 0.6;
/// Noise of C_α − C beyond this part of it is not excused.
const MOST_NOISE: f64 = 0.03125;
/// An integral is complete when this fraction of a rounding error of it can be left.
const COMPLETE: f64 = 0.125;
/// Exponents this close to 1 leave C_α flat, so that all of C_α − C may be a small difference.
const NEARLY_LINEAR: f64 = 0.125;
/// C_α − C is a small difference below this part of C.
const CANCELS: f64 = 1.0 / 64.0;
/// Newton's method for a time within a panel: two are enough.
const MOST_CORRECTIONS: u32 = 8;
/// Fading, in units of the root of a rounding error, over which the rates count as constant.
const LINEAR: f64 = 0.125;
/// Rounding errors of the fading itself, beyond which no correction helps.
const ROUNDING_ULPS: f64 = 64.0;
/// |C_α − C| at equal speeds, in rounding errors of C, below which they stay equal.
const BALANCED_ULPS: f64 = 8.0;
/// |C_α − C| below this part of a rounding error of C is taken as if it were this large.
const LEAST_EXCESS: f64 = 1.0 / 16.0;

/// What a march goes for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Until<R> {
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

/// Rates of fading of v and w, Φ and Χ/C.
pub(super) type Rates<R> = [R; 2];

/// The march.
#[derive(Debug)]
pub(super) struct March<'a, R, P> {
    slider: &'a Slider<R, P>,
    /// 1 − α
    beta: R,
    /// ln v₀/m₀ and ln w₀/m₀, one of them 0.
    offsets: [R; 2],
    /// ln v₀/v and ln w₀/w.
    pub faded: [R; 2],
    /// κt, κx/v₀ and κθR/w₀ in units of m₀^(1−α).
    pub sums: [R; 3],
    /// False for sums to which nothing can be added any more.
    growing: [bool; 3],
    /// Bounds of the rates of fading from here on.
    least: Rates<R>,
    most: Rates<R>,
    lead: Lead,
    rates: Rates<R>,
    /// The stretch ahead; none if the direction does not change.
    leg: Option<Leg<R>>,
    /// ds/dp at the last node.
    slowness: R,
    /// Where the motion leads; the ratio v/w.
    pub ratio: R,
    /// Evaluations of Φ and Χ.
    pub evaluations: u32,
}

/// What the nodes of a panel say.
struct Panel<R> {
    /// Increments of `faded`.
    faded: [R; 2],
    /// Increments of `sums`.
    sums: [R; 3],
    /// Time integrand at the nodes.
    times: [R; POINTS],
    /// Rates and ds/dp at the last node.
    rates: Rates<R>,
    slowness: R,
    /// Largest exponent by which an integrand would fall over the panel, as steep as at its worst node.
    fading: R,
    is_resolved: bool,
}

impl<'a, R: Real, P: Profile<R> + Coupling<R>> March<'a, R, P> {
    /// From two speeds, not negative, finite, not both zero.
    pub fn new(slider: &'a Slider<R, P>, speeds: [R; 2]) -> Self {
        let at = Speeds::new(speeds[0], speeds[1]);
        let lead = at.lead();
        let [minor, major] = match lead {
            Lead::Sliding => [speeds[1], speeds[0]],
            Lead::Spinning => speeds,
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
                Lead::Sliding => [R::ZERO, ln_ratio],
                Lead::Spinning => [ln_ratio, R::ZERO],
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
            march.set_out([at.ratio(), ln_ratio, at.gap()], excess);
        }
        march
    }

    /// Follows the motion.
    pub fn go(&mut self, until: Until<R>) -> Outcome {
        let mut size = R::INFINITY;
        for _ in 0..MOST_PANELS {
            let Some(leg) = self.leg else {
                return self.close(None, until);
            };
            if leg.is_over() {
                match leg.end {
                    End::Settled => return self.close(Some(&leg), until),
                    End::EqualSpeeds => self.cross(),
                }
                continue;
            }
            if !self.growing.contains(&true) {
                if leg.end == End::EqualSpeeds {
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
                // Also if the size is not finite.
                let goes_on = size > R::from_f64(SHORTEST) * longest;
                if !goes_on {
                    return Outcome::Unfit;
                }
                continue;
            }
            if let Until::Time(time) = until
                && self.sums[0] + panel.sums[0] >= time
            {
                return self.stop_within(&leg, size, &panel, time);
            }
            self.take(&leg, size, &panel);
            size = R::INFINITY;
        }
        Outcome::Unfit
    }

    /// Rates of fading, and C_α − C.
    fn rates_and_excess(&mut self, at: &Speeds<R>) -> (Rates<R>, R) {
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

    /// Finds the first leg, from the ratio h with its logarithm and its distance from 1.
    fn set_out(&mut self, ratio: [R; 3], excess: R) {
        let lead = self.lead;
        let at_ends = self.at_ends(lead);
        for other in [Lead::Spinning, Lead::Sliding] {
            let (rates, _) = self.rates_and_excess(&Speeds::from_ratio(other, R::ZERO));
            self.bound(rates);
        }
        let rising = (excess > R::ZERO) == (lead == Lead::Spinning);
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
            End::EqualSpeeds
        } else {
            End::Settled
        };
        let leg = Leg::new(lead, ends, rising, end, ratio);
        (_, [self.slowness, _]) = self.measured(&leg, &leg.place(leg.p));
        self.leg = Some(leg);
        self.aim();
    }

    /// C_α − C at h = 0 and 1.
    fn at_ends(&mut self, lead: Lead) -> [R; 2] {
        let c = self.slider.inertia_ratio;
        let [spinning, sliding] = self.slider.profile.inertia_ends();
        let (rates, at_one) = self.rates_and_excess(&Speeds::from_ratio(lead, R::ONE));
        self.bound(rates);
        let at_zero = match lead {
            Lead::Spinning => spinning - c,
            Lead::Sliding => sliding - c,
        };
        [at_zero, at_one]
    }

    /// The fixed point of a side.
    fn balance(&mut self, lead: Lead, at_ends: [R; 2]) -> R {
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
    fn cross(&mut self) {
        self.lead = match self.lead {
            Lead::Spinning => Lead::Sliding,
            Lead::Sliding => Lead::Spinning,
        };
        let at_ends = self.at_ends(self.lead);
        let bottom = if changes_sign(at_ends[0], at_ends[1]) {
            self.balance(self.lead, at_ends)
        } else {
            R::ZERO
        };
        self.leg = Some(Leg::from_equal(self.lead, bottom));
        self.slowness = R::ZERO;
        self.aim();
    }

    /// The ratio to which the present leg leads.
    fn aim(&mut self) {
        if let Some(leg) = &self.leg {
            let limit = leg.limit();
            self.ratio = match self.lead {
                Lead::Spinning => limit,
                Lead::Sliding => R::ONE / limit,
            };
        }
    }

    fn bound(&mut self, rates: Rates<R>) {
        for ((least, most), rate) in self.least.iter_mut().zip(&mut self.most).zip(rates) {
            let (half, twice) = (R::HALF * rate, R::TWO * rate);
            *least = if half < *least { half } else { *least };
            *most = if twice > *most { twice } else { *most };
        }
    }

    /// Rates at which the three integrands fall under rates of fading of v and w.
    fn falls(&self, rates: Rates<R>) -> [R; 3] {
        let pace = self.beta * self.leading(rates);
        [pace, rates[0] + pace, rates[1] + pace]
    }

    /// The fastest of those that matter.
    fn fastest(&self, rates: Rates<R>) -> R {
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
    fn leading(&self, [slide, rim]: [R; 2]) -> R {
        match self.lead {
            Lead::Sliding => slide,
            Lead::Spinning => rim,
        }
    }

    /// (m/m₀)^(1−α) after the given fading.
    fn pace(&self, faded: [R; 2]) -> R {
        let ln_major = self.leading(self.offsets) - self.leading(faded);
        (self.beta * ln_major).exp()
    }

    /// Longest panel that may fit.
    fn longest(&self, leg: &Leg<R>) -> R {
        let smooth = leg.smooth_length();
        let fastest = self.fastest(self.rates);
        let by_fading = R::from_f64(LARGEST_FADING) / (fastest * self.slowness);
        if by_fading < smooth {
            by_fading
        } else {
            smooth
        }
    }

    /// Rates, ds/|dp|, and C/|C_α − C|, the factor by which the last grows the error of the law.
    fn measured(&mut self, leg: &Leg<R>, place: &Place<R>) -> (Rates<R>, [R; 2]) {
        let ([slide, rim], excess) = self.rates_and_excess(&place.at);
        let c = self.slider.inertia_ratio;
        let least = R::from_f64(LEAST_EXCESS) * R::EPSILON * c;
        let along = leg.sign() * excess;
        let along = if along < least { least } else { along };
        let growth = c / along;
        ([slide, rim], [place.share * growth / slide, growth])
    }

    /// Evaluates the panel of length `size` ahead.
    fn panel(&mut self, leg: &Leg<R>, size: R) -> Panel<R> {
        let half = R::HALF * size;
        let step = if leg.rising { -half } else { half };
        let [mut slides, mut rims] = [[R::ZERO; POINTS]; 2];
        let mut times = [R::ZERO; POINTS];
        let (mut rates, mut slowness, mut growth) = (self.rates, self.slowness, R::ONE);
        for (((slide, rim), time), node) in slides
            .iter_mut()
            .zip(&mut rims)
            .zip(&mut times)
            .zip(&RULE.nodes)
        {
            let place = leg.place(leg.p + step * (R::ONE + R::from_f64(*node)));
            let here;
            (rates, [slowness, here]) = self.measured(leg, &place);
            growth = if here > growth { here } else { growth };
            *time = slowness * half;
            *slide = *time * rates[0];
            *rim = *time * rates[1];
        }
        let faded = [rule::integral(&slides), rule::integral(&rims)];
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
        let (at_slides, at_rims) = (rule::running(&slides), rule::running(&rims));
        for (((time, weight), slide), rim) in times
            .iter_mut()
            .zip(&RULE.weights)
            .zip(at_slides)
            .zip(at_rims)
        {
            let faded = [self.faded[0] + slide, self.faded[1] + rim];
            *time *= self.pace(faded);
            let part = *time * R::from_f64(*weight);
            sums[0] += part;
            for ((sum, faded), is_growing) in sums
                .iter_mut()
                .skip(1)
                .zip(faded)
                .zip(self.growing.iter().skip(1))
            {
                if *is_growing {
                    *sum += part * (-faded).exp();
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

    /// True if sixteen nodes resolve the rates of the speeds that still matter, or all but the
    /// rounding errors of the law times `growth`.
    fn is_resolved(&self, rates: &[[R; POINTS]; 2], faded: [R; 2], growth: R) -> bool {
        let ulps = R::from_f64(TOLERANCE_ULPS) * R::EPSILON;
        let noise_power = R::EPSILON.pow(R::from_f64(NOISE_POWER));
        let leads = [self.lead == Lead::Sliding, self.lead == Lead::Spinning];
        let matters = [self.growing[1] || leads[0], self.growing[2] || leads[1]];
        rates
            .iter()
            .zip(faded)
            .zip(matters)
            .all(|((rates, total), matters)| {
                let [middle, end] = rule::decay(rates);
                let scale = if total > R::ONE { total } else { R::ONE };
                let fall = if end < middle { end / middle } else { R::ONE };
                let error = end * fall * fall;
                let is_noise = end > R::HALF * R::HALF * middle && end < noise_power * total;
                let part = ulps * growth;
                let most = R::from_f64(MOST_NOISE);
                let noise = (if part < most { part } else { most }) * total;
                !matters || error <= ulps * scale || error <= noise || is_noise
            })
    }

    /// Goes over a panel.
    fn take(&mut self, leg: &Leg<R>, size: R, panel: &Panel<R>) {
        let p = if leg.rising {
            leg.p - size
        } else {
            leg.p + size
        };
        // A panel that ends where the leg does must not stop short of it by rounding.
        let is_last = size >= (leg.goal - leg.p).abs();
        self.leg = Some(Leg {
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
        self.see_what_grows();
    }

    /// Finds the sums that are complete.
    fn see_what_grows(&mut self) {
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

    /// The rest of the motion, at or next to the ratio that stays.
    fn close(&mut self, leg: Option<&Leg<R>>, until: Until<R>) -> Outcome {
        let tail = match leg {
            Some(leg) => self.tail(leg),
            None => Tail {
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
            Until::Time(time) => time,
            Until::Rest => R::INFINITY,
        };
        let rests = self.beta > R::ZERO && whole[0] <= time;
        if rests {
            self.sums = whole;
            return Outcome::Rest;
        }
        let left = (time - self.sums[0]) / pace;
        let s = tail.inverse(here[0], end[0], left);
        let parts = pairs.map(|[here, end]| tail.until(here, end, s));
        self.sums = added(self.sums, parts);
        for (faded, more) in self.faded.iter_mut().zip(tail.faded(s)) {
            *faded += more;
        }
        Outcome::Time
    }

    /// Rates here and in the end of the leg, and how fast the one become the other.
    fn tail(&mut self, leg: &Leg<R>) -> Tail<R> {
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
        Tail {
            here,
            end,
            settling,
        }
    }

    /// Stops at a time within the panel of length `size`.
    fn stop_within(&mut self, leg: &Leg<R>, size: R, panel: &Panel<R>, time: R) -> Outcome {
        let left = time - self.sums[0];
        let node = rule::inverse_integral(&panel.times, left);
        let mut size = R::HALF * (R::ONE + node) * size;
        for _ in 0..MOST_CORRECTIONS {
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
            let linear = R::from_f64(LINEAR) * R::EPSILON.sqrt() + rounding;
            if turn.abs() <= linear || turn.is_nan() {
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
