//! Builds the library like a user, and C programs with it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs};

/// Target of the board.
pub const BOARD: &str = "thumbv7em-none-eabihf";
/// Environment variable that makes a missing tool a failure.
const REQUIRE: &str = "TRIBOS_REQUIRE_TARGETS";

/// Warnings are errors. Contraction is off: the C code itself only draws and hashes, with the same
/// rounding everywhere.
const FLAGS: [&str; 8] = [
    "-Wall",
    "-Wextra",
    "-Werror",
    "-O2",
    "-ffp-contract=off",
    "-ffunction-sections",
    "-fdata-sections",
    "-Wl,--gc-sections",
];
const BOARD_FLAGS: [&str; 9] = [
    "-mcpu=cortex-m4",
    "-mthumb",
    "-mfloat-abi=hard",
    "-mfpu=fpv4-sp-d16",
    "-std=gnu99",
    "-ffreestanding",
    "-nostdlib",
    "-Wl,-z,noexecstack",
    "-Tboard.ld",
];

/// A folder of this package.
pub fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Folder for the files that a test builds.
pub fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// True if `tool` can be run; otherwise reports what is missing.
pub fn has(tool: &str) -> bool {
    if Command::new(tool).arg("--version").output().is_ok() {
        return true;
    }
    missing(&format!("`{tool}` is not installed"));
    false
}

/// Reports a part of the test that cannot be run here.
fn missing(what: &str) {
    assert!(
        env::var_os(REQUIRE).is_none(),
        "{what}, and {REQUIRE} is set"
    );
    println!("not tested: {what}");
}

/// The static library, or `None` if the Rust library of the target is not installed.
pub fn archive(target: Option<&str>) -> Option<PathBuf> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--message-format=json"]);
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    if let Some(target) = target {
        cargo.args(["--target", target]);
    }
    let output = cargo.output().expect("cargo runs");
    if !output.status.success() {
        let stderr = String::from_utf8_lossy(&output.stderr);
        let stdout = String::from_utf8_lossy(&output.stdout);
        assert!(
            stdout.contains("E0463") || stderr.contains("E0463"),
            "{stderr}"
        );
        missing("the target is not installed (rustup target add)");
        return None;
    }
    let messages = String::from_utf8(output.stdout).expect("cargo writes JSON");
    let paths = messages.split('"');
    let found = paths.rev().find(|text| text.ends_with("libtribos_c.a"));
    Some(PathBuf::from(found.expect("a static library")))
}

/// Compiles files of `examples`, or other files given by their full path, for this computer.
pub fn compile_for_host(files: &[&str], archive: &Path, program: &Path) {
    let mut cc = Command::new("cc");
    cc.args(FLAGS).args(["-std=c99", "-pedantic"]);
    compile(cc.args(files).arg(archive).arg("-lm"), program);
}

/// Compiles files of `examples` for the board.
pub fn compile_for_board(files: &[&str], archive: &Path, program: &Path) {
    let mut cc = Command::new("arm-none-eabi-gcc");
    cc.args(FLAGS).args(BOARD_FLAGS);
    compile(cc.args(files).arg(archive).arg("-lgcc"), program);
}

fn compile(cc: &mut Command, program: &Path) {
    cc.current_dir(folder("examples")).arg("-I../include");
    cc.arg("-o").arg(program);
    let output = cc.output().expect("a compiler");
    assert!(output.status.success(), "{cc:?}\n{}", text(&output.stderr));
}

/// Output of a program.
pub fn printed(command: &mut Command) -> String {
    let Output {
        status,
        stdout,
        stderr,
    } = command.output().expect("a program");
    assert!(
        status.success(),
        "{status}\n{}{}",
        text(&stdout),
        text(&stderr)
    );
    text(&stdout)
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Text of the header.
pub fn header() -> String {
    fs::read_to_string(folder("include/tribos.h")).expect("the header")
}
