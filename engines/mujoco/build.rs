//! Compiles the step; the plugin's own files, which need MuJoCo's headers, are the Makefile's.

const SOURCES: [&str; 6] = [
    "src/attached.c",
    "src/compliance.c",
    "src/foot.c",
    "src/link.c",
    "src/step.c",
    "src/system.c",
];

fn main() {
    let mut build = cc::Build::new();
    build.files(SOURCES).std("c11").opt_level(3);
    build.flag_if_supported("-fvisibility=hidden");
    build.compile("tribos_mujoco");
    println!("cargo::rerun-if-changed=src");
}
