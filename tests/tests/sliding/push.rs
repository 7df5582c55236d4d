//! Quasi-static pushing: against sums over nodes, by symmetry, by energy, along paths.

use tribos::friction::Area;
use tribos::kernel::limit_surface::FrictionSet;
use tribos::kernel::nalgebra::Vector2;
use tribos::kernel::twist::Twist;
use tribos::push::{
    ContactMode, LineContact, PathEnd, PointContact, Pose, PushError, PushedSide, Pusher,
};
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::Table;

fn set(patch: &str, centre: Option<[f64; 2]>) -> Box<dyn FrictionSet<f64>> {
    Area::named(&patch.parse().expect("a patch"), 0.05, centre)
        .expect("a set")
        .limit_surface(1.0)
        .expect("a set")
}

fn finger(position: [f64; 2], normal: [f64; 2], mu: f64) -> PointContact {
    PointContact::new(position, normal, mu).expect("valid")
}

#[test]
fn pushes_of_a_box_are_those_of_sums_over_nodes() {
    let table = Table::read("pushes.csv");
    for row in table.rows() {
        let pair = |x, y| [row.number(x), row.number(y)];
        let centre = pair("centre_x", "centre_y");
        let floor = set("box:0.3x0.2", Some(centre));
        let contact = finger(
            [row.number("contact_x"), -0.1],
            [0.0, 1.0],
            row.number("mu"),
        );
        let velocity = pair("pusher_x", "pusher_y");
        let moved = contact.push(&*floor, velocity).expect("pushes");
        let slip = row.number("slip");
        let mode = match slip {
            0.0 => ContactMode::Sticking,
            s if s > 0.0 => ContactMode::SlidingRight,
            _ => ContactMode::SlidingLeft,
        };
        let name = format!("{contact:?} {velocity:?}");
        assert_eq!(moved.mode, mode, "{name}");
        // The nodes are good for 1e-5; motions follow forces with the set's curvature.
        for (found, column, scale) in [
            (moved.slip.x, "slip", 1.0),
            (moved.twist.velocity.x, "velocity_x", 1.0),
            (moved.twist.velocity.y, "velocity_y", 1.0),
            (moved.twist.spin, "spin", 10.0),
            (moved.wrench.force.x, "force_x", 1.0),
            (moved.wrench.force.y, "force_y", 1.0),
            (moved.wrench.torque, "torque", 0.1),
        ] {
            let error = (found - row.number(column)).abs() / scale;
            assert!(error < 1e-4, "{name} {column}: {found} {error:e}");
        }
    }
}

#[test]
fn a_push_through_the_centre_of_a_disk_does_not_turn_it() {
    let puck = set("disk", None);
    let contact = finger([-0.05, 0.0], [1.0, 0.0], 0.3);
    let moved = contact.push(&*puck, [0.02, 0.0]).expect("pushes");
    assert_eq!(moved.mode, ContactMode::Sticking);
    assert!(moved.twist.spin.abs() < 1e-15 && moved.twist.velocity.y.abs() < 1e-16);
    assert!((moved.twist.velocity.x - 0.02).abs() < 1e-16);
    // A pusher that moves along the side or away leaves it at rest.
    for away in [[0.0, 0.01], [-0.02, 0.0]] {
        let left = contact.push(&*puck, away).expect("answers");
        assert_eq!(
            (left.mode, left.twist),
            (ContactMode::Separating, Twist::ZERO)
        );
    }
}

