//! The set of wrenches that many points carry, against the closed ring and by its own geometry.

use nalgebra::Vector2;
use tribos_core::coupling::coulomb::CoulombRing;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::law::CoulombLaw;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::patch::nodes::{Node, NodeList, NodePatch};
use tribos_core::planar::PointContacts;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;

const CAPACITY: usize = 256;
type Points = NodeList<f64, CAPACITY>;

fn wrench(rng: &mut Lcg, force: f64, torque: f64) -> Wrench<f64> {
    let [x, y, n] = [(); 3].map(|()| rng.between(-1.0, 1.0));
    Wrench::new(force * x, force * y, torque * n)
}

fn distance(a: &Wrench<f64>, b: &Wrench<f64>, length: f64) -> f64 {
    (a.force - b.force)
        .norm()
        .hypot((a.torque - b.torque) / length)
}

/// Points and loads at random: one to thirty, sometimes in a line, sometimes one carries nearly all.
fn points(rng: &mut Lcg, case: usize) -> Points {
    let mut points = Points::new();
    for n in 0..1 + rng.bits() % 30 {
        let [x, y] = [(); 2].map(|()| rng.between(-0.2, 0.2));
        let node = Node {
            x,
            y: if case.is_multiple_of(4) { 0.0 } else { y },
            weight: if case % 5 == 1 && n == 0 {
                20.0
            } else {
                rng.unit() + 1e-3
            },
        };
        points.push(node).expect("room");
    }
    points
}

#[test]
fn a_ring_of_points_is_the_closed_ring() {
    let (limit, radius, length) = (3.0, 0.1, 0.07);
    let closed = RoundLimitSurface::new(CoulombRing, limit, radius).expect("valid");
    let points: Points = NodeList::ring(radius, 256).expect("it fits");
    let mut foot: PointContacts<f64, _, CAPACITY> =
        PointContacts::new(points, limit).expect("valid");
    let mut rng = Lcg::new(3);
    let mut worst = 0.0_f64;
    for _ in 0..2000 {
        let wanted = wrench(&mut rng, 2.0 * limit, 2.0 * limit * radius);
        let carried = closed.project_with_length(&wanted, length).wrench;
        let got = foot.nearest(&wanted, length);
        worst = worst.max(distance(&carried, &got, length) / limit);
    }
    println!("worst difference from the closed ring: {worst:.1e} of the limit");
    // Where the ring turns about one of its points that point's share is at stake.
    assert!(worst < 1.0 / 256.0);
}

#[test]
fn the_friction_of_a_motion_is_on_the_surface_with_the_motion_as_normal() {
    let mut rng = Lcg::new(7);
    let mut worst = [0.0_f64; 2];
    for case in 0..2000 {
        let points = points(&mut rng, case);
        let length = rng.log_between(0.03, 0.3);
        let limit = rng.log_between(1e-6, 1e6);
        let friction = NodeFriction::new(CoulombLaw::new(1.0).expect("valid"), points.clone());
        let direction = wrench(&mut rng, 1.0, 1.0 / length);
        let twist = Twist {
            velocity: direction.force,
            spin: direction.torque,
        };
        let on = friction.wrench(-limit, &twist); // along the motion
        let reach = limit * rng.log_between(1e-5, 1e3);
        let beyond = Wrench {
            force: on.force + twist.velocity * reach,
            torque: on.torque + twist.spin * reach * length * length,
        };
        let mut foot: PointContacts<f64, _, CAPACITY> =
            PointContacts::new(points, limit).expect("valid");
        let size = distance(&beyond, &Wrench::ZERO, length);
        let got = foot.nearest(&beyond, length);
        worst[0] = worst[0].max(distance(&got, &on, length) / size);
        // What is safely inside stays as it is.
        let inside = on * (1.0 - 1e-9);
        assert_eq!(foot.nearest(&inside, length), inside);
        let again = foot.nearest(&got, length);
        worst[1] = worst[1].max(distance(&again, &got, length) / size);
    }
    println!(
        "worst: from the motion {:.1e}, idempotent {:.1e} of the wrench",
        worst[0], worst[1]
    );
    assert!(worst[0] < 1e-12 && worst[1] < 1e-12);
}

