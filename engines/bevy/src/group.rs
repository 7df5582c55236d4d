//! The feet of one body on the ground through one substep of the engine.

use crate::frame::{Change, Frame, relative};
use crate::friction::{PatchFriction, SubstepFriction};
use crate::reduced::{Inverse, Reduced};
use avian3d::dynamics::integrator::VelocityIntegrationData;
use avian3d::dynamics::solver::constraint_graph::ConstraintGraph;
use avian3d::dynamics::solver::solver_body::{SolverBody, SolverBodyInertia};
use bevy::prelude::*;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};
use tribos_feet::{Correction, Foot, Footprint, Stance, Standing, SurfaceAside};

/// What friction needs of bodies during the substeps.
pub(crate) type Bodies<'w, 's> = Query<
    'w,
    's,
    (
        &'static mut SolverBody,
        &'static SolverBodyInertia,
        &'static VelocityIntegrationData,
    ),
>;

/// The change of velocity in a substep by gravity and the forces of the application.
fn increased(by: &VelocityIntegrationData) -> Change {
    Change {
        linear: by.linear_increment,
        angular: by.angular_increment,
    }
}

/// A foot on the ground.
#[derive(Clone, Debug)]
pub(crate) struct Member {
    /// The foot's collider.
    pub(crate) collider: Entity,
    /// The ground's body, unless it is static.
    pub(crate) ground: Option<Entity>,
    pub(crate) mu: f32,
    pub(crate) footprint: Footprint,
    /// Vector from the body's centre of mass to the patch's centre, before the step.
    pub(crate) arm: Vec3,
    /// The footprint's x axis in the world, before the step.
    pub(crate) along: Vec3,
    /// Vector from the ground's centre of mass to the foot's, before the step.
    pub(crate) lever: Vec3,
    /// Places of its contacts in the constraint graph: colour and index.
    pub(crate) contacts: Vec<[usize; 2]>,
    /// Friction of the last substep.
    pub(crate) last: SubstepFriction,
    /// Where it stands in this substep.
    stance: Stance,
    /// Its normal force in this substep, in N.
    load: f32,
    /// Normal impulse in N s with which friction was last solved.
    solved: Option<f32>,
    /// Sums over the substeps.
    sums: AppliedLoads,
}

#[derive(Clone, Copy, Debug, Default)]
struct AppliedLoads {
    force: Vec3,
    torque: Vec3,
    load: f32,
}

impl Member {
    pub(crate) fn new(
        collider: Entity,
        ground: Option<Entity>,
        mu: f32,
        footprint: Footprint,
    ) -> Self {
        Self {
            collider,
            ground,
            mu,
            footprint,
            arm: Vec3::ZERO,
            along: Vec3::X,
            lever: Vec3::ZERO,
            contacts: Vec::new(),
            last: SubstepFriction::default(),
            stance: Stance::new([0.0; 2], [1.0, 0.0]),
            load: 0.0,
            solved: None,
            sums: AppliedLoads::default(),
        }
    }

    /// The normal impulse of a substep in N s.
    fn impulse(&self, graph: &ConstraintGraph) -> f32 {
        let contact = |&[color, index]: &[usize; 2]| {
            let constraint = graph.colors.get(color)?.contact_constraints.get(index)?;
            let impulses = constraint.points.iter().map(|p| p.normal_part.impulse);
            Some(impulses.sum::<f32>())
        };
        self.contacts.iter().filter_map(contact).sum()
    }

    /// Stores what the engine's relaxation has added to the normal impulse after friction had been solved.
    fn relaxed(&mut self, graph: &ConstraintGraph) {
        if let Some(solved) = self.solved.take() {
            self.last.late = self.impulse(graph) - solved;
        }
    }

    /// Finds the normal force of a substep of `dt` seconds, with what came late in the substep before.
    fn press(&mut self, graph: &ConstraintGraph, dt: f32) {
        let impulse = self.impulse(graph);
        self.solved = Some(impulse);
        self.load = (impulse + self.last.late).max(0.0) / dt;
    }

    /// Finds place and direction in the plane, after the body has turned and for half of the coming turn: `half` is a
    /// quarter of the angle of a substep in radians.
    fn stand(&mut self, frame: &Frame, body: &SolverBody, half: f32) {
        let plane = |vector: Vec3| frame.plane(body.delta_rotation * vector);
        self.stance = Stance::new(plane(self.arm), plane(self.along)).turned(half);
    }

    /// The foot, whose ground moves by `drift` against that of the first.
    fn foot(&self, drift: [f64; 3]) -> Foot<'_> {
        Foot {
            footprint: &self.footprint,
            limit: self.mu * self.load,
            place: self.stance.place,
            axis: self.stance.axis,
            drift,
        }
    }
}

