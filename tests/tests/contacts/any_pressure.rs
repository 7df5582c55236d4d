//! Supports whose pressure is known by its centre alone: limits and supports by high precision, and what
//! every known pressure must obey.

use tribos_core::Real;
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface, UnknownPressureSet};
use tribos_core::patch::outline::{Edge, LinearPressure, Polygon};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance;
use tribos_tests::worst::Worst;

const LIMIT: f64 = 420.0;

/// Corners, centre, force over the limit.
fn case<R: Real>(row: &Row<'_>) -> (Vec<[R; 2]>, [R; 2], [R; 2]) {
    let numbers = |column| {
        let text = row.text(column);
        text.split(' ')
            .map(|x| R::from_f64(x.parse().expect("a number")))
    };
    let corners = numbers("x").zip(numbers("y")).map(|(x, y)| [x, y]);
    let pair = |x, y| [row.number(x), row.number(y)].map(R::from_f64);
    (
        corners.collect(),
        pair("centre_x", "centre_y"),
        pair("force_x", "force_y"),
    )
}

#[test]
fn limits_and_supports_are_those_of_the_table() {
    let table = Table::read("any_pressure.csv");
    let mut limits = Worst::of("yaw limits");
    let mut gaps = Worst::of("gaps");
    let mut supports = Worst::of("supports");
    for row in table.rows() {
        let (corners, centre, force) = case::<f64>(&row);
        let foot = UnknownPressureSet::new(corners, centre, LIMIT).expect("valid");
        let unit = LIMIT * foot.radius();
        let yaw = foot.torque_limits(force.map(|x| x * LIMIT)).expect("held");
        for (side, column) in ["lowest", "highest"].into_iter().enumerate() {
            let exact = LIMIT * row.number(column);
            let [inner, outer] = [yaw.certain[side], yaw.possible[side]];
            let describe = || format!("{} {force:?} {column}", row.text("shape"));
            limits.see((inner - exact).abs() / unit, describe);
            gaps.see((inner - outer).abs() / unit, describe);
            // Sound to rounding.
            let sign = if side == 0 { -1.0 } else { 1.0 };
            let rounding = 1e-14 * unit;
            assert!(sign * (exact - inner) > -rounding, "{}", describe());
            assert!(sign * (outer - exact) > -rounding, "{}", describe());
            let [low, high] =
                foot.gauge_bounds(&Wrench::new(force[0] * LIMIT, force[1] * LIMIT, exact));
            assert!(low < 1.0 + 1e-13 && high > 1.0 - 1e-13 && high - low < 1e-9);
        }
        let twist = Twist::new(
            row.number("velocity_x"),
            row.number("velocity_y"),
            row.number("spin"),
        );
        let exact = LIMIT * row.number("support");
        let describe = || format!("{} {twist:?}", row.text("shape"));
        supports.see((foot.support(&twist) / exact - 1.0).abs(), describe);
        let power = -foot.wrench(&twist).power(&twist);
        supports.see((power / exact - 1.0).abs(), describe);
    }
    limits.assert_within(&tolerance::ANY_PRESSURE_LIMIT);
    gaps.assert_within(&tolerance::ANY_PRESSURE_LIMIT);
    supports.assert_within(&tolerance::ANY_PRESSURE_SUPPORT);
}

#[test]
fn single_precision_bounds_are_sound_and_near() {
    let table = Table::read("any_pressure.csv");
    let mut worst = Worst::of("yaw limits in f32");
    for row in table.rows() {
        let (corners, centre, force) = case::<f32>(&row);
        let foot = UnknownPressureSet::new(corners, centre, 1.0).expect("valid");
        let yaw = foot.torque_limits(force).expect("held");
        for (side, column) in ["lowest", "highest"].into_iter().enumerate() {
            for bound in [yaw.certain[side], yaw.possible[side]] {
                let error = (f64::from(bound) - row.number(column)).abs();
                worst.see(error / f64::from(foot.radius()), || {
                    format!("{} {force:?} {column}", row.text("shape"))
                });
            }
        }
    }
    worst.assert_within(&tolerance::ANY_PRESSURE_SINGLE);
}

type Sole = Polygon<f64, [Edge<f64>; 4], LinearPressure<f64>>;

/// Centres of pressure of a sole under linear pressure, and its sets.
fn soles() -> Vec<([f64; 2], ShapeLimitSurface<f64, Sole>)> {
    let mut rng = Lcg::new(3);
    let mut soles = Vec::new();
    while soles.len() < 20 {
        let centre = [rng.between(-0.05, 0.15), rng.between(-0.04, 0.04)];
        let sole = Polygon::new(SOLE).expect("valid");
        if let Ok(leaning) = sole.with_centre_of_pressure(centre) {
            soles.push((
                centre,
                ShapeLimitSurface::new(leaning, LIMIT).expect("valid"),
            ));
        }
    }
    soles
}

const SOLE: [[f64; 2]; 4] = [[-0.06, -0.04], [0.18, -0.05], [0.18, 0.05], [-0.06, 0.04]];

