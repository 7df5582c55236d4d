//! Belts, treads and turntables against sums over points and against what is known in closed form.

extern crate std;

use super::{Feet, Foot, SteadyMotion, SteadyState};
use crate::contact::TimeStep;
use crate::coupling::coulomb::CoulombDisk;
use crate::coupling::flat::ShapeFriction;
use crate::patch::outline::{Edge, Polygon, UniformPressure};
use crate::patch::piece::HalfPlane;
use crate::patch::round::RoundPatch;
use crate::planar::PlanarBody;
use crate::twist::{Twist, Wrench};
use std::vec::Vec;

type Shape = Polygon<f64, [Edge<f64>; 16], UniformPressure>;

fn rectangle([x, y]: [f64; 2], [a, b]: [f64; 2]) -> Shape {
    let (a, b) = (0.5 * a, 0.5 * b);
    let corners = [
        [x - a, y - b],
        [x + a, y - b],
        [x + a, y + b],
        [x - a, y + b],
    ];
    Polygon::with_holes(&[&corners], [Edge::default(); 16]).unwrap()
}

/// The part of a patch between two parallel borders along x.
fn strip(patch: &Shape, [low, high]: [f64; 2]) -> Option<(Shape, f64)> {
    let above = HalfPlane::new([0.0, low], [1.0, 0.0]).unwrap();
    let below = HalfPlane::new([0.0, high], [-1.0, 0.0]).unwrap();
    let half = patch.within(&above, [Edge::default(); 16]).unwrap()?;
    let rest = half.patch.within(&below, [Edge::default(); 16]).unwrap()?;
    Some((rest.patch, half.share * rest.share))
}

fn size(wrench: &Wrench<f64>) -> f64 {
    wrench.force.norm().max(wrench.torque.abs())
}

fn balanced<P: crate::coupling::flat::PatchShape<f64>>(
    feet: &[Foot<f64, P>],
    push: Wrench<f64>,
) -> SteadyMotion<f64> {
    let limit: f64 = feet.iter().map(|foot| foot.limit).sum();
    match Feet::new(feet).unwrap().steady_motion(&push) {
        SteadyState::Balanced(motion) => {
            assert!(motion.evaluations <= 20, "{motion:?}");
            let left = size(&(motion.friction + push)) / limit;
            assert!(left < 1e-12, "{left:e} {motion:?}");
            motion
        }
        other => panic!("{other:?}"),
    }
}

/// Gauss's rule of 8 points on −1 to 1 (Abramowitz and Stegun 25.4).
const GAUSS: [[f64; 2]; 4] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_3],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_48],
    [0.960_289_856_497_536_2, 0.101_228_536_290_376_26],
];

/// Friction per pressure on what these corners bound, by triangles between the centre of rotation and each side: along
/// a ray everything is a power of the distance, and over the rays Gauss's rule is right on panels that are graded
/// towards the foot of the centre.
fn by_rays(corners: &[[f64; 2]], twist: &Twist<f64>) -> Wrench<f64> {
    let spin = twist.spin;
    let pole = [-twist.velocity.y / spin, twist.velocity.x / spin];
    let mut sum = Wrench::ZERO;
    for (index, from) in corners.iter().enumerate() {
        let to = corners[(index + 1) % corners.len()];
        let (a, b) = (
            [from[0] - pole[0], from[1] - pole[1]],
            [to[0] - pole[0], to[1] - pole[1]],
        );
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        let height = a[0] * along[1] - a[1] * along[0];
        let start = a[0] * along[0] + a[1] * along[1];
        // Ends of panels on both sides of the foot, each twice as far from it as the one before.
        let mut ends: Vec<f64> = [start, start + length].into();
        let mut far = 1e-17;
        while far < 10.0 {
            ends.extend(
                [-far, far]
                    .into_iter()
                    .filter(|t| (start..start + length).contains(t)),
            );
            far *= 1.5;
        }
        ends.sort_unstable_by(f64::total_cmp);
        for pair in ends.windows(2) {
            let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
            for [node, weight] in GAUSS {
                for t in [middle - half * node, middle + half * node] {
                    let (x, y) = (
                        along[0] * t + along[1] * height,
                        along[1] * t - along[0] * height,
                    );
                    let far = x.hypot(y);
                    if far == 0.0 {
                        continue;
                    }
                    let share = height * weight * half * spin.signum();
                    let (fx, fy) = (0.5 * share * y / far, -0.5 * share * x / far);
                    let turn = -share * far / 3.0;
                    sum += Wrench::new(fx, fy, turn + pole[0] * fy - pole[1] * fx);
                }
            }
        }
    }
    sum
}

