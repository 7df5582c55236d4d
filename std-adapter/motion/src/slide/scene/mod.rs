//! Scenes of bodies that slide to rest.

mod curling;
mod cylinder;
mod pipe;
mod planar;
mod plate;
mod slider;

pub use curling::{CurlingScene, IceModel};
pub use cylinder::CylinderScene;
pub use pipe::PipeScene;
pub use planar::{FootPressure, Tipping};
pub use plate::PlateScene;
pub use slider::{DiskScene, SliderIntegrator, Units};

use crate::slide::{PATH_COLUMNS, SlideError, run_planar};
use tribos_base::golden::{Measure, Measurement};

/// Implements what golden files ask of scenes.
macro_rules! measured {
    ($($scene:ty),+) => {$(
        impl Measure for $scene {
            type Error = SlideError;

            fn measured(&self, _: &mut dyn FnMut()) -> Result<Measurement, SlideError> {
                let run = run_planar(self)?;
                let rows = run.series.iter().map(|row| row.to_vec());
                let summary = run.outcome.json(self);
                Ok(Measurement::new(&summary, &PATH_COLUMNS, rows))
            }
        }
    )+};
}
measured!(CurlingScene, CylinderScene, PipeScene, PlateScene);
