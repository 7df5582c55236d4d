//! Rules that stand for continuous pressures: how fast they converge, and to what.
//!
//! Oracles: the compact tier of the uniform disk, closed forms of the Hertz and punch pressures,
//! and a table of four pressures.

use core::f64::consts::{PI, TAU};
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{DiskFriction, compact};
use tribos_core::law::{Coulomb, PowerLaw};
use tribos_core::patch::UniformDisk;
use tribos_core::patch::nodes::{NodeError, NodeList, NodePatch};
use tribos_core::patch::polar::{self, PolarError, PolarRule};
use tribos_core::patch::polygon::{PolygonError, polygon};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;
use tribos_tests::tables::{Row, Table};
use tribos_tests::tolerance::Bound;
use tribos_tests::worst::Worst;

/// Standard rule, Coulomb, any twist and q from -1/2 to 1, of the load and the load × radius.
const STANDARD: Bound = Bound {
    limit: 5e-3,
    reason: "promised in patch::polar; centre of rotation next to a node",
};
/// Standard rule with the centre of rotation half a radius outside the disk, of the largest speed^α.
const STANDARD_OUTSIDE: Bound = Bound {
    limit: 1e-7,
    reason: "promised in patch::polar; alpha = -1/2 and the load at the rim are the worst",
};
/// Odd exponents: the integrand is a polynomial.
const POLYNOMIAL: Bound = Bound {
    limit: 1e-13,
    reason: "exact but for the rounding of 512 nodes",
};
/// Observed order of convergence with the centre inside against 2 + alpha.
const ORDER: Bound = Bound {
    limit: 0.15,
    reason: "fluctuates with the places of 2000 centres among the nodes; next order",
};

/// Most nodes of any rule here.
const ROOM: usize = 64 * 128;

fn law(alpha: f64) -> PowerLaw<f64> {
    PowerLaw::new(alpha, 1.0).expect("in range")
}

fn dry() -> Coulomb<f64> {
    Coulomb::new(1.0).expect("in range")
}

fn rule(rings: u32, angles: u32, q: f64) -> PolarRule<f64> {
    let uniform = PolarRule::new(1.0, rings, angles).expect("in range");
    uniform.with_rim_exponent(q).expect("in range")
}

fn disk(rings: u32, angles: u32, q: f64) -> NodeList<f64, ROOM> {
    rule(rings, angles, q).nodes().expect("room for all")
}

/// A twist with unit rim speed and v = `eps` in any direction.
fn anyhow(rng: &mut Lcg, eps: f64) -> Twist<f64> {
    let angle = rng.between(0.0, TAU);
    Twist::new(eps * angle.cos(), eps * angle.sin(), 1.0)
}

/// |difference of the forces| and of the torques.
fn distance(a: &Wrench<f64>, b: &Wrench<f64>) -> f64 {
    (a.force - b.force).norm().max((a.torque - b.torque).abs())
}

/// The wrench with magnitudes `force` and `torque` against `twist`.
fn against(twist: &Twist<f64>, force: f64, torque: f64) -> Wrench<f64> {
    let speed = twist.velocity.norm();
    Wrench {
        force: -twist.velocity * (force / speed),
        torque: -torque,
    }
}

/// Root mean square error over 2000 centres of rotation inside the disk.
fn error_inside(alpha: f64, rings: u32, angles: u32) -> f64 {
    let nodes = NodeFriction::new(law(alpha), disk(rings, angles, 0.0));
    let tier = compact::Power::new(alpha).expect("in range");
    let patch = UniformDisk::new(1.0).expect("a radius");
    let exact = DiskFriction::new(tier, 1.0, patch).expect("a coefficient");
    let mut rng = Lcg::new(3);
    let mut sum = 0.0;
    for _ in 0..2000 {
        let eps = rng.between(0.01, 0.9);
        let twist = anyhow(&mut rng, eps);
        let error = distance(&nodes.wrench(1.0, &twist), &exact.wrench(1.0, &twist));
        sum += error * error / 2000.0;
    }
    sum.sqrt()
}

