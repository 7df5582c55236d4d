//! `tribos coefficients`: torsional coefficients of engines and their errors.

use crate::program::{Error, Outcome, number, told};
use serde_json::Value;
use std::f64::consts::{PI, TAU};

fn asked(line: &str) -> Result<Value, Error> {
    Ok(serde_json::from_str(&told(format!(
        "coefficients {line} --format json"
    ))?)?)
}

/// The entry of an engine whose parameter contains a word.
fn engine<'a>(answer: &'a Value, name: &str, word: &str) -> &'a Value {
    let engines = answer["engines"].as_array().map_or(&[][..], Vec::as_slice);
    let is_it = |engine: &&Value| {
        engine["engine"] == name
            && engine["parameter"]
                .as_str()
                .is_some_and(|text| text.contains(word))
    };
    engines.iter().find(is_it).unwrap_or(&Value::Null)
}

fn close(found: f64, expected: f64, most: f64) {
    assert!((found - expected).abs() < most, "{found} {expected}");
}

#[test]
fn a_disk_has_the_coefficients_of_its_closed_form() -> Outcome {
    let answer = asked("--radius 0.04 --patch disk --coefficient 0.3")?;
    close(number(&answer, "/arm"), 0.04 * 2.0 / 3.0, 1e-15);
    let cone = engine(&answer, "mujoco", "elliptic");
    close(
        number(cone, "/at_spin/value"),
        0.3 * 0.04 * 2.0 / 3.0,
        1e-15,
    );
    // The error of the ellipsoid's torque on the uniform disk (docs/limit-surface.md).
    close(number(cone, "/at_spin/largest_error"), 0.1506, 1e-4);
    // A limit of its own is all or nothing: right at one end, or wrong by half at both.
    let separate = engine(&answer, "newton", "XPBD");
    close(number(separate, "/at_spin/largest_error"), 1.0, 1e-15);
    close(
        number(separate, "/least_error/value"),
        0.5 * 0.3 * 0.04 * 2.0 / 3.0,
        1e-9,
    );
    close(number(separate, "/least_error/largest_error"), 0.5, 1e-6);
    assert_eq!(
        engine(&answer, "drake", "hydroelastic")["at_spin"],
        Value::Null
    );
    assert_eq!(engine(&answer, "genesis", "none")["model"], Value::Null);
    assert_eq!(number(&answer, "/rolling"), 0.0);
    Ok(())
}

#[test]
fn a_hertzian_patch_has_its_own_radius_in_gazebo() -> Outcome {
    let answer = asked("--radius 0.006 --patch hertz --coefficient 0.8")?;
    let patch = engine(&answer, "gazebo", "ODE");
    close(number(patch, "/at_spin/value"), 0.006, 1e-15);
    let coefficient = engine(&answer, "gazebo", "Featherstone");
    close(
        number(coefficient, "/at_spin/value"),
        0.8 * 3.0 * PI / 16.0 * 0.006,
        1e-15,
    );
    Ok(())
}

/// Torque of a box of even pressure against a spin of 1, over load, by the midpoint rule.
fn torque([a, b]: [f64; 2], [vx, vy]: [f64; 2]) -> f64 {
    let count = 300;
    let mut sum = 0.0;
    for i in 0..count {
        for j in 0..count {
            let [x, y] = [(i, a), (j, b)]
                .map(|(k, side)| side * ((f64::from(k) + 0.5) / f64::from(count) - 0.5));
            let (u, v) = (vx - y, vy + x);
            sum += (x * v - y * u) / u.hypot(v);
        }
    }
    sum / f64::from(count * count)
}

