//! Contact patches: their shape and how they spread the load.

mod gauss_jacobi;
pub mod nodes;
pub mod polar;
pub mod polygon;
pub mod tripod;
mod uniform_disk;

pub use uniform_disk::UniformDisk;

/// Why a patch was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PatchError {
    /// The radius is not positive and finite.
    Radius {
        /// What was given.
        given: f64,
    },
}

impl core::fmt::Display for PatchError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Radius { given } => {
                write!(
                    f,
                    "the contact radius must be positive and finite, not {given}"
                )
            }
        }
    }
}

impl core::error::Error for PatchError {}
