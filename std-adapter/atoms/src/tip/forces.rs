//! Forces between the atoms of a tip and its substrate.

use crate::md::eam::{SuttonChen, Tabulated};
use crate::md::interaction::{Evaluation, Interaction, Tally};
use crate::md::neighbours::VerletList;
use crate::md::pair::LennardJones;
use nalgebra::Vector3;
use std::sync::Arc;

/// The interaction that a scene's potential names.
#[derive(Clone, Debug)]
pub enum TipForces {
    /// Lennard-Jones pairs.
    LennardJones(LennardJones),
    /// A metal of Sutton & Chen.
    SuttonChen(SuttonChen),
    /// Metals from tables.
    Tabulated(Arc<Tabulated>),
}

impl Interaction for TipForces {
    fn cutoff(&self) -> f64 {
        match self {
            Self::LennardJones(law) => law.cutoff(),
            Self::SuttonChen(law) => law.cutoff(),
            Self::Tabulated(law) => law.cutoff(),
        }
    }

    fn species(&self) -> usize {
        match self {
            Self::LennardJones(law) => law.species(),
            Self::SuttonChen(law) => law.species(),
            Self::Tabulated(law) => law.species(),
        }
    }

    fn forces(
        &self,
        list: &mut VerletList,
        onto: &mut [Vector3<f64>],
        wanted: Evaluation,
    ) -> Tally {
        match self {
            Self::LennardJones(law) => law.forces(list, onto, wanted),
            Self::SuttonChen(law) => law.forces(list, onto, wanted),
            Self::Tabulated(law) => law.forces(list, onto, wanted),
        }
    }
}
