//! Each law without memory against what its source says of it.

use tribos_core::law::{
    AgeingLaw, CoulombLaw, DryFriction, LawError, LocalLaw, LuGre, LuGreParameters,
    PlateauPowerLaw, PlateauPowerLawParameters, RateState, RateStateParameters, RestTime,
    RisingLaw, RisingLawParameters, Savkoor, SavkoorParameters, StaticAgeing, StickSlip, Stribeck,
    StribeckParameters, TanhLaw,
};
use tribos_tests::laws::{differentiated, lugre, plateau, rate_state, stribeck};
use tribos_tests::sweep::Lcg;

#[test]
fn a_body_slips_beyond_static_friction_only() {
    let wood = DryFriction::new(0.5_f64, 0.3).unwrap();
    for drive in [0.5_f64, -0.5, 0.0, 0.49] {
        assert_eq!(wood.at_rest(drive), StickSlip::Stick);
        assert_eq!(wood.net_drive(drive), 0.0);
    }
    for drive in [0.5_f64.next_up(), -0.7, f64::INFINITY, f64::NAN] {
        assert_eq!(wood.at_rest(drive), StickSlip::Slip);
    }
    assert_eq!(wood.net_drive(0.75), 0.75 - 0.3);
    assert_eq!(wood.net_drive(-0.75), 0.3 - 0.75);
    assert!(wood.net_drive(f64::NAN).is_nan());
}

#[test]
fn a_slope_holds_up_to_the_angle_of_friction() {
    for mu in [0.0_f64, 0.1, 0.25, 1.0 / 3.0, 1.0, 5.0] {
        let angle = CoulombLaw::new(mu).unwrap().friction_angle();
        let law = DryFriction::new(mu, 0.6 * mu).unwrap();
        assert!((angle.tan() - mu).abs() < 1e-14 * (1.0 + mu * mu));
        assert_eq!(law.at_rest((angle - 1e-9).max(0.0).tan()), StickSlip::Stick);
        assert_eq!(law.at_rest((angle + 1e-9).tan()), StickSlip::Slip);
    }
}

#[test]
fn static_friction_ages_with_the_logarithm_of_time() {
    let law = StaticAgeing::new(0.4, 0.03, 2.0).unwrap();
    let of = |time| law.mu_static(RestTime { time });
    for time in [0.0, 0.3, 2.0] {
        assert_eq!(of(time), 0.4);
    }
    // The same gain for every decade, four days included.
    for time in [2.0, 7.0, 3.5e4] {
        let gain = of(10.0 * time) - of(time);
        assert!((gain - 0.03 * 10.0_f64.ln()).abs() < 1e-15);
        let rate = differentiated(of, 2.0 * time);
        assert!((law.rate(RestTime { time: 2.0 * time }) / rate - 1.0).abs() < 1e-9);
    }
    assert!((of(20.0) - (0.4 + 0.03 * 10.0_f64.ln())).abs() < 1e-15);
    assert!((of(f64::MAX) - (0.4 + 0.03 * (f64::MAX / 2.0).ln())).abs() < 1e-14);
    assert_eq!(of(f64::INFINITY), f64::INFINITY);
    assert!(of(f64::NAN).is_nan());
    // Rest adds up, sliding forgets.
    let age = RestTime::ZERO
        .advance(3.0, StickSlip::Stick)
        .advance(4.0, StickSlip::Stick);
    assert_eq!(age.time, 7.0);
    assert_eq!(age.advance(1.0, StickSlip::Slip), RestTime::ZERO);
    // A drive between young and old strength.
    assert_eq!(law.at_rest(RestTime::ZERO, 0.43), StickSlip::Slip);
    assert_eq!(law.at_rest(RestTime { time: 10.0 }, 0.43), StickSlip::Stick);
}

#[test]
fn a_bell_without_width_or_height_is_refused() {
    let with = |mu_base, mu_max, speed, narrowness| {
        Savkoor::new(SavkoorParameters {
            mu_base,
            mu_max,
            speed,
            narrowness,
        })
    };
    assert!(with(0.6, 0.6, 0.5, 0.4).is_ok());
    for bad in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(with(0.6, 1.2, bad, 0.4).is_err() && with(0.6, 1.2, 0.5, bad).is_err());
    }
    let low = with(0.6, 0.5, 0.5, 0.4).unwrap_err().to_string();
    assert_eq!(
        low,
        "the largest coefficient must not be below the base coefficient"
    );
}

