//! Compactions as long runs.

use super::deposit::DepositError;
use super::{CompactionError, PowderSimulation};
use crate::powder::scene::PowderScene;
use std::ops::ControlFlow;
use tribos_base::record::frames::{Bodies, Frame};
use tribos_base::run::{Cause, LongRun};

impl LongRun for PowderSimulation {
    type Scene = PowderScene;

    fn begin(
        scene: &PowderScene,
        checkpoint: Option<&str>,
        growing: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, CompactionError> {
        Self::begin(scene, checkpoint, growing)
    }

    fn cause(error: &CompactionError) -> Cause {
        error.cause(|placement| matches!(placement, DepositError::Stopped))
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
