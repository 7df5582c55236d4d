//! Groups of atoms and how they may move.

use super::thermostat::Thermostat;

/// How the atoms of a group may move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum MotionConstraint {
    /// Freely.
    #[default]
    Free,
    /// Not at all.
    Frozen,
    /// In x and y; z is fixed.
    Plane,
    /// Individually in x and y, together in z: a layer that stays flat under a load.
    Level,
    /// As a rigid body about a vertical axis, at a given rate.
    Turning {
        /// x and y of the axis.
        axis: [f64; 2],
        /// Angular velocity, positive from x to y.
        rate: f64,
    },
}

/// Whose motion a thermostat takes for heat.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ThermalFrame {
    /// All motion relative to the box.
    #[default]
    Box,
    /// Motion relative to the mean velocity of the group along x and y, which is left alone.
    Mean,
}

/// Properties of a group.
///
/// ```
/// use tribos::md::group::{Group, MotionConstraint};
/// let free = Group::default();
/// assert_eq!(free.hold.freedoms(100), 300);
/// // A flat layer under a load: x and y of each atom and one height.
/// let layer = Group { hold: MotionConstraint::Level, load: -0.5, ..free };
/// assert_eq!(layer.hold.freedoms(100), 201);
/// let wheel = MotionConstraint::Turning { axis: [0.0; 2], rate: 1e-3 };
/// assert!(wheel.freedoms(100) == 0 && !wheel.is_driven_by_forces());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Group {
    /// How the atoms of the group may move.
    pub hold: MotionConstraint,
    /// Thermostat of the group.
    pub thermostat: Thermostat,
    /// What the thermostat takes for heat.
    pub frame: ThermalFrame,
    /// Damping rate γ in 1/time: force −γv per mass on each atom, v relative to the support if
    /// one pulls the group. Exact for any γ·dt.
    pub damping: f64,
    /// Constant force on each atom along z.
    pub load: f64,
}

impl MotionConstraint {
    /// Degrees of freedom of `atoms` atoms in this group.
    pub fn freedoms(&self, atoms: usize) -> usize {
        match self {
            Self::Free => 3 * atoms,
            Self::Plane => 2 * atoms,
            Self::Level => 2 * atoms + usize::from(atoms > 0),
            Self::Frozen | Self::Turning { .. } => 0,
        }
    }

    /// Whether forces move the atoms of the group.
    pub fn is_driven_by_forces(&self) -> bool {
        !matches!(self, Self::Frozen | Self::Turning { .. })
    }
}