#[test]
fn friction_that_rises_never_falls_and_is_refused_where_it_would() {
    let with = |mu_rest, mu_fast, speed| {
        RisingLaw::new(RisingLawParameters {
            mu_rest,
            mu_fast,
            speed,
        })
    };
    for bad in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(with(0.04, 0.12, bad).is_err() && TanhLaw::new(0.8, bad).is_err());
    }
    for bad in [-0.1, f64::INFINITY, f64::NAN] {
        assert!(with(bad, 0.12, 0.04).is_err() && with(0.04, bad, 0.04).is_err());
        assert!(TanhLaw::new(bad, 0.01).is_err());
    }
    let falling = with(0.12, 0.04, 0.04).unwrap_err().to_string();
    let reason = "the coefficient of fast sliding must not be below the coefficient at rest";
    assert_eq!(falling, reason);
    // Level ends: Coulomb's law where nothing rises, and a rise from nothing keeps its digits.
    let level = with(0.12, 0.12, f64::MIN_POSITIVE).unwrap();
    assert_eq!([0.0, 1e-300, 1.0].map(|v| level.friction(v)), [0.12; 3]);
    assert_eq!([0.0, 1.0].map(|v| level.slope(v)), [0.0; 2]);
    let from_nothing = with(0.0, 1.0, 1.0).unwrap();
    assert_eq!(from_nothing.friction(1e-20), 1e-20);
    let laws: [&dyn LocalLaw<f64>; 2] = [&from_nothing, &TanhLaw::new(1.0, 1.0).unwrap()];
    for law in laws {
        let mut last = 0.0;
        for step in 1..2000 {
            let friction = law.friction(0.02 * f64::from(step));
            assert!(friction >= last && friction <= 1.0);
            last = friction;
        }
        assert_eq!(last, 1.0);
    }
}

#[test]
fn stribeck_s_minimum_is_where_its_formula_says() {
    let drop = 0.15 - 0.1;
    // δ = 1: vₛ ln((μₛ − μ_d)/(k vₛ)); δ = 2 and 1/2: Lambert's W and a root, in 40 digits.
    let exact = [
        (1.0, 0.01 * (drop / (0.5_f64 * 0.01)).ln()),
        (2.0, 0.019084020979734697),
        (0.5, 0.017601983373620282),
    ];
    for (exponent, wanted) in exact {
        let law = stribeck::<f64>(exponent, 0.5);
        let got = law.minimum().unwrap();
        assert!((got / wanted - 1.0).abs() < 1e-13, "{got} for {wanted}");
        assert!(law.slope(0.999 * got) < 0.0 && law.slope(1.001 * got) > 0.0);
        let single = stribeck::<f32>(exponent, 0.5).minimum().unwrap();
        assert!((f64::from(single) / wanted - 1.0).abs() < 1e-5);
    }
    // No rise, no fall, or a film too stiff for the fall to show.
    assert_eq!(stribeck::<f64>(2.0, 0.0).minimum(), None);
    assert_eq!(stribeck::<f64>(1.0, 5.1).minimum(), None);
    assert_eq!(stribeck::<f64>(2.0, 5.0).minimum(), None);
    let flat = DryFriction::new(0.1, 0.1).unwrap();
    assert_eq!(
        Stribeck::new(StribeckParameters {
            dry: flat,
            speed: 0.01,
            exponent: 1.0,
            viscous: 0.5
        })
        .unwrap()
        .minimum(),
        None
    );
}

#[test]
fn stribeck_runs_from_boundary_to_hydrodynamic_friction() {
    for exponent in [0.5, 1.0, 2.0] {
        let law = stribeck::<f64>(exponent, 0.5);
        assert_eq!(law.friction(0.0), 0.15);
        let wanted = 0.1 + 0.05 * (-1.0_f64).exp() + 0.005;
        assert!((law.friction(0.01) - wanted).abs() < 1e-16);
        assert!((law.friction(1e3) - 500.1).abs() < 1e-12);
        assert_eq!(
            law.boundary(0.02) + law.hydrodynamic(0.02),
            law.friction(0.02)
        );
    }
    assert_eq!(stribeck::<f64>(0.5, 0.5).slope(0.0), f64::NEG_INFINITY);
    let drop = 0.15 - 0.1;
    assert!((stribeck::<f64>(1.0, 0.5).slope(0.0) - (0.5 - drop / 0.01)).abs() < 1e-14);
    assert_eq!(stribeck::<f64>(2.0, 0.5).slope(0.0), 0.5);
}

