//! How the friction of a sliding body is evaluated, and what that costs.

use super::SlideError;
use super::path::resistance;
use crate::scene::{PlanarBody, PlanarScene, SliderScene};
use std::hint::black_box;
use std::time::{Duration, Instant};
use tribos_core::coupling::table::{Coulomb, Table64};
use tribos_core::coupling::{Annulus, Coupling, ReducedWrench};
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

    /// Times evaluations over a mix of speeds, a tenth of a second long. *Accuracy*: a few per cent of
    /// the ratio, some ten of the times.
    pub fn evaluation_cost(&self) -> Result<EvaluationCost, SlideError> {
        if self.alpha == 0.0 {
            return Ok(timed(&|v, w| both(Coulomb.reduced_wrench(v, w))));
        }
        let table = Table64::new(self.alpha)?;
        Ok(timed(&|v, w| both(table.reduced_wrench(v, w))))
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

    /// Times evaluations over a mix of speeds, a tenth of a second long. *Accuracy*: a few per cent of
    /// the ratio, some ten of the times.
    pub fn evaluation_cost(&self) -> Result<EvaluationCost, SlideError> {
        let body = resistance(self)?;
        Ok(timed(&|v, w| {
            let [force, _, torque] = body.deceleration([v, 0.0, w]);
            [force, torque]
        }))
    }
}

/// Evaluations that are timed at once, over ratios of the speeds from 1/17 to 17.
const EVALUATIONS: usize = 256;
/// Shortest time of a round: a million ticks of the clock, and far more than an interrupt.
const ROUND: Duration = Duration::from_millis(1);
/// Rounds of each of both; the quickest counts.
const ROUNDS: usize = 40;

/// Force and torque at a sliding speed and a rim speed. Both are asked for through a pointer: two
/// of the same kind run the same instructions.
type Evaluated<'a> = &'a dyn Fn(f64, f64) -> [f64; 2];

/// Time of one evaluation, the least of interleaved rounds with the table's.
fn timed(evaluate: Evaluated<'_>) -> EvaluationCost {
    let table = |v, w| both(Coulomb.reduced_wrench(v, w));
    let passes = [passes(evaluate), passes(&table)];
    let mut cost = EvaluationCost {
        seconds: f64::INFINITY,
        table_seconds: f64::INFINITY,
    };
    for _ in 0..ROUNDS {
        cost.seconds = cost.seconds.min(round(evaluate, passes[0]));
        cost.table_seconds = cost.table_seconds.min(round(&table, passes[1]));
    }
    cost
}

fn both(wrench: ReducedWrench<f64>) -> [f64; 2] {
    [wrench.force, wrench.torque]
}

/// How often all evaluations fill a round.
fn passes(evaluate: Evaluated<'_>) -> u32 {
    let mut passes = 1;
    loop {
        let start = Instant::now();
        pass(evaluate, passes);
        if start.elapsed() >= ROUND || passes >= 1 << 20 {
            return passes;
        }
        passes *= 2;
    }
}

/// Time of one evaluation in a round.
fn round(evaluate: Evaluated<'_>, passes: u32) -> f64 {
    let start = Instant::now();
    pass(evaluate, passes);
    start.elapsed().as_secs_f64() / (EVALUATIONS as f64 * f64::from(passes))
}

/// All evaluations, so many times. Not inlined: the compiler makes one version of it.
#[inline(never)]
fn pass(evaluate: Evaluated<'_>, passes: u32) {
    for _ in 0..passes {
        for k in 0..EVALUATIONS {
            let share = (k as f64 + 0.5) / EVALUATIONS as f64;
            let (v, w) = (1.0 / 16.0 + share, 1.0 + 1.0 / 16.0 - share);
            black_box(evaluate(black_box(v), black_box(w)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, parse_scene, vocabulary};

    #[test]
    fn a_table_costs_as_much_as_itself() {
        let text = vocabulary("disk").unwrap().least_text();
        let Scene::Disk(scene) = parse_scene("disk", &text, &[]).unwrap() else {
            unreachable!("a disk")
        };
        // On a busy machine a measurement may go wrong, three of them do not.
        let ratio = || {
            let cost = scene.evaluation_cost().unwrap();
            cost.seconds / cost.table_seconds
        };
        let ratios = [(); 3].map(|()| ratio());
        assert!(
            ratios.iter().any(|ratio| (ratio - 1.0).abs() < 0.05),
            "{ratios:?}"
        );
    }

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
