//! Reasons of refusals.

use tribos_core::Error;
use tribos_core::coupling::{RoundFriction, coulomb::CoulombDisk};
use tribos_core::limit_surface::RoundLimitSurface;
use tribos_core::modes::TerminalMotion;
use tribos_core::planar::PlanarBody;
use tribos_core::slider::{Slider, SliderParameters};
use tribos_web::exchange::words_of;

#[test]
fn reasons_without_formatting_are_those_of_the_kernel() {
    let parameters = SliderParameters {
        deceleration: -1.5,
        radius: 0.04,
        inertia_ratio: 0.5,
    };
    let still = SliderParameters {
        deceleration: 3.0,
        inertia_ratio: -2.0,
        ..parameters
    };
    let errors: [Error; 8] = [
        RoundFriction::new(CoulombDisk, -0.5, 0.04).unwrap_err(),
        RoundFriction::new(CoulombDisk, 0.5, -0.04).unwrap_err(),
        RoundLimitSurface::new(CoulombDisk, -0.5, 0.04).unwrap_err(),
        PlanarBody::new(-1.0, 1.0).unwrap_err().into(),
        PlanarBody::new(1.0, f64::NAN).unwrap_err().into(),
        tribos_core::contact::TimeStep::new(0.0).unwrap_err().into(),
        Slider::new(CoulombDisk, parameters).unwrap_err(),
        Slider::new(CoulombDisk, still).unwrap_err(),
    ];
    for error in errors {
        let (words, given) = words_of(&error);
        let given = given.expect("a number belongs to it");
        assert_eq!(format!("{}{given}", words.concat()), error.to_string());
    }
    let modes: Error = TerminalMotion::new(CoulombDisk, 0.0).unwrap_err().into();
    let (words, given) = words_of(&modes);
    assert_eq!(
        format!("{}{}", words.concat(), given.unwrap()),
        modes.to_string()
    );
}
