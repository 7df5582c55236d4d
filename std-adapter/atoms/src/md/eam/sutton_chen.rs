//! The closed form of Sutton & Chen (1990), Philos. Mag. Lett. 61, 139.

use super::{Functions, Jet, LanesOfJets, PairJets, crystal, passes};
use crate::md::interaction::{Evaluation, Interaction, Tally};
use crate::md::lanes::Lanes;
use crate::md::neighbours::{LANES, VerletList};
use nalgebra::Vector3;

/// E = ε (Σ (a/r)ⁿ S over pairs − c Σ √ρᵢ), ρᵢ = Σ (a/r)ᵐ S. Any consistent units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SuttonChenParameters {
    /// Scale of the energy, > 0.
    pub epsilon: f64,
    /// Scale of the length, commonly the lattice constant, > 0.
    pub a: f64,
    /// Depth of the embedding, > 0.
    pub c: f64,
    /// Exponent of the repulsion, > m.
    pub n: u32,
    /// Exponent of the density, ≥ 1.
    pub m: u32,
    /// Cut-off of all functions.
    pub cutoff: f64,
    /// Distance at which the taper S begins, 0 < `taper` < `cutoff`; closer, the functions are as published.
    pub taper: f64,
}

/// Invalid parameters of the potential.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SuttonChenError {
    /// A number is not finite and positive.
    #[error("{name} must be finite and positive, not {given}")]
    Parameter {
        /// Name of the invalid field.
        name: &'static str,
        /// The rejected value.
        given: f64,
    },
    /// The exponents would not repel at short range.
    #[error("the exponents must be n > m >= 1 and n <= {MOST}, not n = {n} and m = {m}", MOST = MOST_EXPONENT)]
    Exponents {
        /// Exponent of the repulsion.
        n: u32,
        /// Exponent of the density.
        m: u32,
    },
    /// There is no room for the taper.
    #[error("the taper must begin before the cut-off {cutoff}, not at {taper}")]
    Taper {
        /// Start of the taper.
        taper: f64,
        /// The cut-off.
        cutoff: f64,
    },
}

/// Largest exponent; published ones end at 14.
const MOST_EXPONENT: u32 = 64;

/// The Sutton–Chen potential of one species.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::md::{atoms::Atoms, neighbours::VerletList};
/// # use tribos::space::PeriodicBox;
/// use tribos::md::eam::{SuttonChen, SuttonChenError, SuttonChenParameters};
/// use tribos::md::interaction::{Interaction, Evaluation, evaluate};
/// let given = SuttonChenParameters {
///     epsilon: 0.012382, // copper: eV and Å
///     a: 3.61,
///     c: 39.432,
///     n: 9,
///     m: 6,
///     cutoff: 7.2,
///     taper: 6.5,
/// };
/// let copper = SuttonChen::new(given)?;
/// // Two atoms alone: E = ε ((a/r)⁹ − 2 c (a/r)³).
/// # let mut list = VerletList::new(PeriodicBox::OPEN, copper.cutoff(), 0.3)?;
/// # let mut forces = Vec::new();
/// let pair = Atoms::at(vec![Vector3::zeros(), Vector3::x() * 2.3]);
/// let energy = evaluate(&copper, &mut list, &pair, &mut forces, Evaluation::Sums)?.energy;
/// let cube = (copper.parameters().a / 2.3).powi(3);
/// assert!((energy - 0.012382 * (cube.powi(3) - 2.0 * 39.432 * cube)).abs() < 1e-13);
/// // Exponents that would not repel at short range are refused.
/// let refused = SuttonChen::new(SuttonChenParameters { n: 6, ..given });
/// assert_eq!(refused, Err(SuttonChenError::Exponents { n: 6, m: 6 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// The sums of the original run over the whole lattice. Here (a/r)ⁿ and (a/r)ᵐ are multiplied by
/// S = (1 − x)³ (1 + 3x + 6x²), x = (r − taper)/(cutoff − taper): 1 up to the taper, 0 at the cut-off,
/// with two continuous derivatives. Energy and force are continuous everywhere, also for a separating
/// lone pair, whose embedding energy is a root: its force vanishes as the root of the remaining distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SuttonChen {
    given: SuttonChenParameters,
    cutoff_sq: f64,
}

