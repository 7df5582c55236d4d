//! One run of a sweep: any body, from its scene to its summary.

use super::kind::Kind;
use super::refusal;
use crate::command::bodies;
use crate::command::digits::shown;
use crate::command::run::long::{Course, Start, Unfinished, resumed};
use crate::command::run::{powder, tip};
use crate::failure::Failure;
use crate::folder::Lock;
use serde_json::{Value, json};
use std::time::Duration;
use tribos::scene::{PowderScene, Scene, SliderScene, TipScene, parse_scene};
use tribos::slide::{self, PlanarScene, SlideError};

/// Time from one checkpoint of a run to the next.
const PAUSE: Duration = Duration::from_secs(60);

/// A scene that a sweep runs.
#[derive(Debug)]
pub struct Body(Scene);

impl Body {
    /// The scene of this text with overrides; `name` stands for its file in messages.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, Failure> {
        let scene = parse_scene(name, text, overrides).map_err(Failure::input)?;
        Ok(Self(scene))
    }

    /// What is run.
    pub fn scene(&self) -> &Scene {
        &self.0
    }

    /// The seed, of bodies that have one.
    pub fn seed(&self) -> Option<u64> {
        self.0.json()["seed"].as_u64()
    }

    /// What a table is made of.
    pub fn kind(&self) -> &'static Kind {
        bodies::of(&self.0).kind()
    }

    /// Runs to the end, on from a checkpoint if there is one: the summary, and a line about it.
    ///
    /// A scene that is refused, at its start or on its way, has a summary too: it is refused every time.
    pub fn run(&self, folder: &Lock) -> Result<(Value, String), Failure> {
        bodies::of(&self.0).run(folder).or_else(|end| match end {
            Unfinished::Refused(failure) => {
                let reason = failure.to_string();
                let mut summary = json!({"scene": self.0.json()});
                refusal::note(&mut summary, &reason);
                Ok((summary, format!("refused: {reason}")))
            }
            Unfinished::Stopped(failure) => Err(failure),
        })
    }
}

/// A disk, run on the spot.
pub fn slide(scene: &SliderScene) -> Result<(Value, String), Unfinished> {
    let outcome = slide::run(scene, |_| ())?.outcome;
    let (distance, angle) = (shown(outcome.distance), shown(outcome.angle));
    let told = format!("distance {distance}, {angle} rad");
    Ok((outcome.json(scene), told))
}

/// A body in the plane, run on the spot.
pub fn path(scene: &dyn PlanarScene) -> Result<(Value, String), Unfinished> {
    let outcome = slide::run_path(scene)?.outcome;
    let [x, y] = outcome.arrival.point.position.map(shown);
    Ok((outcome.json(scene), format!("{x} m on, curl {y} m")))
}

impl From<SlideError> for Unfinished {
    fn from(error: SlideError) -> Self {
        Self::Refused(error.into())
    }
}

/// A powder, on from a checkpoint if there is one.
pub fn compact(scene: &PowderScene, lock: &Lock) -> Result<(Value, String), Unfinished> {
    let run = resumed(|start| powder::simulate(scene, lock.folder(), &course(start, lock)))?;
    let outcome = run.outcome();
    let told = format!(
        "porosity {} % after {} steps, {:.1} s",
        shown(100.0 * outcome.porosity[1]),
        outcome.steps,
        outcome.wall_seconds
    );
    Ok((outcome.json(scene), told))
}

/// A tip, on from a checkpoint if there is one.
pub fn turn(scene: &TipScene, lock: &Lock) -> Result<(Value, String), Unfinished> {
    let run = resumed(|start| tip::simulate(scene, lock.folder(), &course(start, lock)))?;
    let outcome = run.outcome();
    lock.check()?;
    tip::write_series(&run, lock.folder())?;
    let told = format!(
        "{} degrees driven, {} after it",
        shown(outcome.driven_angle),
        shown(outcome.final_angle)
    );
    Ok((outcome.json(scene), told))
}

fn course(start: Start, lock: &Lock) -> Course<'_> {
    Course::one_of_many(lock, start, PAUSE, 0)
}
