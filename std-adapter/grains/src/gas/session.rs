//! Gases as long runs.

use super::GasSimulation;
use crate::gas::scene::GasScene;
use crate::packing::PackingRunError;
use std::ops::ControlFlow;
use tribos_base::record::frames::{Bodies, Frame};
use tribos_base::run::{Cause, LongRun};

impl LongRun for GasSimulation {
    type Scene = GasScene;

    fn begin(
        scene: &GasScene,
        checkpoint: Option<&str>,
        growing: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, PackingRunError> {
        Self::begin(scene, checkpoint, growing)
    }

    fn cause(error: &PackingRunError) -> Cause {
        error.cause()
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
