//! `tribos wrench`, `laws` and `modes` with other patches and laws.

use crate::program::{Error, Outcome, told};
use std::f64::consts::PI;

/// The named field of one twist.
fn field(arguments: &str, name: &str) -> Result<f64, Error> {
    let value: serde_json::Value =
        serde_json::from_str(&told(format!("wrench {arguments} --format json"))?)?;
    Ok(value[name].as_f64().ok_or(name)?)
}

fn assert_close(got: f64, wanted: f64, tolerance: f64, what: &str) {
    let error = (got - wanted).abs();
    assert!(error <= tolerance, "{what}: {got}, not {wanted}");
}

#[test]
fn pressures_have_their_torque_of_pure_spinning() -> Outcome {
    for (patch, torque) in [
        ("disk", 2.0 / 3.0),
        ("ring", 1.0),
        ("hertz", 3.0 * PI / 16.0),
        ("punch", PI / 4.0),
        ("paraboloid", 8.0 / 15.0),
        ("polynomial:1,-1", 8.0 / 15.0),
        ("polynomial:0,2", 0.8),
        ("annulus:0.5", 2.0 / 3.0 * 0.875 / 0.75),
    ] {
        let arguments = format!("--patch {patch} --tier exact --speed 0 --spin 1");
        assert_close(field(&arguments, "torque")?, torque, 1e-14, &arguments);
        let nodes = format!("--patch {patch} --tier quadrature --tilt 0 --speed 0 --spin 1");
        assert_close(field(&nodes, "torque")?, torque, 1e-3, &nodes);
    }
    Ok(())
}

#[test]
fn tilt_adds_the_lateral_force_and_nothing_else() -> Outcome {
    // G = (F/eps + T)/5 for the uniform disk, 32/(45 pi) at equal speeds.
    let upright = "--speed 1 --spin 1";
    let tilted = format!("{upright} --tilt 0.5");
    let lateral = field(&tilted, "lateral")?;
    assert_close(lateral, 0.5 * 32.0 / (45.0 * PI), 1e-15, &tilted);
    for name in ["force", "torque"] {
        assert_eq!(field(upright, name)?, field(&tilted, name)?);
    }
    // Dimensions: load 8, coefficient 1/2, radius 1/4 at the same ratio.
    let scaled = "--speed 1 --spin 4 --radius 0.25 --load 8 --coefficient 0.5 --tilt 0.5";
    assert_close(field(scaled, "lateral")?, 4.0 * lateral, 1e-15, scaled);
    // The rear loaded more turns the sign; a body that would tip may be held.
    assert_eq!(
        field("--speed 1 --spin 1 --tilt -0.5", "lateral")?,
        -lateral
    );
    let held = field("--speed 1 --spin 1 --tilt 9 --on-lift clamp", "lateral")?;
    assert_eq!(held, 2.0 * lateral);
    Ok(())
}

#[test]
fn a_law_by_name_is_the_law_by_exponent() -> Outcome {
    for patch in ["disk", "annulus:0.5"] {
        let twist = "--speed 0.4 --spin 1";
        let exact = field(
            &format!("--patch {patch} {twist} --alpha 0.5 --coefficient 0.3"),
            "force",
        )?;
        let named = format!("--patch {patch} {twist} --law power:gamma=0.3,alpha=0.5");
        assert_close(field(&named, "force")?, exact, 1e-15, &named);
        // Upright round patches under a power have the tier that serves it best, by any name.
        let nodes = format!("{named} --tier quadrature");
        assert_close(field(&nodes, "force")?, exact, 1e-8, &nodes);
    }
    let exact = field(
        "--patch hertz --speed 0.4 --spin 1 --coefficient 0.3",
        "force",
    )?;
    let named = "--patch hertz --speed 0.4 --spin 1 --law coulomb:mu=0.3";
    assert_close(field(named, "force")?, exact, 1e-15, named);
    Ok(())
}

#[test]
fn a_tripod_from_a_file_is_the_sum_of_its_feet() -> Outcome {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("feet.csv");
    std::fs::write(&path, "weight,x,y\n1,0.5,0\n1,-0.5,0\n2,0,1\n")?;
    let patch = format!("--patch points:{}", path.display());
    // Pure spinning, counterclockwise: each foot resists across its arm.
    let torque = field(&format!("{patch} --speed 0 --spin 2 --load 4"), "torque")?;
    assert_close(torque, 0.5 + 0.5 + 2.0, 1e-15, "torque");
    // The feet at (±1/2, 0) push along ∓y and cancel; the one at (0, 1) is pushed along +x.
    let force = field(&format!("{patch} --speed 0 --spin 2 --load 4"), "force")?;
    assert_close(force, -2.0, 1e-15, "force");
    assert_eq!(field(&format!("{patch} --speed 3 --spin 0"), "force")?, 1.0);
    // Clockwise is not the mirror image of counterclockwise here.
    let left = field(&format!("{patch} --speed 1 --spin 1"), "torque")?;
    let right = field(&format!("{patch} --speed 1 --spin -1"), "torque")?;
    assert!((left + right).abs() > 0.1, "{left} {right}");
    Ok(())
}

