//! One foot on one ground, through one step of the engine.
//!
//! The engine's own solver sees the pair without friction. Before its step the motion at the end is
//! foreseen by an implicit step of the kernel and the friction is handed over as a force; after it
//! the same step is taken again with the load and the pushes that the engine has found. What it
//! gives is the motion: at rest that is zero to the last bit.
//!
//! The engine moves a body by its velocity at the end of each of its n substeps, so that a body under
//! constant deceleration goes too far back by half of what a substep takes. The velocity is offset
//! during the step such that the way is that of the mean velocity.

use crate::frame::{Frame, Reduced, motion};
use crate::patch::Patch;
use rapier3d::prelude::*;
use tribos_core::contact::TimeStep;
use tribos_core::planar::PlanarStep;
use tribos_core::twist::{Twist, Wrench};

/// Where the sliding ended within the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Time from the beginning of the step in which the patch came to rest, in seconds.
    pub within_step: f32,
}

/// What a step has shown and the next one foresees with.
#[derive(Clone, Copy, Debug)]
struct Known {
    /// N
    load: f32,
    normal: Vector,
    /// From the centre of mass to the contact, along the normal, in metres.
    depth: f32,
    /// All pushes but friction in the plane, if friction held against them.
    held: Option<Wrench<f32>>,
}

/// What was done before the engine's step.
#[derive(Debug)]
struct Begun {
    frame: Frame,
    reduced: Reduced,
    before: Twist<f32>,
    friction: Wrench<f32>,
    /// Changes of velocity to take back.
    offset: [[Vector; 2]; 2],
    /// Forces that the user had set on the foot and the ground.
    user: [[Vector; 2]; 2],
}

/// A foot on its ground.
#[derive(Debug)]
pub(crate) struct Pair {
    pub(crate) foot: ColliderHandle,
    pub(crate) ground: ColliderHandle,
    pub(crate) patch: Patch,
    known: Option<Known>,
    begun: Option<Begun>,
    pub(crate) friction: Wrench<f32>,
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
            friction: Wrench::ZERO,
            stop: None,
        }
    }

    /// Hands the friction of the coming step to the engine.
    pub(crate) fn begin(
        &mut self,
        gravity: Vector,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        handles: [RigidBodyHandle; 2],
    ) -> Option<()> {
        self.begun = None;
        let known = self.known?;
        let [foot, ground] = handles.map(|handle| &bodies[handle]);
        if foot.is_sleeping() {
            return None;
        }
        let frame = self.frame(known.normal, foot);
        let reduced = Reduced::new(foot, ground, &frame)?;
        let before = relative(&frame, foot, ground);
        let push = known.held.unwrap_or_else(|| {
            let pull = |body: &RigidBody| match body.is_dynamic() {
                true => gravity * body.gravity_scale() + body.user_force() / body.mass(),
                false => Vector::ZERO,
            };
            let force = (pull(foot) - pull(ground)) * reduced.body.mass();
            frame.wrench(force, foot.user_torque())
        });
        let dt = TimeStep::new(parameters.dt).ok()?;
        let foreseen = self
            .patch
            .step(&reduced.body, known.load, &before, &push, dt)?;
        let share = match foreseen.is_at_rest {
            true => self.patch.share(known.load, &foreseen.friction)?,
            false => 1.0,
        };
        let substeps = parameters.num_solver_iterations + foot.additional_solver_iterations();
        let offset = reduced.shared(&offset(&before, &foreseen, share, substeps), &frame);
        let user = [foot, ground].map(|body| [body.user_force(), body.user_torque()]);
        let push = [foreseen.friction.force.x, foreseen.friction.force.y];
        let force = frame.world(push);
        let torque = frame.normal * foreseen.friction.torque;
        let lever = frame.normal * -known.depth;
        for ((handle, sign), velocity) in handles.into_iter().zip([1.0, -1.0]).zip(&offset) {
            let body = &mut bodies[handle];
            if body.is_dynamic() {
                // On the ground the friction acts at the contact, too.
                let arm = if sign > 0.0 { lever } else { Vector::ZERO };
                body.add_force(force * sign, false);
                body.add_torque((torque + arm.cross(force)) * sign, false);
                accelerate(body, velocity, 1.0);
            }
        }
        self.begun = Some(Begun {
            frame,
            reduced,
            before,
            friction: foreseen.friction,
            offset,
            user,
        });
        Some(())
    }

    /// Judges the step by the load and the pushes that the engine has found.
    pub(crate) fn finish(
        &mut self,
        parameters: &IntegrationParameters,
        bodies: &mut RigidBodySet,
        handles: [RigidBodyHandle; 2],
        touching: Option<Touching>,
    ) -> Option<()> {
        self.stop = None;
        let begun = self.begun.take();
        if let Some(begun) = &begun {
            for ((handle, velocity), user) in handles.into_iter().zip(&begun.offset).zip(begun.user)
            {
                let body = &mut bodies[handle];
                if body.is_dynamic() {
                    accelerate(body, velocity, -1.0);
                    body.reset_forces(false);
                    body.reset_torques(false);
                    body.add_force(user[0], false);
                    body.add_torque(user[1], false);
                }
            }
        }
        let [foot, ground] = handles.map(|handle| &bodies[handle]);
        if foot.is_sleeping() {
            return None;
        }
        let touching = touching.or_else(|| {
            // A contact that opened in a step that friction was meant for carries nothing.
            let normal = begun.as_ref()?.frame.normal;
            Some(Touching {
                load: 0.0,
                normal,
                depth: 0.0,
            })
        })?;
        let frame = match &begun {
            Some(begun) => begun.frame,
            None => self.frame(touching.normal, foot),
        };
        let reduced = match &begun {
            Some(begun) => begun.reduced,
            None => Reduced::new(foot, ground, &frame)?,
        };
        let after = relative(&frame, foot, ground);
        let (before, others) = match &begun {
            Some(begun) => (begun.before, others(&reduced, begun, &after, parameters.dt)),
            None => (after, Wrench::ZERO),
        };
        let dt = TimeStep::new(parameters.dt).ok()?;
        let judged = self
            .patch
            .step(&reduced.body, touching.load, &before, &others, dt)?;
        let changes = reduced.shared(&difference(&judged.twist, &after), &frame);
        for (handle, change) in handles.into_iter().zip(&changes) {
            let body = &mut bodies[handle];
            if body.is_dynamic() {
                accelerate(body, change, 1.0);
            }
        }
        let was_held = self.known.is_some_and(|known| known.held.is_some());
        if judged.is_at_rest && !was_held {
            let share = self.patch.share(touching.load, &judged.friction)?;
            self.stop = Some(Stop {
                within_step: share * parameters.dt,
            });
        }
        self.friction = judged.friction;
        self.known = (touching.load > 0.0).then_some(Known {
            load: touching.load,
            normal: touching.normal,
            depth: touching.depth,
            held: judged.is_at_rest.then_some(others),
        });
        Some(())
    }

    fn frame(&self, normal: Vector, foot: &RigidBody) -> Frame {
        let along = self
            .patch
            .is_oriented()
            .then(|| *foot.rotation() * Vector::X);
        Frame::new(normal, along)
    }
}

