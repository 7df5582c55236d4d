//! Elementary and special functions.

use super::check::{all_nan, finite, holds, numbers};
use super::{Broken, Source};
use tribos_core::internals::{CompleteElliptic, Gauss};
use tribos_core::real::Real;

/// One of the functions.
pub fn special(source: &mut Source) -> Result<(), Broken> {
    let functions = [
        elementary::<f64>,
        elementary::<f32>,
        elliptic::<f64>,
        elliptic::<f32>,
        gauss,
    ];
    source.one_of(&functions)(source)
}

fn elementary<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let (x, y) = (source.number::<R>(), source.number::<R>());
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
    let two = [x.pow(y), x.hypot(y)];
    if x.is_nan() {
        all_nan("elementary functions", one)?;
    }
    if x.is_finite() && y.is_finite() {
        numbers(
            "hypot, asinh, atan, sin, exp",
            [x.hypot(y), x.asinh(), x.atan(), x.sin(), x.exp()],
        )?;
        holds(
            x.hypot(y) >= x.abs() || x.is_nan(),
            "hypot ≥ |x|",
            &[x, y, two[1]],
        )?;
        let index = x.abs().half_octave();
        holds(
            index <= (x.abs() + x.abs()).half_octave(),
            "half octaves rise",
            &[x],
        )?;
    }
    finite(source, "hypot", [two[1], x.atan()])
}

fn elliptic<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let complement = if source.one_in(2) {
        source.unit()
    } else {
        source.number::<R>()
    };
    let at = CompleteElliptic::new(complement);
    if complement > R::ZERO && complement <= R::ONE {
        let values = [at.b, at.d, at.c, at.k(), at.e()];
        holds(
            values.iter().all(|x| x.is_finite() && *x > R::ZERO),
            "integrals > 0",
            &values,
        )
    } else if complement == R::ZERO {
        holds(at.b == R::ONE && at.e() == R::ONE, "E = 1", &[at.b, at.e()])
    } else if complement > R::ONE {
        Ok(())
    } else {
        all_nan("elliptic integrals", [at.b, at.d, at.c, at.k(), at.e()])
    }
}

fn gauss(source: &mut Source) -> Result<(), Broken> {
    // Arguments within the domain, or arbitrary ones.
    let [a, b] = [(); 2].map(|()| 4.0 * source.unit::<f64>() - 2.0);
    let (a, b, c) = if source.is_mild() {
        (a, b, (a + b).max(0.0) + 0.125 + 3.0 * source.unit::<f64>())
    } else {
        (source.number(), source.number(), source.number())
    };
    let f = Gauss::new(a, b, c);
    let x = if source.one_in(2) {
        source.unit()
    } else {
        source.number::<f64>()
    };
    let at = f.at(x, 1.0 - x);
    if (0.0..1.0).contains(&x) {
        finite(source, "hypergeometric function", [at.value, at.slope])?;
    }
    let _ = (
        f.series(x * 0.5),
        f.series_coefficients::<8>(),
        f.taylor::<6>(x, at),
    );
    Ok(())
}
