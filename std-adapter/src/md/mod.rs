//! Molecular dynamics: atoms that interact up to a cut-off.
//!
//! [`atoms`] have one array per property; an [`interaction`] acts between neighbours
//! ([`neighbours`]): [`pair`] forces or the embedded-atom method ([`eam`]). A [`system`] moves them
//! group by group ([`group`]), with thermostats ([`thermostat`]), a torque ([`drive`]) and a
//! moving support ([`support`]); [`observe`] measures energies, temperature and angles. A [`configuration`] is read from or
//! written to a file: [`lammps`] data and dumps, [`extended_xyz`].
//!
//! Forces between atoms of a file are part of the promise: [`configuration`], [`atoms`], [`neighbours`],
//! [`interaction`] and [`pair`]. The other modules serve [`crate::tip`] and the command.

pub mod atoms;
pub mod configuration;
#[doc(hidden)]
pub mod drive;
#[doc(hidden)]
pub mod eam;
#[doc(hidden)]
pub mod extended_xyz;
#[doc(hidden)]
pub mod group;
pub mod interaction;
#[doc(hidden)]
pub mod lammps;
mod lanes;
pub mod neighbours;
#[doc(hidden)]
pub mod observe;
pub mod pair;
pub(crate) mod spheres;
#[doc(hidden)]
pub mod support;
#[doc(hidden)]
pub mod system;
#[doc(hidden)]
pub mod text;
#[doc(hidden)]
pub mod thermostat;
