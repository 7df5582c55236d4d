//! Boxes, polygons and bars: `tribos wrench`, `tribos surface`.

use crate::program::{Error, Outcome, succeed, told};
use std::fs;
use std::path::Path;

/// Rows of a table after its header.
fn rows(table: &str) -> Vec<Vec<f64>> {
    let numbers = |line: &str| {
        line.split(',')
            .map(|cell| cell.parse().expect("a number"))
            .collect()
    };
    table.lines().skip(1).map(numbers).collect()
}

/// A square frame with a square hole.
fn frame(folder: &Path) -> Outcome {
    let outer = "x,y,loop\n-1,-1,a\n1,-1,a\n1,1,a\n-1,1,a\n";
    let hole = "-0.5,-0.5,b\n0.5,-0.5,b\n0.5,0.5,b\n-0.5,0.5,b\n";
    Ok(fs::write(
        folder.join("frame.csv"),
        format!("{outer}{hole}"),
    )?)
}

#[test]
fn boxes_polygons_and_bars_have_their_torque_of_pure_spinning() -> Outcome {
    let folder = tempfile::tempdir()?;
    frame(folder.path())?;
    // A square of two triangles; the second one has a needle of no area beside it.
    let header = "x1,y1,p1,x2,y2,p2,x3,y3,p3";
    let triangles = "-1,-1,7,1,-1,7,1,1,7\n1,1,7,-1,1,7,-1,-1,7\n1,1,7,0,0,7,-1,-1,7";
    fs::write(
        folder.path().join("square.csv"),
        format!("{header}\n{triangles}\n"),
    )?;
    // Mean distances: of a square of half side a, a (√2 + asinh 1)/3; of the frame from both squares.
    let square = (2.0_f64.sqrt() + 1.0_f64.asinh()) / 3.0;
    for (patch, arm) in [
        ("box:2x2", square),
        ("polygon:frame.csv", square * (4.0 - 0.5) / 3.0),
        ("bar:0.2", 0.05),
        ("mesh:square.csv", square),
    ] {
        let line = format!(
            "wrench --patch {patch} --coefficient 0.5 --load 10 --speed 0 --spin 3 --format json"
        );
        let [out, _] = succeed(folder.path(), line)?;
        let answer: serde_json::Value = serde_json::from_str(&out)?;
        let torque = answer["torque"].as_f64().ok_or("torque")?;
        assert!((torque + 5.0 * arm).abs() < 1e-14, "{patch}: {torque}");
        assert_eq!(answer["contact"]["coefficient"], 0.5);
    }
    Ok(())
}

#[test]
fn boxes_and_polygons_serve_powers_of_the_speed() -> Outcome {
    let folder = tempfile::tempdir()?;
    frame(folder.path())?;
    // Viscous friction: γN ω times the mean square of the distance, (a² + b²)/12 for a box.
    let square = (4.0 + 4.0) / 12.0;
    let hole = (1.0 + 1.0) / 12.0;
    for (patch, mean) in [
        ("box:2x2", square),
        ("box:0.3x0.2", (0.09 + 0.04) / 12.0),
        ("polygon:frame.csv", (4.0 * square - hole) / 3.0),
    ] {
        for law in [
            "--coefficient 0.5 --alpha 1",
            "--law power:gamma=0.5,alpha=1",
        ] {
            let line = format!(
                "wrench --patch {patch} {law} --load 10 --speed 0.2 --spin 3 --jacobian --format json"
            );
            let [out, _] = succeed(folder.path(), line)?;
            let answer: serde_json::Value = serde_json::from_str(&out)?;
            let part = |name: &str| answer[name].as_f64().ok_or(name.to_owned());
            assert!((part("force_x")? + 5.0 * 0.2).abs() < 1e-13, "{patch}");
            assert!(
                (part("torque")? + 5.0 * 3.0 * mean).abs() < 1e-13,
                "{patch}"
            );
            assert!(
                (part("dtorque_dspin")? + 5.0 * mean).abs() < 1e-13,
                "{patch}"
            );
            assert_eq!(answer["contact"]["alpha"], 1.0);
        }
    }
    // The same box with its load towards one side, and in single precision.
    let box_ = "wrench --patch box:0.3x0.2 --centre 0.02,0 --alpha 0.5 --speed 0.5 --spin 3";
    let [double, said] = succeed(folder.path(), format!("{box_} --format csv"))?;
    assert!(said.contains("alpha 0.5"), "{said}");
    let [single, _] = succeed(
        folder.path(),
        format!("{box_} --format csv --precision f32"),
    )?;
    for (a, b) in rows(&double)[0].iter().zip(&rows(&single)[0]) {
        assert!((a - b).abs() < 1e-5, "{double}{single}");
    }
    Ok(())
}

