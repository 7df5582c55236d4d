//! Force and torque that are limited each by itself.

use tribos_core::limit_surface::{FrictionSet, Projection, Region};
use tribos_core::twist::{Twist, Wrench};
use tribos_web::all::separate::Separate;

const SET: Separate = Separate {
    force_limit: 0.5,
    torque_limit: 0.01,
    radius: 0.04,
};

#[test]
fn force_and_torque_do_not_know_of_each_other() {
    let push = Wrench::new(0.6, 0.8, 0.004);
    let Projection { wrench, region } = SET.project(&push);
    assert_eq!(wrench, Wrench::new(0.3, 0.4, 0.004));
    let Region::OnSurface { normal } = region else {
        panic!("1 N is more than 0.5 N")
    };
    assert!((normal.velocity.x - 0.6).abs() < 1e-15 && normal.spin == 0.0);
    assert_eq!(SET.gauge(&push), 2.0);
    assert_eq!(SET.gauge(&Wrench::new(0.0, 0.0, -0.03)), 3.0);
    let held = Wrench::new(0.3, -0.3, 0.009);
    assert_eq!(SET.project(&held).wrench, held);
    assert_eq!(SET.project(&held).region, Region::Inside);
}

#[test]
fn friction_attains_the_support() {
    for twist in [
        Twist::new(3.0, 4.0, -2.0),
        Twist::new(0.0, 0.0, 1.0),
        Twist::new(1.0, 0.0, 0.0),
    ] {
        let friction = SET.wrench(&twist);
        assert!((SET.support(&twist) + friction.power(&twist)).abs() < 1e-15);
        assert!((SET.gauge(&friction) - 1.0).abs() < 1e-15);
    }
    assert_eq!(SET.wrench(&Twist::ZERO), Wrench::ZERO);
    assert!(SET.wrench(&Twist::new(f64::NAN, 0.0, 1.0)).force.x.is_nan());
    assert!(SET.gauge(&Wrench::new(0.0, f64::NAN, 1.0)).is_nan());
}
