//! The feet that touch the ground in a step.

use crate::frame::Frame;
use crate::friction::PatchFriction;
use crate::group::{Group, Member};
use crate::patch::FrictionPatch;
use avian3d::collision::contact_types::ContactGraph;
use avian3d::dynamics::solver::constraint_graph::ConstraintGraph;
use avian3d::dynamics::solver::contact::{ContactConstraint, ContactConstraintPoint};
use avian3d::prelude::*;
use bevy::ecs::entity::EntityHashMap;
use bevy::prelude::*;

/// Least cosine of the angle between a contact's normal and its patch's, or that of another foot.
const ONE_PLANE: f32 = 0.99;

/// All groups of feet of a step.
#[derive(Resource, Debug, Default)]
pub(crate) struct Groups(pub(crate) Vec<Group>);

type Patches<'w, 's> = Query<
    'w,
    's,
    (
        &'static FrictionPatch,
        &'static PatchFriction,
        &'static ColliderTransform,
    ),
>;

type Places<'w, 's> = Query<
    'w,
    's,
    (
        &'static RigidBody,
        &'static Rotation,
        &'static ComputedCenterOfMass,
    ),
>;

/// A contact of a patch.
struct PatchContact {
    body: Entity,
    member: Member,
    holds: bool,
    /// From the ground to the foot.
    normal: Vec3,
    moves: [bool; 2],
    /// Vectors from the centres of mass of the foot and the ground to the contact.
    arms: [Vec3; 2],
}

/// Contacts of feet on one plane, until all have been seen.
struct FootGroupBuilder {
    body: Entity,
    /// The first foot's ground, and its normal.
    ground: Option<Entity>,
    normal: Vec3,
    moves: [bool; 2],
    members: Vec<Member>,
    normals: Vec3,
    arms: [Vec3; 2],
    contacts: f32,
    holds: bool,
    /// The next group of the same body.
    next: Option<usize>,
}

/// Finds the contacts of patches, and takes the engine's friction away from them.
pub(crate) fn gather_feet(
    mut groups: ResMut<Groups>,
    mut constraints: ResMut<ConstraintGraph>,
    contacts: Res<ContactGraph>,
    patches: Patches,
    places: Places,
) {
    groups.0.clear();
    if patches.is_empty() {
        return;
    }
    let mut drafts: Vec<FootGroupBuilder> = Vec::new();
    let mut first_of_body = EntityHashMap::default();
    for (color, graph) in constraints.colors.iter_mut().enumerate() {
        for (index, constraint) in graph.contact_constraints.iter_mut().enumerate() {
            let Some((_, pair)) = contacts.get_by_id(constraint.contact_id) else {
                continue;
            };
            let colliders = [pair.collider1, pair.collider2];
            let sides = [0, 1].into_iter();
            let touching = sides
                .filter_map(|foot| touching(foot, colliders, constraint, &patches, &places))
                .next();
            let Some(mut touching) = touching else {
                continue;
            };
            touching.member.contacts.push([color, index]);
            constraint.friction = 0.0;
            for point in &mut constraint.points {
                point.tangent_part = None;
            }
            let new = drafts.len();
            let mut at = *first_of_body.entry(touching.body).or_insert(new);
            while let Some(draft) = drafts.get_mut(at) {
                if draft.takes(&touching) {
                    break;
                }
                at = *draft.next.get_or_insert(new);
            }
            match drafts.get_mut(at) {
                Some(draft) => draft.add(touching),
                None => drafts.push(FootGroupBuilder::new(touching)),
            }
        }
    }
    groups
        .0
        .extend(drafts.into_iter().map(FootGroupBuilder::finish));
}

/// The contact as one of a patch, if the collider on side `foot` has one that faces it.
fn touching(
    foot: usize,
    colliders: [Entity; 2],
    constraint: &ContactConstraint,
    patches: &Patches,
    places: &Places,
) -> Option<PatchContact> {
    let (patch, friction, transform) = patches.get(colliders[foot]).ok()?;
    let bodies = [constraint.body1, constraint.body2];
    let [body, ground] = [bodies[foot], bodies[1 - foot]];
    let (rigid, rotation, com) = places.get(body).ok()?;
    // The constraint's normal points from its first body to the second.
    let (normal, dominance) = match foot {
        0 => (-constraint.normal, constraint.relative_dominance),
        _ => (constraint.normal, -constraint.relative_dominance),
    };
    let turned = |vector: Vec3| *rotation * (transform.rotation * vector);
    if !rigid.is_dynamic() || turned(*patch.up()).dot(normal) < ONE_PLANE {
        return None;
    }
    let is_static = places
        .get(ground)
        .is_ok_and(|(ground, ..)| ground.is_static());
    let ground = Some(ground).filter(|_| !is_static);
    let count = constraint.points.len() as f32;
    let mean = |f: fn(&ContactConstraintPoint) -> Vec3| {
        constraint.points.iter().map(f).sum::<Vec3>() / count
    };
    let anchors = [mean(|p| p.anchor1), mean(|p| p.anchor2)];
    let center = transform.rotation * patch.center() + transform.translation;
    let mut member = Member::new(
        colliders[foot],
        ground,
        patch.mu(),
        patch.footprint().clone(),
    );
    member.arm = *rotation * (center - com.0);
    member.along = turned(*patch.along());
    member.last = friction.last;
    let arms = [anchors[foot], anchors[1 - foot]];
    member.lever = arms[1] - arms[0];
    Some(PatchContact {
        body,
        member,
        holds: friction.holds,
        normal,
        moves: [dominance <= 0, dominance >= 0],
        arms,
    })
}

impl FootGroupBuilder {
    fn new(first: PatchContact) -> Self {
        Self {
            body: first.body,
            ground: first.member.ground,
            normal: first.normal,
            moves: first.moves,
            members: vec![first.member],
            normals: first.normal,
            arms: first.arms,
            contacts: 1.0,
            holds: first.holds,
            next: None,
        }
    }

    /// Whether a contact of the same body belongs to the same plane, on the same ground or on one that friction does not
    /// move either.
    fn takes(&self, other: &PatchContact) -> bool {
        self.moves == other.moves
            && (!self.moves[1] || self.ground == other.member.ground)
            && self.normal.dot(other.normal) > ONE_PLANE
    }

    fn add(&mut self, other: PatchContact) {
        self.normals += other.normal;
        // The distance to a ground matters for the first one alone.
        if other.member.ground == self.ground {
            for (sum, arm) in self.arms.iter_mut().zip(other.arms) {
                *sum += arm;
            }
            self.contacts += 1.0;
        }
        self.holds &= other.holds;
        let same = |member: &&mut Member| {
            member.collider == other.member.collider && member.ground == other.member.ground
        };
        match self.members.iter_mut().find(same) {
            Some(member) => member.contacts.extend(other.member.contacts),
            None => self.members.push(other.member),
        }
    }

    fn finish(self) -> Group {
        let frame = Frame::new(self.normals.normalize_or(self.normal));
        let arms = self.arms.map(|sum| sum / self.contacts);
        let mut group = Group::new(self.body, self.members, frame, self.moves, arms);
        group.holds = self.holds;
        group
    }
}
