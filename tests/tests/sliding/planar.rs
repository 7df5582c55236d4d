//! Tall bodies: their paths bend, loop and end where independent solutions say.

use tribos::friction::{AnyFriction, Flat, FlatPatch, Law, Patch};
use tribos::slide::planar::{
    Gradient, Launch, Pipe, PlanarResult, PlanarSimulation, Plate, Resistance, SlideStopReason,
    TallBody, TallCylinder,
};
use tribos_core::coupling::table::DiskTable64;
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::slider::{Slider, SliderParameters, SliderState};
use tribos_tests::pucks::relative;
use tribos_tests::tables::Table;

/// Speeds that count as rest for laws that never rest.
const STOP_FRACTION: f64 = 1e-4;
/// Standard gravity of the tables, m/s².
const GRAVITY: f64 = 9.81;

fn end(body: &impl Resistance, velocity: [f64; 2], spin: f64) -> PlanarResult {
    PlanarSimulation::new(body, &Launch { velocity, spin }, STOP_FRACTION)
        .unwrap()
        .to_end()
        .unwrap()
}

/// The cylinder of the engines' comparison, H/R = 2.
fn cylinder() -> TallCylinder {
    TallCylinder {
        height: 0.16,
        ..TallCylinder::solid(0.2, 0.08)
    }
}

/// Relative deviation of the place from the table's, by the length of the way.
fn off(point: [f64; 2], table: [f64; 2]) -> f64 {
    (point[0] - table[0]).hypot(point[1] - table[1]) / table[0].hypot(table[1])
}

#[test]
fn tall_cylinders_end_where_the_table_says() {
    for row in Table::read("tilted_cylinder.csv").rows() {
        let radius = row.number("R");
        let cylinder = TallCylinder {
            height: row.number("H_over_R") * radius,
            gradient: match row.text("variant") {
                "front-back" => Gradient::FrontBack,
                _ => Gradient::AllRound,
            },
            ..TallCylinder::solid(row.number("mu"), radius)
        };
        let body = cylinder.body(row.number("g")).unwrap();
        let arrival = end(&body, [row.number("v0"), 0.0], row.number("spin0"));
        let point = arrival.point;
        assert_eq!(arrival.ending, SlideStopReason::Rest);
        // Measured: 2e-13 in the angle, 4e-14 elsewhere.
        let at = (row.text("variant"), row.number("spin0"));
        let place = off(point.position, [row.number("x"), row.number("y")]);
        assert!(place < 1e-13, "{at:?}: {place:e}");
        for (column, value) in [
            ("t_stop", point.time),
            ("angle", point.angle),
            ("ratio_end", point.ratio),
        ] {
            let error = row.reference(column).relative(value);
            assert!(error < 5e-13, "{at:?}, {column}: {error:e}");
        }
    }
}

#[test]
fn spirals_with_many_loops_end_where_another_program_says() {
    // A heavy ring spun up to 40 m/s and nudged: scipy's DOP853 in the same variables at
    // tolerance 1e-13, friction from 2048 points of the ring.
    // Height of the centre of mass in m, time in s, place in m, angle.
    for (height, gradient, time, place, angle) in [
        (
            0.4,
            Gradient::FrontBack,
            61.162091456419944,
            [0.8994423614957349, -0.5396654292549227],
            15290.523859582343,
        ),
        (
            0.4,
            Gradient::AllRound,
            61.162127292527586,
            [1.476325763964074, -0.6327113127362074],
            15290.527841489478,
        ),
        (
            4.0,
            Gradient::FrontBack,
            61.162091456417905,
            [0.03306058234217451, -0.19836350160563399],
            15290.523859582361,
        ),
    ] {
        let body = ring(height, gradient, 3.0);
        let point = end(&body, [0.05, 0.0], 500.0).point;
        assert!(relative(point.time, time) < 1e-10, "{}", point.time);
        assert!(relative(point.angle, angle) < 1e-10, "{}", point.angle);
        let error = off(point.position, place);
        assert!(error < 1e-10, "{:?}: {error:e}", point.position);
    }
}

/// A thin ring of 8 cm on μ = 0.2.
fn ring(height: f64, gradient: Gradient, inertia_ratio: f64) -> TallBody {
    let law = Law::coulomb(0.2).unwrap();
    let foot = AnyFriction::new(&Patch::Ring, &law, None).unwrap();
    let foot = foot.with_radius(0.08).unwrap();
    TallBody::new(foot, height, gradient, [GRAVITY, inertia_ratio]).unwrap()
}