#[test]
fn what_a_linear_pressure_carries_some_pressure_carries() {
    let mut rng = Lcg::new(5);
    for (centre, floor) in soles() {
        let foot = UnknownPressureSet::new(SOLE, centre, LIMIT).expect("valid");
        for _ in 0..100 {
            let twist = Twist::new(
                rng.between(-1.0, 1.0),
                rng.between(-1.0, 1.0),
                rng.between(-20.0, 20.0),
            );
            assert!(floor.support(&twist) <= foot.support(&twist) * (1.0 + 1e-14));
            let carried = floor.wrench(&twist);
            let [_, at_most] = foot.gauge_bounds(&carried);
            assert!(at_most <= 1.0 + 1e-10, "{centre:?} {twist:?} {at_most}");
            let [x, y] = [carried.force.x, carried.force.y];
            let [low, high] = floor.torque_limits([x, y]).expect("carried");
            let nearest = (carried.torque - low)
                .abs()
                .min((carried.torque - high).abs());
            // Next to the largest force the torque has half of the digits.
            assert!(nearest < 1e-7 * LIMIT * floor.radius());
            let yaw = foot.torque_limits([x, y]).expect("carried");
            assert!(yaw.possible[0] <= low + 1e-7 && high - 1e-7 <= yaw.possible[1]);
        }
    }
}

#[test]
fn sets_are_symmetric_and_grow_with_load_and_support() {
    let mut rng = Lcg::new(6);
    let near = |a: f64, b: f64| (a - b).abs() < 1e-8;
    for (centre, _) in soles() {
        let foot = UnknownPressureSet::new(SOLE, centre, LIMIT).expect("valid");
        let (size, angle) = (rng.between(0.0, 0.99) * LIMIT, rng.between(-3.0, 3.0));
        let force = [size * angle.cos(), size * angle.sin()];
        let yaw = foot.torque_limits(force).expect("held");
        let other = foot.torque_limits(force.map(|x| -x)).expect("held");
        assert!(
            near(yaw.certain[0], -other.certain[1]) && near(yaw.possible[1], -other.possible[0])
        );
        // The mirror image about the axis of the foot.
        let image = UnknownPressureSet::new(SOLE, [centre[0], -centre[1]], LIMIT).expect("valid");
        let mirrored = image.torque_limits([force[0], -force[1]]).expect("held");
        assert!(near(yaw.certain[1], -mirrored.certain[0]));
        // More load, and a corner more.
        let heavy = UnknownPressureSet::new(SOLE, centre, 1.1 * LIMIT).expect("valid");
        let wider = [&SOLE[..], &[[0.2, 0.0]]].concat();
        let wide = UnknownPressureSet::new(wider, centre, LIMIT).expect("valid");
        let within = [&SOLE[..], &[[0.0, 0.0]]].concat();
        let same = UnknownPressureSet::new(within, centre, LIMIT).expect("valid");
        for (more, least) in [
            (heavy.torque_limits(force), 1e-6),
            (wide.torque_limits(force), 0.0),
        ] {
            let more = more.expect("held");
            assert!(more.possible[1] >= yaw.certain[1] + least);
            assert!(more.possible[0] <= yaw.certain[0] - least);
        }
        let same = same.torque_limits(force).expect("held");
        assert!(near(same.certain[1], yaw.certain[1]));
    }
}

#[test]
fn centres_on_an_edge_at_a_corner_and_on_a_line_are_served() {
    let limit = |corners: &[[f64; 2]], centre, force| {
        let foot = UnknownPressureSet::new(corners, centre, 1.0).expect("valid");
        foot.torque_limits(force).map(|yaw| yaw.certain[1])
    };
    let near = |a: Option<f64>, b: f64| (a.expect("held") - b).abs() < 1e-9;
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    // Two corners with half of the load each, one metre off the centre.
    assert!(near(limit(&square, [0.0, -1.0], [0.0, 0.0]), 1.0));
    // With 0.25 and 0.75 the smaller share pushes against as much of the larger.
    assert!(near(
        limit(&square, [0.5, -1.0], [0.0, 0.0]),
        0.5 / 2.0 + 0.5 / 2.0
    ));
    // At a corner there is no arm; the force's own torque about the origin remains.
    assert!(near(limit(&square, [1.0, 1.0], [0.5, 0.0]), -0.5));
    assert!(near(limit(&[[2.0, 0.0]], [2.0, 0.0], [0.0, 1.0]), 2.0));
    let bar = [[-1.0, 0.0], [3.0, 0.0], [0.5, 0.0]];
    // Pushed along the bar, what the force leaves across it carries the torque.
    let across = |share: f64, x: f64| (share * share - x * x).sqrt();
    let bar_limit = limit(&bar, [1.0, 0.0], [0.6, 0.0]);
    assert!(near(bar_limit, 4.0 * across(0.5, 0.3)));
    let outside = UnknownPressureSet::new(&bar[..], [3.5, 0.0], 1.0);
    assert!(outside.is_err());
}
