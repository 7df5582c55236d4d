//! No public function of the kernel is without digest and without arbitrary input: the program of all
//! subjects holds them all, in both precisions.

use std::path::Path;
use std::process::Command;
use tribos_api::Library;
use tribos_tests::linked::{linked_functions, not_linked};

/// A program, unoptimised, with names that tell precisions.
fn program(package: &str, example: &str) -> Vec<u8> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    // One folder for all programs, which share what they depend on.
    let target_dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("coverage");
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .current_dir(root)
        .args(["build", "--quiet", "-p", package])
        .args(["--example", example, "--target-dir"])
        .arg(&target_dir);
    for setting in [
        "profile.dev.opt-level=0",
        "profile.dev.debug=false",
        "profile.dev.package.tribos-core.opt-level=0",
    ] {
        cargo.args(["--config", setting]);
    }
    cargo.env("RUSTFLAGS", "-Csymbol-mangling-version=v0");
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS");
    assert!(cargo.status().expect("cargo starts").success());
    let name = format!("debug/examples/{example}{}", std::env::consts::EXE_SUFFIX);
    std::fs::read(target_dir.join(name)).expect("it was built")
}

/// Functions of the kernel that a program does not hold.
fn lacking(package: &str, example: &str) -> Vec<String> {
    let kernel = Library::read("tribos-core", &[]).expect("rustdoc runs");
    let functions = kernel.functions().expect("the format is known");
    let program = program(package, example);
    let mut lacking = not_linked(&functions, &linked_functions(&program, "tribos_core"));
    // Conversions of errors carry no numbers.
    lacking.retain(|name| !name.starts_with("error::Error as From"));
    lacking
}

#[test]
fn the_subjects_reach_every_public_function_in_both_precisions() {
    let lacking = lacking("tribos-subjects", "print");
    assert!(lacking.is_empty(), "in no subject:\n{}", lacking.join("\n"));
}
