//! Curved sides against ellipses and polygons.

extern crate std;

use crate::coupling::flat::{PatchShape, ShapeFriction};
use crate::patch::arcs::{ArcOutline, Border, Side};
use crate::patch::ellipse::{Ellipse, EllipsePressure};
use crate::patch::outline::{Edge, OutlineError, Polygon};
use crate::real::Real;
use crate::twist::{Twist, Wrench};
use std::vec::Vec;

type ArcPiece<R> = ArcOutline<R, [Side<R>; 24]>;

/// Wrench about the origin and derivatives of the power under unit load and coefficient.
fn friction<R: Real>(patch: &impl PatchShape<R>, [x, y, spin]: [f64; 3]) -> [f64; 9] {
    let friction = ShapeFriction::new(patch, R::ONE).unwrap();
    let twist = Twist::new(R::from_f64(x), R::from_f64(y), R::from_f64(spin));
    let (Wrench { force, torque }, jacobian) = friction.wrench_and_jacobian(R::ONE, &twist);
    let second = [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)].map(|at| -jacobian[at]);
    let [xx, xy, yy, xn, yn, nn] = second;
    [force.x, force.y, torque, xx, xy, yy, xn, yn, nn].map(R::to_f64)
}

/// Largest differences of wrenches, and of derivatives in parts of the largest one.
fn apart(found: &[f64; 9], expected: &[f64; 9]) -> [f64; 2] {
    let mut wrench = 0.0_f64;
    let mut bent = 0.0_f64;
    let mut largest = 0.0_f64;
    for (k, (a, b)) in found.iter().zip(expected).enumerate() {
        if k < 3 {
            wrench = wrench.max((a - b).abs());
        } else {
            bent = bent.max((a - b).abs());
            largest = largest.max(b.abs());
        }
    }
    [wrench, bent / largest]
}

/// Centres of rotation: in the patch, on its edge, next to it and far away; in semi-axes.
const PLACES: [[f64; 2]; 16] = [
    [0.0, 0.0],
    [0.3, -0.2],
    [0.6, 0.8],
    [1.0, 0.0],
    [0.0, -1.0],
    [-0.6, 0.8],
    [-0.600_001, 0.8],
    [0.599, 0.8],
    [1.0 + 1e-9, 0.0],
    [0.0, 1.0 - 1e-12],
    [1.5, -0.3],
    [3.0, 4.0],
    [-40.0, 3.0],
    [1e3, 1e4],
    [-1e9, 1e8],
    [0.999, 0.01],
];

fn motions(a: f64, b: f64) -> impl Iterator<Item = [f64; 3]> {
    let turns = PLACES.into_iter().enumerate().map(move |(k, [x, y])| {
        let spin = if k % 3 == 1 { -2.0 } else { 0.7 };
        [spin * b * y, -spin * a * x, spin]
    });
    turns.chain([[1.0, 0.0, 0.0], [-0.3, 0.4, 0.0], [0.2, 0.9, 1e-13]])
}

fn whole<R: Real>(a: f64, b: f64) -> ArcPiece<R> {
    let [a, b, zero] = [a, b, 0.0].map(R::from_f64);
    let arc = Border::Arc {
        centre: [zero; 2],
        half_diameters: [[a, zero], [zero, b]],
        from: R::from_f64(0.3),
        to: R::from_f64(0.3) + R::TWO * R::PI,
    };
    ArcOutline::new(&[arc], [Side::default(); 24]).unwrap()
}

#[test]
fn three_arcs_are_an_ellipse() {
    for [a, b] in [[1.0, 1.0], [1.0, 0.5], [0.25, 1.0], [1.0, 0.1]] {
        let ellipse = Ellipse::new([0.0; 2], [a, b], EllipsePressure::Uniform).unwrap();
        let (arcs, single) = (whole::<f64>(a, b), whole::<f32>(a, b));
        assert!((arcs.area() - core::f64::consts::PI * a * b).abs() < 1e-14);
        for motion in motions(a, b) {
            let exact = friction(&ellipse, motion);
            let [wrench, bent] = apart(&friction(&arcs, motion), &exact);
            // Next to the edge the Jacobian keeps half of the digits of the distance.
            assert!(
                wrench < 5e-15 && bent < 1e-11,
                "{a} {b} {motion:?}: {wrench} {bent}"
            );
            // Nor does single precision know that distance.
            let [wrench, bent] = apart(&friction(&single, motion), &exact);
            assert!(
                wrench < 4e-6 && bent < 5e-4,
                "{a} {b} {motion:?}: {wrench} {bent}"
            );
        }
    }
}