/// The feet of one body on one plane.
#[derive(Debug)]
pub(crate) struct Group {
    pub(crate) body: Entity,
    pub(crate) members: Vec<Member>,
    pub(crate) frame: Frame,
    /// Whether friction moves the foot and the ground.
    pub(crate) moves: [bool; 2],
    /// Vectors from the centres of mass of the foot and the ground to the contact, before the step.
    pub(crate) arms: [Vec3; 2],
    /// Whether all feet were at rest after the last substep.
    pub(crate) holds: bool,
    reduced: Option<Reduced>,
    /// Of a foot alone, from the substep before.
    surface: Option<SurfaceAside>,
    /// Friction on the foot at its centre of mass in the last substep.
    pub(crate) friction: Wrench<f32>,
    /// What was added to the velocities of both for the integration of positions.
    offsets: [Change; 2],
    substeps: u16,
    stopped_after: Option<f32>,
}

impl Group {
    pub(crate) fn new(
        body: Entity,
        members: Vec<Member>,
        frame: Frame,
        moves: [bool; 2],
        arms: [Vec3; 2],
    ) -> Self {
        let mut group = Self {
            body,
            members,
            frame,
            moves,
            arms,
            holds: false,
            reduced: None,
            surface: None,
            friction: Wrench::ZERO,
            offsets: [Change::ZERO; 2],
            substeps: 0,
            stopped_after: None,
        };
        for member in &group.members {
            let SubstepFriction { force, torque, .. } = member.last;
            let torque = torque + member.arm.cross(frame.flat(force));
            group.friction += frame.flat_wrench(force, torque);
        }
        group
    }

    fn ground(&self) -> Option<Entity> {
        self.members.first().and_then(|first| first.ground)
    }

    /// To be called after the engine has relaxed its normal impulses.
    pub(crate) fn relaxed(&mut self, graph: &ConstraintGraph) {
        for member in &mut self.members {
            member.relaxed(graph);
        }
    }

    /// Applies the friction of the last substep, so that the engine's normal impulses meet its lever.
    pub(crate) fn begin(
        &mut self,
        bodies: &mut Bodies,
        graph: &ConstraintGraph,
        dt: f32,
    ) -> Option<()> {
        self.reduced = None;
        self.relaxed(graph);
        let ground = self.ground();
        let (foot, foot_inertia, _) = bodies.get(self.body).ok()?;
        let mut arms = self.arms;
        let moved = foot.delta_position;
        let of = |moves: bool, inertia: &SolverBodyInertia| match moves {
            true => Inverse::of(inertia, &self.frame),
            false => Inverse::fixed(),
        };
        let of_foot = of(self.moves[0], foot_inertia);
        let mut of_ground = Inverse::fixed();
        if let Some(ground) = ground {
            let (body, inertia, _) = bodies.get(ground).ok()?;
            of_ground = of(self.moves[1], inertia);
            arms[1] += moved - body.delta_position;
        }
        let reduced = Reduced::new(of_foot, of_ground, arms, &self.frame)?;
        let impulse = self.friction * dt;
        self.apply(&[reduced.by_impulse(&impulse, &self.frame)], bodies);
        self.reduced = Some(reduced);
        Some(())
    }

    /// Replaces the friction of the last substep by that of this one.
    pub(crate) fn resist(
        &mut self,
        bodies: &mut Bodies,
        graph: &ConstraintGraph,
        dt: TimeStep<f32>,
    ) -> Option<()> {
        let seconds = dt.dt();
        let reduced = self.reduced.take()?;
        let frame = self.frame;
        let (foot, _, increments) = bodies.get(self.body).ok()?;
        let pushed = increased(increments);
        let velocity = Change::velocity(foot);
        let half_turn = 0.25 * seconds * velocity.angular.dot(frame.normal);
        for member in &mut self.members {
            member.stand(&frame, foot, half_turn);
            member.press(graph, seconds);
        }
        let ground = self.ground().and_then(|ground| bodies.get(ground).ok());
        let (below, below_pushed) = ground.map_or((Change::ZERO, Change::ZERO), |(body, _, by)| {
            (Change::velocity(body), increased(by))
        });
        let smooth = [pushed, below_pushed];
        let lever = reduced.arms[1] - reduced.arms[0];
        let now = frame.twist(&relative(&velocity, &below, lever));
        // The motion without friction.
        let begun = self.friction * seconds;
        let free = now - reduced.twist(&begun, &frame);
        let (end, share) = self.balance(&reduced, &free, bodies, dt)?;
        let correction = end.ended.twist - now;
        let corrected = reduced.by_change(&correction, &frame);
        let stops = end.ended.is_at_rest() && !self.holds && free != Twist::ZERO;
        if stops && self.stopped_after.is_none() {
            self.stopped_after = Some((f32::from(self.substeps) + share) * seconds);
        }
        self.holds = end.ended.is_at_rest();
        self.friction = end.ended.friction;
        self.substeps = self.substeps.saturating_add(1);
        self.offsets = if stops {
            reduced.by_change(&(free * (0.5 * share)), &frame)
        } else if self.holds {
            [self.around(&velocity, &below, seconds), Change::ZERO]
        } else {
            self.half_back(&reduced, &smooth, seconds)
        };
        self.offsets = self.offsets.map(|offset| offset.within(&frame));
        self.apply(&[corrected, self.offsets], bodies);
        Some(())
    }