#[test]
fn belts_have_the_friction_of_rays_wherever_the_centre_of_rotation_lies() {
    let (middle, sides) = ([0.05, 0.02], [0.6, 0.4]);
    let parcel = rectangle(middle, sides);
    let belts: [&[f64]; 2] = [&[-1.0, 0.03, 1.0], &[-1.0, -0.07, 0.11, 1.0]];
    let mut largest = 0.0_f64;
    for borders in belts {
        for seed in 0..200 {
            let mut next = numbers(seed);
            let count = borders.len() - 1;
            let surfaces: Vec<_> = (0..count)
                .map(|_| Twist::new(next(), next(), 0.0))
                .collect();
            let feet: Vec<_> = (0..count)
                .map(|i| {
                    let (patch, share) = strip(&parcel, [borders[i], borders[i + 1]]).unwrap();
                    let (limit, surface) = (6.0 * share, surfaces[i]);
                    Foot {
                        patch,
                        limit,
                        surface,
                    }
                })
                .collect();
            // The centre of the rotation over one belt lies in the patch, on a border, at a corner, or anywhere.
            let spin = surfaces[0].spin + if next() > 0.0 { 1.3 } else { -0.8 };
            let pole = match seed % 5 {
                0 => [middle[0] + 0.3 * next(), middle[1] + 0.2 * next()],
                1 => [middle[0] + 0.3 * next(), borders[1]],
                2 => [middle[0] + 0.3, middle[1] + 0.2],
                3 => [middle[0] + 0.3 * next(), borders[1] + 1e-9],
                _ => [3.0 * next(), 3.0 * next()],
            };
            let turn = spin - surfaces[0].spin;
            let twist = surfaces[0] + Twist::new(turn * pole[1], -turn * pole[0], turn);
            let mut sum = Wrench::ZERO;
            for (i, surface) in surfaces.iter().enumerate() {
                let (left, right) = (middle[0] - 0.5 * sides[0], middle[0] + 0.5 * sides[0]);
                let low = borders[i].max(middle[1] - 0.5 * sides[1]);
                let high = borders[i + 1].min(middle[1] + 0.5 * sides[1]);
                let corners = [[left, low], [right, low], [right, high], [left, high]];
                let pressure = 6.0 / (sides[0] * sides[1]);
                sum += by_rays(&corners, &(twist - *surface)) * pressure;
            }
            let off = size(&(Feet::new(&feet).unwrap().wrench(&twist) - sum)) / 6.0;
            largest = largest.max(off);
        }
    }
    assert!(largest < 1e-13, "{largest:e}");
}

