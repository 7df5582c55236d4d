//! Embedded atoms from tables.

use super::file::{ElementError, PotentialFile};
use super::spline::{Grid, Spline};
use super::{Functions, Jet, LanesOfJets, PairJets, crystal, passes};
use crate::md::interaction::{Evaluation, Interaction, Tally};
use crate::md::lanes::Lanes;
use crate::md::neighbours::{LANES, VerletList};
use nalgebra::Vector3;

/// Embedded atoms whose functions come from a file, interpolated as LAMMPS does.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::md::{atoms::Atoms, neighbours::VerletList};
/// # use tribos::space::PeriodicBox;
/// use tribos::md::eam::{Tabulated, file::{Element, ElementError, PotentialFile}};
/// use tribos::md::interaction::{Interaction, Evaluation, evaluate};
/// // Straight lines, which the interpolation meets: F = −ρ, ρ = 5 − r and rφ = 5 − r.
/// let line = |from: f64, step: f64| (0..=10).map(|k| from + step * f64::from(k)).collect();
/// let file = PotentialFile {
///     elements: vec![Element { name: None, number: 29, mass: 63.546 }],
///     cutoff: 5.0,
///     density_step: 0.5,
///     distance_step: 0.5,
///     embeddings: vec![line(0.0, -0.5)],
///     densities: vec![line(5.0, -0.5)],
///     pairs: vec![line(5.0, -0.5)],
/// };
/// let potential = Tabulated::new(&file, &[0])?;
/// # let mut list = VerletList::new(PeriodicBox::OPEN, potential.cutoff(), 0.3)?;
/// # let mut forces = Vec::new();
/// let pair = Atoms::at(vec![Vector3::zeros(), Vector3::x() * 2.0]);
/// let energy = evaluate(&potential, &mut list, &pair, &mut forces, Evaluation::Sums)?.energy;
/// assert!((energy - (-3.0 - 3.0 + 3.0 / 2.0)).abs() < 1e-14);
/// // An element that the file has not.
/// let refused = Tabulated::new(&file, &[1]);
/// assert!(matches!(refused, Err(ElementError::Number { number: 2, known: 1 })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *Domain*: distances above 0. *Special values*: F continues linearly for densities beyond the
/// table; atoms at the same position give NaN. *Accuracy*: within a few ulp of LAMMPS.
#[derive(Clone, Debug)]
pub struct Tabulated {
    cutoff: f64,
    cutoff_sq: f64,
    distances: Grid,
    charges: Grid,
    /// Largest density in the tables of F.
    densest: f64,
    /// F of each species.
    embeddings: Vec<Spline>,
    /// Density that each species contributes to its neighbours.
    densities: Vec<Spline>,
    /// rφ of each pair of species.
    pairs: Vec<Spline>,
}

impl Tabulated {
    /// A potential with one species for each of `elements`, which are indices into the file from 0.
    pub fn new(file: &PotentialFile, elements: &[usize]) -> Result<Self, ElementError> {
        let known = file.elements.len();
        if let Some(&beyond) = elements.iter().find(|&&element| element >= known) {
            let number = beyond + 1;
            return Err(ElementError::Number { number, known });
        }
        let of_elements = |table: &dyn Fn(usize) -> Spline| -> Vec<Spline> {
            elements.iter().map(|&element| table(element)).collect()
        };
        let pair = |a: usize, b: usize| Spline::through(file.pair(a, b), file.distance_step);
        let pairs = elements
            .iter()
            .flat_map(|&a| elements.iter().map(move |&b| (a, b)));
        let knots = |tables: &[Vec<f64>]| tables.first().map_or(2, Vec::len);
        let densest = file.density_step * (knots(&file.embeddings) - 1) as f64;
        Ok(Self {
            cutoff: file.cutoff,
            cutoff_sq: file.cutoff * file.cutoff,
            distances: Grid::new(file.distance_step, knots(&file.densities)),
            charges: Grid::new(file.density_step, knots(&file.embeddings)),
            densest,
            embeddings: of_elements(&|e| Spline::through(&file.embeddings[e], file.density_step)),
            densities: of_elements(&|e| Spline::through(&file.densities[e], file.distance_step)),
            pairs: pairs.map(|(a, b)| pair(a, b)).collect(),
        })
    }

    /// Distance of nearest neighbours and energy of an atom in the face-centred cubic crystal of a
    /// species at zero temperature and pressure; nothing if it does not bind.
    pub fn crystal(&self, species: u8) -> Option<[f64; 2]> {
        crystal::crystal(self, species)
    }
}

impl Functions for Tabulated {
    #[inline]
    fn cutoff_sq(&self) -> f64 {
        self.cutoff_sq
    }

    const ALIKE: bool = false;

    #[inline]
    fn pair(&self, [a, b]: [u8; 2], r: f64) -> PairJets {
        let spot = self.distances.spot(r);
        let [a, b] = [usize::from(a), usize::from(b)];
        let by_b = self.densities[b].jet(spot);
        let by_a = if a == b {
            by_b
        } else {
            self.densities[a].jet(spot)
        };
        let [product, slope] = self.pairs[a * self.densities.len() + b].jet(spot);
        let inv = 1.0 / r;
        let energy = product * inv;
        ([by_b, by_a], [energy, slope * inv - energy * inv])
    }

    #[inline(always)]
    fn pairs<N: Lanes>(
        &self,
        key: N::Key,
        kinds: impl FnOnce() -> [[u8; 2]; LANES],
        [r, _]: [N; 2],
    ) -> LanesOfJets<N> {
        let (kinds, r) = (kinds(), r.to_array());
        let jets: [PairJets; LANES] = std::array::from_fn(|lane| self.pair(kinds[lane], r[lane]));
        let lanes =
            |of: &dyn Fn(&PairJets) -> f64| N::new(key, std::array::from_fn(|k| of(&jets[k])));
        let jet = |of: fn(&PairJets) -> &Jet| [0, 1].map(|part| lanes(&|jets| of(jets)[part]));
        (
            [jet(|jets| &jets.0[0]), jet(|jets| &jets.0[1])],
            jet(|jets| &jets.1),
        )
    }

    #[inline]
    fn embedding(&self, species: u8, density: f64) -> Jet {
        let [energy, slope] = self.embeddings[usize::from(species)].jet(self.charges.spot(density));
        if density > self.densest {
            [energy + slope * (density - self.densest), slope]
        } else {
            [energy, slope]
        }
    }
}

impl Interaction for Tabulated {
    fn cutoff(&self) -> f64 {
        self.cutoff
    }

    fn species(&self) -> usize {
        self.densities.len()
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
