//! `tribos push`: answers, tables, pictures, refusals.

use crate::program::{Outcome, refused, succeed, told};
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

#[test]
fn people_read_whether_a_pusher_sticks_and_whether_a_line_holds() -> Outcome {
    let sticks = told("push push-box --set pusher_coefficient=0.8")?;
    assert!(sticks.contains("pusher          sticking\n"), "{sticks}");
    assert!(sticks.contains("motion cone") && sticks.contains("gauge 1\n"));
    let line = "push push-box --set contact_x=-0.08 --set end_x=0.08 --set end_y=-0.1";
    let holds = told(format!("{line} --set spin=0.02"))?;
    assert!(holds.contains("stable push     yes"), "{holds}");
    let loose = told(format!("{line} --set spin=1"))?;
    assert!(loose.contains("stable push     no"), "{loose}");
    assert!(loose.contains("path            not followed"), "{loose}");
    // Round bodies and their own normals.
    let disk = "push push-box --set patch=disk --set contact_x=-0.05 --set contact_y=0 \
                --set velocity_x=0.02 --set velocity_y=0";
    let straight = told(disk)?;
    assert!(straight.contains("body at 0.2, 0 m"), "{straight}");
    Ok(())
}

#[test]
fn all_mistakes_of_a_scene_are_told_at_once_with_line_and_cure() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scene = "patch = \"bx:1x1\"\nmu = -1\nload = 20\ncontact_x = 0\ncontact_y = 0\n\
                 mu_pusher = 0.3\nvelocity_x = 0\nvelocity_y = 0.1\nend_x = 1\nspeed = 3\n";
    fs::write(folder.path().join("scene.toml"), scene)?;
    let message = refused(folder.path(), "push scene.toml")?;
    for part in [
        "scene.toml:1: `patch`: unknown patch `bx:1x1`",
        "scene.toml:2: `mu` must be a finite number > 0, not -1",
        "scene.toml:9: give both `end_x` and `end_y`, or none",
        "scene.toml:10: ",
        "`distance`",
    ] {
        assert!(message.contains(part), "{part}: {message}");
    }
    for (line, reason) in [
        ("push nothing", "push-box"),
        ("push push-box --set spin=1", "`end_x` and `end_y`"),
        (
            "push push-box --set patch=points:feet.csv",
            "no smooth limit surface",
        ),
        (
            "push push-box --set centre_x=0.1 --set centre_y=0",
            "lifts off",
        ),
        ("push push-box --set velocity_y=0", "nothing moves"),
        (
            "push push-box --set patch=disk --set contact_x=0 --set contact_y=0",
            "`normal_x` and `normal_y`",
        ),
    ] {
        let message = refused(folder.path(), line)?;
        assert!(message.contains(reason), "{line}: {message}");
    }
    Ok(())
}
