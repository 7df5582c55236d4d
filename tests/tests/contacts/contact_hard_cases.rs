//! Contacts at the ends: of the range of numbers, of radii, of mass, and NaN.

use nalgebra::Vector3;
use tribos_core::contact::{
    Attraction, Cohesion, Contact, ContactError, ContactFriction, ContactGeometry, CoupledFriction,
    IndependentFriction, NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::internals::project_on_disc;
use tribos_core::internals::{Masses, TangentialLoad};
use tribos_core::limit_surface::RoundLimitSurface;
use tribos_tests::contacts::{Meeting, components, vector};
use tribos_tests::sweep::{Lcg, special_f64};

fn exact(mu: f64, ratio: f64) -> RoundLimitSurface<f64, CoulombDisk> {
    RoundLimitSurface::new(CoulombDisk, mu, ratio).unwrap()
}

/// Masses whose gyration is half a length.
const HALF: Masses<f64> = Masses {
    sliding: 4.0,
    torsion: 1.0,
};
#[test]
fn no_normal_no_touch() {
    let zero = Vector3::zeros();
    assert_eq!(
        ContactGeometry::spheres(&zero, [1.0, 1.0]),
        Err(ContactError::NoNormal)
    );
    let tiny = Vector3::new(5e-324, 0.0, 0.0);
    assert_eq!(
        ContactGeometry::spheres(&tiny, [1.0, 1.0]),
        Err(ContactError::NoNormal)
    );
    let plate = |height, radius| ContactGeometry::plate(height, &Vector3::z(), radius);
    assert_eq!(plate(0.0, 1.0), Err(ContactError::NoNormal));
    assert_eq!(plate(-1.0, 1.0), Err(ContactError::NoNormal));
    let x = Vector3::x();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(
            ContactGeometry::spheres(&x, [bad, 1.0]),
            Err(ContactError::NotFinite)
        );
        assert_eq!(
            ContactGeometry::spheres(&x, [1.0, bad]),
            Err(ContactError::NotFinite)
        );
        assert_eq!(plate(1.0, bad), Err(ContactError::NotFinite));
    }
    assert_eq!(
        ContactGeometry::spheres(&x, [1e308, 1e308]),
        Err(ContactError::NotFinite)
    );
    let lost = Vector3::new(0.0, f64::NAN, 0.0);
    assert_eq!(
        ContactGeometry::spheres(&lost, [1.0, 1.0]),
        Err(ContactError::NotFinite)
    );
    assert_eq!(plate(f64::NAN, 1.0), Err(ContactError::NotFinite));
}

#[test]
fn a_small_sphere_keeps_the_digits_of_its_arm() {
    for ratio in [1.1e3_f64, 1.3e6, 1.7e9, 1.9e12] {
        let radii = [ratio, 0.3];
        let touch = ContactGeometry::spheres(&Vector3::new(ratio + 0.3, 0.0, 0.0), radii).unwrap();
        let [large, small] = touch.arms;
        assert!((small / 0.3 - 1.0).abs() < 1e-15, "{ratio}: {small}");
        assert!((large / ratio - 1.0).abs() < 1e-15);
        assert!((touch.lever * (1.0 / ratio + 1.0 / 0.3) - 1.0).abs() < 1e-15);
    }
}

#[test]
fn spheres_a_million_times_as_large_stick_and_slip_like_a_wall() {
    let large = 1e6_f64;
    let touch =
        ContactGeometry::spheres(&Vector3::new(0.0, 0.0, large + 1.0), [large, 1.0]).unwrap();
    let law = NormalLaw::new(Cohesion::NONE, 0.0).unwrap();
    let small = SphereBody {
        velocity: Vector3::new(1.0, 0.0, -1.0),
        spin: Vector3::zeros(),
        inv_mass: 1.0,
        inv_inertia: 2.5,
    };
    let mass = large.powi(3);
    let ground = SphereBody {
        velocity: Vector3::zeros(),
        spin: Vector3::zeros(),
        inv_mass: 1.0 / mass,
        inv_inertia: 2.5 / (mass * large * large),
    };
    for mu in [0.1, 0.2, 1.0] {
        let friction = IndependentFriction::all(mu, 0.05, 0.05).unwrap();
        let (mut a, mut b) = (ground, small);
        let mut contact = Contact::new(&touch, &law, &a, &b, 0.01);
        contact.update(&friction, &mut a, &mut b);
        let (mut ball, mut wall) = (
            small,
            WallBody {
                velocity: Vector3::zeros(),
                inv_mass: 0.0,
            },
        );
        let touch = ContactGeometry::plate(1.0, &Vector3::z(), 1.0).unwrap();
        let mut contact = Contact::new(&touch, &law, &ball, &wall, 0.01);
        contact.update(&friction, &mut ball, &mut wall);
        assert!((ball.velocity - b.velocity).norm() < 2e-6, "{ball:?} {b:?}");
        assert!((ball.spin - b.spin).norm() < 2e-6, "{ball:?} {b:?}");
    }
}

