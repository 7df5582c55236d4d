//! K and E from Cephes' polynomials, put into the thesis' formulas as printed.
//!
//! The integrals are good to 1e-16, but eqs. 3.11 and 3.13 subtract nearly equal multiples of
//! them: F loses all digits for ε → 0 and T for ε → ∞.
//!
//! *Source*: S. L. Moshier, Cephes library, `ellpk.c` and `ellpe.c` (2000).
#![expect(clippy::excessive_precision, reason = "coefficients as published")]

use super::agm::horner;
use super::{FORCE_FACTOR, TORQUE_FACTOR};

/// Below this 1 − m Cephes takes the limit ln 4 − ½ ln(1 − m).
const MACHINE_EPSILON: f64 = 1.11022302462515654042e-16;

/// `[F, T]` by eqs. 3.11 and 3.13. *Accuracy*: 1e-15 near ε = 1, none far from it.
#[inline]
pub fn wrench(slide: f64, rim: f64) -> [f64; 2] {
    if rim == 0.0 {
        return [1.0, 0.0];
    }
    let ratio = slide / rim;
    if ratio == 0.0 {
        return [0.0, 2.0 / 3.0];
    }
    let sq = ratio * ratio;
    if ratio <= 1.0 {
        let (k, e) = integrals(1.0 - sq);
        let force = ((sq + 1.0) * e + (sq - 1.0) * k) / ratio;
        let torque = (4.0 - 2.0 * sq) * e + (sq - 1.0) * k;
        [FORCE_FACTOR * force, TORQUE_FACTOR * torque]
    } else {
        let (k, e) = integrals(1.0 - 1.0 / sq);
        let force = (sq + 1.0) * e - (sq - 1.0) * k;
        let torque = ratio * ((4.0 - 2.0 * sq) * e + (2.0 * sq - 5.0 + 3.0 / sq) * k);
        [FORCE_FACTOR * force, TORQUE_FACTOR * torque]
    }
}

/// K and E from the complementary parameter 1 − m.
#[inline]
fn integrals(complement: f64) -> (f64, f64) {
    if complement < MACHINE_EPSILON {
        // (1 − m) K → 0: the infinite K of equal speeds must not meet its factor 0.
        return (0.0, 1.0);
    }
    let log = complement.ln();
    let k = horner(complement, &K_REGULAR) - log * horner(complement, &K_LOG);
    let e = horner(complement, &E_REGULAR) - log * complement * horner(complement, &E_LOG);
    (k, e)
}

/// Regular part of K, ascending powers of 1 − m; Cephes `ellpk.c`, array P.
const K_REGULAR: [f64; 11] = [
    1.38629436111989062502,
    9.65735902811690126535e-2,
    3.08851465246711995998e-2,
    1.49380448916805252718e-2,
    8.79078273952743772254e-3,
    6.18901033637687613229e-3,
    6.87489687449949877925e-3,
    9.85821379021226008714e-3,
    7.97404013220415179367e-3,
    2.28025724005875567385e-3,
    1.37982864606273237150e-4,
];
/// Factor of −ln(1 − m) in K; array Q.
const K_LOG: [f64; 11] = [
    4.99999999999999999821e-1,
    1.24999999999870820058e-1,
    7.03124996963957469739e-2,
    4.88280347570998239232e-2,
    3.73774314173823228969e-2,
    3.01204715227604046988e-2,
    2.39089602715924892727e-2,
    1.54850516649762399335e-2,
    5.94058303753167793257e-3,
    9.14184723865917226571e-4,
    2.94078955048598507511e-5,
];
/// Regular part of E; Cephes `ellpe.c`, array P.
const E_REGULAR: [f64; 11] = [
    1.00000000000000000299,
    4.43147180560990850618e-1,
    5.68051945617860553470e-2,
    2.18317996015557253103e-2,
    1.15688436810574127319e-2,
    7.58395289413514708519e-3,
    7.77395492516787092951e-3,
    1.07350949056076193403e-2,
    8.68786816565889628429e-3,
    2.50888492163602060990e-3,
    1.53552577301013293365e-4,
];
/// Factor of −(1 − m) ln(1 − m) in E; array Q.
const E_LOG: [f64; 10] = [
    2.49999999999888314361e-1,
    9.37499997197644278445e-2,
    5.85936634471101055642e-2,
    4.27180926518931511717e-2,
    3.34833904888224918614e-2,
    2.61769742454493659583e-2,
    1.68862163993311317300e-2,
    6.50609489976927491433e-3,
    1.00962792679356715133e-3,
    3.27954898576485872656e-5,
];

#[cfg(test)]
mod tests {
    use super::*;
    use tribos_core::internals::CompleteElliptic;

    /// Guards the copied coefficients against the kernel's own integrals.
    #[test]
    fn the_integrals_themselves_are_good() {
        for i in 1..1000 {
            let complement = f64::from(i) / 1000.0;
            let exact = CompleteElliptic::new(complement);
            let (k, e) = integrals(complement);
            assert!((k / exact.k() - 1.0).abs() < 2e-15, "K at {complement}");
            assert!((e / exact.e() - 1.0).abs() < 2e-15, "E at {complement}");
        }
    }
}
