//! `tribos measure` measures runs and files, and runs start from both.

use crate::program::{self, Error, Outcome, number, summary};
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
        powder(&first, &["height=12", "size_distribution=uniform:0.1"])?
            .status
            .success()
    );
    for start in [
        first.clone(),
        first.join("final.xyz"),
        first.join("final.vtp"),
    ] {
        let start = format!("initial_state={}", start.display());
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
    let output = powder(&second, &["initial_state=nowhere"])?;
    assert_eq!(output.status.code(), Some(2));
    assert!(!second.join("tribos.json").exists());
    Ok(())
}

#[test]
fn options_that_would_change_nothing_are_refused() -> Outcome {
    let home = tempfile::tempdir()?;
    let home = home.path();
    let run = home.join("run");
    assert!(
        powder(&run, &["height=12", "max_steps=20"])?
            .status
            .success()
    );
    let pair =
        "2\nLattice=\"20 0 0 0 20 0 0 0 20\" Properties=pos:R:3:radius:R:1\n1 1 1 1\n3 1 1 1\n";
    std::fs::write(home.join("pair.xyz"), pair)?;
    for (command, words) in [
        ("measure run --gap 0.01", "--gap has no effect"),
        ("measure pair.xyz --angle 30", "--angle has no effect"),
        ("measure pair.xyz --density 2", "--density has no effect"),
        (
            "measure pair.xyz --periods 20,20,-",
            "it says that it repeats along z after 20",
        ),
        ("view run --out page.html --still 1", "cannot be used with"),
        ("run disk --out disk --checkpoint 9", "--checkpoint is for"),
        ("run disk --out disk --allow-large", "--allow-large is for"),
    ] {
        let (code, _, told) = program::tribos(home, command)?;
        assert_eq!(code, Some(2), "{command}: {told}");
        assert!(told.contains(words), "{command}: {told}");
    }
    // LAMMPS data do not say which axes repeat: across the border of z there is a contact, or none.
    let data = "two\n\n2 atoms\n1 atom types\n\n0 10 xlo xhi\n0 10 ylo yhi\n0 10 zlo zhi\n\nAtoms # sphere\n\n\
                1 1 1 2500 5 5 0.5\n2 1 1 2500 5 5 9.5\n";
    std::fs::write(home.join("two.data"), data)?;
    for (periods, contacts) in [("10,10,10", 1), ("10,10,-", 0)] {
        let command = format!("measure two.data --periods {periods} --format json");
        let (_, out, told) = program::tribos(home, &command)?;
        let measures: Value = serde_json::from_str(&out).map_err(|_| told)?;
        assert_eq!(measures["contacts"], contacts, "{periods}");
    }
    Ok(())
}

#[test]
fn files_of_no_known_format_are_refused_with_what_was_expected() -> Outcome {
    let home = tempfile::tempdir()?;
    let home = home.path();
    for (name, text, words) in [
        ("plain.xyz", "2\n\nAu 0 0 0\nAu 2.9 0 0\n", "plain XYZ"),
        (
            "table.csv",
            "x,y,z,radius\n0,0,0,1\n",
            "none of extended XYZ",
        ),
        (
            "yade.txt",
            "#format x_y_z_r\n0 0 0 1\n",
            "none of extended XYZ",
        ),
        (
            "mercury.data",
            "2 0 0 0 0 10 10 10\n1 1 1 0 0 0 1\n",
            "none of extended XYZ",
        ),
        ("packed.zip", "PK\u{3}\u{4}\0", "unzip"),
    ] {
        std::fs::write(home.join(name), text)?;
        for command in ["measure", "eval --pair lj:cutoff=2.5 --out out"] {
            let (code, _, told) = program::tribos(home, format!("{command} {name}"))?;
            assert_eq!(code, Some(2), "{command} {name}: {told}");
            assert!(told.contains(words), "{command} {name}: {told}");
        }
    }
    Ok(())
}
