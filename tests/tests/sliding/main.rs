//! Bodies that slide and spin: paths, rests, final motion, launches.

mod curling;
mod final_motion;
mod foot;
mod holding;
mod inverse;
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
