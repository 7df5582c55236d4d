//! Round contacts: directions, units, reversal to the bit, and the damping at rest.

use nalgebra::{Matrix3, Vector3};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::table::DiskTable64;
use tribos_core::coupling::{ReducedFriction, RoundFriction};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;
use tribos_tests::tolerance;

const RADIUS: f64 = 0.04;
const LOAD: f64 = 1.7;
const MU: f64 = 0.3;

fn puck<C: ReducedFriction<f64>>(coupling: C) -> RoundFriction<f64, C> {
    RoundFriction::new(coupling, MU, RADIUS).unwrap()
}

/// Twists with every quadrant, every ratio and the pure motions.
fn twists(count: usize) -> Vec<Twist<f64>> {
    let mut rng = Lcg::new(17);
    let mut out: Vec<_> = (0..count)
        .map(|_| {
            let size = rng.log_between(1e-6, 1e2);
            let spin = rng.log_between(1e-6, 1e4) * if rng.unit() < 0.5 { 1.0 } else { -1.0 };
            let (x, y) = (rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
            Twist::new(size * x, size * y, spin)
        })
        .collect();
    for (x, y) in [(1.0, 0.0), (-0.5, 0.0), (0.0, 2.0), (0.3, -0.4)] {
        out.extend([0.0, 25.0, -25.0].map(|spin| Twist::new(x, y, spin)));
    }
    out.extend([7.0, -7.0].map(|spin| Twist::new(0.0, 0.0, spin)));
    out
}

fn vector(w: Wrench<f64>) -> Vector3<f64> {
    w.into()
}

#[test]
fn reversing_the_twist_reverses_the_wrench_to_the_bit() {
    let puck = puck(CoulombDisk);
    for twist in twists(2000) {
        let back = Twist::new(-twist.velocity.x, -twist.velocity.y, -twist.spin);
        let (forth, back) = (puck.wrench(LOAD, &twist), puck.wrench(LOAD, &back));
        assert_eq!(vector(forth), -vector(back), "{twist:?}");
    }
}

#[test]
fn wrenches_have_the_magnitudes_of_the_coupling_in_units() {
    let puck = puck(CoulombDisk);
    for twist in twists(2000) {
        let wrench = puck.wrench(LOAD, &twist);
        let wanted = puck.magnitudes(LOAD, twist.speed(), twist.spin);
        let reduced = CoulombDisk.reduced_wrench(twist.speed(), twist.spin * RADIUS);
        // The speed in the wrench is rounded once, in the magnitudes by the way that never overflows.
        for (got, wanted) in [
            (wrench.force.x.hypot(wrench.force.y), wanted.force),
            (wrench.torque.abs(), wanted.torque),
            (MU * LOAD * reduced.force, wanted.force),
            (MU * LOAD * RADIUS * reduced.torque, wanted.torque),
        ] {
            let error = (got - wanted).abs();
            assert!(error <= tolerance::ROUNDING.limit * wanted, "{twist:?}");
        }
    }
}

#[test]
fn the_jacobian_at_rest_is_the_damping_of_the_law() {
    let linear = puck(DiskTable64::new(1.0).unwrap());
    let j = linear.wrench_jacobian(LOAD, &Twist::ZERO);
    let strength = MU * LOAD;
    assert_eq!(
        j,
        Matrix3::from_diagonal(&Vector3::new(
            -strength,
            -strength,
            -strength * RADIUS * RADIUS * 0.5
        ))
    );
    let dry = puck(CoulombDisk).wrench_jacobian(LOAD, &Twist::ZERO);
    assert_eq!(dry.diagonal(), Vector3::repeat(f64::NEG_INFINITY));
}