#[test]
fn a_file_of_planar_twists_has_wrenches_and_nine_derivatives() -> Result<(), Error> {
    let folder = tempfile::tempdir()?;
    let twists = "velocity_x,velocity_y,spin\n0.3,-0.2,1.5\n0.2,0.4,-0.1\n";
    fs::write(folder.path().join("twists.csv"), twists)?;
    let line =
        "wrench --patch box:0.3x0.2 --centre 0.02,0.01 --load 7 --jacobian --twists twists.csv";
    let [table, said] = succeed(folder.path(), line)?;
    assert!(said.contains("centre 0.02,0.01 m"), "{said}");
    let header = table.lines().next().ok_or("a header")?;
    assert!(
        header
            .starts_with("velocity_x,velocity_y,spin,force_x,force_y,torque,dforce_x_dvelocity_x,")
    );
    assert!(header.ends_with("dtorque_dvelocity_x,dtorque_dvelocity_y,dtorque_dspin"));
    for row in rows(&table) {
        let [twist, wrench, jacobian] = [&row[..3], &row[3..6], &row[6..]];
        let power: f64 = twist.iter().zip(wrench).map(|(t, w)| t * w).sum();
        assert!(power < 0.0, "{row:?}");
        // Dry friction does not depend on the speed: the derivative along the twist is 0.
        for line in jacobian.chunks(3) {
            let along: f64 = line.iter().zip(twist).map(|(d, t)| d * t).sum();
            assert!(along.abs() < 1e-13, "{along}");
        }
        assert!((jacobian[1] - jacobian[3]).abs() < 1e-13);
    }
    Ok(())
}

#[test]
fn pushes_are_judged_by_the_limit_surface() -> Outcome {
    let folder = tempfile::tempdir()?;
    let box_ = "surface --patch box:0.3x0.2 --coefficient 0.4 --load 20";
    let pushes = "torque,force_x,force_y\n0,4,0\n0.2,-6,3\n0,0,0\n";
    fs::write(folder.path().join("pushes.csv"), pushes)?;
    let [table, _] = succeed(folder.path(), format!("{box_} --pushes pushes.csv"))?;
    let [straight, turning, none] = rows(&table).try_into().map_err(|_| "three rows")?;
    assert_eq!(&straight[..3], [4.0, 0.0, 0.0]);
    assert!((straight[3] - 0.5).abs() < 1e-14 && (straight[4] - 1.0).abs() < 1e-14);
    assert!(turning[3] < 1.0 && turning[4] < 0.0 && turning[5] > 0.0 && turning[6] > 0.0);
    assert_eq!(none[3..], [0.0; 4]);
    // Every point of the table lies on the surface, and the picture is one.
    let [points, _] = succeed(folder.path(), format!("{box_} --points 50"))?;
    let found = rows(&points);
    assert_eq!(found.len(), 50);
    let again: String = found
        .iter()
        .map(|row| format!("{},{},{}\n", row[0], row[1], row[2]))
        .collect();
    fs::write(
        folder.path().join("pushes.csv"),
        format!("force_x,force_y,torque\n{again}"),
    )?;
    let [table, _] = succeed(folder.path(), format!("{box_} --pushes pushes.csv"))?;
    for row in rows(&table) {
        assert!((row[3] - 1.0).abs() < 1e-13, "{row:?}");
    }
    succeed(folder.path(), format!("{box_} --picture box.svg"))?;
    assert!(
        fs::read_to_string(folder.path().join("box.svg"))?.contains("Limit surface of box:0.3x0.2")
    );
    // The page keeps nothing outside, and its points lie on the surface too.
    succeed(
        folder.path(),
        format!("{box_} --page box.html --pushes pushes.csv"),
    )?;
    let page = fs::read_to_string(folder.path().join("box.html"))?;
    assert!(!page.contains("src=") && page.contains("drawPushes"));
    let data = page.split_once("class=\"data\">").ok_or("data")?.1;
    let data: serde_json::Value =
        serde_json::from_str(data.split_once("</script>").ok_or("an end")?.0)?;
    assert_eq!(data["pushes"].as_array().map(Vec::len), Some(50));
    let points = data["points"].as_array().ok_or("points")?;
    assert_eq!(points.len(), 65 * 120);
    let [top, limit] = [&points[64 * 120][2], &data["limits"]["torque"]].map(|x| x.as_f64());
    assert!((top.ok_or("a torque")? / limit.ok_or("a limit")? - 1.0).abs() < 1e-5);
    let round = told("surface --patch hertz --radius 0.01 --points 3")?;
    assert_eq!(round.lines().count(), 4);
    Ok(())
}