    /// Half of the velocity that a foot at rest on a ground that turns gains in the coming substep: its path is
    /// a circle.
    fn around(&self, foot: &Change, below: &Change, dt: f32) -> Change {
        let around = below.angular.cross(foot.linear - below.linear);
        let is_carried = !self.moves[1];
        Change {
            linear: if is_carried {
                around * (0.5 * dt)
            } else {
                Vec3::ZERO
            },
            angular: Vec3::ZERO,
        }
    }

    /// Half of the smooth change of velocity, taken back: the displacement is that of the mean velocity, whereas
    /// the engine uses the velocity at the end.
    fn half_back(&self, reduced: &Reduced, smooth: &[Change; 2], dt: f32) -> [Change; 2] {
        let by_friction = reduced.by_impulse(&(self.friction * dt), &self.frame);
        [0, 1].map(|i| Change {
            linear: (by_friction[i].linear + smooth[i].linear) * -0.5,
            angular: (by_friction[i].angular + smooth[i].angular) * -0.5,
        })
    }

    /// Subtracts what was added for the integration of positions.
    pub(crate) fn end(&mut self, bodies: &mut Bodies) {
        let offsets = core::mem::replace(&mut self.offsets, [Change::ZERO; 2]);
        let back = offsets.map(|Change { linear, angular }| Change {
            linear: -linear,
            angular: -angular,
        });
        self.apply(&[back], bodies);
    }

    /// The end of an implicit step from the motion `free`, and the fraction of it until rest. Stores the
    /// friction of each foot.
    fn balance(
        &mut self,
        reduced: &Reduced,
        free: &Twist<f32>,
        bodies: &Bodies,
        dt: TimeStep<f32>,
    ) -> Option<(Correction, f32)> {
        let frame = self.frame;
        let below = |ground, lever| relative(&Change::ZERO, &self.velocity(ground, bodies), lever);
        let (alone, several);
        let feet: &[Foot] = if let [member] = &self.members[..] {
            alone = [member.foot([0.0; 3])];
            &alone
        } else {
            let reference = self.members.first()?;
            let reference = frame.twist(&below(reference.ground, reference.lever));
            let drift = |member: &Member| {
                let drift = frame.twist(&below(member.ground, member.lever)) - reference;
                [drift.velocity.x, drift.velocity.y, drift.spin].map(f64::from)
            };
            let feet = self.members.iter().map(|member| member.foot(drift(member)));
            several = feet.collect::<Vec<_>>();
            &several
        };
        let (body, coupled) = (reduced.planar.body(), reduced.planar.coupled());
        let standing = Standing::with_surface(body, coupled, feet, self.surface.as_ref());
        let surface = standing.surface_aside();
        let end = standing.correct(None, free, dt)?;
        let share = match end.ended.is_at_rest() && *free != Twist::ZERO {
            true => standing.share_until_rest(None, &end),
            false => 1.0,
        };
        self.surface = surface;
        for (number, member) in self.members.iter_mut().enumerate() {
            let [force, torque] = frame.wrench(&end.ended.foot(number).wrench);
            (member.last.force, member.last.torque) = (force, torque);
            member.sums.force += force;
            member.sums.torque += torque;
            member.sums.load += member.load;
        }
        Some((end, share))
    }

    /// The velocity of a body; one that is static, or has been removed, is at rest.
    fn velocity(&self, body: Option<Entity>, bodies: &Bodies) -> Change {
        let body = body.and_then(|body| bodies.get(body).ok());
        body.map_or(Change::ZERO, |(body, ..)| Change::velocity(body))
    }

    /// Changes the velocities of foot and ground, one change after the other.
    fn apply(&self, changes: &[[Change; 2]], bodies: &mut Bodies) {
        let entities = [Some(self.body), self.ground()];
        for i in [0, 1] {
            let body = entities[i].filter(|_| self.moves[i]);
            if let Some((mut body, ..)) = body.and_then(|body| bodies.get_mut(body).ok()) {
                changes.iter().for_each(|both| both[i].apply(&mut body));
            }
        }
    }

    /// What the feet have felt during the substeps.
    pub(crate) fn report(&self) -> impl Iterator<Item = (Entity, PatchFriction)> {
        let share = 1.0 / f32::from(self.substeps.max(1));
        self.members.iter().map(move |member| {
            let friction = PatchFriction {
                force: member.sums.force * share,
                torque: member.sums.torque * share,
                load: member.sums.load * share,
                holds: self.holds,
                stopped_after: self.stopped_after.filter(|_| self.holds),
                last: member.last,
            };
            (member.collider, friction)
        })
    }
}
