//! Bodies that slide and spin: paths, rests, final motion, launches.

mod answers;
mod curling;
mod elastic_steps;
mod final_motion;
mod foot;
mod gradual_presliding;
mod holding;
mod holding_verdicts;
mod inverse;
mod node_presliding;
mod other_steppers;
mod planar;
mod planar_scrutiny;
mod planar_steps;
mod presliding;
mod pressure_modes;
mod pressure_stops;
mod published_holds;
mod push;
mod sliders;
