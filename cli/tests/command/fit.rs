//! `tribos fit`: parameters with their errors, files that go together, refusals with their line.

use crate::program::{Error, Outcome, assert_has, succeed, tribos};
use std::path::Path;

fn data(name: &str) -> String {
    format!("{}/../scenes/data/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// A fit in the folder: what was told.
fn fit(folder: &Path, arguments: &str) -> Result<String, Error> {
    let [told, _] = succeed(folder, format!("fit {arguments}"))?;
    Ok(told)
}

/// Value and standard error of a parameter in fit.toml.
fn parameter(out: &Path, name: &str) -> Result<[f64; 2], Error> {
    let text = std::fs::read_to_string(out.join("fit.toml"))?;
    let table = text
        .split(&format!("[parameters.{name}]"))
        .nth(1)
        .ok_or("no such table")?;
    let number = |key: &str| -> Result<f64, Error> {
        let line = table.lines().find_map(|line| line.strip_prefix(key));
        Ok(line
            .ok_or("no such key")?
            .trim_start_matches(" = ")
            .parse()?)
    };
    Ok([number("value")?, number("standard_error")?])
}

#[test]
fn a_bearing_gives_its_parameters_back_and_files_that_other_commands_take() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out");
    let line = format!("--law stribeck {} --out out", data("bearing.csv"));
    let told = fit(folder.path(), &line)?;
    assert_has(
        &told,
        &[
            "reduced chi^2",
            "degrees of freedom",
            "ended at the best minimum",
            "±",
        ],
    );
    for (name, truth) in [
        ("mu_s", 0.15),
        ("mu_d", 0.08),
        ("vs", 0.02),
        ("delta", 1.5),
        ("k", 0.1),
    ] {
        let [value, error] = parameter(&out, name)?;
        assert!(
            (value - truth).abs() < 3.0 * error,
            "{name}: {value} ± {error}"
        );
    }
    let residuals = std::fs::read_to_string(out.join("residuals.csv"))?;
    assert!(residuals.starts_with("v,f,prediction,residual,sigma\n"));
    assert_eq!(residuals.lines().count(), 41);
    let covariance = std::fs::read_to_string(out.join("covariance.csv"))?;
    assert!(covariance.starts_with("parameter,mu_s,mu_d,vs,delta,k\n"));
    for plot in ["fit.svg", "fit.png"] {
        assert!(out.join(plot).metadata()?.len() > 1000);
    }
    // The law as other commands take it.
    let law = told.lines().find_map(|line| line.strip_prefix("as a law"));
    let law = law.ok_or("no law")?.trim();
    succeed(".", format!("wrench --speed 0.1 --spin 1 --law {law}"))?;
    // The same data, the same bytes.
    let before = std::fs::read(out.join("fit.toml"))?;
    fit(folder.path(), &line)?;
    assert_eq!(std::fs::read(out.join("fit.toml"))?, before);
    Ok(())
}

#[test]
fn a_record_over_time_tells_of_bristles() -> Outcome {
    let folder = tempfile::tempdir()?;
    let line = format!("--law lugre {} --out out", data("joint.csv"));
    let told = fit(folder.path(), &line)?;
    assert!(told.contains("lugre: s0 z + s1 z'"), "{told}");
    for (name, truth) in [
        ("fc", 1.0),
        ("fs", 1.5),
        ("vs", 0.01),
        ("s0", 1e4),
        ("s1", 30.0),
        ("s2", 10.0),
    ] {
        let [value, error] = parameter(&folder.path().join("out"), name)?;
        assert!(
            (value - truth).abs() < 3.0 * error && error < truth,
            "{name}: {value} ± {error}"
        );
    }
    Ok(())
}

#[test]
fn steady_sliding_gives_one_of_two_slopes_and_loads_count() -> Outcome {
    let folder = tempfile::tempdir()?;
    let rows: String = (0..20)
        .map(|k| {
            let speed = 1e-6 * 10_f64.powf(f64::from(k) * 0.15);
            format!("{speed:e},{}\n", 0.6 - 0.005 * (speed / 1e-5).ln())
        })
        .collect();
    std::fs::write(folder.path().join("rock.csv"), format!("v,f\n{rows}"))?;
    let fixed = "--fix eta=0 --fix a=0.01 --fix v0=1e-5";
    let told = fit(folder.path(), &format!("--law rate-state rock.csv {fixed}"))?;
    assert!(
        told.contains("b=0.0150000") || told.contains("b=0.0149999"),
        "{told}"
    );
    // Forces under a load are coefficients times the load.
    let under = |load: &str| {
        fit(
            folder.path(),
            &format!("--law power rock.csv --load {load}"),
        )
    };
    assert_ne!(under("2")?, under("1")?);
    Ok(())
}

#[test]
fn forces_of_any_unit_are_fitted() -> Outcome {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("m.csv");
    let out = folder.path().join("out");
    for (unit, load) in [(1e-150, "1"), (1e200, "1"), (1.0, "1e160")] {
        let row = |k: u32| {
            let speed = 0.1 * f64::from(k);
            let friction = unit * 0.3 * speed.sqrt() * (1.0 + 0.01 * f64::from(k % 3));
            format!("{speed},{friction:e}\n")
        };
        let rows: String = (1..=20).map(row).collect();
        std::fs::write(&path, format!("v,f\n{rows}"))?;
        let line = format!("--law power m.csv --load {load} --out out");
        let told = fit(folder.path(), &line)?;
        assert!(told.contains("16 of 16"), "{told}");
        let [alpha, error] = parameter(&out, "alpha")?;
        assert!(
            (alpha - 0.5).abs() < 0.02 && error < 0.02,
            "{alpha} ± {error}"
        );
    }
    Ok(())
}

#[test]
fn a_record_is_taken_apart_stroke_by_stroke() -> Outcome {
    let folder = tempfile::tempdir()?;
    let line = format!("--strokes {} --load 20 --out out", data("tribometer.csv"));
    let told = fit(folder.path(), &line)?;
    assert_has(
        &told,
        &[
            "strokes       30",
            "…",
            "run-in        settled after stroke",
            "stick-slip",
        ],
    );
    // The first and the last ten of them, a line between, the header: 22 lines.
    assert_eq!(
        told.lines().filter(|line| line.starts_with("  ")).count(),
        22
    );
    let out = folder.path().join("out");
    let table = std::fs::read_to_string(out.join("strokes.csv"))?;
    assert!(table.starts_with("number,start,duration,direction,length,"));
    assert_eq!(table.lines().count(), 31);
    for plot in ["strokes.svg", "strokes.png"] {
        assert!(out.join(plot).metadata()?.len() > 1000);
    }
    let line = format!(
        "--strokes {} --load 20 --format json",
        data("tribometer.csv")
    );
    let all: serde_json::Value = serde_json::from_str(&fit(folder.path(), &line)?)?;
    let number = |name: &str| all["summary"][name].as_f64().ok_or("no number");
    // Made with 0.2, an offset of 0.005 and slips of 0.04 every 0.24 s.
    for (name, truth, within) in [
        ("mean", 0.2, 0.004),
        ("offset", 0.005, 0.002),
        ("drop", 0.04, 0.002),
        ("period", 0.24, 0.003),
    ] {
        let found = number(name)?;
        assert!((found - truth).abs() < within, "{name}: {found}");
    }
    assert_eq!(all["strokes"].as_array().map(Vec::len), Some(30));
    Ok(())
}

/// A record of LuGre's joint as a German machine writes it.
fn machine_log() -> Result<String, Error> {
    let text = std::fs::read_to_string(data("joint.csv"))?;
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let mut log = String::from(
        "Prüfstand 7\nLast;12,5\n\nZeit;Kommentar;Geschwindigkeit;Reibkraft\ns;;mm/s;mN\n",
    );
    for row in rows {
        let mut cells = row.split(',').map(str::parse::<f64>);
        let mut next = || cells.next().ok_or("a row of three numbers");
        let (t, v, f) = (next()??, next()??, next()??);
        log += &format!("{t};ja;{};{}\n", 1e3 * v, 1e3 * f).replace('.', ",");
    }
    // Marks of gaps, and the last row once more.
    log += "9,9;nein;#NV;1\n9,9;;;1\n";
    Ok(log)
}

#[test]
fn a_log_as_a_machine_writes_it_gives_the_fit_of_the_prepared_table() -> Outcome {
    let folder = tempfile::tempdir()?;
    let log = machine_log()?;
    // One byte a letter.
    let bytes: Vec<u8> = log
        .chars()
        .map(|letter| u8::try_from(letter).unwrap_or(b'?'))
        .collect();
    std::fs::write(folder.path().join("log.txt"), bytes)?;
    let told = fit(folder.path(), "--law lugre log.txt --out out")?;
    let mut lines = told.lines();
    let read = "read          Latin-1, semicolons, decimal commas, 2 lines before the header, t from \"Zeit\" in s, \
                v from \"Geschwindigkeit\" in mm/s, f from \"Reibkraft\" in mN";
    assert_eq!(lines.next(), Some(read));
    let dropped = "read          2 rows dropped: 1 with an empty cell, 1 with NaN";
    assert_eq!(lines.next(), Some(dropped));
    fit(
        folder.path(),
        &format!("--law lugre {} --out prepared", data("joint.csv")),
    )?;
    for name in ["fc", "fs", "vs", "s0", "s1", "s2"] {
        let [made, wanted] =
            ["out", "prepared"].map(|out| parameter(&folder.path().join(out), name));
        let ([made, error], [wanted, _]) = (made?, wanted?);
        assert!(
            (made - wanted).abs() < 1e-3 * error,
            "{name}: {made} {wanted}"
        );
    }
    Ok(())
}

#[test]
fn a_first_look_needs_no_law_and_shows_the_cure() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("log.txt"), machine_log()?)?;
    let told = fit(folder.path(), "--look log.txt")?;
    assert_has(
        &told,
        &[
            "semicolons between cells, decimal commas",
            "header in line 4",
            "units in line 5",
            "mm/s",
            "first rows",
        ],
    );
    let json = fit(folder.path(), "log.txt --look --format json")?;
    let json: serde_json::Value = serde_json::from_str(&json)?;
    assert_eq!(json["columns"][2]["role"], "v");
    assert_eq!(json["columns"][1]["words"], 302);
    // Two speeds: one is named.
    std::fs::write(
        folder.path().join("two.csv"),
        "Speed,Velocity,COF\n1,1000,0.3\n2,2000,0.2\n3,3000,0.1\n4,4000,0.1\n",
    )?;
    let said = tribos(folder.path(), "fit --law power two.csv")?;
    assert_eq!(said.0, Some(2));
    assert_has(
        &said.2,
        &[
            "two.csv:1: `Speed` and `Velocity` may both be v",
            "--columns v=\"Speed\"",
            "--look",
        ],
    );
    let by_name = fit(
        folder.path(),
        "--law power two.csv --columns v=Velocity --units v=mm/s",
    )?;
    let by_number = fit(folder.path(), "--law power two.csv --columns v=1,f=COF")?;
    let law = |told: &str| {
        told.lines()
            .find(|line| line.starts_with("as a law"))
            .map(str::to_owned)
    };
    assert_eq!(law(&by_name), law(&by_number));
    Ok(())
}

