//! Tall bodies: leaning pressures by brute force, the balance of moments, tipping, the ends.

use tribos_core::coupling::coulomb::{CoulombHertz, CoulombRing};
use tribos_core::coupling::load_transfer::{
    FullGradient, LoadTransferFriction, LongitudinalGradient, PressureGradient,
};
use tribos_core::coupling::{LateralFriction, ReducedFriction, RoundFriction, coulomb};
use tribos_core::coupling::{ReducedJacobian, ReducedWrench};
use tribos_core::internals::LateralJacobian;
use tribos_core::internals::leaning_wrench;
use tribos_core::patch::PatchError;
use tribos_core::twist::Twist;
use tribos_tests::patches;
use tribos_tests::sweep::{Lcg, special_f64};
use tribos_tests::tilted::Tilted;
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const EXPONENTS: [f64; 4] = [0.0, 0.5, -0.5, 3.0];

/// Speeds ratios that the oracle resolves for pressures of order `order`.
fn ratios(order: f64) -> &'static [f64] {
    if order == 0.5 {
        &[1.25, 1.6, 4.0, 30.0]
    } else {
        &[1e-3, 0.2, 0.5, 0.78, 1.25, 1.6, 4.0, 30.0]
    }
}

#[test]
fn leaning_pressures_are_those_of_brute_force_in_every_direction() {
    let mut worst = Worst::of("leaning wrench - brute force (of its size)");
    for order in [-1.0, 0.0, 0.5, 1.0] {
        for alpha in EXPONENTS {
            let tiers = patches::tiers::<f64>(order, alpha);
            for &ratio in ratios(order) {
                for (n, sense) in (0..5).flat_map(|n| [(n, 1.0), (n, -1.0)]) {
                    let angle = 0.3 + 1.3 * f64::from(n);
                    let (cos, sin) = (angle.cos(), angle.sin());
                    let gradient = [0.4 - 0.2 * f64::from(n), 0.1 + 0.17 * f64::from(n)];
                    let along = gradient[0] * cos + gradient[1] * sin;
                    let left = gradient[1] * cos - gradient[0] * sin;
                    let oracle = Tilted {
                        order,
                        alpha,
                        gradient,
                    };
                    let [x, y, torque] = oracle.wrench([ratio * cos, ratio * sin], sense);
                    let size = x.hypot(y) + torque.abs();
                    let right = x * sin - y * cos;
                    for (name, tier) in &tiers {
                        let lean = [along, left * sense];
                        let got = leaning_wrench(&tier.as_ref(), [ratio, 1.0], lean);
                        let place =
                            || format!("{name}, q {order}, alpha {alpha}, eps {ratio}, {n}");
                        worst.see((got.force + x * cos + y * sin).abs() / size, place);
                        worst.see((got.lateral * sense - right).abs() / size, place);
                        worst.see((got.torque + torque * sense).abs() / size, place);
                    }
                }
            }
        }
    }
    worst.assert_within(&tolerance::LEANING);
}

const LOAD: f64 = 9.81;
const RADIUS: f64 = 0.08;

/// A body on a foot with coefficient 0.2.
fn body<C: LateralFriction<f64>, L: PressureGradient>(
    coupling: C,
    height: f64,
) -> LoadTransferFriction<f64, C, L> {
    let foot = RoundFriction::new(coupling, 0.2, RADIUS).expect("in range");
    LoadTransferFriction::new(foot, height).expect("in range")
}

/// Twists of all directions and both spins.
fn twists(count: usize) -> Vec<Twist<f64>> {
    let mut rng = Lcg::new(31);
    (0..count)
        .map(|_| {
            let speed = rng.log_between(1e-3, 10.0);
            let angle = rng.between(0.0, core::f64::consts::TAU);
            let spin = rng.log_between(0.1, 500.0) * if rng.unit() < 0.5 { 1.0 } else { -1.0 };
            Twist::new(speed * angle.cos(), speed * angle.sin(), spin)
        })
        .collect()
}

