//! Molecular dynamics: atoms that act on each other up to a cut-off.
//!
//! [`atoms`] are kept one array a property, an [`interaction`] acts between those near each other
//! ([`neighbours`]): [`pair`] forces or the embedded-atom method ([`eam`]). A [`system`] moves them
//! group by group ([`group`]), with thermostats ([`thermostat`]) and a torque ([`drive`]); what it
//! does is read off by [`observe`]. A [`configuration`] comes from a file or goes into one:
//! [`lammps`] data and dumps, [`extended_xyz`].

pub mod atoms;
pub mod configuration;
pub mod drive;
pub mod eam;
pub mod extended_xyz;
pub mod group;
pub mod interaction;
pub mod lammps;
pub mod neighbours;
pub mod observe;
pub mod pair;
pub mod system;
pub mod text;
pub mod thermostat;
