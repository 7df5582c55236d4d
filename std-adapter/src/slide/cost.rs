//! How the friction of a sliding body is evaluated, and what that costs.

use super::SlideError;
use super::planar::Resistance;
use crate::scene::{FootPressure, SliderScene};
use std::hint::black_box;
use std::time::{Duration, Instant};
use tribos_core::coupling::table::{Coulomb, Table64};
use tribos_core::coupling::{Annulus, Coupling, ReducedWrench};

/// Where force and torque come from.
///
/// ```
/// use tribos::scene::{CylinderScene, FootPressure, SliderScene};
/// use tribos::slide::{Evaluation, PlanarScene};
/// let disk = SliderScene::default();
/// assert_eq!(disk.evaluation(), Evaluation::CoulombTable);
/// assert_eq!(SliderScene { alpha: -0.5, ..disk }.evaluation(), Evaluation::PowerTable);
/// let hertz = CylinderScene { pressure: FootPressure::Hertz, ..CylinderScene::default() };
/// assert_eq!(hertz.evaluation(), Evaluation::PressureTable);
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
/// use tribos::scene::SliderScene;
/// use tribos::slide::EvaluationCost;
/// let cost: EvaluationCost = SliderScene::default().evaluation_cost()?;
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

impl Evaluation {
    /// Of a round foot.
    pub(crate) fn round(alpha: f64, pressure: FootPressure) -> Self {
        match (alpha == 0.0, pressure == FootPressure::Uniform) {
            (true, true) => Self::CoulombTable,
            (false, true) => Self::PowerTable,
            _ => Self::PressureTable,
        }
    }

    /// Of a band.
    pub(crate) fn band(inner_ratio: f64) -> Self {
        if inner_ratio > Annulus::<f64, Coulomb>::MAX_INNER_RATIO {
            Self::PressureTable
        } else {
            Self::AnnulusTable
        }
    }
}

/// The cost of a body's resistance, with the lateral force and the leaning pressure.
pub(super) fn resistance_cost(body: &dyn Resistance) -> EvaluationCost {
    timed(&|v, w| {
        let [force, _, torque] = body.deceleration([v, 0.0, w]);
        [force, torque]
    })
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
    use crate::scene::{CurlingScene, CylinderScene, IceModel, PipeScene};
    use crate::slide::PlanarScene;

    #[test]
    fn a_table_costs_as_much_as_itself() {
        let scene = SliderScene::default();
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
        for (alpha, expected) in [
            (0.0, Evaluation::CoulombTable),
            (0.5, Evaluation::PowerTable),
        ] {
            let disk = SliderScene {
                alpha,
                ..SliderScene::default()
            };
            assert_eq!(disk.evaluation(), expected);
            let cost = disk.evaluation_cost().unwrap();
            assert!(cost.seconds > 0.0 && cost.seconds < 1e-3, "{cost:?}");
        }
        let cylinder = CylinderScene::default();
        let hertz = CylinderScene {
            pressure: FootPressure::Hertz,
            ..cylinder
        };
        let pipe = PipeScene::default();
        let thin = PipeScene {
            inner_radius: pipe.radius,
            ..pipe
        };
        let rock = CurlingScene::default();
        let film = CurlingScene {
            model: IceModel::Film,
            ..rock
        };
        let scenes: [(&dyn PlanarScene, Evaluation); 6] = [
            (&cylinder, Evaluation::CoulombTable),
            (&hertz, Evaluation::PressureTable),
            (&pipe, Evaluation::AnnulusTable),
            (&thin, Evaluation::PressureTable),
            (&rock, Evaluation::PressureTable),
            (&film, Evaluation::RingRule { points: 256 }),
        ];
        for (scene, expected) in scenes {
            assert_eq!(scene.evaluation(), expected, "{scene:?}");
            let cost = scene.evaluation_cost().unwrap();
            assert!(cost.seconds > 0.0 && cost.seconds < 1e-3, "{cost:?}");
        }
    }
}
