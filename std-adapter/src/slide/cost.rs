//! How the friction of a sliding body is evaluated, and what that costs.

use super::SlideError;
use super::path::resistance;
use crate::scene::{PlanarBody, PlanarScene, SliderScene};
use std::hint::black_box;
use std::time::Instant;
use tribos_core::coupling::table::{Coulomb, Table64};
use tribos_core::coupling::{Annulus, Coupling};
use tribos_core::patch::PowerPressure;

/// Where force and torque come from.
///
/// ```
/// use tribos::scene::{Scene, parse_scene, vocabulary};
/// use tribos::slide::Evaluation;
/// let evaluation = |body: &str, set: &str| {
///     let text = vocabulary(body).ok_or("no such body")?.least_text();
///     Ok::<_, Box<dyn std::error::Error>>(match parse_scene(body, &text, &[set.into()])? {
///         Scene::Disk(scene) => Some(scene.evaluation()),
///         Scene::Planar(scene) => Some(scene.evaluation()),
///         _ => None,
///     })
/// };
/// assert_eq!(evaluation("disk", "alpha=0")?, Some(Evaluation::CoulombTable));
/// assert_eq!(evaluation("disk", "alpha=-0.5")?, Some(Evaluation::PowerTable));
/// assert_eq!(evaluation("cylinder", "pressure=hertz")?, Some(Evaluation::PressureTable));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// A disk under uniform pressure and Coulomb's law: a table in the program.
    CoulombTable,
    /// A disk under uniform pressure and a power law: a table made at the start.
    PowerTable,
    /// A disk under another pressure, or a ring: a table made at the start.
    PressureTable,
    /// An annulus: the table of the disk, twice.
    AnnulusTable,
    /// Points evenly around a ring, summed.
    RingRule {
        /// How many.
        points: usize,
    },
}

/// Cost of one evaluation. *Units*: s on one core of this machine.
///
/// ```
/// use tribos::scene::{parse_slider, vocabulary};
/// use tribos::slide::EvaluationCost;
/// let disk = vocabulary("disk").ok_or("no disk")?.least_text();
/// let cost: EvaluationCost = parse_slider("disk.toml", &disk, &[])?.evaluation_cost()?;
/// assert!(cost.seconds > 0.0 && cost.seconds < 1e-3);
/// assert!(cost.table_seconds > 0.0); // for comparison
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EvaluationCost {
    /// Of the scene's friction; in the plane with the lateral force and the leaning pressure.
    pub seconds: f64,
    /// Of force and torque of a disk under Coulomb's law from the table, measured in turns with it.
    pub table_seconds: f64,
}

impl SliderScene {
    /// Where force and torque come from.
    pub fn evaluation(&self) -> Evaluation {
        if self.alpha == 0.0 {
            Evaluation::CoulombTable
        } else {
            Evaluation::PowerTable
        }
    }

    /// Times evaluations over a mix of speeds. *Accuracy*: some ten per cent.
    pub fn evaluation_cost(&self) -> Result<EvaluationCost, SlideError> {
        if self.alpha == 0.0 {
            return Ok(timed(|v, w| Coulomb.reduced_wrench(v, w).force));
        }
        let table = Table64::new(self.alpha)?;
        Ok(timed(|v, w| table.reduced_wrench(v, w).force))
    }
}

impl PlanarScene {
    /// Where force and torque come from.
    pub fn evaluation(&self) -> Evaluation {
        let round = |alpha: f64, pressure| match (alpha == 0.0, pressure == PowerPressure::UNIFORM)
        {
            (true, true) => Evaluation::CoulombTable,
            (false, true) => Evaluation::PowerTable,
            _ => Evaluation::PressureTable,
        };
        let band = |inner_ratio: f64| {
            if inner_ratio > Annulus::<f64, Coulomb>::MAX_INNER_RATIO {
                Evaluation::PressureTable
            } else {
                Evaluation::AnnulusTable
            }
        };
        match &self.body {
            PlanarBody::Cylinder(cylinder) => round(cylinder.alpha, cylinder.pressure),
            PlanarBody::Pipe(pipe) => band(pipe.inner_ratio),
            PlanarBody::Curling(_, model) if model.name() == "film" => Evaluation::RingRule {
                points: super::curling::RING_POINTS,
            },
            PlanarBody::Curling(rock, _) => band(1.0 - rock.band_width / rock.band_radius),
        }
    }

    /// Times evaluations over a mix of speeds. *Accuracy*: some ten per cent.
    pub fn evaluation_cost(&self) -> Result<EvaluationCost, SlideError> {
        let body = resistance(self)?;
        Ok(timed(|v, w| body.deceleration([v, 0.0, w])[0]))
    }
}

/// Evaluations of a round, and rounds.
const EVALUATIONS: usize = 256;
const ROUNDS: usize = 9;

/// Time of one evaluation, the least of interleaved rounds with the table's.
fn timed(evaluate: impl Fn(f64, f64) -> f64) -> EvaluationCost {
    let mut cost = EvaluationCost {
        seconds: f64::INFINITY,
        table_seconds: f64::INFINITY,
    };
    for _ in 0..ROUNDS {
        cost.seconds = cost.seconds.min(round(&evaluate));
        let table = |v, w| Coulomb.reduced_wrench(v, w).force;
        cost.table_seconds = cost.table_seconds.min(round(&table));
    }
    cost
}

/// Time of one evaluation, over ratios of the speeds from 1/16 to 16.
fn round(evaluate: &impl Fn(f64, f64) -> f64) -> f64 {
    let start = Instant::now();
    for k in 0..EVALUATIONS {
        let share = (k as f64 + 0.5) / EVALUATIONS as f64;
        let (v, w) = (1.0 / 16.0 + share, 1.0 + 1.0 / 16.0 - share);
        black_box(evaluate(black_box(v), black_box(w)));
    }
    start.elapsed().as_secs_f64() / EVALUATIONS as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, parse_scene, vocabulary};

    #[test]
    fn every_body_says_where_its_friction_comes_from_and_can_be_timed() {
        for (body, keys, expected) in [
            ("disk", "", Evaluation::CoulombTable),
            ("disk", "alpha=0.5", Evaluation::PowerTable),
            ("cylinder", "", Evaluation::CoulombTable),
            ("cylinder", "pressure=hertz", Evaluation::PressureTable),
            ("pipe", "", Evaluation::AnnulusTable),
            ("pipe", "inner_radius=0.05", Evaluation::PressureTable),
            ("curling", "", Evaluation::PressureTable),
            (
                "curling",
                "model=film",
                Evaluation::RingRule { points: 256 },
            ),
        ] {
            let overrides: Vec<String> = keys.split_whitespace().map(String::from).collect();
            let text = vocabulary(body).unwrap().least_text();
            let (evaluation, cost) = match parse_scene(body, &text, &overrides).unwrap() {
                Scene::Disk(scene) => (scene.evaluation(), scene.evaluation_cost().unwrap()),
                Scene::Planar(scene) => (scene.evaluation(), scene.evaluation_cost().unwrap()),
                _ => unreachable!("a sliding body"),
            };
            assert_eq!(evaluation, expected, "{body} {keys}");
            assert!(cost.seconds > 0.0 && cost.seconds < 1e-3, "{cost:?}");
        }
    }
}
