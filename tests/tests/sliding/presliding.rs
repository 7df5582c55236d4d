//! Elastic bonds hold without creep, slip by the limit surface, and account for all energy.

use nalgebra::{Rotation2, Vector2};
use tribos_core::Real;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::law::StickSlip;
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, RoundLimitSurface, ScaledSet, ShapeLimitSurface,
};
use tribos_core::patch::outline::{Edge, Polygon, UniformPressure};
use tribos_core::presliding::{Anchor, Pose, Presliding};
use tribos_core::twist::{Displacement, Twist, Wrench};
use tribos_tests::sweep::Lcg;

const LIMIT: f64 = 5.0;
const RADIUS: f64 = 0.05;
const STIFFNESS: f64 = 1e4;
/// Displacement at which pure sliding begins.
const REACH: f64 = LIMIT / STIFFNESS;

type Box4 = Polygon<f64, [Edge<f64>; 4], UniformPressure>;

fn disk() -> RoundLimitSurface<f64, CoulombDisk> {
    RoundLimitSurface::new(CoulombDisk, LIMIT, RADIUS).expect("in range")
}

fn book() -> ShapeLimitSurface<f64, Box4> {
    let (a, b) = (RADIUS, 0.4 * RADIUS);
    let corners = [[-a, -b], [a, -b], [a, b], [-a, b]];
    ShapeLimitSurface::new(Polygon::new(corners).expect("a box"), LIMIT).expect("in range")
}

fn sets() -> [Box<dyn FrictionSet<f64>>; 3] {
    let usual = LimitEllipsoid::new(LIMIT, RADIUS, 0.6).expect("in range");
    [Box::new(disk()), Box::new(usual), Box::new(book())]
}

fn bonds() -> Presliding<f64> {
    Presliding::new(STIFFNESS, 0.5 * STIFFNESS * RADIUS * RADIUS).expect("positive")
}

/// Displacements in all directions, of the size of `reach` and the turn that belongs to it.
fn displacement(rng: &mut Lcg, size: f64) -> Displacement<f64> {
    let mut part = || 2.0 * rng.unit() - 1.0;
    Displacement::new(size * part(), size * part(), size * part() / RADIUS)
}

/// −friction along the motion from one pose to another, about the centre.
fn work_on_bonds(friction: &Wrench<f64>, from: &Pose<f64>, to: &Pose<f64>) -> f64 {
    -to.since(from).work(friction)
}

/// Heat of one closed cycle from −A to A, after one that does not count.
fn loop_loss(
    set: &dyn FrictionSet<f64>,
    unit: &Displacement<f64>,
    amplitude: f64,
    steps: i32,
) -> f64 {
    let (law, mut anchor, mut lost) = (bonds(), Anchor::at(Pose::new(0.0, 0.0, 0.0)), 0.0);
    for cycle in 0..2 {
        for n in 1..=4 * steps {
            let n = f64::from(n) / f64::from(steps);
            let part = if n <= 1.0 {
                n
            } else if n <= 3.0 {
                2.0 - n
            } else {
                n - 4.0
            };
            let pose = Pose::new(0.0, 0.0, 0.0).moved(&(*unit * (amplitude * part)));
            let step = law.step(set, &anchor, &pose);
            anchor = step.anchor;
            lost += if cycle == 1 { step.dissipated } else { 0.0 };
        }
    }
    lost
}

#[test]
fn closed_cycles_lose_what_masings_rule_says() {
    for set in sets() {
        let most = set.support(&Twist::new(0.0, 0.0, 1.0));
        let turn = |sign: f64| Displacement::new(0.0, 0.0, sign);
        let directions = [
            (Displacement::new(1.0, 0.0, 0.0), LIMIT, STIFFNESS),
            (Displacement::new(0.0, -1.0, 0.0), LIMIT, STIFFNESS),
            (Displacement::new(-0.6, 0.8, 0.0), LIMIT, STIFFNESS),
            (turn(1.0), most, bonds().torsional_stiffness()),
            (turn(-1.0), most, bonds().torsional_stiffness()),
        ];
        for (unit, limit, stiffness) in directions {
            for (times, steps) in [(1.5, 7), (2.0, 10), (7.3, 64)] {
                let amplitude = times * limit / stiffness;
                let expected = 4.0 * limit * (amplitude - limit / stiffness);
                let lost = loop_loss(&*set, &unit, amplitude, steps);
                let off = (lost / expected - 1.0).abs();
                assert!(off < 1e-10, "{unit:?} {times}: {off:e}");
            }
            let held = loop_loss(&*set, &unit, 0.99 * limit / stiffness, 10);
            assert_eq!(held, 0.0, "{unit:?}");
        }
    }
}

