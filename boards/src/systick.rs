//! The clock of Cortex-M: SysTick counts 24 bits down, its exception counts the wraps.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use cortex_m::peripheral::{SCB, SYST};
use cortex_m_rt::exception;

/// Picoseconds of a tick: the boards' processors run at 25 MHz (mps2-an386) and 16 MHz (microbit).
pub const TICK_PS: u64 = match crate::BOARD.as_bytes() {
    b"microbit" => 62_500,
    _ => 40_000,
};

/// Start of the count, one less than its period.
const RELOAD: u32 = 0x00ff_ffff;
/// Bits of the control register: enabled, with exception, on the processor's clock.
const CONTROL: u32 = 0b111;
/// "SysTick exception pending" in the interrupt control and state register.
const PENDING: u32 = 1 << 26;

static WRAPS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    WRAPS.store(WRAPS.load(Relaxed) + 1, Relaxed);
}

/// Begins a new count, so that short spans meet no wrap.
pub fn restart() {
    // SAFETY: the program has one thread, and nothing else uses the timer.
    unsafe {
        let timer = &*SYST::PTR;
        timer.rvr.write(RELOAD);
        timer.cvr.write(0);
        timer.csr.write(CONTROL);
    }
    WRAPS.store(0, Relaxed);
}

/// Ticks of the timer since the restart.
pub fn ticks() -> u64 {
    let (wraps, left) = cortex_m::interrupt::free(|_| {
        // SAFETY: reads of two registers without side effects.
        let (timer, system) = unsafe { (&*SYST::PTR, &*SCB::PTR) };
        let mut left = timer.cvr.read();
        let mut wraps = WRAPS.load(Relaxed);
        // A wrap whose exception still waits.
        if system.icsr.read() & PENDING != 0 {
            left = timer.cvr.read();
            wraps += u32::from(left == 0 || left > RELOAD / 2);
        }
        (wraps, left)
    });
    // The exception comes when 0 is reached, a new round begins there.
    let round = RELOAD + 1;
    u64::from(wraps) * u64::from(round) + u64::from((round - left) & RELOAD)
}