#[test]
fn pieces_together_are_the_whole() {
    let ell = [
        [0.0, 0.0],
        [0.4, 0.0],
        [0.4, 0.1],
        [0.1, 0.1],
        [0.1, 0.3],
        [0.0, 0.3],
    ];
    let hole = [[0.02, 0.02], [0.06, 0.02], [0.06, 0.06], [0.02, 0.06]];
    let memory = || [Edge::default(); 32];
    let whole = Polygon::with_holes(&[&ell, &hole], memory()).unwrap();
    let leaning = whole.with_slope([0.8, -1.1]).unwrap();
    let whole_friction = ShapeFriction::new(whole, 1.0).unwrap();
    let lean_friction = ShapeFriction::new(leaning, 1.0).unwrap();
    let mut state = 1_u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    for case in 0..2000 {
        // Borders anywhere, at times through corners and along edges.
        let point = match case % 4 {
            0 => ell[case % 6],
            _ => [0.4 * next(), 0.3 * next()],
        };
        let direction = match case % 3 {
            0 => [[1.0, 0.0], [0.0, 1.0], [-1.0, 1.0]][case % 9 / 3],
            _ => [next() - 0.5, next() - 0.5],
        };
        let border = HalfPlane::new(point, direction).unwrap();
        let twist = Twist::new(next() - 0.5, next() - 0.5, 6.0 * next() - 3.0);
        let (mut sum, mut lean, mut shares) = (Wrench::ZERO, Wrench::ZERO, [0.0; 2]);
        for side in [border, border.other_side()] {
            if let Some(piece) = whole.within(&side, memory()).unwrap() {
                let friction = ShapeFriction::new(piece.patch, 1.0).unwrap();
                sum += friction.wrench(piece.share, &twist);
                shares[0] += piece.share;
            }
            if let Some(piece) = leaning.within(&side, memory()).unwrap() {
                let friction = ShapeFriction::new(piece.patch, 1.0).unwrap();
                lean += friction.wrench(piece.share, &twist);
                shares[1] += piece.share;
            }
        }
        let off = size(&(sum - whole_friction.wrench(1.0, &twist)));
        let lean_off = size(&(lean - lean_friction.wrench(1.0, &twist)));
        assert!((shares[0] - 1.0).abs() < 1e-14 && (shares[1] - 1.0).abs() < 1e-14);
        assert!(
            off < 5e-14 && lean_off < 5e-14,
            "{case} {off:e} {lean_off:e}"
        );
    }
}

#[test]
fn a_box_on_two_belts_turns_and_may_be_held() {
    let parcel = rectangle([0.0, 0.0], [0.3, 0.2]);
    let halves = [[0.0, 1.0], [-1.0, 0.0]].map(|ends| strip(&parcel, ends).unwrap());
    let on = |speeds: [f64; 2]| {
        [0, 1].map(|i| Foot {
            patch: halves[i].0,
            limit: 8.0 * halves[i].1,
            surface: Twist::new(speeds[i], 0.0, 0.0),
        })
    };
    let turning = balanced(&on([0.5, -0.5]), Wrench::ZERO);
    assert!(turning.carried_by.is_none() && turning.twist.velocity.norm() < 1e-12);
    assert!(turning.twist.spin < -1.0);
    // A push of more than both belts carry.
    let none = Wrench::new(8.1, 0.0, 0.0);
    let state = Feet::new(&on([0.5, -0.5])).unwrap().steady_motion(&none);
    assert_eq!(state, SteadyState::Accelerates);
    // Both belts with one speed carry it along.
    let along = balanced(&on([0.5, 0.5]), Wrench::new(1.0, 2.0, 0.1));
    assert_eq!(
        (along.carried_by, along.twist),
        (Some(0), Twist::new(0.5, 0.0, 0.0))
    );
}

#[test]
fn most_of_a_box_on_one_belt_takes_it_along() {
    let parcel = rectangle([0.0, 0.0], [0.3, 0.2]);
    // The belt at rest ends 2 cm before the edge, the other one runs.
    let parts = [[-1.0, 0.08], [0.08, 1.0]].map(|ends| strip(&parcel, ends).unwrap());
    let feet = [0, 1].map(|i| Foot {
        patch: parts[i].0,
        limit: 8.0 * parts[i].1,
        surface: Twist::new([0.0, 1.0][i], 0.0, 0.0),
    });
    let held = balanced(&feet, Wrench::ZERO);
    assert_eq!((held.carried_by, held.twist), (Some(0), Twist::ZERO));
}

