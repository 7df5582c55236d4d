//! The clock of RISC-V: the counter of retired instructions, which QEMU counts in nanoseconds.

use core::arch::asm;

/// Picoseconds of a tick.
pub const TICK_PS: u64 = 1000;

/// The counter never wraps: nothing to do.
pub fn restart() {}

/// Nanoseconds since reset.
pub fn ticks() -> u64 {
    #[cfg(target_arch = "riscv64")]
    {
        let count: u64;
        // SAFETY: reads a register.
        unsafe { asm!("csrr {}, minstret", out(reg) count, options(nomem, nostack)) };
        count
    }
    #[cfg(target_arch = "riscv32")]
    loop {
        let (high, low, again): (u32, u32, u32);
        // SAFETY: reads two registers, the upper half twice to detect a carry.
        unsafe {
            asm!(
                "csrr {}, minstreth", "csrr {}, minstret", "csrr {}, minstreth",
                out(reg) high, out(reg) low, out(reg) again, options(nomem, nostack)
            )
        };
        if high == again {
            break u64::from(high) << 32 | u64::from(low);
        }
    }
}