/// Sum of the frictions of pieces, weighted by their areas, and that of the areas.
fn together<R: Real>(pieces: &[ArcPiece<R>], motion: [f64; 3]) -> ([f64; 9], f64) {
    let mut sums = ([0.0; 9], 0.0);
    for piece in pieces {
        let area = piece.area().to_f64();
        sums.1 += area;
        for (sum, part) in sums.0.iter_mut().zip(friction(piece, motion)) {
            *sum += area * part;
        }
    }
    (sums.0.map(|sum| sum / sums.1), sums.1)
}

/// The four cells at a point, two borders through which lie along `along` and across it.
fn cells<R: Real>([x, y]: [f64; 2], [c, s]: [f64; 2]) -> Vec<[[R; 2]; 4]> {
    let at =
        |u: f64, v: f64| [x + 9.0 * (u * c - v * s), y + 9.0 * (u * s + v * c)].map(R::from_f64);
    let corners = [
        (1.0, 0.0),
        (1.0, 1.0),
        (0.0, 1.0),
        (-1.0, 1.0),
        (-1.0, 0.0),
        (-1.0, -1.0),
        (0.0, -1.0),
        (1.0, -1.0),
    ];
    let corner = |k: usize| corners[k % 8];
    [0, 2, 4, 6]
        .map(|k| [(0.0, 0.0), corner(k), corner(k + 1), corner(k + 2)].map(|(u, v)| at(u, v)))
        .to_vec()
}

fn cut<R: Real>(ellipse: &Ellipse<R>, cells: &[[[R; 2]; 4]]) -> Vec<ArcPiece<R>> {
    let pieces = cells
        .iter()
        .map(|cell| ArcOutline::cut(ellipse, cell, [Side::default(); 24]));
    // A cell without ellipse in it is no piece.
    pieces
        .filter(|piece| !matches!(piece, Err(OutlineError::Flat { .. })))
        .map(|piece| piece.expect("a piece"))
        .collect()
}

