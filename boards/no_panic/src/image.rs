//! Shared parts of both images.

use core::hint::black_box;

mod functions {
    #![allow(clippy::all)] // Written by `prove`.
    include!(env!(
        "TRIBOS_NO_PANIC",
        "is built by `cargo run -p tribos-no-panic --bin prove`"
    ));
}
pub use functions::everything;

unsafe extern "C" {
    /// Defined nowhere.
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: never linked, hence never called.
    unsafe { a_panic_is_reachable() }
}

/// Passes names and addresses to a place that the compiler cannot analyse.
pub struct Opaque;

impl Opaque {
    /// Takes the address of a function.
    #[inline(always)]
    pub fn keep(&mut self, name: &'static str, address: *const ()) {
        black_box((name, address));
    }
}
