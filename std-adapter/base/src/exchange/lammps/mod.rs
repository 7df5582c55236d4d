//! Files of LAMMPS: data (`atom_style atomic`) and text dumps, orthogonal boxes.

mod bounds;
mod columns;
mod data;
mod dump;
mod header;
mod write;

pub use data::read_data;
pub use data::read_spheres;
pub use dump::sphere_frames;
pub use dump::{frames, last_frame};
#[doc(hidden)]
pub use write::{Export, SphereRows, sphere_data_file};
pub use write::{data_file, dump_frame};