#[test]
fn centre_inside_converges_with_order_two_plus_alpha() {
    let mut worst = Worst::of("order of the polar rule, centre inside");
    for alpha in [-0.5, 0.0, 0.5] {
        let errors = [(8, 16), (16, 32), (32, 64)].map(|(r, a)| error_inside(alpha, r, a));
        println!("alpha {alpha}: {errors:.7?}");
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            worst.see((order - 2.0 - alpha).abs(), || {
                format!("alpha {alpha}: {order:.3}")
            });
        }
    }
    worst.assert_within(&ORDER);
}

#[test]
fn odd_exponents_are_exact() {
    let mut worst = Worst::of("polar rule, alpha 1 and 3");
    for alpha in [1.0, 3.0] {
        worst.see(error_inside(alpha, 16, 32), || format!("alpha {alpha}"));
    }
    worst.assert_within(&POLYNOMIAL);
}

#[test]
fn standard_rule_keeps_its_bound_for_every_pressure() {
    let mut worst = Worst::of("standard rule, Coulomb, centre anywhere");
    let mut rng = Lcg::new(4);
    let tier = compact::Coulomb;
    let patch = UniformDisk::new(1.0).expect("a radius");
    let exact = DiskFriction::new(tier, 1.0, patch).expect("a coefficient");
    let nodes = [0.0, 0.5, -0.5].map(|q| {
        let rule = PolarRule::standard(1.0).expect("a radius");
        let rule = rule.with_rim_exponent(q).expect("in range");
        let list = rule.nodes::<{ PolarRule::<f64>::STANDARD_NODES }>();
        NodeFriction::new(dry(), list.expect("room for all"))
    });
    let [uniform, hertz, punch] = &nodes;
    for _ in 0..20_000 {
        let twist = rng.between(0.001, 1.3);
        let twist = anyhow(&mut rng, twist);
        let found = uniform.wrench(1.0, &twist);
        let error = distance(&found, &exact.wrench(1.0, &twist));
        worst.see(error, || format!("uniform, {twist:?}"));
        let e = twist.velocity.norm();
        if e > 1.0 {
            continue;
        }
        // Closed forms with the centre inside.
        let (sq, fourth) = (e * e, e * e * e * e);
        let force = 0.375 * PI * e * (1.0 - sq / 4.0);
        let torque = 0.1875 * PI * (1.0 - sq + 0.375 * fourth);
        let error = distance(&hertz.wrench(1.0, &twist), &against(&twist, force, torque));
        worst.see(error, || format!("Hertz, {twist:?}"));
        let (force, torque) = (0.25 * PI * e, 0.25 * PI * (1.0 - sq / 2.0));
        let error = distance(&punch.wrench(1.0, &twist), &against(&twist, force, torque));
        worst.see(error, || format!("punch, {twist:?}"));
    }
    worst.assert_within(&STANDARD);
}

/// The table's patch with pressure × (1 + `tilt` x), 16 × 32 nodes, a ring with 512.
fn tabulated(row: &Row<'_>, tilt: f64) -> NodeList<f64, ROOM> {
    let q = row.number("q");
    if q > -1.0 {
        return rule(16, 32, q).nodes_tilted(tilt, 0.0).expect("room");
    }
    let ring: NodeList<f64, ROOM> = polar::ring(1.0, 512).expect("room");
    ring.nodes()
        .iter()
        .fold(NodeList::new(), |mut list, &node| {
            let weight = node.weight * (1.0 + tilt * node.x);
            let pushed = list.push(tribos_core::patch::nodes::Node { weight, ..node });
            pushed.expect("room");
            list
        })
}

