//! Inputs that broke a property once, found by `--bin fuzz`, in the smallest form.
use tribos_core::coupling::RoundFriction;
use tribos_core::coupling::coulomb::CoulombHertz;
use tribos_core::internals::tripod_shares;
use tribos_core::law::{AgeingLaw, CoulombLaw, LocalLaw, PowerLaw, SlipLaw, StateEvolution};
use tribos_core::limit_surface::{FrictionSet, LimitEllipsoid, RoundLimitSurface};
use tribos_core::twist::{Twist, Wrench};

type Outcome = Result<(), Box<dyn std::error::Error>>;

#[test]
fn coulomb_s_law_does_not_launder_nan() -> Outcome {
    let law = CoulombLaw::new(0.5)?;
    assert!(law.friction(f64::NAN).is_nan());
    assert!(law.slope(f64::NAN).is_nan());
    assert_eq!([law.friction(3.0), law.slope(3.0)], [0.5, 0.0]);
    Ok(())
}

#[test]
fn a_power_law_does_not_launder_nan_and_without_a_coefficient_is_nothing() -> Outcome {
    for alpha in [0.0, 1.0, 2.0] {
        let law = PowerLaw::new(alpha, 0.5)?;
        assert!(law.friction(f64::NAN).is_nan() && law.slope(f64::NAN).is_nan());
        // The power overflows.
        let none = PowerLaw::new(alpha, 0.0)?;
        assert_eq!([none.friction(1e300), none.slope(1e300)], [0.0; 2]);
    }
    Ok(())
}

#[test]
fn an_ellipsoid_without_an_arm_is_refused() {
    // radius × torque is less than the smallest number.
    assert!(LimitEllipsoid::new(2.0, 1e-200, 1e-200).is_err());
}

#[test]
fn an_ellipsoid_of_any_spin_torque_has_the_gauge_of_its_limits() -> Outcome {
    for spin_torque in [1e-150, 1e-20, 1e20, 1e150] {
        let set = LimitEllipsoid::new(2.0, 1.0, spin_torque)?;
        let torque = 0.8 * set.torque_limit();
        for [x, torque, gauge] in [[-1.0, 0.0, 0.5_f64], [0.0, torque, 0.8], [1.2, torque, 1.0]] {
            let found = set.gauge(&Wrench::new(x, 0.0, torque));
            assert!((found - gauge).abs() < 1e-15, "{spin_torque}: {found}");
        }
    }
    // Without a load a push of any size is too much.
    let none = LimitEllipsoid::new(0.0, f64::MAX, 1.0)?;
    assert_eq!(none.gauge(&Wrench::new(1e-45, 0.0, 1e-45)), f64::INFINITY);
    Ok(())
}

#[test]
fn a_contact_without_age_has_none_after_a_slide_beyond_the_range_of_numbers() {
    // speed × time overflows.
    assert_eq!(SlipLaw::evolved(0.0, 1e300, 1.0, 1e300), 0.0);
    assert_eq!(AgeingLaw::evolved(0.0, 1e300, 1.0, 1e300), 1e-300);
    assert!(SlipLaw::evolved(0.0, f64::NAN, 1.0, 1.0).is_nan());
}

#[test]
fn a_force_limit_of_minus_zero_is_none() -> Outcome {
    let set = RoundLimitSurface::new(CoulombHertz, -0.0, 1.0)?;
    let push = Wrench::new(1.0, 0.0, 0.5);
    assert_eq!(set.gauge(&push), f64::INFINITY);
    Ok(())
}

#[test]
fn a_spin_that_is_no_number_leaves_no_force() -> Outcome {
    let puck = RoundFriction::<f64, _>::new(CoulombHertz, 0.5, 1.0)?;
    let wrench = puck.wrench(1.0, &Twist::new(0.0, 0.0, f64::NAN));
    assert!(wrench.force.x.is_nan() && wrench.force.y.is_nan() && wrench.torque.is_nan());
    let spinning = puck.wrench(1.0, &Twist::new(0.0, 0.0, 2.0));
    assert_eq!(spinning.force, Wrench::ZERO.force);
    Ok(())
}

#[test]
fn feet_in_a_line_but_for_rounding_are_refused() {
    // 0.1 + 0.2 is not 0.3: the area is a rounding error.
    let feet = [[0.0, 0.0], [0.1 + 0.2, 1.0], [0.3 * 3.0, 3.0]];
    if let Ok(shares) = tripod_shares(feet, [0.3, 1.0]) {
        assert!(shares.iter().all(|share| *share <= 2.0), "{shares:?}");
    }
    // An area below the range of numbers is none.
    assert!(tripod_shares([[0.0, 0.0], [1e-160, 0.0], [0.0, 1e-160]], [1.0, 1.0]).is_err());
    assert!(
        tripod_shares(
            [[0.0, 0.0], [1e-150, 0.0], [1e-150, 1e-150]],
            [1e-150, 0.5e-150]
        )
        .is_ok()
    );
}