/// What the points carry of a foot that turns about its point `pivot`, which carries `share` of its
/// own limit in some direction, and the motion, turning at `spin` (torque over length²).
fn turning(
    rng: &mut Lcg,
    points: &Points,
    limit: f64,
    [pivot, share, spin]: [f64; 3],
) -> (Wrench<f64>, Twist<f64>) {
    let nodes = points.nodes();
    let unit = limit / points.total_weight();
    let centre = &nodes[pivot as usize];
    let angle = rng.unit() * std::f64::consts::TAU;
    let mut on = Wrench::ZERO;
    for (n, node) in nodes.iter().enumerate() {
        let [x, y] = [node.x - centre.x, node.y - centre.y];
        let far = x.hypot(y);
        let force = if n == pivot as usize {
            Vector2::new(angle.cos(), angle.sin()) * share
        } else {
            Vector2::new(-y / far, x / far) * spin.signum()
        };
        let force = force * (unit * node.weight);
        on.force += force;
        on.torque += node.x * force.y - node.y * force.x;
    }
    (on, Twist::new(centre.y * spin, -centre.x * spin, spin))
}

#[test]
fn a_foot_that_turns_about_one_of_its_points_is_found_to_rounding() {
    let mut rng = Lcg::new(9);
    let mut worst = [0.0_f64; 2];
    for case in 0..4000 {
        let points = points(&mut rng, 4 * case + 1);
        let (length, limit) = (rng.log_between(0.03, 0.3), rng.log_between(1e-6, 1e6));
        let pivot = (rng.bits() % points.nodes().len() as u64) as f64;
        // The point carries nothing, some of its limit, or all but a small part of it.
        let share = match case % 3 {
            0 => rng.unit(),
            1 => 1.0 - rng.log_between(1e-12, 1.0),
            _ => 0.0,
        };
        let sign = if rng.unit() < 0.5 { -1.0 } else { 1.0 };
        let spin = sign / length;
        let (on, twist) = turning(&mut rng, &points, limit, [pivot, share, spin]);
        let reach = limit * rng.log_between(1e-5, 1e3);
        let beyond = Wrench {
            force: on.force + twist.velocity * reach,
            torque: on.torque + twist.spin * reach * length * length,
        };
        let mut foot: PointContacts<f64, _, CAPACITY> =
            PointContacts::new(points, limit).expect("valid");
        let size = distance(&beyond, &Wrench::ZERO, length);
        let got = foot.nearest(&beyond, length);
        worst[0] = worst[0].max(distance(&got, &on, length) / size);
        let again = foot.nearest(&got, length);
        worst[1] = worst[1].max(distance(&again, &got, length) / size);
    }
    println!(
        "about a point: {:.1e}, idempotent {:.1e} of the wrench",
        worst[0], worst[1]
    );
    assert!(worst[0] < 1e-14 && worst[1] < 1e-14, "{worst:?}");
}

#[test]
fn points_that_almost_rest_are_found_to_rounding() {
    let mut rng = Lcg::new(15);
    let mut worst = 0.0_f64;
    for case in 0..4000 {
        let points = points(&mut rng, 4 * case + 1);
        let (length, limit) = (rng.log_between(0.03, 0.3), rng.log_between(1e-6, 1e6));
        let friction = NodeFriction::new(CoulombLaw::new(1.0).expect("valid"), points.clone());
        // A turn about a place next to a point, by 1e-14 to 1e-2 of the length.
        let near = points.nodes()[rng.bits() as usize % points.nodes().len()];
        let [dx, dy] = [(); 2].map(|()| rng.between(-1.0, 1.0));
        let off = length * rng.log_between(1e-14, 1e-2);
        let spin = 1.0 / length;
        let twist = Twist::new(
            (near.y + off * dy) * spin,
            -(near.x + off * dx) * spin,
            spin,
        );
        let on = friction.wrench(-limit, &twist);
        let reach = limit * rng.log_between(1e-5, 1e3);
        let beyond = Wrench {
            force: on.force + twist.velocity * reach,
            torque: on.torque + twist.spin * reach * length * length,
        };
        let mut foot: PointContacts<f64, _, CAPACITY> =
            PointContacts::new(points, limit).expect("valid");
        let size = distance(&beyond, &Wrench::ZERO, length);
        let got = foot.nearest(&beyond, length);
        // Where it is next to a kink the nearest wrench is not that of the given motion to rounding,
        // since the motion rounds; but it is no farther away.
        let apart = distance(&beyond, &got, length) - distance(&beyond, &on, length);
        let around = distance(&got, &on, length) / size;
        if off > 1e-3 * length {
            worst = worst.max(around);
        }
        worst = worst.max(apart / size);
    }
    println!("next to a point: {worst:.1e} of the wrench");
    assert!(worst < 1e-14, "{worst:e}");
}

