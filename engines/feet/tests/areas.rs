//! Footprints against many small cells, wherever they lie under the body.

use nalgebra::Vector2;
use tribos_core::contact::TimeStep;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};
use tribos_feet::{Ended, Foot, Footprint, Patch, Standing};

const LIMIT: f32 = 8.0;
const HALF: [f32; 2] = [0.12, 0.05];
const COUNT: usize = 60;
/// Error of friction over its limit, and of its torque over limit and half length.
const NEAR: f32 = 3e-3;

fn body() -> PlanarBody<f32> {
    PlanarBody::new(1.5, 0.02).unwrap()
}

/// A rectangle as a footprint, and as cells.
fn rectangle(place: [f64; 2], angle: f64, motion: &Twist<f32>, push: &Wrench<f32>) -> [Ended; 2] {
    let (body, dt) = (body(), TimeStep::new(1.0 / 60.0).unwrap());
    let [a, b] = HALF;
    let footprint = Footprint::polygon(&[[-a, -b], [a, -b], [a, b], [-a, b]], 2).unwrap();
    let (sin, cos) = angle.sin_cos();
    let foot = Foot {
        axis: [cos, sin],
        ..Foot::new(&footprint, LIMIT, place)
    };
    let at = |k: usize| f64::from((2 * k + 1) as f32 / COUNT as f32 - 1.0);
    let cell = |k: usize| {
        let [x, y] = [f64::from(a) * at(k / COUNT), f64::from(b) * at(k % COUNT)];
        let turned = [place[0] + cos * x - sin * y, place[1] + sin * x + cos * y];
        (turned, LIMIT / (COUNT * COUNT) as f32)
    };
    let cells: Vec<_> = (0..COUNT * COUNT).map(cell).collect();
    let whole = Standing::new(&body, None, &[foot]);
    let many = Standing::on_points(&body, &cells);
    [whole, many].map(|standing| standing.step(motion, push, dt).unwrap())
}

#[test]
fn a_turned_polygon_resists_as_its_cells_do() {
    let push = Wrench::new(1.0, -2.0, 0.05);
    for place in [[0.0, 0.0], [0.03, -0.02]] {
        for angle in [0.0, 0.7, -2.1] {
            for motion in [
                Twist::new(1.0, 0.3, 0.0),
                Twist::new(0.4, -0.5, 9.0),
                Twist::new(0.05, 0.0, -20.0),
            ] {
                let [is, right] = rectangle(place, angle, &motion, &push);
                let off = is.friction - right.friction;
                let force = off.force.norm() / LIMIT;
                let torque = off.torque.abs() / (LIMIT * HALF[0]);
                assert!(
                    force < NEAR && torque < NEAR,
                    "{place:?} {angle} {motion:?}: {:?} for {:?}",
                    is.friction,
                    right.friction
                );
            }
        }
    }
}

#[test]
fn a_held_push_is_balanced_to_the_last_bit() {
    for angle in [0.0, 0.7] {
        let push = Wrench::new(3.1, -4.3, 0.07);
        let [is, right] = rectangle([0.0, 0.0], angle, &Twist::ZERO, &push);
        assert!(is.is_at_rest() && right.is_at_rest());
        assert_eq!(is.twist, Twist::ZERO);
        assert_eq!(is.friction, Wrench::new(-3.1, 4.3, -0.07));
        // Beyond the limit it slides.
        let push = Wrench::new(6.1, -6.3, 0.07);
        assert!(!rectangle([0.0, 0.0], angle, &Twist::ZERO, &push)[0].is_at_rest());
    }
}

