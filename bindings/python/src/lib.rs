//! The compiled half of the Python package `tribos`: the kernel and the library on numpy arrays.
//!
//! Python's half, in `python/tribos`, has the public classes, their documentation and their checks of
//! types; here are the loops. Nothing of this module is public: it is `tribos._native`.

mod any_pressure;
mod arrays;
mod atoms;
mod command;
mod contact;
mod fit;
mod floor;
mod friction;
mod gradients;
mod inverse;
mod law;
mod log;
mod manifold;
mod model;
mod modes;
mod mujoco;
mod packing;
mod particles;
mod patch;
mod planar;
mod push;
mod run;
mod scene;
mod slide;
mod state;
mod strokes;
mod surface;
mod threads;
mod track;
mod vectors;

use pyo3::prelude::*;

/// Loops of the package `tribos`, which documents them.
#[pymodule(gil_used = false)]
mod _native {
    use super::*;

    #[pymodule_export]
    use crate::command::{command, host};
    #[pymodule_export]
    use any_pressure::AnyPressure;
    #[pymodule_export]
    use atoms::{Potential, System};
    #[pymodule_export]
    use contact::ContactLaw;
    #[pymodule_export]
    use fit::{fit_all_laws, fit_law, fit_laws, fit_support, fit_usage, predict_law};
    #[pymodule_export]
    use floor::Floor;
    #[pymodule_export]
    use friction::{Friction, LoadedFriction};
    #[pymodule_export]
    use gradients::{RestMap, SurfaceDerivatives};
    #[pymodule_export]
    use inverse::launches;
    #[pymodule_export]
    use law::{Law, laws};
    #[pymodule_export]
    use log::{log_columns, log_places, look_at, read_file, read_pushes};
    #[pymodule_export]
    use manifold::Manifold;
    #[pymodule_export]
    use modes::PowerLawProfile;
    #[pymodule_export]
    use mujoco::MujocoFeet;
    #[pymodule_export]
    use packing::PackingFile;
    #[pymodule_export]
    use particles::World;
    #[pymodule_export]
    use patch::Patch;
    #[pymodule_export]
    use planar::{planar_rollout, planar_step};
    #[pymodule_export]
    use push::{
        line_boundary, line_grip, motion_cone, nearest_side, push_along, push_modes, pushes,
    };
    #[pymodule_export]
    use run::{Film, Stop, folder_scene, run_at_once, run_scene};
    #[pymodule_export]
    use scene::{library_scenes, scene_of_file, scene_of_settings, scene_of_text, vocabularies};
    #[pymodule_export]
    use slide::Slider;
    #[pymodule_export]
    use state::{LuGre, RateState};
    #[pymodule_export]
    use strokes::strokes_of;
    #[pymodule_export]
    use surface::LimitSurface;
    #[pymodule_export]
    use threads::{num_threads, set_num_threads};
    #[pymodule_export]
    use track::fit_track;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
