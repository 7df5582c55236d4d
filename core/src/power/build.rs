//! The table of a power, built in double-double arithmetic by `const` functions.

use super::{COEFFICIENTS, COEFFICIENTS_F32, Cell, FixedPower, OCTAVE_OF_ONE, OCTAVES, STEPS};

/// An unevaluated sum of two numbers, about 104 binary digits.
#[derive(Clone, Copy)]
struct Double {
    high: f64,
    low: f64,
}

const ONE: Double = Double {
    high: 1.0,
    low: 0.0,
};
const LN_2: Double = Double {
    high: core::f64::consts::LN_2,
    low: 2.319_046_813_846_299_6e-17,
};

/// Multiplies by 2ⁿ + 1 to cut a number in two, 53 − n digits in front.
const HALVES: f64 = (1u64 << 27) as f64 + 1.0;
const TWELVE_DIGITS: f64 = (1u64 << 41) as f64 + 1.0;

const fn front(x: f64, cut: f64) -> f64 {
    let c = cut * x;
    c - (c - x)
}

/// a + b for |a| ≥ |b|.
const fn quick_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    Double {
        high,
        low: b - (high - a),
    }
}

const fn sum(a: Double, b: Double) -> Double {
    let high = a.high + b.high;
    let part = high - a.high;
    let low = (a.high - (high - part)) + (b.high - part);
    quick_sum(high, low + (a.low + b.low))
}

const fn product(a: Double, b: Double) -> Double {
    let high = a.high * b.high;
    let [a1, b1] = [front(a.high, HALVES), front(b.high, HALVES)];
    let [a2, b2] = [a.high - a1, b.high - b1];
    let low = ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2;
    quick_sum(high, low + (a.high * b.low + a.low * b.high))
}

const fn exact(x: f64) -> Double {
    Double { high: x, low: 0.0 }
}

const fn quotient(a: Double, b: f64) -> Double {
    let high = a.high / b;
    let back = product(exact(high), exact(b));
    quick_sum(high, ((a.high - back.high) - back.low + a.low) / b)
}

/// Doublings after the series of the exponential.
const DOUBLINGS: u32 = 9;
/// Terms of that series: (7/512)¹⁶/16! < 2⁻¹³⁰.
const EXP_TERMS: u32 = 16;

/// e^x for |x| ≤ 7.
const fn exp(x: Double) -> Double {
    let shrink = 1.0 / (1u32 << DOUBLINGS) as f64;
    let x = Double {
        high: x.high * shrink,
        low: x.low * shrink,
    };
    let mut out = ONE;
    let mut n = EXP_TERMS;
    while n > 0 {
        out = sum(ONE, quotient(product(x, out), n as f64));
        n -= 1;
    }
    n = 0;
    while n < DOUBLINGS {
        out = product(out, out);
        n += 1;
    }
    out
}

/// Terms of the logarithm's series, whose ratio is at most 1/9.
const LN_TERMS: u32 = 36;

/// −ln c for 1/2 ≤ c ≤ 1: 2 artanh((1 − c)/(1 + c)).
const fn minus_ln(c: f64) -> Double {
    let s = quotient(exact(1.0 - c), 1.0 + c);
    let square = product(s, s);
    let mut out = exact(0.0);
    let mut n = LN_TERMS;
    while n > 0 {
        n -= 1;
        out = sum(quotient(ONE, (2 * n + 1) as f64), product(square, out));
    }
    product(exact(2.0), product(s, out))
}

/// c of each cell: 32/(32 + i) to a 1024th.
const INVERSES: [f64; STEPS] = {
    let mut out = [0.0; STEPS];
    let mut i = 0;
    while i < STEPS {
        let place = STEPS + i;
        out[i] = ((1024 * STEPS + place / 2) / place) as f64 / 1024.0;
        i += 1;
    }
    out
};

/// −ln c of each cell.
const LOGARITHMS: [Double; STEPS] = {
    let mut out = [ONE; STEPS];
    let mut i = 0;
    while i < STEPS {
        out[i] = minus_ln(INVERSES[i]);
        i += 1;
    }
    out
};

/// Largest |t|: half a cell and half a 1024th of c ≥ 1/2.
const REACH: f64 = 0.5 / STEPS as f64 + 1.0 / 1024.0;
/// Terms of the binomial series before economization: those beyond are below 2⁻¹⁰⁰.
const BINOMIAL: usize = 18;

/// q(t) = ((1 + t)^α − 1)/t for |t| ≤ [`REACH`] with `N` terms: of the binomial series, from the
/// top, each surplus power is replaced by what its Chebyshev polynomial leaves of it.
const fn bend<const N: usize>(alpha: f64) -> [f64; N] {
    let mut c = [0.0; BINOMIAL];
    let mut coefficient = alpha;
    let mut n = 0;
    while n < BINOMIAL {
        c[n] = coefficient;
        coefficient *= (alpha - (n + 1) as f64) / (n + 2) as f64;
        n += 1;
    }
    let square = REACH * REACH;
    n = BINOMIAL - 1;
    // The upper bounds say nothing new, but the compiler sees by them that no index is too large.
    while n >= N && n < BINOMIAL {
        let mut part = c[n];
        let mut k = n;
        while k >= 2 && k < BINOMIAL {
            let top = (k * (k - 1)) as f64;
            let bottom = ((n - k + 2) * (n + k - 2)) as f64;
            part *= -top / bottom * square;
            c[k - 2] -= part;
            k -= 2;
        }
        n -= 1;
    }
    let mut out = [0.0; N];
    n = 0;
    while n < N && n < BINOMIAL {
        out[n] = c[n];
        n += 1;
    }
    out
}