#[test]
fn mirror_images_move_like_mirror_images() {
    let floor = set("box:0.3x0.2", None);
    let mut rng = Lcg::new(11);
    for _ in 0..50 {
        let (x, mu) = (rng.between(-0.15, 0.15), rng.between(0.0, 1.0));
        let velocity = [rng.between(-1.0, 1.0), rng.between(0.1, 1.0)];
        let one = finger([x, -0.1], [0.0, 1.0], mu)
            .push(&*floor, velocity)
            .expect("pushes");
        let image = finger([-x, -0.1], [0.0, 1.0], mu);
        let other = image
            .push(&*floor, [-velocity[0], velocity[1]])
            .expect("pushes");
        assert!(
            (one.twist.spin + other.twist.spin).abs() < 1e-11,
            "{x} {mu}"
        );
        assert!((one.twist.velocity.y - other.twist.velocity.y).abs() < 1e-12);
    }
}

#[test]
fn the_pushers_power_is_what_floor_and_contact_dissipate() {
    let mut rng = Lcg::new(12);
    for patch in ["box:0.3x0.2", "box:0.3x0.02", "disk", "ring", "bar:0.2"] {
        let floor = set(patch, None);
        for _ in 0..200 {
            let place = [rng.between(-0.1, 0.1), rng.between(-0.1, 0.1)];
            let normal = [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)];
            let contact = finger(place, normal, rng.between(0.0, 2.0));
            let velocity = Vector2::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
            let moved = contact.push(&*floor, velocity.into()).expect("pushes");
            let given = moved.wrench.force.dot(&velocity);
            let rubbed = moved.wrench.force.dot(&moved.slip);
            let floor_takes = floor.support(&moved.twist);
            assert!(
                rubbed >= 0.0 && floor_takes >= 0.0,
                "{patch} {contact:?} {velocity:?} {rubbed:e}"
            );
            let error = (given - rubbed - floor_takes).abs();
            assert!(error < 1e-12, "{patch} {contact:?} {velocity:?}: {error:e}");
            // The contact follows the pusher along the normal, and in no other way leaves it.
            if moved.mode != ContactMode::Separating {
                assert!(moved.slip.dot(&contact.normal()).abs() < 1e-14);
                assert!((floor.gauge(&moved.wrench) - 1.0).abs() < 1e-12);
                let [right, left] = contact.edges();
                let force = moved.wrench.force;
                let inside = |a: Vector2<f64>, b: Vector2<f64>| a.x * b.y - a.y * b.x > -1e-12;
                assert!(inside(right, force) && inside(force, left));
            }
        }
    }
}

#[test]
fn motions_are_continuous_where_sliding_begins() {
    let floor = set("box:0.3x0.2", None);
    let contact = finger([0.04, -0.1], [0.0, 1.0], 0.3);
    let cone = contact.motion_cone(&*floor).expect("a cone");
    for edge in [cone.right, cone.left] {
        let speed = edge.contact_velocity.norm();
        let along = edge.contact_velocity / speed;
        let across = Vector2::new(-along.y, along.x);
        let [one, other] = [-1e-9, 1e-9].map(|off| {
            let velocity = along + across * off;
            contact.push(&*floor, velocity.into()).expect("pushes")
        });
        assert_ne!(one.mode, other.mode);
        assert!((one.twist.spin - other.twist.spin).abs() < 1e-6);
        assert!((one.wrench.force - other.wrench.force).norm() < 1e-7);
    }
    assert!(cone.holds(cone.left.contact_velocity + cone.right.contact_velocity));
}

fn drive(samples: u32, tolerance: f64) -> Pusher {
    Pusher {
        contact: finger([0.05, -0.1], [0.0, 1.0], 0.3),
        side: PushedSide::Straight {
            right: 0.1,
            left: 0.2,
        },
        start: Pose::default(),
        velocity: [0.0, 0.02],
        duration: 10.0,
        samples,
        tolerance,
    }
}