#[test]
fn inside_the_set_friction_depends_on_the_pose_alone_and_the_anchor_keeps_its_bits() {
    let mut rng = Lcg::new(71);
    // Far from the origin, and so near that poses and their differences round apart.
    let starts = [
        Pose::new(3.0, -2.0, 0.7),
        Pose::new(1.7e-5, -3.1e-6, 1.3e-3),
    ];
    for (set, start) in sets()
        .iter()
        .flat_map(|set| starts.map(|start| (set, start)))
    {
        let (anchor, bonds) = (Anchor::at(start), bonds());
        for _ in 0..300 {
            let away = displacement(&mut rng, 0.3 * REACH);
            let pose = start.moved(&away);
            let step = bonds.step(&**set, &anchor, &pose);
            assert_eq!((step.anchor, step.grip), (anchor, StickSlip::Stick));
            assert_eq!((step.dissipated, step.slip), (0.0, Displacement::ZERO));
            let e = pose.since(&start);
            let wanted = Wrench::new(
                -STIFFNESS * e.shift.x,
                -STIFFNESS * e.shift.y,
                -bonds.torsional_stiffness() * e.turn,
            );
            assert_eq!(step.friction, wanted);
        }
    }
}

#[test]
fn random_paths_dissipate_and_their_energy_balances() {
    let mut rng = Lcg::new(72);
    for set in sets() {
        for _ in 0..150 {
            let mut pose = Pose::new(rng.unit(), rng.unit(), 6.0 * rng.unit());
            let (mut anchor, size) = (Anchor::at(pose), REACH * rng.log_between(0.05, 20.0));
            let law = bonds();
            for _ in 0..20 {
                let next = pose.moved(&displacement(&mut rng, size));
                let step = law.step(&*set, &anchor, &next);
                let before = anchor.deflection(&pose);
                let after = step.anchor.deflection(&next);
                assert!(step.dissipated >= 0.0);
                let change = after - before;
                let balance = work_on_bonds(&step.friction, &pose, &next)
                    - law.stored_energy(&step.anchor, &next)
                    + law.stored_energy(&anchor, &pose)
                    - step.dissipated
                    - law.stored_energy(
                        &Anchor::at(Pose::new(0.0, 0.0, 0.0)),
                        &Pose::new(change.shift.x, change.shift.y, change.turn),
                    );
                let scale = LIMIT * (size + REACH);
                assert!(balance.abs() < 1e-11 * scale, "{balance:e} of {scale:e}");
                // Friction stays in the set, in the axes of the patch.
                let local = Rotation2::new(-next.angle) * step.friction.force;
                let local = Wrench {
                    force: local,
                    ..step.friction
                };
                assert!(set.gauge(&local) < 1.0 + 1e-11);
                (pose, anchor) = (next, step.anchor);
            }
        }
    }
}

#[test]
fn slip_runs_along_the_normal() {
    let mut rng = Lcg::new(73);
    let law = bonds();
    for set in sets() {
        for _ in 0..300 {
            let strain = displacement(&mut rng, 5.0 * REACH);
            let step = law.advance(&*set, &Displacement::ZERO, &strain);
            if step.grip == StickSlip::Stick {
                continue;
            }
            // Of all wrenches of the set that of friction takes most from the slip.
            let motion = Twist {
                velocity: step.slip.shift,
                spin: step.slip.turn,
            };
            let most = set.support(&motion);
            let taken = -step.slip.work(&step.friction);
            assert!((taken - most).abs() < 1e-11 * most, "{taken} {most}");
            assert!((step.dissipated - taken).abs() <= 1e-15 * taken);
            let sum = step.strain + step.slip - strain;
            assert!(sum.shift.norm() < 1e-12 * REACH + 1e-15 && sum.turn.abs() < 1e-12);
        }
    }
}

