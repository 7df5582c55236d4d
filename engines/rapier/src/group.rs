//! The feet of one body on the ground, through one step of the engine.
//!
//! The engine's own solver treats the feet as frictionless. Before its step an implicit step of all
//! feet together predicts the motion at the end, and the friction is passed on as a force; after it
//! the same step is repeated with the loads and pushes that the engine has found. Its result is the
//! motion: at rest it is zero to the last bit.

use crate::foot_pose::FootPose;
use crate::frame::{Frame, FrameMotion, relative};
use crate::members::{Member, bring_forward, is_one_plane, share_motion};
use crate::pair::{Friction, Pair, PreviousStep, Stop};
use crate::reduced::{accelerate, is_free, reduced};
use crate::temporary_forces::TemporaryForces;
use core::ops::Range;
use rapier3d::prelude::*;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};
use tribos_feet::{Foot, FootFriction, Prediction, Reduced, Stance, Standing};

/// What all groups of a step have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepSettings {
    pub(crate) gravity: Vector,
    pub(crate) dt: TimeStep<f32>,
    /// The engine's substeps, without those that a body asks for.
    pub(crate) iterations: usize,
}

/// Groups that have begun the step, in the order of their bodies.
#[derive(Clone, Debug, Default)]
pub(crate) struct PendingGroups {
    pub(crate) groups: Vec<PendingPrediction>,
    /// Positions of their feet.
    pub(crate) stands: Vec<FootPose>,
}

/// Prediction made before the engine's step.
#[derive(Clone, Debug)]
pub(crate) struct PendingPrediction {
    pub(crate) body: RigidBodyHandle,
    /// The body of the first foot's ground.
    ground: Option<RigidBodyHandle>,
    frame: Frame,
    reduced: Reduced,
    step: Prediction,
    /// The positions of its feet in the list of all.
    stands: Range<usize>,
    /// Number of bodies with temporary changes.
    pub(crate) lent: usize,
}

impl PendingPrediction {
    /// Brings the feet of its body that belong to the group to the front of `members`, and returns their number.
    pub(crate) fn take(
        &self,
        members: &mut [Member],
        stands: &[FootPose],
        pairs: &[Pair],
        bodies: &RigidBodySet,
    ) -> usize {
        let mut size = 0;
        for at in 0..members.len() {
            if self.takes(&mut members[at], stands, pairs, bodies) {
                bring_forward(members, at, &mut size);
            }
        }
        size
    }

    /// Whether a foot belongs to the group; finds where it began among the positions of all feet.
    fn takes(
        &self,
        member: &mut Member,
        stands: &[FootPose],
        pairs: &[Pair],
        bodies: &RigidBodySet,
    ) -> bool {
        if member.is_done
            || member.body != self.body
            || !share_motion(member.ground, self.ground, bodies)
        {
            return false;
        }
        let pair = &pairs[member.pair];
        member.stand = self.stands.clone().find(|&at| stands[at].is_of(pair));
        member.is_done =
            member.stand.is_some() || is_one_plane(member.touching.normal, self.frame.normal);
        member.is_done
    }
}

/// The feet of a group on their ground.
fn standing<'a>(
    members: &[Member],
    stand_of: impl Fn(&Member) -> Option<Stance>,
    pairs: &'a [Pair],
    reduced: &'a Reduced,
    drift: impl Fn(&Member) -> [f64; 3],
) -> Option<Standing<'a>> {
    let foot = |member: &Member, drift: [f64; 3]| {
        let patch = &pairs[member.pair].patch;
        let stance = stand_of(member)?;
        Some(Foot {
            footprint: patch.footprint(),
            limit: patch.mu() * member.touching.load,
            place: stance.place,
            axis: stance.axis,
            drift,
        })
    };
    let (body, coupled) = (reduced.body(), reduced.coupled());
    if let [member] = members {
        let alone = [foot(member, [0.0; 3])?];
        return Some(Standing::new(body, coupled, &alone));
    }
    let feet = members.iter().map(|member| foot(member, drift(member)));
    let feet: Vec<Foot> = feet.collect::<Option<_>>()?;
    Some(Standing::new(body, coupled, &feet))
}

/// Mean normal and depth of some contacts, weighted by load.
fn mean_contact(members: &[Member]) -> Option<(Vector, f32)> {
    if let [one] = members {
        return Some((one.touching.normal, one.touching.depth));
    }
    let (mut normal, mut depth, mut load) = (Vector::ZERO, 0.0, 0.0);
    for Member { touching, .. } in members {
        normal += touching.normal * touching.load;
        depth += touching.depth * touching.load;
        load += touching.load;
    }
    let size = normal.length();
    (size > 0.0 && size.is_finite()).then(|| (normal / size, depth / load))
}

