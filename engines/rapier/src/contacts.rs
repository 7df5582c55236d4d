//! All pairs with a patch, around the engine's step.

use crate::active_pairs::{ActivePair, bodies_of, colliders_of};
use crate::grounds::{Ground, GroundMu};
use crate::group::{self, PendingGroups, StepSettings};
use crate::members::{Member, by_body, index, prepare_groups};
use crate::pair::{Friction, Pair, Stop};
use crate::patch::Patch;
use crate::refusal::{PairError, check};
use crate::temporary_forces::TemporaryForces;
use rapier3d::prelude::*;
use tribos_core::contact::TimeStep;

/// Pairs of colliders whose friction is that of a patch.
///
/// Use [`PatchContacts::step`] instead of [`PhysicsWorld::step`], or with a pipeline of your own
/// [`PatchContacts::begin_step`], the pipeline's step with `self` as hooks, and
/// [`PatchContacts::finish_step`]. Pairs are treated in the order of their handles. Hooks of your own
/// call [`PhysicsHooks::modify_solver_contacts`] of this one.
///
/// ```
/// use rapier3d::prelude::*;
/// use tribos_rapier::{Patch, PatchContacts};
///
/// let mut world = PhysicsWorld::new();
/// world.gravity = Vector::new(0.0, -9.81, 0.0);
/// let table = world.insert_collider(ColliderBuilder::cuboid(2.0, 0.1, 2.0), None);
/// let body = RigidBodyBuilder::dynamic()
///     .translation(Vector::new(0.0, 0.11, 0.0))
///     .linvel(Vector::new(1.0, 0.0, 0.0));
/// let (_, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08).mass(0.17));
///
/// let mut patches = PatchContacts::new();
/// let patch = Patch::disk(0.3, 0.08)?;
/// patches.insert(foot, table, patch, &world.bodies, &mut world.colliders)?;
/// assert_eq!(patches.len(), 1);
/// for _ in 0..10 {
///     patches.step(&mut world);
/// }
/// let friction = patches.friction(foot, table).ok_or("no patch")?; // mu N against the motion
/// assert!((friction.force.x + 0.3 * friction.load).abs() < 1e-3 * friction.load);
/// let stops = (0..60).any(|_| {
///     patches.step(&mut world);
///     patches.stop(foot, table).is_some()
/// });
/// assert!(stops); // v/(mu g) is 0.34 s, 20 steps
/// assert!(patches.remove(foot, table) && patches.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// *State*: results of the last step's contacts are part of the simulation state. To save a game,
/// clone the contacts with the engine's sets, or serialise both (feature `serde-serialize`, the same
/// name as Rapier's), between two steps: the motion then continues with the same bits.
#[derive(Clone, Debug, Default)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct PatchContacts {
    pairs: Vec<Pair>,
    /// Grounds on which feet get patches from their shapes.
    grounds: Vec<Ground>,
    /// Forces and offsets that bodies have received for the current step, group after group.
    lent: Vec<TemporaryForces>,
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pending: PendingGroups,
    /// Memory that each step uses again.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    members: Vec<Member>,
}

impl PatchContacts {
    /// No pairs.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives the contact of `foot` on `ground` a patch that replaces the engine's friction.
    ///
    /// A pair that already has a patch continues with the new one: another floor, swept ice. The colliders'
    /// hook that disables their friction is enabled. The foot's body must be dynamic; a body may have several
    /// feet, which resist together. The ground may be fixed, driven by its velocity, or free to move.
    pub fn insert(
        &mut self,
        foot: ColliderHandle,
        ground: ColliderHandle,
        patch: Patch,
        bodies: &RigidBodySet,
        colliders: &mut ColliderSet,
    ) -> Result<(), PairError> {
        check(foot, ground, bodies, colliders)?;
        for handle in [foot, ground] {
            enable_hooks(handle, colliders)?;
        }
        let pair = Pair::new(foot, ground, patch);
        match self.pairs.binary_search_by_key(&pair.key(), Pair::key) {
            Ok(at) => self.pairs[at].repatch(pair),
            Err(at) => self.pairs.insert(at, pair),
        }
        Ok(())
    }

