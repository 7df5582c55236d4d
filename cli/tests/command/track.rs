//! `tribos fit --track`: a filmed body in text and JSON, its files, and refusals with their cure.

use crate::program::{Error, Outcome, assert_has, succeed, tribos};
use std::f64::consts::PI;

/// A puck that only slides, in mm and degrees: 1.2 m/s, μ 0.25, 60 frames/s; errors of about 0.3 mm.
fn film() -> String {
    let (mu, speed, gravity) = (0.25, 1.2, 9.81);
    let rows = (0..50).map(|k| {
        let t = f64::from(k) / 60.0;
        let late = t.min(speed / (mu * gravity));
        let way = 1e3 * (speed * late - 0.5 * mu * gravity * late * late);
        let error = |phase: f64| 0.4 * (phase + 2.4 * f64::from(k * k)).sin();
        format!(
            "{t},{},{},{}\n",
            way + error(0.0),
            40.0 + error(1.0),
            30.0 + error(2.0)
        )
    });
    format!("t,x,y,angle\n{}", rows.collect::<String>())
}

#[test]
fn a_film_gives_coefficient_and_launch_with_errors_and_files() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("puck.csv"), film())?;
    let line = "fit --track puck.csv --units x=mm,y=mm,angle=deg --fix R=0.03 --out out";
    let [told, _] = succeed(folder.path(), line)?;
    assert_has(
        &told,
        &[
            "coulomb on a disk",
            "mu ",
            "[0.2486, 0.2502]",
            "starts",
            "rest          at t = 0.4",
            "as a law      coulomb:mu=0.2",
        ],
    );
    let toml = std::fs::read_to_string(folder.path().join("out/fit.toml"))?;
    assert_has(
        &toml,
        &["[parameters.mu]", "interval = [", "standard_error = "],
    );
    let residuals = std::fs::read_to_string(folder.path().join("out/residuals.csv"))?;
    assert!(residuals.starts_with("t,x,y,angle,residual_x,residual_y,residual_angle,speed,used\n"));
    assert_eq!(residuals.lines().count(), 51);
    for plot in ["fit.svg", "fit.png"] {
        assert!(folder.path().join("out").join(plot).metadata()?.len() > 1000);
    }
    let [json, _] = succeed(folder.path(), format!("{line} --format json"))?;
    let found: serde_json::Value = serde_json::from_str(&json)?;
    let parameters = found["parameters"].as_array().ok_or("no parameters")?;
    let of = |name: &str, key: &str| -> Result<f64, Error> {
        let entry = parameters.iter().find(|entry| entry["name"] == name);
        Ok(entry
            .and_then(|entry| entry[key].as_f64())
            .ok_or("no such number")?)
    };
    assert!((of("mu", "value")? - 0.25).abs() < 0.005 && of("mu", "error")? < 0.003);
    assert!((of("angle0", "value")? - 30.0 * PI / 180.0).abs() < 0.01);
    assert!((of("y0", "value")? - 0.04).abs() < 5e-4);
    assert_eq!((&found["rows"], &found["dropped"]), (&50.into(), &0.into()));
    Ok(())
}

#[test]
fn pixels_and_frames_need_their_scale() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("puck.csv"), film())?;
    for (options, cure) in [
        ("--units x=px", "--scale METRES_PER_PIXEL"),
        ("--units t=frames", "--frame-rate HZ"),
        ("--units angle=mm", "angle"),
        ("--from 90", "--from and --to"),
        ("--patch box:0.1x0.05 --law power", "--law coulomb"),
        ("--law lugre", "--law: "),
        ("--fix radius=1", "the parameters are mu, R, x0"),
    ] {
        let (code, _, told) = tribos(folder.path(), format!("fit --track puck.csv {options}"))?;
        assert_eq!(code, Some(2), "{options}: {told}");
        assert!(told.contains(cure), "{options}: {told}");
    }
    let [told, _] = succeed(
        folder.path(),
        "fit --track puck.csv --scale 0.001 --units angle=deg --fix R=0.03",
    )?;
    assert!(told.contains("coulomb:mu=0.2"), "{told}");
    Ok(())
}
