//! Polynomial tables over half octaves of z = 1 − h², built by a `const` function.
//!
//! Φ and Θ are analytic on (0, 1] in z with a weak singularity z^(2+α) at z = 0. On a cell
//! [z, 1.5 z] or [1.5 z, 2 z] the distance to that singularity is at least five half widths, so
//! a polynomial of degree n errs like 9.9⁻ⁿ. The cell of an argument is read off its exponent and
//! first mantissa bit: no logarithm.

use crate::special::{Gauss, Jet};

/// One cell: Φ(z) = Σ aₙ uⁿ and Θ(z) = Σ bₙ uⁿ with u = z − center, stored as pairs (aₙ, bₙ).
#[derive(Clone, Copy, Debug)]
#[repr(C)]
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

/// Which function stands beside Φ in the cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CompanionFunction {
    /// Θ = ((1+α)/2 Φ + zΦ')/n.
    Theta,
    /// zΦ/n + xΘ, the torque factor where spinning leads.
    Blend,
}

/// A function Φ = `scale` · ₂F₁(…; x) with its partner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub gauss: Gauss,
    pub scale: f64,
    pub alpha: f64,
    /// 1/n
    pub inv_moment: f64,
    pub partner: CompanionFunction,
}

/// Builds the cells of a pair: cell 0 is the end z = 0, then two cells an octave upward
/// to z < 1, and the last of these once more for z = 1. `CELLS` is 2·octaves + 2.
pub(super) const fn cells<const CELLS: usize, const TERMS: usize>(
    pair: &Pair,
) -> [Cell<f64, TERMS>; CELLS] {
    let mut out = [Cell {
        center: 0.0,
        mirror: 1.0,
        terms: [[0.0; 2]; TERMS],
    }; CELLS];
    // The two cells [3/4, 1] and [1/2, 3/4], from the power series in x.
    let mut i = CELLS - 2;
    out[i] = cell(pair, 0.875, 0.125, &shifted_series(&pair.gauss, 0.125));
    out[CELLS - 1] = out[i];
    i -= 1;
    out[i] = cell(pair, 0.625, 0.125, &shifted_series(&pair.gauss, 0.375));
    // Below, the equation is continued from one center to the next.
    let mut walk = ContinuationState::start(pair.gauss);
    let mut width = 0.25;
    while i > 1 {
        let upper = 1.75 * width;
        i -= 1;
        out[i] = cell(pair, upper, 0.25 * width, &walk.taylor_at(upper));
        let lower = 1.25 * width;
        i -= 1;
        out[i] = cell(pair, lower, 0.25 * width, &walk.taylor_at(lower));
        width *= 0.5;
    }
    out[0] = end_cell(pair, pair.gauss.at(1.0, 0.0));
    out
}

/// The state of the continuation.
struct ContinuationState {
    phi: Gauss,
    z: f64,
    at: Jet,
    low: Jet,
}

impl ContinuationState {
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

/// Turns the expansion of Φ/`scale` about `center` into one cell of Φ and its partner.
const fn cell<const TERMS: usize>(
    pair: &Pair,
    center: f64,
    half_width: f64,
    phi: &[f64; TAYLOR],
) -> Cell<f64, TERMS> {
    let theta = torque_expansion(pair, phi);
    let partner = match pair.partner {
        CompanionFunction::Theta => theta,
        CompanionFunction::Blend => blended(pair.inv_moment, center, phi, &theta),
    };
    let partner = economized::<TERMS>(&partner, half_width / center);
    let phi = economized::<TERMS>(phi, half_width / center);
    let mut terms = [[0.0; 2]; TERMS];
    let mut scale = pair.scale;
    let mut n = 0;
    while n < TERMS {
        terms[n] = [phi[n] * scale, partner[n] * scale];
        scale /= half_width;
        n += 1;
    }
    Cell {
        center,
        mirror: 1.0 - center,
        terms,
    }
}

/// Θ = ((1+α)/2 Φ − z dΦ/dz)/n, term by term in t: z d/dz tⁿ = n (tⁿ + tⁿ⁻¹).
const fn torque_expansion(pair: &Pair, phi: &[f64; TAYLOR]) -> [f64; TAYLOR] {
    let mut out = [0.0; TAYLOR];
    let mut n = 0;
    while n < TAYLOR {
        let k = n as f64;
        let next = if n + 1 < TAYLOR {
            (k + 1.0) * phi[n + 1]
        } else {
            0.0
        };
        out[n] = ((0.5 * (1.0 + pair.alpha) - k) * phi[n] - next) * pair.inv_moment;
        n += 1;
    }
    out
}

/// zΦ/n + (1−z)Θ with z = `center` (1 + t).
const fn blended(
    inv_moment: f64,
    center: f64,
    phi: &[f64; TAYLOR],
    theta: &[f64; TAYLOR],
) -> [f64; TAYLOR] {
    let mut out = [0.0; TAYLOR];
    let mut before = 0.0;
    let mut n = 0;
    while n < TAYLOR {
        let here = phi[n] * inv_moment - theta[n];
        out[n] = theta[n] + center * (here + before);
        before = here;
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
    // The upper bounds say nothing new, but the compiler sees by them that no index is too large.
    while n >= TERMS && n < TAYLOR {
        // Tₙ/2ⁿ⁻¹ = sⁿ + …; the ratio of its coefficients two powers apart is rational.
        let mut coefficient = c[n];
        let mut k = n;
        // k ≤ n anyway; said again so that no compiler keeps a check of the index.
        while k >= 2 && k < TAYLOR {
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

/// The cell that holds z = 0 only: values, and one-sided slopes, which may be infinite.
const fn end_cell<const TERMS: usize>(pair: &Pair, phi: Jet) -> Cell<f64, TERMS> {
    let half = 0.5 * (1.0 + pair.alpha);
    let chi = pair.inv_moment * half * phi.value;
    let mut terms = [[0.0; 2]; TERMS];
    terms[0] = [pair.scale * phi.value, pair.scale * chi];
    let slope = match pair.partner {
        // d(zΦ')/dz = Φ' where Φ is smooth enough to have a slope.
        CompanionFunction::Theta => (1.0 - half) * pair.inv_moment * phi.slope,
        CompanionFunction::Blend => {
            (1.0 - half) * pair.inv_moment * phi.slope - chi + pair.inv_moment * phi.value
        }
    };
    terms[1] = [-pair.scale * phi.slope, pair.scale * slope];
    Cell {
        center: 0.0,
        mirror: 1.0,
        terms,
    }
}
