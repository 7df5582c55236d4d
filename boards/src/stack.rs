//! Stack use of a call: the free stack is painted before the call and searched for paint after it.

use core::arch::asm;

/// Pattern with which the free stack is painted.
const PAINT: usize = 0xc5a3_5ac5;
const WORD: usize = size_of::<usize>();
/// Largest number of bytes painted for one measurement.
const PAINTED: usize = 128 * 1024;
/// Bytes above the statics that must still be painted when a program ends.
const GUARD: usize = 64;
/// The smallest reported depth, close to that of the saved registers of the call itself.
const FLOOR: usize = 64;

unsafe extern "C" {
    /// First byte after the statics; the stack grows down towards it.
    static mut __sheap: u8;
}

fn bottom() -> usize {
    (&raw const __sheap).addr().next_multiple_of(WORD)
}

#[inline(always)]
fn stack_pointer() -> usize {
    let sp;
    // SAFETY: reads a register.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("mov {}, sp", out(reg) sp, options(nomem, nostack, preserves_flags));
        #[cfg(any(target_arch = "riscv32", target_arch = "riscv64"))]
        asm!("mv {}, sp", out(reg) sp, options(nomem, nostack, preserves_flags));
    }
    sp
}

/// Fills the words of `from..to` with paint. In assembly, so that it needs no stack of its own.
///
/// # Safety
/// Both ends are aligned, `from < to`, and nothing live lies between them.
#[inline(always)]
unsafe fn paint(from: usize, to: usize) {
    // SAFETY: by the contract above.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!(
            "2:", "str {paint}, [{at}]", "adds {at}, #4", "cmp {at}, {to}", "blo 2b",
            at = inout(reg) from => _, to = in(reg) to, paint = in(reg) PAINT, options(nostack)
        );
        #[cfg(target_arch = "riscv32")]
        asm!(
            "2:", "sw {paint}, 0({at})", "addi {at}, {at}, 4", "bltu {at}, {to}, 2b",
            at = inout(reg) from => _, to = in(reg) to, paint = in(reg) PAINT, options(nostack)
        );
        #[cfg(target_arch = "riscv64")]
        asm!(
            "2:", "sd {paint}, 0({at})", "addi {at}, {at}, 8", "bltu {at}, {to}, 2b",
            at = inout(reg) from => _, to = in(reg) to, paint = in(reg) PAINT, options(nostack)
        );
    }
}

/// The first word of `from..to` that lost its paint.
fn first_used(from: usize, to: usize) -> Option<usize> {
    // SAFETY: aligned words of RAM between the statics and the stack pointer.
    (from..to)
        .step_by(WORD)
        .find(|&at| unsafe { (at as *const usize).read_volatile() } != PAINT)
}

pub(crate) fn set_guard() {
    let from = bottom();
    if stack_pointer() > from + 2 * GUARD {
        // SAFETY: lies between the statics and the stack pointer.
        unsafe { paint(from, from + GUARD) };
    }
}

pub(crate) fn guard_holds() -> bool {
    first_used(bottom(), bottom() + GUARD).is_none()
}

/// Bytes of stack that are free at the call.
pub fn free() -> usize {
    stack_pointer().saturating_sub(bottom())
}

/// Bytes of stack that a call needs, to the word; 64 stands for "64 or less".
///
/// At most 128 KiB below the caller are observed: a result of 128 KiB means at least that.
#[inline(never)]
pub fn stack_used(work: &mut dyn FnMut()) -> usize {
    let top = stack_pointer() & !(WORD - 1);
    let from = (bottom() + GUARD).max(top.saturating_sub(PAINTED));
    if from < top {
        // SAFETY: all below the stack pointer is free, and the statics end below `from`.
        unsafe { paint(from, top) };
    }
    work();
    let deepest = first_used(from, top).unwrap_or(top);
    (top - deepest).max(FLOOR)
}
