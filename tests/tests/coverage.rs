//! No public function of the kernel is without digest: a program of the digests alone holds them
//! all, in both precisions.

use std::path::Path;
use std::process::Command;
use tribos_api::Library;
use tribos_tests::linked::{linked_functions, not_linked};

/// A program, unoptimised, with names that tell precisions.
fn program(package: &str, example: &str) -> Vec<u8> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
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
        "profile.dev.package.tribos.opt-level=0",
    ] {
        cargo.args(["--config", setting]);
    }
    cargo.env("RUSTFLAGS", "-Csymbol-mangling-version=v0");
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS");
    assert!(cargo.status().expect("cargo starts").success());
    let name = format!("debug/examples/{example}{}", std::env::consts::EXE_SUFFIX);
    std::fs::read(target_dir.join(name)).expect("it was built")
}

fn assert_holds_all(package: &str, example: &str, exceptions: &[(&str, &str)]) {
    let kernel = Library::read("tribos-core", &[]).expect("rustdoc runs");
    let functions = kernel.functions().expect("the format is known");
    let mut lacking = not_linked(
        &functions,
        &linked_functions(&program(package, example), "tribos_core"),
    );
    for (exception, _) in exceptions {
        let before = lacking.len();
        lacking.retain(|function| !function.starts_with(exception));
        assert!(lacking.len() < before, "{exception} needs no exception");
    }
    assert!(
        lacking.is_empty(),
        "{} are not in {example} of {package}:\n{}",
        lacking.len(),
        lacking.join("\n")
    );
}

#[test]
fn the_digests_reach_every_public_function_in_both_precisions() {
    assert_holds_all("tribos-digest", "print", &[]);
}
