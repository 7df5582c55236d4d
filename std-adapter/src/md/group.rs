//! Groups of atoms and how they may move.

use super::thermostat::Thermostat;

/// How the atoms of a group may move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Hold {
    /// Freely.
    #[default]
    Free,
    /// Not at all.
    Frozen,
    /// In x and y; z stays.
    Plane,
    /// In x and y each, in z all as one: a layer that stays flat and carries a load.
    Level,
    /// As a rigid body round the vertical axis through a point, at a given rate.
    Turning {
        /// x and y of the axis.
        axis: [f64; 2],
        /// Angle over time, positive from x to y.
        rate: f64,
    },
}

/// What is said of a group.
///
/// ```
/// use tribos::md::group::{Group, Hold};
/// let free = Group::default();
/// assert_eq!(free.hold.freedoms(100), 300);
/// // A flat layer under a load: x and y of each atom and one height.
/// let layer = Group { hold: Hold::Level, load: -0.5, ..free };
/// assert_eq!(layer.hold.freedoms(100), 201);
/// let wheel = Hold::Turning { axis: [0.0; 2], rate: 1e-3 };
/// assert!(wheel.freedoms(100) == 0 && !wheel.is_driven_by_forces());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Group {
    /// How its atoms may move.
    pub hold: Hold,
    /// What keeps their temperature.
    pub thermostat: Thermostat,
    /// Force −γv on each atom over its mass: γ, in 1/time. Exact for any γ·dt.
    pub damping: f64,
    /// Constant force on each atom along z.
    pub load: f64,
}

impl Hold {
    /// Degrees of freedom of so many atoms.
    pub fn freedoms(&self, atoms: usize) -> usize {
        match self {
            Self::Free => 3 * atoms,
            Self::Plane => 2 * atoms,
            Self::Level => 2 * atoms + usize::from(atoms > 0),
            Self::Frozen | Self::Turning { .. } => 0,
        }
    }

    /// Whether forces move its atoms.
    pub fn is_driven_by_forces(&self) -> bool {
        !matches!(self, Self::Frozen | Self::Turning { .. })
    }
}
