//! The feet of one body on the ground, through one step of the engine.
//!
//! The engine's own solver treats the feet as frictionless. Before its step an implicit step of all
//! feet together predicts the motion at the end, and the friction is passed on as a force; after it
//! the same step is repeated with the loads and pushes that the engine has found. Its result is the
//! motion: at rest it is zero to the last bit.

use crate::feet::Solved;
use crate::frame::{Frame, carried, relative};
use crate::handed::Lent;
use crate::judge::Judge;
use crate::pair::{Friction, Known, Pair, Stop, Touching};
use crate::reduced::{Reduced, accelerate, is_free};
use crate::stand::Stand;
use rapier3d::prelude::*;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};

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
    pub(crate) touching: Touching,
}

/// Prediction made before the engine's step.
#[derive(Clone, Debug)]
pub(crate) struct Begun {
    pub(crate) body: RigidBodyHandle,
    /// The body of the first foot's ground.
    pub(crate) ground: Option<RigidBodyHandle>,
    pub(crate) frame: Frame,
    reduced: Reduced,
    before: Twist<f32>,
    /// Pushes that were expected.
    push: Wrench<f32>,
    friction: Wrench<f32>,
    pub(crate) stands: Vec<Stand>,
}

impl Begun {
    /// Whether a foot belongs to the group.
    pub(crate) fn takes(&self, member: &Member, pairs: &[Pair], bodies: &RigidBodySet) -> bool {
        let pair = pairs.get(member.pair);
        let was_here = |pair| self.stands.iter().any(|stand| stand.is_of(pair));
        member.body == self.body
            && share_motion(member.ground, self.ground, bodies)
            && (pair.is_some_and(was_here)
                || member.touching.normal.dot(self.frame.normal) > ONE_PLANE)
    }
}

/// Joins feet of one body on one plane: on grounds that friction does not move, or on the same one.
pub(crate) fn grouped(members: Vec<Member>, bodies: &RigidBodySet) -> Vec<Vec<Member>> {
    let mut groups: Vec<Vec<Member>> = Vec::new();
    for member in members {
        let fits = |group: &Vec<Member>| group.iter().all(|other| joins(&member, other, bodies));
        match groups.iter_mut().find(|group| fits(group)) {
            Some(group) => group.push(member),
            None => groups.push(vec![member]),
        }
    }
    groups
}

fn joins(one: &Member, other: &Member, bodies: &RigidBodySet) -> bool {
    one.body == other.body
        && share_motion(one.ground, other.ground, bodies)
        && one.touching.normal.dot(other.touching.normal) > ONE_PLANE
}

/// Whether both grounds can be treated as one.
pub(crate) fn share_motion(
    one: Option<RigidBodyHandle>,
    other: Option<RigidBodyHandle>,
    bodies: &RigidBodySet,
) -> bool {
    let movable = |ground: Option<RigidBodyHandle>| {
        ground.filter(|&handle| bodies.get(handle).is_some_and(RigidBody::is_dynamic))
    };
    movable(one) == movable(other)
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
) -> Option<(Begun, Vec<Lent>)> {
    let first = members.first()?;
    let foot = bodies.get(first.body)?;
    let ground = first.ground.and_then(|handle| bodies.get(handle));
    let dt = TimeStep::new(parameters.dt).ok()?;
    let (normal, depth) = mean_contact(members)?;
    let frame = Frame::new(normal);
    let reduced = Reduced::new(foot, ground, &frame)?;
    let before = relative(&frame, foot, ground);
    let push = expected(gravity, &reduced, &frame, foot, ground);
    let held = pairs.get(first.pair)?.known.and_then(|known| known.held());
    let pushed = held.map_or(push, |held| push + held);
    // The feet at the middle of the step.
    let half_turn = 0.25 * parameters.dt * foot.angvel().dot(normal);
    let stand = |member: &Member| {
        let pair = pairs.get(member.pair)?;
        Stand::now(pair, &frame, foot, colliders).map(|stand| stand.turned(half_turn))
    };
    let stands: Vec<Stand> = members.iter().map(stand).collect::<Option<_>>()?;
    let drift = |member: &Member| drift(member, &before, &frame, foot, bodies);
    let judge = Judge {
        pairs,
        members,
        stands: &stands,
        drifts: members.iter().map(drift).collect(),
        reduced: &reduced,
    };
    // The motion at the end, and the part of the step that it takes to stop.
    let foreseen = judge.step(&before, &pushed, dt)?;
    let share = match foreseen.is_at_rest() && !is_zero(&before) {
        true => judge.share(&foreseen, &before)?,
        false => 1.0,
    };
    let extra = |body: &RigidBody| body.additional_solver_iterations();
    let most = extra(foot).max(ground.map_or(0, extra));
    let substeps = (parameters.num_solver_iterations + most).max(1);
    let mut offsets = reduced.shared(&offset(&before, &foreseen.twist, share, substeps), &frame);
    let turned = frame.flat(carried(foot, ground)) * parameters.dt;
    if reduced.moved[0] {
        offsets[0][0] -= turned * (0.5 / substeps as f32);
    }
    let forces = forces(&foreseen.friction, &frame, depth, foot, ground);
    let handles = [Some(first.body), first.ground];
    let begun = Begun {
        body: first.body,
        ground: first.ground,
        frame,
        reduced,
        before,
        push,
        friction: foreseen.friction,
        stands,
    };
    let lend = |i: usize| {
        let handle = handles[i].filter(|_| begun.reduced.moved[i])?;
        Lent::to(bodies, handle, forces[i], offsets[i])
    };
    let lent = [0, 1].into_iter().filter_map(lend).collect();
    Some((begun, lent))
}

