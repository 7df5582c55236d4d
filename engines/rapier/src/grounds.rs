//! Grounds on which all that stands flat has a patch of its own shape.

use crate::active_pairs::{ActivePair, colliders_of};
use crate::flat_faces::{Face, face};
use crate::pair::{Pair, PreviousStep};
use crate::patch::Patch;
use rapier3d::prelude::*;

/// The coefficient of friction on a ground.
///
/// ```
/// use rapier3d::prelude::*;
/// use tribos_rapier::{GroundMu, PatchContacts};
/// let mut world = PhysicsWorld::new();
/// let floor = world.insert_collider(ColliderBuilder::cuboid(9.0, 0.1, 9.0), None);
/// const RUBBER: u128 = 1;
/// let mu = GroundMu::ByUserData(vec![(RUBBER, 0.9)]); // colliders with `user_data(RUBBER)`
/// let mut patches = PatchContacts::new();
/// patches.insert_ground(floor, mu, &mut world.colliders)?;
/// # Ok::<(), tribos_rapier::PairError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub enum GroundMu {
    /// The `friction` of both colliders, combined by their rules as in Rapier.
    #[default]
    Combined,
    /// One for everything.
    Same(f32),
    /// By the `user_data` of the foot's collider; combined as in Rapier for what the table does not have.
    ByUserData(Vec<(u128, f32)>),
}

/// A collider whose contacts with flat faces have patches.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct Ground {
    pub(crate) collider: ColliderHandle,
    pub(crate) mu: GroundMu,
}

impl GroundMu {
    /// The first value that is not a coefficient of friction.
    pub(crate) fn first_invalid_mu(&self) -> Option<f32> {
        let is_sound = |mu: f32| mu >= 0.0 && mu.is_finite();
        match self {
            Self::Combined => None,
            Self::Same(mu) => Some(*mu).filter(|&mu| !is_sound(mu)),
            Self::ByUserData(table) => {
                let mut values = table.iter().map(|(_, mu)| *mu);
                values.find(|&mu| !is_sound(mu))
            }
        }
    }

    fn of(&self, foot: &Collider, ground: &Collider) -> f32 {
        let of_both = || {
            let mu = CoefficientCombineRule::combine(
                foot.friction(),
                ground.friction(),
                foot.friction_combine_rule(),
                ground.friction_combine_rule(),
            );
            // Colliders take any number.
            if mu > 0.0 && mu.is_finite() { mu } else { 0.0 }
        };
        match self {
            Self::Combined => of_both(),
            Self::Same(mu) => *mu,
            Self::ByUserData(table) => {
                let found = table
                    .iter()
                    .find(|(material, _)| *material == foot.user_data);
                found.map_or_else(of_both, |(_, mu)| *mu)
            }
        }
    }
}

impl Ground {
    /// The face with which `foot` lies on this ground, whose normal points to it. `None` if it stands on an edge
    /// or a corner, or has no flat face.
    pub(crate) fn face<'a>(&self, foot: &'a Collider, normal: Vector) -> Option<Face<'a>> {
        face(foot.shape(), foot.rotation().inverse() * -normal)
    }

    /// The pair of a foot that has come to stand on this ground in the engine's last step.
    pub(crate) fn met(
        &self,
        foot: ColliderHandle,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        narrow_phase: &NarrowPhase,
        dt: f32,
    ) -> Option<Pair> {
        let handles = [foot, self.collider];
        let awake = ActivePair::of(handles, bodies, colliders, narrow_phase)?;
        let touching = awake.touching(self.collider, dt)?;
        let [shape, below] = colliders_of(handles, colliders)?;
        let patch = self.patch(&self.face(shape, touching.normal)?, shape, below)?;
        let mut pair = Pair::new(foot, self.collider, patch.0);
        pair.face = Some(patch.1);
        if awake.has_friction() {
            // The step was the engine's own: the patch begins with the next one.
            pair.known = Some(PreviousStep::new(
                touching,
                None,
                awake.ground.and_then(|handle| bodies.get(handle)),
            ));
            pair.is_next = true;
        }
        Some(pair)
    }

    /// Whether a pair that has its patch from its shape still lies flat; with the patch of another face if it
    /// has turned over.
    pub(crate) fn still(&self, pair: &mut Pair, colliders: &ColliderSet) -> Option<()> {
        let [shape, below] = colliders_of([pair.foot, pair.ground], colliders)?;
        let face = self.face(shape, pair.known?.touching.normal)?;
        if pair.face == Some(face.normal) {
            pair.patch.set_mu(self.mu.of(shape, below));
            return Some(());
        }
        let (patch, normal) = self.patch(&face, shape, below)?;
        (pair.patch, pair.face) = (patch, Some(normal));
        Some(())
    }

    fn patch(&self, face: &Face, foot: &Collider, below: &Collider) -> Option<(Patch, Vector)> {
        let sole = face.sole()?;
        let patch = Patch::new(self.mu.of(foot, below), sole.footprint).ok()?;
        let patch = patch.centered_at(sole.center).along(sole.along);
        Some((patch, face.normal))
    }
}
