//! Programs of all samples, coefficients of simulators, and refusals.

use super::samples::{Parameters, SAMPLES, Sample};
use super::{FittedLaw, Usage, UsageError, UsageTarget};
use std::path::Path;

/// The text for a target.
fn text((law, parameters, is_per_load, _): Sample, target: UsageTarget) -> String {
    let law = FittedLaw {
        law,
        parameters,
        is_per_load,
    };
    law.usage(target).expect("a sample").to_string()
}

/// A program in Rust whose prints are checks.
fn checked(program: &str, wanted: &[[f64; 2]]) -> String {
    let count = wanted.len();
    let checks = program
        .replace("println!(\"{speed} m/s: {:.9}\", ", "check(speed, ")
        .replace(
            "println!(\"{velocity} m/s: {force:.9}\")",
            "check(velocity, force)",
        );
    format!(
        "{checks}\nfn check(at: f64, friction: f64) {{\n    \
         static NEXT: std::sync::atomic::AtomicUsize = std::sync::atomic::AtomicUsize::new(0);\n    \
         const WANTED: [[f64; 2]; {count}] = {wanted:?};\n    \
         let [place, wanted] = WANTED[NEXT.fetch_add(1, std::sync::atomic::Ordering::Relaxed)];\n    \
         assert!(at == place && (friction / wanted - 1.0).abs() < 1e-12, \"{{friction}} at {{at}}\");\n}}\n"
    )
}

/// The page with the programs of all samples.
fn page() -> String {
    let mut page = "# Programs of fitted laws\n\nWritten by the tests of `usage`. What is behind the programs of a law is what they print: \
         a velocity in m/s and friction.\n".to_owned();
    for sample in SAMPLES {
        let wanted = sample.3();
        let rust = checked(&text(sample, UsageTarget::Rust), &wanted);
        let [c, python, scene] = [UsageTarget::C, UsageTarget::Python, UsageTarget::Scene]
            .map(|target| text(sample, target));
        // A sentence where there is no scene.
        let scene = if scene.contains("body") {
            format!("```toml\n{scene}```\n")
        } else {
            format!("{scene}\n")
        };
        let rows = wanted.iter().map(|[v, f]| format!("{v:?} {f:?}\n"));
        let rows: String = rows.collect();
        page += &format!(
            "\n## {}\n\n```rust\n{rust}```\n\n```c\n{c}```\n\n```python\n{python}```\n\n```text\n{rows}```\n\n{scene}",
            sample.0
        );
    }
    page
}

/// What the page has is run: programs in Rust by the tests of the documentation, those in C and Python by the
/// tests of these interfaces, scenes by those of the command.
#[test]
fn the_page_has_the_programs_of_all_laws() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/fit/usage/programs.md");
    if std::env::var_os("TRIBOS_WRITE_PAGES").is_some() {
        std::fs::write(&file, page()).expect("the page is written");
    }
    let kept = std::fs::read_to_string(file).expect("a page");
    let hint = "write it anew with TRIBOS_WRITE_PAGES=1";
    assert!(
        kept == page(),
        "programs.md is not what `usage` gives: {hint}"
    );
    for name in super::shape::NAMES {
        assert!(SAMPLES.iter().any(|sample| sample.0 == name), "{name}");
    }
}

/// What a simulator takes of a law, and words that have to stand beside it.
fn assert_given(sample: usize, target: UsageTarget, given: &str, words: &[&str]) {
    let text = text(SAMPLES[sample], target);
    for wanted in [given].iter().chain(words) {
        assert!(text.contains(wanted), "{wanted} is not in\n{text}");
    }
}

#[test]
fn simulators_take_what_they_can_hold_and_the_rest_is_named() {
    use UsageTarget::{Gazebo, MuJoCo, Newton};
    let place = |law: &str| {
        SAMPLES
            .iter()
            .position(|sample| sample.0 == law)
            .expect(law)
    };
    let stribeck = place("stribeck");
    let lost = [
        "held  mu_d by",
        "lost  mu_s:",
        "0.2000",
        "lost  vs, delta:",
        "lost  k:",
    ];
    assert_given(
        stribeck,
        MuJoCo,
        "<geom friction=\"0.2 0.005 0.0001\"/>",
        &lost,
    );
    assert_given(stribeck, Newton, "ShapeConfig(mu=0.2)\n", &lost);
    assert_given(
        stribeck,
        Gazebo,
        "<mu>0.2</mu>\n      <mu2>0.2</mu2>",
        &lost,
    );
    let joint = place("lugre");
    let lost = [
        "held  fc by",
        "held  s2 by damping",
        "lost  fs:",
        "lost  vs:",
        "lost  s0, s1:",
    ];
    assert_given(
        joint,
        MuJoCo,
        "<joint frictionloss=\"1.0\" damping=\"0.4\"/>",
        &lost,
    );
    assert_given(
        joint,
        Newton,
        "JointDofConfig(friction=1.0, damping=0.4)",
        &lost,
    );
    assert_given(
        joint,
        Gazebo,
        "<friction>1.0</friction>\n  <damping>0.4</damping>",
        &lost,
    );
    // The ramp at rest of 10 N: mu N/vt.
    assert_given(
        place("tanh"),
        Newton,
        "contact.kf = 80.0 * load",
        &["lost  vt:"],
    );
    assert_given(
        place("rising"),
        MuJoCo,
        "friction=\"0.12 ",
        &["take mu_s, 0.04,"],
    );
    assert_given(
        place("maxwell"),
        MuJoCo,
        "frictionloss=\"2.4\"",
        &["lost  stiffnesses:"],
    );
    assert_given(
        place("amontons"),
        MuJoCo,
        "friction=\"0.3 ",
        &["pulls with 5.0 N"],
    );
    // −0.005 an e-fold.
    assert_given(place("rate-state"), Gazebo, "<mu>0.6</mu>", &["-5.000e-3"]);
}

