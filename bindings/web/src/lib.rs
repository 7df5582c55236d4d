//! The friction kernel for JavaScript: flat functions of a WebAssembly module.
//!
//! This crate contains next to no logic of its own. Each exported function takes plain numbers, builds
//! the kernel's types, calls the kernel and leaves the result in memory that the caller reads: the same
//! arguments give the same bits as `tribos-core`. `src/*.js` beside it makes objects and errors of it.
//!
//! | module | contents |
//! |---|---|
//! | [`boundary`] | the exported functions |
//! | [`exchange`] | numbers and text that pass between the two sides |
//! | [`friction`] | friction of a contact at one motion, and at rows of them |
//! | [`patch`] | a disk by its numbers, or a prepared patch by its handle |
//! | [`surface`] | limit surfaces, exact and approximate |
//! | [`planar`] | time steps and rollouts |
//! | [`slide`] | free motions to rest |
//! | [`modes`] | final motion |
//!
//! With the feature `all` the same functions serve prepared patches, and the module `all` has what is
//! prepared. Without it the module has no heap, no standard library and no panic.
#![no_std]

// The feature needs it, and on hosts it brings the panic handler that a library needs.
#[cfg(any(feature = "all", not(target_arch = "wasm32")))]
extern crate std;

#[cfg(feature = "all")]
extern crate alloc;

#[cfg(feature = "all")]
pub mod all;
pub mod boundary;
pub mod exchange;
pub mod friction;
pub mod modes;
pub mod patch;
pub mod planar;
pub mod slide;
pub mod surface;

/// There are no panics: the module does not contain this function.
#[cfg(all(not(feature = "all"), target_arch = "wasm32"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
