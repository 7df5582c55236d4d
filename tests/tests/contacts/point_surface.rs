//! The limit surface of points: facets, their edges, projection against another search; several feet.

use nalgebra::Vector3;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::limit_surface::{FrictionSet, Region, ShapeLimitSurface};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::feet::{CompoundPatch, PatchPart};
use tribos_core::patch::nodes::{Node, NodeList, NodePatch, Nodes};
use tribos_core::patch::outline::Polygon;
use tribos_core::patch::points::PointPatch;
use tribos_core::planar::PointContacts;
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;

type Any = PointPatch<f64, NodeList<f64, 8>>;

/// Two to eight points whose weights span a factor of 100, near the origin.
fn points(rng: &mut Lcg, least: usize) -> Any {
    let count = least + rng.between(0.0, 8.999 - least as f64) as usize;
    let mut nodes = NodeList::new();
    for _ in 0..count.min(8) {
        let [x, y] = [(); 2].map(|()| rng.between(-1.0, 1.0));
        let weight = 10_f64.powf(rng.between(-2.0, 0.0));
        nodes.push(Node { x, y, weight }).expect("room");
    }
    PointPatch::new(nodes).expect("several places")
}

/// What all points but those at `about` resist with when the body turns about it, and the share of these.
fn beside(points: &Any, about: [f64; 2], sense: f64) -> (Wrench<f64>, f64) {
    let total = points.nodes().total_weight();
    let mut wrench = Wrench::ZERO;
    let mut own = 0.0;
    for node in points.nodes().nodes() {
        let (x, y) = (node.x - about[0], node.y - about[1]);
        let far = x.hypot(y);
        let share = node.weight / total;
        if far == 0.0 {
            own += share;
            continue;
        }
        let force = [-sense * y / far * share, sense * x / far * share];
        wrench += Wrench::new(force[0], force[1], node.x * force[1] - node.y * force[0]);
    }
    (wrench, own)
}

/// |velocity| and spin of the difference of two motions.
fn apart(one: &Twist<f64>, other: &Twist<f64>, radius: f64) -> f64 {
    (one.velocity - other.velocity).norm() + radius * (one.spin - other.spin).abs()
}

/// With |velocity|² + (spin · radius)² = 1.
fn unit(twist: &Twist<f64>, radius: f64) -> Twist<f64> {
    *twist * (1.0 / twist.velocity.norm().hypot(twist.spin * radius))
}

#[test]
fn on_a_facet_the_body_turns_about_the_point_whatever_that_carries() {
    let mut rng = Lcg::new(21);
    for _ in 0..3000 {
        let patch = points(&mut rng, 2);
        let surface = ShapeLimitSurface::new(&patch, 3.0).expect("valid");
        let node = patch.nodes().nodes()[rng.between(0.0, 1.999) as usize];
        let sense = if rng.between(-1.0, 1.0) < 0.0 {
            -1.0
        } else {
            1.0
        };
        let (others, own) = beside(&patch, [node.x, node.y], sense);
        let (angle, part) = (rng.between(0.0, 6.3), rng.between(0.0, 1.0));
        // Anywhere on the disc, its rim included.
        let held = own * if part > 0.8 { 1.0 } else { part };
        let (fx, fy) = (held * angle.cos(), held * angle.sin());
        let push = others + Wrench::new(fx, fy, node.x * fy - node.y * fx);
        let turn = unit(
            &Twist::new(sense * node.y, -sense * node.x, sense),
            surface.radius(),
        );
        for scale in [0.125, 3.0, 40.0] {
            let push = push * scale;
            assert!(
                (surface.gauge(&push) - scale / 3.0).abs() < 1e-13 * scale,
                "{patch:?}"
            );
            let motion = surface.twist_normal_to(&push);
            assert!(
                apart(&motion, &turn, surface.radius()) < 1e-12,
                "{patch:?} {motion:?}"
            );
        }
        // The end of the line of all torques with this force.
        let force = push.force * 3.0;
        let limits = surface.torque_limits([force.x, force.y]);
        let limit = limits.expect("carried")[usize::from(sense > 0.0)];
        assert!((limit - 3.0 * push.torque).abs() < 1e-12, "{patch:?}");
        if part < 0.8 {
            let (normal, curvature) = surface.gauge_derivatives(&push);
            assert!((push.power(&normal) - 1.0 / 3.0).abs() < 1e-13 && curvature.amax() == 0.0);
            // Beyond the facet the nearest wrench is straight below, along the normal.
            let length = surface.radius();
            let by = Wrench::new(
                turn.velocity.x,
                turn.velocity.y,
                turn.spin * length * length,
            );
            let beyond = push * 3.0 + by * 0.25;
            let (near, rate) = surface.project_with_jacobian(&beyond, length);
            let rest = near.wrench - push * 3.0;
            assert!(rest.force.norm() + rest.torque.abs() < 1e-12, "{patch:?}");
            let along = rate * Vector3::new(by.force.x, by.force.y, by.torque);
            assert!(along.amax() < 1e-13);
        }
    }
}

#[test]
fn between_facets_push_and_motion_belong_together() {
    let mut rng = Lcg::new(22);
    let (mut gauges, mut motions) = (0.0_f64, 0.0_f64);
    for _ in 0..3000 {
        let patch = points(&mut rng, 3);
        let surface = ShapeLimitSurface::new(&patch, 1.0).expect("valid");
        let node = patch.nodes().nodes()[0];
        let far = 10_f64.powf(rng.between(-3.0, 0.5));
        let angle = rng.between(0.0, 6.3);
        let twist = Twist::new(node.y + far * angle.cos(), far * angle.sin() - node.x, 1.0);
        let push = -surface.wrench(&twist);
        gauges = gauges.max((surface.gauge(&push) - 1.0).abs());
        let normal = unit(&twist, surface.radius());
        let motion = surface.twist_normal_to(&push);
        motions = motions.max(apart(&motion, &normal, surface.radius()));
        assert!((surface.support(&twist) - push.power(&twist)).abs() < 1e-15 * far.max(4.0));
    }
    println!("{gauges:e} {motions:e}");
    assert!(gauges < 1e-9, "{gauges:e}");
    assert!(motions < 1e-3, "{motions:e}");
}

