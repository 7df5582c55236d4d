//! `tribos onset`: answers, tables, pictures, refusals.

use crate::program::{Outcome, refused, succeed, told};
use std::fs;

#[test]
fn people_read_the_ratio_of_torque_to_force() -> Outcome {
    let out = told("onset --bond weibull:m=8 --points 3")?;
    assert!(
        out.contains("bonds               weibull:m=8 (a model)\n"),
        "{out}"
    );
    assert!(out.contains("T_s/(F_s R)         0.5775"), "{out}");
    // Without re-forming there is no dynamic friction.
    assert!(!out.contains("static"), "{out}");
    let gap = told("onset --bond re-forming-one-strength --points 2")?;
    assert!(
        gap.contains("static over dynamic 2 for a pure push\n"),
        "{gap}"
    );
    let boxed = told("onset --patch box:2x2 --bond one-strength --points 2")?;
    assert!(boxed.contains("T_s/(F_s R)         0.333333"), "{boxed}");
    Ok(())
}

#[test]
fn table_document_and_picture_have_the_same_curve() -> Outcome {
    let folder = tempfile::tempdir()?;
    let line = "onset --bond re-forming:n=64 --coefficient 0.5 --load 4 --radius 0.1 --points 5";
    let files = "--output onset.csv --picture onset.svg --format json";
    let [out, said] = succeed(folder.path(), format!("{line} {files}"))?;
    assert!(
        said.contains("onset.csv") && said.contains("onset.svg"),
        "{said}"
    );
    let answer: serde_json::Value = serde_json::from_str(&out)?;
    assert!((answer["force"].as_f64().ok_or("force")? - 2.0).abs() < 1e-12);
    assert!((answer["static_over_dynamic"].as_f64().ok_or("gap")? - 1.5119).abs() < 1e-4);
    let table = fs::read_to_string(folder.path().join("onset.csv"))?;
    let header = "share,force_x,force_y,torque,displacement_x,displacement_y,turn,of_limit,static_over_dynamic";
    assert_eq!(table.lines().next(), Some(header));
    assert_eq!(table.lines().count(), 1 + 5);
    for (row, point) in table
        .lines()
        .skip(1)
        .zip(answer["points"].as_array().ok_or("points")?)
    {
        for (cell, name) in row.split(',').zip(header.split(',')) {
            assert_eq!(Some(cell.parse()?), point[name].as_f64(), "{name}");
        }
    }
    assert_eq!(told(format!("{line} --format csv"))?, table);
    let picture = fs::read_to_string(folder.path().join("onset.svg"))?;
    assert!(picture.contains("re-forming:n=64 bonds (a model)"));
    Ok(())
}

#[test]
fn what_cannot_be_is_refused_with_a_cure() -> Outcome {
    for (line, reason) in [
        ("onset --bond weibul:m=2", "did you mean `weibull`?"),
        ("onset --bond weibull", "such as weibull:m=8"),
        (
            "onset --bond re-forming:n=0",
            "number of stages must be positive",
        ),
        ("onset --load 0", "give a number > 0"),
        ("onset --points 1", "2..=10000"),
        ("onset --patch box:2x2 --radius 2", "leave out --radius"),
        (
            "onset --centre 0.1,0",
            "a centre of pressure is for boxes and polygons",
        ),
        ("onset --patch box:1x1 --centre 0.5,0", "lifts off"),
    ] {
        let said = refused(".", line)?;
        assert!(said.contains(reason), "{line}: {said}");
    }
    Ok(())
}
