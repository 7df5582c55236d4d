//! The disk of the slider tests: 8 cm on a table with μg = 2.943 m/s², C = 1/2.

use crate::reference::Reference;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::slider::{Slider, SliderParameters};

/// Coefficient times gravity, m/s² for α = 0.
pub const MU_G: f64 = 0.3 * 9.81;
/// Radius of the contact, m.
pub const RADIUS: f64 = 0.08;
/// I/(M R²) of a solid disk.
const INERTIA_RATIO: f64 = 0.5;

/// The disk under dry friction.
pub fn coulomb() -> Slider<f64, CoulombDisk> {
    Slider::new(
        CoulombDisk,
        SliderParameters {
            deceleration: MU_G,
            radius: RADIUS,
            inertia_ratio: INERTIA_RATIO,
        },
    )
    .expect("the disk is valid")
}

/// The disk under |v|^`alpha`.
pub fn power(alpha: f64) -> Slider<f64, DiskTable64> {
    let table = DiskTable64::new(alpha).expect("the exponent is in range");
    Slider::new(
        table,
        SliderParameters {
            deceleration: MU_G,
            radius: RADIUS,
            inertia_ratio: INERTIA_RATIO,
        },
    )
    .expect("the disk is valid")
}

/// Relative distance of two numbers.
pub fn relative(got: f64, wanted: f64) -> f64 {
    Reference::exact(wanted).relative(got)
}