#[test]
fn a_body_at_rest_lets_go_at_its_static_limit_and_slides_under_the_kinetic_one() {
    let (body, dt) = (body(), TimeStep::new(1.0 / 60.0).unwrap());
    let (disk, strength) = (Footprint::disk(0.05).unwrap(), 1.5);
    let one = [Foot::new(&disk, LIMIT, [0.0; 2])];
    let places = [[0.1, 0.0], [-0.1, 0.05], [-0.1, -0.05], [0.1, 0.0]];
    let many = places.map(|place| Foot::new(&disk, LIMIT / 4.0, place));
    for feet in [&one[..], &many[..]] {
        let standing = Standing::new(&body, None, feet);
        for angle in [0.0_f32, 1.1] {
            let at = |load: f32| Wrench::new(load * angle.cos(), load * angle.sin(), 0.0);
            for share in [0.5, 0.9, 0.9999, 1.0001, 1.3] {
                let push = at(share * strength * LIMIT);
                let end = standing
                    .step_sticking(strength, &Twist::ZERO, &push, dt)
                    .unwrap();
                assert_eq!(end.is_at_rest(), share < 1.0, "{} feet {share}", feet.len());
                if end.is_at_rest() {
                    assert_eq!(end.friction, -push);
                    assert_eq!(end.twist, Twist::ZERO);
                    // What the feet carry is the whole.
                    let sum = (0..feet.len()).map(|n| end.foot(n).wrench.force);
                    let sum = sum.fold(Vector2::zeros(), |sum, force| sum + force);
                    assert!((sum + push.force).norm() < 1e-5 * push.force.norm());
                    continue;
                }
                let kinetic = standing.step(&Twist::ZERO, &push, dt).unwrap();
                assert_eq!(end.twist, kinetic.twist);
                // It goes on under a push between both limits.
                let between = at(1.2 * LIMIT);
                let next = standing
                    .step_sticking(strength, &end.twist, &between, dt)
                    .unwrap();
                assert!(!next.is_at_rest() && next.twist.speed() > end.twist.speed());
            }
        }
        let push = Wrench::new(1.0, 0.0, 0.0);
        assert!(
            standing
                .step_sticking(f32::NAN, &Twist::ZERO, &push, dt)
                .is_none()
        );
    }
}

#[test]
fn a_body_without_friction_moves_freely() {
    let (body, dt) = (body(), TimeStep::new(0.5).unwrap());
    let disk = Footprint::disk(0.1).unwrap();
    let feet = [Foot::new(&disk, 0.0, [0.0; 2])];
    let standing = Standing::new(&body, None, &feet);
    let push = Wrench::new(3.0, 0.0, 0.04);
    let end = standing.step(&Twist::ZERO, &push, dt).unwrap();
    assert_eq!(end.friction, Wrench::ZERO);
    assert!((end.twist.velocity.x - 1.0).abs() < 1e-6 && (end.twist.spin - 1.0).abs() < 1e-6);
}

/// A round foot alone, and in two halves of the load at one place, against its points.
#[test]
fn a_round_foot_under_any_pressure_resists_as_its_points_do() {
    let (body, dt) = (body(), TimeStep::new(1.0 / 60.0).unwrap());
    for name in [
        "disk",
        "ring",
        "annulus:0.5",
        "hertz",
        "punch",
        "paraboloid",
        "power:0.25",
        "polynomial:1,-0.5",
    ] {
        let patch: Patch = name.parse().unwrap();
        let footprint = Footprint::round(&patch, HALF[0]).unwrap();
        let share: f32 = footprint.points().iter().map(|point| point[2]).sum();
        assert!((share - 1.0).abs() < 1e-5, "{name}: {share}");
        let point = |&[x, y, share]: &[f32; 3]| ([x, y].map(f64::from), LIMIT * share);
        let points: Vec<_> = footprint.points().iter().map(point).collect();
        let half = Foot::new(&footprint, 0.5 * LIMIT, [0.0; 2]);
        for motion in [Twist::new(0.3, 0.4, 0.0), Twist::new(0.8, 0.0, 3.0)] {
            let ends = [
                Standing::on_points(&body, &points),
                Standing::new(&body, None, &[Foot::new(&footprint, LIMIT, [0.0; 2])]),
                Standing::new(&body, None, &[half, half]),
            ];
            let [right, alone, among] =
                ends.map(|standing| standing.step(&motion, &Wrench::ZERO, dt).unwrap().friction);
            for is in [alone, among] {
                let force = (is.force - right.force).norm() / LIMIT;
                let torque = (is.torque - right.torque).abs() / (LIMIT * HALF[0]);
                assert!(
                    force < NEAR && torque < NEAR,
                    "{name} {motion:?}: {is:?} for {right:?}"
                );
            }
        }
    }
}

/// Force over the limit and torque over limit and half length by which the friction of a foot differs from that
/// of points, on the foot alone and on two halves of it.
fn differences(footprint: &Footprint, points: &[([f64; 2], f32)], motion: &Twist<f32>) -> Vec<f32> {
    let (body, dt) = (body(), TimeStep::new(1.0 / 60.0).unwrap());
    let turned = |([x, y], limit): ([f64; 2], f32)| ([PLACE[0] - y, PLACE[1] + x], limit);
    let points: Vec<_> = points.iter().copied().map(turned).collect();
    let foot = |limit: f32| Foot {
        axis: [0.0, 1.0],
        ..Foot::new(footprint, limit, PLACE)
    };
    let ends = [
        Standing::on_points(&body, &points),
        Standing::new(&body, None, &[foot(LIMIT)]),
        Standing::new(&body, None, &[foot(0.5 * LIMIT); 2]),
    ];
    let [right, alone, among] =
        ends.map(|standing| standing.step(motion, &Wrench::ZERO, dt).unwrap().friction);
    let off = |is: Wrench<f32>| {
        let off = is - right;
        [
            off.force.norm() / LIMIT,
            off.torque.abs() / (LIMIT * HALF[0]),
        ]
    };
    [alone, among].into_iter().flat_map(off).collect()
}

