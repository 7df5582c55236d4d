//! Slip that begins early: Dahl's curve, the conditions of the step's minimum, vibration.

use crate::elastic_steps::{LIMIT, RADIUS, sets};
use tribos_core::Real;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::law::StickSlip;
use tribos_core::limit_surface::{LimitEllipsoid, RoundLimitSurface, ScaledSet};
use tribos_core::presliding::{Anchor, MicroslipPresliding, Pose, Presliding, PreslidingStep};
use tribos_core::twist::{Displacement, Twist, Wrench};
use tribos_tests::sweep::Lcg;

const STIFFNESS: f64 = 1e4;
const REACH: f64 = LIMIT / STIFFNESS;

fn bonds() -> Presliding<f64> {
    Presliding::new(STIFFNESS, 0.5 * STIFFNESS * RADIUS * RADIUS).expect("positive")
}

fn gradual(breakaway: f64, exponent: f64) -> MicroslipPresliding<f64> {
    MicroslipPresliding::new(bonds(), breakaway, exponent).expect("in range")
}

fn displacement(rng: &mut Lcg, size: f64) -> Displacement<f64> {
    let mut part = || 2.0 * rng.unit() - 1.0;
    Displacement::new(size * part(), size * part(), size * part() / RADIUS)
}

fn motion(d: &Displacement<f64>) -> Twist<f64> {
    Twist {
        velocity: d.shift,
        spin: d.turn,
    }
}

#[test]
fn in_one_direction_it_is_dahls_curve_to_first_order() {
    for set in sets() {
        let torque = set.support(&Twist::new(0.0, 0.0, 1.0));
        let torsional = bonds().torsional_stiffness();
        for (unit, limit, stiffness) in [
            (Displacement::new(-1.0, 0.0, 0.0), LIMIT, STIFFNESS),
            (Displacement::new(0.6, 0.8, 0.0), LIMIT, STIFFNESS),
            (Displacement::new(0.0, 0.0, 1.0), torque, torsional),
        ] {
            let distance = 2.0 * limit / stiffness;
            let exact = limit * (1.0 - (-stiffness * distance / limit).exp());
            let errors = [50, 100, 200].map(|steps| {
                let (law, mut strain, mut end) = (gradual(0.0, 1.0), Displacement::ZERO, 0.0);
                for _ in 0..steps {
                    let moved = unit * (distance / f64::from(steps));
                    let step = law.advance(&*set, &strain, &moved);
                    (strain, end) = (step.strain, -unit.work(&step.friction));
                }
                (end - exact).abs() / limit
            });
            for pair in errors.windows(2) {
                let order = (pair[0] / pair[1]).log2();
                assert!((0.9..1.1).contains(&order), "{unit:?}: {errors:?}");
            }
            assert!(errors[2] < 2e-3, "{errors:?}");
        }
    }
}

/// Slip along the normal of the wrench, as much as D h(g) says, or more on the surface itself.
#[test]
fn the_step_is_where_its_function_is_least() {
    let mut rng = Lcg::new(81);
    let mut seen = [0; 3];
    for set in sets() {
        for _ in 0..150 {
            let breakaway = if rng.unit() < 0.5 {
                0.0
            } else {
                0.9 * rng.unit()
            };
            let exponent = [1.0, 2.0, 0.5][(rng.bits() % 3) as usize];
            let law = gradual(breakaway, exponent);
            let size = REACH * rng.log_between(0.01, 3.0);
            // Half of the bonds come from a stronger set, which has shrunk.
            let strength = if rng.unit() < 0.5 { 1.0 } else { 2.0 };
            let before = ScaledSet::new(&*set, strength).expect("positive");
            let reach = 2.0 * REACH * rng.unit();
            let strain = displacement(&mut rng, reach);
            let strain = bonds()
                .advance(&before, &Displacement::ZERO, &strain)
                .strain;
            let moved = displacement(&mut rng, size);
            let step = law.advance(&*set, &strain, &moved);
            let wrench = -step.friction;
            let (gauge, driven) = (set.gauge(&wrench), set.support(&motion(&moved)));
            let share = ((gauge - breakaway) / (1.0 - breakaway))
                .max(0.0)
                .powf(exponent);
            if step.grip == StickSlip::Stick {
                assert!(gauge <= breakaway || driven * share < 1e-12 * LIMIT * size);
                seen[0] += 1;
                continue;
            }
            // λ is the support of λ n; z·slip = g λ says that slip is along the normal at z.
            let lambda = set.support(&motion(&step.slip));
            let taken = step.slip.work(&wrench);
            let rounding = 1e-11 * LIMIT * (size + REACH);
            assert!(
                (taken - gauge * lambda).abs() < rounding,
                "{taken} {gauge} {lambda}"
            );
            if gauge < 1.0 - 1e-9 {
                assert!(
                    (lambda - driven * share).abs() < rounding,
                    "{lambda} {driven} {share}"
                );
                seen[1] += 1;
            } else {
                assert!(gauge < 1.0 + 1e-11 && lambda > driven * (1.0 - 1e-9) - rounding);
                seen[2] += 1;
            }
            assert!(step.dissipated >= 0.0);
        }
    }
    assert!(seen.iter().all(|n| *n > 15), "{seen:?}");
}

