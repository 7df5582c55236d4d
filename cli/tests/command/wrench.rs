//! `tribos wrench` prints what the kernel computes, in the form that was asked for.

use crate::program::{Error, Outcome, succeed, told, tribos};
use std::f64::consts::PI;

#[test]
fn one_twist_as_json_keeps_all_bits() -> Outcome {
    let text = told("wrench --speed 1 --spin 1 --format json")?;
    let value: serde_json::Value = serde_json::from_str(&text)?;
    let force = value["force"].as_f64().ok_or("no force")?;
    assert!((force - 8.0 / (3.0 * PI)).abs() < 2e-16);
    // The shortest text of a number is the one that Rust writes.
    let torque = value["torque"].as_f64().ok_or("no torque")?;
    assert!(text.contains(&format!("\"torque\": {torque:?}")), "{text}");
    Ok(())
}

#[test]
fn a_motion_that_is_not_given_is_none() -> Outcome {
    for patch in ["disk", "box:0.3x0.2"] {
        for (given, all) in [
            ("--speed 1.5", "--speed 1.5 --spin 0"),
            ("--spin -2", "--speed 0 --spin -2"),
        ] {
            let [short, full] =
                [given, all].map(|motion| format!("wrench --patch {patch} {motion}"));
            assert_eq!(
                told(short.as_str())?,
                told(full.as_str())?,
                "{patch} {given}"
            );
        }
    }
    Ok(())
}

#[test]
fn dimensions_scale_force_and_torque() -> Outcome {
    let dimensionless = ["--speed", "0.5", "--spin", "1", "--format", "csv"];
    let plain = told([&["wrench"][..], &dimensionless].concat())?;
    // The same ratio v/(ωR) with radius 1/4, load 8 and coefficient 1/2.
    let scaled =
        told("wrench --speed 0.5 --spin 4 --radius 0.25 --load 8 --coefficient 0.5 --format csv")?;
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
    let printed = told(["wrench", "--twists", &input, "--jacobian", "--output", &out])?;
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
        let force = |more: &[&str]| -> Result<f64, Error> {
            let base = [
                "wrench", "--alpha", alpha, "--speed", "0.8", "--spin", "1.1",
            ];
            let text = told([&base[..], &["--format", "json"], more].concat())?;
            let value: serde_json::Value = serde_json::from_str(&text)?;
            value["force"].as_f64().ok_or("no force".into())
        };
        let exact = force(&[])?;
        for older in ["table", "compact"] {
            assert_eq!(force(&["--tier", older])?, exact);
        }
        assert!((force(&["--tier", "quadrature"])? / exact - 1.0).abs() < 1e-6);
        assert!((force(&["--precision", "f32"])? / exact - 1.0).abs() < 1e-6);
    }
    Ok(())
}

#[test]
fn a_large_exponent_is_served_without_tables() -> Outcome {
    let text = told("wrench --alpha 30 --speed 1 --spin 0 --format csv")?;
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
        told([
            "wrench", "--speed", speed, "--spin", spin, "--format", format,
        ])
    };
    let all = |format| told(["wrench", "--twists", &file, "--format", format]);
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
    let line = "wrench --twists twists.csv --output out.csv";
    let (code, _, said) = tribos(folder.path(), line)?;
    assert_eq!(code, Some(2));
    assert!(said.contains("twists.csv:300002: spin is `x`"), "{said}");
    assert_eq!(
        std::fs::read_to_string(folder.path().join("out.csv"))?,
        written
    );
    Ok(())
}

/// Named numbers of the answer, and what is said beside it.
fn said(arguments: &str) -> Result<(serde_json::Value, String), Error> {
    let [answer, told] = succeed(".", format!("wrench {arguments} --format json"))?;
    Ok((serde_json::from_str(&answer)?, told))
}