#[test]
fn another_origin_and_other_axes_change_nothing() {
    let mut rng = Lcg::new(74);
    for set in sets() {
        for _ in 0..40 {
            let (turn, by) = (
                6.0 * rng.unit() - 3.0,
                Vector2::new(rng.unit(), -rng.unit()),
            );
            let axes = Rotation2::new(turn);
            let seen = |p: &Pose<f64>| Pose {
                position: axes * p.position + by,
                angle: p.angle + turn,
            };
            let mut pose = Pose::new(0.0, 0.0, 0.0);
            let (mut here, mut there) = (Anchor::at(pose), Anchor::at(seen(&pose)));
            for _ in 0..20 {
                pose = pose.moved(&displacement(&mut rng, REACH));
                let one = bonds().step(&*set, &here, &pose);
                let other = bonds().step(&*set, &there, &seen(&pose));
                let off = axes * one.friction.force - other.friction.force;
                // Positions of size 1 m resolve 2e-16 m, 2e-12 N; slip turns by 1e-10 of that.
                assert!(off.norm() < 3e-10, "{off:?}");
                assert!((one.friction.torque - other.friction.torque).abs() < 3e-11);
                (here, there) = (one.anchor, other.anchor);
            }
        }
    }
}

#[test]
fn curved_paths_converge_with_the_step() {
    // A patch that runs on a circle while it turns; the finest step is the reference.
    let friction = |set: &dyn FrictionSet<f64>, steps: u32| {
        let law = bonds();
        let mut anchor = Anchor::at(Pose::new(0.0, 0.0, 0.0));
        let mut last = Wrench::ZERO;
        for n in 1..=steps {
            let s = 3.0 * f64::from(n) / f64::from(steps);
            let (sin, cos) = s.sin_cos();
            let pose = Pose::new(2.0 * REACH * sin, 2.0 * REACH * (1.0 - cos), 0.02 * s * s);
            let step = law.step(set, &anchor, &pose);
            (anchor, last) = (step.anchor, step.friction);
        }
        last
    };
    for set in sets() {
        let reference = friction(&*set, 16384);
        let errors = [64, 128, 256, 512].map(|steps| {
            let off = friction(&*set, steps) - reference;
            off.force.norm() + off.torque.abs() / RADIUS
        });
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((0.85..1.3).contains(&order), "{errors:?}");
        }
        assert!(errors[3] < 5e-3 * LIMIT, "{errors:?}");
    }
}

#[test]
fn steps_do_not_expand() {
    let mut rng = Lcg::new(75);
    let law = bonds();
    let norm = |d: &Displacement<f64>| {
        let at = Pose::new(d.shift.x, d.shift.y, d.turn);
        law.stored_energy(&Anchor::at(Pose::new(0.0, 0.0, 0.0)), &at)
            .sqrt()
    };
    for set in sets() {
        for _ in 0..500 {
            let [a, b] = [(); 2].map(|()| displacement(&mut rng, 4.0 * REACH));
            let [za, zb] = [a, b].map(|d| law.advance(&*set, &Displacement::ZERO, &d).strain);
            let (before, after) = (norm(&(a - b)), norm(&(za - zb)));
            assert!(after <= before * (1.0 + 1e-12) + 1e-14, "{before} {after}");
        }
    }
}

#[test]
fn a_set_that_shrinks_lets_bonds_slip_and_one_that_grows_keeps_them() {
    let (set, law) = (disk(), bonds());
    let start = Pose::new(0.0, 0.0, 0.0);
    let pulled = Pose::new(0.8 * REACH, 0.0, 0.0);
    let held = law.step(&set, &Anchor::at(start), &pulled);
    assert_eq!(held.grip, StickSlip::Stick);
    // Half the load: half the force, and the rest of the strain slips.
    let half = ScaledSet::new(&set, 0.5).expect("positive");
    let less = law.step(&half, &held.anchor, &pulled);
    assert!((less.friction.force.x + 0.5 * LIMIT).abs() < 1e-12);
    assert!((less.slip.shift.x - 0.3 * REACH).abs() < 1e-15);
    assert!((less.dissipated - 0.5 * LIMIT * 0.3 * REACH).abs() < 1e-15);
    // A stronger set brings none of it back.
    let twice = ScaledSet::new(&set, 2.0).expect("positive");
    let more = law.step(&twice, &less.anchor, &pulled);
    assert_eq!((more.anchor, more.grip), (less.anchor, StickSlip::Stick));
}