#[test]
fn below_the_breakaway_share_nothing_slips_whatever_shakes() {
    let law = gradual(0.7, 1.0);
    let mut rng = Lcg::new(82);
    for set in sets() {
        let anchor = Anchor::at(Pose::new(1.0, 2.0, 0.3));
        let mut from = anchor.pose;
        for _ in 0..500 {
            // The set contains the octahedron of its largest parts.
            let mut away = displacement(&mut rng, 0.3 * REACH);
            away.turn *= 0.1;
            let to = anchor.pose.moved(&away);
            let step = law.step(&*set, &anchor, [&from, &to]);
            assert_eq!((step.anchor, step.grip), (anchor, StickSlip::Stick));
            from = to;
        }
    }
}

/// Friction at the middle of a vibration of a tenth of the reach, before and after 1000 cycles.
fn shaken(law: &MicroslipPresliding<f64>, share: f64) -> [f64; 2] {
    let set = RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).expect("in range");
    let at = |x: f64| Pose::new(x, 0.0, 0.0);
    let (mut anchor, mut from) = (Anchor::at(at(0.0)), at(0.0));
    let mut go = |x: f64| -> PreslidingStep<f64> {
        let step = law.step(&set, &anchor, [&from, &at(x)]);
        (anchor, from) = (step.anchor, at(x));
        step
    };
    let middle = share * REACH;
    let first = (1..=100)
        .map(|n| go(middle * f64::from(n) / 100.0))
        .last()
        .expect("steps");
    for _ in 0..1000 {
        for x in [0.05, 0.0, -0.05, 0.0] {
            go(middle + x * REACH);
        }
    }
    let last = go(middle);
    [first, last].map(|step| -step.friction.force.x / LIMIT)
}

#[test]
fn dahls_law_relaxes_under_vibration_and_a_breakaway_share_keeps_what_it_holds() {
    let [before, after] = shaken(&gradual(0.0, 1.0), 0.5);
    assert!(before > 0.39 && after.abs() < 0.05, "{before} {after}");
    let [before, after] = shaken(&gradual(0.7, 1.0), 0.5);
    assert!(
        (before - 0.5).abs() < 1e-12 && before == after,
        "{before} {after}"
    );
}

#[test]
fn steps_do_not_expand() {
    let mut rng = Lcg::new(83);
    let norm = |d: &Displacement<f64>| {
        let torsional = bonds().torsional_stiffness();
        (STIFFNESS * d.shift.norm_squared() + torsional * d.turn * d.turn).sqrt()
    };
    let law = gradual(0.2, 1.0);
    for set in sets() {
        for _ in 0..150 {
            let [a, b] = [(); 2].map(|()| displacement(&mut rng, REACH));
            let moved = displacement(&mut rng, 0.5 * REACH);
            let [za, zb] = [a, b].map(|d| law.advance(&*set, &d, &moved).strain);
            let (before, after) = (norm(&(a - b)), norm(&(za - zb)));
            assert!(after <= before * (1.0 + 1e-11) + 1e-13, "{before} {after}");
        }
    }
}

#[test]
fn with_a_steep_exponent_it_becomes_the_sharp_law() {
    let (set, sharp) = (
        RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).expect("in range"),
        bonds(),
    );
    let law = gradual(0.0, 4000.0);
    let (mut one, mut other) = (Displacement::ZERO, Displacement::ZERO);
    for n in 0..200 {
        let moved = Displacement::new(1e-5, 0.0, 1e-4 * f64::from(n) / 200.0);
        one = law.advance(&set, &one, &moved).strain;
        other = sharp.advance(&set, &other, &moved).strain;
    }
    assert!(
        (one.shift - other.shift).norm() < 2e-3 * REACH,
        "{one:?} {other:?}"
    );
    assert!((one.turn - other.turn).abs() < 2e-3 * REACH / RADIUS);
}

#[test]
fn both_precisions_and_what_is_no_number() {
    fn end<R: Real>() -> [f64; 2] {
        let number = R::from_f64;
        let set =
            LimitEllipsoid::new(number(LIMIT), number(RADIUS), number(0.6)).expect("in range");
        let law = Presliding::new(number(1e4), number(12.5)).expect("positive");
        let law = MicroslipPresliding::new(law, number(0.3), R::ONE).expect("in range");
        let mut strain = Displacement::ZERO;
        let moved = Displacement::new(number(1e-5), number(0.5e-5), number(1e-4));
        for _ in 0..60 {
            strain = law.advance(&set, &strain, &moved).strain;
        }
        let nan = Displacement::new(R::NAN, R::ZERO, R::ZERO);
        for bad in [nan, Displacement::new(R::ZERO, R::INFINITY, R::ZERO)] {
            let Wrench { force, torque } = law.advance(&set, &strain, &bad).friction;
            assert!((force.x + force.y + torque).is_nan());
        }
        [
            strain.shift.x.to_f64() / REACH,
            strain.turn.to_f64() * RADIUS / REACH,
        ]
    }
    let (double, single) = (end::<f64>(), end::<f32>());
    for (a, b) in double.into_iter().zip(single) {
        assert!((a - b).abs() < 1e-5, "{a} {b}");
    }
    for bad in [-0.1, 1.0, f64::NAN] {
        assert!(MicroslipPresliding::new(bonds(), bad, 1.0).is_err());
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(MicroslipPresliding::new(bonds(), 0.5, bad).is_err());
    }
}
