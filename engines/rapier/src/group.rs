//! The feet of one body on the ground, through one step of the engine.
//!
//! The engine's own solver treats the feet as frictionless. Before its step an implicit step of all
//! feet together predicts the motion at the end, and the friction is passed on as a force; after it
//! the same step is repeated with the loads and pushes that the engine has found. Its result is the
//! motion: at rest it is zero to the last bit.

use crate::foot_pose::FootPose;
use crate::frame::{Frame, FrameMotion, relative};
use crate::pair::{ContactLoad, Friction, Pair, PreviousStep, Stop};
use crate::reduced::{accelerate, is_free, reduced};
use crate::temporary_forces::TemporaryForces;
use core::ops::Range;
use rapier3d::prelude::*;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};
use tribos_feet::{Foot, FootFriction, Prediction, Reduced, Standing};

/// Least cosine of the angle between the normals of two feet on one plane.
const ONE_PLANE: f32 = 0.99;

/// A foot of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    /// Index of the pair.
    pub(crate) pair: usize,
    pub(crate) body: RigidBodyHandle,
    /// Body of the ground; a collider without body is at rest.
    pub(crate) ground: Option<RigidBodyHandle>,
    pub(crate) touching: ContactLoad,
    /// Belongs to a group that has been solved.
    pub(crate) is_done: bool,
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
    pub(crate) stands: Range<usize>,
    /// Number of bodies with temporary changes.
    pub(crate) lent: usize,
}

impl PendingPrediction {
    /// Whether a foot belongs to the group, whose feet began at `stands`.
    pub(crate) fn takes(
        &self,
        member: &Member,
        stands: &[FootPose],
        pairs: &[Pair],
        bodies: &RigidBodySet,
    ) -> bool {
        let pair = pairs.get(member.pair);
        let was_here = |pair| stands.iter().any(|stand| stand.is_of(pair));
        member.body == self.body
            && share_motion(member.ground, self.ground, bodies)
            && (pair.is_some_and(was_here)
                || member.touching.normal.dot(self.frame.normal) > ONE_PLANE)
    }
}

/// Joins feet of one body on one plane: on grounds that friction does not move, or on the same one. Brings
/// those that go with the first one of `members` to the front, and returns their number.
///
/// Feet of one body lie next to each other.
pub(crate) fn prepare_groups(members: &mut [Member], bodies: &RigidBodySet) -> usize {
    let Some(body) = members.first().map(|first| first.body) else {
        return 0;
    };
    let mut size = 1;
    for at in 1..members.len() {
        let member = members[at];
        if member.body != body {
            break;
        }
        if members[..size]
            .iter()
            .all(|other| joins(&member, other, bodies))
        {
            members[size..=at].rotate_right(1);
            size += 1;
        }
    }
    size
}

fn joins(one: &Member, other: &Member, bodies: &RigidBodySet) -> bool {
    share_motion(one.ground, other.ground, bodies)
        && one.touching.normal.dot(other.touching.normal) > ONE_PLANE
}

/// Whether both grounds can be treated as one.
fn share_motion(
    one: Option<RigidBodyHandle>,
    other: Option<RigidBodyHandle>,
    bodies: &RigidBodySet,
) -> bool {
    let movable = |ground: Option<RigidBodyHandle>| {
        ground.filter(|&handle| bodies.get(handle).is_some_and(RigidBody::is_dynamic))
    };
    one == other || movable(one) == movable(other)
}

