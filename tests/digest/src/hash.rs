//! The hash of results.

use tribos_core::coupling::{ReducedJacobian, ReducedWrench};
use tribos_core::internals::LateralJacobian;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// 64-bit Fowler–Noll–Vo hash, version 1a.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fnv(pub u64);

const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const FNV_PRIME: u64 = 0x0000_0100_0000_01b3;
/// All NaN count as this one: their payload and sign are not part of any promise.
const CANONICAL_NAN: u64 = 0x7ff8_0000_0000_0000;

impl Fnv {
    pub fn new() -> Self {
        Self(FNV_OFFSET)
    }

    pub fn feed(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(FNV_PRIME);
        }
    }

    /// A number as the bits of its f64, which is exact for f32, subnormals and −0 included.
    pub fn number<R: Real>(&mut self, x: R) {
        let wide = x.to_f64();
        self.feed(if wide.is_nan() {
            CANONICAL_NAN
        } else {
            wide.to_bits()
        });
    }

    pub fn numbers<R: Real>(&mut self, all: impl IntoIterator<Item = R>) {
        for x in all {
            self.number(x);
        }
    }

    /// A number that may be missing.
    pub fn maybe<R: Real>(&mut self, x: Option<R>) {
        self.feed(u64::from(x.is_some()));
        self.numbers(x);
    }

    /// Whether a constructor took its arguments.
    pub fn verdict<T, E>(&mut self, given: &Result<T, E>) {
        self.feed(u64::from(given.is_ok()));
    }

    pub fn wrench<R: Real>(&mut self, w: &Wrench<R>) {
        self.numbers([w.force.x, w.force.y, w.torque]);
    }

    pub fn twist<R: Real>(&mut self, t: &Twist<R>) {
        self.numbers([t.velocity.x, t.velocity.y, t.spin]);
    }

    pub fn reduced<R: Real>(&mut self, wrench: ReducedWrench<R>, jacobian: ReducedJacobian<R>) {
        self.numbers([wrench.force, wrench.torque]);
        self.numbers([jacobian.force_per_slide, jacobian.force_slide]);
        self.numbers([jacobian.mixed, jacobian.torque_rim]);
    }

    pub fn lateral<R: Real>(&mut self, value: R, gradient: LateralJacobian<R>) {
        self.numbers([value, gradient.slide, gradient.rim]);
    }
}

/// The digest of the same work in f64, then in f32.
pub(crate) fn in_both(wide: fn(&mut Fnv), narrow: fn(&mut Fnv)) -> u64 {
    let mut hash = Fnv::new();
    wide(&mut hash);
    narrow(&mut hash);
    hash.0
}
