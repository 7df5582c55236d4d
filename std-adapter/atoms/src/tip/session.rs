//! Turned tips as long runs, with their frames.

use super::{TipError, TipSimulation};
use crate::tip::scene::TipScene;
use std::ops::ControlFlow;
use tribos_base::record::frames::{Bodies, Frame, Kind};
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

    /// The data that all frames share, with at most `limit` frames. Atoms are balls that touch in
    /// the crystal.
    fn bodies(&self, limit: u64) -> Bodies {
        let shape = self.scene().shape();
        Bodies {
            kind: Kind::Tip,
            scene: self.scene().json(),
            limit,
            stride: self.scene().sample_every.max(1),
            sides: shape.periods(),
            periods: self.system().space().lengths(),
            radii: vec![0.5 * shape.spacing; self.layers().len()],
            materials: Vec::new(),
            densities: Vec::new(),
            layers: self.layers().iter().map(|&layer| layer as u16).collect(),
            parts: self.parts().to_vec(),
            marked: shape.marked().into_iter().map(|atom| atom as u32).collect(),
        }
    }

    /// The current state.
    ///
    /// ```
    /// use tribos::run::LongRun;
    /// use tribos::scene::TipScene;
    /// use tribos::tip::TipSimulation;
    /// let scene = TipScene {
    ///     lambda: 0.01,
    ///     substrate_columns: 8,
    ///     substrate_rows: 8,
    ///     substrate_layers: 4,
    ///     tip_layers: 4,
    ///     tip_side_atoms: 2,
    ///     ..TipScene::default()
    /// };
    /// let run = TipSimulation::new(&scene)?;
    /// let (bodies, frame) = (run.bodies(100), run.frame());
    /// assert_eq!(bodies.radii.len(), frame.places.len());
    /// // Neighbours in the crystal touch, and nothing is turned before the drive.
    /// assert_eq!(bodies.radii[0] + bodies.radii[1], scene.spacings()[0]);
    /// assert_eq!((frame.time, frame.measure), (-scene.equilibration, 0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn frame(&self) -> Frame {
        let [x, y] = self.scene().shape().periods();
        let cell = self.system().space();
        let positions = &self.system().atoms().positions;
        let places: Vec<_> = positions.iter().map(|place| cell.wrap(place)).collect();
        // A box that contains all atoms; its ends are rounded outwards.
        let heights = places.iter().map(|place| place.z);
        let low = heights.clone().fold(f64::INFINITY, f64::min) as f32;
        let high = heights.fold(f64::NEG_INFINITY, f64::max) as f32;
        let velocities = self.system().velocities_on_step();
        Frame {
            step: self.system().steps(),
            time: self.time(),
            height: self.height(),
            tilt: 0.0,
            measure: self.angle().to_degrees(),
            corners: [
                [0.0, 0.0, low.next_down()],
                [x as f32, y as f32, high.next_up()],
            ],
            places,
            speeds: velocities.iter().map(|v| v.norm() as f32).collect(),
            ..Frame::default()
        }
    }
}
