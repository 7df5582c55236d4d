//! `tribos measure` measures runs and files, and runs start from both.

use crate::program::{Error, Outcome, number, summary};
use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

fn tribos(arguments: &[&str]) -> Result<Command, Error> {
    let mut command = Command::cargo_bin("tribos")?;
    command.args(arguments);
    Ok(command)
}

/// A small powder under a piston.
fn powder(out: &Path, set: &[&str]) -> Result<std::process::Output, Error> {
    let mut command = tribos(&["run", "compaction-small", "--quiet", "--out"])?;
    command.arg(out).args(["--set", "width=8"]);
    for setting in set {
        command.args(["--set", setting]);
    }
    Ok(command.output()?)
}

#[test]
fn a_run_is_measured_with_its_forces_and_over_its_frames() -> Outcome {
    let home = tempfile::tempdir()?;
    let (run, out) = (home.path().join("run"), home.path().join("measures"));
    assert!(powder(&run, &["height=12"])?.status.success());
    let mut command = tribos(&["measure", "--frames"])?;
    let told = command.arg(&run).arg("--out").arg(&out).output()?;
    assert!(
        told.status.success(),
        "{}",
        String::from_utf8_lossy(&told.stderr)
    );
    let measures: Value = serde_json::from_slice(&std::fs::read(out.join("measures.json"))?)?;
    let summary = summary(&run)?;
    assert_eq!(measures["spheres"], summary["particles"]);
    let porosity = number(&measures, "porosity") / number(&summary, "porosity_final");
    assert!((porosity - 1.0).abs() < 1e-12);
    // The contacts' share of the stress is that of the last line of the run's series.
    let zz = |share: &str| measures["stress"][share][2][2].as_f64();
    let contacts = zz("plus").zip(zz("minus")).ok_or("no stress")?;
    let rows = std::fs::read_to_string(run.join("series.csv"))?;
    let last = rows.lines().last().and_then(|row| row.split(',').nth(5));
    let told_zz: f64 = last.ok_or("no series")?.parse()?;
    let over_pressure = (contacts.0 + contacts.1) / 0.0025;
    assert!(
        (over_pressure - told_zz).abs() < 1e-9,
        "{over_pressure} {told_zz}"
    );
    let mean = measures["coordination"]["mean"]
        .as_f64()
        .ok_or("no coordination")?;
    let known = summary["statistics"]["mean_coordination"]
        .as_f64()
        .ok_or("no statistics")?;
    assert!(mean <= known + 1e-12);
    for file in [
        "pair-correlation.csv",
        "forces.svg",
        "force-chains.csv",
        "necks.csv",
        "series.svg",
    ] {
        assert!(out.join(file).is_file(), "{file}");
    }
    let series = std::fs::read_to_string(out.join("series.csv"))?;
    let frames = std::fs::read_dir(run.join("frames"))?.count() - 1;
    assert_eq!(series.lines().count(), frames + 1);
    assert!(String::from_utf8(told.stdout)?.contains("with their forces"));
    Ok(())
}

#[test]
fn a_file_has_contacts_of_its_geometry_and_no_stress() -> Outcome {
    let home = tempfile::tempdir()?;
    let file = home.path().join("pair.xyz");
    let text = "2\nLattice=\"20 0 0 0 20 0 0 0 20\" Properties=species:S:1:pos:R:3:radius:R:1\n\
                X 1 1 1 1\nX 3 1 1 1\n";
    std::fs::write(&file, text)?;
    let output = tribos(&["measure", "--format", "json"])?
        .arg(&file)
        .output()?;
    let measures: Value = serde_json::from_slice(&output.stdout)?;
    assert_eq!(
        (&measures["contacts"], &measures["stress"]),
        (&Value::from(1), &Value::Null)
    );
    std::fs::write(&file, text.replace(":radius:R:1", ":size:R:1"))?;
    let output = tribos(&["measure"])?.arg(&file).output()?;
    assert_eq!(output.status.code(), Some(2));
    assert!(
        String::from_utf8(output.stderr)?
            .contains("line 2: there are no radii; give a column radius:R:1")
    );
    Ok(())
}

#[test]
fn a_finished_run_and_its_export_start_other_runs() -> Outcome {
    let home = tempfile::tempdir()?;
    let (first, second) = (home.path().join("first"), home.path().join("second"));
    assert!(
        powder(&first, &["height=12", "sizes=uniform:0.1"])?
            .status
            .success()
    );
    for start in [
        first.clone(),
        first.join("final.xyz"),
        first.join("final.vtp"),
    ] {
        let start = format!("start={}", start.display());
        let output = powder(&second, &[&start, "pressure=0.01"])?;
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        let (before, after) = (summary(&first)?, summary(&second)?);
        assert_eq!(before["particles"], after["particles"]);
        // A file's plates touch the spheres, which overlap a little.
        let [was, is] = [
            number(&before, "porosity_final"),
            number(&after, "porosity_initial"),
        ];
        assert!((was - is).abs() < 1e-3, "{was} {is}");
        std::fs::remove_dir_all(&second)?;
    }
    let output = powder(&second, &["start=nowhere"])?;
    assert_eq!(output.status.code(), Some(2));
    assert!(!second.join("tribos.json").exists());
    Ok(())
}
