//! Proof that no public function of the kernel can panic.
//!
//! The image of `no_panic` holds the address of every public function of `tribos-core`, in both
//! precisions, and a panic handler that calls a function that does not exist: a panic that
//! survives optimisation anywhere fails the link. A function whose address is handed out has to be
//! compiled for all arguments: nothing that a caller knows about them can remove a branch. `control`
//! holds one more function, with an index that may lie outside: it must not link. `prove` writes
//! their source from the compiler's list of public functions and the list of instances, and builds
//! both for three microcontrollers at three optimisation levels.
//!
//! What this proves: no panic in the functions listed, for all arguments, with the type arguments
//! listed. What it does not prove: the same for a law or patch of the caller's own, which may
//! panic itself, or that loops terminate.
#![cfg_attr(target_os = "none", no_std)]

#[cfg(not(target_os = "none"))]
pub mod functions;
