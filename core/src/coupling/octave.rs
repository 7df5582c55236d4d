//! Polynomial tables over half octaves of z = 1 − h², built by a `const` function.
//!
//! Φ and Θ are analytic on (0, 1] in z with a weak singularity z^(2+α) at z = 0. On a cell
//! [z, 1.5 z] or [1.5 z, 2 z] the distance to that singularity is at least five half widths, so
//! a polynomial of degree n errs like 9.9⁻ⁿ. The cell of an argument is read off its exponent and
//! first mantissa bit: no logarithm.

use crate::special::hypergeometric::{Gauss, Jet};

/// One cell: Φ(z) = Σ aₙ uⁿ and Θ(z) = Σ bₙ uⁿ with u = z − center, stored as pairs (aₙ, bₙ).
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell<R, const TERMS: usize> {
    pub center: R,
    /// 1 − center, the cell's center in x: u = mirror − x keeps every digit of a small x.
    pub mirror: R,
    pub terms: [[R; 2]; TERMS],
}

/// Taylor terms kept before economization: the ratio of half width to center is at most 1/5, and
/// 5⁻²⁸ < 2⁻⁶⁴.
const TAYLOR: usize = 28;
/// Terms of the power series about x = 0 used for the two cells above z = 1/2: 2⁻⁶⁰ at x = 1/2.
const SERIES: usize = 60;

/// Builds the cells of exponent `alpha`: cell 0 is the end z = 0, then two cells an octave upward
/// to z < 1, and the last of these once more for z = 1. `CELLS` is 2·octaves + 2.
pub(super) const fn cells<const CELLS: usize, const TERMS: usize>(
    alpha: f64,
) -> [Cell<f64, TERMS>; CELLS] {
    let phi = force_function(alpha);
    let mut out = [Cell {
        center: 0.0,
        mirror: 1.0,
        terms: [[0.0; 2]; TERMS],
    }; CELLS];
    // The two cells [3/4, 1] and [1/2, 3/4], from the power series in x.
    let mut i = CELLS - 2;
    out[i] = cell(alpha, 0.875, 0.125, &shifted_series(&phi, 0.125));
    out[CELLS - 1] = out[i];
    i -= 1;
    out[i] = cell(alpha, 0.625, 0.125, &shifted_series(&phi, 0.375));
    // Below, the equation is continued from one center to the next.
    let mut walk = Walk::start(phi);
    let mut width = 0.25;
    while i > 1 {
        let upper = 1.75 * width;
        i -= 1;
        out[i] = cell(alpha, upper, 0.25 * width, &walk.taylor_at(upper));
        let lower = 1.25 * width;
        i -= 1;
        out[i] = cell(alpha, lower, 0.25 * width, &walk.taylor_at(lower));
        width *= 0.5;
    }
    out[0] = end_cell(alpha, phi.at(1.0, 0.0));
    out
}

/// Φ = ₂F₁((1−α)/2, −(1+α)/2; 2; x).
pub(super) const fn force_function(alpha: f64) -> Gauss {
    Gauss::new(0.5 * (1.0 - alpha), -0.5 * (1.0 + alpha), 2.0)
}

/// The state of the continuation.
struct Walk {
    phi: Gauss,
    z: f64,
    at: Jet,
    low: Jet,
}

impl Walk {
    const fn start(phi: Gauss) -> Self {
        Self {
            phi,
            z: 0.5,
            at: phi.series(0.5),
            low: Jet {
                value: 0.0,
                slope: 0.0,
            },
        }
    }

    /// Moves to `z` and expands Φ there in t = (z' − z)/z.
    const fn taylor_at(&mut self, z: f64) -> [f64; TAYLOR] {
        (self.at, self.low) = self
            .phi
            .continued(self.z, self.at, self.low, z / self.z - 1.0);
        self.z = z;
        let at = Jet {
            value: self.at.value + self.low.value,
            slope: self.at.slope + self.low.slope,
        };
        self.phi.taylor(z, at)
    }
}

