//! Rows that the functions are compared on, and the comparison.
//!
//! Sizes are spread over octaves, motions over the cases that a closed form may treat apart. One row in eight has numbers
//! that nobody means: no numbers, infinities, zeros of both signs, subnormal numbers, the ends of the range.

use tribos_core::Real;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
use tribos_core::twist::Twist;

/// A source of numbers in a precision with exponents within ±`reach`. The same on every machine: splitmix64.
pub(crate) struct Random {
    state: u64,
    reach: u64,
}

impl Random {
    pub(crate) fn new<R: Drawn>(seed: u64) -> Self {
        let reach = R::REACH;
        Self { state: seed, reach }
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, end: u64) -> u64 {
        (self.next() >> 32) % end
    }

    fn one_in(&mut self, count: u64) -> bool {
        self.below(count) == 0
    }

    /// Between −1 and 1.
    fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// 2ᵏ with |k| ≤ `octaves`.
    fn power(&mut self, octaves: u64) -> f64 {
        let octave = 1023 - octaves + self.below(2 * octaves + 1);
        f64::from_bits(octave << 52)
    }

    /// `size` times a number within a factor of 2 to the power `octaves`; every fourth a power of two times it.
    fn sized(&mut self, size: f64, octaves: u64) -> f64 {
        let mantissa = if self.one_in(4) { 1.0 } else { 1.0 + self.signed().abs() };
        size * self.power(octaves) * mantissa
    }

    /// Velocity and spin, of 1 and 1/`lever`, or a force and a torque, if `lever` is the inverse of their lever.
    fn motion(&mut self, lever: f64) -> [f64; 3] {
        let [x, y, turn] = [(); 3].map(|()| self.signed());
        let speed = x.hypot(y);
        match self.below(16) {
            0 => [0.0; 3],
            1 => [0.0, 0.0, turn / lever],
            2 => [x, y, 0.0],
            3 => [x, 0.0, x / lever],
            4 => [x, y, speed / lever],
            5 => {
                let apart = 1.0 + turn * self.power(40).min(1.0);
                [x, y, apart * speed / lever]
            }
            6 => {
                let scale = self.power(self.reach);
                [x * scale, y * scale, turn * scale / lever]
            }
            _ => {
                let scale = self.power(20);
                [x * scale, y * scale, turn / lever * self.power(20)]
            }
        }
    }

    /// Corners of a rectangle that is shifted, bent and turned over, or of anything.
    fn corners(&mut self) -> [[f64; 2]; 4] {
        let [a, b] = [(); 2].map(|()| self.sized(0.1, 3));
        let rectangle = [[-a, -b], [a, -b], [a, b], [-a, b]];
        let centre = if self.one_in(2) { [0.0; 2] } else { [(); 2].map(|()| self.signed()) };
        let (bends, is_anything) = (self.one_in(2), self.one_in(32));
        let mut corners = rectangle.map(|corner| {
            let bend = [(); 2].map(|()| if bends { 0.3 * self.signed() } else { 0.0 });
            let own = [0, 1].map(|axis| centre[axis] + corner[axis] * (1.0 + bend[axis]));
            if is_anything { [(); 2].map(|()| self.signed()) } else { own }
        });
        if self.one_in(2) {
            corners.reverse();
        }
        corners
    }

    /// Motion of a polygon: about a corner, the middle of an edge, a place near it or far away, or any.
    fn motion_of(&mut self, corners: &[[f64; 2]; 4]) -> [f64; 3] {
        let [[ax, ay], [bx, by]] = [corners[0], corners[1]];
        let [x, y] = match self.below(6) {
            0 => corners[0],
            1 => [0.5 * (ax + bx), 0.5 * (ay + by)],
            2 => [(); 2].map(|()| 0.2 * self.signed()),
            3 => [(); 2].map(|()| self.signed() * self.power(30)),
            _ => return self.motion(0.1),
        };
        let spin = self.signed() * self.power(20);
        [spin * y, -spin * x, spin]
    }
}

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
    let [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = corners;
    [coefficient, load, x, y, spin, ax, ay, bx, by, cx, cy, dx, dy]
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

/// Force limit, radius, mass, moment of inertia, time step, twist, push. Many bodies stop or start in the step.
pub(crate) fn step(random: &mut Random) -> [f64; 11] {
    let (limit, radius, mass) = (random.sized(5.0, 6), random.sized(1.0, 8), random.sized(1.0, 6));
    let inertia = random.sized(0.5 * mass * radius * radius, 3);
    let dt = random.sized(0.002, 6);
    let change = if random.one_in(2) { random.sized(limit * dt / mass, 3) } else { 1.0 };
    let [x, y, spin] = random.motion(radius).map(|part| change * part);
    let size = if random.one_in(2) { 0.0 } else { random.sized(limit, 2) };
    let [push_x, push_y, push_torque] = random.motion(1.0 / radius).map(|part| size * part);
    [limit, radius, mass, inertia, dt, x, y, spin, push_x, push_y, push_torque]
}

/// Candidate, limit, mean lever, dynamic over static, inverse masses.
pub(crate) fn manifold(random: &mut Random) -> [f64; 8] {
    let (impulse, lever, k) = (random.sized(0.1, 8), random.sized(0.1, 6), random.sized(1.0, 6));
    let size = random.sized(impulse, 4);
    let [x, y, angular] = random.motion(1.0 / lever).map(|part| size * part);
    let ratio = if random.one_in(2) { 1.0 } else { random.signed().abs() };
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
    let [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = corners;
    [x, y, angular, impulse, ratio, k, kt, ax, ay, bx, by, cx, cy, dx, dy]
}

/// A precision with the numbers that nobody means.
pub(crate) trait Drawn: Real {
    const REACH: u64;
    const ODD: [Self; 12];
    /// The same bits, or both no numbers: processors fill these differently.
    fn is_same(self, other: Self) -> bool;
}

macro_rules! drawn {
    ($real:ident, $reach:literal) => {
        impl Drawn for $real {
            const REACH: u64 = $reach;
            const ODD: [Self; 12] = [
                $real::NAN, $real::INFINITY, -$real::INFINITY, 0.0, -0.0, 1.0,
                $real::from_bits(1), -$real::from_bits(12345), $real::MIN_POSITIVE / 2.0,
                $real::MIN_POSITIVE, $real::MAX, -$real::MAX,
            ];
            fn is_same(self, other: Self) -> bool {
                self.to_bits() == other.to_bits() || self.is_nan() && other.is_nan()
            }
        }
    };
}
drawn!(f32, 125);
drawn!(f64, 1020);

/// Fills a table with rows, in which one or two numbers may become odd.
pub(crate) fn fill<R: Drawn, const IN: usize>(
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
pub(crate) fn differing<R: Drawn>(one: &[R], other: &[R], width: usize) -> u64 {
    let rows = one.chunks_exact(width).zip(other.chunks_exact(width));
    rows.filter(|(a, b)| !a.iter().zip(*b).all(|(a, b)| a.is_same(*b))).count() as u64
}
