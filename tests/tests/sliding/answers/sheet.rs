//! A flat body on a patch with straight edges.

use super::march::Body;
use tribos::friction::Flat;
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::twist::{Twist, Wrench};

/// A body as thin as its patch, per mass.
#[derive(Debug)]
pub struct Sheet {
    friction: ShapeFriction<f64, Flat<f64>>,
    gravity: f64,
    gyration_sq: f64,
}

impl Sheet {
    pub fn new(patch: Flat<f64>, [mu, gravity]: [f64; 2], gyration_sq: f64) -> Self {
        Self {
            friction: ShapeFriction::new(patch, mu).expect("a coefficient"),
            gravity,
            gyration_sq,
        }
    }
}

impl Body for Sheet {
    fn friction(&self, twist: &Twist<f64>) -> Wrench<f64> {
        self.friction.wrench(self.gravity, twist)
    }

    fn scale(&self, twist: &Twist<f64>) -> f64 {
        twist.speed().hypot(self.gyration_sq.sqrt() * twist.spin)
    }

    fn gyration_sq(&self) -> f64 {
        self.gyration_sq
    }

    fn strength(&self) -> f64 {
        self.friction.coefficient() * self.gravity
    }
}