#[test]
fn a_drive_keeps_its_inertia_and_a_sensor_its_offset() {
    let parameters = [
        ("mu", 1.36),
        ("k", 2.203),
        ("inertia", 0.57),
        ("offset", 0.019),
    ];
    let drive = FittedLaw {
        law: "viscous",
        parameters: &parameters,
        is_per_load: false,
    };
    let of = |target| drive.usage(target).expect("a drive").to_string();
    let mujoco = of(UsageTarget::MuJoCo);
    assert!(
        mujoco.ends_with("<joint frictionloss=\"1.36\" damping=\"2.203\" armature=\"0.57\"/>\n")
    );
    assert!(mujoco.contains("lost  offset:"));
    assert!(of(UsageTarget::Newton).ends_with("(friction=1.36, damping=2.203, armature=0.57)\n"));
    let gazebo = of(UsageTarget::Gazebo);
    assert!(
        gazebo.contains("lost  inertia: add it to that of the link") && !gazebo.contains("0.57")
    );
    // A comment of XML has no double hyphen within.
    for text in [mujoco, gazebo] {
        let (comment, _) = text["<!--".len()..].split_once("-->").expect("a comment");
        assert!(!comment.contains("--"));
    }
}

#[test]
fn what_a_target_cannot_hold_is_a_sentence() {
    let of = |law, parameters, is_per_load| FittedLaw {
        law,
        parameters,
        is_per_load,
    };
    let simulators = [
        UsageTarget::MuJoCo,
        UsageTarget::Newton,
        UsageTarget::Gazebo,
    ];
    for target in simulators {
        // 0.01 · 0.1^(−1/2) = 0.0316.
        let ice = of("power", &[("gamma", 0.01), ("alpha", -0.5)], true).usage(target);
        assert!(matches!(ice, Ok(Usage::NotPossible(why)) if why.contains("0.0316 at 0.1 m/s")));
        // Viscous friction is a damping of joints alone.
        let film: Parameters = &[("gamma", 0.7), ("alpha", 1.0)];
        let contact = of("power", film, true).usage(target);
        assert!(matches!(contact, Ok(Usage::NotPossible(_))));
        let joint = of("power", film, false)
            .usage(target)
            .expect("a film")
            .to_string();
        assert!(joint.contains("0.7") && joint.contains("held  gamma by damping"));
    }
    for law in ["arctan", "elastic-plastic", "elasto-plastic", "maxwell"] {
        let sample = SAMPLES.iter().find(|sample| sample.0 == law).expect(law);
        let scene = of(law, sample.1, sample.2).usage(UsageTarget::Scene);
        assert!(
            matches!(scene, Ok(Usage::NotPossible(why)) if why.ends_with('.')),
            "{law}"
        );
    }
    // The same slope at rest: 2 mu/(π vt) = mu/(π vt/2).
    let nearest = text(SAMPLES[4], UsageTarget::Scene);
    assert!(
        nearest.contains("tanh:mu=0.8,vt=0.015707963267948967"),
        "{nearest}"
    );
}

#[test]
fn names_and_values_that_no_law_has_are_refused() {
    let of = |law, parameters| {
        let law = FittedLaw {
            law,
            parameters,
            is_per_load: true,
        };
        law.usage(UsageTarget::Rust).expect_err("a refusal")
    };
    let unknown = of("columb", &[]).to_string();
    assert!(unknown.starts_with("there is no fitted law `columb`; there are coulomb, viscous"));
    let missing = of("stribeck", &[("mu_s", 0.3), ("mu_d", 0.2)]);
    assert_eq!(missing.to_string(), "stribeck needs a value of `vs`");
    let falling = of("rising", &[("mu_s", 0.3), ("mu_f", 0.2), ("vr", 0.1)]);
    assert!(matches!(falling, UsageError::Refused { .. }));
    for (law, parameters) in [
        ("coulomb", &[("mu", -0.1)][..]),
        ("arctan", &[("mu", 0.1), ("vt", 0.0)]),
        ("maxwell", &[("k1", 1e5), ("f1", 0.0)]),
        ("dahl", &[("fc", 1.0), ("s0", f64::NAN)]),
        ("amontons", &[("mu", 0.3), ("adhesion", f64::INFINITY)]),
    ] {
        assert!(
            matches!(of(law, parameters), UsageError::Refused { .. }),
            "{law}"
        );
    }
}
