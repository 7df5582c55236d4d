//! Numbers: the shortest form that keeps the bits in files, six digits for people; signs of answers.

use crate::program::{Error, Outcome, succeed, summary, told};
use serde_json::Value;
use std::path::Path;

fn wrench(more: &str) -> Result<Value, Error> {
    Ok(serde_json::from_str(&told(format!(
        "wrench --format json {more}"
    ))?)?)
}

/// Every number of a text that has a point or a power of ten.
fn floats(text: &str) -> Vec<&str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || "+-._".contains(c);
    text.split(|c: char| !is_part(c))
        .filter(|word| word.starts_with(|c: char| c.is_ascii_digit() || c == '-'))
        .filter(|word| word.contains(['.', 'e']) && word.parse::<f64>().is_ok())
        .collect()
}

/// Every float of the file is as short as its bits allow.
fn assert_shortest(file: &Path) -> Outcome {
    let text = std::fs::read_to_string(file)?;
    let numbers = floats(&text);
    assert!(numbers.len() > 5, "{}", file.display());
    for number in numbers {
        let shortest = format!("{:?}", number.parse::<f64>()?);
        assert_eq!(number, shortest, "{}", file.display());
    }
    Ok(())
}

#[test]
fn files_of_runs_have_the_shortest_form_that_keeps_the_bits() -> Outcome {
    let folder = tempfile::tempdir()?;
    let small = " --set max_steps=3 --set height=8 --set width=8";
    for (scene, more, files) in [
        ("disk", "", &["summary.json", "series.csv"][..]),
        ("cylinder", "", &["summary.json", "series.csv"]),
        (
            "compaction-small",
            small,
            &["summary.json", "series.csv", "initial.xyz"],
        ),
    ] {
        succeed(folder.path(), format!("run {scene} --out {scene}{more}"))?;
        for file in files {
            assert_shortest(&folder.path().join(scene).join(file))?;
        }
    }
    Ok(())
}

#[test]
fn what_is_counted_stays_a_whole_number_in_summaries() -> Outcome {
    let folder = tempfile::tempdir()?;
    let packing = " --set max_steps=2 --set height=8 --set width=8";
    let tip = " --set equilibration=0.01 --set drive_time=0.01 --set rest_time=0.01";
    for (scene, more, counted) in [
        ("disk", "", "samples"),
        ("pipe-a", "", "samples"),
        ("curling-draw", "", "samples"),
        (
            "compaction-small",
            packing,
            "seed max_steps sample_every max_iterations",
        ),
        (
            "tip-reversible",
            tip,
            "substrate_columns substrate_rows tip_side_atoms seed sample_every tip_layers",
        ),
    ] {
        succeed(folder.path(), format!("run {scene} --out {scene}{more}"))?;
        let summary = summary(&folder.path().join(scene))?;
        for key in counted.split(' ') {
            let value = &summary["scene"][key];
            assert!(value.is_u64(), "{scene}: {key} is {value}");
        }
    }
    Ok(())
}

#[test]
fn people_read_six_digits_unless_they_ask_for_others() -> Outcome {
    let twist = "wrench --speed 0.3 --spin 1 --coefficient 0.3";
    let with = |more: &str| told(format!("{twist} {more}"));
    let [six, four, all] = [with("")?, with("--digits 4")?, with("--digits full")?];
    let force = wrench("--speed 0.3 --spin 1 --coefficient 0.3")?["force"]
        .as_f64()
        .ok_or("no force")?;
    let line = |text: &str| {
        let line = text.lines().find(|line| line.starts_with("force "));
        line.and_then(|line| line.split_whitespace().nth(1))
            .map(str::to_owned)
    };
    // 0.0889758…: zeros before the first digit do not count.
    assert!((0.01..0.1).contains(&force), "{force}");
    assert_eq!(line(&six), Some(format!("{force:.7}")));
    assert_eq!(line(&four), Some(format!("{force:.5}")));
    assert_eq!(line(&all), Some(format!("{force:?}")));
    assert!(six.contains("speed           0.3 m/s\n"), "{six}");
    // The option may stand before the command too, and changes no file.
    assert_eq!(told(format!("--digits 4 {twist}"))?, four);
    assert_eq!(with("--format csv")?, with("--format csv --digits 2")?);
    Ok(())
}

