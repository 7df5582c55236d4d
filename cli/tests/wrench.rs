//! `tribos wrench` prints what the kernel computes, in the form that was asked for.

use assert_cmd::Command;
use std::f64::consts::PI;

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn tribos(arguments: &[&str]) -> Result<String, Box<dyn std::error::Error>> {
    let output = Command::cargo_bin("tribos")?.args(arguments).output()?;
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    Ok(String::from_utf8(output.stdout)?)
}

#[test]
fn one_twist_as_json_keeps_all_bits() -> Outcome {
    let text = tribos(&["wrench", "--speed", "1", "--spin", "1", "--format", "json"])?;
    let value: serde_json::Value = serde_json::from_str(&text)?;
    let force = value["force"].as_f64().ok_or("no force")?;
    assert!((force - 8.0 / (3.0 * PI)).abs() < 2e-16);
    // The shortest text of a number is the one that Rust writes.
    let torque = value["torque"].as_f64().ok_or("no torque")?;
    assert!(text.contains(&format!("\"torque\": {torque:?}")), "{text}");
    Ok(())
}

#[test]
fn dimensions_scale_force_and_torque() -> Outcome {
    let dimensionless = ["--speed", "0.5", "--spin", "1", "--format", "csv"];
    let plain = tribos(&[&["wrench"][..], &dimensionless].concat())?;
    // The same ratio v/(ωR) with radius 1/4, load 8 and coefficient 1/2.
    let scaled = tribos(&[
        "wrench",
        "--speed",
        "0.5",
        "--spin",
        "4",
        "--radius",
        "0.25",
        "--load",
        "8",
        "--coefficient",
        "0.5",
        "--format",
        "csv",
    ])?;
    let row = |text: &str| -> Vec<f64> {
        let line = text.lines().nth(1).unwrap_or("");
        line.split(',')
            .filter_map(|cell| cell.parse().ok())
            .collect()
    };
    let (plain, scaled) = (row(&plain), row(&scaled));
    assert_eq!(scaled[2], 4.0 * plain[2]);
    assert_eq!(scaled[3], plain[3]);
    Ok(())
}

#[test]
fn a_file_of_twists_becomes_csv_with_the_jacobian() -> Outcome {
    let folder = tempfile::tempdir()?;
    let twists = folder.path().join("twists.csv");
    let output = folder.path().join("deep/wrenches.csv");
    // Columns in any order, spaces allowed.
    std::fs::write(&twists, "spin, speed\n1,0.25\n-2,-0.5\n0,0\n")?;
    let (input, out) = (twists.display().to_string(), output.display().to_string());
    let printed = tribos(&["wrench", "--twists", &input, "--jacobian", "--output", &out])?;
    assert_eq!(printed, "");
    let text = std::fs::read_to_string(&output)?;
    let lines: Vec<&str> = text.lines().collect();
    let header = "speed,spin,force,torque,dforce_dspeed,dforce_dspin,dtorque_dspeed,dtorque_dspin";
    assert_eq!(lines[0], header);
    assert_eq!(lines.len(), 4);
    // Dry friction depends on the ratio only.
    let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let number = |cell: &String| cell.parse::<f64>().unwrap_or(f64::NAN);
    for (a, b) in cells(lines[1])[2..4].iter().zip(&cells(lines[2])[2..4]) {
        // Both motions are turned about.
        assert_eq!(number(a), -number(b));
    }
    assert_eq!(cells(lines[3])[2], "0.0");
    Ok(())
}

#[test]
fn all_tiers_and_precisions_agree() -> Outcome {
    for alpha in ["-0.5", "0", "0.5", "1", "2.5"] {
        let force = |more: &[&str]| -> Result<f64, Box<dyn std::error::Error>> {
            let base = [
                "wrench", "--alpha", alpha, "--speed", "0.8", "--spin", "1.1",
            ];
            let text = tribos(&[&base[..], &["--format", "json"], more].concat())?;
            let value: serde_json::Value = serde_json::from_str(&text)?;
            value["force"].as_f64().ok_or("no force".into())
        };
        let table = force(&[])?;
        assert!((force(&["--tier", "compact"])? / table - 1.0).abs() < 1e-14);
        assert!((force(&["--tier", "quadrature"])? / table - 1.0).abs() < 1e-6);
        assert!((force(&["--precision", "f32"])? / table - 1.0).abs() < 1e-6);
    }
    Ok(())
}

