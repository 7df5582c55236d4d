//! The compiled half of the Python package `tribos`: the kernel and the library on numpy arrays.
//!
//! Python's half, in `python/tribos`, has the public classes, their documentation and their checks of
//! types; here are the loops. Nothing of this module is public: it is `tribos._native`.

mod any_pressure;
mod arrays;
mod command;
mod contact;
mod fit;
mod friction;
mod law;
mod manifold;
mod model;
mod patch;
mod push;
mod surface;
mod threads;

use pyo3::prelude::*;

/// Loops of the package `tribos`, which documents them.
#[pymodule(gil_used = false)]
mod _native {
    use super::*;

    #[pymodule_export]
    use any_pressure::AnyPressure;
    #[pymodule_export]
    use command::command;
    #[pymodule_export]
    use contact::ContactLaw;
    #[pymodule_export]
    use fit::{fit_law, fit_laws, fit_support, predict_law};
    #[pymodule_export]
    use friction::Friction;
    #[pymodule_export]
    use law::{Law, laws};
    #[pymodule_export]
    use manifold::Manifold;
    #[pymodule_export]
    use patch::Patch;
    #[pymodule_export]
    use push::{
        line_boundary, line_grip, motion_cone, nearest_side, push_along, push_modes, pushes,
    };
    #[pymodule_export]
    use surface::LimitSurface;
    #[pymodule_export]
    use threads::{num_threads, set_num_threads};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
