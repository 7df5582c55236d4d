//! No public function of the kernel is without digest: a program of the digests alone holds them
//! all, in both precisions.

use std::path::Path;
use std::process::Command;
use tribos_tests::linked::{linked_functions, not_linked};
use tribos_tests::public_items::public_functions;

/// Functions that no digest needs, with the reason.
const EXCEPTIONS: [(&str, &str); 0] = [];

/// The program of all digests, unoptimised, with names that tell precisions.
fn program() -> Vec<u8> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let target_dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join("coverage");
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .current_dir(root)
        .args(["build", "--quiet", "-p", "tribos-digest"]);
    cargo
        .args(["--example", "print", "--target-dir"])
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
    let name = format!("debug/examples/print{}", std::env::consts::EXE_SUFFIX);
    std::fs::read(target_dir.join(name)).expect("it was built")
}

#[test]
fn the_digests_reach_every_public_function_in_both_precisions() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/src");
    let mut listed = public_functions(&src).expect("the kernel parses");
    for (exception, _) in EXCEPTIONS {
        assert!(listed.remove(exception).is_some(), "{exception}: not there");
    }
    let lacking = not_linked(&listed, &linked_functions(&program(), "tribos_core"));
    assert!(
        lacking.is_empty(),
        "{} lack a digest:\n{}",
        lacking.len(),
        lacking.join("\n")
    );
}