#[test]
fn robots_on_wheels_and_tracks_find_what_they_turn_about() {
    let wheel = |x: f64, y: f64| RoundPatch::new(CoulombDisk, [x, y], 0.01).unwrap();
    let track = |y: f64| rectangle([0.05, y], [0.6, 0.1]);
    for [left, right] in [
        [0.2, -0.2],
        [0.2, 0.1],
        [0.3, 0.0],
        [0.5, 0.49],
        [1.0, -0.9],
    ] {
        for load in [0.0, 5.0, 20.0] {
            let surface = |speed: f64| Twist::new(speed, 0.0, 0.0);
            let tracks = [(0.25, left), (-0.25, right)].map(|(y, speed)| Foot {
                patch: track(y),
                limit: 60.0,
                surface: surface(speed),
            });
            balanced(&tracks, Wrench::new(load, 0.5 * load, 0.1 * load));
            let wheels = [
                (0.2, 0.25, left),
                (-0.2, 0.25, left),
                (0.2, -0.25, right),
                (-0.15, -0.25, right),
            ];
            let wheels = wheels.map(|(x, y, speed)| Foot {
                patch: wheel(x, y),
                limit: 30.0,
                surface: surface(speed),
            });
            balanced(&wheels, Wrench::new(load, 0.5 * load, 0.1 * load));
        }
    }
}

#[test]
fn a_ring_of_pads_on_a_turntable_goes_round_with_it() {
    let pad = |x: f64, y: f64| rectangle([x, y], [0.05, 0.05]);
    let table = Twist::new(0.1, -0.2, 3.0);
    let feet = [(0.2, 0.0), (-0.2, 0.1), (0.0, 0.3)].map(|(x, y)| Foot {
        patch: pad(x, y),
        limit: 4.0,
        surface: table,
    });
    let along = balanced(&feet, Wrench::new(1.0, -2.0, 0.2));
    assert_eq!(along.twist, table);
}

#[test]
fn the_jacobian_is_the_slope_of_the_wrench() {
    let feet = [(0.3, 0.2, 0.5), (-0.2, 0.1, -0.4)].map(|(x, y, speed)| Foot {
        patch: rectangle([x, y], [0.1, 0.2]),
        limit: 5.0,
        surface: Twist::new(speed, 0.1, speed),
    });
    let feet = Feet::new(&feet).unwrap();
    for twist in [[0.1, 0.2, 0.3], [-1.0, 0.4, 2.0]] {
        let twist = Twist::new(twist[0], twist[1], twist[2]);
        let (wrench, jacobian) = feet.wrench_and_jacobian(&twist);
        assert!(size(&(wrench - feet.wrench(&twist))) < 1e-14);
        for column in 0..3 {
            let mut step = [0.0; 3];
            step[column] = 1e-5;
            let step = Twist::new(step[0], step[1], step[2]);
            let slope =
                (feet.wrench(&(twist + step)) - feet.wrench(&(twist - step))) * (0.5 / 1e-5);
            let found = jacobian.column(column);
            let off = size(&(slope - Wrench::new(found[0], found[1], found[2])));
            assert!(off < 1e-7, "{off:e}");
        }
    }
}

#[test]
fn steps_lead_to_the_steady_motion_and_stay_there() {
    let parcel = rectangle([0.0, 0.0], [0.3, 0.2]);
    let halves = [[0.02, 1.0], [-1.0, 0.02]].map(|ends| strip(&parcel, ends).unwrap());
    let feet = [0, 1].map(|i| Foot {
        patch: halves[i].0,
        limit: 8.0 * halves[i].1,
        surface: Twist::new([0.5, -0.4][i], 0.0, 0.0),
    });
    let push = Wrench::new(0.3, -0.2, 0.05);
    let steady = balanced(&feet, push);
    let (feet, body) = (
        Feet::new(&feet).unwrap(),
        PlanarBody::new(2.0, 0.02).unwrap(),
    );
    let mut twist = Twist::new(1.0, 0.3, 5.0);
    let dt = TimeStep::new(0.02).unwrap();
    for _ in 0..4000 {
        let step = feet.step(&body, &twist, &push, dt);
        assert!(step.imbalance < 1e-13, "{step:?}");
        twist = step.twist;
    }
    let off = twist - steady.twist;
    assert!(off.velocity.norm() + off.spin.abs() < 1e-10, "{off:?}");
}

