//! Frames of a film of a gas.

use super::run::GasSimulation;
use super::time_stepped::DENSITY;
use tribos_base::record::frames::{Bodies, Frame, Kind};

impl GasSimulation {
    /// Data common to all frames of the film, which keeps at most `limit` of them.
    pub fn bodies(&self, limit: u64) -> Bodies {
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
    pub fn frame(&self) -> Frame {
        let state = self.state();
        let length = self.length() as f32;
        Frame {
            step: self.steps(),
            time: self.time(),
            height: self.length(),
            tilt: 0.0,
            measure: state.temperatures().translational,
            corners: [[0.0; 3], [length; 3]],
            places: state.places,
            speeds: state
                .motions
                .iter()
                .map(|motion| motion.velocity.norm() as f32)
                .collect(),
            contacts: Vec::new(),
        }
    }
}