#[test]
fn the_order_of_calls_does_not_matter_beyond_rounding() {
    let mut rng = Lcg::new(11);
    for case in 0..300 {
        let points = points(&mut rng, case);
        let total = points.total_weight();
        let mut warm: PointContacts<f64, _, CAPACITY> =
            PointContacts::new(points.clone(), total).expect("valid");
        for _ in 0..5 {
            let wanted = wrench(&mut rng, 2.0 * total, 0.4 * total);
            let mut cold: PointContacts<f64, _, CAPACITY> =
                PointContacts::new(points.clone(), total).expect("valid");
            let [a, b] = [warm.nearest(&wanted, 0.1), cold.nearest(&wanted, 0.1)];
            assert!(distance(&a, &b, 0.1) <= 1e-12 * total, "{a:?} {b:?}");
        }
    }
}

#[test]
fn foreign_numbers_give_numbers_or_nan() {
    let points = points(&mut Lcg::new(13), 3);
    let extremes = [
        0.0,
        -0.0,
        5e-324,
        1e-300,
        1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    for x in extremes {
        for n in extremes {
            for length in extremes {
                let mut foot: PointContacts<f64, _, CAPACITY> =
                    PointContacts::new(points.clone(), 1.0).expect("valid");
                let given = Wrench::new(x, -x, n);
                let got = foot.nearest(&given, length);
                let sane = x.is_finite() && n.is_finite() && (n / length).is_finite() && x < 1e308;
                let wanted = length > 0.0 && length.is_finite() && (1.0 / length).is_finite();
                if wanted && sane && n < 1e308 {
                    assert!(
                        got.force.x.abs() <= x.abs().max(1.0),
                        "{x} {n} {length} {got:?}"
                    );
                } else if x.is_nan() || n.is_nan() || length.is_nan() {
                    assert!(got.force.x.is_nan() && got.torque.is_nan());
                }
            }
        }
    }
}

#[test]
fn single_precision_follows() {
    let mut rng = Lcg::new(17);
    let mut worst = 0.0_f64;
    for case in 0..1000 {
        let points = points(&mut rng, case);
        let mut narrow_points = NodeList::<f32, CAPACITY>::new();
        let mut wide_points = Points::new();
        for node in points.nodes() {
            let [x, y, weight] = [node.x, node.y, node.weight].map(|value| value as f32);
            narrow_points.push(Node { x, y, weight }).expect("room");
            let [x, y, weight] = [x, y, weight].map(f64::from);
            wide_points.push(Node { x, y, weight }).expect("room");
        }
        let mut narrow: PointContacts<f32, _, CAPACITY> =
            PointContacts::new(narrow_points, 3.0).expect("valid");
        let mut wide: PointContacts<f64, _, CAPACITY> =
            PointContacts::new(wide_points, 3.0).expect("valid");
        let wanted = wrench(&mut rng, 6.0, 0.6);
        let [x, y, n] = [wanted.force.x, wanted.force.y, wanted.torque].map(|value| value as f32);
        let got = narrow.nearest(&Wrench::new(x, y, n), 0.125);
        let wanted = Wrench::new(f64::from(x), f64::from(y), f64::from(n));
        let right = wide.nearest(&wanted, 0.125);
        let got = Wrench::new(
            f64::from(got.force.x),
            f64::from(got.force.y),
            f64::from(got.torque),
        );
        let size = distance(&wanted, &Wrench::ZERO, 0.125);
        worst = worst.max(distance(&got, &right, 0.125) / size);
    }
    println!("worst in f32: {worst:.1e} of the wrench");
    assert!(worst < 1e-6);
}
