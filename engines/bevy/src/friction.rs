//! Friction of a patch, as a component to read.

use bevy::prelude::*;

/// Friction of a [`FrictionPatch`](crate::FrictionPatch) in the last physics step; inserted with it.
///
/// All values are zero, and `holds` is false, while the patch touches nothing. A sleeping body keeps those of its
/// last step.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct PatchFriction {
    /// Force on the foot in newtons, in the world, as its mean over the step.
    pub force: Vec3,
    /// Torque on the foot about the patch's centre in N m, as its mean over the step.
    pub torque: Vec3,
    /// Normal force in newtons, as its mean over the step.
    pub load: f32,
    /// Whether the foot is at rest relative to its ground at the end of the step.
    pub holds: bool,
    /// The time from the step's beginning to rest in seconds, if the foot stopped in this step.
    pub stopped_after: Option<f32>,
    /// Friction in the last substep: where the next step begins.
    pub(crate) last: SubstepFriction,
}

/// Friction in a substep.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SubstepFriction {
    /// Force in newtons.
    pub(crate) force: Vec3,
    /// Torque about the patch's centre in N m.
    pub(crate) torque: Vec3,
    /// Normal impulse in N s that the engine has added after friction had been solved.
    pub(crate) late: f32,
}
