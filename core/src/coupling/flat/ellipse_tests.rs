//! Ellipses against chords with 25 digits, their round and thin limits, and places next to special ones.

extern crate std;

use crate::coupling::coulomb::{CoulombDisk, CoulombHertz, CoulombParaboloid, CoulombPunch};
use crate::coupling::flat::ShapeFriction;
use crate::coupling::{DryReducedFriction, RoundFriction};
use crate::patch::PatchError;
use crate::patch::affine_image::{AffineImage, AffineMap};
use crate::patch::bar::Bar;
use crate::patch::ellipse::{Ellipse, EllipsePressure};
use crate::real::Real;
use crate::special::CompleteElliptic;
use crate::twist::{Twist, Wrench};
use nalgebra::Vector2;
use std::vec::Vec;

const TABLE: &str = include_str!("../../../../tests/tables/ellipses.csv");
const ALL: [EllipsePressure; 4] = [
    EllipsePressure::FlatPunch,
    EllipsePressure::Uniform,
    EllipsePressure::Hertz,
    EllipsePressure::Paraboloid,
];

/// Pressure, semi-axes, twist, wrench and second derivatives of each row.
fn rows() -> impl Iterator<Item = (EllipsePressure, Vec<f64>)> {
    TABLE.lines().skip(2).map(|line| {
        let (name, numbers) = line.split_once(',').unwrap();
        let names = ["punch", "uniform", "hertz", "paraboloid"];
        let index = names.iter().position(|of| *of == name).unwrap();
        let numbers = numbers.split(',').map(|x| x.parse().unwrap());
        (ALL[index], numbers.collect())
    })
}

/// Wrench and derivatives of the power under unit load and coefficient.
fn friction<R: Real>(pressure: EllipsePressure, sizes: [R; 2], motion: [R; 3]) -> [f64; 9] {
    let patch = Ellipse::new([R::ZERO; 2], sizes, pressure).unwrap();
    let friction = ShapeFriction::new(patch, R::ONE).unwrap();
    let [x, y, spin] = motion;
    let (wrench, jacobian) = friction.wrench_and_jacobian(R::ONE, &Twist::new(x, y, spin));
    let Wrench { force, torque } = wrench;
    let second = [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)].map(|at| -jacobian[at]);
    let [xx, xy, yy, xn, yn, nn] = second;
    [force.x, force.y, torque, xx, xy, yy, xn, yn, nn].map(R::to_f64)
}

/// Largest differences of wrenches, and of derivatives in parts of the largest one.
fn apart(found: &[f64], expected: &[f64]) -> [f64; 2] {
    let most = |pairs: &mut dyn Iterator<Item = f64>| pairs.fold(0.0, f64::max);
    let mut differences = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
    let wrench = most(&mut differences.by_ref().take(3));
    let largest = most(&mut expected[3..].iter().map(|x| x.abs()));
    [wrench, most(&mut differences) / largest]
}

fn raise(worst: &mut [f64; 2], found: [f64; 2]) {
    *worst = [worst[0].max(found[0]), worst[1].max(found[1])];
}

#[test]
fn chords_with_many_digits_agree() {
    let (mut double, mut single, mut count) = ([0.0; 2], [0.0; 2], 0);
    for (pressure, numbers) in rows() {
        let [a, b, x, y, spin] = [0, 1, 2, 3, 4].map(|k| numbers[k]);
        // A punch's Jacobian rises like a root towards its edge, where half of the digits of the place count.
        let place = Real::hypot(y / (spin * a), x / (spin * b));
        let rises = pressure == EllipsePressure::FlatPunch && (place - 1.0).abs() < 1e-5;
        let eased = |[wrench, bent]: [f64; 2]| [wrench, if rises { bent * 1e-4 } else { bent }];
        let found = friction(pressure, [a, b], [x, y, spin]);
        raise(&mut double, eased(apart(&found, &numbers[5..])));
        let narrow = [a, b, x, y, spin].map(|number| number as f32);
        let [a, b, x, y, spin] = narrow.map(f64::from);
        let exact = friction(pressure, [a, b], [x, y, spin]);
        let [a, b, x, y, spin] = narrow;
        let found = friction(pressure, [a, b], [x, y, spin]);
        raise(&mut single, eased(apart(&found, &exact)));
        count += 1;
    }
    assert_eq!(count, 552);
    assert!(double[0] < 1e-14 && double[1] < 2e-12, "{double:?}");
    assert!(single[0] < 1e-6 && single[1] < 1e-5, "{single:?}");
}

