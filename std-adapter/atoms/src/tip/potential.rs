//! Potentials of a tip by name: Lennard-Jones in reduced units, metals in Å, eV, ps, K and u.

use super::forces::TipForces;
use super::run::TipError;
use crate::md::eam::file::PotentialFile;
use crate::md::eam::{SUTTON_CHEN, SuttonChen, Tabulated};
use crate::md::interaction::Interaction;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

/// Atomic mass unit in eV ps²/Å² (CODATA 2018: u = 1.660 539 066 60e-27 kg, e = 1.602 176 634e-19 C).
const ATOMIC_MASS: f64 = 1.660_539_066_60e-27 * 1e4 / 1.602_176_634e-19;
/// Boltzmann's constant in eV/K (exact in the SI).
const BOLTZMANN: f64 = 1.380_649e-23 / 1.602_176_634e-19;

/// The potential of a tip and its substrate.
///
/// | text | potential | units |
/// |---|---|---|
/// | `lennard-jones` | the thesis' (section 5.3) | σ, ε, m and k_B are 1 |
/// | `sutton-chen:Cu` | a metal of Sutton & Chen: Ni, Cu, Rh, Pd, Ag, Ir, Pt, Au, Pb, Al | Å, eV, ps, K, u |
/// | `eam:FILE` | the first element of a `setfl` or `funcfl` file | Å, eV, ps, K, u |
/// | `eam:FILE,substrate=Cu,tip=Ni` | elements of a `setfl` file by their names | Å, eV, ps, K, u |
///
/// ```
/// use tribos::tip::TipPotential;
/// let copper: TipPotential = "sutton-chen:Cu".parse()?;
/// assert!(copper.is_metal() && copper.to_string() == "sutton-chen:Cu");
/// let [substrate, tip] = copper.spacings().ok_or("no crystal")?;
/// assert!(substrate == tip && (substrate - 2.553).abs() < 0.02); // Å
/// assert!((copper.boltzmann() * 300.0 - 0.02585).abs() < 1e-5); // eV
/// assert!(!TipPotential::default().is_metal());
/// let refused = "sutton-chen:Fe".parse::<TipPotential>();
/// assert!(refused.is_err_and(|error| error.to_string().contains("Ni, Cu")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A file is read once, when the text is.
#[derive(Clone, Debug, Default)]
pub struct TipPotential(Option<Arc<Metal>>);

/// A metal, and what its crystals are.
#[derive(Debug)]
struct Metal {
    text: String,
    forces: TipForces,
    /// Elements of substrate and tip, as species of `forces`.
    species: [u8; 2],
    /// Their names.
    names: [String; 2],
    /// Their masses, in u.
    masses: [f64; 2],
    /// Distances of nearest neighbours in their crystals.
    spacings: [f64; 2],
}

impl TipPotential {
    /// Whether it is a metal, in metal units.
    pub fn is_metal(&self) -> bool {
        self.0.is_some()
    }

    /// Elements of substrate and tip; nothing for Lennard-Jones.
    pub fn elements(&self) -> Option<[&str; 2]> {
        let metal = self.0.as_ref()?;
        Some([&metal.names[0], &metal.names[1]])
    }

    /// Distances of nearest neighbours in the crystals of substrate and tip at zero temperature and
    /// pressure; nothing for Lennard-Jones, whose scene says it.
    pub fn spacings(&self) -> Option<[f64; 2]> {
        Some(self.0.as_ref()?.spacings)
    }

    /// Cut-off of a metal; nothing for Lennard-Jones, whose scene says it.
    pub fn cutoff(&self) -> Option<f64> {
        Some(self.0.as_ref()?.forces.cutoff())
    }

    /// Boltzmann's constant in the potential's units.
    pub fn boltzmann(&self) -> f64 {
        if self.is_metal() { BOLTZMANN } else { 1.0 }
    }

    /// Masses of an atom of substrate and tip in units of energy, time and length.
    pub fn masses(&self) -> [f64; 2] {
        let metal = self.0.as_ref();
        metal.map_or([1.0; 2], |metal| {
            metal.masses.map(|mass| mass * ATOMIC_MASS)
        })
    }

    /// Masses of an atom of substrate and tip as tables have them: in u for metals.
    pub(super) fn plain_masses(&self) -> [f64; 2] {
        self.0.as_ref().map_or([1.0; 2], |metal| metal.masses)
    }