#[test]
fn errors_of_a_box_are_those_of_its_integral() -> Outcome {
    let sides = [0.06, 0.02];
    let answer = asked("--patch box:0.06x0.02")?;
    let (arm, radius) = (torque(sides, [0.0, 0.0]), 0.03_f64.hypot(0.01));
    close(number(&answer, "/arm"), arm, 1e-7);
    close(number(&answer, "/radius"), radius, 1e-15);
    let length = number(engine(&answer, "mujoco", "elliptic"), "/least_error/value");
    let limit = number(
        engine(&answer, "mujoco", "elliptic"),
        "/least_error/largest_error",
    );
    for (row, ratio) in [0.1, 0.3, 1.0, 3.0, 10.0].into_iter().enumerate() {
        let speed = radius / ratio;
        let exact: Vec<f64> = (0..24)
            .map(|i| {
                let angle = TAU * f64::from(i) / 24.0;
                torque(sides, [speed * angle.cos(), speed * angle.sin()])
            })
            .collect();
        let place = |name: &str| format!("/errors/{row}/{name}");
        let mean = exact.iter().sum::<f64>() / 24.0 / arm;
        close(number(&answer, &place("exact")), mean, 1e-4);
        let made = length * length / (length * length + speed * speed).sqrt();
        let worst = exact.iter().map(|exact| (made - exact) / arm);
        let worst = worst.fold(0.0, |worst: f64, error| {
            if error.abs() > worst.abs() {
                error
            } else {
                worst
            }
        });
        let found = number(&answer, &place("ellipsoid/least_error"));
        close(found, worst, 1e-4);
        assert!(found.abs() <= limit + 1e-12);
    }
    Ok(())
}

#[test]
fn the_least_error_is_least_and_no_place_of_the_patch_matters() -> Outcome {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("box.csv");
    // The same box off the origin, turned by a right angle.
    std::fs::write(&file, "x,y\n0.5,0.2\n0.52,0.2\n0.52,0.26\n0.5,0.26\n")?;
    let (here, there) = (
        asked("--patch box:0.06x0.02")?,
        asked(&format!("--patch polygon:{}", file.display()))?,
    );
    for word in ["elliptic", "pyramidal"] {
        let [a, b] = [&here, &there].map(|answer| engine(answer, "mujoco", word));
        for place in [
            "/at_spin/value",
            "/at_spin/largest_error",
            "/least_error/value",
            "/least_error/largest_error",
        ] {
            close(number(a, place), number(b, place), 1e-6);
        }
        assert!(number(a, "/least_error/largest_error") < number(a, "/at_spin/largest_error"));
    }
    // Lengths grow with the patch, errors stay.
    let large = asked("--patch box:0.6x0.2 --coefficient 0.5")?;
    let [small, large] = [&here, &large].map(|answer| engine(answer, "mujoco", "elliptic"));
    close(
        number(large, "/least_error/value"),
        5.0 * number(small, "/least_error/value"),
        1e-9,
    );
    close(
        number(large, "/least_error/largest_error"),
        number(small, "/least_error/largest_error"),
        1e-9,
    );
    Ok(())
}

#[test]
fn the_table_of_patches_has_the_arms_of_closed_forms() -> Outcome {
    let rows: Value = serde_json::from_str(&told("coefficients --format json")?)?;
    let root = 2.0_f64.sqrt();
    for (name, arm) in [
        ("disk", 2.0 / 3.0),
        ("ring", 1.0),
        ("annulus:0.5", 2.0 / 3.0 * (1.0 - 0.125) / (1.0 - 0.25)),
        ("hertz", 3.0 * PI / 16.0),
        ("punch", PI / 4.0),
        ("paraboloid", 8.0 / 15.0),
        ("box:1x1", (root + (1.0 + root).ln()) / 6.0),
        ("bar:1", 0.25),
    ] {
        let rows = rows.as_array().map_or(&[][..], Vec::as_slice);
        let row = rows.iter().find(|row| row["patch"] == name).ok_or(name)?;
        close(number(row, "/arm"), arm, 1e-13);
        close(number(row, "/patch_radius"), arm * 16.0 / (3.0 * PI), 1e-13);
    }
    let csv = told("coefficients --format csv")?;
    assert!(
        csv.starts_with("patch,arm,patch_radius,ellipsoid,error\ndisk,0.666"),
        "{csv}"
    );
    Ok(())
}
