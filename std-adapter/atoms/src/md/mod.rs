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

mod blocks;
#[doc(hidden)]
pub mod drive;
#[doc(hidden)]
pub mod eam;
#[doc(hidden)]
pub mod group;
pub mod interaction;
mod lanes;
pub mod neighbours;
#[doc(hidden)]
pub mod observe;
pub mod pair;
#[doc(hidden)]
pub mod support;
#[doc(hidden)]
pub mod system;
#[doc(hidden)]
pub mod thermostat;

#[doc(inline)]
pub use tribos_base::exchange::{atoms, configuration};
#[doc(hidden)]
pub use tribos_base::exchange::{extended_xyz, lammps, text};
