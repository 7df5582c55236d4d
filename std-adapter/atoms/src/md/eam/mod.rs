//! Embedded atoms: E = Σ F(ρᵢ) + Σ φ(r) over pairs, where ρᵢ is the electron density that the
//! neighbours of atom i contribute at its position (Daw & Baskes 1984; Finnis & Sinclair 1984).
//!
//! [`Tabulated`] reads the functions from a file; [`SuttonChen`] has them in closed form.

mod crystal;
#[cfg(test)]
mod lanes_tests;
mod metals;
mod passes;
mod spline;
mod sutton_chen;
mod tabulated;

#[doc(hidden)]
pub mod file;

use super::lanes::Lanes;
use super::neighbours::LANES;

pub use metals::{SUTTON_CHEN, SuttonChenMetal};
pub use sutton_chen::{SuttonChen, SuttonChenError, SuttonChenParameters};
pub use tabulated::Tabulated;

/// A function's value and its slope.
type Jet = [f64; 2];

/// Contributions of a pair of atoms: the densities at the first and at the second, and the pair
/// energy.
type PairJets = ([Jet; 2], Jet);

/// The same of four pairs.
type LanesOfJets<N> = ([[N; 2]; 2], [N; 2]);

/// The three functions of embedded atoms. All distances are below the cut-off.
trait Functions: Sync {
    /// Square of the cut-off.
    fn cutoff_sq(&self) -> f64;

    /// Whether both atoms of any pair contribute the same density to each other.
    const ALIKE: bool;

    /// Densities and φ with their slopes.
    fn pair(&self, species: [u8; 2], r: f64) -> PairJets;

    /// The same of a block of pairs of these species, at these distances and their reciprocals.
    fn pairs<N: Lanes>(
        &self,
        key: N::Key,
        kinds: impl FnOnce() -> [[u8; 2]; LANES],
        r: [N; 2],
    ) -> LanesOfJets<N>;

    /// F(ρ).
    fn embedding(&self, species: u8, density: f64) -> Jet;
}
