//! Surfaces of patches by name against independent numbers.

use super::*;
use tribos_core::real::Real;
use tribos_friction::Patch;

fn surface(patch: &str, bond: &str, contact: &OnsetContact) -> OnsetSurface {
    let (patch, bond) = (patch.parse::<Patch>(), bond.parse());
    OnsetSurface::new(&patch.unwrap(), bond.unwrap(), contact, 7).unwrap()
}

fn ratio(patch: &str, bond: &str) -> f64 {
    surface(patch, bond, &OnsetContact::default())
        .summary()
        .arm_ratio()
}

/// One strength: polar moment over the square of the reach. Yielding bonds: mean distance over the reach.
/// Exponential: the largest mean of r² e^(−r s) e s over s; disk and square by scipy, 1e-10.
#[test]
fn every_patch_has_its_ratio_of_torque_to_force() {
    let root = 2.0_f64.sqrt();
    for (patch, one, plastic) in [
        ("disk", 0.5, 2.0 / 3.0),
        ("ring", 1.0, 1.0),
        ("annulus:0.5", 0.625, 2.0 / 3.0 * 0.875 / 0.75),
        ("hertz", 0.4, 3.0 * std::f64::consts::PI / 16.0),
        ("paraboloid", 1.0 / 3.0, 8.0 / 15.0),
        ("polynomial:1,-1", 1.0 / 3.0, 8.0 / 15.0),
        (
            "box:2x2",
            1.0 / 3.0,
            (root + Real::asinh(1.0_f64)) / 3.0 / root,
        ),
        ("bar:0.3", 1.0 / 3.0, 0.5),
    ] {
        assert!(
            (ratio(patch, "one-strength") - one).abs() < 1e-12,
            "{patch}"
        );
        assert!((ratio(patch, "plastic") - plastic).abs() < 1e-12, "{patch}");
    }
    let e = std::f64::consts::E;
    assert!((ratio("disk", "exponential") - 0.2354003796773 * e).abs() < 1e-5);
    let square = 0.2686572366079 * e / root;
    assert!((ratio("box:2x2", "exponential") - square).abs() < 1e-5);
}

/// The first maximum of the mean of r f(s r) over s, over the largest f: mpmath's quadrature with 20 digits, root
/// of the derivative.
#[test]
fn round_patches_on_bonds_that_soften_have_their_ratios() {
    for (patch, broad, sharp) in [
        ("hertz", 0.560_037_469_9, 0.490_496_233_9),
        ("punch", 0.765_142_056_2, 0.720_022_726_9),
        ("annulus:0.5", 0.765_860_500_7, 0.715_380_115_2),
        ("paraboloid", 0.503_750_358_6, 0.431_503_732_3),
    ] {
        assert!(
            (ratio(patch, "exponential") - broad).abs() < 1e-5,
            "{patch}"
        );
        assert!(
            (ratio(patch, "weibull:m=8") - sharp).abs() < 1e-5,
            "{patch}"
        );
    }
}

#[test]
fn forces_scale_with_the_load_and_displacements_with_the_strain() {
    let small = OnsetContact {
        coefficient: 0.4,
        load: 20.0,
        radius: 0.03,
        strain: 1e-5,
        ..OnsetContact::default()
    };
    for bond in ["weibull:m=3", "re-forming:n=30"] {
        let (unit, scaled) = (
            surface("hertz", bond, &OnsetContact::default()),
            surface("hertz", bond, &small),
        );
        for (one, other) in unit.points().iter().zip(scaled.points()) {
            let (a, b) = (one.onset, other.onset);
            assert!((b.push.force.x / 8.0 - a.push.force.x).abs() < 1e-11);
            assert!((b.push.torque / 8.0 / 0.03 - a.push.torque).abs() < 1e-11);
            let turned = b.displacement.spin * 0.03 / 10.0;
            assert!((turned - a.displacement.spin).abs() < 1e-16);
            assert!((one.of_limit - other.of_limit).abs() < 1e-11);
        }
    }
}

