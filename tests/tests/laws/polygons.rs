//! Uniform pressure on polygons: area, centroid, moments, refused shapes, convergence.

use core::f64::consts::TAU;
use tribos_core::coupling::nodes::NodeFriction;
use tribos_core::coupling::{RoundFriction, coulomb};
use tribos_core::law::CoulombLaw;
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{NodeList, NodePatch};
use tribos_core::twist::{Twist, Wrench};
use tribos_tests::sweep::Lcg;

const ROOM: usize = 1024;

fn dry() -> CoulombLaw<f64> {
    CoulombLaw::new(1.0).expect("in range")
}

/// A twist with unit spin and v = `eps` in any direction.
fn anyhow(rng: &mut Lcg, eps: f64) -> Twist<f64> {
    let angle = rng.between(0.0, TAU);
    Twist::new(eps * angle.cos(), eps * angle.sin(), 1.0)
}

/// The larger of the differences of force and torque.
fn distance(a: &Wrench<f64>, b: &Wrench<f64>) -> f64 {
    (a.force - b.force).norm().max((a.torque - b.torque).abs())
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
        moments(&NodeList::<f64, 56>::polygon(&corners, 2).expect("room")),
        expected,
    );
    corners.reverse();
    close(
        moments(&NodeList::<f64, 14>::polygon(&corners, 1).expect("room")),
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
    let list = NodeList::<f64, ROOM>::polygon(&ell, 3).expect("one corner sees all");
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
    let list = NodeList::<f64, ROOM>::polygon(&turned, 1).expect("an inner corner sees all");
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
    assert_eq!(
        NodeList::<f64, ROOM>::polygon(&u_shape, 1),
        Err(PatchError::Hidden)
    );
    let line = [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]];
    assert_eq!(
        NodeList::<f64, ROOM>::polygon(&line, 1),
        Err(PatchError::Hidden)
    );
    let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(
        NodeList::<f64, ROOM>::polygon(&bow_tie, 1),
        Err(PatchError::Hidden)
    );
    let two = NodeList::<f64, ROOM>::polygon(&line[..2], 1);
    assert_eq!(two, Err(PatchError::Corners { given: 2 }));
    let none = NodeList::<f64, ROOM>::polygon(&u_shape, 0);
    assert_eq!(none, Err(PatchError::Divisions { given: 0 }));
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let full = NodeList::<f64, 13>::polygon(&square, 1);
    assert_eq!(full, Err(PatchError::Full { capacity: 13 }));
}

/// A regular polygon with 256 corners and the area of the unit disk.
fn nearly_a_disk(divisions: u32) -> NodeList<f64, 16384> {
    let side = TAU / 256.0;
    let radius = (side / side.sin()).sqrt();
    let corners: Vec<_> = (0..256)
        .map(|n| f64::from(n) * side)
        .map(|angle| [radius * angle.cos(), radius * angle.sin()])
        .collect();
    NodeList::polygon(&corners, divisions).expect("room")
}

#[test]
fn a_polygon_of_many_corners_is_a_disk() {
    let exact = RoundFriction::new(coulomb::CoulombDisk, 1.0, 1.0).expect("a coefficient");
    let nodes = NodeFriction::new(dry(), nearly_a_disk(3));
    for eps in [1.5, 3.0] {
        let twist = Twist::new(0.6 * eps, 0.8 * eps, 1.0);
        let error = distance(&nodes.wrench(1.0, &twist), &exact.wrench(1.0, &twist));
        // 256 corners differ from the disk by (pi/256)²/3 in their second moment.
        assert!(error < 1e-4, "{eps}: {error:e}");
    }
}

/// Root mean square error of the square of side 2 for centres with eps in `range`, by divisions,
/// against 24 divisions.
fn square_errors(range: [f64; 2]) -> [f64; 3] {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let at = |divisions| {
        let list = NodeList::<f64, { 14 * 24 * 24 }>::polygon(&square, divisions);
        NodeFriction::new(dry(), list.expect("room"))
    };
    let fine = at(24);
    [2, 4, 8].map(|divisions| {
        let coarse = at(divisions);
        let mut rng = Lcg::new(6);
        let mut sum = 0.0;
        for _ in 0..200 {
            let eps = rng.between(range[0], range[1]);
            let twist = anyhow(&mut rng, eps);
            sum += distance(&coarse.wrench(1.0, &twist), &fine.wrench(1.0, &twist)).powi(2);
        }
        (sum / 200.0).sqrt()
    })
}

#[test]
fn square_converges_with_order_two_inside_and_six_outside() {
    for (range, order, slack) in [([0.05, 0.8], 2.0, 0.3), ([2.0, 3.0], 6.0, 0.6)] {
        let errors = square_errors(range);
        println!("order {order}: {errors:?}");
        for pair in errors.windows(2) {
            let found = (pair[0] / pair[1]).log2();
            assert!((found - order).abs() < slack, "{found} instead of {order}");
        }
    }
}
