//! `tribos deposit` leaves complete, repeatable results.

use crate::program::{Error, Outcome, number, succeed, summary};
use std::path::Path;

/// A deposit in the folder: what was told.
fn deposit(out: &Path, arguments: &str) -> Result<String, Error> {
    let [told, _] = succeed(".", format!("deposit {arguments} --out {}", out.display()))?;
    Ok(told)
}

#[test]
fn the_small_system_is_grown_and_told() -> Outcome {
    let folder = tempfile::tempdir()?;
    let told = deposit(folder.path(), "--cut 61.5")?;
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
    for (folder, seed) in [(&one, 5), (&two, 5), (&other, 6)] {
        let count = "--count 300 --spread 0.3 --capture-radius 4";
        deposit(folder.path(), &format!("{count} --seed {seed}"))?;
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
    deposit(folder.path(), "--height 80 --porosity-curve")?;
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
    for seed in 1..=5 {
        let single = tempfile::tempdir()?;
        deposit(single.path(), &format!("--height 80 --seed {seed}"))?;
        mean += number(&summary(single.path())?, "porosity") / 5.0;
    }
    assert!((three[2] - mean).abs() < 1e-14);
    for plot in ["porosity.svg", "porosity.png"] {
        assert!(folder.path().join(plot).metadata()?.len() > 1000);
    }
    Ok(())
}