#[test]
fn no_onset_lies_outside_what_dry_friction_carries() {
    for patch in ["disk", "ring", "box:0.3x0.1", "bar:1"] {
        for bond in [
            "exponential",
            "weibull:m=8",
            "one-strength",
            "re-forming:n=100",
        ] {
            for heading in [0.0, 30.0] {
                let contact = OnsetContact {
                    heading,
                    ..OnsetContact::default()
                };
                let surface = surface(patch, bond, &contact);
                assert!((surface.points()[0].of_limit - 1.0).abs() < 1e-9);
                for point in surface.points() {
                    assert!(point.of_limit < 1.0 + 1e-9, "{patch} {bond} {point:?}");
                }
            }
        }
        for point in surface(patch, "plastic", &OnsetContact::default()).points() {
            assert!((point.of_limit - 1.0).abs() < 1e-12, "{patch}");
        }
    }
}

#[test]
fn static_over_dynamic_friction_is_between_one_and_two() {
    let gaps = |bond: &str| -> Vec<f64> {
        let surface = surface("disk", bond, &OnsetContact::default());
        let points = surface.points().iter();
        points
            .filter_map(|point| point.static_over_dynamic)
            .collect()
    };
    // A pure push has all of it; one strength under pure torque (1/2)/(1/3).
    let one = gaps("re-forming-one-strength");
    assert!((one[0] - 2.0).abs() < 1e-12 && (one[6] - 1.5).abs() < 1e-12);
    assert!(
        gaps("re-forming:n=1")
            .iter()
            .all(|gap| (gap - 1.0).abs() < 1e-12)
    );
    for bond in ["re-forming:n=16", "re-forming:n=64", "re-forming:n=1000"] {
        let found = gaps(bond);
        assert!(
            found.iter().all(|gap| (1.0..2.0).contains(gap)),
            "{bond} {found:?}"
        );
        assert!(found[0] > found[6]);
    }
    assert!(gaps("exponential").is_empty());
}

#[test]
fn a_centre_of_pressure_beside_the_middle_is_the_place_of_the_rotation() {
    let contact = OnsetContact {
        centre: Some([0.04, -0.02]),
        ..OnsetContact::default()
    };
    let leaning = surface("box:0.4x0.3", "plastic", &contact);
    for point in leaning.points() {
        assert!((point.of_limit - 1.0).abs() < 1e-12);
    }
    // The farthest corner from the centre of pressure, and the polar moment about it under the linear pressure:
    // that of the box without its displacement, 0.4²/12 + 0.3²/12 − 0.04² − 0.02².
    let brittle = surface("box:0.4x0.3", "one-strength", &contact).summary();
    let reach = Real::hypot(0.24_f64, 0.17);
    assert!((brittle.reach - reach).abs() < 1e-14);
    let moment = 0.25 / 12.0 - 0.002;
    assert!((brittle.torque - moment / reach).abs() < 1e-13);
    assert!((brittle.force - 1.0).abs() < 1e-13);
}

#[test]
fn contacts_and_laws_that_cannot_be_are_refused_with_a_cure() {
    let refusal = |bond: &str| bond.parse::<Bond>().unwrap_err().to_string();
    assert_eq!(
        refusal("weibul:m=2"),
        "unknown law of bonds `weibul:m=2`; did you mean `weibull`?"
    );
    assert_eq!(refusal("weibull"), "give an exponent, such as weibull:m=8");
    assert_eq!(
        refusal("re-forming:n=2.5"),
        "n: give a whole number from 1 to 1000, not 2.5"
    );
    assert_eq!(refusal("plastic:m=2"), "`plastic` takes no `m=2`");
    assert!(refusal("re-forming:n=0").contains("number of stages must be positive"));
    assert!(refusal("re-forming:n=1001").contains("1000"));
    assert!(refusal("weibull:m=0").contains("exponent must be positive"));
    for contact in [
        OnsetContact {
            coefficient: 0.0,
            ..OnsetContact::default()
        },
        OnsetContact {
            strain: f64::NAN,
            ..OnsetContact::default()
        },
        OnsetContact {
            heading: f64::INFINITY,
            ..OnsetContact::default()
        },
    ] {
        assert!(OnsetSurface::new(&Patch::Disk, Bond::Plastic, &contact, 3).is_err());
    }
    let usual = OnsetContact::default();
    assert!(OnsetSurface::new(&Patch::Disk, Bond::Plastic, &usual, 1).is_err());
}