#[test]
fn pressure_and_friction_balance_each_other() {
    let mut worst = Worst::of("tall body: lean + lambda F/(gamma N)");
    let mut wrench_of_lean = Worst::of("tall body: wrench of its own lean");
    for alpha in EXPONENTS {
        for (name, tier) in patches::tiers::<f64>(0.0, alpha) {
            let foot = RoundFriction::new(tier.as_ref(), 0.2, RADIUS).expect("in range");
            let tall =
                LoadTransferFriction::<_, _, FullGradient>::new(foot, 0.05).expect("in range");
            for twist in twists(300) {
                let got = tall.wrench(LOAD, &twist);
                let scale = tall.lean() / (0.2 * LOAD);
                let place = || format!("{name}, alpha {alpha}, {twist:?}");
                if got.is_lifting {
                    continue;
                }
                let size = got.lean.x.hypot(got.lean.y);
                let residual = (got.lean.x + scale * got.wrench.force.x)
                    .hypot(got.lean.y + scale * got.wrench.force.y);
                worst.see(residual / size, place);
                // The gradient, taken as given, yields the same wrench.
                let speed = twist.speed();
                let (cos, sin) = (twist.velocity.x / speed, twist.velocity.y / speed);
                let sense = 1.0_f64.copysign(twist.spin);
                let along = got.lean.x * cos + got.lean.y * sin;
                let left = (got.lean.y * cos - got.lean.x * sin) * sense;
                let speeds = [speed, (twist.spin * RADIUS).abs()];
                let again = leaning_wrench(&tier.as_ref(), speeds, [along, left]);
                let back = -(got.wrench.force.x * cos + got.wrench.force.y * sin);
                let right = (got.wrench.force.x * sin - got.wrench.force.y * cos) * sense;
                let strength = 0.2 * LOAD;
                for (one, other) in [
                    (back, again.force),
                    (right, again.lateral),
                    (-got.wrench.torque * sense / RADIUS, again.torque),
                ] {
                    let size = strength * (again.force + again.torque.abs());
                    wrench_of_lean.see((one - strength * other).abs() / size, place);
                }
            }
        }
    }
    worst.assert_within(&tolerance::BALANCE);
    wrench_of_lean.assert_within(&tolerance::BALANCE);
}

#[test]
fn friction_of_a_leaning_body_is_that_of_brute_force() {
    let mut worst = Worst::of("tall body - brute force at its lean");
    for alpha in EXPONENTS {
        let (_, tier) = patches::tiers::<f64>(0.0, alpha).remove(0);
        let foot = RoundFriction::new(tier.as_ref(), 0.2, 1.0).expect("in range");
        let tall = LoadTransferFriction::<_, _, FullGradient>::new(foot, 0.15).expect("in range");
        for (x, y, spin) in [
            (0.3, 0.2, 1.0),
            (-0.3, 0.5, -1.0),
            (0.1, -1.3, 1.0),
            (-0.9, -1.2, -1.1),
        ] {
            let got = tall.wrench(1.0, &Twist::new(x, y, spin));
            assert!(!got.is_lifting);
            let oracle = Tilted {
                order: 0.0,
                alpha,
                gradient: [got.lean.x, got.lean.y],
            };
            let wanted = oracle.wrench([x, y], spin).map(|x| 0.2 * x);
            let size = wanted[0].hypot(wanted[1]);
            let got = [got.wrench.force.x, got.wrench.force.y, got.wrench.torque];
            for (got, wanted) in got.into_iter().zip(wanted) {
                worst.see((got - wanted).abs() / size, || {
                    format!("alpha {alpha}, ({x}, {y}, {spin})")
                });
            }
        }
    }
    worst.assert_within(&tolerance::LEANING);
}

#[test]
fn front_and_back_alone_are_the_thesis_formula() {
    // 3.38: lateral force mu^2 N (H/R) F 2G; force and torque are the upright body's.
    let height = 0.16;
    let tall = body::<_, LongitudinalGradient>(coulomb::CoulombDisk, 0.5 * height);
    for twist in twists(300) {
        let (speed, rim) = (twist.speed(), (twist.spin * RADIUS).abs());
        let upright = tall.foot().wrench(LOAD, &twist);
        let got = tall.wrench(LOAD, &twist);
        assert!(!got.is_lifting);
        let force = coulomb::CoulombDisk.reduced_wrench(speed, rim).force;
        let wanted = 0.04
            * LOAD
            * (height / RADIUS)
            * force
            * 2.0
            * coulomb::CoulombDisk.lateral(speed, rim);
        let (cos, sin) = (twist.velocity.x / speed, twist.velocity.y / speed);
        let right =
            (got.wrench.force.x * sin - got.wrench.force.y * cos) * 1.0_f64.copysign(twist.spin);
        let back = got.wrench.force.x * cos + got.wrench.force.y * sin;
        let upright_back = upright.force.x * cos + upright.force.y * sin;
        let slack = 4.0 * tolerance::ROUNDING.limit * 0.2 * LOAD;
        assert!((right - wanted).abs() <= slack, "{right} {wanted}");
        assert!((back - upright_back).abs() <= slack);
        assert!((got.wrench.torque - upright.torque).abs() <= slack * RADIUS);
    }
}

