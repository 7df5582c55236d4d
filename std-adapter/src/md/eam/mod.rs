//! Embedded atoms: E = Σ F(ρᵢ) + Σ φ(r) over pairs, where ρᵢ sums what the neighbours of atom i
//! contribute to the electron density at its place (Daw & Baskes 1984; Finnis & Sinclair 1984).
//!
//! [`Tabulated`] reads the functions from a file, [`SuttonChen`] has them in closed form.

mod passes;
mod spline;
mod sutton_chen;
mod tabulated;

pub mod file;

pub use sutton_chen::{SuttonChen, SuttonChenError, SuttonChenParameters};
pub use tabulated::Tabulated;

/// A function's value and its slope.
type Jet = [f64; 2];

/// What a pair of atoms gives each other: (what the second puts at the first, the other way round),
/// and the energy of the pair.
type PairJets = ([Jet; 2], Jet);

/// The three functions of embedded atoms. Distances handed in are nearer than the cut-off.
trait Functions: Sync {
    /// Square of the cut-off.
    fn cutoff_sq(&self) -> f64;

    /// Density at the first of two atoms due to the second, and the other way round.
    fn densities(&self, species: [u8; 2], r: f64) -> [f64; 2];

    /// Densities and φ with their slopes.
    fn pair(&self, species: [u8; 2], r: f64) -> PairJets;

    /// F(ρ).
    fn embedding(&self, species: u8, density: f64) -> Jet;
}