    /// Returns the pair to the engine's friction; true if it had a patch.
    ///
    /// Forces and velocities of its bodies that were changed for the current step are restored at
    /// the end of the step.
    pub fn remove(&mut self, foot: ColliderHandle, ground: ColliderHandle) -> bool {
        let at = self
            .pairs
            .binary_search_by_key(&key(foot, ground), Pair::key);
        if let Ok(at) = at {
            self.pairs.remove(at);
        }
        at.is_ok()
    }

    /// Gives everything that stands flat on `ground` a patch of its own shape, now and in future.
    ///
    /// A collider of a dynamic body gets a patch when one of its flat faces lies on the ground: the base of a
    /// cylinder or a cone is a disk, the face of a cuboid or of a convex hull a polygon, rounded ones without
    /// their rounding. Everything else is
    /// left to the engine: balls and capsules, bodies on an edge or a corner, cylinders that roll, compound
    /// shapes and meshes. A pair with a patch by [`PatchContacts::insert`] keeps that. The whole face counts, even
    /// where it extends beyond the rim of the ground. A second call exchanges `mu`.
    ///
    /// ```
    /// use rapier3d::prelude::*;
    /// use tribos_rapier::{GroundMu, PatchContacts};
    /// let mut world = PhysicsWorld::new();
    /// world.gravity = Vector::new(0.0, -9.81, 0.0);
    /// let table = world.insert_collider(ColliderBuilder::cuboid(2.0, 0.1, 2.0), None);
    /// let mut patches = PatchContacts::new();
    /// patches.insert_ground(table, GroundMu::Combined, &mut world.colliders)?;
    /// let body = RigidBodyBuilder::dynamic()
    ///     .translation(Vector::new(0.0, 0.11, 0.0))
    ///     .linvel(Vector::new(1.0, 0.0, 0.0));
    /// let (_, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08));
    /// for _ in 0..10 {
    ///     patches.step(&mut world);
    /// }
    /// assert!(patches.friction(foot, table).is_some());
    /// # Ok::<(), tribos_rapier::PairError>(())
    /// ```
    pub fn insert_ground(
        &mut self,
        ground: ColliderHandle,
        mu: GroundMu,
        colliders: &mut ColliderSet,
    ) -> Result<(), PairError> {
        if let Some(given) = mu.first_invalid_mu() {
            return Err(PairError::Coefficient { given });
        }
        enable_hooks(ground, colliders)?;
        self.grounds.retain(|other| other.collider != ground);
        let ground = Ground {
            collider: ground,
            mu,
        };
        self.grounds.push(ground);
        Ok(())
    }

    /// Returns everything on `ground` to the engine's friction, except pairs with patches by
    /// [`PatchContacts::insert`]; true if it was there.
    pub fn remove_ground(&mut self, ground: ColliderHandle) -> bool {
        let before = self.grounds.len();
        self.grounds.retain(|other| other.collider != ground);
        self.pairs
            .retain(|pair| pair.ground != ground || pair.face.is_none());
        self.grounds.len() < before
    }

    /// Number of pairs. Pairs of removed colliders disappear in the next step.
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Whether there are no pairs.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// Advances the world by one step of its own length.
    pub fn step(&mut self, world: &mut PhysicsWorld) {
        self.step_with_events(world, &());
    }

    /// The same with a listener to the engine's events.
    pub fn step_with_events(&mut self, world: &mut PhysicsWorld, events: &dyn EventHandler) {
        let parameters = world.integration_parameters;
        self.begin_step(
            world.gravity,
            &parameters,
            &mut world.bodies,
            &world.colliders,
        );
        world.step_with_events(self, events);
        self.finish_step(
            &parameters,
            &mut world.bodies,
            &world.colliders,
            &world.narrow_phase,
        );
    }