/// The power series in x re-expanded about `x`, in t = (z' − z)/z with z = 1 − x.
const fn shifted_series(phi: &Gauss, x: f64) -> [f64; TAYLOR] {
    let mut c: [f64; SERIES] = phi.series_coefficients();
    // Repeated synthetic division by (x' − x).
    let mut n = 0;
    while n < TAYLOR {
        let mut k = SERIES - 1;
        while k > n {
            c[k - 1] += x * c[k];
            k -= 1;
        }
        n += 1;
    }
    let mut out = [0.0; TAYLOR];
    let mut power = 1.0;
    n = 0;
    while n < TAYLOR {
        out[n] = c[n] * power;
        power *= x - 1.0;
        n += 1;
    }
    out
}

/// Turns the expansion of Φ about `center` into one cell of Φ and Θ.
const fn cell<const TERMS: usize>(
    alpha: f64,
    center: f64,
    half_width: f64,
    phi: &[f64; TAYLOR],
) -> Cell<f64, TERMS> {
    let theta = economized::<TERMS>(&torque_expansion(alpha, phi), half_width / center);
    let phi = economized::<TERMS>(phi, half_width / center);
    let mut terms = [[0.0; 2]; TERMS];
    let mut scale = 1.0;
    let mut n = 0;
    while n < TERMS {
        terms[n] = [phi[n] * scale, theta[n] * scale];
        scale /= half_width;
        n += 1;
    }
    Cell {
        center,
        mirror: 1.0 - center,
        terms,
    }
}

/// Θ = 2/(3+α) ((1+α)/2 Φ − z dΦ/dz), term by term in t: z d/dz tⁿ = n (tⁿ + tⁿ⁻¹).
const fn torque_expansion(alpha: f64, phi: &[f64; TAYLOR]) -> [f64; TAYLOR] {
    let mut out = [0.0; TAYLOR];
    let mut n = 0;
    while n < TAYLOR {
        let k = n as f64;
        let next = if n + 1 < TAYLOR {
            (k + 1.0) * phi[n + 1]
        } else {
            0.0
        };
        out[n] = ((0.5 * (1.0 + alpha) - k) * phi[n] - next) * 2.0 / (3.0 + alpha);
        n += 1;
    }
    out
}

/// Lanczos' economization: rescales t to s = t/`ratio` ∈ [−1, 1] and drops, from the top, the
/// Chebyshev polynomial that each surplus power carries. The error is that of the dropped
/// Chebyshev terms, nearly the least possible.
const fn economized<const TERMS: usize>(taylor: &[f64; TAYLOR], ratio: f64) -> [f64; TERMS] {
    let mut c = *taylor;
    let mut scale = 1.0;
    let mut n = 0;
    while n < TAYLOR {
        c[n] *= scale;
        scale *= ratio;
        n += 1;
    }
    n = TAYLOR - 1;
    while n >= TERMS {
        // Tₙ/2ⁿ⁻¹ = sⁿ + …; the ratio of its coefficients two powers apart is rational.
        let mut coefficient = c[n];
        let mut k = n;
        while k >= 2 {
            let top = (k * (k - 1)) as f64;
            let bottom = ((n - k + 2) * (n + k - 2)) as f64;
            coefficient *= -top / bottom;
            c[k - 2] -= coefficient;
            k -= 2;
        }
        n -= 1;
    }
    let mut out = [0.0; TERMS];
    n = 0;
    while n < TERMS {
        out[n] = c[n];
        n += 1;
    }
    out
}

/// The cell that holds z = 0 only: value and one-sided slope.
const fn end_cell<const TERMS: usize>(alpha: f64, phi: Jet) -> Cell<f64, TERMS> {
    let factor = 2.0 / (3.0 + alpha);
    let mut terms = [[0.0; 2]; TERMS];
    terms[0] = [phi.value, factor * 0.5 * (1.0 + alpha) * phi.value];
    terms[1] = [-phi.slope, factor * 0.5 * (1.0 - alpha) * phi.slope];
    Cell {
        center: 0.0,
        mirror: 1.0,
        terms,
    }
}
