//! Largest errors of a method over many pairs.

use crate::baselines::PURE_SPIN_TORQUE;
use crate::reference::Wide;

/// Largest errors over a set of pairs; infinite if a method returned NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// |δF|/F
    pub relative_force: f64,
    /// |δT|/T
    pub relative_torque: f64,
    /// |δF|, in units of F(∞) = 1 for α = 0
    pub absolute_force: f64,
    /// |δT| in units of the torque of pure spinning, 2/3 for α = 0
    pub absolute_torque: f64,
}

impl Errors {
    /// Compares pair by pair.
    pub fn between(found: &[[f64; 2]], exact: &[[Wide; 2]]) -> Self {
        let mut errors = Self::default();
        for (&[force, torque], [exact_force, exact_torque]) in found.iter().zip(exact) {
            let (absolute, relative) = deviation(force, exact_force);
            errors.absolute_force = errors.absolute_force.max(absolute);
            errors.relative_force = errors.relative_force.max(relative);
            let (absolute, relative) = deviation(torque, exact_torque);
            let absolute = absolute / PURE_SPIN_TORQUE;
            errors.absolute_torque = errors.absolute_torque.max(absolute);
            errors.relative_torque = errors.relative_torque.max(relative);
        }
        errors
    }

    /// The larger of the two relative errors.
    pub fn relative(&self) -> f64 {
        self.relative_force.max(self.relative_torque)
    }

    /// The larger of the two absolute errors.
    pub fn absolute(&self) -> f64 {
        self.absolute_force.max(self.absolute_torque)
    }
}

/// Absolute and relative deviation; NaN counts as infinite, so that `max` cannot lose it.
fn deviation(found: f64, exact: &Wide) -> (f64, f64) {
    let absolute = ((found - exact.high) - exact.low).abs();
    if absolute.is_nan() {
        (f64::INFINITY, f64::INFINITY)
    } else if absolute == 0.0 {
        (0.0, 0.0)
    } else {
        (absolute, absolute / exact.high.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_is_an_infinite_error() {
        let exact = [[Wide::new(1.0), Wide::new(0.5)]; 2];
        let errors = Errors::between(&[[1.0, f64::NAN], [1.25, 0.5]], &exact);
        assert_eq!(errors.relative_torque, f64::INFINITY);
        assert_eq!(errors.relative_force, 0.25);
    }
}