const PLACE: [f64; 2] = [0.03, -0.02];
const MOTIONS: [Twist<f32>; 2] = [
    Twist {
        velocity: Vector2::new(0.4, -0.5),
        spin: 9.0,
    },
    Twist {
        velocity: Vector2::new(0.05, 0.0),
        spin: -20.0,
    },
];

#[test]
fn a_sole_with_a_hole_resists_as_its_cells_do() {
    // A square frame, pressed twice as much on the right as on the left.
    let pressure = |x: f32| 1.5 + 0.5 * x / HALF[0];
    let corner = |size: f32, [x, y]: [f32; 2]| [size * x, size * y, pressure(size * x)];
    let around = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let rings = [HALF[0], 0.5 * HALF[0]].map(|size| around.map(|at| corner(size, at)));
    let strip = |k: usize| {
        [
            [k, (k + 1) % 4, 4 + k],
            [(k + 1) % 4, 4 + (k + 1) % 4, 4 + k],
        ]
    };
    let triangles: Vec<_> = (0..4).flat_map(strip).collect();
    let sole = Footprint::mesh(rings.as_flattened(), &triangles).unwrap();
    let at = |k: usize| HALF[0] * ((2 * k + 1) as f32 / COUNT as f32 - 1.0);
    let places = (0..COUNT * COUNT).map(|k| [at(k / COUNT), at(k % COUNT)]);
    let outside = places.filter(|[x, y]| x.abs().max(y.abs()) > 0.5 * HALF[0]);
    let cells: Vec<_> = outside
        .map(|[x, y]| ([x, y].map(f64::from), pressure(x)))
        .collect();
    let whole: f32 = cells.iter().map(|cell| cell.1).sum();
    let cells: Vec<_> = cells
        .into_iter()
        .map(|(at, p)| (at, LIMIT * p / whole))
        .collect();
    for motion in &MOTIONS {
        for off in differences(&sole, &cells, motion) {
            assert!(off < NEAR, "{motion:?}: {off}");
        }
    }
}

#[test]
fn legs_resist_as_their_points_do() {
    let legs = [[0.1, 0.02, 3.0], [-0.1, 0.05, 2.0], [-0.05, -0.1, 1.0]];
    let points = legs.map(|[x, y, weight]: [f32; 3]| ([x, y].map(f64::from), LIMIT * weight / 6.0));
    for motion in &MOTIONS {
        for off in differences(&Footprint::weighted(&legs).unwrap(), &points, motion) {
            assert!(off < 1e-5, "{motion:?}: {off}");
        }
    }
}

#[test]
fn a_kept_surface_serves_the_foot_at_its_place_alone() {
    let (body, dt) = (body(), TimeStep::new(1.0 / 60.0).unwrap());
    let [a, b] = HALF;
    let corners = [[-a, -b], [a, -b], [a, b], [-a, b]];
    let [first, second] = [(); 2].map(|()| Footprint::polygon(&corners, 2).unwrap());
    let motion = Twist::new(0.3, -0.1, 2.0);
    let ended = |foot: &Foot, kept| {
        let standing = Standing::with_surface(&body, None, &[*foot], kept);
        let end = standing.step(&motion, &Wrench::ZERO, dt).unwrap();
        (end.twist, end.friction)
    };
    let foot = Foot::new(&first, LIMIT, [0.1, 0.02]);
    let kept = Standing::new(&body, None, &[foot]).surface_aside().unwrap();
    let elsewhere = Foot::new(&first, LIMIT, [0.02, 0.1]);
    let other = Foot::new(&second, LIMIT, foot.place);
    for foot in [foot, elsewhere, other] {
        assert_eq!(ended(&foot, Some(&kept)), ended(&foot, None));
    }
    assert_ne!(ended(&elsewhere, None), ended(&foot, None));
    let centred = Foot::new(&first, LIMIT, [0.0; 2]);
    let standing = Standing::new(&body, None, &[centred]);
    assert!(standing.surface_aside().is_none());
}
