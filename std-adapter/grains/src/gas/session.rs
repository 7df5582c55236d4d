//! Gases as long runs.

use super::{GasError, GasSimulation, GasStartError};
use crate::gas::scene::GasScene;
use std::ops::ControlFlow;
use tribos_base::record::frames::{Bodies, Frame};
use tribos_base::run::{Cause, LongRun};

impl LongRun for GasSimulation {
    type Scene = GasScene;

    fn begin(
        scene: &GasScene,
        checkpoint: Option<&str>,
        growing: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, GasError> {
        Self::begin(scene, checkpoint, growing)
    }

    fn cause(error: &GasError) -> Cause {
        error.cause(|start| matches!(start, GasStartError::Stopped))
    }

    fn checkpoint(&self) -> String {
        self.checkpoint()
    }

    fn steps(&self) -> u64 {
        self.steps()
    }

    fn bodies(&self, limit: u64) -> Bodies {
        self.bodies(limit)
    }

    fn frame(&self) -> Frame {
        self.frame()
    }
}