#[test]
fn strokes_that_cannot_be_found_are_refused_with_a_reason() -> Outcome {
    let folder = tempfile::tempdir()?;
    let write = |text: &str| std::fs::write(folder.path().join("r.csv"), text);
    for (text, options, reason) in [
        ("v,f\n1,2\n", "", "no column for t"),
        ("t,v,f\n0,0,1\n1,0,1\n2,0,1\n", "", "nothing moves"),
        (
            "t,f,load\n0,1,2\n1,1,0\n",
            "",
            "r.csv:3: the load must be > 0",
        ),
        ("t,f,load\n0,1,2\n1,1,2\n", "--load 2", "both given"),
        ("t,f\n0,1\n1,1\n", "--law power", "cannot be used with"),
    ] {
        write(text)?;
        let line = format!("fit --strokes r.csv {options}");
        let (code, _, told) = tribos(folder.path(), line)?;
        assert_eq!(code, Some(2), "{text:?}");
        assert!(told.contains(reason), "{text:?}: {told}");
    }
    Ok(())
}

#[test]
fn pushes_of_a_spreadsheet_are_the_same_pushes() -> Outcome {
    let folder = tempfile::tempdir()?;
    let text = std::fs::read_to_string(data("pushes.csv"))?;
    let rows = text.lines().filter(|line| !line.starts_with('#'));
    let sheet: String = rows
        .map(|row| row.replace(',', ";").replace('.', ",") + "\r\n")
        .collect();
    std::fs::write(
        folder.path().join("sheet.csv"),
        sheet.replacen("fx;", "Kraft;", 1),
    )?;
    let made = fit(folder.path(), "--support sheet.csv --columns fx=Kraft")?;
    assert_eq!(
        made,
        fit(folder.path(), &format!("--support {}", data("pushes.csv")))?
    );
    Ok(())
}

