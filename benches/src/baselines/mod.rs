//! Baselines for the kernel, one method per file.
//!
//! Every method returns `[F, T]` of a uniform disk of radius 1 under unit load with α = 0, for
//! sliding speed `slide` ≥ 0 and rim speed `rim` ≥ 0, not both zero.

pub mod agm;
pub mod bulirsch;
pub mod cephes;
pub mod decoupled;
pub mod ellipsoid;
pub mod micromath_agm;
pub mod pade;
pub mod series;
pub mod trapezoid;

/// T(0) = 2/3: the reduced torque of pure spinning.
pub const PURE_SPIN_TORQUE: f64 = 2.0 / 3.0;

/// 4/(3π), the common factor of the closed forms of the force.
pub const FORCE_FACTOR: f64 = 4.0 / (3.0 * core::f64::consts::PI);

/// 4/(9π), the common factor of the closed forms of the torque.
pub const TORQUE_FACTOR: f64 = 4.0 / (9.0 * core::f64::consts::PI);

/// The smaller speed over the larger, and whether sliding is the larger.
#[inline]
fn ordered(slide: f64, rim: f64) -> (f64, bool) {
    if slide > rim {
        (rim / slide, true)
    } else {
        (slide / rim, false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{errors, mix, reference};

    type Wrench = fn(f64, f64) -> [f64; 2];

    /// Largest relative errors of force and torque over the mix.
    fn relative_errors(method: Wrench, inputs: &[[f64; 2]]) -> [f64; 2] {
        let exact: Vec<_> = inputs
            .iter()
            .map(|&[v, w]| reference::wrench(v, w))
            .collect();
        let found: Vec<_> = inputs.iter().map(|&[v, w]| method(v, w)).collect();
        let errors = errors::Errors::between(&found, &exact);
        [errors.relative_force, errors.relative_torque]
    }

    #[test]
    fn elliptic_baselines_are_as_good_as_their_sources_say() {
        let inputs = mix::pairs(1);
        let methods: [(&str, Wrench, f64); 3] = [
            ("agm, hardware root", agm::wrench, 1e-14),
            ("agm, libm root", agm::wrench_libm, 1e-14),
            ("bulirsch", bulirsch::wrench, 2e-15),
        ];
        for (name, method, bound) in methods {
            let [force, torque] = relative_errors(method, &inputs);
            assert!(
                force < bound && torque < bound,
                "{name}: {force:e} {torque:e}"
            );
        }
    }

    /// The literature's approximations have the errors that were published or re-derived.
    #[test]
    fn approximations_have_their_known_errors() {
        let inputs = mix::pairs(1);
        let known: [(&str, Wrench, [f64; 2]); 4] = [
            ("ellipsoid", ellipsoid::wrench, [0.50, 0.78]),
            ("pade 1", pade::first_order, [0.41, 0.49]),
            ("pade 2", pade::second_order, [0.215, 0.79]),
            ("series", series::wrench, [0.0124, 0.080]),
        ];
        for (name, method, expected) in known {
            let found = relative_errors(method, &inputs);
            for (a, b) in found.iter().zip(expected) {
                assert!(
                    (a / b - 1.0).abs() < 0.02,
                    "{name}: {found:?}, not {expected:?}"
                );
            }
        }
    }
}
