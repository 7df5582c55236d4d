//! Whatever is written, nothing panics: a result, or a refusal with code 2.

use crate::program::{Outcome, prepared, run, summary, texts};
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
        tier in prop::sample::select(&["exact", "quadrature"][..]),
        precision in prop::sample::select(&["f64", "f32"][..]),
    ) {
        let names = ["--alpha", "--coefficient", "--load", "--radius", "--speed", "--spin"];
        let mut command = prepared(".", "wrench --jacobian --format json --tier");
        command.args([tier, "--precision", precision]);
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

#[test]
fn shares_that_have_no_meaning_are_left_out_of_a_result() -> Outcome {
    for tiny in ["pressure=1e-300", "time_step=1e-300"] {
        let folder = tempfile::tempdir()?;
        let sets = ["width=6", "height=6", "max_steps=5", tiny];
        let output = run("compaction-small", folder.path(), &sets).output()?;
        let said = texts(&output)?.concat();
        assert_eq!(output.status.code(), Some(0), "{tiny}: {said}");
        for text in [said, summary(folder.path())?.to_string()] {
            let text = text.to_lowercase();
            assert!(!text.contains("nan") && !text.contains("inf"), "{text}");
        }
    }
    Ok(())
}
