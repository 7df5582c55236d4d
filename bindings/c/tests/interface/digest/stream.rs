//! The stream of inputs, and the hash of the results.

use nalgebra::Vector3;
use tribos_core::coupling::ReducedFriction;
use tribos_core::coupling::table::{DiskTable32, DiskTable64};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Distribution of the numbers of a draw, as in C.
#[derive(Clone, Copy, PartialEq)]
pub enum Range {
    Wide,
    Mild,
    Fit,
    Sure,
}

/// What the two precisions do not share by [`Real`].
pub trait Precision: Real {
    const MAX: Self;
    type PowerTable: ReducedFriction<Self>;
    /// A table of the power law, if one exists for the exponent.
    fn table(alpha: Self) -> Option<Self::PowerTable>;
}

impl Precision for f64 {
    const MAX: Self = f64::MAX;
    type PowerTable = DiskTable64;
    fn table(alpha: Self) -> Option<DiskTable64> {
        DiskTable64::new(alpha).ok()
    }
}

impl Precision for f32 {
    const MAX: Self = f32::MAX;
    type PowerTable = DiskTable32;
    fn table(alpha: Self) -> Option<DiskTable32> {
        DiskTable32::new(alpha).ok()
    }
}

/// State of the random draws and of the hash.
pub struct Stream {
    state: u64,
    hash: u64,
}

impl Stream {
    pub fn new() -> Self {
        Self {
            state: 1,
            hash: 0xcbf2_9ce4_8422_2325,
        }
    }

    pub fn hash(&self) -> u64 {
        self.hash
    }

    pub fn bits(&mut self) -> u64 {
        self.state = self
            .state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.state ^ (self.state >> 33)
    }

    pub fn draw<R: Precision>(&mut self, range: Range) -> R {
        let edges = [
            R::ZERO,
            -R::ZERO,
            R::MIN_POSITIVE * R::EPSILON,
            -R::MIN_POSITIVE * R::EPSILON,
            R::MIN_POSITIVE,
            R::MAX,
            -R::MAX,
            R::INFINITY,
            -R::INFINITY,
            R::NAN,
            R::ONE,
        ];
        let bits = self.bits();
        let odd = (bits & 63) as usize;
        let unit = (bits >> 40) as f64 / 16_777_216.0;
        if range == Range::Wide && odd < 11 {
            return edges[odd];
        }
        if (range == Range::Mild || range == Range::Fit) && odd == 0 {
            return edges[((bits >> 6) % 11) as usize];
        }
        let x = match range {
            Range::Wide => unit * (1_u64 << ((bits >> 6) & 31)) as f64 / 65_536.0,
            _ => 2.0 * unit,
        };
        R::from_f64(match range {
            Range::Fit | Range::Sure => x.max(1.0 / 1024.0),
            _ if (bits >> 11) & 1 == 1 => -x,
            _ => x,
        })
    }

    pub fn draws<R: Precision, const N: usize>(&mut self, range: Range) -> [R; N] {
        [(); N].map(|()| self.draw(range))
    }

    pub fn vector<R: Precision>(&mut self, range: Range) -> Vector3<R> {
        self.draws::<R, 3>(range).into()
    }

    pub fn twist<R: Precision>(&mut self, range: Range) -> Twist<R> {
        self.vector(range).into()
    }

    pub fn wrench<R: Precision>(&mut self, range: Range) -> Wrench<R> {
        let [x, y, torque] = self.draws(range);
        let mut wrench = Wrench::ZERO;
        (wrench.force.x, wrench.force.y, wrench.torque) = (x, y, torque);
        wrench
    }

    pub fn feed_bits(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }

    pub fn number<R: Real>(&mut self, x: R) {
        let wide = x.to_f64();
        self.feed_bits(if wide.is_nan() {
            0x7ff8_0000_0000_0000
        } else {
            wide.to_bits()
        });
    }

    pub fn numbers<R: Real>(&mut self, all: impl IntoIterator<Item = R>) {
        for x in all {
            self.number(x);
        }
    }

    /// Hashes whether there is a result, and returns the result.
    pub fn ok<T, E>(&mut self, answer: Result<T, E>) -> Option<T> {
        self.feed_bits(answer.is_ok().into());
        answer.ok()
    }

    pub fn result<R: Real, E>(&mut self, answer: Result<R, E>) {
        if let Some(x) = self.ok(answer) {
            self.number(x);
        }
    }

    pub fn wrench_of<R: Real, E>(&mut self, answer: Result<Wrench<R>, E>) {
        if let Some(w) = self.ok(answer) {
            self.numbers([w.force.x, w.force.y, w.torque]);
        }
    }

    pub fn twist_of<R: Real, E>(&mut self, answer: Result<Twist<R>, E>) {
        if let Some(t) = self.ok(answer) {
            self.numbers([t.velocity.x, t.velocity.y, t.spin]);
        }
    }

    pub fn twist_and_friction<R: Real>(&mut self, twist: &Twist<R>, friction: &Wrench<R>) {
        self.numbers([twist.velocity.x, twist.velocity.y, twist.spin]);
        self.numbers([friction.force.x, friction.force.y, friction.torque]);
    }

    /// Hashes the matrix row by row.
    pub fn jacobian_of<R: Real, E>(&mut self, answer: Result<WrenchJacobian<R>, E>) {
        if let Some(j) = self.ok(answer) {
            for row in 0..3 {
                self.numbers([j[(row, 0)], j[(row, 1)], j[(row, 2)]]);
            }
        }
    }
}