#[test]
fn steps_are_of_second_order_while_all_feet_slide() {
    let feet = [(0.3, 0.2, 0.5), (-0.2, 0.1, -0.4)].map(|(x, y, speed)| Foot {
        patch: rectangle([x, y], [0.1, 0.2]),
        limit: 5.0,
        surface: Twist::new(speed, 0.1, speed),
    });
    let (feet, body) = (
        Feet::new(&feet).unwrap(),
        PlanarBody::new(2.0, 0.2).unwrap(),
    );
    let end = |count: u32| {
        let dt = TimeStep::new(0.2 / f64::from(count)).unwrap();
        let mut twist = Twist::new(3.0, 1.0, 6.0);
        for _ in 0..count {
            twist = feet.step(&body, &twist, &Wrench::ZERO, dt).twist;
        }
        twist
    };
    let exact = end(512);
    let off = |count| (end(count) - exact).velocity.norm();
    assert!(
        (3.7..4.4).contains(&(off(8) / off(16))),
        "{} {}",
        off(8),
        off(16)
    );
}

/// Numbers from −1 to 1 from a seed.
fn numbers(seed: u32) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 23) - 1.0
    }
}

#[test]
fn feet_anywhere_are_balanced_or_gain_speed() {
    let (mut most, mut rest, mut faster) = (Vec::new(), 0, 0);
    for seed in 0..4000 {
        let mut next = numbers(seed);
        let count = 2 + seed as usize % 4;
        let feet: Vec<_> = (0..count)
            .map(|_| Foot {
                patch: rectangle([next(), next()], [0.5 + 0.49 * next(), 0.1 + 0.09 * next()]),
                limit: 1.0 + next(),
                surface: Twist::new(next(), next(), 2.0 * next()),
            })
            .collect();
        let limit: f64 = feet.iter().map(|foot| foot.limit).sum();
        let size = libm::pow(10.0, 2.0 * next() - 2.0) * limit;
        let push = Wrench::new(next() * size, next() * size, next() * size);
        let feet = Feet::new(&feet).unwrap();
        match feet.steady_motion(&push) {
            SteadyState::Balanced(motion) => {
                if motion.carried_by.is_none() {
                    // Next to the motion of a surface the sliding over it is lost in rounding.
                    let near = feet.feet().iter().fold(1.0_f64, |near, foot| {
                        let slides = motion.twist - foot.surface;
                        near.min(slides.velocity.norm() + slides.spin.abs())
                    });
                    let left = (motion.friction + push).force.norm() / limit;
                    assert!(left < 1e-12 + 1e-15 / near, "{seed} {left:e} {near:e}");
                } else {
                    rest += 1;
                }
                most.push(motion.evaluations);
            }
            SteadyState::Accelerates => faster += 1,
            SteadyState::Missed(motion) => panic!("{seed} {motion:?}"),
        }
    }
    most.sort_unstable();
    // Of them half within 12 evaluations.
    assert!(
        most[most.len() / 2] <= 12 && most[most.len() - 1] <= 30,
        "{most:?}"
    );
    assert!(rest > 300 && faster > 100, "{rest} {faster}");
}

#[test]
fn single_precision_is_balanced_to_its_rounding() {
    for seed in 0..500 {
        let mut next = numbers(seed);
        let mut next = || next() as f32;
        let feet: Vec<_> = (0..3)
            .map(|_| {
                let (x, y, a) = (next(), next(), 0.3 + 0.2 * next());
                let corners = [[x, y], [x + a, y], [x + a, y + 0.2], [x, y + 0.2]];
                let surface = Twist::new(next(), next(), 2.0 * next());
                Foot {
                    patch: Polygon::new(corners).unwrap(),
                    limit: 1.1 + next(),
                    surface,
                }
            })
            .collect();
        let push = Wrench::new(0.1 * next(), 0.1 * next(), 0.05 * next());
        let state = Feet::new(&feet).unwrap().steady_motion(&push);
        let SteadyState::Balanced(motion) = state else {
            panic!("{seed} {state:?}")
        };
        let near = feet.iter().fold(1.0_f32, |near, foot| {
            let slides = motion.twist - foot.surface;
            near.min(slides.velocity.norm() + slides.spin.abs())
        });
        let left = (motion.friction + push).force.norm();
        let within = 5e-5 + 4e-6 / near;
        assert!(
            motion.carried_by.is_some() || left < within,
            "{seed} {left:e} {near:e}"
        );
    }
}
