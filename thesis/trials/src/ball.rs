//! A ball that slides into rolling.

use super::column::DENSITY;
use super::pile::Pile;
use super::{Method, PreparedTrial, Trial, TrialResult};
use anyhow::Result;
use nalgebra::Vector3;
use tribos::cd::solid;
use tribos_core::contact::{IndependentFriction, SphereBody};

/// Length of the run, in the time of sliding.
const RUN: f64 = 1.5;

/// A ball that is struck through its centre. It slides for 2 v/(7 μ g) and over 12 v²/(49 μ g) and rolls on with 5/7 v.
/// The unit of stiffness is m g/R; soft contacts start at their static overlap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Sliding coefficient μ.
    pub mu: f64,
    /// Speed v at the start, in √(g R).
    pub speed: f64,
}

impl Trial for Ball {
    fn quantities(&self) -> &'static [&'static str] {
        &["rolling speed [5/7 v]", "way [sliding length]"]
    }

    fn ready(&self, method: Method) -> Result<PreparedTrial> {
        let (Self { mu, speed }, up) = (*self, Vector3::z());
        let overlap = match method {
            Method::Soft { stiffness, .. } => 1.0 / stiffness,
            _ => 0.0,
        };
        let ball = SphereBody {
            velocity: Vector3::x() * speed,
            ..solid(1.0, DENSITY)
        };
        let pile = Pile {
            up,
            gravity: -up,
            friction: IndependentFriction::sliding(mu)?,
            spheres: vec![(up * (1.0 - overlap), ball)],
        };
        let (sliding, length) = (2.0 * speed / (7.0 * mu), 12.0 * speed * speed / (49.0 * mu));
        let rolling = 5.0 / 7.0 * speed;
        Ok(Box::new(move || {
            let mut errors = vec![f64::NAN; 2];
            let updates = pile.run(method, RUN * sliding, |look| {
                let (place, ball) = (look.positions[0].x, &look.spheres[0]);
                let exact = length + rolling * (look.time - sliding);
                errors = vec![
                    (ball.velocity.x / rolling - 1.0).abs(),
                    ((place - exact) / length).abs(),
                ];
            })?;
            Ok(TrialResult { errors, updates })
        }))
    }
}
