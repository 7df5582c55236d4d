//! Molecular dynamics: atoms that interact up to a cut-off.
//!
//! [`atoms`] have one array per property; an [`interaction`] acts between neighbours
//! ([`neighbours`]): [`pair`] forces or the embedded-atom method ([`eam`]). A [`system`] moves them
//! group by group ([`group`]), with thermostats ([`thermostat`]) and a torque ([`drive`]);
//! [`observe`] measures energies, temperature and angles. A [`configuration`] is read from or
//! written to a file: [`lammps`] data and dumps, [`extended_xyz`].

pub mod atoms;
#[doc(hidden)]
pub mod configuration;
#[doc(hidden)]
pub mod drive;
pub mod eam;
#[doc(hidden)]
pub mod extended_xyz;
pub mod group;
#[doc(hidden)]
pub mod interaction;
#[doc(hidden)]
pub mod lammps;
#[doc(hidden)]
pub mod neighbours;
#[doc(hidden)]
pub mod observe;
pub mod pair;
pub mod system;
#[doc(hidden)]
pub mod text;
pub mod thermostat;
