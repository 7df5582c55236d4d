//! Bodies that slide and spin: paths, rests, final motion, launches.

#[cfg(feature = "library")]
mod answers;
#[cfg(feature = "library")]
mod curling;
mod elastic_steps;
mod final_motion;
mod foot;
mod gradual_presliding;
mod holding;
mod holding_verdicts;
#[cfg(feature = "library")]
mod inverse;
mod node_presliding;
mod other_steppers;
#[cfg(feature = "library")]
mod planar;
#[cfg(feature = "library")]
mod planar_scrutiny;
mod planar_steps;
mod presliding;
mod pressure_modes;
mod pressure_stops;
mod published_holds;
#[cfg(feature = "library")]
mod push;
#[cfg(feature = "library")]
mod sliders;