impl SuttonChen {
    /// Checks the parameters.
    pub fn new(given: SuttonChenParameters) -> Result<Self, SuttonChenError> {
        let SuttonChenParameters {
            epsilon,
            a,
            c,
            n,
            m,
            cutoff,
            taper,
        } = given;
        for (name, given) in [
            ("epsilon", epsilon),
            ("a", a),
            ("c", c),
            ("cutoff", cutoff),
            ("taper", taper),
        ] {
            if !given.is_finite() || given <= 0.0 {
                return Err(SuttonChenError::Parameter { name, given });
            }
        }
        if m == 0 || n <= m || n > MOST_EXPONENT {
            return Err(SuttonChenError::Exponents { n, m });
        }
        if taper >= cutoff {
            return Err(SuttonChenError::Taper { taper, cutoff });
        }
        let cutoff_sq = cutoff * cutoff;
        Ok(Self { given, cutoff_sq })
    }

    /// Distance of nearest neighbours and energy of an atom in the face-centred cubic crystal at zero
    /// temperature and pressure; nothing if it does not bind.
    pub fn crystal(&self, species: u8) -> Option<[f64; 2]> {
        crystal::crystal(self, species)
    }

    /// The parameters.
    pub fn parameters(&self) -> &SuttonChenParameters {
        &self.given
    }

    /// S and its slope.
    #[inline(always)]
    fn taper<N: Lanes>(&self, key: N::Key, r: N) -> [N; 2] {
        let [zero, one, three, six] = [0.0, 1.0, 3.0, 6.0].map(|number| N::splat(key, number));
        let inv_width = N::splat(key, 1.0 / (self.given.cutoff - self.given.taper));
        let x = (r - N::splat(key, self.given.taper)) * inv_width;
        let positive = |x: N| zero.if_below(x, x, zero);
        let x = positive(x);
        // At the cut-off rounding may give a negative value.
        let left = positive(one - x);
        let cube = left * left * left;
        let value = cube * (one + x * (three + six * x));
        let slope = N::splat(key, -30.0) * (x * x) * (left * left) * inv_width;
        [value, slope]
    }

    /// Density and energy of pairs at these distances and their reciprocals, with their slopes.
    #[inline(always)]
    fn jets<N: Lanes>(&self, key: N::Key, [r, inv]: [N; 2]) -> [[N; 2]; 2] {
        let SuttonChenParameters {
            epsilon, a, n, m, ..
        } = self.given;
        let [s, ds] = self.taper(key, r);
        let ratio = N::splat(key, a) * inv;
        let density = power(key, ratio, m);
        let repulsion = N::splat(key, epsilon) * density * power(key, ratio, n - m);
        // (xᵏ S)' = xᵏ (S' − k S/r)
        let fall = s * inv;
        [(density, m), (repulsion, n)].map(|(value, k)| {
            let k = N::splat(key, f64::from(k));
            [value * s, value * (ds - k * fall)]
        })
    }
}

impl Functions for SuttonChen {
    const ALIKE: bool = true;

    #[inline]
    fn cutoff_sq(&self) -> f64 {
        self.cutoff_sq
    }

    fn pair(&self, _: [u8; 2], r: f64) -> PairJets {
        let r: wide::f64x4 = Lanes::splat((), r);
        let one: wide::f64x4 = Lanes::splat((), 1.0);
        let [density, energy] = self
            .jets((), [r, one / r])
            .map(|jet| jet.map(|lanes| lanes.to_array()[0]));
        ([density; 2], energy)
    }

    #[inline(always)]
    fn pairs<N: Lanes>(
        &self,
        key: N::Key,
        _: impl FnOnce() -> [[u8; 2]; LANES],
        r: [N; 2],
    ) -> LanesOfJets<N> {
        let [density, energy] = self.jets(key, r);
        ([density; 2], energy)
    }

    #[inline]
    fn embedding(&self, _: u8, density: f64) -> Jet {
        // An atom without neighbours has no force, though the root's slope is infinite there.
        if density == 0.0 {
            return [0.0; 2];
        }
        let depth = -self.given.epsilon * self.given.c;
        let root = density.sqrt();
        [depth * root, 0.5 * depth / root]
    }
}

impl Interaction for SuttonChen {
    fn cutoff(&self) -> f64 {
        self.given.cutoff
    }

    fn species(&self) -> usize {
        1
    }

    fn forces(
        &self,
        list: &mut VerletList,
        onto: &mut [Vector3<f64>],
        wanted: Evaluation,
    ) -> Tally {
        passes::forces(self, list, onto, wanted)
    }
}

/// xᵏ by squaring.
#[inline(always)]
fn power<N: Lanes>(key: N::Key, mut x: N, mut k: u32) -> N {
    let mut product = N::splat(key, 1.0);
    while k > 0 {
        if k & 1 == 1 {
            product = product * x;
        }
        k >>= 1;
        if k > 0 {
            x = x * x;
        }
    }
    product
}
