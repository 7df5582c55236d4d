//! `tribos run` leaves complete, repeatable results.

use crate::program::{Error, Outcome, number, scene, succeed, summary, summary_of};
use serde_json::Value;

#[test]
fn the_disk_stops_where_an_independent_solution_says() -> Outcome {
    let folder = tempfile::tempdir()?;
    let summary = summary_of("disk", folder.path(), &[])?;
    // 20-digit quadratures in mpmath, tests/tables/stops.csv, over mu g = 2.943 m/s².
    assert!((number(&summary, "stop_time") / 0.369_017_132_104_518_4 - 1.0).abs() < 1e-12);
    assert!((number(&summary, "distance") / 0.176_861_185_300_854_5 - 1.0).abs() < 1e-12);
    assert!((number(&summary, "final_ratio") - 0.653_001_789_205_597_6).abs() < 1e-12);
    assert!(number(&summary, "energy_error") < 1e-12);
    assert_eq!(number(&summary, "steps"), 200.0);
    assert_eq!(summary["ending"], "rest");
    let series = std::fs::read_to_string(folder.path().join("series.csv"))?;
    assert!(series.starts_with("time,speed,spin,distance,angle,ratio,"));
    assert_eq!(series.lines().count(), 202);
    // Both speeds vanish in the last line and not before.
    let lines: Vec<&str> = series.lines().collect();
    assert!(lines[201].contains(",0.0,0.0,"));
    assert!(!lines[200].contains(",0.0,"));
    for plot in ["motion.svg", "motion.png"] {
        assert!(folder.path().join(plot).metadata()?.len() > 1000);
    }
    Ok(())
}

#[test]
fn the_same_scene_gives_the_same_bytes() -> Outcome {
    let (one, two) = (tempfile::tempdir()?, tempfile::tempdir()?);
    for folder in [&one, &two] {
        summary_of("disk", folder.path(), &["alpha=0.25", "spin=-12"])?;
    }
    for file in ["summary.json", "series.csv", "motion.svg", "motion.png"] {
        assert_eq!(
            std::fs::read(one.path().join(file))?,
            std::fs::read(two.path().join(file))?
        );
    }
    Ok(())
}

#[test]
fn verlet_tends_to_the_exact_motion() -> Outcome {
    let folder = tempfile::tempdir()?;
    let exact = number(&summary_of("disk", folder.path(), &[])?, "distance");
    let error = |step: &str| -> Result<f64, Error> {
        let step = format!("time_step={step}");
        Ok((number(
            &summary_of("disk", folder.path(), &["integrator=verlet", &step])?,
            "distance",
        ) / exact
            - 1.0)
            .abs())
    };
    // The stop itself is met to first order only.
    let (coarse, fine) = (error("1e-3")?, error("1e-4")?);
    assert!(coarse < 1e-6 && fine < coarse / 9.0, "{coarse} {fine}");
    Ok(())
}

#[test]
fn a_dimensionless_scene_is_the_scaled_dimensional_one() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scene = folder.path().join("scene.toml");
    // v* = v/√(gR), ω* = ω√(R/g) of the disk scene.
    let scale = (9.81_f64 * 0.08).sqrt();
    let text = format!(
        "units = \"dimensionless\"\nspeed = {:?}\nspin = {:?}\ngamma = 0.3\nalpha = 0\ninertia_ratio = 0.5\n",
        1.0 / scale,
        5.0 * (0.08_f64 / 9.81).sqrt()
    );
    std::fs::write(&scene, text)?;
    let out = folder.path().join("out");
    succeed(folder.path(), "run scene.toml --out out")?;
    let summary = summary(&out)?;
    let dimensional = summary_of("disk", &folder.path().join("si"), &[])?;
    let time = number(&summary, "stop_time") * (0.08_f64 / 9.81).sqrt();
    assert!((time / number(&dimensional, "stop_time") - 1.0).abs() < 1e-12);
    let distance = number(&summary, "distance") * 0.08;
    assert!((distance / number(&dimensional, "distance") - 1.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn linear_and_steeper_laws_fade_without_rest() -> Outcome {
    let folder = tempfile::tempdir()?;
    for alpha in ["alpha=1", "alpha=3"] {
        let summary = summary_of("disk", folder.path(), &[alpha])?;
        assert_eq!(summary["ending"], "faded");
        assert_eq!(summary["stop_time"], Value::Null);
        assert!(number(&summary, "energy_error") < 1e-10);
    }
    let summary = summary_of("disk", folder.path(), &["alpha=3", "duration=2"])?;
    assert_eq!(summary["ending"], "duration");
    assert_eq!(number(&summary, "end_time"), 2.0);
    Ok(())
}

#[test]
fn keys_by_earlier_names_are_read_noted_and_written_by_the_present_ones() -> Outcome {
    let folder = tempfile::tempdir()?;
    let scene = scene("disk");
    let run = format!("run {scene} --quiet --set coefficient=0.2 --out out");
    let [_, said] = succeed(folder.path(), run)?;
    let note = format!("warning: {scene}: `coefficient` is called `gamma` now\n");
    assert_eq!(said.matches(&note).count(), 1, "{said}");
    let summary = summary(&folder.path().join("out"))?;
    assert_eq!(number(&summary, "/scene/gamma"), 0.2);
    assert!(summary["scene"]["coefficient"].is_null());
    let sweep = format!("sweep {scene} --set coefficient=0.2,0.3 --out swept");
    let [_, said] = succeed(folder.path(), sweep)?;
    assert_eq!(said.matches(&note).count(), 1, "{said}");
    let table = std::fs::read_to_string(folder.path().join("swept/sweep.csv"))?;
    assert!(table.starts_with("gamma,"), "{table}");
    Ok(())
}
