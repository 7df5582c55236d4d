//! Grains as long runs.

use super::{GrainsError, GrainsSimulation, PlacementError};
use crate::grains::scene::GrainsScene;
use std::ops::ControlFlow;
use tribos_base::record::frames::{Bodies, Frame};
use tribos_base::run::{Cause, LongRun};

impl LongRun for GrainsSimulation {
    type Scene = GrainsScene;

    fn begin(
        scene: &GrainsScene,
        checkpoint: Option<&str>,
        growing: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Self, GrainsError> {
        Self::begin(scene, checkpoint, growing)
    }

    fn cause(error: &GrainsError) -> Cause {
        error.cause(|placement| matches!(placement, PlacementError::Stopped))
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
