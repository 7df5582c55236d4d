//! `tribos onset`: tables and pictures.

use crate::program::{Outcome, succeed, told};
use std::fs;

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
