//! A panic handler that cannot be linked: an image that links with it cannot panic.

unsafe extern "C" {
    /// Defined nowhere.
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // SAFETY: never linked, hence never called.
    unsafe { a_panic_is_reachable() }
}
