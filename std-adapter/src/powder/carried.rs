//! Which modes the contacts of a scene carry, and what they are limited by.

use crate::cd::internals::Link;
use crate::scene::{Coupling, PowderScene};
use tribos_core::contact::{
    AllModes, ContactModes, Frictionless, Sliding, SlidingRolling, SlidingTorsion,
};

/// Modes of a contact for which there is a type; what is not named is neither stored nor computed.
///
/// ```
/// use tribos::powder::CarriedModes;
/// let modes = CarriedModes::SlidingTorsion;
/// assert_eq!(modes.has(), [true, false, true]);
/// assert_eq!(modes.unknowns(), 4); // normal, two of sliding, torsion
/// assert!(modes.bytes() < CarriedModes::All.bytes());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CarriedModes {
    /// The normal force alone.
    Normal,
    /// And sliding.
    Sliding,
    /// Sliding and torsion.
    SlidingTorsion,
    /// Sliding and rolling.
    SlidingRolling,
    /// Sliding, rolling and torsion.
    All,
}

/// What limits the modes of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Carried {
    /// The modes.
    pub modes: CarriedModes,
    /// How the limits of sliding and torsion go together; independent where one of them is absent.
    pub coupling: Coupling,
}

impl PowderScene {
    /// What its contacts carry: the smallest set of modes for which there is a type. Modes with a
    /// coefficient of zero in it are carried but never resist.
    ///
    /// ```
    /// use tribos::powder::{Carried, CarriedModes};
    /// use tribos::scene::{Coupling, PowderScene};
    /// // Sliding resists unless it is switched off.
    /// let scene = PowderScene { torsion: 0.1, ..PowderScene::default() };
    /// let (modes, coupling) = (CarriedModes::SlidingTorsion, Coupling::Independent);
    /// assert_eq!(scene.carried(), Carried { modes, coupling });
    /// ```
    pub fn carried(&self) -> Carried {
        let [slides, rolls, twists] = [self.sliding, self.rolling, self.torsion].map(|mu| mu > 0.0);
        let modes = match [slides, rolls, twists] {
            [false, false, false] => CarriedModes::Normal,
            [true, false, false] => CarriedModes::Sliding,
            [true, false, true] => CarriedModes::SlidingTorsion,
            [true, true, false] => CarriedModes::SlidingRolling,
            _ => CarriedModes::All,
        };
        let coupling = if slides && twists {
            self.coupling
        } else {
            Coupling::Independent
        };
        Carried { modes, coupling }
    }
}

impl CarriedModes {
    /// Unknowns of a contact, the normal one included.
    pub fn unknowns(self) -> usize {
        match self {
            Self::Normal => <Frictionless as ContactModes<f64>>::UNKNOWNS,
            Self::Sliding => <Sliding as ContactModes<f64>>::UNKNOWNS,
            Self::SlidingTorsion => <SlidingTorsion as ContactModes<f64>>::UNKNOWNS,
            Self::SlidingRolling => <SlidingRolling as ContactModes<f64>>::UNKNOWNS,
            Self::All => <AllModes as ContactModes<f64>>::UNKNOWNS,
        }
    }

    /// Bytes of a contact in the solver.
    pub fn bytes(self) -> usize {
        match self {
            Self::Normal => size_of::<Link<Frictionless>>(),
            Self::Sliding => size_of::<Link<Sliding>>(),
            Self::SlidingTorsion => size_of::<Link<SlidingTorsion>>(),
            Self::SlidingRolling => size_of::<Link<SlidingRolling>>(),
            Self::All => size_of::<Link<AllModes>>(),
        }
    }

    /// Whether sliding, rolling and torsion are among them.
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
