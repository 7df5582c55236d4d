//! One foot on one ground, through one step of the engine.
//!
//! The engine's own solver sees the pair without friction. Before its step the motion at the end is
//! foreseen by an implicit step of the kernel and the friction is handed over as a force; after it
//! the same step is taken again with the load and the pushes that the engine has found. What it
//! gives is the motion: at rest that is zero to the last bit.

use crate::frame::{Frame, carried, difference, relative};
use crate::handed::Handed;
use crate::patch::Patch;
use crate::reduced::{Reduced, accelerate, is_free};
use rapier3d::prelude::*;
use tribos_core::contact::TimeStep;
use tribos_core::planar::PlanarStep;
use tribos_core::twist::{Twist, Wrench};

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
/// patches.insert(foot, table, Patch::disk(0.3, 0.08)?, &mut world.colliders);
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
pub struct Friction {
    /// In newtons, in axes of the world, at the contact.
    pub force: Vector,
    /// About the contact's normal, in newton metres, in axes of the world.
    pub torque: Vector,
    /// What presses the foot to the ground, in newtons.
    pub load: f32,
    /// The foot does not move against the ground.
    pub holds: bool,
}

/// Where the sliding ended within the last step.
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
/// patches.insert(foot, table, Patch::disk(0.3, 0.08)?, &mut world.colliders);
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
pub struct Stop {
    /// Time from the beginning of the step in which the patch came to rest, in seconds.
    pub within_step: f32,
}

/// The bodies of a foot and its ground; a collider without body stands still.
pub(crate) type Handles = (RigidBodyHandle, Option<RigidBodyHandle>);

/// A contact as the engine has left it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touching {
    /// In newtons.
    pub(crate) load: f32,
    /// From the ground to the foot.
    pub(crate) normal: Vector,
    /// From the centre of mass of the foot to the contact, against the normal, in metres.
    pub(crate) depth: f32,
}

/// What a step has shown and the next one foresees with.
#[derive(Clone, Copy, Debug)]
struct Known {
    touching: Touching,
    /// Pushes in the plane beyond those expected, if friction held against them.
    held: Option<Wrench<f32>>,
}

/// What was foreseen before the engine's step.
#[derive(Debug)]
struct Begun {
    frame: Frame,
    reduced: Reduced,
    before: Twist<f32>,
    /// Pushes that were expected.
    push: Wrench<f32>,
    friction: Wrench<f32>,
    handed: Handed,
}

/// A foot on its ground.
#[derive(Debug)]
pub(crate) struct Pair {
    pub(crate) foot: ColliderHandle,
    pub(crate) ground: ColliderHandle,
    patch: Patch,
    known: Option<Known>,
    begun: Option<Begun>,
    pub(crate) friction: Friction,
    pub(crate) stop: Option<Stop>,
}

impl Pair {
    pub(crate) fn new(foot: ColliderHandle, ground: ColliderHandle, patch: Patch) -> Self {
        Self {
            foot,
            ground,
            patch,
            known: None,
            begun: None,
            friction: Friction::default(),
            stop: None,
        }
    }

    /// Goes on with the patch of `other`, from what is known of the contact.
    pub(crate) fn repatch(&mut self, other: Self) {
        if self.foot == other.foot {
            self.patch = other.patch;
        } else {
            *self = other;
        }
    }

    /// Hands the friction of the coming step to the engine.
    pub(crate) fn begin(
        &mut self,
        gravity: Vector,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        handles: Handles,
    ) -> Option<()> {
        self.begun = None;
        let known = self.known?;
        let (foot, ground) = looked_up(bodies, handles)?;
        if foot.is_sleeping() {
            return None;
        }
        let frame = self.frame(known.touching.normal, foot);
        let reduced = Reduced::new(foot, ground, &frame)?;
        let before = relative(&frame, foot, ground);
        let push = expected(gravity, &reduced, &frame, foot, ground);
        let pushed = known.held.map_or(push, |held| sum(&push, &held));
        // The motion at the end, and the part of the step that it takes to stop.
        let dt = TimeStep::new(parameters.dt).ok()?;
        let load = known.touching.load;
        let foreseen = self.patch.step(&reduced.body, load, &before, &pushed, dt)?;
        let share = match foreseen.is_at_rest && !is_zero(&before) {
            true => self.patch.share(load, &foreseen.friction, &before)?,
            false => 1.0,
        };
        let extra = |body: &RigidBody| body.additional_solver_iterations();
        let most = extra(foot).max(ground.map_or(0, extra));
        let substeps = (parameters.num_solver_iterations + most).max(1);
        let mut offset = reduced.shared(&offset(&before, &foreseen, share, substeps), &frame);
        let turned = frame.flat(carried(foot, ground)) * parameters.dt;
        if reduced.moved[0] {
            offset[0][0] -= turned * (0.5 / substeps as f32);
        }
        // The force acts at the contact; a ground takes it at its centre of mass.
        let force = frame.world(&foreseen.friction.force);
        let torque = frame.normal * foreseen.friction.torque;
        let lever = (frame.normal * -known.touching.depth).cross(force);
        let forces = [[force, torque + lever], [-force, -torque]];
        let handed = Handed::over(bodies, handles, reduced.moved, forces, offset);
        self.begun = Some(Begun {
            frame,
            reduced,
            before,
            push,
            friction: foreseen.friction,
            handed,
        });
        Some(())
    }

