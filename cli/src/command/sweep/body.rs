//! One run of a sweep: any body, from its scene to its summary.

use super::refusal;
use crate::command::bodies::{self, NoResult, RunKind};
use crate::failure::Failure;
use serde_json::{Value, json};
use std::sync::Arc;
use tribos::run::folder::Lock;
use tribos::scene::{Key, Scene};

/// A scene that a sweep runs.
#[derive(Debug)]
pub struct Body(Scene);

impl Body {
    /// The scene of this text with overrides; `name` stands for its file in messages.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, Failure> {
        let scene = Scene::parse(name, text, overrides).map_err(Failure::input)?;
        Ok(Self(scene))
    }

    /// What is run.
    pub fn scene(&self) -> &Scene {
        &self.0
    }

    /// The keys of its scene.
    pub fn keys(&self) -> &'static [Key] {
        self.0.as_body().keys()
    }

    /// The seed, of bodies that have one.
    pub fn seed(&self) -> Option<u64> {
        self.0.json()["seed"].as_u64()
    }

    /// Whether it goes on from a state that is given.
    pub fn starts_from(&self) -> bool {
        self.0.json()["initial_state"].is_string()
    }

    /// What a table is made of.
    pub fn kind(&self) -> RunKind {
        bodies::of(&self.0).kind()
    }

    /// Runs to the end, on from a checkpoint if there is one: the summary, and a line about it.
    ///
    /// A scene that is refused, at its start or during its run, has a summary too: it is refused every time.
    pub fn run(&self, folder: &Arc<Lock>) -> Result<(Value, String), Failure> {
        bodies::of(&self.0)
            .summarize(folder)
            .or_else(|end| match end {
                NoResult::Refused(failure) => {
                    let reason = failure.to_string();
                    let mut summary = json!({"scene": self.0.json()});
                    refusal::note(&mut summary, &reason);
                    Ok((summary, format!("refused: {reason}")))
                }
                NoResult::Stopped(failure) => Err(failure),
            })
    }
}
