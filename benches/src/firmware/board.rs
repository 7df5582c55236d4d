//! Cost of calls on emulated microcontrollers.

use crate::command_line::first_line;
use std::path::Path;
use std::process::Command;

/// A board that QEMU emulates.
#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// Name of the board in reports.
    pub name: &'static str,
    /// The compiler's target.
    pub target: &'static str,
    /// QEMU's machine.
    pub machine: &'static str,
}

/// A microcontroller with single-precision floating point in hardware.
pub const CORTEX_M4F: Board = Board {
    name: "M4F",
    target: "thumbv7em-none-eabihf",
    machine: "mps2-an386",
};

/// A microcontroller without floating point: 256 KiB of flash, 16 KiB of RAM.
pub const CORTEX_M0: Board = Board {
    name: "M0",
    target: "thumbv6m-none-eabi",
    machine: "microbit",
};

/// The same instructions on a board with memory for everything.
pub const CORTEX_M0_LARGE: Board = Board {
    machine: "mps2-an386",
    ..CORTEX_M0
};

const EMULATOR: &str = "qemu-system-arm";

/// One item on one board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Instructions of a call on average over the inputs.
    pub mean: u64,
    /// Instructions of the dearest call.
    pub worst: u64,
    /// Bytes of stack of the deepest call.
    pub stack: u64,
    /// Which input was the dearest.
    pub worst_at: u64,
}

impl Board {
    /// Refuses if the target's core library is missing.
    pub fn installed(&self) -> Result<(), String> {
        let output = Command::new("rustc")
            .args(["--print", "target-libdir", "--target", self.target])
            .output()
            .map_err(|error| format!("cannot run rustc: {error}"))?;
        let folder = String::from_utf8_lossy(&output.stdout);
        if output.status.success() && Path::new(folder.trim()).is_dir() {
            Ok(())
        } else {
            Err(format!(
                "the target is missing; install it with: rustup target add {}",
                self.target
            ))
        }
    }

    /// Runs a measuring image.
    pub fn run(&self, image: &Path) -> Result<Cost, String> {
        let output = Command::new(EMULATOR)
            .args(["-M", self.machine, "-nographic"])
            .args(["-semihosting-config", "enable=on,target=native"])
            // An instruction takes 2^10 ns, so that the timer resolves each.
            .args(["-icount", "shift=10,sleep=off", "-kernel"])
            .arg(image)
            .output()
            .map_err(|error| format!("cannot run {EMULATOR}: {error}; install QEMU"))?;
        let said = String::from_utf8_lossy(&output.stdout);
        let complaint = String::from_utf8_lossy(&output.stderr);
        let failed = || format!("{} on {}: {said}{complaint}", image.display(), self.machine);
        if !output.status.success() {
            return Err(failed());
        }
        told(&said).ok_or_else(failed)
    }
}

/// QEMU's version.
pub fn emulator() -> Result<String, String> {
    first_line(EMULATOR, &["--version"]).map_err(|error| format!("{error}; install QEMU"))
}

/// The line that a measuring program prints.
fn told(said: &str) -> Option<Cost> {
    let line = said.lines().find_map(|line| line.strip_prefix("cost "))?;
    let numbers: Vec<u64> = line.split(' ').map_while(|n| n.parse().ok()).collect();
    let [mean, worst, stack, worst_at] = numbers[..] else {
        return None;
    };
    Some(Cost {
        mean,
        worst,
        stack,
        worst_at,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn costs_are_read_whole_or_not_at_all() {
        let cost = told("cost 310 402 64 17\n").unwrap();
        assert_eq!(
            (cost.mean, cost.worst, cost.stack, cost.worst_at),
            (310, 402, 64, 17)
        );
        assert_eq!(told("refused\n"), None);
        assert_eq!(told("cost 310 402\n"), None);
    }
}
