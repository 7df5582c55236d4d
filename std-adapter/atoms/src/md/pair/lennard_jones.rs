//! The Lennard-Jones potential for any number of species.

use super::{Coefficients, Evaluation, LANES, Lanes, Mixing, PairLaw, Shift, Tally, forces};
use crate::md::atoms::MOST_SPECIES;
use crate::md::interaction::Interaction;
use crate::md::neighbours::{Site, VerletList};
use nalgebra::Vector3;

/// Invalid parameters of the potential.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LennardJonesError {
    /// No species, or more than the table of pairs can hold.
    #[error("there must be 1 to {MOST_SPECIES} species, not {given}")]
    Species {
        /// Number of species.
        given: usize,
    },
    /// A number is not finite and positive.
    #[error("{name}{first}{second} must be finite and positive, not {given}")]
    Parameter {
        /// Name of the parameter: "epsilon", "sigma" or "cutoff".
        name: &'static str,
        /// First species of the pair, from 1.
        first: usize,
        /// Second species of the pair, from 1.
        second: usize,
        /// The rejected value.
        given: f64,
    },
    /// A pair of a species that does not exist.
    #[error("there is no pair {first}{second} among {known} species")]
    Pair {
        /// First species of the pair, from 1.
        first: usize,
        /// Second species of the pair, from 1.
        second: usize,
        /// Number of species.
        known: usize,
    },
}

/// ε, σ and r_c of a pair of species.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pairing {
    /// Depth ε of the potential.
    pub epsilon: f64,
    /// Distance σ at which the potential crosses 0.
    pub sigma: f64,
    /// Cut-off radius r_c.
    pub cutoff: f64,
}

/// U = 4ε((σ/r)¹² − (σ/r)⁶) between all pairs nearer than their cut-off. Any consistent units.
///
/// ```
/// use tribos::md::interaction::Interaction;
/// use tribos::md::pair::{LennardJones, LennardJonesError, Mixing, Pairing, Shift};
/// let argon = Pairing { epsilon: 119.8, sigma: 3.405, cutoff: 8.5 }; // K and Å
/// let krypton = Pairing { epsilon: 164.0, sigma: 3.83, cutoff: 9.5 };
/// let mut gas = LennardJones::mixed(&[argon, krypton], Mixing::Arithmetic, Shift::Energy)?;
/// assert_eq!((gas.cutoff(), gas.shift()), (9.5, Shift::Energy));
/// assert_eq!(gas.pairing(0, 1).map(|unlike| unlike.cutoff), Some(9.0));
/// // Measured parameters in place of mixed ones; a pair has no order.
/// gas.set(0, 1, Pairing { epsilon: 137.0, sigma: 3.6, cutoff: 9.0 })?;
/// assert_eq!(gas.pairing(1, 0), gas.pairing(0, 1));
/// let refused = LennardJones::single(Pairing { sigma: 0.0, ..argon }, Shift::None);
/// let (first, second) = (1, 1);
/// let why = LennardJonesError::Parameter { name: "sigma", first, second, given: 0.0 };
/// assert_eq!(refused, Err(why));
/// # Ok::<(), LennardJonesError>(())
/// ```
///
/// *Accuracy*: forces to a few 10⁻¹⁴ of their largest part. *Special values*: atoms in the same
/// place give NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct LennardJones {
    species: usize,
    shift: Shift,
    pairings: Vec<Pairing>,
    table: Vec<Coefficients>,
}

impl LennardJones {
    /// A potential of one species. *Domain*: all parameters > 0 and finite.
    pub fn single(pairing: Pairing, shift: Shift) -> Result<Self, LennardJonesError> {
        Self::mixed(&[pairing], Mixing::default(), shift)
    }

    /// A potential of several species; parameters of unlike pairs are mixed, the cut-off like σ.
    pub fn mixed(
        like: &[Pairing],
        mixing: Mixing,
        shift: Shift,
    ) -> Result<Self, LennardJonesError> {
        let species = like.len();
        if species == 0 || species > MOST_SPECIES {
            return Err(LennardJonesError::Species { given: species });
        }
        let mut all = Self {
            species,
            shift,
            pairings: vec![like[0]; species * species],
            table: vec![Coefficients::default(); species * species],
        };
        for first in 0..species {
            for second in first..species {
                let (a, b) = (like[first], like[second]);
                let [epsilon, sigma] = mixing.mix([a.epsilon, a.sigma], [b.epsilon, b.sigma]);
                let [_, cutoff] = mixing.mix([1.0, a.cutoff], [1.0, b.cutoff]);
                let unlike = Pairing {
                    epsilon,
                    sigma,
                    cutoff,
                };
                all.set(first, second, if first == second { a } else { unlike })?;
            }
        }
        Ok(all)
    }