/// A servo joint: f = 1.4 sgn v + 2.2 v + 0.57 a + 0.02, with steps in place of noise.
fn servo() -> String {
    let mut text = String::from("time [s];speed [rad/s];torque [N m]\n");
    for k in 0..400 {
        let t = 0.02 * f64::from(k) + 0.005;
        let (v, a) = (0.8 * (2.0 * t).sin(), 1.6 * (2.0 * t).cos());
        let f = 1.4 * v.signum() + 2.2 * v + 0.57 * a + 0.02 + 1e-3 * f64::from(k * 7 % 11 - 5);
        text += &format!("{t};{v};{f}\n").replace('.', ",");
    }
    text
}

#[test]
fn a_joint_is_fitted_with_its_drive_and_printed_for_programs() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("servo.txt"), servo())?;
    let bare = fit(folder.path(), "--law viscous servo.txt")?;
    assert_has(
        &bare,
        &[
            "read          semicolons, decimal commas",
            "fit it by --inertia",
        ],
    );
    let line = "--law viscous servo.txt --inertia --offset";
    let json = fit(folder.path(), &format!("{line} --format json"))?;
    let json: serde_json::Value = serde_json::from_str(&json)?;
    assert_eq!(
        (&json["law"], &json["rows"], &json["dropped"]),
        (&"viscous".into(), &400.into(), &0.into())
    );
    for (name, truth) in [("mu", 1.4), ("k", 2.2), ("inertia", 0.57), ("offset", 0.02)] {
        let all = json["parameters"].as_array().ok_or("no list")?;
        let one = all
            .iter()
            .find(|one| one["name"] == name)
            .ok_or("no parameter")?;
        let number = |value: &serde_json::Value| value.as_f64().ok_or("no number");
        let [low, high] = [number(&one["interval"][0])?, number(&one["interval"][1])?];
        // Accelerations are differences of the velocity: right to a thousandth.
        assert!(
            low - 1e-3 < truth && truth < high + 1e-3,
            "{name}: {low} to {high}"
        );
        assert!(number(&one["error"])? > 0.0 && number(&one["value"])? > low);
    }
    assert!(json["rms"].as_f64().is_some_and(|rms| rms < 5e-3));
    let xml = fit(folder.path(), &format!("{line} --as mujoco"))?;
    assert_has(&xml, &["frictionloss=\"1.4", "armature=\"0.57"]);
    let program = fit(
        folder.path(),
        &format!("--law lugre {} --as c", data("joint.csv")),
    )?;
    assert_has(&program, &["tribos_lugre_step_f64"]);
    Ok(())
}

