//! The friction kernel for programs in C: `include/tribos.h` and a static library.
//!
//! This crate has no idea of its own. Each function checks its pointers, makes the kernel's types
//! from plain structures, calls the kernel and writes the answer: same arguments, same bits as
//! `tribos-core` gives. `docs/c.md` tells how to build and to link.
//!
//! Everything exists twice, [`double`] and [`single`]; the second is written by `build.rs` from the
//! text of the first.
//!
//! # Safety
//!
//! One contract for all functions: a pointer is null, which is refused, or it leads to memory of
//! its type that is aligned and, for arguments, initialised; a pointer to an array comes with the
//! number of its elements and does not overlap the results. Nothing is kept after the call.
#![no_std]

// On hosts the standard library brings the panic handler that a static library needs.
#[cfg(not(target_os = "none"))]
extern crate std;

pub mod choice;
mod memory;
pub mod status;
pub mod table;

/// The interface in double precision.
pub mod double {
    pub mod contact;
    pub mod law;
    pub mod nodes;
    pub mod patch;
    pub mod slider;
    pub mod surface;
    pub mod update;
    pub mod vectors;
}

/// The interface in single precision.
pub mod single {
    include!(concat!(env!("OUT_DIR"), "/single.rs"));
}

/// Nothing here panics: no image that drops unused sections contains this function, which
/// `arm-none-eabi-nm` shows. Should one do, it stops here.
#[cfg(all(target_os = "none", feature = "panic-handler"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    tribos_panicked()
}

/// A name that is easy to look for.
#[cfg(all(target_os = "none", feature = "panic-handler"))]
#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn tribos_panicked() -> ! {
    loop {
        core::hint::spin_loop();
    }
}
