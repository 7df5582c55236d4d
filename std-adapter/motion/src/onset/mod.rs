//! The onset of sliding: what a contact holds under force and torque before it slides, by a model of
//! its bonds.
//!
//! A patch by name ([`Patch`]), bonds by name ([`Bond`]), and the surface of pushes at which the body lets go
//! ([`OnsetSurface`]), beside the limit surface of dry friction. The kernel's [`tribos_core::bond`] has
//! the laws and the search; here are nodes for every patch, names and tables.
//!
//! The model is in the spirit of S. R. Dahmen, Z. Farkas, H. Hinrichsen, D. E. Wolf, Phys. Rev. E 71
//! (2005) 066602 and J. Stat. Mech. (2005) P03004; their equations are not used.
//!
//! ```
//! use tribos::friction::Patch;
//! use tribos::onset::{OnsetContact, OnsetSurface};
//! let contact = OnsetContact { coefficient: 0.4, load: 1.7, radius: 0.04, ..OnsetContact::default() }; // N, m
//! let surface = OnsetSurface::new(&Patch::Disk, "weibull:m=2".parse()?, &contact, 9)?;
//! let summary = surface.summary();
//! assert!((summary.force - 0.4 * 1.7).abs() < 1e-12); // N
//! assert!((summary.arm_ratio() - 0.6231).abs() < 1e-4); // T_s/(F_s R)
//! # Ok::<(), tribos::friction::FrictionError>(())
//! ```

mod bond;
mod law;
mod nodes;
mod strips;
mod surface;
#[cfg(test)]
mod tests;

pub use bond::Bond;
#[doc(hidden)]
pub use law::AnyBond;
pub use surface::{OnsetContact, OnsetPoint, OnsetSummary, OnsetSurface};

#[cfg(doc)]
use tribos_friction::Patch;
