//! One run of a sweep: any body, from its scene to its summary.

use super::kind::{self, Kind};
use super::refusal;
use crate::command::digits::shown;
use crate::command::interrupt;
use crate::command::run::tip;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::error::Error;
use std::sync::Arc;
use tribos::powder::Compaction;
use tribos::run::folder::Lock;
use tribos::run::{LongRun, RunError, Session, Start};
use tribos::scene::{self, PlanarScene, PowderScene, Scene, SliderScene, TipScene};
use tribos::slide::{self, SlideError};
use tribos::tip::TipRun;

/// A scene that a sweep runs.
#[derive(Debug)]
pub enum Body {
    /// A flat disk on a straight path.
    Disk(Box<SliderScene>),
    /// A body along a path in the plane.
    Planar(Box<PlanarScene>),
    /// A powder under a piston.
    Powder(Box<PowderScene>),
    /// A tip on a substrate.
    Tip(Box<TipScene>),
}

impl Body {
    /// The scene of this text with overrides; `name` stands for its file in messages.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, Failure> {
        let scene = scene::parse_scene(name, text, overrides).map_err(Failure::input)?;
        Ok(match scene {
            Scene::Disk(scene) => Self::Disk(Box::new(scene)),
            Scene::Planar(scene) => Self::Planar(Box::new(scene)),
            Scene::Powder(scene) => Self::Powder(scene),
            Scene::Tip(scene) => Self::Tip(scene),
        })
    }

    /// The seed, of bodies that have one.
    pub fn seed(&self) -> Option<u64> {
        match self {
            Self::Disk(_) | Self::Planar(_) => None,
            Self::Powder(scene) => Some(scene.seed),
            Self::Tip(scene) => Some(scene.seed),
        }
    }

    /// The scene as its summary has it.
    pub fn json(&self) -> Value {
        match self {
            Self::Disk(scene) => scene.json(),
            Self::Planar(scene) => scene.json(),
            Self::Powder(scene) => scene.json(),
            Self::Tip(scene) => scene.json(),
        }
    }

    /// What a table is made of.
    pub fn kind(&self) -> &'static Kind {
        match self {
            Self::Disk(_) => &kind::DISK,
            Self::Planar(_) => &kind::PLANAR,
            Self::Powder(_) => &kind::POWDER,
            Self::Tip(_) => &kind::TIP,
        }
    }

    /// Runs to the end, on from a checkpoint if there is one: the summary, and a line about it.
    ///
    /// A scene that is refused, at its start or on its way, has a summary too: it is refused every time.
    pub fn run(&self, folder: &Arc<Lock>) -> Result<(Value, String), Failure> {
        self.done(folder).or_else(|end| match end {
            Unfinished::Refused(failure) => {
                let reason = failure.to_string();
                let mut summary = json!({"scene": self.json()});
                refusal::note(&mut summary, &reason);
                Ok((summary, format!("refused: {reason}")))
            }
            Unfinished::Stopped(failure) => Err(failure),
        })
    }

    fn done(&self, folder: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
        match self {
            Self::Disk(scene) => {
                let outcome = slide::run(scene, |_| ())?.outcome;
                let told = format!(
                    "distance {}, {} rad",
                    shown(outcome.distance),
                    shown(outcome.angle)
                );
                Ok((outcome.json(scene), told))
            }
            Self::Planar(scene) => {
                let outcome = slide::run_path(scene)?.outcome;
                let [x, y] = outcome.arrival.point.position;
                Ok((
                    outcome.json(scene),
                    format!("{} m on, curl {} m", shown(x), shown(y)),
                ))
            }
            Self::Powder(scene) => compact(scene, folder),
            Self::Tip(scene) => turn(scene, folder),
        }
    }
}

/// Why there is no result.
enum Unfinished {
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

fn compact(scene: &PowderScene, lock: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
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

fn turn(scene: &TipScene, lock: &Arc<Lock>) -> Result<(Value, String), Unfinished> {
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
        .cancel_when(interrupt::is_asked)
}
