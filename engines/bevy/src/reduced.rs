//! Two bodies as one: the mass with which a common impulse meets their relative motion in the plane.

use crate::frame::{Change, Frame, relative};
use avian3d::dynamics::solver::solver_body::SolverBodyInertia;
use bevy::math::Vec3;
use tribos_core::twist::{Twist, Wrench};
use tribos_feet::Reduced as Planar;

/// Cosine to the normal from which on an axis of the world counts as the normal.
const ALONG: f32 = 0.99;

/// A foot and its ground, reduced to one body.
#[derive(Clone, Debug)]
pub(crate) struct Reduced {
    /// In the plane.
    pub(crate) planar: Planar,
    foot: Inverse,
    ground: Inverse,
    /// Vectors from the centres of mass of the foot and the ground to the point at which friction acts.
    pub(crate) arms: [Vec3; 2],
}

/// Inverse mass and inertia of a body in the plane, and its whole inverse inertia for tilting.
#[derive(Clone, Debug)]
pub(crate) struct Inverse {
    mass: f32,
    inertia: f32,
    whole: SolverBodyInertia,
}

impl Inverse {
    pub(crate) fn of(inertia: &SolverBodyInertia, frame: &Frame) -> Self {
        // The plane has one mass for all directions: that along the axes that are free.
        let flat = frame.normal.abs().cmplt(Vec3::splat(ALONG));
        let mass = Vec3::select(flat, inertia.effective_inv_mass(), Vec3::ZERO).max_element();
        let turn = inertia.effective_inv_angular_inertia() * frame.normal;
        Self {
            mass,
            inertia: turn.dot(frame.normal),
            whole: inertia.clone(),
        }
    }

    /// A body that friction does not move.
    pub(crate) fn fixed() -> Self {
        Self {
            mass: 0.0,
            inertia: 0.0,
            whole: SolverBodyInertia::DUMMY,
        }
    }

    fn moves(&self) -> bool {
        self.mass > 0.0 || self.inertia > 0.0
    }

    /// Rotation due to the lever of a tangential impulse, without that about the normal.
    fn tilt(&self, impulse: Vec3, arm: Vec3, frame: &Frame) -> Vec3 {
        if !self.moves() {
            return Vec3::ZERO;
        }
        let lever = frame.normal * frame.normal.dot(arm);
        frame.flat(self.whole.effective_inv_angular_inertia() * lever.cross(impulse))
    }

    /// A velocity along the axes that are free.
    fn free(&self, velocity: Vec3) -> Vec3 {
        let free = self.whole.effective_inv_mass().cmpgt(Vec3::ZERO);
        Vec3::select(free, velocity, Vec3::ZERO)
    }
}

impl Reduced {
    /// `None` if neither can be moved.
    pub(crate) fn new(
        foot: Inverse,
        ground: Inverse,
        arms: [Vec3; 2],
        frame: &Frame,
    ) -> Option<Self> {
        let lever = frame.plane(arms[1] - arms[0]);
        let of = |inverse: &Inverse| [inverse.mass, inverse.inertia];
        Some(Self {
            planar: Planar::new([of(&foot), of(&ground)], lever)?,
            foot,
            ground,
            arms,
        })
    }

    /// Changes of both bodies' velocities due to an impulse, given at the foot's centre of mass.
    pub(crate) fn by_impulse(&self, impulse: &Wrench<f32>, frame: &Frame) -> [Change; 2] {
        let [push, turn] = frame.wrench(impulse);
        let lever = self.arms[1] - self.arms[0];
        let below = frame.normal * lever.cross(push).dot(frame.normal) + turn;
        let change = |of: &Inverse, arm, push: Vec3, turn: Vec3| Change {
            linear: of.free(push * of.mass),
            angular: turn * of.inertia + of.tilt(push, arm, frame),
        };
        [
            change(&self.foot, self.arms[0], push, turn),
            change(&self.ground, self.arms[1], -push, -below),
        ]
    }

    /// Changes of both bodies' velocities that together give a change of the relative twist: exactly, if the
    /// ground is not moved.
    pub(crate) fn by_change(&self, change: &Twist<f32>, frame: &Frame) -> [Change; 2] {
        let impulse = self.planar.push(change, 1.0);
        let mut both = self.by_impulse(&impulse, frame);
        if !self.planar.moved()[1] {
            let exact = frame.motion(change);
            let tilt = self
                .foot
                .tilt(frame.wrench(&impulse)[0], self.arms[0], frame);
            let turn = f32::from(u8::from(self.foot.inertia > 0.0));
            both[0] = Change {
                linear: self.foot.free(exact.linear),
                angular: exact.angular * turn + tilt,
            };
        }
        both
    }

    /// The change of the relative twist due to an impulse.
    pub(crate) fn twist(&self, impulse: &Wrench<f32>, frame: &Frame) -> Twist<f32> {
        let [foot, ground] = self.by_impulse(impulse, frame);
        let ground = Change {
            angular: frame.normal * ground.angular.dot(frame.normal),
            ..ground
        };
        frame.twist(&relative(&foot, &ground, self.arms[1] - self.arms[0]))
    }
}