#[test]
fn an_ellipse_in_pieces_has_the_friction_of_the_whole() {
    let crossings = [
        [0.0, 0.0],
        [0.2, 0.3],
        [-0.5, 0.1],
        [0.05, 0.45],
        [1.7, 0.2],
        [0.9, -0.1],
        [2.0, 3.0],
    ];
    let ways = [[1.0, 0.0], [0.8, 0.6], [0.28, -0.96]];
    for [a, b] in [[1.0, 1.0], [1.0, 0.5]] {
        let ellipse = Ellipse::new([0.0; 2], [a, b], EllipsePressure::Uniform).unwrap();
        let narrow =
            Ellipse::new([0.0; 2], [a as f32, b as f32], EllipsePressure::Uniform).unwrap();
        for crossing in crossings {
            for way in ways {
                let pieces = cut(&ellipse, &cells(crossing, way));
                let single = cut(&narrow, &cells(crossing, way));
                for motion in motions(a, b).step_by(2) {
                    let exact = friction(&ellipse, motion);
                    let (found, area) = together(&pieces, motion);
                    assert!(
                        (area - core::f64::consts::PI * a * b).abs() < 1e-14,
                        "{crossing:?} {way:?}: {area}"
                    );
                    let [wrench, bent] = apart(&found, &exact);
                    assert!(
                        wrench < 2e-14 && bent < 1e-11,
                        "{a} {b} {crossing:?} {way:?} {motion:?}: {wrench} {bent}"
                    );
                    let [wrench, bent] = apart(&together(&single, motion).0, &exact);
                    assert!(
                        wrench < 1e-5 && bent < 2e-3,
                        "{a} {b} {crossing:?} {way:?} {motion:?}: {wrench} {bent}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_polygon_within_the_ellipse_stays_a_polygon_and_one_around_it_the_ellipse() {
    let ellipse = Ellipse::new([0.1, 0.2], [2.0, 1.0], EllipsePressure::Hertz).unwrap();
    let corners = [[0.0, 0.0], [0.8, 0.1], [0.3, 0.6]];
    let inner = ArcOutline::cut(&ellipse, &corners, [Side::default(); 9]).unwrap();
    let polygon = Polygon::new(corners).unwrap();
    assert_eq!(inner.sides().len(), 3);
    let around = [[-5.0, -5.0], [5.0, -5.0], [0.0, 9.0]];
    let whole = ArcOutline::cut(&ellipse, &around, [Side::default(); 9]).unwrap();
    let uniform = Ellipse::new([0.1, 0.2], [2.0, 1.0], EllipsePressure::Uniform).unwrap();
    for motion in [
        [0.1, 0.2, 1.0],
        [1.0, 0.3, 0.4],
        [0.3, -0.3, -1.0],
        [0.2, 0.9, 0.01],
    ] {
        let [wrench, bent] = apart(&friction(&inner, motion), &friction(&polygon, motion));
        assert!(
            wrench < 1e-14 && bent < 1e-13,
            "{motion:?}: {wrench} {bent}"
        );
        let [wrench, bent] = apart(&friction(&whole, motion), &friction(&uniform, motion));
        assert!(
            wrench < 1e-14 && bent < 1e-13,
            "{motion:?}: {wrench} {bent}"
        );
    }
    let apart = [[3.0, 0.0], [4.0, 0.0], [4.0, 1.0]];
    let none = ArcOutline::cut(&ellipse, &apart, [Side::default(); 9]);
    assert!(matches!(none.err(), Some(OutlineError::Flat { .. })));
}

#[test]
fn a_concave_arc_is_a_polygon_with_many_corners() {
    // A square of 2 without a quarter of a disk of radius 1 about its last corner.
    let count = 2048;
    let mut corners = std::vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 0.0]];
    for k in 1..count {
        let angle = core::f64::consts::FRAC_PI_2 * (3.0 - f64::from(k) / f64::from(count));
        corners.push([1.0 + libm::cos(angle), 1.0 + libm::sin(angle)]);
    }
    corners.extend([[0.0, 1.0], [-1.0, 1.0]]);
    let edges = std::vec![Edge::default(); corners.len()];
    let polygon = Polygon::with_holes(&[&corners[..]], edges).unwrap();
    let line = |from, to| Border::Line { from, to };
    let half_turn = core::f64::consts::PI;
    let borders = [
        line([-1.0, -1.0], [1.0, -1.0]),
        line([1.0, -1.0], [1.0, 0.0]),
        Border::Arc {
            centre: [1.0, 1.0],
            half_diameters: [[1.0, 0.0], [0.0, 1.0]],
            from: 1.5 * half_turn,
            to: half_turn,
        },
        line([0.0, 1.0], [-1.0, 1.0]),
        line([-1.0, 1.0], [-1.0, -1.0]),
    ];
    let piece: ArcPiece<f64> = ArcOutline::new(&borders, [Side::default(); 24]).unwrap();
    assert!((piece.area() - (4.0 - 0.25 * half_turn)).abs() < 1e-15);
    for motion in [
        [0.1, 0.2, 1.0],
        [1.0, 0.3, 0.4],
        [0.3, -0.3, -1.0],
        [0.2, 0.9, 0.01],
    ] {
        let [wrench, bent] = apart(&friction(&piece, motion), &friction(&polygon, motion));
        assert!(wrench < 1e-6 && bent < 1e-5, "{motion:?}: {wrench} {bent}");
    }
}

#[test]
fn borders_that_bound_nothing_are_refused() {
    let line = |from, to| Border::Line { from, to };
    let memory = || [Side::default(); 4];
    let (a, b, c) = ([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]);
    let open = ArcOutline::new(&[line(a, b), line(b, c)], memory());
    assert_eq!(open.err(), Some(OutlineError::Open));
    let backwards = ArcOutline::new(&[line(a, c), line(c, b), line(b, a)], memory());
    assert!(matches!(backwards.err(), Some(OutlineError::Flat { .. })));
    let twice = ArcOutline::new(&[line(a, a)], memory());
    assert!(matches!(twice.err(), Some(OutlineError::Repeated { .. })));
    let unknown = ArcOutline::new(&[line(a, [f64::NAN, 0.0])], memory());
    assert!(matches!(unknown.err(), Some(OutlineError::Position { .. })));
    let crowded = ArcOutline::new(&[line(a, b), line(b, c), line(c, a)], [Side::default(); 2]);
    assert_eq!(
        crowded.err(),
        Some(OutlineError::Room { given: 3, room: 2 })
    );
    let none = ArcOutline::<f64, _>::new(&[], memory());
    assert!(matches!(none.err(), Some(OutlineError::Corners { .. })));
}