#[test]
fn loops_have_at_least_24_points_a_turn() {
    let body = ring(4.0, Gradient::FrontBack, 3.0);
    let launch = Launch {
        velocity: [0.05, 0.0],
        spin: 500.0,
    };
    let mut headings = Vec::new();
    PlanarSimulation::new(&body, &launch, STOP_FRACTION)
        .unwrap()
        .follow(&[], |point| {
            headings.push(point.velocity[1].atan2(point.velocity[0]))
        })
        .unwrap();
    headings.pop();
    let mut turned: f64 = 0.0;
    for pair in headings.windows(2) {
        // To the right, by less than 20 degrees: 15 and the step that went beyond.
        let turn = (pair[0] - pair[1]).rem_euclid(std::f64::consts::TAU);
        assert!(turn < 0.35, "{turn}");
        turned += turn;
    }
    assert!(turned > 10.0 * std::f64::consts::TAU, "{turned}");
}

#[test]
fn counterclockwise_bends_right_and_clockwise_is_its_mirror_image() {
    for gradient in [Gradient::AllRound, Gradient::FrontBack] {
        let body = TallCylinder {
            gradient,
            ..cylinder()
        };
        let body = body.body(GRAVITY).unwrap();
        for spin in [0.5, 5.0, 50.0] {
            let left = end(&body, [1.0, 0.0], spin).point;
            let right = end(&body, [1.0, 0.0], -spin).point;
            assert!(left.position[1] < 0.0);
            assert_eq!(left.position, [right.position[0], -right.position[1]]);
            assert_eq!(left.time, right.time);
            assert_eq!(left.angle, -right.angle);
            // Launched another way, the whole path turns.
            let turned = end(&body, [-0.6, 0.8], spin).point.position;
            let [x, y] = left.position;
            let expected = [-0.6 * x - 0.8 * y, 0.8 * x - 0.6 * y];
            assert!(off(turned, expected) < 1e-13, "{turned:?} {expected:?}");
        }
    }
}

#[test]
fn flat_bodies_go_straight_and_agree_with_the_kernel_slider() {
    for (alpha, speed, spin) in [
        (0.0, 1.0, 5.0),
        (0.0, 0.01, 50.0),
        (0.0, 1.0, -0.1),
        (0.5, 1.0, 12.0),
        (-0.5, 2.0, 1.5),
        (0.9, 1.0, 5.0),
        (0.97, 1.0, 5.0),
    ] {
        let flat = TallCylinder {
            alpha,
            ..TallCylinder::solid(0.3, 0.08)
        };
        let point = end(&flat.body(GRAVITY).unwrap(), [speed, 0.0], spin).point;
        let table = DiskTable64::new(alpha).unwrap();
        let rest = Slider::new(
            table,
            SliderParameters {
                deceleration: 0.3 * GRAVITY,
                radius: 0.08,
                inertia_ratio: 0.5,
            },
        )
        .unwrap()
        .to_rest(&SliderState::launched(speed, spin))
        .unwrap();
        assert_eq!(point.position[1], 0.0);
        for (ours, theirs) in [
            (point.time, rest.motion.time),
            (point.position[0], rest.motion.distance),
            (point.distance, rest.motion.distance),
            (point.angle, rest.motion.angle),
        ] {
            let error = relative(ours, theirs);
            assert!(error < 1e-12, "alpha {alpha}, {spin} rad/s: {error:e}");
        }
        // The ratio finds its limit ever more slowly towards α = 1.
        let error = relative(point.ratio, rest.ratio);
        assert!(
            error < 1e-12 / (1.0 - alpha) || alpha > 0.9,
            "alpha {alpha}: {error:e}"
        );
    }
}

#[test]
fn friction_takes_all_the_kinetic_energy() {
    let pipe = Pipe {
        coefficient: 0.15,
        alpha: 0.0,
        radius: 0.05,
        inner_ratio: 0.9,
        height: 0.15,
        gradient: Gradient::AllRound,
    };
    let pipe_body = pipe.body(GRAVITY).unwrap();
    let cylinder_body = cylinder().body(GRAVITY).unwrap();
    for (body, speed, spin) in [
        (&pipe_body, 1.74, 10.2),
        (&pipe_body, 0.01, 300.0),
        (&cylinder_body, 1.0, 50.0),
        (&cylinder_body, 0.1, 500.0),
    ] {
        let rim = spin * body.radius();
        let energy = 0.5 * (speed * speed + body.inertia_ratio() * rim * rim);
        let work = end(body, [speed, 0.0], spin).point.work;
        assert!(relative(work, energy) < 1e-13, "{work} {energy}");
    }
}

#[test]
fn requested_times_lie_on_the_path() {
    let body = cylinder().body(GRAVITY).unwrap();
    let launch = Launch {
        velocity: [1.0, 0.0],
        spin: 50.0,
    };
    let journey = || PlanarSimulation::new(&body, &launch, STOP_FRACTION).unwrap();
    let times: Vec<f64> = (1..=160).map(|k| 0.01 * f64::from(k)).collect();
    let mut seen = Vec::new();
    journey().follow(&times, |point| seen.push(*point)).unwrap();
    for &time in &times {
        let point = seen.iter().find(|p| relative(p.time, time) < 1e-15);
        let point = point.unwrap_or_else(|| panic!("no point at {time} s"));
        // Set off again from here, the rest of the way is the same.
        let [x, y] = point.position;
        let rest = end(&body, point.velocity, point.spin).point;
        let whole = seen.last().unwrap();
        assert!(relative(time + rest.time, whole.time) < 1e-13);
        let place = [x + rest.position[0], y + rest.position[1]];
        assert!(off(place, whole.position) < 1e-13);
    }
}

