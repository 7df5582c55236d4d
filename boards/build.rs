//! Selects the memory map of the board and passes the start-up's linker script to the linker.

use std::path::Path;
use std::{env, fs};

/// A Cortex-M4 with 4 MiB of program and 4 MiB of data memory (ARM AN386).
const MPS2_AN386: &str = "\
MEMORY
{
  FLASH : ORIGIN = 0x00000000, LENGTH = 4M
  RAM : ORIGIN = 0x20000000, LENGTH = 4M
}
";

/// nRF51822: a Cortex-M0 with 256 KiB of flash and 16 KiB of RAM.
const MICROBIT: &str = "\
MEMORY
{
  FLASH : ORIGIN = 0x00000000, LENGTH = 256K
  RAM : ORIGIN = 0x20000000, LENGTH = 16K
}
";

/// QEMU's RISC-V machine loads everything into RAM.
const VIRT: &str = "\
MEMORY
{
  FLASH : ORIGIN = 0x80000000, LENGTH = 16M
  RAM : ORIGIN = 0x81000000, LENGTH = 16M
}
REGION_ALIAS(\"REGION_TEXT\", FLASH);
REGION_ALIAS(\"REGION_RODATA\", FLASH);
REGION_ALIAS(\"REGION_DATA\", RAM);
REGION_ALIAS(\"REGION_BSS\", RAM);
REGION_ALIAS(\"REGION_HEAP\", RAM);
REGION_ALIAS(\"REGION_STACK\", RAM);
";

fn main() {
    println!("cargo::rerun-if-env-changed=TRIBOS_BOARD");
    println!("cargo::rerun-if-env-changed=TRIBOS_SUBJECTS");
    // Subjects of the digest program; an empty list selects all.
    let subjects = env::var("TRIBOS_SUBJECTS").unwrap_or_default();
    println!("cargo::rustc-env=TRIBOS_SUBJECTS={subjects}");
    let [os, arch, target] = ["CARGO_CFG_TARGET_OS", "CARGO_CFG_TARGET_ARCH", "TARGET"]
        .map(|key| env::var(key).unwrap());
    if os != "none" {
        println!("cargo::rustc-env=TRIBOS_BOARD=host");
        return;
    }
    let usual = match (arch.as_str(), target.starts_with("thumbv6m")) {
        ("arm", true) => "microbit",
        ("arm", false) => "mps2-an386",
        _ => "virt",
    };
    let board = env::var("TRIBOS_BOARD").unwrap_or_else(|_| usual.into());
    let memory = match (arch.as_str(), board.as_str()) {
        ("arm", "mps2-an386") => MPS2_AN386,
        ("arm", "microbit") => MICROBIT,
        ("riscv32" | "riscv64", "virt") => VIRT,
        _ => panic!(
            "TRIBOS_BOARD={board}: no such board for {target}; \
             choose mps2-an386 or microbit for ARM, virt for RISC-V, or leave it unset"
        ),
    };
    let out = env::var("OUT_DIR").unwrap();
    fs::write(Path::new(&out).join("memory.x"), memory).expect("OUT_DIR can be written");
    println!("cargo::rustc-env=TRIBOS_BOARD={board}");
    println!("cargo::rustc-link-search={out}");
    // RISC-V's script does not include the memory map by itself.
    if arch != "arm" {
        println!("cargo::rustc-link-arg=-Tmemory.x");
    }
    println!("cargo::rustc-link-arg=-Tlink.x");
}
