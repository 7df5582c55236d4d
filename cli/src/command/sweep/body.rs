//! One run of a sweep: any body, from its scene to its summary.

use super::kind::Kind;
use super::refusal;
use crate::command::bodies;
use crate::command::digits::shown;
use crate::command::interrupt;
use crate::command::run::size::{Allowed, check};
use crate::command::run::tip;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::error::Error;
use std::sync::Arc;
use tribos::powder::Compaction;
use tribos::run::folder::Lock;
use tribos::run::{LongRun, RunError, Session, Start};
use tribos::scene::{PowderScene, Scene, SliderScene, TipScene, parse_scene};
use tribos::slide::{self, PlanarScene, SlideError};
use tribos::tip::TipRun;

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
    pub fn run(&self, folder: &Arc<Lock>) -> Result<(Value, String), Failure> {
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

/// Why there is no result.
pub enum Unfinished {
    /// The scene cannot be run: the same every time.
    Refused(Failure),
    /// Something other than the scene.
    Stopped(Failure),
}

impl<E: Error + Into<Failure>> From<RunError<E>> for Unfinished {
    fn from(error: RunError<E>) -> Self {
        match error {
            RunError::Scene(error) => Self::Refused(error.into()),
            error => Self::Stopped(error.into()),
        }
    }
}

impl From<SlideError> for Unfinished {
    fn from(error: SlideError) -> Self {
        Self::Refused(error.into())
    }
}

/// A powder, resumed from a checkpoint if there is one.
pub fn compact(scene: &PowderScene, lock: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
    check(&tribos::powder::size(scene), "spheres", Allowed::Usual).map_err(Unfinished::Refused)?;
    let run: Compaction = session(lock).run(scene)?;
    let outcome = run.outcome();
    let told = format!(
        "porosity {} % after {} steps, {:.1} s",
        shown(100.0 * outcome.porosity[1]),
        outcome.steps,
        outcome.wall_seconds
    );
    Ok((outcome.json(scene), told))
}

/// A tip, resumed from a checkpoint if there is one.
pub fn turn(scene: &TipScene, lock: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
    check(&tribos::tip::size(scene), "atoms", Allowed::Usual).map_err(Unfinished::Refused)?;
    let run: TipRun = session(lock).run(scene)?;
    let outcome = run.outcome();
    let written = lock.check().map_err(Failure::from);
    written
        .and_then(|()| tip::write_series(&run, lock.folder()))
        .map_err(Unfinished::Stopped)?;
    let told = format!(
        "{} degrees driven, {} after it",
        shown(outcome.driven_angle),
        shown(outcome.final_angle)
    );
    Ok((outcome.json(scene), told))
}

/// A run without frames, resumed if it can be.
fn session<R: LongRun>(lock: &Arc<Lock>) -> Session<'_, R> {
    Session::under(lock.clone(), lock.folder())
        .start(Start::ResumeIfPossible)
        .frames(0)
        .without_final_checkpoint()
        .cancel_when(interrupt::is_asked)
}