#[test]
fn scaled_sets_are_the_sets_of_the_scaled_limit() {
    let mut rng = Lcg::new(76);
    for strength in [0.25, 0.7, 3.0] {
        let own = RoundLimitSurface::new(CoulombDisk, strength * LIMIT, RADIUS).expect("in range");
        let base = disk();
        let scaled = ScaledSet::new(&base, strength).expect("positive");
        for _ in 0..200 {
            let d = displacement(&mut rng, 3.0);
            let w = Wrench {
                force: d.shift * 4.0,
                torque: d.turn * RADIUS * 0.1,
            };
            let t = Twist {
                velocity: d.shift,
                spin: d.turn,
            };
            let close =
                |a: f64, b: f64| assert!((a - b).abs() <= 1e-13 * (a.abs() + b.abs()), "{a} {b}");
            close(own.gauge(&w), scaled.gauge(&w));
            close(own.support(&t), scaled.support(&t));
            close(own.wrench(&t).torque, scaled.wrench(&t).torque);
            close(
                own.scale_to_surface(&w).torque,
                scaled.scale_to_surface(&w).torque,
            );
            close(
                own.twist_normal_to(&w).spin,
                scaled.twist_normal_to(&w).spin,
            );
            let [p, q] = [own.project(&w).wrench, scaled.project(&w).wrench];
            assert!(
                (p.force - q.force).norm() < 1e-13 * LIMIT && (p.torque - q.torque).abs() < 1e-13
            );
            assert_eq!(own.contains(&w), scaled.contains(&w));
        }
        assert_eq!(
            [scaled.force_limit(), scaled.radius()],
            [strength * LIMIT, RADIUS]
        );
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(ScaledSet::new(&disk(), bad).is_err());
    }
}

/// A million tiny moves there and back, far from the origin: the anchor's bits stay.
#[test]
fn vibration_inside_the_set_does_not_creep() {
    let (set, law) = (
        LimitEllipsoid::new(LIMIT, RADIUS, 0.6).expect("in range"),
        bonds(),
    );
    let held = Pose::new(100.0 + 0.9 * REACH, -40.0, 2.0);
    let anchor = Anchor::at(Pose::new(100.0, -40.0, 2.0));
    let mut now = anchor;
    for n in 0..1_000_000_u32 {
        let shake = 0.09 * REACH * f64::from(n % 5) / 4.0;
        now = law
            .step(&set, &now, &held.moved(&Displacement::new(shake, 0.0, 0.0)))
            .anchor;
    }
    assert_eq!(now, anchor);
}

fn single_follows_double() -> [f64; 2] {
    fn end<R: Real>() -> [f64; 2] {
        let number = R::from_f64;
        let set =
            RoundLimitSurface::new(CoulombDisk, number(LIMIT), number(RADIUS)).expect("in range");
        let law = Presliding::new(number(1e4), number(12.5)).expect("positive");
        let mut anchor = Anchor::at(Pose::new(R::ZERO, R::ZERO, R::ZERO));
        let mut friction = Wrench::ZERO;
        for n in 1..=100 {
            let n = f64::from(n) / 100.0;
            let pose = Pose::new(number(2e-3 * n), number(1e-3 * n * n), number(0.05 * n));
            let step = law.step(&set, &anchor, &pose);
            (anchor, friction) = (step.anchor, step.friction);
        }
        [friction.force.x.to_f64(), friction.torque.to_f64()]
    }
    let (double, single) = (end::<f64>(), end::<f32>());
    [
        (double[0] - single[0]).abs() / LIMIT,
        (double[1] - single[1]).abs() / (LIMIT * RADIUS),
    ]
}

#[test]
fn single_precision_does_the_same_to_its_own() {
    for off in single_follows_double() {
        assert!(off < 2e-5, "{off:e}");
    }
}

#[test]
fn what_is_no_number_gives_no_number() {
    let (set, law) = (disk(), bonds());
    let start = Anchor::at(Pose::new(0.0, 0.0, 0.0));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e306] {
        for pose in [
            Pose::new(bad, 0.0, 0.0),
            Pose::new(0.0, bad, 0.0),
            Pose::new(0.0, 0.0, bad),
        ] {
            let step = law.step(&set, &start, &pose);
            let sum = step.friction.force.x + step.friction.force.y + step.friction.torque;
            assert!(sum.is_nan() || bad == 1e306, "{pose:?}: {step:?}");
            assert_eq!(step.grip, StickSlip::Slip);
        }
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Presliding::new(bad, 1.0).is_err() && Presliding::new(1.0, bad).is_err());
    }
    assert!(Presliding::new(1e-100, 1e100).is_ok() && Presliding::new(1e-200, 1e200).is_err());
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(law.with_damping(bad, 0.0).is_err() && law.with_damping(0.0, bad).is_err());
    }
}
