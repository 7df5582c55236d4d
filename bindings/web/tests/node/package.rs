//! The package is built and tested in Node. Where Node is missing the test says so and passes, unless
//! `TRIBOS_REQUIRE_TARGETS` is set.

use std::path::Path;
use std::process::Command;

fn runs(program: &str, arguments: &[&str]) -> bool {
    let output = Command::new(program).args(arguments).output();
    output.is_ok_and(|output| output.status.success())
}

/// The compiler has the target of WebAssembly.
fn has_target() -> bool {
    let output = Command::new("rustc")
        .args(["--print", "target-libdir"])
        .args(["--target", "wasm32-unknown-unknown"])
        .output()
        .expect("rustc runs");
    let folder = String::from_utf8_lossy(&output.stdout);
    Path::new(folder.trim()).is_dir()
}

#[test]
fn the_package_passes_its_tests_and_computes_the_bits_of_the_kernel() {
    let missing = if !runs("node", &["--version"]) {
        Some("node: apt-get install -y nodejs")
    } else if !has_target() {
        Some("a target: rustup target add wasm32-unknown-unknown")
    } else {
        None
    };
    if let Some(missing) = missing {
        assert!(
            std::env::var_os("TRIBOS_REQUIRE_TARGETS").is_none(),
            "missing {missing}"
        );
        eprintln!("skipped, missing {missing}");
        return;
    }
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let node = |arguments: &[&str]| {
        let output = Command::new("node")
            .args(arguments)
            .current_dir(here)
            .output()
            .expect("node starts");
        let said = String::from_utf8_lossy(&output.stdout);
        let wrong = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.success(),
            "node {arguments:?}\n{said}\n{wrong}"
        );
    };
    node(&["build.mjs", "--quick"]);
    std::fs::write(here.join("dist/bits.txt"), super::bits::digests()).expect("dist is there");
    node(&[
        "--test",
        "test/disk.test.mjs",
        "test/all.test.mjs",
        "test/package.test.mjs",
    ]);
    node(&[
        "--test",
        "playground/test/texts.test.mjs",
        "playground/test/panels.test.mjs",
        "playground/test/throw.test.mjs",
        "playground/test/push.test.mjs",
        "playground/test/programs.test.mjs",
    ]);
}
