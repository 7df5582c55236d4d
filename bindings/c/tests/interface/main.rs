//! The C interface: its header, its programs, its refusals.

mod batches;
mod digest;
mod examples;
mod feet;
mod fitted;
mod header;
mod kernel;
mod manifold;
mod programs;
mod refusals;
