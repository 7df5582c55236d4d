//! Turned tips as long runs.

use super::{TipError, TipSimulation};
use crate::tip::scene::TipScene;
use std::ops::ControlFlow;
use tribos_base::record::frames::{Bodies, Frame};
use tribos_base::run::{Cause, LongRun};

impl LongRun for TipSimulation {
    type Scene = TipScene;

    /// The crystal is placed at once.
    fn begin(
        scene: &TipScene,
        checkpoint: Option<&str>,
        _: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, TipError> {
        match checkpoint {
            Some(text) => Self::resume(scene, text),
            None => Self::new(scene),
        }
    }

    fn cause(error: &TipError) -> Cause {
        match error {
            TipError::Checkpoint(_) => Cause::Checkpoint,
            _ => Cause::Scene,
        }
    }

    fn checkpoint(&self) -> String {
        self.checkpoint()
    }

    fn steps(&self) -> u64 {
        self.system().steps()
    }

    fn bodies(&self, limit: u64) -> Bodies {
        self.bodies(limit)
    }

    fn frame(&self) -> Frame {
        self.frame()
    }
}
