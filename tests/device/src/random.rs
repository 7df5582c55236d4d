//! Random numbers, motions and shapes, the same on every machine.

use tribos_core::Real;

/// A precision with the numbers that nobody means.
pub(crate) trait RandomReal: Real {
    const REACH: u64;
    const ODD: [Self; 12];
    /// The same bits, or both no numbers: processors fill these differently.
    fn is_same(self, other: Self) -> bool;
}

macro_rules! drawn {
    ($real:ident, $reach:literal) => {
        impl RandomReal for $real {
            const REACH: u64 = $reach;
            const ODD: [Self; 12] = [
                $real::NAN,
                $real::INFINITY,
                -$real::INFINITY,
                0.0,
                -0.0,
                1.0,
                $real::from_bits(1),
                -$real::from_bits(12345),
                $real::MIN_POSITIVE / 2.0,
                $real::MIN_POSITIVE,
                $real::MAX,
                -$real::MAX,
            ];
            fn is_same(self, other: Self) -> bool {
                self.to_bits() == other.to_bits() || self.is_nan() && other.is_nan()
            }
        }
    };
}
drawn!(f32, 125);
drawn!(f64, 1020);

/// A source of numbers in a precision with exponents within ±`reach`. The same on every machine: splitmix64.
pub(crate) struct Random {
    state: u64,
    reach: u64,
}

impl Random {
    pub(crate) fn new<R: RandomReal>(seed: u64) -> Self {
        let reach = R::REACH;
        Self { state: seed, reach }
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    pub(crate) fn below(&mut self, end: u64) -> u64 {
        (self.next() >> 32) % end
    }

    pub(crate) fn one_in(&mut self, count: u64) -> bool {
        self.below(count) == 0
    }

    /// Between −1 and 1.
    pub(crate) fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// 2ᵏ with |k| ≤ `octaves`.
    pub(crate) fn power(&mut self, octaves: u64) -> f64 {
        let octave = 1023 - octaves + self.below(2 * octaves + 1);
        f64::from_bits(octave << 52)
    }

    /// `size` times a number within a factor of 2 to the power `octaves`; every fourth a power of two times it.
    pub(crate) fn sized(&mut self, size: f64, octaves: u64) -> f64 {
        let mantissa = if self.one_in(4) {
            1.0
        } else {
            1.0 + self.signed().abs()
        };
        size * self.power(octaves) * mantissa
    }

    /// Velocity and spin, of 1 and 1/`lever`, or a force and a torque, if `lever` is the inverse of their lever.
    pub(crate) fn motion(&mut self, lever: f64) -> [f64; 3] {
        let [x, y, turn] = [(); 3].map(|()| self.signed());
        let speed = (x * x + y * y).sqrt();
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
    pub(crate) fn corners(&mut self) -> [[f64; 2]; 4] {
        let [a, b] = [(); 2].map(|()| self.sized(0.1, 3));
        let rectangle = [[-a, -b], [a, -b], [a, b], [-a, b]];
        let centre = if self.one_in(2) {
            [0.0; 2]
        } else {
            [(); 2].map(|()| self.signed())
        };
        let (bends, is_anything) = (self.one_in(2), self.one_in(32));
        let mut corners = rectangle.map(|corner| {
            let bend = [(); 2].map(|()| if bends { 0.3 * self.signed() } else { 0.0 });
            let own = [0, 1].map(|axis| centre[axis] + corner[axis] * (1.0 + bend[axis]));
            if is_anything {
                [(); 2].map(|()| self.signed())
            } else {
                own
            }
        });
        if self.one_in(2) {
            corners.reverse();
        }
        corners
    }

    /// Motion of a polygon: about a corner, the middle of an edge, a place near it or far away, or any.
    pub(crate) fn motion_of(&mut self, corners: &[[f64; 2]; 4]) -> [f64; 3] {
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
