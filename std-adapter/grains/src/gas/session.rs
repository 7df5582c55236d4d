//! Gases as long runs, with their frames.

use super::GasSimulation;
use super::time_stepped::DENSITY;
use crate::gas::scene::GasScene;
use crate::packing::PackingRunError;
use std::ops::ControlFlow;
use tribos_base::record::frames::{Bodies, Frame, Kind};
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

    /// Data common to all frames of the film, which keeps at most `limit` of them.
    fn bodies(&self, limit: u64) -> Bodies {
        Bodies {
            kind: Kind::Gas,
            scene: self.scene().json(),
            limit,
            stride: 1,
            sides: [self.length(); 2],
            periods: [Some(self.length()); 3],
            radii: vec![1.0; self.scene().count],
            materials: Vec::new(),
            densities: vec![DENSITY; self.scene().count],
            layers: Vec::new(),
            parts: Vec::new(),
            marked: Vec::new(),
        }
    }

    /// The current state; its measure is the translational temperature.
    fn frame(&self) -> Frame {
        let state = self.state();
        let length = self.length() as f32;
        let velocities = || state.motions.iter().map(|motion| motion.velocity);
        Frame {
            step: self.steps(),
            time: self.time(),
            height: self.length(),
            tilt: 0.0,
            measure: state.temperatures().translational,
            corners: [[0.0; 3], [length; 3]],
            places: state.places,
            speeds: velocities().map(|v| v.norm() as f32).collect(),
            velocities: velocities().map(|v| v.cast()).collect(),
            ..Frame::default()
        }
    }
}
