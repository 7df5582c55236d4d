//! Embedded atoms: E = Σ F(ρᵢ) + Σ φ(r) over pairs, where ρᵢ is the electron density that the
//! neighbours of atom i contribute at its position (Daw & Baskes 1984; Finnis & Sinclair 1984).
//!
//! [`Tabulated`] reads the functions from a file; [`SuttonChen`] has them in closed form.

mod crystal;
mod metals;
mod passes;
mod spline;
mod sutton_chen;
mod tabulated;

#[doc(hidden)]
pub mod file;

pub use metals::{SUTTON_CHEN, SuttonChenMetal};
pub use sutton_chen::{SuttonChen, SuttonChenError, SuttonChenParameters};
pub use tabulated::Tabulated;

/// A function's value and its slope.
type Jet = [f64; 2];

/// Contributions of a pair of atoms: the densities at the first and at the second, and the pair
/// energy.
type PairJets = ([Jet; 2], Jet);

/// The three functions of embedded atoms. All distances are below the cut-off.
trait Functions: Sync {
    /// Square of the cut-off.
    fn cutoff_sq(&self) -> f64;

    /// Density at the first of two atoms due to the second, and vice versa.
    fn densities(&self, species: [u8; 2], r: f64) -> [f64; 2];

    /// Densities and φ with their slopes.
    fn pair(&self, species: [u8; 2], r: f64) -> PairJets;

    /// F(ρ).
    fn embedding(&self, species: u8, density: f64) -> Jet;
}