/// A contact as the engine has left it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touching {
    /// In newtons.
    pub(crate) load: f32,
    /// From the ground to the foot.
    pub(crate) normal: Vector,
    /// From the centre of mass of the foot down to the contact, in metres.
    pub(crate) depth: f32,
}

/// The twist of the foot against the ground.
fn relative(frame: &Frame, foot: &RigidBody, ground: &RigidBody) -> Twist<f32> {
    let [[linear, angular], [_, turn]] = [foot, ground].map(motion);
    let below = ground.velocity_at_point(foot.center_of_mass());
    frame.twist(linear - below, angular - turn)
}

fn difference(to: &Twist<f32>, from: &Twist<f32>) -> Twist<f32> {
    Twist {
        velocity: to.velocity - from.velocity,
        spin: to.spin - from.spin,
    }
}

/// The change of velocity for the time of the step that makes the engine's way that of the mean
/// velocity. Friction that ends the motion takes the given `share` of the step for it.
fn offset(
    before: &Twist<f32>,
    foreseen: &PlanarStep<f32>,
    share: f32,
    substeps: usize,
) -> Twist<f32> {
    let change = difference(&foreseen.twist, before);
    // The mean of the velocities after each of n substeps lies change/(2n) beyond that of start and
    // end; a stop before the end cuts what is left of the way.
    let [late, cut] = [0.5 / substeps as f32, 0.5 * (1.0 - share)];
    Twist {
        velocity: change.velocity * -late - before.velocity * cut,
        spin: change.spin * -late - before.spin * cut,
    }
}

/// The mean of all forces but friction over the step.
fn others(reduced: &Reduced, begun: &Begun, after: &Twist<f32>, dt: f32) -> Wrench<f32> {
    let change = difference(after, &begun.before);
    let Wrench { force, torque } = begun.friction;
    Wrench {
        force: change.velocity * (reduced.body.mass() / dt) - force,
        torque: change.spin * (reduced.body.inertia() / dt) - torque,
    }
}

fn accelerate(body: &mut RigidBody, change: &[Vector; 2], sign: f32) {
    let [linear, angular] = motion(body);
    body.set_linvel(linear + change[0] * sign, false);
    body.set_angvel(angular + change[1] * sign, false);
}
