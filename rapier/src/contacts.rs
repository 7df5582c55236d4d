//! All pairs with a patch, around the engine's step.

use crate::pair::{Friction, Handles, Pair, Stop};
use crate::patch::Patch;
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
/// patches.insert(foot, table, Patch::disk(0.3, 0.08)?, &mut world.colliders);
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
#[derive(Debug, Default)]
pub struct PatchContacts {
    pairs: Vec<Pair>,
}

impl PatchContacts {
    /// No pairs.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives the contact of `foot` on `ground` a patch, in place of the engine's friction.
    ///
    /// A pair that has one already goes on with the new one: another floor, ice that is swept. The
    /// colliders' hook that sets their friction aside is switched on.
    pub fn insert(
        &mut self,
        foot: ColliderHandle,
        ground: ColliderHandle,
        patch: Patch,
        colliders: &mut ColliderSet,
    ) {
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
    }

    /// Gives the pair back to the engine's friction; true if it had a patch.
    pub fn remove(&mut self, foot: ColliderHandle, ground: ColliderHandle) -> bool {
        let at = self
            .pairs
            .binary_search_by_key(&key(foot, ground), Pair::key);
        if let Ok(at) = at {
            self.pairs.remove(at);
        }
        at.is_ok()
    }

    /// How many pairs there are. Pairs of removed colliders leave with the next step.
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// True if there are no pairs.
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

    /// Foresees friction and hands it to the engine, before its step.
    ///
    /// ```
    /// use rapier3d::prelude::*;
    /// use tribos_rapier::{Patch, PatchContacts};
    /// # type Sliding = (PhysicsWorld, RigidBodyHandle, PatchContacts);
    /// # fn sliding() -> Result<Sliding, tribos_rapier::PatchError> {
    /// # let mut world = PhysicsWorld::new();
    /// # world.gravity = Vector::new(0.0, -9.81, 0.0);
    /// # let table = world.insert_collider(ColliderBuilder::cuboid(2.0, 0.1, 2.0), None);
    /// # let body = RigidBodyBuilder::dynamic()
    /// #     .translation(Vector::new(0.0, 0.11, 0.0))
    /// #     .linvel(Vector::new(1.0, 0.0, 0.0));
    /// # let (puck, foot) = world.insert(body, ColliderBuilder::cylinder(0.01, 0.08).mass(0.17));
    /// # let mut patches = PatchContacts::new();
    /// # patches.insert(foot, table, Patch::disk(0.3, 0.08)?, &mut world.colliders);
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
    /// # Ok::<(), tribos_rapier::PatchError>(())
    /// ```
    pub fn begin_step(
        &mut self,
        gravity: Vector,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let is_there =
            |pair: &Pair| colliders.contains(pair.foot) && colliders.contains(pair.ground);
        self.pairs.retain(is_there);
        for pair in &mut self.pairs {
            if let Some(handles) = bodies_of(pair, bodies, colliders) {
                pair.begin(gravity, parameters, bodies, handles);
            }
        }
    }

    /// Corrects the motion by the loads that the engine has found, after its step.
    pub fn finish_step(
        &mut self,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
        narrow_phase: &NarrowPhase,
    ) {
        for pair in self.pairs.iter_mut().rev() {
            if let Some(handles) = bodies_of(pair, bodies, colliders) {
                let foot = bodies.get(handles.0);
                let touching = foot
                    .and_then(|foot| touching(pair, foot, colliders, narrow_phase, parameters.dt));
                pair.finish(parameters, bodies, handles, touching);
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
        if self.pair(context.collider1, context.collider2).is_some()
            && let Some(contact) = context.rigid_mut()
        {
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

/// The bodies of foot and ground, if the engine treats the pair.
fn bodies_of(pair: &Pair, bodies: &RigidBodySet, colliders: &ColliderSet) -> Option<Handles> {
    let [foot, ground] = [pair.foot, pair.ground].map(|handle| colliders.get(handle));
    let (foot, ground) = (foot?, ground?);
    if !(foot.is_enabled() && ground.is_enabled()) {
        return None;
    }
    let is_there = |handle| bodies.get(handle).is_some_and(RigidBody::is_enabled);
    let body = foot.parent().filter(|&handle| is_there(handle))?;
    match ground.parent() {
        Some(below) => (is_there(below) && below != body).then_some((body, Some(below))),
        None => Some((body, None)),
    }
}
