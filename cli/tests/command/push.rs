//! `tribos push`: answers, tables, pictures.

use crate::program::{Outcome, succeed};
use std::fs;

#[test]
fn a_box_is_pushed_with_its_answer_path_and_picture() -> Outcome {
    let folder = tempfile::tempdir()?;
    let line = "push push-box --output box.csv --picture box.svg --format json";
    let [out, said] = succeed(folder.path(), line)?;
    assert!(
        said.contains("box.csv") && said.contains("box.svg"),
        "{said}"
    );
    let answer: serde_json::Value = serde_json::from_str(&out)?;
    assert_eq!(answer["mode"], "sliding to the left");
    assert_eq!(answer["stable"], serde_json::Value::Null);
    let table = fs::read_to_string(folder.path().join("box.csv"))?;
    assert!(table.starts_with("time,x,y,angle,contact_x,contact_y,velocity_x,"));
    assert_eq!(table.lines().count(), 1 + 101);
    // The last row is the end of the summary, to the bit.
    let last = table.lines().last().ok_or("rows")?;
    let cells: Result<Vec<f64>, _> = last.split(',').map(str::parse).collect();
    let cells = cells?;
    for (cell, name) in cells
        .iter()
        .zip(["end_time", "end_x", "end_y", "end_angle"])
    {
        assert_eq!(Some(*cell), answer[name].as_f64());
    }
    let picture = fs::read_to_string(folder.path().join("box.svg"))?;
    assert!(picture.contains("box:0.3x0.2, pushed"));
    // At most all load rubs at the corners.
    let [yaw, most] = ["yaw_limit", "yaw_limit_of_any_pressure"].map(|name| answer[name].as_f64());
    let corners = 8.0 * 0.15_f64.hypot(0.1);
    assert!((most.ok_or("most")? - corners).abs() < 1e-9);
    assert!(yaw < most);
    Ok(())
}
