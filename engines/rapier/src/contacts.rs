//! All pairs with a patch, around the engine's step.

use crate::group::{self, Begun, Member};
use crate::handed::Lent;
use crate::pair::{Friction, Pair, Stop, Touching};
use crate::patch::Patch;
use crate::refusal::{PairError, check};
use crate::touching::touching;
use rapier3d::prelude::*;

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
    /// Forces and offsets that each group has received for the current step.
    lent: Vec<Vec<Lent>>,
    /// Prediction for each group.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    begun: Vec<Begun>,
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
            if let Some(collider) = colliders.get_mut(handle) {
                let hooks = collider.active_hooks() | ActiveHooks::MODIFY_SOLVER_CONTACTS;
                collider.set_active_hooks(hooks);
            }
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
        let is_there =
            |pair: &Pair| colliders.contains(pair.foot) && colliders.contains(pair.ground);
        self.pairs.retain(is_there);
        let members = self.members(bodies, colliders, |pair, _| {
            pair.known.map(|known| known.touching)
        });
        for group in group::grouped(members, bodies) {
            let begun = group::begin(&group, &self.pairs, gravity, parameters, bodies, colliders);
            if let Some((begun, lent)) = begun {
                self.begun.push(begun);
                self.lent.push(lent);
            }
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
        if self.begun.len() != self.lent.len() {
            self.cancel_step(bodies);
        }
        let mut members = self.members(bodies, colliders, |pair, foot| {
            touching(pair, foot, colliders, narrow_phase, parameters.dt)
        });
        self.forget_open(&members, bodies, colliders);
        while let (Some(begun), Some(lent)) = (self.begun.pop(), self.lent.pop()) {
            lent.into_iter().for_each(|lent| lent.take_back(bodies));
            let is_of = |member: &mut Member| begun.takes(member, &self.pairs, bodies);
            let group: Vec<Member> = members.extract_if(.., is_of).collect();
            let pairs = &mut self.pairs;
            group::finish(Some(begun), &group, pairs, parameters, bodies, colliders);
        }
        for group in group::grouped(members, bodies).into_iter().rev() {
            group::finish(None, &group, &mut self.pairs, parameters, bodies, colliders);
        }
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
        while let Some(lent) = self.lent.pop() {
            lent.into_iter().for_each(|lent| lent.take_back(bodies));
        }
        self.begun.clear();
    }

    /// Pairs that the engine treats and that touch, by `touching`.
    fn members(
        &self,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        touching: impl Fn(&Pair, &RigidBody) -> Option<Touching>,
    ) -> Vec<Member> {
        let member = |(number, pair): (usize, &Pair)| {
            let (body, ground) = bodies_of(pair, bodies, colliders)?;
            let foot = bodies.get(body).filter(|foot| !foot.is_sleeping())?;
            Some(Member {
                pair: number,
                body,
                ground,
                touching: touching(pair, foot)?,
            })
        };
        self.pairs.iter().enumerate().filter_map(member).collect()
    }

    /// Pairs that no longer touch carry nothing.
    fn forget_open(&mut self, members: &[Member], bodies: &RigidBodySet, colliders: &ColliderSet) {
        for (number, pair) in self.pairs.iter_mut().enumerate() {
            pair.stop = None;
            let handles = bodies_of(pair, bodies, colliders);
            let foot = handles.and_then(|(body, _)| bodies.get(body));
            let is_awake = foot.is_some_and(|foot| !foot.is_sleeping());
            if is_awake && members.iter().all(|member| member.pair != number) {
                pair.friction = Friction::default();
                pair.known = None;
            }
        }
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
        let pair = self.pair(context.collider1, context.collider2);
        let is_ours =
            pair.is_some_and(|pair| bodies_of(pair, context.bodies, context.colliders).is_some());
        if is_ours && let Some(contact) = context.rigid_mut() {
            *contact.friction = 0.0;
        }
    }
}

/// The same for both orders of two colliders.
type Key = [(u32, u32); 2];

fn key(a: ColliderHandle, b: ColliderHandle) -> Key {
    let [a, b] = [a, b].map(ColliderHandle::into_raw_parts);
    [a.min(b), a.max(b)]
}

impl Pair {
    fn key(&self) -> Key {
        key(self.foot, self.ground)
    }
}

/// The bodies of foot and ground, if the engine treats the pair and forces move the foot.
fn bodies_of(
    pair: &Pair,
    bodies: &RigidBodySet,
    colliders: &ColliderSet,
) -> Option<(RigidBodyHandle, Option<RigidBodyHandle>)> {
    let [foot, ground] = [pair.foot, pair.ground].map(|handle| colliders.get(handle));
    let (foot, ground) = (foot?, ground?);
    if !(foot.is_enabled() && ground.is_enabled()) {
        return None;
    }
    let is_there = |handle| bodies.get(handle).is_some_and(RigidBody::is_enabled);
    let is_dynamic = |handle| bodies.get(handle).is_some_and(RigidBody::is_dynamic);
    let body = foot
        .parent()
        .filter(|&handle| is_there(handle) && is_dynamic(handle))?;
    match ground.parent() {
        Some(below) => (is_there(below) && below != body).then_some((body, Some(below))),
        None => Some((body, None)),
    }
}