    /// Predicts friction and passes it to the engine, before its step.
    ///
    /// ```
    /// use rapier3d::prelude::*;
    /// use tribos_rapier::{Patch, PatchContacts};
    /// # type Sliding = (PhysicsWorld, RigidBodyHandle, PatchContacts);
    /// # fn sliding() -> Result<Sliding, Box<dyn std::error::Error>> {
    /// # let mut world = PhysicsWorld::new();
    /// # world.gravity = Vector::new(0.0, -9.81, 0.0);
    /// # let table = world.insert_collider(ColliderBuilder::cuboid(2.0, 0.1, 2.0), None);
    /// # let body = RigidBodyBuilder::dynamic()
    /// #     .translation(Vector::new(0.0, 0.11, 0.0))
    /// #     .linvel(Vector::new(1.0, 0.0, 0.0));
    /// # let (puck, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08).mass(0.17));
    /// # let mut patches = PatchContacts::new();
    /// # let patch = Patch::disk(0.3, 0.08)?;
    /// # patches.insert(foot, table, patch, &world.bodies, &mut world.colliders)?;
    /// # Ok((world, puck, patches))
    /// # }
    /// let (mut world, puck, mut patches) = sliding()?;
    /// let (mut other, same_puck, mut same_patches) = sliding()?;
    /// for _ in 0..10 {
    ///     let parameters = world.integration_parameters;
    ///     patches.begin_step(world.gravity, &parameters, &mut world.bodies, &world.colliders);
    ///     world.step_with_events(&patches, &()); // the step of your own pipeline
    ///     let (bodies, colliders) = (&mut world.bodies, &world.colliders);
    ///     patches.finish_step(&parameters, bodies, colliders, &world.narrow_phase);
    ///     same_patches.step_with_events(&mut other, &()); // all three
    /// }
    /// assert!(world.bodies[puck].linvel().x < 1.0);
    /// assert_eq!(world.bodies[puck].linvel(), other.bodies[same_puck].linvel());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn begin_step(
        &mut self,
        gravity: Vector,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        // For a step that was begun and not finished.
        self.cancel_step(bodies);
        let mut members = core::mem::take(&mut self.members);
        self.collect_known(&mut members, bodies, colliders);
        if let Ok(dt) = TimeStep::new(parameters.dt) {
            let settings = StepSettings {
                gravity,
                dt,
                iterations: parameters.num_solver_iterations,
            };
            self.begin_groups(&mut members, &settings, bodies, colliders);
        }
        self.members = members;
    }

    fn begin_groups(
        &mut self,
        mut members: &mut [Member],
        settings: &StepSettings,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let (pairs, pending, lent) = (&self.pairs, &mut self.pending, &mut self.lent);
        while !members.is_empty() {
            let size = prepare_groups(members, bodies);
            let (group, others) = members.split_at_mut(size);
            let from = pending.stands.len();
            if group::begin(group, pairs, settings, bodies, colliders, pending, lent).is_none() {
                pending.stands.truncate(from);
            }
            members = others;
        }
    }

    /// Corrects the motion with the loads that the engine has found, after its step.
    pub fn finish_step(
        &mut self,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
        narrow_phase: &NarrowPhase,
    ) {
        // Restored in the middle of a step: forces are restored, the step is not corrected.
        if self.pending.groups.is_empty() {
            self.cancel_step(bodies);
        }
        if !self.grounds.is_empty() {
            self.add_ground_pairs(bodies, colliders, narrow_phase, parameters.dt);
        }
        let mut members = core::mem::take(&mut self.members);
        self.collect_touching(&mut members, bodies, colliders, narrow_phase, parameters.dt);
        let dt = TimeStep::new(parameters.dt).ok();
        self.finish_begun(&mut members, dt, bodies, colliders);
        members.retain(|member| !member.is_done);
        if let Some(dt) = dt {
            self.finish_new(&mut members, dt, bodies, colliders);
        }
        self.remove_ground_pairs(colliders);
        self.members = members;
    }

    /// Groups that began the step, each with the members of its body. Without `dt` bodies get their forces back only.
    fn finish_begun(
        &mut self,
        mut members: &mut [Member],
        dt: Option<TimeStep<f32>>,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let mut pending = core::mem::take(&mut self.pending);
        let stands = &pending.stands[..];
        for begun in pending.groups.iter().rev() {
            self.undo(begun.lent, bodies);
            let body = index(begun.body);
            let end = members
                .iter()
                .rposition(|member| index(member.body) <= body);
            members = &mut members[..end.map_or(0, |at| at + 1)];
            let others = members.iter().rposition(|member| index(member.body) < body);
            let of_body = &mut members[others.map_or(0, |at| at + 1)..];
            let size = begun.take(of_body, stands, &self.pairs, bodies);
            let (group, pairs) = (&of_body[..size], &mut self.pairs);
            if let Some(dt) = dt {
                group::finish(Some((begun, stands)), group, pairs, dt, bodies, colliders);
            }
        }
        pending.groups.clear();
        pending.stands.clear();
        self.pending = pending;
    }

    /// Contacts that are new in this step.
    fn finish_new(
        &mut self,
        members: &mut [Member],
        dt: TimeStep<f32>,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let mut rest = &mut members[..];
        let mut sizes = Vec::new();
        while !rest.is_empty() {
            let size = prepare_groups(rest, bodies);
            sizes.push(size);
            rest = &mut rest[size..];
        }
        let mut end = members.len();
        for size in sizes.into_iter().rev() {
            let group = &members[end - size..end];
            group::finish(None, group, &mut self.pairs, dt, bodies, colliders);
            end -= size;
        }
    }

    /// Patches for what has come to stand on the grounds.
    fn add_ground_pairs(
        &mut self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        narrow_phase: &NarrowPhase,
        dt: f32,
    ) {
        self.grounds
            .retain(|ground| colliders.contains(ground.collider));
        for ground in &self.grounds {
            for contact in narrow_phase.contact_pairs_with(ground.collider) {
                let foot = match contact.collider1 == ground.collider {
                    true => contact.collider2,
                    false => contact.collider1,
                };
                let key = key(foot, ground.collider);
                let Err(at) = self.pairs.binary_search_by_key(&key, Pair::key) else {
                    continue;
                };
                let met = ground.met(foot, bodies, colliders, narrow_phase, dt);
                if let Some(pair) = met {
                    self.pairs.insert(at, pair);
                }
            }
        }
    }

    /// Drops the patches of what no longer lies flat on its ground.
    fn remove_ground_pairs(&mut self, colliders: &ColliderSet) {
        let grounds = &self.grounds;
        self.pairs.retain_mut(|pair| {
            let of_pair = |ground: &&Ground| ground.collider == pair.ground;
            pair.face.is_none()
                || grounds
                    .iter()
                    .find(of_pair)
                    .is_some_and(|ground| ground.still(pair, colliders).is_some())
        });
    }

    /// Whether a contact without patch will get one from its shape.
    fn is_covered(&self, context: &mut ContactModificationContext) -> bool {
        let both = [context.collider1, context.collider2];
        let of_pair = |ground: &&Ground| both.contains(&ground.collider);
        let Some(ground) = self.grounds.iter().find(of_pair) else {
            return false;
        };
        // The engine's normal points from the first collider to the second.
        let (foot, towards) = match both[0] == ground.collider {
            true => (both[1], 1.0),
            false => (both[0], -1.0),
        };
        let colliders = context.colliders;
        let Some([shape, below]) = colliders_of([foot, ground.collider], colliders) else {
            return false;
        };
        let is_treated = bodies_of(shape, below, context.bodies).is_some();
        let normal = context.rigid_mut().map(|contact| *contact.normal * towards);
        is_treated && normal.is_some_and(|normal| ground.face(shape, normal).is_some())
    }

    /// Undoes the changes of [`begin_step`](Self::begin_step) to bodies, for a step that will not be
    /// taken. The next `begin_step` does the same first.
    ///
    /// ```
    /// use rapier3d::prelude::*;
    /// use tribos_rapier::{Patch, PatchContacts};
    /// # let mut world = PhysicsWorld::new();
    /// # world.gravity = Vector::new(0.0, -9.81, 0.0);
    /// # let table = world.insert_collider(ColliderBuilder::cuboid(2.0, 0.1, 2.0), None);
    /// # let body = RigidBodyBuilder::dynamic()
    /// #     .translation(Vector::new(0.0, 0.11, 0.0))
    /// #     .linvel(Vector::new(1.0, 0.0, 0.0));
    /// # let (puck, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08).mass(0.17));
    /// # let mut patches = PatchContacts::new();
    /// # let patch = Patch::disk(0.3, 0.08)?;
    /// patches.insert(foot, table, patch, &world.bodies, &mut world.colliders)?;
    /// patches.step(&mut world);
    /// let parameters = world.integration_parameters;
    /// patches.begin_step(world.gravity, &parameters, &mut world.bodies, &world.colliders);
    /// assert!(world.bodies[puck].user_force().x < -0.4); // mu N is 0.5 N
    /// patches.cancel_step(&mut world.bodies);
    /// assert_eq!(world.bodies[puck].user_force(), Vector::ZERO);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cancel_step(&mut self, bodies: &mut RigidBodySet) {
        self.undo(self.lent.len(), bodies);
        self.pending.groups.clear();
        self.pending.stands.clear();
    }

    /// Undoes the last `count` changes.
    fn undo(&mut self, count: usize, bodies: &mut RigidBodySet) {
        for _ in 0..count {
            if let Some(lent) = self.lent.pop() {
                lent.restore_forces(bodies);
            }
        }
    }

    /// Pairs that the engine treats and that carried load in the last step, by the handle of the foot's
    /// body. Pairs of removed colliders are dropped.
    fn collect_known(
        &mut self,
        members: &mut Vec<Member>,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
    ) {
        members.clear();
        let mut is_any_gone = false;
        for (number, pair) in self.pairs.iter().enumerate() {
            let Some([foot, ground]) = colliders_of([pair.foot, pair.ground], colliders) else {
                is_any_gone = true;
                continue;
            };
            let Some(known) = pair.known else {
                continue;
            };
            let bodies = bodies_of(foot, ground, bodies);
            if let Some((body, _, ground)) = bodies.filter(|(_, foot, _)| !foot.is_sleeping()) {
                members.push(Member::new(number, body, ground, known.touching));
            }
        }
        if is_any_gone {
            // Indices of pairs change.
            self.pairs
                .retain(|pair| colliders_of([pair.foot, pair.ground], colliders).is_some());
            return self.collect_known(members, bodies, colliders);
        }
        by_body(members);
    }

    /// Pairs that carry load after the engine's step; the others carry nothing.
    fn collect_touching(
        &mut self,
        members: &mut Vec<Member>,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        narrow_phase: &NarrowPhase,
        dt: f32,
    ) {
        members.clear();
        for (number, pair) in self.pairs.iter_mut().enumerate() {
            pair.stop = None;
            if core::mem::take(&mut pair.is_next) {
                continue;
            }
            let Some(awake) =
                ActivePair::of([pair.foot, pair.ground], bodies, colliders, narrow_phase)
            else {
                continue;
            };
            match awake.touching(pair.ground, dt) {
                Some(touching) => {
                    members.push(Member::new(number, awake.body, awake.ground, touching));
                }
                None => {
                    pair.friction = Friction::default();
                    pair.known = None;
                }
            }
        }
        by_body(members);
    }

    /// Friction on the foot in the last step. `None` for a pair without patch.
    pub fn friction(&self, foot: ColliderHandle, ground: ColliderHandle) -> Option<Friction> {
        self.pair(foot, ground).map(|pair| pair.friction)
    }

    /// The end of the pair's motion if it came to rest in the last step.
    pub fn stop(&self, foot: ColliderHandle, ground: ColliderHandle) -> Option<Stop> {
        self.pair(foot, ground)?.stop
    }

    fn pair(&self, a: ColliderHandle, b: ColliderHandle) -> Option<&Pair> {
        let key = key(a, b);
        let at = self.pairs.binary_search_by_key(&key, Pair::key).ok()?;
        self.pairs.get(at)
    }
}

