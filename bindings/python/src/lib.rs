//! The compiled half of the Python package `tribos`: the kernel and the library on numpy arrays.
//!
//! Python's half, in `python/tribos`, has the public classes, their documentation and their checks of
//! types; here are the loops. Nothing of this module is public: it is `tribos._native`.

mod arrays;
mod atoms;
mod command;
mod friction;
mod law;
mod model;
mod particles;
mod patch;
mod run;
mod scene;
mod surface;
mod threads;
mod vectors;

use pyo3::prelude::*;

/// Loops of the package `tribos`, which documents them.
#[pymodule(gil_used = false)]
mod _native {
    use super::*;

    #[pymodule_export]
    use crate::command::{command, host};
    #[pymodule_export]
    use atoms::{Potential, System};
    #[pymodule_export]
    use friction::Friction;
    #[pymodule_export]
    use law::{Law, laws};
    #[pymodule_export]
    use particles::World;
    #[pymodule_export]
    use patch::Patch;
    #[pymodule_export]
    use run::{Film, Stop, folder_scene, run_at_once, run_scene};
    #[pymodule_export]
    use scene::{library_scenes, scene_of_file, scene_of_settings, scene_of_text, vocabularies};
    #[pymodule_export]
    use surface::LimitSurface;
    #[pymodule_export]
    use threads::{num_threads, set_num_threads};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
