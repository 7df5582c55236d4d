//! The kernel's laws as models of data.

mod lugre;
mod power;
mod rate_state;
mod stribeck;

use super::error::FitError;
use super::parameter::Model;
use super::{Measurements, Motion};
use std::borrow::Cow;
use std::str::FromStr;
use tribos_core::law::{AgeingLaw, LocalLaw, SlipLaw};
use tribos_friction::FrictionError;

/// A law that can be fitted.
///
/// ```
/// use tribos::fit::FitLaw;
/// assert_eq!("lugre".parse(), Ok(FitLaw::LuGre));
/// assert_eq!((FitLaw::LuGre.steady(), FitLaw::LuGre.over_time()), ("lugre", "lugre-bristles"));
/// for (law, name, _) in FitLaw::ALL {
///     assert_eq!(name.parse(), Ok(law));
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitLaw {
    /// Boundary and hydrodynamic lubrication; steady.
    Stribeck,
    /// Bristles; steady, or over time with their deflection.
    LuGre,
    /// A power of the speed; steady.
    Power,
    /// Rate and state with the ageing law of Dieterich; steady, or over time with its age.
    RateState,
    /// Rate and state with the slip law of Ruina; in steady sliding it equals `RateState`.
    RateStateSlip,
}

impl FitLaw {
    /// All laws that can be fitted, each with its name and what is fitted.
    pub const ALL: [(Self, &'static str, &'static str); 5] = [
        (
            Self::Stribeck,
            "stribeck",
            "Boundary, then hydrodynamic lubrication: mu_s, mu_d, vs, delta, k",
        ),
        (
            Self::LuGre,
            "lugre",
            "Bristles: fc, fs, vs, s2; over time s0 and s1 as well",
        ),
        (Self::Power, "power", "A power of the speed: gamma, alpha"),
        (
            Self::RateState,
            "rate-state",
            "Rate and state, ageing law: mu0, a, b, eta at a reference v0; over time dc as well",
        ),
        (
            Self::RateStateSlip,
            "rate-state-slip",
            "The same with the slip law",
        ),
    ];

    /// The law of steady sliding in the catalogue [`LAWS`](tribos_friction::LAWS).
    pub fn steady(self) -> &'static str {
        match self {
            Self::Stribeck => "stribeck",
            Self::LuGre => "lugre",
            Self::Power => "power",
            Self::RateState | Self::RateStateSlip => "rate-state",
        }
    }

    /// The law of a record over time in the catalogue: that with its state, where it has one.
    pub fn over_time(self) -> &'static str {
        match self {
            Self::LuGre => "lugre-bristles",
            Self::RateState => "rate-state-ageing",
            Self::RateStateSlip => "rate-state-slip",
            Self::Stribeck | Self::Power => self.steady(),
        }
    }
}

impl FromStr for FitLaw {
    type Err = FrictionError;

    fn from_str(text: &str) -> Result<Self, FrictionError> {
        let found = Self::ALL.into_iter().find(|(_, name, _)| *name == text);
        found.map(|(law, ..)| law).ok_or_else(|| {
            let names = Self::ALL.map(|(_, name, _)| name);
            let list = format!("there are {}", names.join(", "));
            FrictionError::unknown("law to fit", text, names, list)
        })
    }
}