impl PhysicsHooks for PatchContacts {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext) {
        let is_ours = match self.pair(context.collider1, context.collider2) {
            Some(pair) => {
                let both = colliders_of([pair.foot, pair.ground], context.colliders);
                both.is_some_and(|[foot, ground]| bodies_of(foot, ground, context.bodies).is_some())
            }
            None => self.is_covered(context),
        };
        if is_ours && let Some(contact) = context.rigid_mut() {
            *contact.friction = 0.0;
        }
    }
}

/// The same for both orders of two colliders.
type Key = [(u32, u32); 2];

/// Lets the engine ask about the contacts of a collider.
fn enable_hooks(collider: ColliderHandle, colliders: &mut ColliderSet) -> Result<(), PairError> {
    let found = colliders.get_mut(collider);
    let found = found.ok_or(PairError::Missing { collider })?;
    found.set_active_hooks(found.active_hooks() | ActiveHooks::MODIFY_SOLVER_CONTACTS);
    Ok(())
}

fn key(a: ColliderHandle, b: ColliderHandle) -> Key {
    let [a, b] = [a, b].map(ColliderHandle::into_raw_parts);
    [a.min(b), a.max(b)]
}

impl Pair {
    fn key(&self) -> Key {
        key(self.foot, self.ground)
    }
}
