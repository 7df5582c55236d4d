//! Proof that no public function of the kernel can panic.
//!
//! The image of `no_panic` holds the address of every public function of `tribos-core`, in both
//! precisions, and a panic handler that calls a function that does not exist: a panic that
//! survives optimisation anywhere fails the link. `control` has one more function, with an index
//! that may be out of bounds: it must not link. `prove` builds both for three microcontrollers at
//! three optimisation levels and reports; `coverage` compares the list with the kernel's source to
//! find missing functions.
//!
//! What this proves: no panic in the functions listed, for all arguments, with the type arguments
//! listed. What it does not prove: the same for a law or patch of the caller's own, which may
//! panic itself, or that loops terminate.
#![cfg_attr(target_os = "none", no_std)]

#[cfg(not(target_os = "none"))]
pub mod coverage;
pub mod kept;
