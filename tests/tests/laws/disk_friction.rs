//! The contact in the plane: directions, symmetry, rotation and definiteness of the Jacobian.

use nalgebra::{Matrix3, Rotation3, Vector3};
use tribos_core::coupling::table::{CoulombDisk, DiskTable64};
use tribos_core::coupling::{ReducedFriction, RoundFriction, compact};
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
fn the_wrench_opposes_the_twist() {
    let puck = puck(CoulombDisk);
    for twist in twists(2000) {
        let wrench = puck.wrench(LOAD, &twist);
        let (v, f) = (twist.velocity, wrench.force);
        assert!(v.dot(&f) <= 0.0 && twist.spin * wrench.torque <= 0.0);
        // Parallel to the velocity, and never stronger than sliding alone.
        let cross = v.x * f.y - v.y * f.x;
        assert!(
            cross.abs() <= tolerance::ROUNDING.limit * v.norm() * f.norm(),
            "{twist:?}"
        );
        assert!(f.norm() <= MU * LOAD * (1.0 + tolerance::ROUNDING.limit));
        assert!(
            wrench.torque.abs()
                <= MU * LOAD * RADIUS * (2.0 / 3.0) * (1.0 + tolerance::ROUNDING.limit)
        );
    }
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
fn a_batch_is_its_single_wrenches_to_the_bit() {
    let puck = puck(CoulombDisk);
    let twists = twists(100);
    let mut wrenches = vec![Wrench::ZERO; twists.len() + 1];
    puck.wrench_batch(LOAD, &twists, &mut wrenches);
    for (twist, wrench) in twists.iter().zip(&wrenches) {
        assert_eq!(puck.wrench(LOAD, twist), *wrench);
    }
    assert_eq!(wrenches[twists.len()], Wrench::ZERO);
}

#[test]
fn the_wrench_has_the_magnitudes() {
    let puck = puck(CoulombDisk);
    for twist in twists(2000) {
        let wrench = puck.wrench(LOAD, &twist);
        let wanted = puck.magnitudes(LOAD, twist.speed(), twist.spin);
        let force = wrench.force.x.hypot(wrench.force.y);
        assert!(
            (force - wanted.force).abs() <= tolerance::ROUNDING.limit * wanted.force,
            "{twist:?}"
        );
        // The speed in the wrench is rounded once, in the magnitudes by the way that never overflows.
        assert!(
            (wrench.torque.abs() - wanted.torque).abs()
                <= tolerance::ROUNDING.limit * wanted.torque,
            "{twist:?}"
        );
    }
}

#[test]
fn magnitudes_carry_the_units() {
    let puck = puck(CoulombDisk);
    for twist in twists(200) {
        let reduced = CoulombDisk.reduced_wrench(twist.speed(), twist.spin * RADIUS);
        let got = puck.magnitudes(LOAD, twist.speed(), twist.spin);
        assert!(
            (got.force - MU * LOAD * reduced.force).abs() <= tolerance::ROUNDING.limit * got.force
        );
        assert!(
            (got.torque - MU * LOAD * RADIUS * reduced.torque).abs()
                <= tolerance::ROUNDING.limit * got.torque
        );
    }
}

/// Laws whose friction never weakens, and one that does.
fn convex() -> Vec<(f64, RoundFriction<f64, DiskTable64>)> {
    [0.0, 0.3, 1.0, 2.5, 6.0]
        .map(|alpha| (alpha, puck(DiskTable64::new(alpha).unwrap())))
        .into()
}

#[test]
fn the_jacobian_is_symmetric_and_negative_semidefinite_for_rising_laws() {
    for (alpha, puck) in convex() {
        for twist in twists(500) {
            let j = puck.wrench_jacobian(LOAD, &twist);
            assert_eq!(j, j.transpose());
            // Lengths in units of the radius, so that all entries have one unit.
            let unit = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 1.0 / RADIUS));
            let scaled = unit * j * unit;
            let largest = scaled.symmetric_eigenvalues().max();
            assert!(
                largest <= tolerance::EIGENVALUE.limit * scaled.norm(),
                "alpha {alpha}, {twist:?}: {largest:e}"
            );
        }
    }
}

#[test]
fn weakening_laws_are_not_dissipative_in_the_small() {
    let puck = puck(DiskTable64::new(-0.5).unwrap());
    let j = puck.wrench_jacobian(LOAD, &Twist::new(1.0, 0.0, 1.0));
    assert!(j.symmetric_eigenvalues().max() > 0.0);
}

#[test]
fn wrench_and_jacobian_turn_with_the_frame() {
    for (alpha, puck) in convex() {
        let mut rng = Lcg::new(23);
        for twist in twists(200) {
            let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), rng.between(-3.0, 3.0));
            let motion = Vector3::new(twist.velocity.x, twist.velocity.y, twist.spin);
            let turned = Twist::from(turn * motion);
            let wanted = turn * vector(puck.wrench(LOAD, &twist));
            let got = vector(puck.wrench(LOAD, &turned));
            // Turning rounds the speed by an ulp or two, which the law raises to its power.
            let bound = (4.0 + 2.0 * alpha) * tolerance::IDENTITY.limit;
            let error = (got - wanted).xy().norm() / wanted.xy().norm().max(f64::MIN_POSITIVE);
            assert!(error <= bound, "alpha {alpha}, {twist:?}: {error:e}");
            let matrix = turn.matrix();
            let wanted = matrix * puck.wrench_jacobian(LOAD, &twist) * matrix.transpose();
            let got = puck.wrench_jacobian(LOAD, &turned);
            let error = (got - wanted).norm() / wanted.norm();
            assert!(error <= 4.0 * bound, "alpha {alpha}, {twist:?}: {error:e}");
        }
    }
}

#[test]
fn the_jacobian_matches_differences_of_the_wrench() {
    for puck in [
        puck(compact::CompactPower::new(0.0).unwrap()),
        puck(compact::CompactPower::new(1.7).unwrap()),
    ] {
        for twist in twists(300) {
            let rim = (twist.spin * RADIUS).abs();
            let (major, minor) = (twist.speed().max(rim), twist.speed().min(rim));
            // Away from the kinks of |v| and |ω| and from equal speeds of the Coulomb law.
            if minor < 1e-3 * major || (major - minor) < 1e-2 * major {
                continue;
            }
            let j = puck.wrench_jacobian(LOAD, &twist);
            let step = major * 2.0_f64.powi(-20);
            let motion = Vector3::new(twist.velocity.x, twist.velocity.y, twist.spin);
            for (column, size) in [(0, step), (1, step), (2, step / RADIUS)] {
                let mut d = Vector3::zeros();
                d[column] = size;
                let (p, m) = (Twist::from(motion + d), Twist::from(motion - d));
                let difference =
                    (vector(puck.wrench(LOAD, &p)) - vector(puck.wrench(LOAD, &m))) / (2.0 * size);
                let error = (difference - j.column(column)).norm();
                assert!(
                    error <= tolerance::DIFFERENCES_IN_PLANE.limit * j.norm(),
                    "{twist:?}, column {column}: {error:e}"
                );
            }
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