/// Passes the friction of the coming step to the engine.
pub(crate) fn begin(
    members: &mut [Member],
    pairs: &[Pair],
    settings: &StepSettings,
    bodies: &mut RigidBodySet,
    colliders: &ColliderSet,
    pending: &mut PendingGroups,
    lent: &mut Vec<TemporaryForces>,
) -> Option<()> {
    let first = members.first()?;
    let (pair, body, below) = (first.pair, first.body, first.ground);
    let first_pair = &pairs[pair];
    let foot = bodies.get(body)?;
    let ground = below.and_then(|handle| bodies.get(handle));
    let dt = settings.dt;
    let (normal, depth) = mean_contact(members)?;
    let frame = Frame::new(normal);
    let reduced = reduced(foot, ground, &frame)?;
    let before = relative(&frame, foot, ground);
    let extra = |body: &RigidBody| body.additional_solver_iterations();
    let most = extra(foot).max(ground.map_or(0, extra));
    let substeps = (settings.iterations + most).max(1);
    let turning = ground.filter(|ground| ground.angvel() != Vector::ZERO);
    let carried = turning.map(|ground| FrameMotion::over(foot, ground, dt.dt(), substeps));
    let push = expected(
        settings.gravity,
        carried.as_ref(),
        &reduced,
        &frame,
        foot,
        ground,
    );
    let known = first_pair.known.as_ref();
    let held = known.and_then(PreviousStep::held);
    // The feet at the middle of the step.
    let half_turn = 0.25 * dt.dt() * foot.angvel().dot(normal);
    let from = pending.stands.len();
    for member in &mut *members {
        let stand = FootPose::now(&pairs[member.pair], &frame, foot, colliders)?;
        member.stand = Some(pending.stands.len());
        pending.stands.push(stand.turned(half_turn));
    }
    let stands = from..pending.stands.len();
    let stand_of = |member: &Member| Some(pending.stands[member.stand?].stance);
    let drift = |member: &Member| drift(member, below, &before, &frame, foot, bodies);
    let standing = standing(members, stand_of, pairs, &reduced, drift)?;
    let step = standing.predict(&before, &push, held, dt, substeps)?;
    let mut offset = step.offset;
    // What is held goes with a ground whose velocity was changed between the steps, and does not slip to reach it.
    if let (Some(known), Some(stops), true) = (known, step.stops, first_pair.friction.holds)
        && let Some([velocity, spin]) = known.jump(ground, foot.center_of_mass())
    {
        offset += frame.twist(velocity, spin) * (0.5 * stops);
    }
    let moved = reduced.moved();
    let [of_foot, of_ground] = reduced.shared(&offset);
    // Forces of friction at the contact, with their torques about both centres of mass.
    let force = frame.world(&step.friction.force);
    let torque = normal * step.friction.torque;
    let down = normal * -depth;
    let arm = ground.map(|ground| foot.center_of_mass() + down - ground.center_of_mass());
    let before = lent.len();
    if moved[0] {
        let mut offset = frame.motion(&of_foot);
        if let Some(carried) = carried {
            offset[0] += frame.flat(carried.offset);
        }
        let on_foot = [force, torque + down.cross(force)];
        TemporaryForces::lend(bodies, body, on_foot, offset, lent);
    }
    if let (Some(handle), Some(arm), true) = (below, arm, moved[1]) {
        let on_ground = [-force, -(torque + arm.cross(force))];
        let offset = frame.motion(&of_ground);
        TemporaryForces::lend(bodies, handle, on_ground, offset, lent);
    }
    pending.groups.push(PendingPrediction {
        body,
        ground: below,
        frame,
        reduced,
        step,
        stands,
        lent: lent.len() - before,
    });
    Some(())
}

