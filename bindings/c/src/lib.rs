//! The friction kernel for programs in C: `include/tribos.h` and a static library.
//!
//! This crate contains no logic of its own. Each function checks its pointers, builds the
//! kernel's types from plain structures, calls the kernel and writes the result: the same
//! arguments give the same bits as `tribos-core`. `docs/c.md` explains how to build and link.
//!
//! Everything exists twice, in [`double`] and [`single`]; `build.rs` generates the second from the
//! source of the first.
//!
//! # Safety
//!
//! One contract holds for all functions: a pointer is null, which is refused, or points to memory
//! of its type that is aligned and, for arguments, initialised; a pointer to an array comes with
//! the number of its elements and does not overlap the results. No pointer is kept after the call,
//! except that a polygon names the memory of its edges.
#![no_std]

// On hosts the standard library brings the panic handler that a static library needs.
#[cfg(not(target_os = "none"))]
extern crate std;

pub mod choice;
mod fields;
mod memory;
pub mod status;
pub mod table;

/// The interface in double precision.
pub mod double {
    pub mod batch;
    pub mod contact;
    pub mod feet;
    pub mod law;
    pub mod nodes;
    pub mod patch;
    pub mod patch_batch;
    pub mod patch_surface;
    pub mod piece;
    pub mod planar;
    pub mod polygon;
    pub mod shape;
    pub mod slider;
    pub mod surface;
    pub mod update;
    pub mod vectors;
}

/// The interface in single precision.
pub mod single {
    include!(concat!(env!("OUT_DIR"), "/single.rs"));
}

/// The library has no panics: an image without its unused sections does not contain this function, as
/// `arm-none-eabi-nm` shows. A panic would stop here.
#[cfg(all(target_os = "none", feature = "panic-handler"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    tribos_panicked()
}

/// A symbol that is easy to find in an image.
#[cfg(all(target_os = "none", feature = "panic-handler"))]
#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn tribos_panicked() -> ! {
    loop {
        core::hint::spin_loop();
    }
}