#[test]
fn every_law_is_listed_with_units_and_source() -> Outcome {
    let list: serde_json::Value = serde_json::from_str(&told("laws --format json")?)?;
    let laws = list.as_array().ok_or("no array")?;
    assert!(laws.len() >= 16);
    for law in laws {
        for key in ["name", "formula", "source", "summary"] {
            assert!(
                law[key].as_str().is_some_and(|text| !text.is_empty()),
                "{law}"
            );
        }
        assert!(
            law["parameters"]
                .as_array()
                .is_some_and(|list| !list.is_empty())
        );
    }
    Ok(())
}

#[test]
fn curves_of_laws_are_written_as_numbers_and_pictures() -> Outcome {
    let folder = tempfile::tempdir()?;
    let base = "laws --curve power:gamma=2,alpha=0.5 --curve coulomb:mu=0.3 --from 0.01 --to 1";
    for ending in ["csv", "svg", "png"] {
        let path = folder.path().join(format!("curve.{ending}"));
        told(format!("{base} --out {}", path.display()))?;
        assert!(std::fs::metadata(&path)?.len() > 1000, "{ending}");
    }
    let csv = std::fs::read_to_string(folder.path().join("curve.csv"))?;
    let last = csv.lines().last().ok_or("empty")?;
    let cells: Vec<f64> = last
        .split(',')
        .filter_map(|cell| cell.parse().ok())
        .collect();
    assert_close(cells[1], 2.0 * cells[0].sqrt(), 1e-15, last);
    assert_eq!(cells[2], 0.3);
    Ok(())
}

#[test]
fn final_motion_depends_on_patch_and_lean() -> Outcome {
    let ratio = |arguments: &str| -> Result<f64, Error> {
        let text = told(format!("modes {arguments} --format json"))?;
        let value: serde_json::Value = serde_json::from_str(&text)?;
        Ok(value["final_ratio"].as_f64().ok_or(text)?)
    };
    // A ring and a punch whose fixed points are exactly one.
    assert_close(
        ratio("--alpha 0 --inertia-ratio 1 --patch ring")?,
        1.0,
        1e-14,
        "ring",
    );
    assert_close(
        ratio("--alpha 0 --inertia-ratio 0.5 --patch punch")?,
        1.0,
        1e-14,
        "punch",
    );
    // A tall cylinder's, bisected with 30 digits.
    let tall = ratio("--alpha 0 --inertia-ratio 0.5 --lean 0.8")?;
    assert_close(tall, 0.670_104_521_635_125_7, 1e-14, "tall");
    // A curling rock: together under alpha = -1/2, spinning last under -0.19.
    let rock = "--inertia-ratio 2.69 --patch ring";
    assert_close(ratio(&format!("--alpha -0.5 {rock}"))?, 0.782, 5e-4, "rock");
    assert_eq!(ratio(&format!("--alpha -0.19 {rock}"))?, 0.0);
    Ok(())
}

#[test]
fn modes_answers_in_json_and_draws() -> Outcome {
    let folder = tempfile::tempdir()?;
    for ending in ["svg", "png", "csv"] {
        let file = folder.path().join(format!("diagram.{ending}"));
        let place = file.to_str().ok_or("a name")?;
        let arguments = "modes --alpha 0 --inertia-ratio 0.5 --format json --diagram";
        let words = [arguments.split(' ').collect(), vec![place]].concat();
        let answer: serde_json::Value = serde_json::from_str(&told(words)?)?;
        let points = answer["fixed_points"].as_array().ok_or("no points")?;
        assert_eq!(points.len(), 3);
        assert_eq!(points[1]["stability"], "stable");
        let ratio = points[1]["ratio"].as_f64().ok_or("no ratio")?;
        assert!((ratio - 0.653_001_789_205_597_6).abs() < 1e-15);
        assert_eq!(answer["final_mode"], "together");
        assert!(file.metadata()?.len() > 1000);
    }
    Ok(())
}