/// Motions about centres of rotation at all distances.
fn motions<R: Real>() -> impl Iterator<Item = [R; 3]> {
    (0..2_000_u32).map(|k| {
        let part = |of: u32| f64::from(k.wrapping_mul(of) >> 16) / 65536.0 - 0.5;
        let far = libm::exp(8.0 * part(2_654_435_761)) * libm::exp(8.0 * part(2_246_822_519));
        let angle = 6.3 * part(3_266_489_917);
        [
            far * libm::cos(angle),
            far * libm::sin(angle),
            part(668_265_263),
        ]
        .map(R::from_f64)
    })
}

fn is_round<R: Real>(pressure: EllipsePressure, round: impl DryReducedFriction<R>, bound: f64) {
    let radius = R::from_f64(0.04);
    let round = RoundFriction::new(round, R::ONE, radius).unwrap();
    let patch = Ellipse::new([R::ZERO; 2], [radius; 2], pressure).unwrap();
    let friction = ShapeFriction::new(patch, R::ONE).unwrap();
    for [x, y, rim] in motions() {
        let twist = Twist::new(x, y, rim / radius);
        let [a, b] = [
            friction.wrench(R::ONE, &twist),
            round.wrench(R::ONE, &twist),
        ];
        let torque = (a.torque - b.torque) / radius;
        let apart = [a.force.x - b.force.x, a.force.y - b.force.y, torque];
        let most = apart
            .map(|part| part.to_f64().abs())
            .into_iter()
            .fold(0.0, f64::max);
        assert!(most < bound, "{pressure:?} {twist:?}: {most}");
    }
}

#[test]
fn a_circle_is_the_round_patch() {
    is_round::<f64>(EllipsePressure::FlatPunch, CoulombPunch, 1e-14);
    is_round::<f64>(EllipsePressure::Uniform, CoulombDisk, 1e-14);
    is_round::<f64>(EllipsePressure::Hertz, CoulombHertz, 1e-14);
    is_round::<f64>(EllipsePressure::Paraboloid, CoulombParaboloid, 1e-14);
    is_round::<f32>(EllipsePressure::FlatPunch, CoulombPunch, 3e-6);
    is_round::<f32>(EllipsePressure::Uniform, CoulombDisk, 3e-6);
    is_round::<f32>(EllipsePressure::Hertz, CoulombHertz, 3e-6);
    is_round::<f32>(EllipsePressure::Paraboloid, CoulombParaboloid, 3e-6);
}

#[test]
fn spinning_in_place_takes_the_second_elliptic_integral() {
    // Mean of the radius: of Hertz 3/8 E (Johnson), uniform 4/(3π) E, punch E/2, paraboloid 16/(15π) E.
    let pi = core::f64::consts::PI;
    let arms = [0.5, 4.0 / (3.0 * pi), 0.375, 16.0 / (15.0 * pi)];
    for (pressure, arm) in ALL.into_iter().zip(arms) {
        for ratio in [1.0, 0.9, 0.5, 0.1, 0.01, 1e-3, 1e-6] {
            let e = CompleteElliptic::new(ratio * ratio).e();
            let [x, y, torque, ..] = friction(pressure, [1.0, ratio], [0.0, 0.0, 2.0]);
            assert!(
                x == 0.0 && y == 0.0 && (torque + arm * e).abs() < 2e-15,
                "{pressure:?} {ratio}"
            );
        }
    }
}