#[test]
fn paths_have_the_error_that_they_were_asked_for_and_keep_the_pusher_on_the_side() {
    let floor = set("box:0.3x0.2", None);
    let fine = drive(10, 1e-11).path(&*floor).expect("a path");
    let exact = fine.moments[10].pose;
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let path = drive(10, tolerance).path(&*floor).expect("a path");
        let pose = path.moments[10].pose;
        let off = (pose.x - exact.x).hypot(pose.y - exact.y);
        let turn = (pose.angle - exact.angle).abs() * floor.radius();
        assert!(
            off < tolerance && turn < tolerance,
            "{tolerance} {off:e} {turn:e}"
        );
        for moment in &path.moments {
            assert!((moment.contact.y + 0.1).abs() < tolerance);
        }
    }
    // How often it is recorded does not matter, nor where the floor's axes lie.
    let often = drive(1000, 1e-9).path(&*floor).expect("a path");
    assert!((often.moments[1000].pose.angle - exact.angle).abs() < 1e-8);
    let turned = Pusher {
        start: Pose {
            x: 1.0,
            y: -2.0,
            angle: 1.0,
        },
        velocity: [-0.02 * 1.0_f64.sin(), 0.02 * 1.0_f64.cos()],
        ..drive(10, 1e-9)
    };
    let path = turned.path(&*floor).expect("a path");
    assert!((path.moments[10].pose.angle - 1.0 - exact.angle).abs() < 1e-8);
}

#[test]
fn paths_end_where_the_pusher_slips_off_or_moves_away() {
    let floor = set("box:0.3x0.2", None);
    let short = Pusher {
        contact: finger([0.05, -0.1], [0.0, 1.0], 0.0),
        side: PushedSide::Straight {
            right: 0.1,
            left: 0.001,
        },
        ..drive(10, 1e-7)
    };
    let path = short.path(&*floor).expect("a path");
    let last = path.moments.last().expect("an end");
    assert_eq!(path.end, PathEnd::Slipped);
    assert!((last.contact.x - 0.049).abs() < 1e-5 && last.time < 10.0);
    let away = Pusher {
        velocity: [0.0, -0.02],
        ..short
    };
    let path = away.path(&*floor).expect("a path");
    assert_eq!((path.end, path.moments.len()), (PathEnd::Separated, 1));
    let puck = set("disk", None);
    let straight = Pusher {
        contact: finger([-0.05, 0.0], [1.0, 0.0], 0.3),
        side: PushedSide::Round,
        velocity: [0.02, 0.0],
        ..short
    };
    let path = straight.path(&*puck).expect("a path");
    let last = path.moments[10].pose;
    assert!((last.x - 0.2).abs() < 1e-9 && last.angle.abs() < 1e-9);
    let never = Pusher {
        duration: 0.0,
        ..straight
    };
    let refused = never.path(&*puck);
    assert!(matches!(refused, Err(PushError::Number { .. })));
}

#[test]
fn a_line_holds_the_motions_whose_push_is_a_sum_of_its_ends() {
    let floor = set("box:0.3x0.2", None);
    let fence = LineContact::new([[-0.08, -0.1], [0.08, -0.1]], 0.4).expect("a line");
    // The boundary is on the edge: just inside it holds, just outside it does not.
    let boundary = fence.stable_boundary(&*floor, 25);
    let middle = Twist::new(0.0, 1.0, 0.0);
    for motion in &boundary {
        let mixed = |part: f64| {
            let inner = -floor.wrench(&middle);
            let edge = -floor.wrench(motion);
            let push = inner * part + edge * (1.0 - part);
            fence
                .stable_push(&*floor, &floor.twist_normal_to(&push))
                .is_stable
        };
        assert!(mixed(1e-6) && !mixed(-1e-6), "{motion:?}");
    }
    // Any push that both ends give, in any parts, is a stable one.
    let mut rng = Lcg::new(13);
    for _ in 0..500 {
        let mut push = tribos::kernel::twist::Wrench::ZERO;
        for end in fence.ends() {
            for force in end.edges() {
                push += end.wrench(force) * rng.between(0.01, 1.0);
            }
        }
        let grip = fence.stable_push(&*floor, &floor.twist_normal_to(&push));
        assert!(grip.is_stable, "{push:?}");
    }
}
