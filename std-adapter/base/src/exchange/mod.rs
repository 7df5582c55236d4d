//! Atoms, spheres and triangles in files of other programs: LAMMPS data and dumps, extended XYZ, STL; what columns of any file
//! mean.

pub mod atoms;
pub mod configuration;
pub mod extended_xyz;
pub mod lammps;
pub mod sphere_columns;
pub mod spheres;
pub mod stl;
pub mod text;
