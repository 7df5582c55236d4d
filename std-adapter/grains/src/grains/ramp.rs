//! Loads in time: constant, or linear between given values.

use crate::packing::SettingError;
use std::fmt;
use std::str::FromStr;
use tribos_base::scene::entries::Written;
use tribos_base::scene::key::{Domain, Form};
use tribos_base::scene::table::Setting;

/// A quantity that follows time: constant, or piecewise linear.
///
/// *Formula*: linear between the given pairs of time and value; the first value before the first time,
/// the last value after the last.
///
/// *Domain*: finite times ≥ 0 in ascending order, finite values.
///
/// *Accuracy*: a few roundings of the values beside the time.
///
/// ```
/// use tribos::grains::Ramp;
/// let load: Ramp = "0:0, 2:1e3, 3:500".parse()?; // s and Pa
/// assert_eq!([0.5, 2.0, 2.5, 9.0].map(|time| load.at(time)), [250.0, 1e3, 750.0, 500.0]);
/// assert_eq!(load.integral(3.0), 1e3 + 750.0);
/// assert_eq!(Ramp::from(9.81).at(5.0), 9.81);
/// # Ok::<(), tribos::scene::SettingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    /// Times and values; at least one.
    knots: Vec<[f64; 2]>,
}

impl Ramp {
    /// A ramp through pairs of time and value.
    pub fn through(knots: &[[f64; 2]]) -> Result<Self, SettingError> {
        for &[time, value] in knots {
            if !(time >= 0.0 && time.is_finite() && value.is_finite()) {
                return Err(SettingError::RampRange(time, value));
            }
        }
        let descends = |pair: &&[[f64; 2]]| pair[0][0] >= pair[1][0];
        if let Some(pair) = knots.windows(2).find(descends) {
            return Err(SettingError::RampOrder(pair[0][0], pair[1][0]));
        }
        if knots.is_empty() {
            return Err(SettingError::Ramp(String::new()));
        }
        Ok(Self {
            knots: knots.to_vec(),
        })
    }

    /// The value at a time.
    pub fn at(&self, time: f64) -> f64 {
        let after = self.knots.partition_point(|[knot, _]| *knot <= time);
        match (self.knots[..after].last(), self.knots.get(after)) {
            (Some([t0, v0]), Some([t1, v1])) => v0 + (v1 - v0) * ((time - t0) / (t1 - t0)),
            (Some([_, value]), None) | (None, Some([_, value])) => *value,
            (None, None) => 0.0,
        }
    }

    /// The integral of the value over time, from 0 on.
    pub fn integral(&self, time: f64) -> f64 {
        let [first, value] = self.knots[0];
        let mut sum = value * first.min(time);
        for pair in self.knots.windows(2) {
            let [[t0, v0], [t1, _]] = [pair[0], pair[1]];
            if time > t0 {
                let end = t1.min(time);
                sum += 0.5 * (v0 + self.at(end)) * (end - t0);
            }
        }
        let [last, value] = self.knots[self.knots.len() - 1];
        if time > last {
            sum += value * (time - last);
        }
        sum
    }

    /// Pairs of time and value.
    pub(super) fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// Smallest and largest value.
    pub fn range(&self) -> [f64; 2] {
        let values = || self.knots.iter().map(|[_, value]| *value);
        [
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        ]
    }

    /// The value, if it is the same at all times.
    pub(crate) fn constant(&self) -> Option<f64> {
        let [least, most] = self.range();
        (least == most).then_some(least)
    }
}

/// A number, or a ramp in time, as [`Ramp`] reads it.
pub(super) const RAMP: Domain = Domain::Form(&of_numbers(&Domain::Finite));

/// The same with no number below 0.
pub(super) const RAMP_NOT_NEGATIVE: Domain = Domain::Form(&of_numbers(&Domain::NotNegative));

const fn of_numbers(numbers: &'static Domain) -> Form {
    Form {
        name: "ramp",
        valid: "a ramp such as \"0:0, 0.5:1e3, 1:0\"",
        // Between its knots a ramp takes no value beyond theirs.
        read: |text| match text.parse::<Ramp>() {
            Ok(ramp) => Ok(ramp.range().to_vec()),
            Err(refused) => Err(refused.to_string()),
        },
        numbers: Some(numbers),
        names_absence: true,
    }
}

impl Setting for Ramp {
    fn written(&self) -> Written {
        let text = || Written::Text(self.to_string());
        self.constant().map_or_else(text, Written::Number)
    }

    fn read(written: &Written) -> Option<Self> {
        match written {
            Written::Number(x) => Some(Self::from(*x)),
            _ => written.text()?.parse().ok(),
        }
    }
}

impl Default for Ramp {
    fn default() -> Self {
        Self::from(0.0)
    }
}

impl From<f64> for Ramp {
    fn from(value: f64) -> Self {
        Self {
            knots: vec![[0.0, value]],
        }
    }
}

impl fmt::Display for Ramp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let [[0.0, value]] = self.knots[..] {
            return write!(f, "{value}");
        }
        for (index, [time, value]) in self.knots.iter().enumerate() {
            let gap = if index == 0 { "" } else { ", " };
            write!(f, "{gap}{time}:{value}")?;
        }
        Ok(())
    }
}

impl FromStr for Ramp {
    type Err = SettingError;

    fn from_str(text: &str) -> Result<Self, SettingError> {
        let number = |text: &str| text.trim().parse::<f64>().ok();
        if let Some(value) = number(text) {
            return Self::through(&[[0.0, value]]);
        }
        let pair = |part: &str| {
            let pair = part.split_once(':');
            let pair = pair.and_then(|(time, value)| Some([number(time)?, number(value)?]));
            pair.ok_or_else(|| SettingError::Ramp(part.trim().into()))
        };
        let knots: Result<Vec<_>, _> = text.split(',').map(pair).collect();
        Self::through(&knots?)
    }
}
