//! The Lennard-Jones potential of one pair of species, U = 4ε((σ/r)¹² − (σ/r)⁶) up to a cut-off.

/// Treatment of the jump at the cut-off.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shift {
    /// No shift: the energy jumps, and is not conserved when pairs cross the cut-off.
    #[default]
    None,
    /// U − U(r_c): the energy is continuous.
    Energy,
    /// U − U(r_c) − (r − r_c)U'(r_c): energy and force are continuous.
    Force,
}

impl Shift {
    /// Names of the shifts in scenes.
    pub const WORDS: [(&'static str, Self); 3] = [
        ("none", Self::None),
        ("energy", Self::Energy),
        ("force", Self::Force),
    ];
}

/// Precomputed coefficients of one pair of species.
///
/// ```
/// use tribos::md::pair::{Coefficients, Shift};
/// let energy = |pair: Coefficients, r: f64| {
///     let inv6 = r.powi(-6);
///     inv6 * (pair.energy12 * inv6 - pair.energy6) + pair.offset + pair.force_at_cutoff * r
/// };
/// // What is left 1e-4 before the cut-off: a jump, a kink, or neither.
/// let pairs = Shift::WORDS.map(|(_, shift)| Coefficients::new(1.0, 1.0, 2.5, shift));
/// let left = pairs.map(|pair| energy(pair, 2.4999));
/// let at_cutoff = 4.0 * (2.5_f64.powi(-12) - 2.5_f64.powi(-6));
/// assert!((left[0] - at_cutoff).abs() < 1e-5);
/// let slope = -24.0 * (2.0 * 2.5_f64.powi(-12) - 2.5_f64.powi(-6)) / 2.5;
/// assert!((left[1] + 1e-4 * slope).abs() < 1e-8);
/// assert!(left[2].abs() < 1e-8);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients {
    /// Squared cut-off r_c².
    pub cutoff_sq: f64,
    /// 48εσ¹², where −U'(r)/r = (force12/r⁶ − force6)/r⁸.
    pub force12: f64,
    /// 24εσ⁶, see `force12`.
    pub force6: f64,
    /// 4εσ¹², where U = (energy12/r⁶ − energy6)/r⁶ + offset + force_at_cutoff · r.
    pub energy12: f64,
    /// 4εσ⁶, see `energy12`.
    pub energy6: f64,
    /// Constant part of the energy shift.
    pub offset: f64,
    /// −U'(r_c) if the force is shifted, else 0.
    pub force_at_cutoff: f64,
}

impl Coefficients {
    /// *Domain*: ε finite, σ and r_c finite and > 0.
    pub fn new(epsilon: f64, sigma: f64, cutoff: f64, shift: Shift) -> Self {
        let sigma_sq = sigma * sigma;
        let sigma6 = sigma_sq * sigma_sq * sigma_sq;
        let mut pair = Self {
            cutoff_sq: cutoff * cutoff,
            force12: 48.0 * epsilon * sigma6 * sigma6,
            force6: 24.0 * epsilon * sigma6,
            energy12: 4.0 * epsilon * sigma6 * sigma6,
            energy6: 4.0 * epsilon * sigma6,
            ..Self::default()
        };
        let inv_sq = 1.0 / pair.cutoff_sq;
        let inv6 = inv_sq * inv_sq * inv_sq;
        let energy = inv6 * (pair.energy12 * inv6 - pair.energy6);
        let force = inv6 * (pair.force12 * inv6 - pair.force6) / cutoff;
        match shift {
            Shift::None => {}
            Shift::Energy => pair.offset = -energy,
            Shift::Force => {
                pair.offset = -(energy + force * cutoff);
                pair.force_at_cutoff = force;
            }
        }
        pair
    }
}
