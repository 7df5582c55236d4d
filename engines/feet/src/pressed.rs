//! A friction set under a load, with its largest torque known.

use tribos_core::limit_surface::{FrictionSet, Projection, ScaledSet};
use tribos_core::twist::{Twist, Wrench};

/// The limit surface of any area.
pub(crate) type Set = dyn FrictionSet<f32> + Send + Sync;

/// A set under 1 N, and its largest torque.
pub(crate) struct Prepared {
    pub(crate) set: Box<Set>,
    torque_limit: f32,
}

/// The unit of spin.
const TURN: Twist<f32> = Twist {
    spin: 1.0,
    ..Twist::ZERO
};

impl Prepared {
    pub(crate) fn new(set: Box<Set>) -> Self {
        let torque_limit = set.support(&TURN);
        Self { set, torque_limit }
    }

    /// The set under a friction limit in newtons; `None` unless that is positive and finite.
    pub(crate) fn under(&self, limit: f32) -> Option<Pressed<'_>> {
        Some(Pressed {
            set: ScaledSet::new(&*self.set, limit).ok()?,
            torque_limit: limit * self.torque_limit,
        })
    }
}

/// A set under its load. Every step asks for the largest torque, which is computed once.
pub(crate) struct Pressed<'a> {
    set: ScaledSet<'a, f32, Set>,
    torque_limit: f32,
}

impl FrictionSet<f32> for Pressed<'_> {
    fn force_limit(&self) -> f32 {
        self.set.force_limit()
    }

    fn radius(&self) -> f32 {
        self.set.radius()
    }

    fn support(&self, twist: &Twist<f32>) -> f32 {
        if *twist == TURN {
            return self.torque_limit;
        }
        self.set.support(twist)
    }

    fn wrench(&self, twist: &Twist<f32>) -> Wrench<f32> {
        self.set.wrench(twist)
    }

    fn gauge(&self, wrench: &Wrench<f32>) -> f32 {
        self.set.gauge(wrench)
    }

    fn twist_normal_to(&self, push: &Wrench<f32>) -> Twist<f32> {
        self.set.twist_normal_to(push)
    }

    fn scale_to_surface(&self, wrench: &Wrench<f32>) -> Wrench<f32> {
        self.set.scale_to_surface(wrench)
    }

    fn project_with_length(&self, wrench: &Wrench<f32>, length: f32) -> Projection<f32> {
        self.set.project_with_length(wrench, length)
    }
}
