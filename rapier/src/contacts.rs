//! All pairs with a patch, around the engine's step.

use crate::pair::{Pair, Stop, Touching};
use crate::patch::Patch;
use rapier3d::prelude::*;
use tribos_core::twist::Wrench;

/// Pairs of colliders whose friction is that of a patch.
///
/// Use [`PatchContacts::step`] instead of [`PhysicsWorld::step`], or with a pipeline of your own
/// [`PatchContacts::begin_step`], the pipeline's step with `self` as hooks, and
/// [`PatchContacts::finish_step`]. Pairs are treated in the order in which they were inserted.
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
    /// A pair that has one already gets the new one. The colliders' hook that sets their friction
    /// aside is switched on.
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
        self.remove(foot, ground);
        self.pairs.push(Pair::new(foot, ground, patch));
    }

    /// Gives the pair back to the engine's friction; true if it had a patch.
    pub fn remove(&mut self, foot: ColliderHandle, ground: ColliderHandle) -> bool {
        let before = self.pairs.len();
        self.pairs.retain(|pair| !pair.is_of(foot, ground));
        self.pairs.len() < before
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
    pub fn begin_step(
        &mut self,
        gravity: Vector,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
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
                let touching = touching(
                    pair,
                    &bodies[handles[0]],
                    colliders,
                    narrow_phase,
                    parameters.dt,
                );
                pair.finish(parameters, bodies, handles, touching);
            }
        }
    }

    /// Friction on the foot in the last step, as force and torque about the normal, in axes of the
    /// contact. `None` for a pair without patch.
    pub fn friction(&self, foot: ColliderHandle, ground: ColliderHandle) -> Option<Wrench<f32>> {
        self.pair(foot, ground).map(|pair| pair.friction)
    }

    /// The end of the pair's motion if it came to rest in the last step.
    pub fn stop(&self, foot: ColliderHandle, ground: ColliderHandle) -> Option<Stop> {
        self.pair(foot, ground)?.stop
    }

    fn pair(&self, a: ColliderHandle, b: ColliderHandle) -> Option<&Pair> {
        self.pairs.iter().find(|pair| pair.is_of(a, b))
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

impl Pair {
    fn is_of(&self, a: ColliderHandle, b: ColliderHandle) -> bool {
        [self.foot, self.ground] == [a, b] || [self.foot, self.ground] == [b, a]
    }
}

/// The bodies of foot and ground, if both are still there.
fn bodies_of(
    pair: &Pair,
    bodies: &RigidBodySet,
    colliders: &ColliderSet,
) -> Option<[RigidBodyHandle; 2]> {
    let [foot, ground] = [pair.foot, pair.ground].map(|handle| colliders.get(handle)?.parent());
    let (foot, ground) = (foot?, ground?);
    (bodies.contains(foot) && bodies.contains(ground) && foot != ground).then_some([foot, ground])
}

/// The pair's contact after a step of length `dt`; `None` if nothing pushed.
fn touching(
    pair: &Pair,
    foot: &RigidBody,
    colliders: &ColliderSet,
    narrow_phase: &NarrowPhase,
    dt: f32,
) -> Option<Touching> {
    let contact = narrow_phase.contact_pair(pair.foot, pair.ground)?;
    let collider = colliders.get(pair.foot)?;
    // The engine's normal points from the first collider to the second.
    let is_second = contact.collider1 == pair.ground;
    let mut impulse = Vector::ZERO;
    let mut moment = Vector::ZERO;
    for manifold in contact.manifolds() {
        let normal = manifold.data.normal * if is_second { 1.0 } else { -1.0 };
        // Points that the solver did not see keep the impulse of an earlier step.
        for solved in manifold.data.solver_contacts.iter() {
            let [index] = solved.contact_indices();
            let Some(point) = manifold.points.get(index as usize) else {
                continue;
            };
            let local = if is_second {
                point.local_p2
            } else {
                point.local_p1
            };
            let arm = collider.position().transform_point(local) - foot.center_of_mass();
            impulse += normal * point.data.impulse;
            moment += arm * point.data.impulse;
        }
    }
    let size = impulse.length();
    if !(size > 0.0) {
        return None;
    }
    let normal = impulse / size;
    Some(Touching {
        load: size / dt,
        normal,
        depth: -moment.dot(normal) / size,
    })
}
