//! The planners' habit: the convex hull of sampled wrenches.

use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::twist::{Twist, Wrench};

/// So many motions, spread evenly over all directions of velocity and rim speed.
pub fn motions(count: usize, radius: f64) -> impl Iterator<Item = Twist<f64>> {
    let golden = core::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |i| {
        let rim = 1.0 - (2.0 * i as f64 + 1.0) / count as f64;
        let (slide, angle) = ((1.0 - rim * rim).sqrt(), golden * i as f64);
        Twist::new(slide * angle.cos(), slide * angle.sin(), rim / radius)
    })
}

/// Wrenches of the limit surface under motions that are spread evenly.
#[derive(Clone, Debug)]
pub struct Hull {
    wrenches: Vec<Wrench<f64>>,
}

impl Hull {
    /// So many wrenches of a patch with μN = 1.
    pub fn of(friction: &ShapeFriction<f64, impl PatchShape<f64>>, samples: usize) -> Self {
        let motions = motions(samples, friction.patch().radius());
        Self {
            wrenches: motions.map(|twist| friction.wrench(1.0, &twist)).collect(),
        }
    }

    /// The corner of the hull that dissipates most.
    pub fn wrench(&self, twist: &Twist<f64>) -> Wrench<f64> {
        let mut best = (f64::INFINITY, Wrench::ZERO);
        for wrench in &self.wrenches {
            let power = wrench.power(twist);
            if power < best.0 {
                best = (power, *wrench);
            }
        }
        best.1
    }
}
