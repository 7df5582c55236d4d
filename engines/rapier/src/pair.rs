//! One foot on one ground: the state of the contact, and its friction.

use crate::patch::Patch;
use rapier3d::prelude::*;
use tribos_core::twist::Wrench;

/// Friction on a foot, as its mean over a step.
///
/// ```
/// use rapier3d::prelude::*;
/// use tribos_rapier::{Friction, Patch, PatchContacts};
/// # let mut world = PhysicsWorld::new();
/// # world.gravity = Vector::new(0.0, -9.81, 0.0);
/// # let table = world.insert_collider(ColliderBuilder::cuboid(2.0, 0.1, 2.0), None);
/// # let body = RigidBodyBuilder::dynamic()
/// #     .translation(Vector::new(0.0, 0.11, 0.0))
/// #     .linvel(Vector::new(0.0, 0.0, 0.0));
/// # let (puck, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08).mass(0.17));
/// # let mut patches = PatchContacts::new();
/// let patch = Patch::disk(0.3, 0.08)?;
/// patches.insert(foot, table, patch, &world.bodies, &mut world.colliders)?;
/// world.bodies[puck].add_force(Vector::new(0.2, 0.0, 0.0), true); // mu N is 0.5 N
/// for _ in 0..30 {
///     patches.step(&mut world);
/// }
/// let Friction { force, load, holds, .. } = patches.friction(foot, table).ok_or("no patch")?;
/// assert!(holds && (force.x + 0.2).abs() < 1e-3);
/// assert!((load - 0.17 * 9.81).abs() < 1e-2 * load); // its weight
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct Friction {
    /// Force in newtons, in world axes, at the middle of the patch.
    pub force: Vector,
    /// Torque about the contact's normal in newton metres, in world axes.
    pub torque: Vector,
    /// Normal load of the foot, in newtons.
    pub load: f32,
    /// Whether the foot is at rest relative to the ground.
    pub holds: bool,
}

/// End of sliding within the last step.
///
/// ```
/// use rapier3d::prelude::*;
/// use tribos_rapier::{Patch, PatchContacts, Stop};
/// # let mut world = PhysicsWorld::new();
/// # world.gravity = Vector::new(0.0, -9.81, 0.0);
/// # let table = world.insert_collider(ColliderBuilder::cuboid(2.0, 0.1, 2.0), None);
/// # let body = RigidBodyBuilder::dynamic()
/// #     .translation(Vector::new(0.0, 0.11, 0.0))
/// #     .linvel(Vector::new(1.0, 0.0, 0.0));
/// # let (_, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08).mass(0.17));
/// # let mut patches = PatchContacts::new();
/// let patch = Patch::disk(0.3, 0.08)?;
/// patches.insert(foot, table, patch, &world.bodies, &mut world.colliders)?;
/// let dt = world.integration_parameters.dt;
/// let found = (0..60).find_map(|step| {
///     patches.step(&mut world);
///     patches.stop(foot, table).map(|stop| (step as f32 * dt, stop))
/// });
/// let (before, Stop { within_step }) = found.ok_or("still on its way")?;
/// let exact = 1.0 / (0.3 * 9.81); // v/(mu g)
/// assert!((before + within_step - exact).abs() < 5e-3 * exact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct Stop {
    /// Time from the beginning of the step in which the patch came to rest, in seconds.
    pub within_step: f32,
}

/// A contact after the engine's step.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct ContactLoad {
    /// Normal load in newtons.
    pub(crate) load: f32,
    /// Normal from the ground to the foot.
    pub(crate) normal: Vector,
    /// Distance from the centre of mass of the foot to the contact, against the normal, in metres.
    pub(crate) depth: f32,
}

/// Results of a step with which the next one predicts.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct PreviousStep {
    pub(crate) touching: ContactLoad,
    /// Force and torque in the plane beyond the expected ones, if friction held against them.
    held: Option<[f32; 3]>,
    /// Linear and angular velocity of the ground after the step.
    below: [Vector; 2],
}

/// A foot on its ground.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct Pair {
    pub(crate) foot: ColliderHandle,
    pub(crate) ground: ColliderHandle,
    pub(crate) patch: Patch,
    /// Outward normal of the face in the foot's frame, if the patch follows from its shape.
    pub(crate) face: Option<Vector>,
    /// Whether the current step is the engine's own, and the patch begins with the next one.
    pub(crate) is_next: bool,
    pub(crate) known: Option<PreviousStep>,
    pub(crate) friction: Friction,
    pub(crate) stop: Option<Stop>,
}

impl Pair {
    pub(crate) fn new(foot: ColliderHandle, ground: ColliderHandle, patch: Patch) -> Self {
        Self {
            foot,
            ground,
            patch,
            face: None,
            is_next: false,
            known: None,
            friction: Friction::default(),
            stop: None,
        }
    }

    /// Continues with the patch of `other` from the current state of the contact.
    pub(crate) fn repatch(&mut self, other: Self) {
        if self.foot == other.foot {
            (self.patch, self.face) = (other.patch, other.face);
        } else {
            *self = other;
        }
    }
}

impl PreviousStep {
    pub(crate) fn new(
        touching: ContactLoad,
        held: Option<Wrench<f32>>,
        ground: Option<&RigidBody>,
    ) -> Self {
        Self {
            touching,
            held: held.map(|held| [held.force.x, held.force.y, held.torque]),
            below: motion(ground),
        }
    }

    /// The change of the ground's velocity at a point and of its spin since the step, if there is one.
    pub(crate) fn jump(&self, ground: Option<&RigidBody>, point: Vector) -> Option<[Vector; 2]> {
        let now = motion(ground);
        if now == self.below {
            return None;
        }
        let [linear, angular] = [now[0] - self.below[0], now[1] - self.below[1]];
        let arm = ground.map_or(Vector::ZERO, |ground| point - ground.center_of_mass());
        Some([linear + angular.cross(arm), angular])
    }

    /// The push beyond the expected one against which friction held.
    pub(crate) fn held(&self) -> Option<Wrench<f32>> {
        let [x, y, torque] = self.held?;
        Some(Wrench::new(x, y, torque))
    }
}

/// Velocity of the centre of mass and spin of a ground; without body it is at rest.
fn motion(ground: Option<&RigidBody>) -> [Vector; 2] {
    ground.map_or([Vector::ZERO; 2], |ground| {
        [ground.linvel(), ground.angvel()]
    })
}