/// 2^(eα), e rising.
const fn octaves(alpha: f64) -> [Double; OCTAVES] {
    let step = product(exact(alpha), LN_2);
    let [up, down] = [
        exp(step),
        exp(Double {
            high: -step.high,
            low: -step.low,
        }),
    ];
    let mut out = [ONE; OCTAVES];
    let mut i = OCTAVE_OF_ONE;
    while i + 1 < OCTAVES {
        out[i + 1] = product(out[i], up);
        i += 1;
    }
    i = OCTAVE_OF_ONE;
    while i > 0 && i < OCTAVES {
        out[i - 1] = product(out[i], down);
        i -= 1;
    }
    out
}

/// Exponents below this make no difference to a difference quotient at exponent 0.
const NO_EXPONENT: f64 = 1e-18;

/// x^α and (x^α − 1)/α for x = 2^−`halvings`; the second is ln x for α = 0.
///
/// *Domain*: −1 < `alpha` ≤ 10. *Accuracy*: half a unit in the last place, about.
pub(crate) const fn halved(alpha: f64, halvings: u32) -> [f64; 2] {
    if alpha.abs() < NO_EXPONENT {
        return [1.0, -(halvings as f64) * core::f64::consts::LN_2];
    }
    let half = exp(product(exact(-alpha), LN_2));
    let mut power = ONE;
    let mut n = 0;
    while n < halvings {
        power = product(power, half);
        n += 1;
    }
    let rest = sum(power, exact(-1.0));
    [power.high, (rest.high + rest.low) / alpha]
}

impl FixedPower<f64> {
    /// *Domain*: −1 < `alpha` ≤ 10. *Cost*: about 50,000 floating-point operations.
    pub const fn new(alpha: f64) -> Self {
        let powers = octaves(alpha);
        let mut octaves = [[0.0; 2]; OCTAVES];
        let mut i = 0;
        while i < OCTAVES {
            octaves[i] = in_two(powers[i]);
            i += 1;
        }
        let mut cells = [Cell {
            inverse: 1.0,
            head: 1.0,
            tail: 0.0,
        }; STEPS];
        i = 0;
        while i < STEPS {
            let [head, tail] = in_two(exp(product(exact(alpha), LOGARITHMS[i])));
            cells[i] = Cell {
                inverse: INVERSES[i],
                head,
                tail,
            };
            i += 1;
        }
        Self {
            alpha,
            octaves,
            cells,
            terms: bend::<COEFFICIENTS>(alpha),
        }
    }
}

/// Half of the digits, and the rest.
const fn in_two(x: Double) -> [f64; 2] {
    let head = front(x.high, HALVES);
    [head, (x.high - head) + x.low]
}

/// Beyond 2^±80 tails of single precision lose digits, or products overflow.
const SINGLE_OCTAVES: f64 = 80.0;

impl FixedPower<f32> {
    /// *Domain*: −1 < `alpha` ≤ 10; computed in f64 arithmetic and rounded.
    pub const fn new(alpha: f32) -> Self {
        let wide = alpha as f64;
        let powers = octaves(wide);
        let mut octaves = [[f32::NAN; 2]; OCTAVES];
        let mut i = 0;
        while i < OCTAVES {
            let octave = (i as f64 - OCTAVE_OF_ONE as f64) * wide;
            if octave <= SINGLE_OCTAVES && octave >= -SINGLE_OCTAVES {
                octaves[i] = in_two_single(powers[i]);
            }
            i += 1;
        }
        let mut cells = [Cell {
            inverse: 1.0,
            head: 1.0,
            tail: 0.0,
        }; STEPS];
        i = 0;
        while i < STEPS {
            let [head, tail] = in_two_single(exp(product(exact(wide), LOGARITHMS[i])));
            cells[i] = Cell {
                inverse: INVERSES[i] as f32,
                head,
                tail,
            };
            i += 1;
        }
        let few = bend::<COEFFICIENTS_F32>(wide);
        let mut terms = [0.0; COEFFICIENTS];
        i = 0;
        while i < COEFFICIENTS_F32 {
            terms[i] = few[i] as f32;
            i += 1;
        }
        Self {
            alpha,
            octaves,
            cells,
            terms,
        }
    }
}

/// Twelve digits, and the rest.
const fn in_two_single(x: Double) -> [f32; 2] {
    let head = front(x.high, TWELVE_DIGITS);
    [head as f32, ((x.high - head) + x.low) as f32]
}
