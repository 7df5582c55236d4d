//! Who may lean on whom: the packages of this workspace, and nothing that is not in the table.

use serde_json::Value;
use std::collections::BTreeMap;
use std::process::Command;

/// Each package, and the packages of this workspace that its library or program may be built from.
const ALLOWED: &[(&str, &[&str])] = &[
    ("tribos-core", &["tribos-sqrt"]),
    ("tribos-sqrt", &[]),
    ("tribos-lanes", &[]),
    ("tribos-avx2", &[]),
    ("tribos-prefetch", &[]),
    // The library: no scene below the room that it describes, no motion beside particles.
    ("tribos-base", &["tribos-core"]),
    ("tribos-friction", &["tribos-base", "tribos-core"]),
    (
        "tribos-contacts",
        &[
            "tribos-avx2",
            "tribos-base",
            "tribos-core",
            "tribos-lanes",
            "tribos-prefetch",
        ],
    ),
    (
        "tribos-grains",
        &["tribos-base", "tribos-contacts", "tribos-core"],
    ),
    (
        "tribos-atoms",
        &["tribos-avx2", "tribos-base", "tribos-core"],
    ),
    (
        "tribos-motion",
        &["tribos-base", "tribos-core", "tribos-friction"],
    ),
    (
        "tribos",
        &[
            "tribos-atoms",
            "tribos-base",
            "tribos-contacts",
            "tribos-core",
            "tribos-friction",
            "tribos-grains",
            "tribos-motion",
        ],
    ),
    // Programs, and doors from other languages and engines. The wheel has the command in it.
    ("tribos-report", &["tribos", "tribos-core"]),
    (
        "tribos-thesis",
        &["tribos", "tribos-core", "tribos-report", "tribos-trials"],
    ),
    ("tribos-trials", &["tribos", "tribos-core"]),
    ("tribos-cli", &["tribos", "tribos-core", "tribos-report"]),
    ("tribos-c", &["tribos-core"]),
    (
        "tribos-web",
        &["tribos-core", "tribos-friction", "tribos-motion"],
    ),
    (
        "tribos-python",
        &["tribos", "tribos-cli", "tribos-core", "tribos-mujoco"],
    ),
    ("tribos-feet", &["tribos-core", "tribos-friction"]),
    ("tribos-mujoco", &[]),
    ("tribos-boards", &["tribos-core", "tribos-subjects"]),
    // What proves and measures stands beside the command.
    ("tribos-api", &[]),
    ("tribos-no-panic", &["tribos-api", "tribos-core"]),
    ("tribos-subjects", &["tribos-core"]),
    (
        "tribos-tests",
        &[
            "tribos",
            "tribos-api",
            "tribos-base",
            "tribos-core",
            "tribos-friction",
            "tribos-subjects",
        ],
    ),
    (
        "tribos-benches",
        &[
            "tribos",
            "tribos-api",
            "tribos-core",
            "tribos-report",
            "tribos-subjects",
            "tribos-tests",
            "tribos-trials",
        ],
    ),
];

#[test]
fn packages_lean_on_none_but_those_that_they_may() {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--format-version=1", "--offline"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    let told: Value = serde_json::from_slice(&output.stdout).expect("metadata");
    let mut now = BTreeMap::new();
    for package in told["packages"].as_array().expect("packages") {
        let all = package["dependencies"].as_array().into_iter().flatten();
        let ours = all.filter(|on| on["path"].is_string() && on["kind"].is_null());
        let mut names: Vec<&str> = ours.filter_map(|on| on["name"].as_str()).collect();
        names.sort_unstable();
        names.dedup();
        now.insert(package["name"].as_str().expect("a name"), names);
    }
    let allowed = ALLOWED.iter().map(|(name, on)| (*name, on.to_vec()));
    assert_eq!(now, allowed.collect());
}
