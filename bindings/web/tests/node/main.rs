//! The package in Node: its own tests, and the bits of the kernel.

mod bits;
mod package;
mod separate;
mod words;
