//! Parameters of face-centred cubic metals.

use super::SuttonChenParameters;

/// A metal in the form of Sutton & Chen. *Units*: eV, Å, u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SuttonChenMetal {
    /// Symbol of the element.
    pub name: &'static str,
    /// Standard atomic weight.
    pub mass: f64,
    /// Scale of the energy ε.
    pub epsilon: f64,
    /// Lattice constant a.
    pub a: f64,
    /// Depth c of the embedding.
    pub c: f64,
    /// Exponent of the repulsion.
    pub n: u32,
    /// Exponent of the density.
    pub m: u32,
}

/// Cut-off, in lattice constants; the sum of the densities beyond it is 3 % for m = 6.
const CUTOFF: f64 = 1.8;
/// Where the taper begins, in lattice constants: behind the fifth shell of neighbours.
const TAPER: f64 = 1.6;

/// The metals of Sutton & Chen (1990), Philos. Mag. Lett. 61, 139, table 1.
///
/// ```
/// use tribos::md::eam::{SUTTON_CHEN, SuttonChen, SuttonChenMetal};
/// let copper: &SuttonChenMetal =
///     SUTTON_CHEN.iter().find(|metal| metal.name == "Cu").ok_or("no copper")?;
/// let potential = SuttonChen::new(copper.parameters())?;
/// // Distance of neighbours and energy of an atom in the crystal.
/// let [spacing, energy] = potential.crystal(0).ok_or("it does not bind")?;
/// assert!((spacing - 3.61 / 2.0_f64.sqrt()).abs() < 0.02 && (energy + 3.49).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const SUTTON_CHEN: [SuttonChenMetal; 10] = [
    metal("Ni", 58.693, [1.5707e-2, 3.52, 39.432], [9, 6]),
    metal("Cu", 63.546, [1.2382e-2, 3.61, 39.432], [9, 6]),
    metal("Rh", 102.905, [4.9371e-3, 3.80, 144.41], [12, 6]),
    metal("Pd", 106.42, [4.1790e-3, 3.89, 108.27], [12, 7]),
    metal("Ag", 107.868, [2.5415e-3, 4.09, 144.41], [12, 6]),
    metal("Ir", 192.217, [2.4489e-3, 3.84, 334.94], [14, 6]),
    metal("Pt", 195.084, [1.9833e-2, 3.92, 34.408], [10, 8]),
    metal("Au", 196.967, [1.2793e-2, 4.08, 34.408], [10, 8]),
    metal("Pb", 207.2, [5.5765e-3, 4.95, 45.778], [10, 7]),
    metal("Al", 26.982, [3.3147e-2, 4.05, 16.399], [7, 6]),
];

const fn metal(
    name: &'static str,
    mass: f64,
    [epsilon, a, c]: [f64; 3],
    [n, m]: [u32; 2],
) -> SuttonChenMetal {
    SuttonChenMetal {
        name,
        mass,
        epsilon,
        a,
        c,
        n,
        m,
    }
}

impl SuttonChenMetal {
    /// Parameters of the potential, tapered between 1.6 and 1.8 lattice constants.
    pub fn parameters(&self) -> SuttonChenParameters {
        SuttonChenParameters {
            epsilon: self.epsilon,
            a: self.a,
            c: self.c,
            n: self.n,
            m: self.m,
            cutoff: CUTOFF * self.a,
            taper: TAPER * self.a,
        }
    }
}
