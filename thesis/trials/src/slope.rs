//! Five spheres that friction holds on a slope.

use super::column::DENSITY;
use super::pile::{Pile, StepObservation};
use super::{Method, PreparedTrial, Trial, TrialResult};
use anyhow::Result;
use nalgebra::Vector3;
use tribos::cd::solid;
use tribos_core::contact::IndependentFriction;

/// Share of the run over which the mean speed counts.
const JUDGED: f64 = 0.5;

/// Four spheres in a square and one upon them on an inclined plane, below the slopes at which a sphere would
/// slide (`mu`) or roll (`mu_rolling`). The unit of stiffness is m g/R.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Sliding coefficient.
    pub mu: f64,
    /// Rolling coefficient.
    pub mu_rolling: f64,
    /// Tangent of the inclination.
    pub slope: f64,
    /// Length of the run, in √(R/g).
    pub time: f64,
}

impl Trial for Slope {
    fn quantities(&self) -> &'static [&'static str] {
        &["creep [√(g R)]", "strain before it stands [R]"]
    }

    fn ready(&self, method: Method) -> Result<PreparedTrial> {
        let (slope, up) = (*self, Vector3::z());
        let down = Vector3::new(slope.slope, 0.0, -1.0).normalize();
        let top = 1.0 + 2.0_f64.sqrt();
        let places = [
            [-1.0, -1.0, 1.0],
            [1.0, -1.0, 1.0],
            [-1.0, 1.0, 1.0],
            [1.0, 1.0, 1.0],
            [0.0, 0.0, top],
        ];
        let pile = Pile {
            up,
            gravity: down,
            friction: IndependentFriction::sliding_rolling(slope.mu, slope.mu_rolling)?,
            spheres: places.map(|x| (x.into(), solid(1.0, DENSITY))).to_vec(),
        };
        let mean = |look: &StepObservation<'_>| look.positions.iter().sum::<Vector3<f64>>() / 5.0;
        let start = pile.spheres.iter().map(|(x, _)| x).sum::<Vector3<f64>>() / 5.0;
        Ok(Box::new(move || {
            let (mut first, mut last) = (None, (0.0, start));
            let updates = pile.run(method, slope.time, |look| {
                last = (look.time, mean(look));
                if first.is_none() && look.time > (1.0 - JUDGED) * slope.time {
                    first = Some(last);
                }
            })?;
            let (before, from) = first.unwrap_or((0.0, start));
            let (after, to) = last;
            let errors = vec![(to - from).norm() / (after - before), (to - start).norm()];
            Ok(TrialResult { errors, updates })
        }))
    }
}
