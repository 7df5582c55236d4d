//! The figures, tables and sections of the thesis, a module for each or for a few that belong together.

pub(crate) mod asymptotics;
pub(crate) mod classical;
pub(crate) mod contact_exhibits;
pub(crate) mod contact_laws;
pub(crate) mod contact_thresholds;
pub(crate) mod contact_trials;
pub(crate) mod coupling;
pub(crate) mod creep;
pub(crate) mod deposit;
pub(crate) mod double_disk;
pub(crate) mod growth;
pub(crate) mod ice;
pub(crate) mod interval;
pub(crate) mod local_law;
pub(crate) mod lubrication;
pub(crate) mod odd;
pub(crate) mod onset;
pub(crate) mod packing;
pub(crate) mod pipe;
pub(crate) mod porosity;
pub(crate) mod pressure;
pub(crate) mod pressure_modes;
pub(crate) mod stopping;
pub(crate) mod stress;
pub(crate) mod tilted;
pub(crate) mod tip;