#[test]
fn four_pressures_and_their_tilts_agree_with_the_table() {
    let mut outside = Worst::of("standard rule, four pressures, tilted, centre outside");
    let mut inside = Worst::of("the same, centre inside");
    for row in Table::read("pressures.csv").rows() {
        let (alpha, eps) = (row.number("alpha"), row.number("eps"));
        let [force, torque, sideways] = ["F", "T", "Fperp"].map(|name| row.number(name));
        let twist = Twist::new(eps, 0.0, 1.0);
        for tilt in [0.0, 0.6, -1.0] {
            let nodes = NodeFriction::new(law(alpha), tabulated(&row, tilt));
            let found = nodes.wrench(1.0, &twist);
            let mut expected = against(&twist, force, torque);
            expected.force.y = -tilt * sideways;
            let scale = eps.max(1.0).powf(alpha);
            let error = distance(&found, &expected) / scale;
            let place = || {
                format!(
                    "{}, alpha {alpha}, eps {eps}, tilt {tilt}",
                    row.text("pressure")
                )
            };
            if eps >= 1.5 {
                outside.see(error, place);
            } else if alpha >= 0.0 && eps < 1.0 && row.number("q") > -1.0 {
                inside.see(error, place);
            }
        }
    }
    outside.assert_within(&STANDARD_OUTSIDE);
    inside.assert_within(&STANDARD);
}

#[test]
fn a_shape_may_be_any_pressure() {
    // Uniform rule with p(r) = 1 - r² against the parabolic rule.
    let shaped: NodeList<f64, 512> = rule(16, 32, 0.0)
        .nodes_shaped(|x, y| 1.0 - x * x - y * y)
        .expect("room");
    let twist = Twist::new(1.2, 0.9, 1.0);
    let found = NodeFriction::new(dry(), shaped).wrench(1.0, &twist);
    let expected = NodeFriction::new(dry(), disk(16, 32, 1.0)).wrench(1.0, &twist);
    assert!(distance(&found, &expected) < 1e-8);
    // A tilt that would pull is refused where a node lies there.
    let pulling = rule(8, 16, 0.0).nodes_tilted::<ROOM>(1.5, 0.0);
    assert!(matches!(pulling, Err(NodeError::Weight { .. })));
}

/// Area, centroid and second moment about the origin.
fn moments(list: &impl NodePatch<f64>) -> [f64; 4] {
    let sum = |f: fn(f64, f64) -> f64| -> f64 {
        list.nodes().iter().map(|n| n.weight * f(n.x, n.y)).sum()
    };
    let area = list.total_weight();
    [
        area,
        sum(|x, _| x) / area,
        sum(|_, y| y) / area,
        sum(|x, y| x * x + y * y),
    ]
}

#[test]
fn polygons_have_their_area_centroid_and_moment() {
    let close = |found: [f64; 4], expected: [f64; 4]| {
        for (f, e) in found.iter().zip(expected) {
            assert!((f - e).abs() < 1e-13, "{found:?} {expected:?}");
        }
    };
    // A rectangle 3 × 2 from its corner, in both senses.
    let mut corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];
    let expected = [6.0, 1.5, 1.0, 2.0 * 9.0 + 3.0 * 8.0 / 3.0];
    close(
        moments(&polygon::<f64, 56>(&corners, 2).expect("room")),
        expected,
    );
    corners.reverse();
    close(
        moments(&polygon::<f64, 14>(&corners, 1).expect("room")),
        expected,
    );
    // An L: a 2 × 2 square without its upper right unit square.
    let ell = [
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [0.0, 2.0],
    ];
    let list = polygon::<f64, ROOM>(&ell, 3).expect("one corner sees all");
    close(
        moments(&list),
        [3.0, 2.5 / 3.0, 2.5 / 3.0, 32.0 / 3.0 - 14.0 / 3.0],
    );
    // No node in the missing square.
    assert!(list.nodes().iter().all(|n| n.x < 1.0 || n.y < 1.0));
    // A T whose two inner corners lie in one line with the bar, turned by an odd angle.
    let tee = [
        [-3.0, 2.0],
        [-1.0, 2.0],
        [-1.0, 0.0],
        [1.0, 0.0],
        [1.0, 2.0],
        [3.0, 2.0],
        [3.0, 3.0],
        [-3.0, 3.0],
    ];
    let (sin, cos) = 0.37_f64.sin_cos();
    let turned = tee.map(|[x, y]| [cos * x - sin * y, sin * x + cos * y]);
    let list = polygon::<f64, ROOM>(&turned, 1).expect("an inner corner sees all");
    assert!((list.total_weight() - 10.0).abs() < 1e-13);
}