/// Every bit pattern into every field gives numbers or NaN, never a panic.
#[test]
fn nothing_panics_and_nan_stays_nan() {
    let mut rng = Lcg::new(71);
    let special = special_f64();
    let all = IndependentFriction::all(0.3, 0.1, 0.1).unwrap();
    let coupled = CoupledFriction::all(exact(0.3, 0.5), 0.1).unwrap();
    for round in 0..20_000 {
        let meeting = Meeting::<f64>::random(&mut rng, [1.0, 0.5]);
        let value = special[rng.bits() as usize % special.len()];
        let mut hit = meeting;
        let at = (round / 7) % 3;
        let only_in_plane = match round % 7 {
            0 => {
                hit.spheres[0].velocity[at] = value;
                false
            }
            1 => {
                hit.spheres[1].spin[at] = value;
                true
            }
            2 => {
                hit.spheres[0].inv_mass = value;
                false
            }
            3 => {
                hit.spheres[1].inv_inertia = value;
                true
            }
            4 => {
                hit.touch.gap = value;
                false
            }
            5 => {
                hit.dt = value;
                false
            }
            _ => {
                hit.touch.lever = value;
                true
            }
        };
        let (one, after) = hit.updated(&all);
        let (two, _) = hit.updated(&coupled);
        if value.is_nan() {
            let (one, two) = (components(one.impulse()), components(two.impulse()));
            assert!(
                only_in_plane || (one[0].is_nan() && two[0].is_nan()),
                "{hit:?}"
            );
            // Closed contacts only have friction that could tell.
            let pressed =
                meeting.contact(&all).cohesion() + meeting.updated(&all).0.impulse().normal;
            if pressed > 0.0 && only_in_plane {
                assert!(one[1..].iter().any(|x| x.is_nan()), "{hit:?}");
                assert!(two[1..].iter().any(|x| x.is_nan()), "{hit:?}");
            }
            assert!(
                after
                    .iter()
                    .any(|s| s.spin.iter().any(|x| x.is_nan())
                        || s.velocity.iter().any(|x| x.is_nan()))
                    || pressed == 0.0
            );
        }
    }
}

#[test]
fn time_that_does_not_run_forwards_is_refused_or_nan() {
    for bad in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(TimeStep::new(bad).is_err(), "{bad}");
    }
    assert_eq!(TimeStep::new(0.5_f32).unwrap().dt(), 0.5);
    let mut rng = Lcg::new(72);
    for bad in [0.0, -1.0, f64::NAN] {
        let meeting = Meeting {
            dt: bad,
            ..Meeting::<f64>::random(&mut rng, [1.0, 1.0])
        };
        let (contact, _) = meeting.updated(&IndependentFriction::sliding(0.3).unwrap());
        assert!(contact.impulse().normal.is_nan(), "{bad}");
    }
}

#[test]
fn what_cannot_move_takes_no_impulse() {
    let mut rng = Lcg::new(73);
    let law = NormalLaw::new(Cohesion::NONE, 0.0).unwrap();
    let friction = IndependentFriction::all(0.3, 0.1, 0.1).unwrap();
    let coupled = CoupledFriction::all(exact(0.3, 0.5), 0.1).unwrap();
    let touch = ContactGeometry::plate(1.0, &Vector3::z(), 1.0).unwrap();
    let mut wall = WallBody {
        velocity: Vector3::new(1.0, 0.0, 0.5),
        inv_mass: 0.0,
    };
    // A sphere that cannot turn: it slides, and nothing about it is NaN.
    let mut stiff = SphereBody::<f64> {
        velocity: vector(&mut rng, 1.0) - Vector3::z() * 2.0,
        spin: Vector3::zeros(),
        inv_mass: 1.0,
        inv_inertia: 0.0,
    };
    let mut same = stiff;
    let mut contact = Contact::new(&touch, &law, &stiff, &wall, 0.01);
    contact.update(&friction, &mut stiff, &mut wall);
    assert_eq!(components(contact.impulse())[4..], [0.0; 4]);
    assert!(contact.impulse().normal > 0.0 && stiff.velocity.iter().all(|x| x.is_finite()));
    let mut contact = Contact::new(&touch, &law, &same, &wall, 0.01);
    contact.update(&coupled, &mut same, &mut wall);
    assert!((same.velocity - stiff.velocity).norm() < 1e-14);
    // Two that cannot move at all.
    let mut fixed = SphereBody {
        inv_mass: 0.0,
        ..stiff
    };
    let before = fixed;
    let mut contact = Contact::new(&touch, &law, &fixed, &wall, 0.01);
    contact.update(&friction, &mut fixed, &mut wall);
    contact.update(&friction, &mut fixed, &mut wall);
    assert_eq!((components(contact.impulse()), fixed), ([0.0; 8], before));
    // One that turns about a fixed centre: sliding and rolling are the same motion.
    let mut wheel = SphereBody {
        velocity: Vector3::zeros(),
        inv_inertia: 2.5,
        spin: Vector3::new(0.3, 1.0, 0.2),
        ..before
    };
    let cohesion = Cohesion::new(100.0, 1.0, Attraction::Pull).unwrap();
    let law = NormalLaw::new(cohesion, 0.0).unwrap();
    let mut slow = WallBody {
        velocity: Vector3::zeros(),
        inv_mass: 1.0,
    };
    let mut contact = Contact::new(&touch, &law, &wheel, &slow, 0.1);
    contact.update(&friction, &mut wheel, &mut slow);
    assert!(wheel.spin.norm() < 1e-14, "{wheel:?}");
}

