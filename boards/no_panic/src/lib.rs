//! Proof that no public function of the kernel can panic.
//!
//! The image of `no_panic` holds the address of every public function of `tribos-core`, in both
//! precisions, and a panic handler that calls a function that does not exist: a panic that
//! survives optimisation anywhere fails the link. A function whose address is taken must be
//! compiled for all arguments: the compiler cannot remove a branch from knowledge of a caller. `control`
//! contains one more function, with an index that may be out of bounds: it must not link. `prove` generates
//! the source of both from the compiler's list of public functions and the list of instances, and builds
//! them for three microcontrollers at three optimisation levels.
//!
//! The proof covers the listed functions, for all arguments and the listed type arguments. It does
//! not cover laws or patches implemented by a caller, which may panic themselves, and it does not prove
//! that loops terminate.
#![cfg_attr(target_os = "none", no_std)]

#[cfg(not(target_os = "none"))]
pub mod functions;