/// The feet of a group on their ground.
fn standing<'a>(
    members: &[Member],
    stands: &[FootPose],
    pairs: &'a [Pair],
    reduced: &'a Reduced,
    drift: impl Fn(&Member) -> [f64; 3],
) -> Option<Standing<'a>> {
    let foot = |(member, stand): (&Member, &FootPose)| {
        let patch = &pairs.get(member.pair)?.patch;
        Some(Foot {
            footprint: patch.footprint(),
            limit: patch.mu() * member.touching.load,
            place: stand.stance.place,
            axis: stand.stance.axis,
            drift: [0.0; 3],
        })
    };
    let coupled = reduced.coupled();
    if let ([member], [stand]) = (members, stands) {
        return Some(Standing::new(
            reduced.body(),
            coupled,
            &[foot((member, stand))?],
        ));
    }
    let with_drift = |both: (&Member, &FootPose)| {
        let drift = drift(both.0);
        Some(Foot {
            drift,
            ..foot(both)?
        })
    };
    let feet: Vec<Foot> = members
        .iter()
        .zip(stands)
        .map(with_drift)
        .collect::<Option<_>>()?;
    Some(Standing::new(reduced.body(), coupled, &feet))
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
    members: &[Member],
    pairs: &[Pair],
    gravity: Vector,
    parameters: &IntegrationParameters,
    bodies: &mut RigidBodySet,
    colliders: &ColliderSet,
    all_stands: &mut Vec<FootPose>,
) -> Option<(PendingPrediction, [Option<TemporaryForces>; 2])> {
    let first = members.first()?;
    let foot = bodies.get(first.body)?;
    let ground = first.ground.and_then(|handle| bodies.get(handle));
    let dt = TimeStep::new(parameters.dt).ok()?;
    let (normal, depth) = mean_contact(members)?;
    let frame = Frame::new(normal);
    let reduced = reduced(foot, ground, &frame)?;
    let before = relative(&frame, foot, ground);
    let extra = |body: &RigidBody| body.additional_solver_iterations();
    let most = extra(foot).max(ground.map_or(0, extra));
    let substeps = (parameters.num_solver_iterations + most).max(1);
    let carried = FrameMotion::over(foot, ground, parameters.dt, substeps);
    let push = expected(gravity, &carried, &reduced, &frame, foot, ground);
    let held = pairs.get(first.pair)?.known.and_then(|known| known.held());
    // The feet at the middle of the step.
    let half_turn = 0.25 * parameters.dt * foot.angvel().dot(normal);
    let from = all_stands.len();
    for member in members {
        let stand = FootPose::now(pairs.get(member.pair)?, &frame, foot, colliders)?;
        all_stands.push(stand.turned(half_turn));
    }
    let stands = from..all_stands.len();
    let drift = |member: &Member| drift(member, &before, &frame, foot, bodies);
    let standing = standing(members, &all_stands[from..], pairs, &reduced, drift)?;
    let step = standing.predict(&before, &push, held, dt, substeps)?;
    let mut offset = step.offset;
    let first_pair = pairs.get(first.pair)?;
    // What is held goes with a ground whose velocity was changed between the steps, and does not slip to reach it.
    if let (Some(known), Some(stops), true) =
        (first_pair.known, step.stops, first_pair.friction.holds)
    {
        let [velocity, spin] = known.jump(ground, foot.center_of_mass());
        offset += frame.twist(velocity, spin) * (0.5 * stops);
    }
    let moved = reduced.moved();
    let mut offsets = reduced.shared(&offset).map(|offset| frame.motion(&offset));
    if moved[0] {
        offsets[0][0] += frame.flat(carried.offset);
    }
    let forces = forces(&step.friction, &frame, depth, foot, ground);
    let handles = [Some(first.body), first.ground];
    let lent = [0, 1].map(|i| {
        let handle = handles[i].filter(|_| moved[i])?;
        TemporaryForces::to(bodies, handle, forces[i], offsets[i])
    });
    let begun = PendingPrediction {
        body: first.body,
        ground: first.ground,
        frame,
        reduced,
        step,
        stands,
        lent: lent.iter().flatten().count(),
    };
    Some((begun, lent))
}