#[test]
fn counterclockwise_spin_bends_the_path_to_the_right() {
    for spin in [0.5, 12.0, 300.0] {
        let tall = body::<_, FullGradient>(CoulombHertz, 0.08);
        let left = tall.wrench(LOAD, &Twist::new(1.0, 0.0, spin));
        let right = tall.wrench(LOAD, &Twist::new(1.0, 0.0, -spin));
        assert!(left.wrench.force.y < 0.0 && right.wrench.force.y > 0.0);
        let left = tall.wrench(LOAD, &Twist::new(0.0, 1.0, spin));
        assert!(left.wrench.force.x > 0.0);
        // The pressure rises towards the front.
        assert!(left.lean.y > 0.0);
    }
}

#[test]
fn a_mirrored_motion_has_the_mirrored_wrench_to_the_bit() {
    let tall = body::<_, FullGradient>(coulomb::CoulombDisk, 0.1);
    for twist in twists(500) {
        let (x, y, spin) = (twist.velocity.x, twist.velocity.y, twist.spin);
        let one = tall.wrench(LOAD, &twist);
        let other = tall.wrench(LOAD, &Twist::new(x, -y, -spin));
        assert_eq!(one.wrench.force.x, other.wrench.force.x);
        assert_eq!(one.wrench.force.y, -other.wrench.force.y);
        assert_eq!(one.wrench.torque, -other.wrench.torque);
        assert_eq!((one.lean.x, one.lean.y), (other.lean.x, -other.lean.y));
        assert_eq!(one.is_lifting, other.is_lifting);
        let turned = tall.wrench(LOAD, &Twist::new(-x, -y, spin));
        assert_eq!(one.wrench.force, -turned.wrench.force);
        assert_eq!(one.wrench.torque, turned.wrench.torque);
    }
}

/// A coupling whose numbers are at hand: F = 1, T = 0, G = 1/2, constant gradients.
#[derive(Clone, Copy, Debug)]
struct Plain;

impl ReducedFriction<f64> for Plain {
    fn reduced_wrench(&self, _: f64, _: f64) -> ReducedWrench<f64> {
        ReducedWrench {
            force: 1.0,
            torque: 0.0,
        }
    }
    fn reduced_jacobian(&self, _: f64, _: f64) -> ReducedJacobian<f64> {
        ReducedJacobian::default()
    }
}

impl LateralFriction<f64> for Plain {
    fn lateral(&self, _: f64, _: f64) -> f64 {
        0.5
    }
    fn lateral_jacobian(&self, _: f64, _: f64) -> LateralJacobian<f64> {
        LateralJacobian {
            slide: 0.0,
            rim: 0.0,
        }
    }
    fn mean_square_radius(&self) -> f64 {
        0.5
    }
}

#[test]
fn tipping_begins_exactly_where_the_trailing_edge_bears_nothing() {
    // lambda = 2 gamma h/(R/2) = 4 gamma h/R, and l = lambda for F = 1.
    let foot = RoundFriction::new(Plain, 0.25, 1.0).expect("in range");
    let at = |height: f64| {
        let tall = LoadTransferFriction::<_, _, LongitudinalGradient>::new(foot, height)
            .expect("in range");
        tall.wrench(1.0, &Twist::new(1.0, 0.0, 1.0))
    };
    let border = at(1.0);
    assert!(!border.is_lifting);
    assert_eq!(border.whole(), Ok(border.wrench));
    assert_eq!((border.lean.x, border.lean.y), (1.0, 0.0));
    let beyond = at(1.0_f64.next_up());
    assert!(beyond.is_lifting);
    let lean = 1.0_f64.next_up();
    assert_eq!(beyond.whole(), Err(PatchError::Tips { lean }));
    let far = at(4.0);
    let error = far.whole().expect_err("it tips");
    assert_eq!(error, PatchError::Tips { lean: 4.0 });
    assert!(
        error.to_string().contains("4 of what its foot can bear"),
        "{error}"
    );
    // The wrench is held at |l| = 1, the lean is reported as it is.
    assert_eq!(far.wrench, border.wrench);
    assert_eq!(far.lean.x, 4.0);
}

#[test]
fn a_tipping_body_feels_the_wrench_of_the_largest_lean_its_foot_can_bear() {
    let tall = body::<_, FullGradient>(coulomb::CoulombDisk, 0.4);
    let mut seen = 0;
    for twist in twists(300) {
        let got = tall.wrench(LOAD, &twist);
        if !got.is_lifting {
            continue;
        }
        seen += 1;
        let lean = got.lean.x.hypot(got.lean.y);
        assert!(lean > 1.0 && got.whole().is_err());
        let speed = twist.speed();
        let (cos, sin) = (twist.velocity.x / speed, twist.velocity.y / speed);
        let sense = 1.0_f64.copysign(twist.spin);
        let held = [
            got.lean.x * cos + got.lean.y * sin,
            (got.lean.y * cos - got.lean.x * sin) * sense,
        ]
        .map(|l| l / lean);
        let wanted = leaning_wrench(
            &coulomb::CoulombDisk,
            [speed, (twist.spin * RADIUS).abs()],
            held,
        );
        let back = -(got.wrench.force.x * cos + got.wrench.force.y * sin);
        let slack = tolerance::BALANCE.limit * 0.2 * LOAD;
        assert!((back - 0.2 * LOAD * wanted.force).abs() <= slack);
        assert!((got.wrench.torque * sense + 0.2 * LOAD * RADIUS * wanted.torque).abs() <= slack);
    }
    assert!(seen > 20, "only {seen} tip");
}