    /// Sets the parameters of a pair of species, from 0.
    pub fn set(
        &mut self,
        first: usize,
        second: usize,
        pairing: Pairing,
    ) -> Result<(), LennardJonesError> {
        let known = self.species;
        let (one, two) = (first + 1, second + 1);
        if one.max(two) > known {
            return Err(LennardJonesError::Pair {
                first: one,
                second: two,
                known,
            });
        }
        let Pairing {
            epsilon,
            sigma,
            cutoff,
        } = pairing;
        for (name, given) in [("epsilon", epsilon), ("sigma", sigma), ("cutoff", cutoff)] {
            if !given.is_finite() || given <= 0.0 {
                return Err(LennardJonesError::Parameter {
                    name,
                    first: one,
                    second: two,
                    given,
                });
            }
        }
        for at in [first * known + second, second * known + first] {
            self.pairings[at] = pairing;
            self.table[at] = Coefficients::new(epsilon, sigma, cutoff, self.shift);
        }
        Ok(())
    }

    /// Parameters of a pair of species, from 0.
    pub fn pairing(&self, first: usize, second: usize) -> Option<&Pairing> {
        let is_known = first < self.species && second < self.species;
        is_known.then(|| &self.pairings[first * self.species + second])
    }

    /// How the potential is shifted at the cut-off.
    pub fn shift(&self) -> Shift {
        self.shift
    }
}

impl Interaction for LennardJones {
    fn cutoff(&self) -> f64 {
        self.pairings
            .iter()
            .fold(0.0, |most, pairing| pairing.cutoff.max(most))
    }

    fn species(&self) -> usize {
        self.species
    }

    fn forces(
        &self,
        list: &mut VerletList,
        onto: &mut [Vector3<f64>],
        wanted: Evaluation,
    ) -> Tally {
        // Separate loops: one species needs no table, an unshifted force no square root.
        let many = MultiSpecies {
            species: self.species,
            table: &self.table,
        };
        let one = SingleSpecies(self.table[0]);
        match (self.species, self.shift) {
            (1, Shift::Force) => forces(&law(one, Shifted), list, onto, wanted),
            (1, _) => forces(&law(one, Unshifted), list, onto, wanted),
            (_, Shift::Force) => forces(&law(many, Shifted), list, onto, wanted),
            (_, _) => forces(&law(many, Unshifted), list, onto, wanted),
        }
    }
}

pub(super) fn law<S, E>(source: S, end: E) -> Truncated<S, E> {
    Truncated { source, end }
}

/// Source of the coefficients of a block of pairs.
pub(super) trait Source: Sync {
    type Kinds: Copy;

    fn kinds(&self, here: &Site, block: &[u32; LANES], sites: &[Site]) -> Self::Kinds;

    /// Square of the largest cut-off.
    fn reach_sq(&self) -> f64;

    /// One coefficient of every lane.
    fn each<N: Lanes>(
        &self,
        key: N::Key,
        kinds: Self::Kinds,
        of: impl Fn(&Coefficients) -> f64,
    ) -> N;
}

/// One species: constant coefficients.
pub(super) struct SingleSpecies(pub(super) Coefficients);

impl Source for SingleSpecies {
    type Kinds = ();

    #[inline(always)]
    fn kinds(&self, _: &Site, _: &[u32; LANES], _: &[Site]) {}

    fn reach_sq(&self) -> f64 {
        self.0.cutoff_sq
    }

    #[inline(always)]
    fn each<N: Lanes>(&self, key: N::Key, (): (), of: impl Fn(&Coefficients) -> f64) -> N {
        N::splat(key, of(&self.0))
    }
}

/// Several species: a table of coefficients.
pub(super) struct MultiSpecies<'a> {
    pub(super) species: usize,
    pub(super) table: &'a [Coefficients],
}