#[test]
fn points_answer_at_any_planar_twist_and_turn_about_one_another() -> Result<(), Error> {
    let folder = tempfile::tempdir()?;
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text);
    write("feet.csv", "x,y,weight\n-0.1,0,1\n0.1,0,1\n")?;
    write("twists.csv", "velocity_x,velocity_y,spin\n0,0.5,0\n0,0,3\n")?;
    let line = "wrench --patch points:feet.csv --coefficient 0.5 --load 20 --twists twists.csv";
    let [table, _] = succeed(folder.path(), format!("{line} --jacobian"))?;
    let [slides, turns] = rows(&table).try_into().map_err(|_| "two rows")?;
    // Each foot resists with 5 N against its own velocity.
    for (row, expected) in [(&slides, [0.0, -10.0, 0.0]), (&turns, [0.0, 0.0, -1.0])] {
        for (found, expected) in row[3..6].iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{row:?}");
        }
    }
    assert_eq!(slides.len(), 3 + 3 + 9);
    // Across the motion a point resists with its force over its speed: 10 N over 0.5 m/s.
    assert!((slides[6] + 20.0).abs() < 1e-13 && slides[10].abs() < 1e-13);
    // Pushed at one foot, it turns about the other one.
    write("pushes.csv", "force_x,force_y,torque\n0,1,0.08\n0,1,0.09\n")?;
    let surface = "surface --patch points:feet.csv --coefficient 0.5 --load 20";
    let [table, _] = succeed(folder.path(), format!("{surface} --pushes pushes.csv"))?;
    for row in rows(&table) {
        let [vx, vy, spin] = [row[4], row[5], row[6]];
        assert!(
            vx.abs() < 1e-15 && (vy - 0.1 * spin).abs() < 1e-15 && spin > 0.0,
            "{row:?}"
        );
        // About the foot at -0.1 m the push has the torque 0.1 + torque; the other foot holds 5 N at 0.2 m.
        assert!((row[3] - (0.1 + row[2]) / 1.0).abs() < 1e-14, "{row:?}");
    }
    Ok(())
}

#[test]
fn pressure_comes_from_pushes() -> Outcome {
    let folder = tempfile::tempdir()?;
    let box_ = "--patch box:0.3x0.2";
    let line = format!("surface {box_} --coefficient 0.4 --load 20 --points 80");
    let [points, _] = succeed(folder.path(), line)?;
    let pushes: String = rows(&points)
        .iter()
        .map(|row| {
            let [push, motion] = [&row[..3], &row[3..]];
            format!(
                "{},{},{},{},{},{}\n",
                push[2], motion[0], motion[1], motion[2], push[0], push[1]
            )
        })
        .collect();
    let write = |text: &str| fs::write(folder.path().join("pushes.csv"), text);
    write(&format!(
        "# a box\ntorque,dx,dy,dtheta,fx,fy\n# 80 of them\n{pushes}"
    ))?;
    let fit = "fit --support pushes.csv";
    let [told, _] = succeed(folder.path(), format!("{fit} {box_} --out out"))?;
    assert!(told.contains("no fit"), "{told}");
    let summary = fs::read_to_string(folder.path().join("out/summary.json"))?;
    let summary: serde_json::Value = serde_json::from_str(&summary)?;
    let median = |k: usize| {
        summary["models"][k]["median_angle_deg"]
            .as_f64()
            .ok_or("a median")
    };
    assert_eq!(summary["models"][0]["name"], "known");
    assert!(median(0)? < 1e-6 && median(1)? < 0.5, "{summary}");
    for axis in 0..2 {
        let centre = summary["centre_of_pressure"][axis]
            .as_f64()
            .ok_or("a centre")?;
        assert!(centre.abs() < 1e-3, "{summary}");
    }
    let table = fs::read_to_string(folder.path().join("out/pressure.csv"))?;
    let shares: f64 = rows(&table).iter().map(|row| row[2]).sum();
    assert!((shares - 1.0).abs() < 1e-12);
    assert!(
        fs::read_to_string(folder.path().join("out/pressure.svg"))?.contains("centre of pressure")
    );
    // Without the support its models are three.
    let [told, _] = succeed(folder.path(), fit)?;
    assert!(
        !told.contains("no fit") && told.contains("quartic"),
        "{told}"
    );
    Ok(())
}
