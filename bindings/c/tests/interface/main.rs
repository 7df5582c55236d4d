//! The C interface: its header, its programs, its refusals.

mod digest;
mod examples;
mod header;
mod programs;
mod refusals;