#[test]
fn the_nearest_wrench_is_that_of_the_search_with_smoothed_points() {
    let mut rng = Lcg::new(23);
    let mut worst = 0.0_f64;
    for _ in 0..2000 {
        let patch = points(&mut rng, 2);
        let surface = ShapeLimitSurface::new(&patch, 2.0).expect("valid");
        let nodes: &NodeList<f64, 8> = patch.nodes();
        let mut foot: PointContacts<f64, _, 8> =
            PointContacts::new(nodes.clone(), 2.0).expect("room");
        let length = rng.between(0.25, 2.0);
        let push = Wrench::new(
            rng.between(-4.0, 4.0),
            rng.between(-4.0, 4.0),
            rng.between(-4.0, 4.0),
        );
        let found = surface.project_with_length(&push, length);
        let expected = foot.nearest(&push, length);
        let rest = found.wrench - expected;
        worst = worst.max(rest.force.norm().max(rest.torque.abs() / length));
        let is_carried = expected == push;
        assert_eq!(
            is_carried,
            found.region == Region::Inside,
            "{patch:?} {push:?}"
        );
    }
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn two_halves_of_a_plate_as_feet_are_the_plate() {
    let rectangle = |x: [f64; 2], y: [f64; 2]| {
        Polygon::new([[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]]).expect("valid")
    };
    let whole = rectangle([-1.0, 3.0], [0.0, 2.0]);
    let halves = [
        PatchPart {
            patch: rectangle([-1.0, 0.0], [0.0, 2.0]),
            load: 1.0,
        },
        PatchPart {
            patch: rectangle([0.0, 3.0], [0.0, 2.0]),
            load: 3.0,
        },
    ];
    let feet = CompoundPatch::new(&halves).expect("loaded");
    assert!((feet.centre() - whole.centre()).norm() < 1e-15);
    let (one, other) = (
        ShapeFriction::new(whole, 1.0),
        ShapeFriction::new(feet, 1.0),
    );
    let (one, other) = (one.expect("valid"), other.expect("valid"));
    let mut rng = Lcg::new(25);
    for _ in 0..2000 {
        let far = 10_f64.powf(rng.between(-2.0, 4.0));
        let angle = rng.between(0.0, 6.3);
        let twist = Twist::new(1.0 + far * angle.cos(), far * angle.sin() - 1.0, 1.0);
        let ((a, j), (b, k)) = (
            one.wrench_and_jacobian(1.0, &twist),
            other.wrench_and_jacobian(1.0, &twist),
        );
        let rest = a - b;
        assert!(rest.force.norm() + rest.torque.abs() < 5e-14, "{twist:?}");
        assert!((j - k).amax() < 4e-13 * j.amax(), "{twist:?}");
        assert_eq!(b, other.wrench(1.0, &twist));
    }
    let set = ShapeLimitSurface::new(feet, 1.0).expect("valid");
    let plate = ShapeLimitSurface::new(whole, 1.0).expect("valid");
    for _ in 0..200 {
        let push = Wrench::new(
            rng.between(-1.0, 1.0),
            rng.between(-1.0, 1.0),
            rng.between(-2.0, 2.0),
        );
        assert!(
            (set.gauge(&push) / plate.gauge(&push) - 1.0).abs() < 1e-13,
            "{push:?}"
        );
    }
}

#[test]
fn feet_of_different_kinds_share_a_body_and_keep_the_facets_of_points() {
    let blade = Bar::new([-0.5, 0.0], [0.5, 0.0]).expect("valid");
    let at = |x: f64, y: f64| Node { x, y, weight: 1.0 };
    let props = PointPatch::new(Nodes::new([at(-1.0, 2.0), at(1.0, 2.0)]).expect("valid"));
    let props = props.expect("two places");
    let feet: [PatchPart<f64, &dyn PatchShape<f64>>; 2] = [
        PatchPart {
            patch: &blade,
            load: 2.0,
        },
        PatchPart {
            patch: &props,
            load: 1.0,
        },
    ];
    let body = CompoundPatch::new(&feet).expect("loaded");
    let surface = ShapeLimitSurface::new(body, 1.0).expect("valid");
    // About the prop at (1, 2) m: the blade and the other prop, and any force within a sixth.
    let turn = Twist::new(2.0, -1.0, 1.0);
    let resisted = ShapeFriction::new(blade, 1.0)
        .expect("valid")
        .wrench(2.0 / 3.0, &turn);
    let other = Wrench::new(0.0, -1.0 / 6.0, 1.0 / 6.0);
    for share in [0.0, 0.5, 0.999] {
        let (fx, fy) = (0.6 * share / 6.0, -0.8 * share / 6.0);
        let push = other - resisted + Wrench::new(fx, fy, fy - 2.0 * fx);
        assert!((surface.gauge(&push) - 1.0).abs() < 1e-14, "{share}");
        let motion = surface.twist_normal_to(&push);
        assert!(
            apart(&motion, &unit(&turn, surface.radius()), 1.0) < 1e-13,
            "{motion:?}"
        );
    }
}
