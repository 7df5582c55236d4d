//! Bits of elementary and special functions.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, signed, speed, unit};
use tribos_core::internals::{CompleteElliptic, Gauss};
use tribos_core::real::Real;

/// Digest of roots, powers, logarithms and angles, f64 and f32.
pub fn elementary() -> u64 {
    in_both(elementary_of::<f64>, elementary_of::<f32>)
}

fn elementary_of<R: Real>(hash: &mut Fnv) {
    let mut rng = Lcg::new(61);
    for _ in 0..500 {
        let (x, y): (R, R) = (signed(&mut rng), signed(&mut rng));
        one_argument(hash, x);
        one_argument(hash, unit::<R>(&mut rng) - R::HALF);
        two_arguments(hash, x, y);
        two_arguments(hash, x.abs(), unit::<R>(&mut rng) + R::ONE);
    }
    for x in ends::<R>() {
        one_argument(hash, x);
    }
    for (x, y) in pairs_of_ends::<R>() {
        two_arguments(hash, x, y);
    }
    hash.numbers([R::PI, R::EPSILON, R::MIN_POSITIVE, R::INFINITY, R::NAN]);
    hash.feed(R::HALF_OCTAVE_OF_ONE as u64);
}

fn one_argument<R: Real>(hash: &mut Fnv, x: R) {
    hash.numbers([x, x.abs(), x.sqrt(), x.abs().sqrt(), x.exp(), x.exp_m1()]);
    hash.numbers([x.ln(), x.ln_1p(), x.abs().ln(), x.sin(), x.cos()]);
    hash.numbers([x.asin(), x.atan(), x.asinh()]);
    hash.feed(u64::from(x.is_finite()) | u64::from(x.is_nan()) << 1);
    // Counted for numbers ≥ 0; a NaN's bits are no promise.
    if !x.is_nan() {
        hash.feed(x.abs().half_octave() as u64);
    }
}

fn two_arguments<R: Real>(hash: &mut Fnv, x: R, y: R) {
    hash.numbers([x.pow(y), x.hypot(y)]);
    // The sign of a NaN is no promise.
    if !y.is_nan() {
        hash.number(x.copysign(y));
    }
    hash.numbers([x + y, x - y, x * y, x / y]);
}

/// Digest of complete elliptic integrals, f64 and f32.
pub fn elliptic() -> u64 {
    in_both(elliptic_of::<f64>, elliptic_of::<f32>)
}

fn elliptic_of<R: Real>(hash: &mut Fnv) {
    let mut rng = Lcg::new(67);
    let mut at = |complement| {
        let integrals = CompleteElliptic::<R>::new(complement);
        hash.numbers([integrals.b, integrals.d, integrals.c]);
        hash.numbers([integrals.k(), integrals.e()]);
    };
    for _ in 0..600 {
        let x: R = unit(&mut rng);
        at(x);
        // Close to both ends of the domain.
        let small = speed::<R>(&mut rng) / R::from_f64((1_u64 << 40) as f64);
        at(small);
        at(R::ONE - small);
    }
    ends().into_iter().for_each(at);
}

/// Digest of hypergeometric functions.
pub fn hypergeometric() -> u64 {
    let mut hash = Fnv::new();
    let mut rng = Lcg::new(71);
    let parameters = [
        [0.5, -0.25, 2.0],
        [-0.375, 0.5, 3.0],
        [1.0, 1.0, 2.5],
        [-1.25, -0.75, 12.0],
    ];
    for [a, b, c] in parameters {
        let f = Gauss::new(a, b, c);
        for _ in 0..5 {
            let x: f64 = unit(&mut rng);
            let (at, series) = (f.at(x, 1.0 - x), f.series(x * 0.5));
            hash.numbers([at.value, at.slope, series.value, series.slope]);
            hash.numbers(f.taylor::<9>(1.0 - x, at));
        }
        hash.numbers(f.series_coefficients::<12>());
        for x in ends::<f64>() {
            let (near, far) = (f.at(x, 1.0 - x), f.at(1.0 - x, x));
            hash.numbers([near.value, near.slope, far.value, far.slope]);
        }
    }
    hash.0
}