#[test]
fn polygons_that_no_corner_oversees_are_refused() {
    let u_shape = [
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 3.0],
        [2.0, 3.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 3.0],
        [0.0, 3.0],
    ];
    assert_eq!(polygon::<f64, ROOM>(&u_shape, 1), Err(PolygonError::Hidden));
    let line = [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]];
    assert_eq!(polygon::<f64, ROOM>(&line, 1), Err(PolygonError::Hidden));
    let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(polygon::<f64, ROOM>(&bow_tie, 1), Err(PolygonError::Hidden));
    let two = polygon::<f64, ROOM>(&line[..2], 1);
    assert_eq!(two, Err(PolygonError::Corners { given: 2 }));
    let none = polygon::<f64, ROOM>(&u_shape, 0);
    assert_eq!(none, Err(PolygonError::Divisions { given: 0 }));
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let full = polygon::<f64, 13>(&square, 1);
    assert_eq!(
        full,
        Err(PolygonError::Nodes(NodeError::Full { capacity: 13 }))
    );
}

/// A regular polygon with 256 corners and the area of the unit disk.
fn nearly_a_disk(divisions: u32) -> NodeList<f64, 16384> {
    let side = TAU / 256.0;
    let radius = (side / side.sin()).sqrt();
    let corners: Vec<_> = (0..256)
        .map(|n| f64::from(n) * side)
        .map(|angle| [radius * angle.cos(), radius * angle.sin()])
        .collect();
    polygon(&corners, divisions).expect("room")
}

#[test]
fn a_polygon_of_many_corners_is_a_disk() {
    let patch = UniformDisk::new(1.0).expect("a radius");
    let exact = DiskFriction::new(compact::Coulomb, 1.0, patch).expect("a coefficient");
    let nodes = NodeFriction::new(dry(), nearly_a_disk(3));
    for eps in [1.5, 3.0] {
        let twist = Twist::new(0.6 * eps, 0.8 * eps, 1.0);
        let error = distance(&nodes.wrench(1.0, &twist), &exact.wrench(1.0, &twist));
        // 256 corners differ from the disk by (pi/256)²/3 in their second moment.
        assert!(error < 1e-4, "{eps}: {error:e}");
    }
}

#[test]
fn square_converges_with_order_two_while_the_centre_is_inside() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let at = |divisions: u32| {
        let list = polygon::<f64, { 14 * 24 * 24 }>(&square, divisions);
        NodeFriction::new(dry(), list.expect("room"))
    };
    let error = |divisions: u32| {
        let (coarse, fine) = (at(divisions), at(24));
        let mut rng = Lcg::new(6);
        let mut sum = 0.0;
        for _ in 0..200 {
            let eps = rng.between(0.05, 0.8);
            let twist = anyhow(&mut rng, eps);
            sum += distance(&coarse.wrench(1.0, &twist), &fine.wrench(1.0, &twist)).powi(2);
        }
        (sum / 200.0).sqrt()
    };
    let errors = [2, 4, 8].map(error);
    println!("{errors:.7?}");
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.4, "{order}");
    }
}

#[test]
fn rules_without_meaning_are_refused() {
    let with = |r, rings, angles| PolarRule::new(r, rings, angles);
    assert!(matches!(with(0.0, 1, 1), Err(PolarError::Radius(_))));
    assert!(matches!(with(f64::NAN, 1, 1), Err(PolarError::Radius(_))));
    assert_eq!(with(1.0, 0, 1), Err(PolarError::Order { given: 0 }));
    assert_eq!(with(1.0, 1, 1025), Err(PolarError::Order { given: 1025 }));
    for q in [-1.0, 65.0, f64::NAN] {
        let refused = rule(2, 2, 0.0).with_rim_exponent(q);
        assert!(matches!(refused, Err(PolarError::RimExponent { .. })));
    }
    let full = rule(4, 8, 0.0).nodes::<31>();
    assert_eq!(full, Err(NodeError::Full { capacity: 31 }));
}