    /// The interaction and the species of substrate and tip; nothing for Lennard-Jones.
    pub(super) fn forces(&self) -> Option<(&TipForces, [u8; 2])> {
        let metal = self.0.as_ref()?;
        Some((&metal.forces, metal.species))
    }
}

impl Metal {
    /// A metal of the table, tip and substrate alike.
    fn sutton_chen(text: &str, name: &str) -> Result<Self, TipError> {
        let metal = SUTTON_CHEN.iter().find(|metal| metal.name == name);
        let refused = || TipError::Metal { given: name.into() };
        let metal = metal.ok_or_else(refused)?;
        let law = SuttonChen::new(metal.parameters()).map_err(|_| refused())?;
        let unbound = || TipError::Unbound { name: name.into() };
        let [spacing, _] = law.crystal(0).ok_or_else(unbound)?;
        Ok(Self {
            text: text.into(),
            forces: TipForces::SuttonChen(law),
            species: [0; 2],
            names: [name.into(), name.into()],
            masses: [metal.mass; 2],
            spacings: [spacing; 2],
        })
    }

    /// Elements of a file.
    fn of_file(text: &str, rest: &str) -> Result<Self, TipError> {
        let mut parts = rest.split(',').map(str::trim);
        let file = parts.next().unwrap_or_default();
        let refuse = |reason: String| TipError::File {
            file: file.into(),
            reason,
        };
        let mut wanted: [Option<&str>; 2] = [None; 2];
        for part in parts {
            match part.split_once('=') {
                Some(("substrate", name)) => wanted[0] = Some(name.trim()),
                Some(("tip", name)) => wanted[1] = Some(name.trim()),
                _ => return Err(TipError::Potential(text.into())),
            }
        }
        let tables = std::fs::read_to_string(file).map_err(|error| refuse(error.to_string()))?;
        let tables = PotentialFile::read(&tables).map_err(|error| refuse(error.to_string()))?;
        let number = |wanted: Option<&str>| -> Result<usize, TipError> {
            match wanted {
                None => Ok(0),
                Some(name) => {
                    let names = [name.to_owned()];
                    let found = tables.elements_of(Some(&names), 1);
                    let found = found.map_err(|error| refuse(error.to_string()))?;
                    Ok(found.first().copied().unwrap_or_default())
                }
            }
        };
        let numbers = [number(wanted[0])?, number(wanted[1])?];
        let mut elements = numbers.to_vec();
        elements.dedup();
        let law = Tabulated::new(&tables, &elements).map_err(|error| refuse(error.to_string()))?;
        let species = [0, elements.len() as u8 - 1];
        let name = |number: usize| {
            let element = &tables.elements[number];
            element
                .name
                .clone()
                .unwrap_or_else(|| format!("element {}", element.number))
        };
        let names = numbers.map(name);
        let [below, above] = [0, 1].map(|side| {
            let unbound = || TipError::Unbound {
                name: names[side].clone(),
            };
            law.crystal(species[side]).ok_or_else(unbound)
        });
        Ok(Self {
            text: text.into(),
            species,
            masses: numbers.map(|number| tables.elements[number].mass),
            spacings: [below?[0], above?[0]],
            forces: TipForces::Tabulated(Arc::new(law)),
            names,
        })
    }
}

impl FromStr for TipPotential {
    type Err = TipError;

    fn from_str(text: &str) -> Result<Self, TipError> {
        let text = text.trim();
        let metal = match text.split_once(':') {
            None if text == "lennard-jones" => return Ok(Self(None)),
            Some(("sutton-chen", name)) => Metal::sutton_chen(text, name.trim())?,
            Some(("eam", rest)) if !rest.is_empty() => Metal::of_file(text, rest)?,
            _ => return Err(TipError::Potential(text.into())),
        };
        Ok(Self(Some(Arc::new(metal))))
    }
}

impl fmt::Display for TipPotential {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.as_ref().map_or("lennard-jones", |metal| &metal.text))
    }
}

/// The same text and the same crystals.
impl PartialEq for TipPotential {
    fn eq(&self, other: &Self) -> bool {
        self.to_string() == other.to_string()
            && self.spacings() == other.spacings()
            && self.masses() == other.masses()
    }
}
