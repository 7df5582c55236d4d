//! Start-up, output, instruction counts and stack depth for programs on emulated boards.
//!
//! | target | board (`TRIBOS_BOARD`) | memory |
//! |---|---|---|
//! | thumbv7em-none-eabihf | mps2-an386: Cortex-M4 with a single-precision FPU | 4 MiB flash, 4 MiB RAM |
//! | thumbv6m-none-eabi | microbit: Cortex-M0; or mps2-an386 where RAM is short | 256 KiB flash, 16 KiB RAM |
//! | riscv32imac-unknown-none-elf, riscv64gc-unknown-none-elf | virt | 16 MiB each |
//!
//! A program is a file of `src/bin/` that begins like this:
//!
//! ```ignore
//! #![cfg_attr(target_os = "none", no_std, no_main)]
//! tribos_boards::main!(run);
//!
//! #[cfg(target_os = "none")]
//! fn run() {
//!     tribos_boards::println!("hello from {}", tribos_boards::BOARD);
//! }
//! ```
//!
//! `cargo run -p tribos-boards --profile dist --bin hello --target thumbv7em-none-eabihf` runs it; the
//! command of the emulator is in `.cargo/config.toml`. The program ends with an error if it
//! panics, faults, or if its stack has overwritten its statics. On a host the same file compiles
//! to a line that says for which targets to build.
//!
//! `instructions` and `stack_used` exist on boards alone. They take `&mut dyn FnMut()`, an
//! opaque call that the compiler cannot move work out of; still, pass arguments and results
//! through [`core::hint::black_box`].
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", allow(unsafe_code))]

#[cfg(target_os = "none")]
mod checks;
#[cfg(target_os = "none")]
#[doc(hidden)]
pub mod console;
#[cfg(target_os = "none")]
mod counter;
mod decimal;
#[cfg(target_os = "none")]
mod run;
#[cfg(target_os = "none")]
mod stack;

#[cfg(target_os = "none")]
pub use checks::Checks;
#[cfg(target_os = "none")]
pub use counter::instructions;
pub use decimal::Decimal;
#[cfg(target_os = "none")]
pub use run::start;
#[cfg(target_os = "none")]
pub use semihosting::process::exit;
#[cfg(target_os = "none")]
pub use stack::{free, stack_used};

/// The board that the memory map is made for: "mps2-an386", "microbit", "virt", or "host".
pub const BOARD: &str = env!("TRIBOS_BOARD");

/// Makes `$run: fn()` the program: on a board it runs between start-up and exit, on a host a notice is printed.
#[macro_export]
macro_rules! main {
    ($run:path) => {
        // SAFETY: the one symbol of this name, which both start-ups call as their last act.
        #[cfg(target_os = "none")]
        #[allow(unsafe_code)]
        #[unsafe(no_mangle)]
        extern "C" fn main() -> ! {
            $crate::start($run)
        }

        #[cfg(not(target_os = "none"))]
        fn main() {
            $crate::explain();
        }
    };
}

/// Prints on a host how to run the program on a board.
#[cfg(not(target_os = "none"))]
pub fn explain() {
    std::println!(
        "This program runs on a microcontroller: add --target thumbv7em-none-eabihf, \
         thumbv6m-none-eabi, riscv32imac-unknown-none-elf or riscv64gc-unknown-none-elf."
    );
}
