//! Atoms, tips and deposits.

mod deposit;
mod exports;
mod md_dynamics;
mod md_files;
mod md_forces;
mod md_lammps;
mod md_neighbours;
mod neighbours;
mod soft_contacts;
mod soft_worlds;
mod tip_metal;
mod tip_run;
mod tip_scenes;
mod tip_shape;
mod tip_slid;
