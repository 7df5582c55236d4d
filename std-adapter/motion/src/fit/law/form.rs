//! What a law says to a fit: its parameters, and where a search for them starts.

use super::super::parameter::{FitParameter, Range};
use super::guess::Guess;

/// The parameters of a law and their starts.
pub(in super::super) struct Form {
    /// In the order of all slices.
    pub parameters: &'static [FitParameter],
    /// Parameters in which friction is linear, or nearly so.
    pub linear: &'static [&'static str],
    /// A parameter, and the one that must not be below it.
    pub ordered: Option<[&'static str; 2]>,
    /// A parameter that only sets the scale of another one.
    pub reference: Option<&'static str>,
    /// Initial values for a point of the unit cube, whose middle is the best guess.
    pub start: fn(&Guess, &[f64]) -> Vec<f64>,
}

impl Form {
    /// Whether friction is linear in the parameter, or nearly so.
    pub fn is_linear(&self, parameter: usize) -> bool {
        let name = self.parameters[parameter].name;
        self.linear.contains(&name)
    }

    /// The parameter that this one must not be below.
    pub fn above(&self, parameter: usize) -> Option<usize> {
        let [low, high] = self.ordered?;
        let place = |name| self.parameters.iter().position(|p| p.name == name);
        (place(high)? == parameter).then(|| place(low))?
    }

    /// The value of a reference.
    pub fn reference(&self, parameter: usize, guess: &Guess) -> Option<f64> {
        let is_reference = self.reference == Some(self.parameters[parameter].name);
        is_reference.then(|| guess.middle_speed())
    }

    /// Least and largest value that the data can show.
    pub fn limits(&self, parameter: usize, guess: &Guess) -> [f64; 2] {
        let [slow, fast] = guess.speeds;
        let [shortest, whole] = guess.slid;
        let force = guess.forces[1];
        match self.parameters[parameter].name {
            "vs" | "vr" | "vt" => [0.3 * slow, 10.0 * fast],
            // The excess over the lower one.
            "fs" | "mu_s" => [0.0, 10.0 * force],
            "delta" => [0.05, 20.0],
            "dc" => [1e-3 * shortest, 10.0 * whole],
            "s0" | "k1" | "k2" | "k3" => [1e-3 * force / whole, 1e3 * force / shortest],
            // Less friction than a millionth of the largest is none.
            "fc" | "f1" | "f2" | "f3" | "a" => [1e-6 * force, 100.0 * force],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }
}

/// A parameter.
pub(super) const fn parameter(
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    range: Range,
) -> FitParameter {
    FitParameter {
        name,
        unit,
        meaning,
        range,
    }
}

/// A factor from 1/`fold` to `fold`, and 1 in the middle of the unit interval.
pub(super) fn around(share: f64, fold: f64) -> f64 {
    libm::pow(fold, 2.0 * share - 1.0)
}

/// From `low` to `high` in equal ratios as `share` goes from 0 to 1.
pub(super) fn log_between(share: f64, [low, high]: [f64; 2]) -> f64 {
    low * libm::pow(high / low, share)
}

/// From `low` to `high`.
pub(super) fn between(share: f64, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * share
}
