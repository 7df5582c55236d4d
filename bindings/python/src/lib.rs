//! The compiled half of the Python package `tribos`: the kernel and the library on numpy arrays.
//!
//! Python's half, in `python/tribos`, has the public classes, their documentation and their checks of
//! types; here are the loops. Nothing of this module is public: it is `tribos._native`.

mod arrays;
mod command;
mod friction;
mod inverse;
mod law;
mod model;
mod modes;
mod patch;
mod planar;
mod slide;
mod state;
mod surface;
mod threads;

use pyo3::prelude::*;

/// Loops of the package `tribos`, which documents them.
#[pymodule(gil_used = false)]
mod _native {
    use super::*;

    #[pymodule_export]
    use command::command;
    #[pymodule_export]
    use friction::Friction;
    #[pymodule_export]
    use inverse::launches;
    #[pymodule_export]
    use law::{Law, laws};
    #[pymodule_export]
    use modes::Profiled;
    #[pymodule_export]
    use patch::Patch;
    #[pymodule_export]
    use planar::{planar_rollout, planar_step};
    #[pymodule_export]
    use slide::Slider;
    #[pymodule_export]
    use state::{LuGre, RateState};
    #[pymodule_export]
    use surface::LimitSurface;
    #[pymodule_export]
    use threads::{num_threads, set_num_threads};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