#[test]
fn thresholds_met_exactly_hold() {
    // Powers of two: friction of exactly mu times the load, a pull of exactly the cohesion.
    let law = NormalLaw::new(Cohesion::new(4.0, 1.0, Attraction::Pull).unwrap(), 0.0).unwrap();
    let ball = |x: f64, z: f64| SphereBody {
        velocity: Vector3::new(x, 0.0, z),
        spin: Vector3::zeros(),
        inv_mass: 1.0,
        inv_inertia: 0.0,
    };
    let mut wall = WallBody {
        velocity: Vector3::zeros(),
        inv_mass: 0.0,
    };
    let touch = ContactGeometry::plate(1.0, &Vector3::z(), 1.0).unwrap();
    assert_eq!(touch.gap, 0.0);
    let friction = IndependentFriction::sliding(0.5).unwrap();
    let mut met = |mut ball: SphereBody<f64>| {
        let mut contact = Contact::new(&touch, &law, &ball, &wall, 0.25);
        contact.update(&friction, &mut ball, &mut wall);
        (ball, contact.bound())
    };
    // P = 1 + 1, friction up to 1.
    assert_eq!(met(ball(1.0, -1.0)), (ball(0.0, 0.0), 2.0));
    assert_eq!(met(ball(1.5, -1.0)), (ball(0.5, 0.0), 2.0));
    // The whole cohesion is used: held, but without friction.
    assert_eq!(met(ball(1.0, 1.0)), (ball(1.0, 0.0), 0.0));
    assert_eq!(met(ball(1.0, 1.25)), (ball(1.0, 0.25), 0.0));
}

#[test]
fn discs_of_any_scale() {
    let direction = Vector3::new(2.0, -1.0, 2.0) / 3.0;
    for (size, bound) in [
        (1e-300_f64, 5e-301_f64),
        (1e300, 5e299),
        (1e-310, 1e-311),
        (1.0, 1e-300),
        (1e200, 1e-100),
        (1e-200, 3e-201),
        (1e308, 1.0),
    ] {
        let held = project_on_disc(&(direction * size), bound);
        let wanted = direction * bound;
        let miss = (held - wanted).iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        assert!(miss <= 1e-14 * bound + 5e-324, "{size} {bound}: {held:?}");
        let inside = direction * size;
        assert_eq!(project_on_disc(&inside, 2.0 * size.min(8e307)), inside);
    }
    let nan = |v: Vector3<f64>| v.iter().any(|x| x.is_nan());
    assert!(nan(project_on_disc(&Vector3::new(f64::NAN, 0.0, 0.0), 1.0)));
    assert!(nan(project_on_disc(&direction, f64::NAN)));
    assert!(nan(project_on_disc(
        &Vector3::new(f64::INFINITY, 0.0, 0.0),
        1.0
    )));
    assert_eq!(project_on_disc(&direction, f64::INFINITY), direction);
    assert_eq!(project_on_disc(&direction, 0.0).norm(), 0.0);
}

#[test]
fn coupled_sets_of_any_scale() {
    let friction = CoupledFriction::sliding_torsion(exact(0.5, 0.25));
    let shape = TangentialLoad {
        sliding: Vector3::new(2.0, 1.0, 0.0),
        torsion: -0.5,
    };
    let wanted = friction.hold(&shape, 1.0, 1.0, &HALF);
    assert!(wanted != shape);
    for scale in [1e-290, 1e-100, 1e100, 1e290] {
        let trial = TangentialLoad {
            sliding: shape.sliding * scale,
            torsion: shape.torsion * scale,
        };
        let got = friction.hold(&trial, scale, 1.0, &HALF);
        assert!(
            (got.sliding / scale - wanted.sliding).norm() < 1e-14,
            "{scale}"
        );
        assert!(
            (got.torsion / scale - wanted.torsion).abs() < 1e-14,
            "{scale}"
        );
    }
    // A contact that is all but open: far outside, and still on the set.
    for bound in [1e-30, 1e-100, 1e-300] {
        let got = friction.hold(&shape, bound, 1.0, &HALF);
        let size = (got.sliding / bound).norm();
        assert!(
            size > 0.1 && size <= 0.5 * (1.0 + 1e-14),
            "{bound}: {got:?}"
        );
        assert!(got.torsion < 0.0);
    }
    let open = friction.hold(&shape, 0.0, 1.0, &HALF);
    assert_eq!((open.sliding.norm(), open.torsion), (0.0, 0.0));
    let smooth = CoupledFriction::sliding_torsion(exact(0.0, 0.25));
    let free = smooth.hold(&shape, 1.0, 1.0, &HALF);
    assert_eq!((free.sliding.norm(), free.torsion), (0.0, 0.0));
}
