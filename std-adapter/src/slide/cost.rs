//! How the friction of a sliding body is evaluated, and what that costs.

use super::SlideError;
use super::path::resistance;
use crate::friction::{Evaluation, Law, Patch, RoundPower, Tier, Visitor, visit_disk};
use crate::scene::{PlanarBody, PlanarScene, SliderScene};
use std::hint::black_box;
use std::time::{Duration, Instant};
use tribos_core::coupling::table::Coulomb;
use tribos_core::coupling::{Coupling, ReducedWrench};

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
    /// What an evaluation of force and torque consists of.
    ///
    /// ```
    /// use tribos::friction::Evaluation;
    /// use tribos::scene::{parse_slider, vocabulary};
    /// let text = vocabulary("disk").ok_or("no disk")?.least_text();
    /// let evaluation = |alpha: &str| parse_slider("disk", &text, &[alpha.into()]).map(|s| s.evaluation());
    /// assert_eq!(evaluation("alpha=0")??, Evaluation::TableInProgram);
    /// assert_eq!(evaluation("alpha=-0.5")??, Evaluation::TableMade);
    /// assert_eq!(evaluation("alpha=20")??, Evaluation::Series);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn evaluation(&self) -> Result<Evaluation, SlideError> {
        of_law(&Patch::Disk, &self.law()?)
    }

    /// Times evaluations over a mix of speeds, a tenth of a second long. *Accuracy*: a few per cent of
    /// the ratio, some ten of the times.
    pub fn evaluation_cost(&self) -> Result<EvaluationCost, SlideError> {
        let tier = Tier::serving::<f64>(&Patch::Disk, &self.law()?, None)?;
        Ok(visit_disk(self.alpha, tier, Timed)?)
    }
}

/// The evaluation of a law in the tier that is chosen for it.
fn of_law(patch: &Patch, law: &Law) -> Result<Evaluation, SlideError> {
    Ok(Tier::serving::<f64>(patch, law, None)?.evaluation(patch, law))
}

/// Times the kernel's own type.
struct Timed;

impl Visitor<f64> for Timed {
    type Output = EvaluationCost;
    fn visit<P: RoundPower<f64> + 'static>(self, profile: P) -> EvaluationCost {
        timed(&|v, w| both(profile.reduced_wrench(v, w)))
    }
}

impl PlanarScene {
    /// What an evaluation of force and torque consists of.
    ///
    /// ```
    /// use tribos::friction::Evaluation;
    /// use tribos::scene::{Scene, parse_scene, vocabulary};
    /// let text = vocabulary("cylinder").ok_or("no cylinder")?.least_text();
    /// let parsed = parse_scene("cylinder.toml", &text, &["pressure=hertz".into()])?;
    /// let Scene::Planar(scene) = parsed else { unreachable!() };
    /// assert_eq!(scene.evaluation()?, Evaluation::TableMade);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn evaluation(&self) -> Result<Evaluation, SlideError> {
        match &self.body {
            PlanarBody::Cylinder(cylinder) => {
                let law = Law::power(cylinder.coefficient, cylinder.alpha)?;
                of_law(&cylinder.pressure.into(), &law)
            }
            PlanarBody::Pipe(pipe) => {
                let law = Law::power(pipe.coefficient, pipe.alpha)?;
                of_law(&Patch::band(pipe.inner_ratio), &law)
            }
            PlanarBody::Curling(_, model) if model.name() == "film" => Ok(Evaluation::RingRule {
                points: super::curling::RING_POINTS,
            }),
            // Every law of ice is a power that has tables.
            PlanarBody::Curling(rock, _) => of_law(&rock.patch(), &Law::coulomb(1.0)?),
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
            ("disk", "", Evaluation::TableInProgram),
            ("disk", "alpha=0.5", Evaluation::TableMade),
            ("disk", "alpha=20", Evaluation::Series),
            ("cylinder", "", Evaluation::TableInProgram),
            ("cylinder", "pressure=hertz", Evaluation::TableMade),
            ("pipe", "", Evaluation::TwoTables),
            ("pipe", "inner_radius=0.05", Evaluation::TableMade),
            ("curling", "", Evaluation::TableMade),
            (
                "curling",
                "model=film",
                Evaluation::RingRule { points: 256 },
            ),
        ] {
            let overrides: Vec<String> = keys.split_whitespace().map(String::from).collect();
            let text = vocabulary(body).unwrap().least_text();
            let (evaluation, cost) = match parse_scene(body, &text, &overrides).unwrap() {
                Scene::Disk(scene) => (
                    scene.evaluation().unwrap(),
                    scene.evaluation_cost().unwrap(),
                ),
                Scene::Planar(scene) => (
                    scene.evaluation().unwrap(),
                    scene.evaluation_cost().unwrap(),
                ),
                _ => unreachable!("a sliding body"),
            };
            assert_eq!(evaluation, expected, "{body} {keys}");
            assert!(cost.seconds > 0.0 && cost.seconds < 1e-3, "{cost:?}");
        }
    }
}