    /// Judges the step by the load and the pushes that the engine has found.
    pub(crate) fn finish(
        &mut self,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        handles: Handles,
        touching: Option<Touching>,
    ) -> Option<()> {
        self.stop = None;
        let begun = self.begun.take();
        if let Some(begun) = &begun {
            begun.handed.taken_back(bodies, handles);
        }
        let (foot, ground) = looked_up(bodies, handles)?;
        if foot.is_sleeping() {
            return None;
        }
        let Some(touching) = touching.or_else(|| open(begun.as_ref()?)) else {
            self.friction = Friction::default();
            return None;
        };
        let dt = TimeStep::new(parameters.dt).ok()?;
        let (frame, reduced) = match &begun {
            Some(begun) => (begun.frame, begun.reduced),
            None => {
                let frame = self.frame(touching.normal, foot);
                (frame, Reduced::new(foot, ground, &frame)?)
            }
        };
        let after = relative(&frame, foot, ground);
        // All pushes but friction, as their mean over the step, and what of them was expected.
        let (before, others, push) = match &begun {
            Some(begun) => {
                let all = reduced.push(&difference(&after, &begun.before), parameters.dt);
                (begun.before, without(&all, &begun.friction), begun.push)
            }
            None => (after, Wrench::ZERO, Wrench::ZERO),
        };
        let judged = self
            .patch
            .step(&reduced.body, touching.load, &before, &others, dt)?;
        let changes = reduced.shared(&difference(&judged.twist, &after), &frame);
        for (handle, change) in [Some(handles.0), handles.1].into_iter().zip(&changes) {
            let body = handle.and_then(|handle| bodies.get_mut(handle));
            if let Some(body) = body.filter(|body| is_free(body)) {
                accelerate(body, change, 1.0);
            }
        }
        self.stop = match judged.is_at_rest && touching.load > 0.0 && !self.friction.holds {
            true => {
                let share = self.patch.share(touching.load, &judged.friction, &before)?;
                Some(Stop {
                    within_step: share * parameters.dt,
                })
            }
            false => None,
        };
        self.remember(&frame, touching, &judged, without(&others, &push));
        Some(())
    }

    fn remember(
        &mut self,
        frame: &Frame,
        touching: Touching,
        judged: &PlanarStep<f32>,
        unexpected: Wrench<f32>,
    ) {
        let touches = touching.load > 0.0;
        self.friction = Friction {
            force: frame.world(&judged.friction.force),
            torque: frame.normal * judged.friction.torque,
            load: touching.load,
            holds: touches && judged.is_at_rest,
        };
        self.known = touches.then_some(Known {
            touching,
            held: judged.is_at_rest.then_some(unexpected),
        });
    }

    fn frame(&self, normal: Vector, foot: &RigidBody) -> Frame {
        let along = self
            .patch
            .is_oriented()
            .then(|| *foot.rotation() * Vector::X);
        Frame::new(normal, along)
    }
}

fn looked_up(bodies: &RigidBodySet, handles: Handles) -> Option<(&RigidBody, Option<&RigidBody>)> {
    let ground = handles.1.and_then(|handle| bodies.get(handle));
    Some((bodies.get(handles.0)?, ground))
}

/// A contact that opened in a step that friction was meant for: it carries nothing.
fn open(begun: &Begun) -> Option<Touching> {
    Some(Touching {
        load: 0.0,
        normal: begun.frame.normal,
        depth: 0.0,
    })
}

/// What gravity, the forces of the user and the turning of the ground will push.
fn expected(
    gravity: Vector,
    reduced: &Reduced,
    frame: &Frame,
    foot: &RigidBody,
    ground: Option<&RigidBody>,
) -> Wrench<f32> {
    let pull = |body: &RigidBody| match is_free(body) {
        true => gravity * body.gravity_scale() + body.user_force() / body.mass(),
        false => Vector::ZERO,
    };
    let relative = pull(foot) - ground.map_or(Vector::ZERO, pull) - carried(foot, ground);
    frame.wrench(relative * reduced.body.mass(), foot.user_torque())
}

/// The change of velocity for the time of the step that makes the engine's way that of the mean
/// velocity.
///
/// The engine moves a body by its velocity at the end of each of its n substeps, so that a body under
/// constant deceleration is late by half of what a substep takes. Friction that ends the motion needs
/// the given `share` of the step for it, and what is left of the way is cut.
fn offset(
    before: &Twist<f32>,
    foreseen: &PlanarStep<f32>,
    share: f32,
    substeps: usize,
) -> Twist<f32> {
    let change = difference(&foreseen.twist, before);
    let [late, cut] = [0.5 / substeps as f32, 0.5 * (1.0 - share)];
    Twist {
        velocity: change.velocity * -late - before.velocity * cut,
        spin: change.spin * -late - before.spin * cut,
    }
}

fn is_zero(twist: &Twist<f32>) -> bool {
    *twist == Twist::new(0.0, 0.0, 0.0)
}

fn sum(one: &Wrench<f32>, other: &Wrench<f32>) -> Wrench<f32> {
    Wrench {
        force: one.force + other.force,
        torque: one.torque + other.torque,
    }
}

fn without(sum: &Wrench<f32>, part: &Wrench<f32>) -> Wrench<f32> {
    Wrench {
        force: sum.force - part.force,
        torque: sum.torque - part.torque,
    }
}
