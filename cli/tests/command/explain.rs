//! `tribos explain` says what a scene carries, and after a run what it could have left out.

use crate::program::{Error, Outcome, succeed, told};

#[test]
fn shares_of_the_energy_add_up() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scene = "body = \"powder\"\nwidth = 8\nheight = 12\npressure = 0.01\npiston_mass = 100\n";
    std::fs::write(folder.path().join("tiny.toml"), scene)?;
    // So small a threshold of torsion takes next to nothing.
    let scene = "tiny.toml --set mu_torsion=1e-6 --out out";
    succeed(folder.path(), format!("run {scene}"))?;
    let [told, _] = succeed(folder.path(), format!("explain {scene}"))?;
    // Shares of what was exchanged add up, those that gave energy counted alike.
    let shares = told
        .lines()
        .filter_map(|line| line.split_once(" %"))
        .filter_map(|(head, _)| {
            let name = head.split_whitespace().next()?;
            let parts = ["normal", "sliding", "rolling", "torsion", "cohesion"];
            let number: f64 = head.split_whitespace().last()?.parse().ok()?;
            (parts.contains(&name) && head.split_whitespace().count() == 2).then_some(number.abs())
        });
    let total: f64 = shares.sum();
    assert!((total - 100.0).abs() < 0.3, "{total}: {told}");
    assert!(!told.contains("sliding dissipated"), "{told}");
    Ok(())
}

#[test]
fn the_reading_of_a_tips_drive_is_told_with_the_force_that_it_means() -> Outcome {
    let force = |reading: &str| -> Result<f64, Error> {
        let small = "--set substrate_layers=4 --set tip_layers=4";
        let told = told(format!(
            "explain tip-reversible --set reading={reading} {small}"
        ))?;
        let (_, rest) = told.split_once("up to ").ok_or("no force")?;
        Ok(rest.split(' ').next().ok_or("no number")?.parse()?)
    };
    let [angular, mean, largest] = [force("angular")?, force("mean")?, force("largest")?];
    // The outermost atom stands farthest out: lambda itself acts on it under `largest`.
    assert!(
        largest < mean && mean < angular,
        "{angular} {mean} {largest}"
    );
    assert!((1.2..3.0).contains(&(mean / largest)) && angular / largest > 3.0);
    Ok(())
}