#[test]
fn a_thin_punch_is_a_bar() {
    // Loads of a punch are spread evenly along its major axis.
    let bar = ShapeFriction::new(Bar::new([-1.0, 0.0], [1.0, 0.0]).unwrap(), 1.0).unwrap();
    for [x, y, rim] in motions::<f64>() {
        let found = friction(EllipsePressure::FlatPunch, [1.0, 1e-6], [x, y, rim]);
        let Wrench { force, torque } = bar.wrench(1.0, &Twist::new(x, y, rim));
        let [off, _] = apart(&found, &[force.x, force.y, torque, 1.0]);
        assert!(off < 2e-6, "{x} {y} {rim}: {off}");
    }
}

#[test]
fn an_image_of_the_disk_is_moved_with_its_axes() {
    let (sin, cos) = (0.6, 0.8);
    let turned = |x: f64, y: f64| [cos * x - sin * y, sin * x + cos * y];
    for pressure in ALL {
        let moved = Ellipse::new(turned(0.3, -0.2), [1.0, 1.0], pressure).unwrap();
        let oblique = [turned(1.0, 0.0), turned(0.0, 0.25)];
        let moved = [
            Ellipse::with_half_diameters(turned(0.3, -0.2), oblique, pressure).unwrap(),
            moved
                .image(&AffineMap {
                    rows: [
                        Vector2::new(cos * cos + 0.25 * sin * sin, 0.75 * sin * cos),
                        Vector2::new(0.75 * sin * cos, 0.25 * cos * cos + sin * sin),
                    ],
                    shift: Vector2::zeros(),
                })
                .unwrap(),
        ];
        let place = moved[1].centre();
        let straight = Ellipse::new([0.0, 0.0], [1.0, 0.25], pressure).unwrap();
        let straight = ShapeFriction::new(straight, 1.0).unwrap();
        for [vx, vy, spin] in motions::<f64>().step_by(20) {
            let here = straight.wrench(1.0, &Twist::new(vx, vy, spin));
            for (patch, [px, py]) in moved.iter().zip([turned(0.3, -0.2), [place.x, place.y]]) {
                let friction = ShapeFriction::new(*patch, 1.0).unwrap();
                let [x, y] = turned(vx, vy);
                let found = friction.wrench(1.0, &Twist::new(x + spin * py, y - spin * px, spin));
                let [fx, fy] = turned(here.force.x, here.force.y);
                let torque = here.torque + px * fy - py * fx;
                let expected = [fx, fy, torque, 1.0];
                let found = [found.force.x, found.force.y, found.torque];
                let [off, _] = apart(&found, &expected);
                // The centre of rotation loses what the motion of the centre has more digits than that of the origin.
                assert!(off < 1e-11, "{pressure:?} {vx} {vy} {spin}: {off}");
            }
        }
    }
}

#[test]
fn slow_spins_have_torques_with_all_digits() {
    for pressure in ALL {
        let [.., damping] = friction(pressure, [1.0, 0.3], [0.6, 0.8, 0.0]);
        for spin in [1e-6, 1e-9, 1e-100] {
            let [_, _, torque, ..] = friction(pressure, [1.0, 0.3], [0.6, 0.8, spin]);
            assert!(
                (torque / spin + damping).abs() < 1e-11,
                "{pressure:?} {spin}"
            );
        }
    }
}

#[test]
fn what_is_no_ellipse_is_refused() {
    let [inf, nan] = [f64::INFINITY, f64::NAN];
    for given in [
        [0.0, 1.0],
        [1.0, -1.0],
        [inf, 1.0],
        [1.0, nan],
        [1.0, 1e-7],
        [nan, nan],
    ] {
        let made = Ellipse::new([0.0; 2], given, EllipsePressure::Hertz);
        assert!(
            matches!(made, Err(PatchError::SemiAxes { .. })),
            "{given:?}"
        );
    }
    let lined_up = [[1.0, 2.0], [-0.5, -1.0]];
    let made = Ellipse::with_half_diameters([0.0; 2], lined_up, EllipsePressure::Hertz);
    assert!(matches!(made, Err(PatchError::SemiAxes { .. })), "{made:?}");
    let made = Ellipse::new([0.0, nan], [1.0; 2], EllipsePressure::Hertz);
    assert_eq!(made, Err(PatchError::Centre));
}
