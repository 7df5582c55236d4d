//! Rows that the functions are compared on, and the comparison.
//!
//! Sizes are spread over octaves, motions over the cases that a closed form may treat apart. One row in eight has numbers
//! that nobody means: no numbers, infinities, zeros of both signs, subnormal numbers, the ends of the range.

use crate::random::{Random, RandomReal};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::twist::Twist;

/// Coefficient, radius, load, twist.
pub(crate) fn round(random: &mut Random) -> [f64; 6] {
    let (coefficient, load) = (random.sized(0.5, 4), random.sized(10.0, 12));
    let radius = random.sized(1.0, 8);
    let [x, y, spin] = random.motion(radius);
    [coefficient, radius, load, x, y, spin]
}

/// Coefficient, load, twist, corners.
pub(crate) fn polygon(random: &mut Random) -> [f64; 13] {
    let (coefficient, load) = (random.sized(0.5, 4), random.sized(10.0, 12));
    let corners = random.corners();
    let [x, y, spin] = random.motion_of(&corners);
    joined([&[coefficient, load, x, y, spin], corners.as_flattened()])
}

/// Force limit, radius, length of the metric, wrench: some are on the surface, as far as rounding lets them.
pub(crate) fn projection(random: &mut Random) -> [f64; 6] {
    let (limit, radius) = (random.sized(5.0, 12), random.sized(1.0, 8));
    let length = random.sized(radius, 4);
    let wanted = if random.one_in(8) {
        let [x, y, spin] = random.motion(radius);
        RoundLimitSurface::new(CoulombDisk, limit, radius).map_or([0.0; 3], |set| {
            let surface = set.wrench(&Twist::new(x, y, spin));
            [surface.force.x, surface.force.y, surface.torque]
        })
    } else {
        let size = random.sized(limit, 4);
        random.motion(1.0 / radius).map(|part| size * part)
    };
    let [x, y, torque] = wanted;
    [limit, radius, length, x, y, torque]
}

/// Force limit, length of the metric, wrench, corners.
pub(crate) fn polygon_projection(random: &mut Random) -> [f64; 13] {
    let (limit, length) = (random.sized(5.0, 12), random.sized(0.1, 6));
    let (corners, size) = (random.corners(), random.sized(limit, 4));
    let [x, y, torque] = random.motion(10.0).map(|part| size * part);
    joined([&[limit, length, x, y, torque], corners.as_flattened()])
}

/// Force limit, radius, mass, moment of inertia, time step, twist, push. Many bodies stop or start in the step.
pub(crate) fn step(random: &mut Random) -> [f64; 11] {
    let (limit, radius, mass) = (
        random.sized(5.0, 6),
        random.sized(1.0, 8),
        random.sized(1.0, 6),
    );
    let inertia = random.sized(0.5 * mass * radius * radius, 3);
    let dt = random.sized(0.002, 6);
    let change = if random.one_in(2) {
        random.sized(limit * dt / mass, 3)
    } else {
        1.0
    };
    let [x, y, spin] = random.motion(radius).map(|part| change * part);
    let size = if random.one_in(2) {
        0.0
    } else {
        random.sized(limit, 2)
    };
    let [push_x, push_y, push_torque] = random.motion(1.0 / radius).map(|part| size * part);
    let motion = [x, y, spin, push_x, push_y, push_torque];
    joined([&[limit, radius, mass, inertia, dt], &motion])
}

/// Candidate, limit, mean lever, dynamic over static, inverse masses.
pub(crate) fn manifold(random: &mut Random) -> [f64; 8] {
    let (impulse, lever, k) = (
        random.sized(0.1, 8),
        random.sized(0.1, 6),
        random.sized(1.0, 6),
    );
    let size = random.sized(impulse, 4);
    let [x, y, angular] = random.motion(1.0 / lever).map(|part| size * part);
    let ratio = if random.one_in(2) {
        1.0
    } else {
        random.signed().abs()
    };
    let kt = random.sized(k / (lever * lever), 7);
    [x, y, angular, impulse, lever, ratio, k, kt]
}

/// Candidate, limit, dynamic over static, inverse masses, corners, some of which are on a line.
pub(crate) fn plank(random: &mut Random) -> [f64; 15] {
    let [x, y, angular, impulse, _, ratio, k, kt] = manifold(random);
    let mut corners = random.corners();
    if random.one_in(16) {
        corners = corners.map(|[x, _]| [x, 0.5 * x]);
    }
    let body = [x, y, angular, impulse, ratio, k, kt];
    joined([&body, corners.as_flattened()])
}

/// A row of two parts.
fn joined<const IN: usize>(parts: [&[f64]; 2]) -> [f64; IN] {
    let mut numbers = parts.into_iter().flatten();
    std::array::from_fn(|_| *numbers.next().expect("as many as the row has"))
}

/// Fills a table with rows, in which one or two numbers may become odd.
pub(crate) fn fill<R: RandomReal, const IN: usize>(
    seed: u64,
    inputs: &mut [R],
    draw: fn(&mut Random) -> [f64; IN],
) {
    let random = &mut Random::new::<R>(seed);
    for row in inputs.chunks_exact_mut(IN) {
        row.copy_from_slice(&draw(random).map(R::from_f64));
        if random.one_in(8) {
            for _ in 0..1 + random.below(2) {
                let (place, odd) = (random.below(IN as u64), random.below(R::ODD.len() as u64));
                row[place as usize] = R::ODD[odd as usize];
            }
        }
    }
}

/// Numbers that a function reads and writes.
pub(crate) fn widths<R, const IN: usize, const OUT: usize>(_: fn([R; IN]) -> [R; OUT]) -> [u64; 2] {
    [IN as u64, OUT as u64]
}

/// The number of rows of `width` numbers that are not the same.
pub(crate) fn differing<R: RandomReal>(one: &[R], other: &[R], width: usize) -> u64 {
    let rows = one.chunks_exact(width).zip(other.chunks_exact(width));
    rows.filter(|(a, b)| !a.iter().zip(*b).all(|(a, b)| a.is_same(*b)))
        .count() as u64
}
