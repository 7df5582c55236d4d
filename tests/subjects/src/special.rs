//! Elementary and special functions.

use crate::{Input, Verdict};
use tribos_core::internals::{CompleteElliptic, Gauss};
use tribos_core::real::Real;

/// Roots, powers, logarithms and angles.
pub fn elementary<R: Real>(input: &mut Input<'_>) -> Verdict {
    let (x, y) = (input.number::<R>(), input.number::<R>());
    let one = [
        x.sqrt(),
        x.exp(),
        x.exp_m1(),
        x.ln(),
        x.ln_1p(),
        x.sin(),
        x.cos(),
        x.asinh(),
    ];
    let arcs = [x.asin(), x.atan(), x.abs()];
    let (power, length) = (x.pow(y), x.hypot(y));
    input.give([x + y, x - y, x * y, x / y, power]);
    input.give_bits(u64::from(x.is_finite()) | u64::from(x.is_nan()) << 1);
    if x.is_nan() {
        input.all_nan("elementary functions", one)?;
        return input.all_nan("angles", arcs);
    }
    input.give(one.into_iter().chain(arcs));
    // The sign and the octave of a NaN are no promise.
    if !y.is_nan() {
        input.give([x.copysign(y)]);
    }
    input.give_bits(x.abs().half_octave() as u64);
    if x.is_finite() && y.is_finite() {
        let never_nan = [x.asinh(), x.atan(), x.sin(), x.exp()];
        input.numbers("asinh, atan, sin, exp", never_nan)?;
        input.numbers("hypot", [length])?;
        input.holds(length >= x.abs(), "hypot ≥ |x|", &[x, y, length])?;
        let index = x.abs().half_octave();
        let rises = index <= (x.abs() + x.abs()).half_octave();
        input.holds(rises, "half octaves rise", &[x])?;
    }
    input.finite("hypot", [length, x.atan()])
}

/// The constants of the scalar, and complete elliptic integrals.
pub fn elliptic<R: Real>(input: &mut Input<'_>) -> Verdict {
    let complement = if input.one_in(2) {
        input.unit()
    } else {
        input.number::<R>()
    };
    let at = CompleteElliptic::new(complement);
    input.give([R::PI, R::EPSILON, R::MIN_POSITIVE, R::INFINITY, R::NAN]);
    input.give_bits(R::HALF_OCTAVE_OF_ONE as u64);
    let values = [at.b, at.d, at.c, at.k(), at.e()];
    input.give(values);
    if complement > R::ZERO && complement <= R::ONE {
        input.holds(
            values.iter().all(|x| x.is_finite() && *x > R::ZERO),
            "integrals > 0",
            &values,
        )
    } else if complement == R::ZERO {
        input.holds(at.b == R::ONE && at.e() == R::ONE, "E = 1", &[at.b, at.e()])
    } else if complement > R::ONE {
        Ok(())
    } else {
        input.all_nan("elliptic integrals", values)
    }
}

/// Hypergeometric functions.
pub fn gauss(input: &mut Input<'_>) -> Verdict {
    // Arguments within the domain, or arbitrary ones.
    let [a, b] = [(); 2].map(|()| 4.0 * input.unit::<f64>() - 2.0);
    let (a, b, c) = if input.is_mild() {
        (a, b, (a + b).max(0.0) + 0.125 + 3.0 * input.unit::<f64>())
    } else {
        (input.number(), input.number(), input.number())
    };
    let f = Gauss::new(a, b, c);
    let x = if input.one_in(2) {
        input.unit()
    } else {
        input.number::<f64>()
    };
    let at = f.at(x, 1.0 - x);
    if (0.0..1.0).contains(&x) {
        input.finite("hypergeometric function", [at.value, at.slope])?;
    }
    let series = f.series(x * 0.5);
    input.give([at.value, at.slope, series.value, series.slope]);
    input.give(f.series_coefficients::<8>());
    input.give(f.taylor::<6>(x, at));
    Ok(())
}