#[test]
fn all_laws_are_compared_on_a_bearing() -> Outcome {
    let folder = tempfile::tempdir()?;
    let told = fit(
        folder.path(),
        &format!("--law all {} --out out", data("bearing.csv")),
    )?;
    assert_has(
        &told,
        &["best          stribeck", "left out      dahl", "coulomb"],
    );
    let table = std::fs::read_to_string(folder.path().join("out/laws.csv"))?;
    assert!(table.starts_with("law,parameters,rms,foretold,akaike,told_apart\nstribeck,5,"));
    let json = std::fs::read_to_string(folder.path().join("out/laws.json"))?;
    let json: serde_json::Value = serde_json::from_str(&json)?;
    assert_eq!(json["best"], "stribeck");
    assert!(json["laws"].as_array().is_some_and(|laws| laws.len() >= 6));
    Ok(())
}

#[test]
fn a_machine_that_does_not_belong_to_the_law_is_refused() -> Outcome {
    let folder = tempfile::tempdir()?;
    let bearing = data("bearing.csv");
    for (options, reason) in [
        ("--law stribeck --spring 3000", "leave --spring out"),
        ("--law rate-state --spring stiff", "or give `fit`"),
        ("--law stribeck --inertia", "an inertia needs accelerations"),
        ("--law dahl", "a record over time"),
        ("--law amontons", "no column for load"),
        ("--law all --as c", "choose a law"),
        ("--as c --look", "--law"),
        ("--law stribeck --as c --format json", "cannot be used with"),
        ("--law stribeck --patch disk", "--support or --track"),
    ] {
        let (code, _, told) = tribos(folder.path(), format!("fit {bearing} {options}"))?;
        assert_eq!(code, Some(2), "{options}");
        assert!(told.contains(reason), "{options}: {told}");
    }
    Ok(())
}
