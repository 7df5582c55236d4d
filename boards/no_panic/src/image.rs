//! Shared parts of both images.

use core::hint::black_box;
use tribos_no_panic::kept::Keeper;

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

impl Keeper for Opaque {
    #[inline(always)]
    fn keep(&mut self, name: &'static str, address: *const ()) {
        black_box((name, address));
    }
}