/// Corrects the step with the loads and pushes that the engine has found. Feet of `members` that did
/// not begin the step are taken at their current position.
pub(crate) fn finish(
    begun: Option<Begun>,
    members: &[Member],
    pairs: &mut [Pair],
    parameters: &IntegrationParameters,
    bodies: &mut RigidBodySet,
    colliders: &ColliderSet,
) -> Option<()> {
    let handles = match (&begun, members.first()) {
        (Some(begun), _) => (begun.body, begun.ground),
        (None, first) => first.map(|first| (first.body, first.ground))?,
    };
    let foot = bodies.get(handles.0).filter(|foot| !foot.is_sleeping())?;
    let ground = handles.1.and_then(|handle| bodies.get(handle));
    let dt = TimeStep::new(parameters.dt).ok()?;
    let (frame, reduced) = match &begun {
        Some(begun) => (begun.frame, begun.reduced),
        None => {
            let frame = Frame::new(mean_contact(members)?.0);
            (frame, Reduced::new(foot, ground, &frame)?)
        }
    };
    let after = relative(&frame, foot, ground);
    // All pushes except friction, as their mean over the step, and the expected part of them.
    let (before, others, push) = match &begun {
        Some(begun) => {
            let all = reduced.push(&(after - begun.before), parameters.dt);
            (begun.before, all - begun.friction, begun.push)
        }
        None => (after, Wrench::ZERO, Wrench::ZERO),
    };
    let stand_of = |member: &Member| {
        let pair = pairs.get(member.pair)?;
        let begun = begun.iter().flat_map(|begun| &begun.stands);
        let kept = begun.copied().find(|stand| stand.is_of(pair));
        kept.or_else(|| Stand::now(pair, &frame, foot, colliders))
    };
    let stands: Vec<Stand> = members.iter().map(stand_of).collect::<Option<_>>()?;
    let drift = |member: &Member| drift(member, &after, &frame, foot, bodies);
    let judge = Judge {
        pairs,
        members,
        stands: &stands,
        drifts: members.iter().map(drift).collect(),
        reduced: &reduced,
    };
    let judged = judge.step(&before, &others, dt)?;
    let share = match judged.is_at_rest() {
        true => judge.share(&judged, &before)?,
        false => 1.0,
    };
    let changes = reduced.shared(&(judged.twist - after), &frame);
    for (handle, change) in [Some(handles.0), handles.1].into_iter().zip(&changes) {
        let body = handle.and_then(|handle| bodies.get_mut(handle));
        if let Some(body) = body.filter(|body| is_free(body)) {
            accelerate(body, change, 1.0);
        }
    }
    let unexpected = others - push;
    let held = judged.is_at_rest().then_some(&unexpected);
    for (number, member) in members.iter().enumerate() {
        let stop = (judged.is_at_rest()).then_some(Stop {
            within_step: share * parameters.dt,
        });
        remember(
            &mut pairs[member.pair],
            member,
            &judged,
            number,
            &frame,
            held,
            stop,
        );
    }
    Some(())
}

/// Stores the results of a step for a foot.
fn remember(
    pair: &mut Pair,
    member: &Member,
    judged: &Solved,
    number: usize,
    frame: &Frame,
    held: Option<&Wrench<f32>>,
    stop: Option<Stop>,
) {
    let none = (Wrench::ZERO, false);
    let each = judged
        .each
        .iter()
        .copied()
        .zip(judged.holds.iter().copied());
    let (friction, holds) = each.into_iter().nth(number).unwrap_or(none);
    pair.stop = stop.filter(|_| !pair.friction.holds);
    pair.friction = Friction {
        force: frame.world(&friction.force),
        torque: frame.normal * friction.torque,
        load: member.touching.load,
        holds,
    };
    pair.known = Some(Known::new(member.touching, held));
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
    let linear = pull(foot) - ground.map_or(Vector::ZERO, pull) - carried(foot, ground);
    let angular = turn(foot) - ground.map_or(Vector::ZERO, turn);
    reduced.push(&frame.twist(linear, angular), 1.0)
}

/// The velocity offset during the step that makes the engine's displacement that of the mean
/// velocity.
///
/// The engine moves a body by its velocity at the end of each of its n substeps, so that a body under
/// constant deceleration lags by half a substep's change. Friction that ends the motion needs the
/// given `share` of the step for it, and the remaining displacement is cut.
fn offset(before: &Twist<f32>, after: &Twist<f32>, share: f32, substeps: usize) -> Twist<f32> {
    let [late, cut] = [0.5 / substeps as f32, 0.5 * (1.0 - share)];
    (*after - *before) * -late - *before * cut
}

fn is_zero(twist: &Twist<f32>) -> bool {
    *twist == Twist::ZERO
}
