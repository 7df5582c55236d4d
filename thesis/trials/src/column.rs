//! A column of spheres: statics says what the floor bears.

use super::pile::{Pile, deepest};
use super::{Method, PreparedTrial, Trial, TrialResult};
use anyhow::Result;
use nalgebra::Vector3;
use std::f64::consts::PI;
use tribos::cd::solid;
use tribos_core::contact::IndependentFriction;

/// Density of a sphere of mass 1.
pub(super) const DENSITY: f64 = 3.0 / (4.0 * PI);
/// Share of the run over which the largest error counts.
const JUDGED: f64 = 0.5;

/// Spheres one above the other that touch and are at rest at the start; the topmost may be heavier. The unit of
/// stiffness is the weight of all over R.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Number of spheres.
    pub spheres: usize,
    /// Mass of the topmost.
    pub top: f64,
    /// Length of the run, in √(R/g).
    pub time: f64,
}

impl Column {
    fn weight(&self) -> f64 {
        self.spheres as f64 - 1.0 + self.top
    }
}

impl Trial for Column {
    fn quantities(&self) -> &'static [&'static str] {
        &["force on the floor [weight]", "deepest overlap [R]"]
    }

    fn ready(&self, method: Method) -> Result<PreparedTrial> {
        let (column, up) = (*self, Vector3::z());
        let method = match method {
            Method::Soft { stiffness, steps } => Method::Soft {
                stiffness: stiffness * column.weight(),
                steps,
            },
            other => other,
        };
        let sphere = |index: usize| {
            let mass = if index + 1 == column.spheres {
                column.top
            } else {
                1.0
            };
            (up * (1.0 + 2.0 * index as f64), solid(1.0, DENSITY * mass))
        };
        let pile = Pile {
            up,
            gravity: -up,
            friction: IndependentFriction::none(),
            spheres: (0..column.spheres).map(sphere).collect(),
        };
        Ok(Box::new(move || {
            let [mut error, mut depth] = [0.0_f64; 2];
            let updates = pile.run(method, column.time, |look| {
                if look.time > (1.0 - JUDGED) * column.time {
                    error = error.max((look.floor / column.weight() - 1.0).abs());
                    depth = depth.max(deepest(look, &up));
                }
            })?;
            let errors = vec![error, depth];
            Ok(TrialResult { errors, updates })
        }))
    }
}