impl FitLaw {
    /// The law as a model of these data: in its steady form, or with its state over time.
    ///
    /// Over time the state follows the kernel's exact step through each interval at the mean of the
    /// velocities at its ends; it begins as in steady sliding at the first velocity, relaxed if that is
    /// zero.
    pub fn model(self, data: &Measurements) -> Result<Box<dyn Model + '_>, FitError> {
        const STATELESS: &str =
            "this law has no memory: give steady friction, columns v,f, or fit lugre or rate-state";
        let scales = DataRange::of(data);
        Ok(match (self, data.motion()) {
            (FitLaw::Stribeck, Motion::Steady { speeds }) => {
                let speeds = Cow::Borrowed(speeds.as_slice());
                Box::new(stribeck::Steady { speeds, scales })
            }
            (FitLaw::Power, Motion::Steady { speeds }) => {
                Box::new(power::Steady::new(data, speeds))
            }
            (FitLaw::LuGre, Motion::Steady { speeds }) => {
                let speeds = Cow::Borrowed(speeds.as_slice());
                Box::new(lugre::Steady { speeds, scales })
            }
            (FitLaw::LuGre, Motion::Series { times, velocities }) => {
                Box::new(lugre::Series::new(data, times, velocities))
            }
            (FitLaw::RateState | FitLaw::RateStateSlip, Motion::Steady { speeds }) => {
                let speeds = Cow::Borrowed(speeds.as_slice());
                Box::new(rate_state::Steady { speeds, scales })
            }
            (FitLaw::RateState, Motion::Series { times, velocities }) => Box::new(
                rate_state::Series::<AgeingLaw>::new(data, times, velocities)?,
            ),
            (FitLaw::RateStateSlip, Motion::Series { times, velocities }) => {
                Box::new(rate_state::Series::<SlipLaw>::new(data, times, velocities)?)
            }
            (FitLaw::Stribeck | FitLaw::Power, Motion::Series { .. }) => {
                return Err(FitError::Form(STATELESS));
            }
        })
    }
}

/// Scales of the starts: the smallest and largest measured values.
#[derive(Clone, Copy)]
struct DataRange {
    speeds: [f64; 2],
    forces: [f64; 2],
}

impl DataRange {
    fn of(data: &Measurements) -> Self {
        Self {
            speeds: data.speeds(),
            forces: data.forces(),
        }
    }

    /// Geometric mean of the extremes.
    fn middle_speed(&self) -> f64 {
        geometric_mean(self.speeds)
    }
}

/// Friction of a law at all speeds.
fn steady(law: &impl LocalLaw<f64>, speeds: &[f64]) -> Vec<f64> {
    speeds.iter().map(|&v| law.friction(v)).collect()
}

/// From `low` to `high` in equal ratios as `share` goes from 0 to 1.
fn log_between(share: f64, [low, high]: [f64; 2]) -> f64 {
    low * libm::pow(high / low, share)
}

/// From `low` to `high`.
fn between(share: f64, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * share
}

/// Enforces `low` ≤ `high` by moving free values: both to their mean, or one to the other.
fn order(values: &mut [f64], is_free: &[bool], [low, high]: [usize; 2]) {
    if values[low] <= values[high] {
        return;
    }
    let meet = match [is_free[low], is_free[high]] {
        [true, true] => 0.5 * (values[low] + values[high]),
        [true, false] => values[high],
        _ => values[low],
    };
    for index in [low, high] {
        if is_free[index] {
            values[index] = meet;
        }
    }
}

/// √(low high) without overflow of the product.
fn geometric_mean([low, high]: [f64; 2]) -> f64 {
    low.sqrt() * high.sqrt()
}

/// Values at some points.
fn picked(values: &[f64], points: &[usize]) -> Vec<f64> {
    let found = points.iter().filter_map(|&point| values.get(point));
    found.copied().collect()
}

/// Length of an interval of a record in time, and the mean velocity in it.
type Interval = (f64, f64);

/// Intervals of a record, each with the mean of the velocities at its ends.
fn intervals(times: &[f64], velocities: &[f64]) -> Vec<Interval> {
    let lengths = times.windows(2).map(|pair| pair[1] - pair[0]);
    let means = velocities.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    lengths.zip(means).collect()
}

/// Intervals between selected points of a record, with the same durations and distances.
fn merged(intervals: &[Interval], points: &[usize]) -> Vec<Interval> {
    let between = points
        .windows(2)
        .filter_map(|pair| intervals.get(pair[0]..pair[1]));
    let merged = between.map(|parts| {
        let time: f64 = parts.iter().map(|(dt, _)| dt).sum();
        let distance: f64 = parts.iter().map(|(dt, v)| dt * v).sum();
        (time, distance / time)
    });
    merged.collect()
}

/// Shortest and whole distance slid in a record.
fn distances(intervals: &[Interval]) -> [f64; 2] {
    let slid = || intervals.iter().map(|(dt, v)| (v * dt).abs());
    let shortest = slid().filter(|x| *x > 0.0).fold(f64::INFINITY, f64::min);
    let whole: f64 = slid().sum();
    if shortest.is_finite() {
        [shortest, whole]
    } else {
        [1.0, 1.0]
    }
}