/// Corrects the step with the loads and pushes that the engine has found. Feet of `members` that did
/// not begin the step are taken at their current position.
pub(crate) fn finish(
    begun: Option<(PendingPrediction, &[FootPose])>,
    members: &[Member],
    pairs: &mut [Pair],
    parameters: &IntegrationParameters,
    bodies: &mut RigidBodySet,
    colliders: &ColliderSet,
) -> Option<()> {
    let handles = match (&begun, members.first()) {
        (Some((begun, _)), _) => (begun.body, begun.ground),
        (None, first) => first.map(|first| (first.body, first.ground))?,
    };
    let foot = bodies.get(handles.0).filter(|foot| !foot.is_sleeping())?;
    let ground = handles.1.and_then(|handle| bodies.get(handle));
    let dt = TimeStep::new(parameters.dt).ok()?;
    let (frame, reduced) = match &begun {
        Some((begun, _)) => (begun.frame, begun.reduced),
        None => {
            let frame = Frame::new(mean_contact(members)?.0);
            (frame, reduced(foot, ground, &frame)?)
        }
    };
    let after = relative(&frame, foot, ground);
    let step = begun.as_ref().map(|(begun, _)| &begun.step);
    let stand_of = |member: &Member| {
        let pair = pairs.get(member.pair)?;
        let begun = begun.iter().flat_map(|(_, stands)| *stands);
        let kept = begun.copied().find(|stand| stand.is_of(pair));
        kept.or_else(|| FootPose::now(pair, &frame, foot, colliders))
    };
    let drift = |member: &Member| drift(member, &after, &frame, foot, bodies);
    let on = |stands: &[FootPose]| {
        let standing = standing(members, stands, pairs, &reduced, drift)?;
        let end = standing.correct(step, &after, dt)?;
        let stops = end.ended.is_at_rest() && was_sliding(members, pairs);
        let stop = stops.then(|| Stop {
            within_step: standing.share_until_rest(step, &end) * parameters.dt,
        });
        Some((end, stop))
    };
    let (end, stop) = match members {
        [one] => on(&[stand_of(one)?])?,
        _ => on(&members.iter().map(stand_of).collect::<Option<Vec<_>>>()?)?,
    };
    let changes = reduced.shared(&end.change);
    for (handle, change) in [Some(handles.0), handles.1].into_iter().zip(&changes) {
        let body = handle.and_then(|handle| bodies.get_mut(handle));
        if let Some(body) = body.filter(|body| is_free(body)) {
            accelerate(body, &frame.motion(change), 1.0);
        }
    }
    for (number, member) in members.iter().enumerate() {
        let foot = end.ended.foot(number);
        let ground = member.ground.and_then(|handle| bodies.get(handle));
        let known = PreviousStep::new(member.touching, end.held, ground);
        remember(&mut pairs[member.pair], known, &foot, &frame, stop);
    }
    Some(())
}

/// Whether a foot was not at rest before.
fn was_sliding(members: &[Member], pairs: &[Pair]) -> bool {
    let holds = |member: &Member| {
        pairs
            .get(member.pair)
            .is_some_and(|pair| pair.friction.holds)
    };
    !members.iter().all(holds)
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

/// Motion of a foot relative to its ground minus that of the first foot relative to its own, at the
/// centre of mass.
fn drift(
    member: &Member,
    first: &Twist<f32>,
    frame: &Frame,
    foot: &RigidBody,
    bodies: &RigidBodySet,
) -> [f64; 3] {
    let ground = member.ground.and_then(|handle| bodies.get(handle));
    let drift = relative(frame, foot, ground) - *first;
    [drift.velocity.x, drift.velocity.y, drift.spin].map(f64::from)
}

/// Forces and torques of friction on the foot and the ground, about their centres of mass.
fn forces(
    friction: &Wrench<f32>,
    frame: &Frame,
    depth: f32,
    foot: &RigidBody,
    ground: Option<&RigidBody>,
) -> [[Vector; 2]; 2] {
    let force = frame.world(&friction.force);
    let torque = frame.normal * friction.torque;
    let below = frame.normal * -depth;
    let arm = ground.map_or(Vector::ZERO, |ground| {
        foot.center_of_mass() + below - ground.center_of_mass()
    });
    [
        [force, torque + below.cross(force)],
        [-force, -(torque + arm.cross(force))],
    ]
}

/// Expected push of gravity, the user's forces and the rotation of the ground.
fn expected(
    gravity: Vector,
    carried: &FrameMotion,
    reduced: &Reduced,
    frame: &Frame,
    foot: &RigidBody,
    ground: Option<&RigidBody>,
) -> Wrench<f32> {
    let pull = |body: &RigidBody| match is_free(body) {
        true => gravity * body.gravity_scale() + body.user_force() / body.mass(),
        false => Vector::ZERO,
    };
    let turn = |body: &RigidBody| match is_free(body) {
        true => body.mass_properties().effective_world_inv_inertia * body.user_torque(),
        false => Vector::ZERO,
    };
    let linear = pull(foot) - ground.map_or(Vector::ZERO, pull) - carried.acceleration;
    let angular = turn(foot) - ground.map_or(Vector::ZERO, turn);
    reduced.push(&frame.twist(linear, angular), 1.0)
}
