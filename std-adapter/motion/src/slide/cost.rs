//! How the friction of a sliding body is evaluated, and the cost of an evaluation.

use super::MotionError;
use super::planar::Resistance;
use crate::slide::scene::DiskScene;
use std::hint::black_box;
use std::time::{Duration, Instant};
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::{ReducedFriction, ReducedWrench};
use tribos_friction::{AnyFriction, Evaluation, Law, Patch, RoundPower, Tier, Visitor, visit_disk};

/// Cost of one evaluation. *Units*: s on one core of this machine.
///
/// ```
/// use tribos::scene::DiskScene;
/// use tribos::slide::EvaluationCost;
/// let cost: EvaluationCost = DiskScene::default().evaluation_cost()?;
/// assert!(cost.seconds > 0.0 && cost.seconds < 1e-3);
/// assert!(cost.table_seconds > 0.0); // for comparison
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EvaluationCost {
    /// One evaluation of the scene's friction; in the plane this includes lateral force and leaning pressure.
    pub seconds: f64,
    /// One evaluation of force and torque of a disk under Coulomb's law by table, timed alternately with it.
    pub table_seconds: f64,
}

impl DiskScene {
    /// Method by which force and torque are evaluated.
    ///
    /// ```
    /// use tribos::{friction::Evaluation, scene::DiskScene};
    /// let evaluation = |alpha| DiskScene { alpha, ..DiskScene::default() }.evaluation();
    /// assert_eq!(evaluation(0.0)?, Evaluation::Form);
    /// assert_eq!(evaluation(-0.5)?, Evaluation::TableMade);
    /// assert_eq!(evaluation(20.0)?, Evaluation::Series);
    /// # Ok::<(), tribos::slide::MotionError>(())
    /// ```
    pub fn evaluation(&self) -> Result<Evaluation, MotionError> {
        of_law(&Patch::Disk, &self.law()?)
    }

    /// Times evaluations over a mix of speeds for some tenths of a second. *Accuracy*: a few per cent for the
    /// ratio of the two times, about ten per cent for the times.
    pub fn evaluation_cost(&self) -> Result<EvaluationCost, MotionError> {
        let law = self.law()?;
        let Some([_, alpha]) = law.power_of_speed() else {
            let friction = AnyFriction::<f64>::new(&Patch::Disk, &law, None)?;
            return Ok(timed(&|v, w| both(friction.reduced_wrench(v, w))));
        };
        let tier = Tier::choose::<f64>(&Patch::Disk, &law, None)?;
        Ok(visit_disk(alpha, tier, EvaluationTiming)?)
    }
}

/// Method of evaluation in the tier chosen for the law.
pub(crate) fn of_law(patch: &Patch, law: &Law) -> Result<Evaluation, MotionError> {
    Ok(Tier::choose::<f64>(patch, law, None)?.evaluation(patch, law))
}

/// Times the kernel's type for this friction.
struct EvaluationTiming;

impl Visitor<f64> for EvaluationTiming {
    type Output = EvaluationCost;
    fn visit<P: RoundPower<f64> + 'static>(self, profile: P) -> EvaluationCost {
        timed(&|v, w| both(profile.reduced_wrench(v, w)))
    }
}

/// Cost of a body's resistance, including the lateral force and the leaning pressure.
pub(super) fn resistance_cost(body: &dyn Resistance) -> EvaluationCost {
    timed(&|v, w| {
        let [force, _, torque] = body.deceleration([v, 0.0, w]);
        [force, torque]
    })
}

/// Evaluations timed together, over velocity ratios from 1/17 to 17.
const EVALUATIONS: usize = 256;
/// Shortest duration of a round: a million ticks of the clock, much longer than an interrupt.
const ROUND: Duration = Duration::from_millis(1);
/// Rounds of each of the two, and their time in all where evaluations are slow; the fastest one counts.
const ROUNDS: usize = 40;
const LONGEST: Duration = Duration::from_millis(200);

/// Force and torque at a sliding speed and a rim speed. Both methods are called through a pointer, so that
/// two methods of the same kind execute the same instructions.
type Evaluated<'a> = &'a dyn Fn(f64, f64) -> [f64; 2];

/// Time of one evaluation: the minimum over rounds that alternate with those of the table.
fn timed(evaluate: Evaluated<'_>) -> EvaluationCost {
    let table = |v, w| both(CoulombDisk.reduced_wrench(v, w));
    let passes = [passes(evaluate), passes(&table)];
    let begun = Instant::now();
    let mut cost = EvaluationCost {
        seconds: f64::INFINITY,
        table_seconds: f64::INFINITY,
    };
    for _ in 0..ROUNDS {
        cost.seconds = cost.seconds.min(round(evaluate, passes[0]));
        cost.table_seconds = cost.table_seconds.min(round(&table, passes[1]));
        if begun.elapsed() >= LONGEST {
            break;
        }
    }
    cost
}

fn both(wrench: ReducedWrench<f64>) -> [f64; 2] {
    [wrench.force, wrench.torque]
}

/// Number of repetitions of the whole mix that fill a round.
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

/// Time of one evaluation, averaged over a round.
fn round(evaluate: Evaluated<'_>, passes: u32) -> f64 {
    let start = Instant::now();
    pass(evaluate, passes);
    start.elapsed().as_secs_f64() / (EVALUATIONS as f64 * f64::from(passes))
}

/// Repeats the whole mix `count` times. Not inlined, so that the compiler generates one version of it.
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
    use crate::slide::PlanarScene;
    use crate::slide::scene::{CurlingScene, CylinderScene, FootPressure, IceModel, PipeScene};

    #[test]
    fn every_body_says_where_its_friction_comes_from_and_can_be_timed() {
        for (alpha, expected) in [
            (0.0, Evaluation::Form),
            (0.5, Evaluation::TableMade),
            (20.0, Evaluation::Series),
        ] {
            let disk = DiskScene {
                alpha,
                ..DiskScene::default()
            };
            assert_eq!(disk.evaluation().unwrap(), expected);
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
            (&cylinder, Evaluation::Form),
            (&hertz, Evaluation::Form),
            (&pipe, Evaluation::TwoForms),
            (&thin, Evaluation::Form),
            (&rock, Evaluation::TableMade),
            (&film, Evaluation::RingRule { points: 256 }),
        ];
        for (scene, expected) in scenes {
            assert_eq!(scene.evaluation().unwrap(), expected, "{scene:?}");
            let cost = scene.evaluation_cost().unwrap();
            assert!(cost.seconds > 0.0 && cost.seconds < 1e-3, "{cost:?}");
        }
    }
}
