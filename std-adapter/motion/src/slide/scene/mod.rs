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
