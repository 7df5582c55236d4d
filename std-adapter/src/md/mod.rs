//! Molecular dynamics: atoms that act on each other up to a cut-off.
//!
//! [`atoms`] are kept one array a property, an [`interaction`] acts between those near each other
//! ([`neighbours`]): [`pair`] forces. A [`system`] moves them group by group ([`group`]), with
//! thermostats ([`thermostat`]) and a torque ([`drive`]); what it does is read off by [`observe`].

pub mod atoms;
pub mod drive;
pub mod group;
pub mod interaction;
pub mod neighbours;
pub mod observe;
pub mod pair;
pub mod system;
pub mod thermostat;
