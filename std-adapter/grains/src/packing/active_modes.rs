//! Modes that the contacts of a scene carry, and their limits.

use super::Material;
use crate::packing::method::FrictionCoupling;
use tribos_contacts::cd::internals::Pairs;
use tribos_contacts::soft::SoftContact;
use tribos_core::contact::{
    AllModes, ContactModes, Frictionless, SlidingOnly, SlidingRolling, SlidingTorsion,
};

/// Sets of contact modes for which a type exists; an absent mode is neither stored nor computed.
///
/// ```
/// use tribos::powder::ModeSet;
/// let modes = ModeSet::SlidingTorsion;
/// assert_eq!(modes.has(), [true, false, true]);
/// assert_eq!(modes.unknowns(), 4); // normal, two of sliding, torsion
/// assert!(modes.bytes() < ModeSet::All.bytes());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeSet {
    /// Normal force only.
    Normal,
    /// Normal force and sliding.
    Sliding,
    /// Normal force, sliding and torsion.
    SlidingTorsion,
    /// Normal force, sliding and rolling.
    SlidingRolling,
    /// Normal force, sliding, rolling and torsion.
    All,
}

/// Modes of a material's contacts and the shape of their limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ActiveModes {
    /// Set of modes.
    pub modes: ModeSet,
    /// How the limits of sliding and torsion are combined; independent if one of them is absent.
    pub coupling: FrictionCoupling,
}

impl Material {
    /// Modes of the material's contacts: the smallest set for which a type exists. Modes with a
    /// coefficient of zero in it are carried but never resist.
    ///
    /// ```
    /// use tribos::powder::{ActiveModes, ModeSet};
    /// use tribos::scene::{FrictionCoupling, PowderScene};
    /// // Sliding resists unless it is switched off.
    /// let scene = PowderScene { mu_torsion: 0.1, ..PowderScene::default() };
    /// let (modes, coupling) = (ModeSet::SlidingTorsion, FrictionCoupling::Independent);
    /// assert_eq!(scene.material().carried(), ActiveModes { modes, coupling });
    /// ```
    pub fn carried(&self) -> ActiveModes {
        let [slides, rolls, twists] = [self.sliding, self.rolling, self.torsion].map(|mu| mu > 0.0);
        let modes = match [slides, rolls, twists] {
            [false, false, false] => ModeSet::Normal,
            [true, false, false] => ModeSet::Sliding,
            [true, false, true] => ModeSet::SlidingTorsion,
            [true, true, false] => ModeSet::SlidingRolling,
            _ => ModeSet::All,
        };
        let coupling = if slides && twists {
            self.coupling
        } else {
            FrictionCoupling::Independent
        };
        ActiveModes { modes, coupling }
    }
}

impl ModeSet {
    /// Number of unknowns of a contact, including the normal one.
    pub fn unknowns(self) -> usize {
        match self {
            Self::Normal => <Frictionless as ContactModes<f64>>::UNKNOWNS,
            Self::Sliding => <SlidingOnly as ContactModes<f64>>::UNKNOWNS,
            Self::SlidingTorsion => <SlidingTorsion as ContactModes<f64>>::UNKNOWNS,
            Self::SlidingRolling => <SlidingRolling as ContactModes<f64>>::UNKNOWNS,
            Self::All => <AllModes as ContactModes<f64>>::UNKNOWNS,
        }
    }

    /// Size of a contact in the solver, in bytes.
    pub fn bytes(self) -> usize {
        match self {
            Self::Normal => Pairs::<Frictionless>::BYTES,
            Self::Sliding => Pairs::<SlidingOnly>::BYTES,
            Self::SlidingTorsion => Pairs::<SlidingTorsion>::BYTES,
            Self::SlidingRolling => Pairs::<SlidingRolling>::BYTES,
            Self::All => Pairs::<AllModes>::BYTES,
        }
    }

    /// Size of a soft contact, in bytes.
    pub(crate) fn soft_bytes(self) -> usize {
        match self {
            Self::Normal => size_of::<SoftContact<Frictionless>>(),
            Self::Sliding => size_of::<SoftContact<SlidingOnly>>(),
            Self::SlidingTorsion => size_of::<SoftContact<SlidingTorsion>>(),
            Self::SlidingRolling => size_of::<SoftContact<SlidingRolling>>(),
            Self::All => size_of::<SoftContact<AllModes>>(),
        }
    }

    /// Whether the set includes sliding, rolling and torsion.
    pub fn has(self) -> [bool; 3] {
        match self {
            Self::Normal => [false; 3],
            Self::Sliding => [true, false, false],
            Self::SlidingTorsion => [true, false, true],
            Self::SlidingRolling => [true, true, false],
            Self::All => [true; 3],
        }
    }
}
