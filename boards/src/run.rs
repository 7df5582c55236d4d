//! Start and exit of a program.

use crate::eprintln;
#[cfg(target_arch = "arm")]
use cortex_m_rt::{ExceptionFrame, exception};
#[cfg(any(target_arch = "riscv32", target_arch = "riscv64"))]
use riscv_rt as _;
use semihosting::process::exit;

/// Runs a program and exits: with an error if its stack has reached its statics.
pub fn start(run: fn()) -> ! {
    crate::stack::set_guard();
    crate::counter::start();
    run();
    if !crate::stack::guard_holds() {
        eprintln!("the stack has run into the statics: use a board with more RAM");
        exit(1);
    }
    exit(0)
}

#[cfg(feature = "panic-exit")]
#[panic_handler]
fn panicked(info: &core::panic::PanicInfo<'_>) -> ! {
    eprintln!("{info}");
    exit(1)
}

// SAFETY: the handler reads nothing but the frame that it is given, and does not return.
#[cfg(target_arch = "arm")]
#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    eprintln!("hard fault at {:#010x}", frame.pc());
    exit(1)
}

// SAFETY: the one symbol of this name, which the start-up calls for every exception.
#[cfg(any(target_arch = "riscv32", target_arch = "riscv64"))]
#[unsafe(no_mangle)]
extern "C" fn ExceptionHandler(_: &riscv_rt::TrapFrame) -> ! {
    let (cause, place): (usize, usize);
    // SAFETY: reads two registers.
    unsafe { core::arch::asm!("csrr {}, mcause", "csrr {}, mepc", out(reg) cause, out(reg) place) };
    eprintln!("exception {cause} at {place:#x}");
    exit(1)
}