#[test]
fn results_inside_the_number_range_are_right_whatever_their_factors_are() -> Outcome {
    // The same contacts in other units: products of the factors that are numbers.
    let pairs = [
        (
            "--coefficient 1e-200 --load 1e-200 --radius 1e200 --speed 1 --spin 1",
            "--speed 1e-200 --spin 1",
            [0.0, 1e-200],
        ),
        (
            "--coefficient 1e200 --load 1e200 --radius 1e-200 --speed 1e-100 --spin 1e200",
            "--load 1e200 --speed 1e-100 --spin 1",
            [1e200, 1.0],
        ),
        (
            "--coefficient 1e-200 --alpha 2 --speed 1e200 --spin 1e200",
            "--alpha 2 --speed 1 --spin 1",
            [1e200, 1e200],
        ),
        (
            "--coefficient 1e200 --alpha 2 --speed 1e-200 --spin 1e-200",
            "--alpha 2 --speed 1 --spin 1",
            [1e-200, 1e-200],
        ),
        (
            "--alpha 0.5 --radius 1e200 --spin 1e200 --speed 1",
            "--alpha 0.5 --spin 1 --speed 1e-200",
            [0.0, 0.0],
        ),
        (
            "--coefficient 1e-200 --load 1e-100 --alpha 2 --tier quadrature --speed 1e140 --spin 1e140",
            "--alpha 2 --speed 1 --spin 1 --tier quadrature",
            [1e-20, 1e-20],
        ),
    ];
    for (extreme, plain, [force, torque]) in pairs {
        let (value, told) = said(extreme)?;
        let (wanted, _) = said(plain)?;
        for (name, scale) in [("force", force), ("torque", torque)] {
            if scale == 0.0 {
                continue;
            }
            let found = value[name].as_f64().ok_or(format!("{extreme}: {name}"))?;
            let wanted = wanted[name].as_f64().ok_or("no number")? * scale;
            let error = (found / wanted - 1.0).abs();
            assert!(error < 1e-14, "{extreme}: {name} {found:e} {wanted:e}");
        }
        let is_beyond = ["force", "torque"]
            .iter()
            .any(|name| !value[name].as_f64().is_some_and(f64::is_normal));
        assert_eq!(told.contains("warning"), is_beyond, "{extreme}: {told}");
    }
    // A force that only the ratio of the speeds makes small: F = ε while the rim leads.
    let (value, told) = said(
        "--patch annulus:0.5 --coefficient 3.7e89 --load 2.57e273 --radius 7.8e91 --speed 2.2e-129 \
         --spin 2.1e149",
    )?;
    let (unit, _) = said("--patch annulus:0.5 --speed 1e-100 --spin 1")?;
    let drag = unit["force"].as_f64().ok_or("force")? / 1e-100;
    let wanted = drag * (3.7e89 / 7.8e91) * (2.57e273 / 2.1e149) * 2.2e-129;
    let force = value["force"].as_f64().ok_or("force")?;
    assert!((force / wanted - 1.0).abs() < 1e-13, "{force:e} {wanted:e}");
    assert!(
        told.contains("inf"),
        "the torque is beyond the range: {told}"
    );
    Ok(())
}

#[test]
fn slopes_are_right_whatever_their_factors_are() -> Outcome {
    let (extreme, _) = said("--radius 1e200 --spin 1e107 --speed 5e306 --jacobian")?;
    // Dry friction: the slopes of speeds 10^100 times as slow are as much steeper.
    let (plain, _) = said("--radius 1e100 --spin 1e7 --speed 5e106 --jacobian --load 1e-93")?;
    for (name, scale) in [
        ("dforce_dspeed", 1e93 / 1e200),
        ("dforce_dspin", 1e93 / 1e100),
        ("dtorque_dspeed", 1e93 / 1e100),
        ("dtorque_dspin", 1e93),
    ] {
        let found = extreme[name].as_f64().ok_or(name)?;
        let wanted = plain[name].as_f64().ok_or(name)? * scale;
        assert!(
            (found / wanted - 1.0).abs() < 1e-12,
            "{name} {found:e} {wanted:e}"
        );
    }
    Ok(())
}