#[test]
fn steep_laws_fade_and_a_body_too_tall_is_held_at_the_edge() {
    let faint = TallCylinder {
        alpha: 1.0,
        height: 0.1,
        ..TallCylinder::solid(0.05, 0.08)
    };
    let arrival = end(&faint.body(GRAVITY).unwrap(), [1.0, 0.0], 5.0);
    assert_eq!(arrival.ending, SlideStopReason::Faded);
    let [x, y] = arrival.point.velocity;
    assert!(x.hypot(y) <= STOP_FRACTION && arrival.point.spin.abs() <= 5.0 * STOP_FRACTION);
    let tall = TallCylinder {
        height: 0.8,
        ..cylinder()
    };
    let arrival = end(&tall.body(GRAVITY).unwrap(), [1.0, 0.0], 5.0);
    assert!(arrival.most_lean > 1.0 && arrival.point.position[1] < 0.0);
}

#[test]
fn plates_end_where_the_table_says() {
    for row in Table::read("plates.csv").rows() {
        let corners = match row.text("shape") {
            "box" => vec![[-0.15, -0.05], [0.15, -0.05], [0.15, 0.05], [-0.15, 0.05]],
            "triangle" => vec![[0.0, 0.0], [0.3, 0.0], [0.0, 0.2]],
            _ => vec![
                [0.0, 0.0],
                [0.4, 0.0],
                [0.4, 0.1],
                [0.1, 0.1],
                [0.1, 0.4],
                [0.0, 0.4],
            ],
        };
        let memory = vec![Edge::default(); corners.len()];
        let outline = Polygon::with_holes(&[&corners], memory).unwrap();
        let plate = Plate::new(Flat::Polygon(outline), row.number("mu"), GRAVITY).unwrap();
        let plate = plate.with_orientation(row.number("orientation"));
        let plate = match row.number("gyration") {
            0.0 => plate,
            radius => plate.with_radius_of_gyration(radius).unwrap(),
        };
        let arrival = end(&plate, [row.number("v0"), 0.0], row.number("spin0"));
        let point = arrival.point;
        let at = (row.text("shape"), row.number("spin0"));
        assert_eq!(arrival.ending, SlideStopReason::Rest);
        // The table's own steps are good to 1e-11.
        let reach = point.distance;
        let [x, y] = [row.number("x"), row.number("y")];
        assert!(
            (point.position[0] - x).hypot(point.position[1] - y) < 2e-10 * reach,
            "{at:?}"
        );
        assert!(relative(point.time, row.number("t_stop")) < 2e-10, "{at:?}");
        assert!(relative(point.angle, row.number("angle")) < 2e-10, "{at:?}");
    }
}

fn plate(patch: &str) -> Plate {
    let patch: FlatPatch = patch.parse().unwrap();
    Plate::new(patch.loaded(None).unwrap(), 0.3, GRAVITY).unwrap()
}

#[test]
fn plates_of_every_proportion_come_to_rest_and_keep_their_energy_balance() {
    let balance = |plate: &Plate, velocity: [f64; 2], spin: f64| {
        let point = end(plate, velocity, spin).point;
        let rim = spin * plate.radius();
        let energy = 0.5 * (velocity[0] * velocity[0] + velocity[1] * velocity[1] + rim * rim);
        (point.work / energy - 1.0).abs()
    };
    for patch in ["box:0.2x0.2", "box:1x0.01", "bar:0.3"] {
        for gyration in [0.01, 0.1, 1.0] {
            let plate = plate(patch).with_radius_of_gyration(gyration).unwrap();
            for (speed, spin) in [(1.0, 5.0), (0.0, 5.0), (1.0, 0.0), (1e-6, 5.0), (1.0, 1e-6)] {
                let off = balance(&plate, [0.8 * speed, 0.6 * speed], spin);
                assert!(off < 1e-11, "{patch} {gyration} {speed} {spin}: {off:e}");
            }
        }
    }
    // A plate turned with its launch ends turned.
    let turned = |angle: f64| {
        let plate = plate("box:0.3x0.1");
        let (sin, cos) = angle.sin_cos();
        let [x, y] = end(&plate.with_orientation(angle), [cos, sin], 8.0)
            .point
            .position;
        [cos * x + sin * y, cos * y - sin * x]
    };
    let (one, other) = (turned(0.0), turned(2.1));
    assert!((one[0] - other[0]).abs() < 1e-12 && (one[1] - other[1]).abs() < 1e-12);
}
