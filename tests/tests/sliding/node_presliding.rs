//! Points that let go one after the other: Masing's rule, the backbone, energy.

use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
use tribos_core::presliding::{PointPresliding, Pose};
use tribos_core::twist::Displacement;
use tribos_tests::sweep::Lcg;

/// N/m, and N.
const STIFFNESS: f64 = 1e6;
const LIMIT: f64 = 5.0;
const REACH: f64 = LIMIT / STIFFNESS;
const RADIUS: f64 = 0.05;
/// Share of the reach in Masing's cycles.
const SCALE: f64 = 0.05;
const ORIGIN: Pose<f64> = Pose::new(0.0, 0.0, 0.0);

/// Points of a uniform disk on eight rings.
fn disk() -> NodeList<f64, 128> {
    let mut nodes = NodeList::new();
    for ring in 0..8 {
        let r = RADIUS * ((f64::from(ring) + 0.5) / 8.0).sqrt();
        for n in 0..16 {
            let (y, x) = (std::f64::consts::TAU * f64::from(n) / 16.0).sin_cos();
            nodes
                .push(Node {
                    x: r * x,
                    y: r * y,
                    weight: 1.0,
                })
                .expect("room");
        }
    }
    nodes
}

fn bound() -> PointPresliding<f64, NodeList<f64, 128>, 128> {
    PointPresliding::new(disk(), STIFFNESS, LIMIT, &ORIGIN).expect("it fits")
}

/// Torque of the first loading to the angle `turn`, and its integral from 0, from the rings.
fn backbone(turn: f64) -> [f64; 2] {
    let nodes = disk();
    let mut sums = [0.0; 2];
    for node in nodes.nodes() {
        let (r, share) = (node.x.hypot(node.y), node.weight / nodes.total_weight());
        let (k, limit) = (STIFFNESS * share * r * r, LIMIT * share * r);
        let elastic = turn.min(limit / k);
        sums[0] += k * elastic;
        sums[1] += 0.5 * k * elastic * elastic + limit * (turn - elastic);
    }
    sums
}

/// The angle at which the outermost ring slips.
fn first_slip() -> f64 {
    REACH / (RADIUS * (7.5_f64 / 8.0).sqrt())
}

#[test]
fn torsion_follows_the_backbone_and_bends_off_gradually() {
    for times in [0.5, 1.5, 3.0, 10.0] {
        let turn = times * first_slip();
        let mut patch = bound();
        let mut last = patch.step(&ORIGIN);
        for n in 1..=50 {
            last = patch.step(&Pose::new(0.0, 0.0, turn * f64::from(n) / 50.0));
        }
        let [torque, _] = backbone(turn);
        // Chords instead of arcs: turns of 1e-3 rad change them by 1e-7.
        let off = (-last.friction.torque / torque - 1.0).abs();
        assert!(off < 1e-7, "{times}: {off:e}");
        assert_eq!(last.slipping == 0, times < 1.0);
    }
}

#[test]
fn closed_cycles_lose_what_masings_rule_says() {
    // Turns of 1e-5 rad, between the rounding of positions and chords that are not arcs.
    let stiffness = STIFFNESS / SCALE;
    for times in [0.9, 1.3, 2.0, 3.0] {
        let turn = times * first_slip() * SCALE;
        let mut patch: PointPresliding<f64, _, 128> =
            PointPresliding::new(disk(), stiffness, LIMIT, &ORIGIN).expect("it fits");
        let (mut lost, steps) = (0.0, 23);
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
                let step = patch.step(&Pose::new(0.0, 0.0, turn * part));
                lost += if cycle == 1 { step.dissipated } else { 0.0 };
            }
        }
        // The backbone scales with the angle.
        let [torque, area] = backbone(times * first_slip());
        let expected = (8.0 * area - 4.0 * times * first_slip() * torque) * SCALE;
        if times < 1.0 {
            assert_eq!(lost, 0.0);
            continue;
        }
        assert!(
            (lost / expected - 1.0).abs() < 1e-10,
            "{times}: {lost:e} {expected:e}"
        );
    }
}

#[test]
fn random_paths_dissipate_and_their_energy_balances() {
    let mut rng = Lcg::new(101);
    for _ in 0..20 {
        let (mut patch, mut pose) = (bound(), ORIGIN);
        let size = REACH * rng.log_between(0.1, 20.0);
        for _ in 0..30 {
            let mut part = || size * (2.0 * rng.unit() - 1.0);
            let next = pose.moved(&Displacement::new(part(), part(), part() / RADIUS));
            let stored = patch.stored_energy(&pose);
            // The bonds at the new pose before they slip: a path of any shape stores the same.
            let strained = patch.stored_energy(&next);
            let step = patch.step(&next);
            let slipped = strained - patch.stored_energy(&next);
            assert!(step.dissipated >= 0.0 && slipped >= step.dissipated * (1.0 - 1e-9) - 1e-18);
            assert!(stored >= 0.0);
            let force = step.friction.force.norm();
            assert!(force <= LIMIT * (1.0 + 1e-12));
            pose = next;
        }
    }
}

#[test]
fn anchors_keep_their_bits_while_all_points_hold() {
    let mut patch = bound();
    let there = Pose::new(0.4 * REACH, 0.0, 0.3 * first_slip());
    let first = patch.step(&there);
    for n in 0..10_000 {
        let shake = 0.1 * REACH * f64::from(n % 3);
        patch.step(&there.moved(&Displacement::new(shake, 0.0, 0.0)));
    }
    assert_eq!(patch.step(&there), first);
    assert_eq!(first.slipping, 0);
}

#[test]
fn sliding_far_it_meets_the_friction_of_all_points() {
    let mut patch = bound();
    let slid = patch.step(&Pose::new(1.0, 0.0, 0.0));
    assert!((slid.friction.force.x + LIMIT).abs() < 1e-9);
    assert_eq!(slid.slipping, 128);
    patch.anchor_at(&Pose::new(1.0, 0.0, 0.0));
    assert_eq!(
        patch.step(&Pose::new(1.0, 0.0, 0.0)).friction.force.norm(),
        0.0
    );
    patch.set_force_limit(0.0).expect("allowed");
    assert_eq!(
        patch.step(&Pose::new(2.0, 0.0, 0.0)).friction.force.norm(),
        0.0
    );
    let lost = patch.step(&Pose::new(f64::NAN, 0.0, 0.0));
    assert!(lost.friction.force.x.is_nan() && lost.slipping == 128);
    assert!(patch.set_force_limit(-1.0).is_err());
    let few: Result<PointPresliding<f64, _, 5>, _> =
        PointPresliding::new(disk(), STIFFNESS, LIMIT, &ORIGIN);
    assert!(few.is_err());
}
