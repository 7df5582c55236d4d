//! `tribos fit`: parameters with their errors, files that go together, refusals with their line.

use crate::program::{Error, Outcome, Said, assert_has, tribos};
use assert_cmd::Command;
use std::path::Path;

fn data(name: &str) -> String {
    format!("{}/../scenes/data/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn fit(arguments: &[&str]) -> Result<Said, Error> {
    tribos(".", [&["fit"], arguments].concat())
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
    let path = out.to_str().ok_or("no text")?;
    let (code, told, said) = fit(&["--law", "stribeck", &data("bearing.csv"), "--out", path])?;
    assert_eq!(code, Some(0), "{said}");
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
    let wrench = [
        "wrench",
        "--speed",
        "0.1",
        "--spin",
        "1",
        "--law",
        law.ok_or("no law")?.trim(),
    ];
    Command::cargo_bin("tribos")?
        .args(wrench)
        .assert()
        .success();
    // The same data, the same bytes.
    let before = std::fs::read(out.join("fit.toml"))?;
    fit(&["--law", "stribeck", &data("bearing.csv"), "--out", path])?;
    assert_eq!(std::fs::read(out.join("fit.toml"))?, before);
    Ok(())
}

#[test]
fn a_record_over_time_tells_of_bristles() -> Outcome {
    let folder = tempfile::tempdir()?;
    let path = folder.path().to_str().ok_or("no text")?;
    let (code, told, said) = fit(&["--law", "lugre", &data("joint.csv"), "--out", path])?;
    assert!(
        code == Some(0) && told.contains("lugre-bristles"),
        "{told}{said}"
    );
    for (name, truth) in [
        ("fc", 1.0),
        ("fs", 1.5),
        ("vs", 0.01),
        ("s0", 1e4),
        ("s1", 30.0),
        ("s2", 10.0),
    ] {
        let [value, error] = parameter(folder.path(), name)?;
        assert!(
            (value - truth).abs() < 3.0 * error && error < truth,
            "{name}: {value} ± {error}"
        );
    }
    Ok(())
}

#[test]
fn what_the_data_do_not_tell_is_said_in_place_of_a_number() -> Outcome {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("rock.csv");
    let rows: String = (0..20)
        .map(|k| {
            let speed = 1e-6 * 10_f64.powf(f64::from(k) * 0.15);
            format!("{speed:e},{}\n", 0.6 - 0.005 * (speed / 1e-5).ln())
        })
        .collect();
    std::fs::write(&path, format!("v,f\n{rows}"))?;
    let path = path.to_str().ok_or("no text")?;
    let (code, told, _) = fit(&["--law", "rate-state", path, "--fix", "eta=0"])?;
    assert_eq!(code, Some(0));
    assert!(
        told.contains("only a combination of a and b; give --fix NAME=VALUE"),
        "{told}"
    );
    assert!(!told.contains("inf") && !told.contains("NaN"), "{told}");
    let (_, told, _) = fit(&[
        "--law",
        "rate-state",
        path,
        "--fix",
        "eta=0",
        "--fix",
        "a=0.01",
        "--fix",
        "v0=1e-5",
    ])?;
    assert!(!told.contains("warning"), "{told}");
    assert!(
        told.contains("b=0.0150000") || told.contains("b=0.0149999"),
        "{told}"
    );
    // Forces under a load are coefficients times the load.
    let (_, heavy, _) = fit(&["--law", "power", path, "--load", "2"])?;
    let (_, light, _) = fit(&["--law", "power", path, "--load", "1"])?;
    assert_ne!(heavy, light);
    Ok(())
}

#[test]
fn bad_measurements_are_refused_with_their_line_and_cure() -> Outcome {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("m.csv");
    let name = path.to_str().ok_or("no text")?.to_owned();
    for (law, text, more, words) in [
        (
            "power",
            "speed,f\n1,1\n",
            &[][..],
            "m.csv:1: column `v` is missing",
        ),
        (
            "power",
            "v,f\n1,1\n\n-1,1\n",
            &[],
            "m.csv:4: the speed of steady sliding must be > 0",
        ),
        ("power", "v,f\n1,x\n", &[], "m.csv:2: f is `x`"),
        (
            "power",
            "v,f\n1,1\n2,1\n",
            &[],
            "2 points cannot determine 2 parameters",
        ),
        (
            "power",
            "v,f\n1,-1\n2,-1\n3,-1\n",
            &[],
            "friction must be positive",
        ),
        (
            "power",
            "v,f,sigma\n1,1,0\n",
            &[],
            "m.csv:2: the standard deviation must be > 0",
        ),
        (
            "lugre",
            "t,v,f\n0,1,1\n0,1,1\n",
            &[],
            "m.csv:3: times must rise",
        ),
        ("stribeck", "t,v,f\n0,1,1\n1,1,1\n", &[], "no memory"),
        (
            "rate-state",
            "t,v,f\n0,1,1\n1,-1,-1\n",
            &[],
            "m.csv:3: rate and state knows no way back",
        ),
        (
            "power",
            "v,f\n1,1\n2,1\n3,1\n",
            &["--fix", "beta=1"],
            "the parameters are gamma, alpha",
        ),
        (
            "power",
            "v,f\n1,1\n2,1\n3,1\n",
            &["--fix", "alpha=-1"],
            "> -1",
        ),
        (
            "power",
            "v,f\n1,1\n2,1\n3,1\n",
            &["--fix", "alpha"],
            "NAME=VALUE",
        ),
        (
            "power",
            "v,f,f\n1,1,2\n",
            &[],
            "m.csv:1: column `f` occurs twice",
        ),
        (
            "power",
            "v,f\n1,1\n2,1\n3,1\n",
            &["--fix", "alpha=0", "--fix", "alpha=1"],
            "`alpha` is given twice",
        ),
        (
            "power",
            "v,f\n1,1\n2,1\n3,1\n",
            &["--load", "1e300"],
            "in another unit",
        ),
        (
            "power",
            "v,f\n1,1\n",
            &["--starts", "1000000000"],
            "from 1 to 10000",
        ),
        ("power", "v,f\n1,1\n", &["--load", "0"], "> 0"),
        ("coulomb", "v,f\n1,1\n", &[], "stribeck"),
    ] {
        std::fs::write(&path, text)?;
        let out = folder.path().join("out");
        let mut arguments = vec![
            "--law",
            law,
            name.as_str(),
            "--out",
            out.to_str().ok_or("no text")?,
        ];
        arguments.extend(more);
        let (code, _, said) = fit(&arguments)?;
        assert_eq!(code, Some(2), "{text}: {said}");
        assert!(said.contains(words), "{words} not in {said}");
        assert!(!out.exists());
    }
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
        let name = path.to_str().ok_or("no text")?;
        let folder = out.to_str().ok_or("no text")?;
        let (code, told, said) = fit(&["--law", "power", name, "--load", load, "--out", folder])?;
        assert_eq!(code, Some(0), "{said}");
        assert!(
            !said.contains("panicked") && told.contains("16 of 16"),
            "{told}"
        );
        let [alpha, error] = parameter(&out, "alpha")?;
        assert!(
            (alpha - 0.5).abs() < 0.02 && error < 0.02,
            "{alpha} ± {error}"
        );
    }
    Ok(())
}