#[test]
fn weights_of_points_count_by_their_ratios_alone() -> Outcome {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("feet.csv");
    for unit in ["1", "1e308", "1e-320", "3e-310"] {
        std::fs::write(&path, format!("x,y,weight\n1,0,{unit}\n-1,0,{unit}\n"))?;
        for precision in ["f64", "f32"] {
            let patch = format!("--patch points:{} --precision {precision}", path.display());
            let (value, told) = said(&format!("{patch} --speed 1 --spin 1"))?;
            assert!(!told.contains("warning"), "{told}");
            for name in ["force", "torque"] {
                let x = value[name].as_f64().ok_or(name)?;
                assert!((x - 0.5_f64.sqrt()).abs() < 1e-7, "{unit} {precision}: {x}");
            }
        }
    }
    Ok(())
}

#[test]
fn laws_that_are_powers_have_the_exact_tier() -> Outcome {
    let twist = "--patch hertz --speed 0.5741485371342836 --spin 1";
    let exact = said(&format!("{twist} --alpha=-0.5"))?;
    assert!((exact.0["force"].as_f64().ok_or("force")? - 0.681_075).abs() < 1e-6);
    let (named, told) = said(&format!("{twist} --law power:gamma=1,alpha=-0.5"))?;
    assert_eq!(named["force"], exact.0["force"]);
    assert!(!told.contains("warning"), "{told}");
    // Nodes are far off and say so.
    let (_, told) = said(&format!("{twist} --alpha=-0.5 --tier quadrature"))?;
    assert!(
        told.contains("warning: nodes stand for the pressure"),
        "{told}"
    );
    let (_, told) = said(&format!("{twist} --alpha 0.5 --tier quadrature"))?;
    assert!(!told.contains("warning"), "{told}");
    Ok(())
}

/// Devices of this test's own: never those of the machine.
#[cfg(unix)]
#[test]
fn devices_pipes_and_links_are_written_into() -> Outcome {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    use std::process::Command;
    let folder = tempfile::tempdir()?;
    let here = |name: &str| folder.path().join(name);
    let write = |name: &str| -> Result<(Option<i32>, String), Error> {
        let (code, _, said) = tribos(
            folder.path(),
            format!("wrench --speed 1 --spin 1 -o {name}"),
        )?;
        Ok((code, said))
    };
    assert!(Command::new("mkfifo").arg(here("pipe")).status()?.success());
    let reader = std::thread::spawn({
        let pipe = here("pipe");
        move || std::fs::read_to_string(pipe)
    });
    assert_eq!(write("pipe")?.0, Some(0));
    let read = reader.join().map_err(|_| "the reader failed")??;
    assert!(read.contains("force"), "{read}");
    assert!(here("pipe").metadata()?.file_type().is_fifo());

    std::fs::write(here("file"), "old")?;
    std::fs::set_permissions(here("file"), PermissionsExt::from_mode(0o640))?;
    symlink("file", here("link"))?;
    assert_eq!(write("link")?.0, Some(0));
    assert!(here("link").is_symlink());
    assert_eq!(std::fs::read_to_string(here("file"))?, read);
    let mode = here("file").metadata()?.permissions().mode();
    assert_eq!(mode & 0o777, 0o640);

    // Standard output is a file that somebody else has opened, with a line in it.
    let line = "echo first; exec \"$0\" wrench --speed 1 --spin 1 -o /dev/stdout";
    let mut shell = Command::new("sh");
    let shell = shell.args(["-c", line, env!("CARGO_BIN_EXE_tribos")]);
    let shell = shell.stdout(std::fs::File::create(here("log"))?);
    assert!(shell.status()?.success());
    assert_eq!(
        std::fs::read_to_string(here("log"))?,
        format!("first\n{read}")
    );

    // Full and null, as Linux numbers them.
    for (name, minor, code) in [("full", "7", Some(1)), ("null", "3", Some(0))] {
        let mut node = Command::new("mknod");
        let made = node.arg(here(name)).args(["c", "1", minor]).output()?;
        if !cfg!(target_os = "linux") || !made.status.success() {
            println!("skipped: a device cannot be made (needs root)");
            return Ok(());
        }
        let opened = std::fs::OpenOptions::new().write(true).open(here(name));
        if opened.is_err() {
            println!("skipped: devices cannot be opened here");
            return Ok(());
        }
        let (ended, told) = write(name)?;
        assert_eq!(ended, code, "{name}: {told}");
        assert!(
            here(name).metadata()?.file_type().is_char_device(),
            "{name}"
        );
    }
    Ok(())
}
