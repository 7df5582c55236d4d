//! Executed instructions, from the clock of an emulator in which every instruction takes the same time.
//!
//! With `-icount shift=S` QEMU's clock advances by 2^S ns an instruction. The SysTick timer reads
//! that clock on ARM, `minstret` on RISC-V. S is found at start-up by timing a loop of known
//! length, so the same program works with any shift: 10 resolves single instructions on both ARM
//! boards, 0 suits whole programs.

use core::arch::asm;
use core::hint::black_box;
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};

#[cfg(target_arch = "arm")]
#[path = "systick.rs"]
mod clock;
#[cfg(any(target_arch = "riscv32", target_arch = "riscv64"))]
#[path = "minstret.rs"]
mod clock;

/// Instructions of the loop that is timed at start-up.
const KNOWN: u32 = 1 << 19;
/// S + 1; 0 if the clock does not follow the instructions.
static SHIFT: AtomicU32 = AtomicU32::new(0);

/// Executes `count` instructions, up to a constant.
#[inline(never)]
fn spin(count: u32) {
    // SAFETY: counts a register down to zero, by two instructions a round.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("2:", "subs {n}, #1", "bne 2b", n = inout(reg) count / 2 => _, options(nomem, nostack));
        #[cfg(any(target_arch = "riscv32", target_arch = "riscv64"))]
        asm!("2:", "addi {n}, {n}, -1", "bnez {n}, 2b", n = inout(reg) count / 2 => _, options(nomem, nostack));
    }
}

/// Finds the time of an instruction.
pub(crate) fn start() {
    let timed = |count| {
        clock::restart();
        let before = clock::ticks();
        spin(black_box(count));
        clock::ticks() - before
    };
    // The difference of two loops cancels the overhead around them.
    let short = timed(KNOWN);
    let span = timed(2 * KNOWN).saturating_sub(short);
    let picoseconds = span * clock::TICK_PS / u64::from(KNOWN);
    // The nearest power of two in ns, if it is one within 1/64.
    let shift = (0..=10_u32).find(|shift| {
        let whole = 1000_u64 << shift;
        picoseconds.abs_diff(whole) < whole / 64
    });
    SHIFT.store(shift.map_or(0, |shift| shift + 1), Relaxed);
}

/// Instructions in a span of ticks, rounded.
fn ticks_to_instructions(span: u64) -> Option<u64> {
    let shift = SHIFT.load(Relaxed).checked_sub(1)?;
    let instruction_ps = 1000_u64 << shift;
    Some((span * clock::TICK_PS + instruction_ps / 2) / instruction_ps)
}

fn span(work: &mut dyn FnMut()) -> u64 {
    clock::restart();
    let before = clock::ticks();
    black_box(work)();
    clock::ticks() - before
}

/// Instructions that a call executes, with 0 for an empty call; `None` without `-icount`.
///
/// With shift 10 the count is exact to the instruction up to about 655 000 (mps2-an386) or a
/// million (microbit) instructions on ARM, above which about ten are added for every wrap of the
/// 24-bit timer; on RISC-V it is always exact. A call of this function inside `work` invalidates the
/// outer count.
#[inline(never)]
pub fn instructions(work: &mut dyn FnMut()) -> Option<u64> {
    let nothing = span(&mut || {});
    ticks_to_instructions(span(work).saturating_sub(nothing))
}
