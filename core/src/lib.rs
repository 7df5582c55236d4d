//! Coupled sliding and spinning friction: the kernel.
#![no_std]
#![forbid(unsafe_code)]

pub mod coupling;
pub mod law;
pub mod modes;
pub mod patch;
pub mod real;
pub mod slider;
pub mod special;
pub mod twist;

pub use real::Real;