#[test]
fn reports_of_all_commands_have_short_numbers() -> Outcome {
    let folder = tempfile::tempdir()?;
    for line in [
        "run disk --out disk",
        "run cylinder --out cylinder",
        "modes --alpha 0 --inertia-ratio 0.5",
        "inverse --coefficient 0.2 --radius 0.03 --inertia-ratio 0.5 --x 0.3 --y 0.1 --angle 1.5 \
         --max-speed 5 --max-spin 100",
        "deposit --width 8 --count 40 --out deposit",
        "wrench --speed 0.1 --spin 0.7 --jacobian",
        "sweep disk --set spin=0,3 --out sweep",
    ] {
        let [text, _] = succeed(folder.path(), line)?;
        for number in floats(&text) {
            let mantissa = number.split('e').next().unwrap_or_default();
            let digits = mantissa.trim_start_matches(['-', '0', '.']);
            let digits = digits.chars().filter(char::is_ascii_digit).count();
            assert!(digits <= 6, "{line}: {number}\n{text}");
        }
    }
    Ok(())
}

#[test]
fn force_and_torque_have_the_signs_of_the_motion_for_every_patch() -> Outcome {
    let folder = tempfile::tempdir()?;
    let feet = folder.path().join("feet.csv");
    // Four feet on the corners of a square: what a ring does in the mean.
    std::fs::write(&feet, "x,y,weight\n1,0,1\n0,1,1\n-1,0,1\n0,-1,1\n")?;
    let points = format!("points:{}", feet.display());
    for patch in ["disk", "hertz", "ring", "annulus:0.5", points.as_str()] {
        for tier in ["exact", "quadrature"] {
            let at = |speed: f64, spin: f64| {
                let more = format!("--patch {patch} --tier {tier} --speed {speed} --spin {spin}");
                let value = wrench(&more)?;
                let number = |name: &str| value[name].as_f64().ok_or(more.clone());
                Ok::<_, Error>([number("force")?, number("torque")?])
            };
            let [force, torque] = at(0.7, 1.0)?;
            assert!(force > 0.1 && torque > 0.1, "{patch} {tier}");
            for (speed, spin) in [(0.7, -1.0), (-0.7, 1.0), (-0.7, -1.0)] {
                let [f, t] = at(speed, spin)?;
                assert!(
                    (f - force.copysign(speed)).abs() < 1e-12,
                    "{patch} {tier}: {f}"
                );
                assert!(
                    (t - torque.copysign(spin)).abs() < 1e-12,
                    "{patch} {tier}: {t}"
                );
            }
        }
    }
    Ok(())
}

#[test]
fn the_lateral_force_turns_with_the_velocity_and_mirrors_with_the_spin() -> Outcome {
    for patch in ["disk", "paraboloid"] {
        for tier in ["exact", "quadrature"] {
            let at = |speed: &str, spin: &str| {
                let more = format!(
                    "--patch {patch} --tier {tier} --tilt 0.5 --speed {speed} --spin {spin}"
                );
                Ok::<_, Error>(wrench(&more)?["lateral"].as_f64().ok_or(more)?)
            };
            let lateral = at("1", "1")?;
            assert!(lateral > 0.05);
            assert_eq!(at("1", "-1")?, -lateral);
            assert_eq!(at("-1", "1")?, -lateral);
            assert_eq!(at("-1", "-1")?, lateral);
        }
    }
    Ok(())
}

#[test]
fn the_jacobian_is_the_derivative_of_what_is_printed() -> Outcome {
    const STEP: f64 = 1e-5;
    for (speed, spin) in [(0.7, 1.1), (-0.7, 1.1), (0.7, -1.1), (-0.7, -1.1)] {
        let at = |speed: f64, spin: f64| {
            wrench(&format!(
                "--jacobian --alpha 0.5 --speed {speed} --spin {spin}"
            ))
        };
        let here = at(speed, spin)?;
        let number = |value: &Value, name: &str| value[name].as_f64().unwrap_or(f64::NAN);
        let ends = [
            ("speed", at(speed + STEP, spin)?, at(speed - STEP, spin)?),
            ("spin", at(speed, spin + STEP)?, at(speed, spin - STEP)?),
        ];
        for (along, more, less) in &ends {
            for what in ["force", "torque"] {
                let difference = (number(more, what) - number(less, what)) / (2.0 * STEP);
                let slope = number(&here, &format!("d{what}_d{along}"));
                // The central difference errs by about STEP², rounding by 1e-16/STEP.
                assert!(
                    (slope - difference).abs() < 1e-8,
                    "{speed} {spin} {what} {along}"
                );
            }
        }
    }
    Ok(())
}
