//! `tribos measure` measures runs and files, and runs start from both.

use crate::program::{self, Outcome, json, number, succeed, summary};
use serde_json::Value;
use std::path::Path;

/// A small powder under a piston, in a folder of the home.
fn powder(home: &Path, out: &str, sets: &str) -> Outcome {
    let run = "run compaction-small --quiet --set width=8";
    succeed(home, format!("{run} {sets} --out {out}"))?;
    Ok(())
}

#[test]
fn a_run_is_measured_with_its_forces_and_over_its_frames() -> Outcome {
    let home = tempfile::tempdir()?;
    let (run, out) = (home.path().join("run"), home.path().join("measures"));
    powder(home.path(), "run", "--set height=12")?;
    let [told, _] = succeed(home.path(), "measure --frames run --out measures")?;
    let measures = json(&out.join("measures.json"))?;
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
    assert!(told.contains("with their forces"));
    Ok(())
}

#[test]
fn a_file_has_contacts_of_its_geometry_and_no_stress() -> Outcome {
    let home = tempfile::tempdir()?;
    let file = home.path().join("pair.xyz");
    let text = "2\nLattice=\"20 0 0 0 20 0 0 0 20\" Properties=species:S:1:pos:R:3:radius:R:1\n\
                X 1 1 1 1\nX 3 1 1 1\n";
    std::fs::write(&file, text)?;
    let [told, _] = succeed(home.path(), "measure --format json pair.xyz")?;
    let measures: Value = serde_json::from_str(&told)?;
    assert_eq!(
        (&measures["contacts"], &measures["stress"]),
        (&Value::from(1), &Value::Null)
    );
    Ok(())
}

#[test]
fn a_finished_run_and_its_export_start_other_runs() -> Outcome {
    let home = tempfile::tempdir()?;
    let (first, second) = (home.path().join("first"), home.path().join("second"));
    let sets = "--set height=12 --set size_distribution=uniform:0.1";
    powder(home.path(), "first", sets)?;
    for start in ["first", "first/final.xyz", "first/final.vtp"] {
        let sets = format!("--set initial_state={start} --set pressure=0.01");
        powder(home.path(), "second", &sets)?;
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
    Ok(())
}

#[test]
fn periods_of_lammps_data_are_those_that_are_given() -> Outcome {
    let home = tempfile::tempdir()?;
    let home = home.path();
    // Across the border of z there is a contact, or none.
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
fn means_over_time_are_those_of_the_series() -> Outcome {
    let home = tempfile::tempdir()?;
    let out = home.path().join("flow");
    let sets = "--set duration=0.1 --set average_from=0.04";
    let [said, _] = succeed(
        home.path(),
        format!("run shear-periodic {sets} --quiet --out flow"),
    )?;
    program::assert_has(
        &said,
        &[
            "means         solid fraction",
            "stress ratio",
            "inertial number",
        ],
    );
    // Sums over the lines later than 0.04 s, each with the time since the line before.
    let text = std::fs::read_to_string(out.join("series.csv"))?;
    let names: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
    let at = |name: &str| {
        names
            .iter()
            .position(|known| *known == name)
            .unwrap_or(usize::MAX)
    };
    let [time, zz, shear] = ["time", "stress_zz", "shear_stress"].map(at);
    let (mut before, mut sums) = (0.0, [0.0; 3]);
    for line in text.lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(str::parse).collect::<Result<_, _>>()?;
        if row[time] > 0.04 {
            for (sum, value) in sums.iter_mut().zip([1.0, row[zz], row[shear]]) {
                *sum += value * (row[time] - before);
            }
        }
        before = row[time];
    }
    let told = summary(&out)?;
    let mean = |column: &str| {
        told["averages"][column]["mean"]
            .as_f64()
            .unwrap_or(f64::NAN)
    };
    for (column, wanted) in [
        ("stress_zz", sums[1] / sums[0]),
        ("stress_ratio", sums[2] / sums[1]),
    ] {
        assert!(
            (mean(column) / wanted - 1.0).abs() < 1e-12,
            "{column}: {} {wanted}",
            mean(column)
        );
    }
    // I = rate d √(ρ/P) of the mean pressure, with the mean diameter to the spread of 216 radii.
    let number = 10.0 * 0.01 * (2500.0 * sums[0] / sums[1]).sqrt();
    assert!((mean("inertial_number") / number - 1.0).abs() < 0.02);

    // The command finds the same in the series, and others from another time on.
    let measured = |option: &str| -> Result<Value, program::Error> {
        let [text, _] = succeed(home.path(), format!("measure flow --format json {option}"))?;
        Ok(serde_json::from_str::<Value>(&text)?["averages"].clone())
    };
    assert_eq!(measured("")?, told["averages"]);
    assert_ne!(measured("--average-from 0.06")?, told["averages"]);
    let [text, _] = succeed(home.path(), "measure flow --out measured")?;
    program::assert_has(&text, &["over time", "stress_ratio"]);
    let table = std::fs::read_to_string(home.path().join("measured/averages.csv"))?;
    assert_eq!(table.lines().count(), 1 + names.len() - 2);
    let (code, _, refused) = program::tribos(home.path(), "measure flow --average-from 1")?;
    assert_eq!(code, Some(2));
    program::assert_has(&refused, &["--average-from 1", "0.1"]);
    Ok(())
}
