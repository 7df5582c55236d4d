//! Pressures that are a polynomial of r².

use super::{PatchError, PowerPressure};

/// A pressure proportional to Σ aₖ r²ᵏ on the unit disk, nowhere negative, as a sum of members
/// (1−r²)ʲ that carry the shares wⱼ of the load.
///
/// *Shape*: `N` coefficients, degree 2(N−1) in r. Shares of opposite sign cancel: results lose a
/// factor Σ|wⱼ|.
///
/// ```
/// use tribos_core::patch::{PatchError, PolynomialPressure};
/// let hollow = PolynomialPressure::new([1.0, 1.0])?; // 1 + r^2 = 2 - (1 - r^2)
/// let [uniform, paraboloid] = *hollow.shares();
/// assert!((uniform - 4.0 / 3.0).abs() < 1e-15 && (paraboloid + 1.0 / 3.0).abs() < 1e-15);
/// let mean = (1.0 / 2.0 + 1.0 / 3.0) / (1.0 + 1.0 / 2.0); // of s over (1 + s) ds, s = r^2
/// assert!((hollow.mean_square_radius() - mean).abs() < 1e-15);
/// assert_eq!(PolynomialPressure::new([1.0, -2.0]), Err(PatchError::Negative)); // pulls at the rim
/// # Ok::<(), PatchError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PolynomialPressure<const N: usize> {
    shares: [f64; N],
}

/// Halvings of [0, 1] in the search for a negative pressure: an interior zero is then located to
/// 1e-6.
const HALVINGS: u32 = 20;
/// A dip below zero of this fraction of the largest coefficient is rounding.
const ROUNDING: f64 = 1e-13;

impl<const N: usize> PolynomialPressure<N> {
    /// From a₀, a₁, …; their common scale does not matter.
    ///
    /// *Domain*: at most [`PowerPressure::MAX_ORDER`] + 1 coefficients, finite, Σ aₖ r²ᵏ ≥ 0 on
    /// the patch with a positive load.
    pub fn new(coefficients: [f64; N]) -> Result<Self, PatchError> {
        if N > PowerPressure::MAX_ORDER as usize + 1 {
            return Err(PatchError::Order {
                given: N.saturating_sub(1) as f64,
                max: PowerPressure::MAX_ORDER,
            });
        }
        let largest = coefficients
            .iter()
            .fold(0.0_f64, |a, b| if b.abs() > a { b.abs() } else { a });
        if !coefficients.iter().all(|a| a.is_finite()) {
            return Err(PatchError::Negative);
        }
        if largest == 0.0 {
            return Err(PatchError::NoLoad);
        }
        let scaled = coefficients.map(|a| a / largest);
        if !is_positive(bernstein(&scaled), HALVINGS) {
            return Err(PatchError::Negative);
        }
        // (1 − u)ᵏ in powers of u = 1 − r², then each power's share of the load, 1/(j+1).
        let mut shares = in_complement(&scaled);
        for (j, share) in shares.iter_mut().enumerate() {
            *share /= j as f64 + 1.0;
        }
        let load: f64 = shares.iter().sum();
        if load <= 0.0 {
            return Err(PatchError::NoLoad);
        }
        Ok(Self {
            shares: shares.map(|share| share / load),
        })
    }

    /// The shares wⱼ of the members (1−r²)ʲ; their sum is 1.
    pub fn shares(&self) -> &[f64; N] {
        &self.shares
    }

    /// ⟨r²⟩ = Σ wⱼ/(j+2), in radii squared.
    pub fn mean_square_radius(&self) -> f64 {
        let terms = self.shares.iter().enumerate();
        terms.map(|(j, share)| share / (j as f64 + 2.0)).sum()
    }
}

/// Coefficients of Σ aₖ (1−u)ᵏ in powers of u, by repeated synthetic division.
fn in_complement<const N: usize>(a: &[f64; N]) -> [f64; N] {
    let mut out = *a;
    // About 1: c[j] are the powers of (s − 1) = −u.
    for done in 0..N {
        let mut carry = 0.0;
        for c in out.iter_mut().skip(done).rev() {
            carry += *c;
            *c = carry;
        }
    }
    for (j, c) in out.iter_mut().enumerate() {
        if j % 2 == 1 {
            *c = -*c;
        }
    }
    out
}

/// Bernstein coefficients on [0, 1]: βₙ = Σₖ C(n,k)/C(N−1,k) aₖ.
fn bernstein<const N: usize>(a: &[f64; N]) -> [f64; N] {
    let mut out = [0.0; N];
    let degree = N as f64 - 1.0;
    for (n, value) in out.iter_mut().enumerate() {
        let mut ratio = 1.0;
        for (k, coefficient) in a.iter().enumerate().take(n + 1) {
            *value += ratio * coefficient;
            ratio *= (n as f64 - k as f64) / (degree - k as f64);
        }
    }
    out
}

/// True if the polynomial of these Bernstein coefficients is nowhere negative on [0, 1]: it lies
/// within their hull, which halving tightens.
fn is_positive<const N: usize>(beta: [f64; N], halvings: u32) -> bool {
    if beta.iter().all(|b| *b >= -ROUNDING) {
        return true;
    }
    let ends = [beta.first(), beta.last()];
    let ends_are_positive = ends.into_iter().flatten().all(|b| *b >= -ROUNDING);
    if !ends_are_positive {
        return false;
    }
    if halvings == 0 {
        // A hull this small around a touching zero.
        return true;
    }
    let (left, right) = halved(beta);
    is_positive(left, halvings - 1) && is_positive(right, halvings - 1)
}

/// de Casteljau: the coefficients on either half.
fn halved<const N: usize>(beta: [f64; N]) -> ([f64; N], [f64; N]) {
    let (mut left, mut right) = (beta, beta);
    for (round, value) in left.iter_mut().enumerate() {
        *value = right.first().copied().unwrap_or(0.0);
        // Averages of neighbours, from the front; what is passed stays as the right half.
        let mut pairs = right.iter_mut();
        let Some(mut front) = pairs.next() else { break };
        for next in pairs.take(N - 1 - round) {
            *front = 0.5 * (*front + *next);
            front = next;
        }
    }
    (left, right)
}
