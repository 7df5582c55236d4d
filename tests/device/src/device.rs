//! What programs of a GPU need beside the kernel.

use core::arch::nvptx::{_block_dim_x, _block_idx_x, _thread_idx_x, trap};

/// No function of the kernel can panic; where one could, this would be in the device code, and `ptx.py` would refuse it.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: ends the program.
    unsafe { trap() }
}

/// Calls `of` with this thread's row.
#[inline(always)]
pub(crate) fn each_row(rows: u64, of: impl Fn(usize)) {
    // SAFETY: they read registers.
    let [block, width, thread] =
        unsafe { [_block_idx_x(), _block_dim_x(), _thread_idx_x()] }.map(|index| index as u64);
    let row = block * width + thread;
    if row < rows {
        of(row as usize);
    }
}
