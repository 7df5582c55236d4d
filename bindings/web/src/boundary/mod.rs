//! The exported functions. Only here are names exported, which Rust counts as unsafe.
//!
//! Numbers come as arguments. The value is a status: 0 after success; 1 after a refusal, whose reason stands at
//! [`reason`]; 2 if the reason ends with the first number of the result. Results of fixed size stand at
//! [`result`]; rows without fixed number are in memory of the caller, and their number is the result.
//!
//! `patch` is the handle of a prepared patch, or 0 for the disk of `radius` and `mu` under Coulomb friction.
//!
//! # Safety
//!
//! One contract for all functions: a pointer leads to as many aligned numbers as its count says, which do not
//! overlap those of another argument. JavaScript has them in pages of its own.

// Exported names, and memory of the caller.
#![allow(unsafe_code, unsafe_op_in_unsafe_fn)]
// The flat interface of WebAssembly; the contract above.
#![allow(clippy::too_many_arguments, clippy::missing_safety_doc)]

mod addresses;
mod friction;
mod motion;
mod sets;

#[cfg(feature = "all")]
mod contacts;
#[cfg(feature = "all")]
mod floor;
#[cfg(feature = "all")]
mod prepared;

pub use addresses::*;
#[cfg(feature = "all")]
pub use contacts::*;
#[cfg(feature = "all")]
pub use floor::*;
pub use friction::*;
pub use motion::*;
#[cfg(feature = "all")]
pub use prepared::*;
pub use sets::*;

/// Rows of the caller, to be read and written.
unsafe fn rows<'a, const N: usize>(from: *mut [f64; N], count: usize) -> &'a mut [[f64; N]] {
    core::slice::from_raw_parts_mut(from, count)
}
