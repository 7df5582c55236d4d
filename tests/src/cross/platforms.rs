//! The platforms that compute the digests, one row of the table each.

use tribos_subjects::{Needs, SUBJECTS};

/// A build with the machine that runs it.
#[derive(Clone, Copy, Debug)]
pub struct Platform {
    /// Name for `--only`.
    pub name: &'static str,
    /// The compiler's target; `None` for this machine.
    pub target: Option<&'static str>,
    /// Machine that runs it.
    pub machine: Machine,
    /// Cargo's profile, "dev" or "release".
    pub profile: &'static str,
    /// Settings for `cargo --config`.
    pub config: &'static [&'static str],
    /// Flags of the compiler.
    pub flags: &'static str,
    /// Programs that must be installed.
    pub tools: &'static [Tool],
    /// Whether identical bits are promised.
    pub promised: bool,
}

/// A way to run a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Machine {
    /// This machine, or a user-mode emulator: the words before the program.
    Host(&'static [&'static str]),
    /// Node with a WebAssembly module.
    Node,
    /// QEMU's system emulator, by program and board.
    Board {
        /// qemu-system-…
        emulator: &'static str,
        /// Its `-M`, which is also our `TRIBOS_BOARD`.
        board: &'static str,
        /// Subjects that fit the board and finish in time.
        subjects: Share,
    },
}

/// Subjects that run on a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// Subjects with low requirements.
    Little,
    /// Subjects that require only memory: those that a neighbouring board omits.
    Memory,
    /// All subjects.
    All,
}

/// A program that must run, and the way to install it.
#[derive(Clone, Copy, Debug)]
pub struct Tool {
    /// A command that succeeds if the program is installed.
    pub check: &'static [&'static str],
    /// A command that installs the program.
    pub install: &'static str,
}

impl Share {
    fn holds(self, needs: Needs) -> bool {
        match self {
            Self::Little => needs == Needs::Little,
            Self::Memory => needs == Needs::Memory,
            Self::All => true,
        }
    }
}

impl Platform {
    /// Indices of the subjects that the platform computes.
    pub fn subjects(&self) -> Vec<usize> {
        let share = match self.machine {
            Machine::Board { subjects, .. } => subjects,
            _ => Share::All,
        };
        (0..SUBJECTS.len())
            .filter(|&index| share.holds(SUBJECTS[index].needs))
            .collect()
    }

    /// Short description of the machine.
    pub fn machine_name(&self) -> &'static str {
        match self.machine {
            Machine::Host([]) => "this one",
            Machine::Host(words) => words[0],
            Machine::Node => "node",
            Machine::Board { board, .. } => board,
        }
    }
}

const NODE: Tool = Tool {
    check: &["node", "--version"],
    install: "apt-get install -y nodejs",
};
const QEMU_USER: Tool = Tool {
    check: &["qemu-aarch64", "--version"],
    install: "apt-get install -y qemu-user",
};
const GCC_AARCH64: Tool = Tool {
    check: &["aarch64-linux-gnu-gcc", "--version"],
    install: "apt-get install -y gcc-aarch64-linux-gnu libc6-dev-arm64-cross",
};
const QEMU_ARM: Tool = Tool {
    check: &["qemu-system-arm", "--version"],
    install: "apt-get install -y qemu-system-arm",
};
const QEMU_RISCV32: Tool = Tool {
    check: &["qemu-system-riscv32", "--version"],
    install: "apt-get install -y qemu-system-misc",
};
const QEMU_RISCV64: Tool = Tool {
    check: &["qemu-system-riscv64", "--version"],
    ..QEMU_RISCV32
};
/// A linker with the 32-bit C library.
const GCC_M32: Tool = Tool {
    check: &[
        "sh",
        "-c",
        "echo 'int main(void){return 0;}' | cc -m32 -x c - -o /dev/null",
    ],
    install: "apt-get install -y --no-install-recommends gcc-12-multilib",
};