#[test]
fn a_body_without_height_is_its_foot() {
    let tall = body::<_, FullGradient>(coulomb::CoulombDisk, 0.0);
    let front = body::<_, LongitudinalGradient>(coulomb::CoulombDisk, 0.0);
    for twist in twists(500) {
        let upright = tall.foot().wrench(LOAD, &twist);
        for got in [tall.wrench(LOAD, &twist), front.wrench(LOAD, &twist)] {
            assert!(!got.is_lifting);
            assert_eq!((got.lean.x.abs(), got.lean.y.abs()), (0.0, 0.0));
            let slack = tolerance::ROUNDING.limit;
            let size = upright.force.x.hypot(upright.force.y);
            assert!((got.wrench.force.x - upright.force.x).abs() <= slack * size);
            assert!((got.wrench.force.y - upright.force.y).abs() <= slack * size);
            let torque = (got.wrench.torque - upright.torque).abs();
            assert!(torque <= slack * upright.torque.abs());
        }
    }
}

#[test]
fn impossible_heights_are_refused() {
    let foot = RoundFriction::new(CoulombRing, 0.2, RADIUS).expect("in range");
    for height in [-1e-300, -1.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let error =
            LoadTransferFriction::<_, _, FullGradient>::new(foot, height).expect_err("impossible");
        match error {
            PatchError::Height { given } => {
                assert!(given == height || given.is_nan() && height.is_nan());
            }
            other => panic!("{height}: {other:?}"),
        }
        assert!(error.to_string().contains("height"), "{error}");
    }
    for height in [0.0, -0.0, 5e-324, 1e300] {
        assert!(LoadTransferFriction::<_, _, FullGradient>::new(foot, height).is_ok());
    }
}

#[test]
fn a_tall_body_at_rest_feels_no_friction() {
    for alpha in EXPONENTS {
        for order in [-1.0, -0.5, 0.0, 0.5, 1.0] {
            for (name, tier) in patches::tiers::<f64>(order, alpha) {
                let tall = body::<_, FullGradient>(tier.as_ref(), 0.1);
                for zero in [0.0, -0.0] {
                    let got = tall.wrench(LOAD, &Twist::new(zero, -zero, zero));
                    let parts = [
                        got.wrench.force.x,
                        got.wrench.force.y,
                        got.wrench.torque,
                        got.lean.x,
                        got.lean.y,
                    ];
                    assert!(parts.iter().all(|x| *x == 0.0), "{name}: {got:?}");
                    assert!(!got.is_lifting);
                }
                // Pure spinning does not lean; pure sliding does not bend.
                let spinning = tall.wrench(LOAD, &Twist::new(0.0, 0.0, -3.0)).wrench;
                assert_eq!(
                    (spinning.force.x.abs(), spinning.force.y.abs()),
                    (0.0, 0.0),
                    "{name}"
                );
                assert!(spinning.torque > 0.0);
                let sliding = tall.wrench(LOAD, &Twist::new(0.0, 2.0, 0.0)).wrench;
                assert_eq!(
                    (sliding.force.x.abs(), sliding.torque.abs()),
                    (0.0, 0.0),
                    "{name}"
                );
                assert!(sliding.force.y < 0.0);
            }
        }
    }
}

#[test]
fn nan_goes_through_and_counts_as_lifting() {
    let tall = body::<_, FullGradient>(coulomb::CoulombDisk, 0.1);
    for other in special_f64() {
        for twist in [
            Twist::new(f64::NAN, other, other),
            Twist::new(other, f64::NAN, other),
            Twist::new(other, other, f64::NAN),
        ] {
            let got = tall.wrench(LOAD, &twist);
            let force = [got.wrench.force.x, got.wrench.force.y];
            assert!(force.iter().all(|x| x.is_nan()), "{twist:?}: {got:?}");
            assert!(got.wrench.torque.is_nan(), "{twist:?}: {got:?}");
            assert!(got.is_lifting, "{twist:?}");
            assert!(got.whole().is_err());
        }
    }
}