#[test]
fn the_plateau_joins_ice_at_rest_to_fast_sliding() {
    for alpha in [-0.19, -0.5, -0.75] {
        for rest in [0.0, 0.5, 1.0] {
            let law = plateau::<f64>(alpha, rest);
            let top = 0.008 * 1e-4_f64.powf(alpha);
            assert!((law.friction(0.0) / top - rest).abs() < 1e-15);
            // Nowhere farther from the two branches than documented, and below both.
            let mut rng = Lcg::new(59);
            for _ in 0..500 {
                let v = rng.log_between(1e-4, 1e2);
                let gap = 1.0 - law.friction(v) / (0.008 * v.powf(alpha));
                let bound = -alpha / 2.0 * (1e-4 / v).powi(2) + (1.0 - rest) * 1e-7 / v;
                assert!((-1e-14..=bound * (1.0 + 1e-9) + 1e-14).contains(&gap));
                let v = rng.log_between(1e-7, 1e-4);
                let gap = 1.0 - law.friction(v) / top;
                let bound = -alpha / 2.0 * (v / 1e-4).powi(2) + (1.0 - rest) * 1e-7 / v;
                assert!((-1e-14..=bound * (1.0 + 1e-9) + 1e-14).contains(&gap));
            }
            // The two decades of fig. 3.19 are flat within (1 − r)/11.
            let flat = law.friction(1e-6) / top;
            assert!(1.0 - flat <= (1.0 - rest) / 11.0 + 1e-4);
        }
    }
    assert_eq!(plateau::<f64>(-0.5, 0.5).friction(f64::INFINITY), 0.0);
}

#[test]
fn senseless_laws_are_refused() {
    assert_eq!(
        DryFriction::new(0.3, 0.5),
        Err(LawError::Order {
            smaller: "dynamic coefficient",
            larger: "static coefficient"
        })
    );
    let dry = DryFriction::new(0.5, 0.3).unwrap();
    let stribeck = |speed, exponent| {
        let viscous = 0.0;
        Stribeck::new(StribeckParameters {
            dry,
            speed,
            exponent,
            viscous,
        })
        .is_err()
    };
    let plateau = |alpha, plateau_speed, drop_speed, rest_share| {
        let coefficient = 1.0;
        let parameters = PlateauPowerLawParameters {
            alpha,
            coefficient,
            plateau_speed,
            drop_speed,
            rest_share,
        };
        PlateauPowerLaw::new(parameters).is_err()
    };
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(stribeck(bad, 1.0) && stribeck(1.0, bad));
        assert!(StaticAgeing::new(0.3, 0.1, bad).is_err());
        assert!(plateau(-0.5, bad, 1e-9, 0.5) && plateau(-0.5, 1e-4, bad, 0.5));
        assert!(lugre::<f64>().steady_per_load(bad).is_err());
        let parameters = *rate_state::<f64>(0.01, 0.02, 0.0).parameters();
        let with_a = RateStateParameters {
            a: bad,
            ..parameters
        };
        assert!(RateState::<_, AgeingLaw>::new(with_a).is_err());
        let parameters = *lugre::<f64>().parameters();
        let with_force = LuGreParameters {
            coulomb_force: bad,
            ..parameters
        };
        assert!(LuGre::new(with_force).is_err());
    }
    assert!(plateau(-0.5, 1e-4, 1e-3, 0.5));
    assert!(plateau(-0.5, 1e-4, 1e-6, 1.5));
    assert!(plateau(0.5, 1e-4, 1e-6, 0.5));
    let message = StaticAgeing::new(0.3, 0.1, -2.0).unwrap_err().to_string();
    assert_eq!(
        message,
        "the cut-off age must be positive and finite, not -2"
    );
}