const NATIVE: Platform = Platform {
    name: "native-release",
    target: None,
    machine: Machine::Host(&[]),
    profile: "release",
    config: &[],
    flags: "",
    tools: &[],
    promised: true,
};

const WASM: Platform = Platform {
    name: "wasm32",
    target: Some("wasm32-unknown-unknown"),
    machine: Machine::Node,
    tools: &[NODE],
    ..NATIVE
};

const M4: Platform = Platform {
    name: "thumbv7em-release",
    target: Some("thumbv7em-none-eabihf"),
    machine: Machine::Board {
        emulator: "qemu-system-arm",
        board: "mps2-an386",
        subjects: Share::All,
    },
    tools: &[QEMU_ARM],
    ..NATIVE
};

/// Small code, so that a subject fits into 256 KiB of flash; without optimisation at link time the
/// search for images that fit remains fast.
const SMALL: &[&str] = &[
    "profile.release.opt-level=\"z\"",
    "profile.release.lto=false",
];

const M0: Platform = Platform {
    name: "thumbv6m-microbit",
    target: Some("thumbv6m-none-eabi"),
    machine: Machine::Board {
        emulator: "qemu-system-arm",
        board: "microbit",
        subjects: Share::Little,
    },
    config: SMALL,
    ..M4
};

const RISCV32: Platform = Platform {
    name: "riscv32imac",
    target: Some("riscv32imac-unknown-none-elf"),
    machine: Machine::Board {
        emulator: "qemu-system-riscv32",
        board: "virt",
        subjects: Share::All,
    },
    tools: &[QEMU_RISCV32],
    ..NATIVE
};

/// All rows, fast ones first.
pub const PLATFORMS: [Platform; 15] = [
    NATIVE,
    Platform {
        name: "native-debug",
        profile: "dev",
        config: &[
            "profile.dev.opt-level=0",
            "profile.dev.package.tribos-core.opt-level=0",
        ],
        ..NATIVE
    },
    Platform {
        name: "native-lto",
        config: &["profile.release.lto=\"fat\""],
        ..NATIVE
    },
    Platform {
        name: "native-cpu",
        flags: "-Ctarget-cpu=native",
        ..NATIVE
    },
    Platform {
        name: "i686",
        target: Some("i686-unknown-linux-gnu"),
        tools: &[GCC_M32],
        ..NATIVE
    },
    Platform {
        name: "aarch64",
        target: Some("aarch64-unknown-linux-gnu"),
        machine: Machine::Host(&["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"]),
        config: &["target.aarch64-unknown-linux-gnu.linker=\"aarch64-linux-gnu-gcc\""],
        tools: &[QEMU_USER, GCC_AARCH64],
        ..NATIVE
    },
    WASM,
    // As the npm package has it.
    Platform {
        name: "wasm32-simd",
        flags: "-Ctarget-feature=+simd128",
        ..WASM
    },
    M0,
    Platform {
        name: "thumbv6m-mps2",
        machine: Machine::Board {
            emulator: "qemu-system-arm",
            board: "mps2-an386",
            subjects: Share::Memory,
        },
        ..M0
    },
    M4,
    Platform {
        name: "thumbv7em-debug",
        profile: "dev",
        config: &["profile.dev.package.tribos-subjects.opt-level=1"],
        ..M4
    },
    RISCV32,
    Platform {
        name: "riscv64gc",
        target: Some("riscv64gc-unknown-none-elf"),
        machine: Machine::Board {
            emulator: "qemu-system-riscv64",
            board: "virt",
            subjects: Share::All,
        },
        tools: &[QEMU_RISCV64],
        ..RISCV32
    },
    // The x87 rounds sums twice, first in its 80-bit registers.
    Platform {
        name: "i586-x87",
        target: Some("i586-unknown-linux-gnu"),
        tools: &[GCC_M32],
        promised: false,
        ..NATIVE
    },
];