#[test]
fn a_large_exponent_is_served_without_tables() -> Outcome {
    let text = tribos(&[
        "wrench", "--alpha", "30", "--speed", "1", "--spin", "0", "--format", "csv",
    ])?;
    assert_eq!(
        text.lines().nth(1).and_then(|line| line.split(',').nth(2)),
        Some("1.0")
    );
    Ok(())
}

#[test]
fn the_rows_of_a_file_are_those_of_single_twists_in_every_format() -> Outcome {
    let folder = tempfile::tempdir()?;
    let twists = folder.path().join("twists.csv");
    std::fs::write(&twists, "\u{feff}speed,spin\r\n1,2\r\n\r\n\"0.5\", 3\r\n")?;
    let file = twists.display().to_string();
    let one = |speed, spin, format| {
        tribos(&[
            "wrench", "--speed", speed, "--spin", spin, "--format", format,
        ])
    };
    let all = |format| tribos(&["wrench", "--twists", &file, "--format", format]);
    let json: serde_json::Value = serde_json::from_str(&all("json")?)?;
    let rows = [("1", "2"), ("0.5", "3")];
    for (at, (speed, spin)) in rows.into_iter().enumerate() {
        let mut single: serde_json::Value = serde_json::from_str(&one(speed, spin, "json")?)?;
        // The contact is said once, beside the answer.
        single
            .as_object_mut()
            .and_then(|single| single.remove("contact"));
        assert_eq!(json[at], single);
        let csv = one(speed, spin, "csv")?;
        assert_eq!(csv.lines().nth(1), all("csv")?.lines().nth(at + 1));
    }
    let twist = |text: String| {
        let lines = text.lines().skip_while(|line| !line.starts_with("speed"));
        lines.map(|line| format!("{line}\n")).collect::<String>()
    };
    let text = [
        twist(one("1", "2", "text")?),
        twist(one("0.5", "3", "text")?),
    ]
    .join("\n");
    assert!(all("text")?.ends_with(&text));
    Ok(())
}

/// 60 MB of addresses, program and all: a table of as many twists in memory takes more than 100.
#[cfg(target_os = "linux")]
#[test]
fn many_twists_take_no_more_memory_than_few() -> Outcome {
    let folder = tempfile::tempdir()?;
    let twists = folder.path().join("twists.csv");
    let rows: String = (0..300_000).map(|k| format!("{}e-5,1\n", k)).collect();
    std::fs::write(&twists, format!("speed,spin\n{rows}"))?;
    let output = std::process::Command::new("sh")
        .arg("-c")
        .arg("ulimit -v 60000; exec \"$0\" wrench --twists \"$1\" --jacobian --output \"$2\"")
        .arg(env!("CARGO_BIN_EXE_tribos"))
        .args([&twists, &folder.path().join("out.csv")])
        .output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let written = std::fs::read_to_string(folder.path().join("out.csv"))?;
    assert_eq!(written.lines().count(), 300_001);
    // A bad row at the end leaves what was written before.
    std::fs::write(&twists, format!("speed,spin\n{rows}1,x\n"))?;
    let refused = Command::cargo_bin("tribos")?
        .args(["wrench", "--twists"])
        .arg(&twists)
        .arg("--output")
        .arg(folder.path().join("out.csv"))
        .output()?;
    let said = String::from_utf8(refused.stderr)?;
    assert_eq!(refused.status.code(), Some(2));
    assert!(said.contains("twists.csv:300002: spin is `x`"), "{said}");
    assert_eq!(
        std::fs::read_to_string(folder.path().join("out.csv"))?,
        written
    );
    Ok(())
}
