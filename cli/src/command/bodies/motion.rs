//! Bodies that slide, or hold and slip.

use super::kind::RunKind;
use super::{Commands, NoResult};
use crate::command::digits::shown;
use crate::command::explain::{after, slide as text};
use crate::command::interrupt;
use crate::command::run::motion;
use crate::command::run::request::RunRequest;
use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use tribos::motion::MotionScene;
use tribos::results::{SweptQuantity, swept};
use tribos::run::folder::Lock;
use tribos::scene::Scene;

/// A body, as a scene in motion and as one of any body.
pub struct MotionBody<'a> {
    pub scene: &'a dyn MotionScene,
    pub any: &'a Scene,
}

impl MotionBody<'_> {
    /// The quantities that a sweep averages, with their units unless the scene has none.
    fn quantities(&self) -> Vec<SweptQuantity> {
        let mut all = swept(self.scene.quantities());
        if self.scene.json()["units"] == "dimensionless" {
            for quantity in &mut all {
                quantity.unit = "-";
            }
        }
        all
    }

    /// Those of them that people are shown, with their labels.
    pub fn shown_quantities(&self) -> impl Iterator<Item = (&'static str, SweptQuantity)> {
        let all = self.quantities().into_iter();
        all.filter_map(|quantity| Some((quantity.label?, quantity)))
    }
}

impl Commands for MotionBody<'_> {
    fn is_long(&self) -> bool {
        false
    }

    fn simulate(&self, order: &RunRequest<'_>) -> Result<(), Failure> {
        motion::run(self, order)
    }

    fn kind(&self) -> RunKind {
        let (drawn, share) = self.scene.sweep_view();
        RunKind::of(self.quantities(), drawn, share)
    }

    fn summarize(&self, _: &Arc<Lock>) -> Result<(Value, String), NoResult> {
        let run = self.scene.follow(&mut |_| !interrupt::is_asked())?;
        let summary = run.json(self.scene);
        let told = match run.told.first() {
            Some((head, text)) => format!("{head} {text}"),
            None => {
                let first = self
                    .shown_quantities()
                    .take(2)
                    .map(|(label, quantity)| format!("{label} {}", quantity.text(&summary, shown)));
                first.collect::<Vec<_>>().join(", ")
            }
        };
        Ok((summary, told))
    }

    fn explanation(&self) -> Result<String, Failure> {
        text::text(self.any, self.scene)
    }

    fn account(&self, out: Option<&Path>, _: &str) -> Result<String, Failure> {
        if out.is_some() {
            return Err(Failure::input(
                "--out is for powders, grains, gases and tips; the energy balance of a sliding body needs no run",
            ));
        }
        after::motion(self.any, self.scene)
    }
}