impl Source for MultiSpecies<'_> {
    /// Indices into the table.
    type Kinds = [usize; LANES];

    #[inline(always)]
    fn kinds(&self, here: &Site, block: &[u32; LANES], sites: &[Site]) -> [usize; LANES] {
        let row = here.species() * self.species;
        block.map(|other| row + sites[other as usize].species())
    }

    fn reach_sq(&self) -> f64 {
        let all = self.table.iter().map(|pair| pair.cutoff_sq);
        all.fold(0.0, |most, cutoff_sq| cutoff_sq.max(most))
    }

    #[inline(always)]
    fn each<N: Lanes>(
        &self,
        key: N::Key,
        kinds: [usize; LANES],
        of: impl Fn(&Coefficients) -> f64,
    ) -> N {
        N::new(key, kinds.map(|kind| of(&self.table[kind])))
    }
}

/// The shift of the force at the cut-off, and the corresponding energy.
pub(super) trait CutoffCorrection: Sync {
    /// −U'(r)/r at 1/r², given its unshifted value.
    fn force<N: Lanes>(&self, unshifted: N, force_at_cutoff: N, inv_sq: N) -> N;

    /// The shift of the energy at r².
    fn energy<N: Lanes>(&self, offset: N, force_at_cutoff: N, r_sq: N) -> N;
}

/// No shift of the force, and no square root.
pub(super) struct Unshifted;

impl CutoffCorrection for Unshifted {
    #[inline(always)]
    fn force<N: Lanes>(&self, unshifted: N, _: N, _: N) -> N {
        unshifted
    }

    #[inline(always)]
    fn energy<N: Lanes>(&self, offset: N, _: N, _: N) -> N {
        offset
    }
}

/// Shift by the force at the cut-off.
pub(super) struct Shifted;

impl CutoffCorrection for Shifted {
    #[inline(always)]
    fn force<N: Lanes>(&self, unshifted: N, force_at_cutoff: N, inv_sq: N) -> N {
        unshifted - force_at_cutoff * inv_sq.sqrt()
    }

    #[inline(always)]
    fn energy<N: Lanes>(&self, offset: N, force_at_cutoff: N, r_sq: N) -> N {
        offset + force_at_cutoff * r_sq.sqrt()
    }
}

/// The potential with its coefficients and its shift.
pub(super) struct Truncated<S, E> {
    source: S,
    end: E,
}

impl<S: Source, E: CutoffCorrection> Truncated<S, E> {
    /// The values where r is below the cut-off, 0 elsewhere.
    #[inline(always)]
    fn within<N: Lanes>(&self, key: N::Key, kinds: S::Kinds, r_sq: N, values: N) -> N {
        let cutoff_sq = self.source.each(key, kinds, |pair| pair.cutoff_sq);
        r_sq.if_below(cutoff_sq, values, N::splat(key, 0.0))
    }
}

impl<S: Source, E: CutoffCorrection> PairLaw for Truncated<S, E> {
    type Kinds = S::Kinds;

    #[inline(always)]
    fn kinds(&self, here: &Site, block: &[u32; LANES], sites: &[Site]) -> S::Kinds {
        self.source.kinds(here, block, sites)
    }

    fn reach_sq(&self) -> f64 {
        self.source.reach_sq()
    }

    #[inline(always)]
    fn force_over_distance<N: Lanes>(&self, key: N::Key, kinds: S::Kinds, r_sq: N) -> N {
        let force12: N = self.source.each(key, kinds, |pair| pair.force12);
        let force6 = self.source.each(key, kinds, |pair| pair.force6);
        let at_cutoff = self.source.each(key, kinds, |pair| pair.force_at_cutoff);
        let inv_sq = N::splat(key, 1.0) / r_sq;
        let inv6 = inv_sq * inv_sq * inv_sq;
        let unshifted = inv6 * (force12 * inv6 - force6) * inv_sq;
        let strength = self.end.force(unshifted, at_cutoff, inv_sq);
        self.within(key, kinds, r_sq, strength)
    }

    #[inline(always)]
    fn energy<N: Lanes>(&self, key: N::Key, kinds: S::Kinds, r_sq: N) -> N {
        let energy12: N = self.source.each(key, kinds, |pair| pair.energy12);
        let energy6 = self.source.each(key, kinds, |pair| pair.energy6);
        let offset = self.source.each(key, kinds, |pair| pair.offset);
        let at_cutoff = self.source.each(key, kinds, |pair| pair.force_at_cutoff);
        let inv_sq = N::splat(key, 1.0) / r_sq;
        let inv6 = inv_sq * inv_sq * inv_sq;
        let energy = inv6 * (energy12 * inv6 - energy6) + self.end.energy(offset, at_cutoff, r_sq);
        self.within(key, kinds, r_sq, energy)
    }
}