/// Corrects the step with the loads and pushes that the engine has found. Feet of `members` that did
/// not begin the step are taken at their current position.
pub(crate) fn finish(
    begun: Option<(&PendingPrediction, &[FootPose])>,
    members: &[Member],
    pairs: &mut [Pair],
    dt: TimeStep<f32>,
    bodies: &mut RigidBodySet,
    colliders: &ColliderSet,
) -> Option<()> {
    let (body, below) = match (begun, members.first()) {
        (Some((begun, _)), _) => (begun.body, begun.ground),
        (None, first) => first.map(|first| (first.body, first.ground))?,
    };
    let foot = bodies.get(body).filter(|foot| !foot.is_sleeping())?;
    let ground = below.and_then(|handle| bodies.get(handle));
    let new;
    let (frame, reduced) = match begun {
        Some((begun, _)) => (&begun.frame, &begun.reduced),
        None => {
            let frame = Frame::new(mean_contact(members)?.0);
            new = (frame, reduced(foot, ground, &frame)?);
            (&new.0, &new.1)
        }
    };
    let after = relative(frame, foot, ground);
    let step = begun.map(|(begun, _)| &begun.step);
    let stands = begun.map_or(&[][..], |(_, stands)| stands);
    let stand_of = |member: &Member| match member.stand {
        Some(kept) => Some(stands[kept].stance),
        None => Some(FootPose::now(&pairs[member.pair], frame, foot, colliders)?.stance),
    };
    let drift = |member: &Member| drift(member, below, &after, frame, foot, bodies);
    let standing = standing(members, stand_of, pairs, reduced, drift)?;
    let end = standing.correct(step, &after, dt)?;
    let stops = end.ended.is_at_rest() && was_sliding(members, pairs);
    let stop = stops.then(|| Stop {
        within_step: standing.share_until_rest(step, &end) * dt.dt(),
    });
    let changes = reduced.shared(&end.change);
    let moved = [Some(body), below.filter(|_| reduced.moved()[1])];
    for (handle, change) in moved.into_iter().zip(&changes) {
        let body = handle.and_then(|handle| bodies.get_mut(handle));
        if let Some(body) = body.filter(|body| is_free(body)) {
            accelerate(body, &frame.motion(change), 1.0);
        }
    }
    for (number, member) in members.iter().enumerate() {
        let foot = end.ended.foot(number);
        let ground = member.ground.and_then(|handle| bodies.get(handle));
        let known = PreviousStep::new(member.touching, end.held, ground);
        remember(&mut pairs[member.pair], known, &foot, frame, stop);
    }
    Some(())
}

/// Whether a foot was not at rest before.
fn was_sliding(members: &[Member], pairs: &[Pair]) -> bool {
    !members
        .iter()
        .all(|member| pairs[member.pair].friction.holds)
}

/// Stores the results of a step for a foot.
fn remember(
    pair: &mut Pair,
    known: PreviousStep,
    foot: &FootFriction,
    frame: &Frame,
    stop: Option<Stop>,
) {
    let FootFriction { wrench, holds } = *foot;
    pair.stop = stop.filter(|_| !pair.friction.holds);
    pair.friction = Friction {
        force: frame.world(&wrench.force),
        torque: frame.normal * wrench.torque,
        load: known.touching.load,
        holds,
    };
    pair.known = Some(known);
}

/// Motion of a foot relative to its ground minus that of the first foot relative to its own, which is on the ground
/// `below`, at the centre of mass.
fn drift(
    member: &Member,
    below: Option<RigidBodyHandle>,
    first: &Twist<f32>,
    frame: &Frame,
    foot: &RigidBody,
    bodies: &RigidBodySet,
) -> [f64; 3] {
    if member.ground == below {
        return [0.0; 3];
    }
    let ground = member.ground.and_then(|handle| bodies.get(handle));
    let drift = relative(frame, foot, ground) - *first;
    [drift.velocity.x, drift.velocity.y, drift.spin].map(f64::from)
}

/// Expected push of gravity, the user's forces and the rotation of the ground.
fn expected(
    gravity: Vector,
    carried: Option<&FrameMotion>,
    reduced: &Reduced,
    frame: &Frame,
    foot: &RigidBody,
    ground: Option<&RigidBody>,
) -> Wrench<f32> {
    let [mut linear, mut angular] = free_acceleration(gravity, foot);
    if let Some(ground) = ground {
        let [pull, turn] = free_acceleration(gravity, ground);
        linear -= pull;
        angular -= turn;
    }
    if let Some(carried) = carried {
        linear -= carried.acceleration;
    }
    reduced.push(&frame.twist(linear, angular), 1.0)
}

/// Linear and angular acceleration of a body by gravity and the user's forces.
fn free_acceleration(gravity: Vector, body: &RigidBody) -> [Vector; 2] {
    if !is_free(body) {
        return [Vector::ZERO; 2];
    }
    // Most bodies have none.
    let some = |by_user: Vector| (by_user != Vector::ZERO).then_some(by_user);
    let pull = some(body.user_force()).map_or(Vector::ZERO, |force| force / body.mass());
    let turn = some(body.user_torque()).map_or(Vector::ZERO, |torque| {
        body.mass_properties().effective_world_inv_inertia * torque
    });
    [gravity * body.gravity_scale() + pull, turn]
}
