//! `tribos deposit` leaves complete, repeatable results.

use crate::program::{Error, Outcome, number, summary};
use assert_cmd::Command;
use std::path::Path;

fn deposit(out: &Path, arguments: &[&str]) -> Result<Command, Error> {
    let mut command = Command::cargo_bin("tribos")?;
    command.arg("deposit").args(arguments).arg("--out").arg(out);
    Ok(command)
}

#[test]
fn the_small_system_is_grown_and_told() -> Outcome {
    let folder = tempfile::tempdir()?;
    let output = deposit(folder.path(), &["--cut", "61.5"])?.output()?;
    assert!(output.status.success());
    let summary = summary(folder.path())?;
    let particles = number(&summary, "particles");
    // 470 in the thesis; single deposits scatter by 6 %.
    assert!((390.0..550.0).contains(&particles), "{particles}");
    assert_eq!(
        number(&summary, "contacts") + number(&summary, "on_substrate"),
        particles
    );
    let porosity = number(&summary, "porosity");
    assert!((porosity - 0.92).abs() < 0.02, "{porosity}");
    let height = number(&summary, "height");
    assert!((60.5..=61.5).contains(&height), "{height}");
    // Porosity, spheres and height belong together.
    let solid = particles * 4.0 / 3.0 * std::f64::consts::PI / (400.0 * height);
    assert!((1.0 - solid - porosity).abs() < 1e-12);
    let told = String::from_utf8(output.stdout)?;
    assert!(told.contains(&format!("particles      {particles}\n")));
    let line = told.lines().find(|line| line.starts_with("porosity "));
    let percent = line.and_then(|line| line.split_whitespace().nth(1));
    let percent: f64 = percent.ok_or("no porosity")?.parse()?;
    assert!((percent - 100.0 * porosity).abs() < 5e-5, "{told}");
    let xyz = std::fs::read_to_string(folder.path().join("deposit.xyz"))?;
    assert!(xyz.starts_with(&format!("{particles}\nLattice=")));
    assert_eq!(xyz.lines().count() as f64, particles + 2.0);
    for (file, piece) in [
        ("deposit.vtp", format!("NumberOfVerts=\"{particles}\"")),
        ("contacts.vtp", format!("NumberOfLines=\"{particles}\"")),
    ] {
        let text = std::fs::read_to_string(folder.path().join(file))?;
        assert!(text.contains(&piece), "{file}");
    }
    Ok(())
}

#[test]
fn the_same_seed_gives_the_same_bytes() -> Outcome {
    let (one, two, other) = (
        tempfile::tempdir()?,
        tempfile::tempdir()?,
        tempfile::tempdir()?,
    );
    let count = ["--count", "300", "--spread", "0.3", "--capture-radius", "4"];
    for (folder, seed) in [(&one, "5"), (&two, "5"), (&other, "6")] {
        let mut arguments = count.to_vec();
        arguments.extend(["--seed", seed]);
        deposit(folder.path(), &arguments)?.assert().success();
    }
    for file in ["deposit.xyz", "deposit.vtp", "contacts.vtp", "summary.json"] {
        let bytes = std::fs::read(one.path().join(file))?;
        assert_eq!(bytes, std::fs::read(two.path().join(file))?);
        assert_ne!(bytes, std::fs::read(other.path().join(file))?);
    }
    assert_eq!(number(&summary(one.path())?, "particles"), 300.0);
    Ok(())
}

#[test]
fn the_porosity_curve_has_means_and_deviations() -> Outcome {
    let folder = tempfile::tempdir()?;
    deposit(folder.path(), &["--height", "80", "--porosity-curve"])?
        .assert()
        .success();
    let csv = std::fs::read_to_string(folder.path().join("porosity.csv"))?;
    let mut lines = csv.lines();
    assert_eq!(
        lines.next(),
        Some(
            "inv_capture_radius,capture_radius,porosity,porosity_std,bulk_porosity,\
             bulk_porosity_std,particles,particles_std"
        )
    );
    let rows: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(str::parse).collect::<Result<_, _>>())
        .collect::<Result<_, _>>()?;
    assert_eq!(rows.len(), 10);
    for (row, next) in rows.iter().zip(&rows[1..]) {
        assert!(row[0] < next[0] && row[2] > next[2] && row[6] < next[6]);
    }
    for row in &rows {
        assert_eq!(row[0], 1.0 / row[1]);
        assert!(row[3] > 0.0 && row[3] < 0.02 && row[5] > 0.0 && row[7] > 0.0);
    }
    // A point is what five single deposits give.
    let three = rows.iter().find(|row| row[1] == 3.0).ok_or("no 3R")?;
    let mut mean = 0.0;
    for seed in ["1", "2", "3", "4", "5"] {
        let single = tempfile::tempdir()?;
        deposit(single.path(), &["--height", "80", "--seed", seed])?
            .assert()
            .success();
        mean += number(&summary(single.path())?, "porosity") / 5.0;
    }
    assert!((three[2] - mean).abs() < 1e-14);
    for plot in ["porosity.svg", "porosity.png"] {
        assert!(folder.path().join(plot).metadata()?.len() > 1000);
    }
    Ok(())
}

#[test]
fn impossible_deposits_are_refused_before_any_file() -> Outcome {
    let cases: &[(&[&str], &str)] = &[
        (&[], "--height"),
        (&["--cut", "1.5"], "above a diameter"),
        (&["--cut", "9", "--height", "9"], "cannot be used with"),
        (&["--height", "60", "--count", "10"], "cannot be used with"),
        (&["--height", "-1"], "> 0"),
        (&["--height", "nan"], "finite"),
        (&["--count", "0"], "one sphere or more"),
        (&["--count", "99999999999"], "more than 20000000"),
        (&["--count", "9", "--width", "5"], "must be twice that"),
        (&["--count", "9", "--capture-radius", "1.5"], "at least 2"),
        (&["--count", "9", "--spread", "1"], "less than 1"),
        (
            &["--height", "60", "--porosity-curve", "--width", "19"],
            "twice",
        ),
        (
            &[
                "--height",
                "60",
                "--porosity-curve",
                "--capture-radius",
                "3",
            ],
            "cannot be used with",
        ),
    ];
    for (arguments, words) in cases {
        let folder = tempfile::tempdir()?;
        let out = folder.path().join("out");
        let output = deposit(&out, arguments)?.output()?;
        let said = String::from_utf8(output.stderr)?;
        assert_eq!(output.status.code(), Some(2), "{arguments:?} {said}");
        assert!(said.contains(words), "{arguments:?} {said}");
        assert!(!out.exists(), "{arguments:?}");
    }
    Ok(())
}
