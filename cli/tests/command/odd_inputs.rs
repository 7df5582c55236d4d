//! Whatever is written, nothing panics: a result, or a refusal with code 2.

use crate::program::Error;
use assert_cmd::Command;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use tribos::scene::DiskScene;

/// Numbers that break things.
const ODD: &[&str] = &[
    "0",
    "-0.0",
    "1",
    "-1",
    "nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "5e-324",
    "1e-310",
    "1e999",
    "0x10",
    "1_000",
    "٣",
    "",
    " ",
    "1.",
    ".5",
    "1e",
    "--",
    "true",
    "1,5",
    "1e-17",
    "0.9999999999999999",
    "1.0000000000000002",
    "3.402823466e38",
    "1e39",
    "127.99",
    "-0.9999999999999999",
];

fn odd() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::sample::select(ODD).prop_map(str::to_owned),
        any::<f64>().prop_map(|x| format!("{x:e}")),
        "\\PC{0,12}",
    ]
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x7269_626f_7321),
        ..ProptestConfig::default()
    }
}

const KEYS: &[&str] = &[
    "speed",
    "spin",
    "gamma",
    "alpha",
    "gravity",
    "radius",
    "mass",
    "inertia_ratio",
    "units",
    "integrator",
    "time_step",
    "duration",
    "stop_fraction",
    "samples",
    "spam",
    "",
];

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn any_text_is_a_scene_or_a_refusal(text in "\\PC{0,80}") {
        let _ = DiskScene::parse("text", &text, &[]);
    }

    #[test]
    fn any_values_of_known_keys_run_or_are_refused(
        values in prop::collection::vec((prop::sample::select(KEYS), odd()), 1..4),
    ) {
        let base = "speed=1\nspin=5\ngamma=0.3\nalpha=0\ngravity=9.81\nradius=0.08\nmass=0.1\n\
                    inertia_ratio=0.5\nsamples=20";
        let overrides: Vec<String> = values.iter().map(|(k, v)| format!("{k}={v}")).collect();
        // A long run is a legal answer; only short ones are followed here.
        let bounded = |scene: &DiskScene| {
            scene.samples <= 1000 && scene.time_step.is_none() && scene.stop_fraction > 1e-9
        };
        if let Ok(scene) = DiskScene::parse("text", base, &overrides)
            && bounded(&scene)
            && let Ok(result) = scene.run()
        {
            for row in &result.rows {
                prop_assert!(row.iter().take(5).all(|x| x.is_finite()));
            }
        }
    }
}

proptest! {
    #![proptest_config(config(120))]

    #[test]
    fn any_numbers_on_the_command_line_end_well(
        numbers in prop::array::uniform6(odd()),
        tier in prop::sample::select(&["table", "compact", "quadrature"][..]),
        precision in prop::sample::select(&["f64", "f32"][..]),
    ) {
        let names = ["--alpha", "--coefficient", "--load", "--radius", "--speed", "--spin"];
        let mut command = Command::cargo_bin("tribos")?;
        command.args(["wrench", "--jacobian", "--format", "json", "--tier", tier]);
        command.args(["--precision", precision]);
        for (name, number) in names.iter().zip(&numbers) {
            // Half of them stay ordinary, or nothing would ever get through.
            let text = if number.len() % 2 == 0 { "0.5" } else { number };
            command.arg(format!("{name}={text}"));
        }
        let output = command.output()?;
        let message = String::from_utf8_lossy(&output.stderr);
        prop_assert!(!message.contains("panicked"), "{}", message);
        prop_assert!(matches!(output.status.code(), Some(0 | 2)), "{}", message);
    }
}

/// `tribos run SCENE --set …` into a folder of its own: exit code, what it said, its summary.
fn run(scene: &str, overrides: &[&str]) -> Result<(Option<i32>, String, String), Error> {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out");
    let mut command = Command::cargo_bin("tribos")?;
    command.args(["run", scene, "--out"]).arg(&out);
    command.timeout(std::time::Duration::from_secs(60));
    for item in overrides {
        command.args(["--set", item]);
    }
    let output = command.output()?;
    let said = [output.stdout, output.stderr].concat();
    let summary = std::fs::read_to_string(out.join("summary.json")).unwrap_or_default();
    Ok((output.status.code(), String::from_utf8(said)?, summary))
}

#[test]
fn numbers_that_are_not_finite_end_in_a_refusal_and_not_in_a_result() -> Result<(), Error> {
    const SMALL: [&str; 3] = ["width=6", "height=6", "max_steps=5"];
    for (scene, overrides, code, words) in [
        ("disk", &["radius=1e300"][..], 2, "kinetic energy of inf J"),
        (
            "disk",
            &["speed=1e-300", "spin=0"],
            2,
            "kinetic energy of 0",
        ),
        ("disk", &["alpha=1.5", "spin=1e300"], 2, "kinetic energy"),
        ("disk", &["alpha=10", "speed=1e100"], 1, "no longer finite"),
        ("cylinder", &["speed=1e-300", "spin=0"], 2, "kinetic energy"),
        ("pipe-a", &["radius=1e300"], 2, "kinetic energy of inf J"),
        (
            "curling-draw",
            &["spin=1e300"],
            2,
            "kinetic energy of inf J",
        ),
        ("cylinder", &["gamma=1e300"], 1, "no longer finite"),
        ("compaction-small", &["pressure=1e300"], 1, "after step "),
    ] {
        let sets = if scene.starts_with("comp") {
            [&SMALL[..], overrides].concat()
        } else {
            [&["samples=5"][..], overrides].concat()
        };
        let (got, said, summary) = run(scene, &sets)?;
        assert_eq!(got, Some(code), "{scene} {overrides:?}: {said}");
        assert!(said.contains(words), "{scene} {overrides:?}: {said}");
        assert_eq!(summary, "", "{scene} {overrides:?}");
    }
    // A result whose shares have no meaning leaves them out.
    for tiny in ["pressure=1e-300", "time_step=1e-300"] {
        let (got, said, summary) = run("compaction-small", &[&SMALL[..], &[tiny]].concat())?;
        assert_eq!(got, Some(0), "{tiny}: {said}");
        for text in [said, summary] {
            let text = text.to_lowercase();
            assert!(!text.contains("nan") && !text.contains("inf"), "{text}");
        }
    }
    Ok(())
}
