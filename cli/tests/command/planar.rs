//! `tribos run` of bodies that slide along a path in the plane.

use crate::program::{Error, Outcome, number, run, summary_of};

#[test]
fn the_cylinder_ends_where_the_table_says_and_leaves_complete_results() -> Outcome {
    let folder = tempfile::tempdir()?;
    let summary = summary_of("cylinder", folder.path(), &[])?;
    // tests/tables/tilted_cylinder.csv, "full", 5 rad/s.
    assert!((number(&summary, "stop_time") / 0.563_721_099_858_319_1 - 1.0).abs() < 1e-12);
    assert!((number(&summary, "x") / 0.265_924_351_225_834_87 - 1.0).abs() < 1e-12);
    assert!((number(&summary, "curl") / -0.014_632_310_204_878_707 - 1.0).abs() < 1e-12);
    assert!(number(&summary, "energy_error") < 1e-13);
    assert_eq!(summary["tipped"], false);
    assert_eq!(summary["scene"]["pressure_gradient"], "all-round");
    let series = std::fs::read_to_string(folder.path().join("series.csv"))?;
    assert!(series.starts_with("time,x,y,vx,vy,spin,angle,ratio,lean,"));
    assert!(series.lines().count() > 201);
    // Time goes on from line to line, and the last line is the rest.
    let times: Vec<f64> = series
        .lines()
        .skip(1)
        .map(|line| line.split(',').next().unwrap_or("").parse())
        .collect::<Result<_, _>>()?;
    assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(times.last().copied(), summary["stop_time"].as_f64());
    for plot in ["path.svg", "path.png"] {
        assert!(folder.path().join(plot).metadata()?.len() > 1000);
    }
    Ok(())
}

#[test]
fn the_other_gradient_is_the_thesis_own() -> Outcome {
    let folder = tempfile::tempdir()?;
    let summary = summary_of("cylinder", folder.path(), &["gradient=front-back"])?;
    assert!((number(&summary, "y") / -0.013_837_666_364_369_062 - 1.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn the_same_path_gives_the_same_bytes() -> Outcome {
    let (one, two) = (tempfile::tempdir()?, tempfile::tempdir()?);
    for folder in [&one, &two] {
        summary_of("curling-slow", folder.path(), &["model=film"])?;
    }
    for file in ["summary.json", "series.csv", "path.svg", "path.png"] {
        assert_eq!(
            std::fs::read(one.path().join(file))?,
            std::fs::read(two.path().join(file))?
        );
    }
    Ok(())
}

#[test]
fn pipes_bend_right_more_with_spin_and_height() -> Outcome {
    let folder = tempfile::tempdir()?;
    let curl = |scene, overrides: &[&str]| -> Result<f64, Error> {
        Ok(number(
            &summary_of(scene, folder.path(), overrides)?,
            "curl",
        ))
    };
    let [a, b] = [curl("pipe-a", &[])?, curl("pipe-b", &[])?];
    assert!(a < 0.0 && b < a, "{a} {b}");
    assert!(curl("pipe-a", &["spin=20"])? < 1.5 * a);
    assert!(curl("pipe-a", &["height=0.2"])? < 1.2 * a);
    assert_eq!(curl("pipe-a", &["spin=-10.2"])?, -a);
    Ok(())
}

#[test]
fn every_curling_model_runs_and_a_draw_stops_about_the_tee() -> Outcome {
    let folder = tempfile::tempdir()?;
    let plain = folder.path().join("plain.toml");
    std::fs::write(&plain, "body = \"curling\"\nspeed = 1.9866\nspin = 1.5\n")?;
    let draw = summary_of("curling-draw", folder.path(), &[])?;
    assert!((0.9..1.1).contains(&number(&draw, "curl")));
    for (model, range) in [
        ("dry", -0.02..-0.005),
        ("left-right", 0.0..1e-300),
        ("front-back", -0.02..-0.005),
        ("back-heavy", 0.2..0.5),
        ("film", 0.1..0.3),
        ("pivot-slide", 0.6..0.7),
        ("scratch-guide", 0.9..1.1),
    ] {
        let summary = summary_of("curling-draw", folder.path(), &[&format!("model={model}")])?;
        let curl = number(&summary, "curl");
        assert!(range.contains(&curl), "{model}: {curl}");
        assert!((number(&summary, "x") - 28.35).abs() < 0.1, "{model}");
        assert!(number(&summary, "energy_error") < 1e-8, "{model}");
    }
    Ok(())
}

#[test]
fn a_body_that_may_tip_is_held_at_the_edge_when_asked() -> Outcome {
    let folder = tempfile::tempdir()?;
    let summary = summary_of(
        "cylinder",
        folder.path(),
        &["height=0.4", "on_tipping=clamp"],
    )?;
    assert_eq!(summary["tipped"], true);
    assert!(number(&summary, "max_lean") > 1.0 && number(&summary, "tipped_at") < 0.1);
    Ok(())
}

#[test]
fn odd_numbers_end_with_a_result_or_a_reason() -> Outcome {
    let odd = [
        "0", "-1", "1e308", "-1e308", "5e-324", "1e-310", "1e-17", "1e17", "nan", "inf",
    ];
    let folder = tempfile::tempdir()?;
    for (scene, keys) in [
        (
            "cylinder",
            &["speed", "spin", "gamma", "radius", "height"][..],
        ),
        ("pipe-a", &["inner_radius", "alpha", "gravity"]),
        (
            "curling-draw",
            &[
                "spin",
                "alpha",
                "scratch_strength",
                "scratch_onset_angle",
                "inertia_ratio",
            ],
        ),
    ] {
        for key in keys {
            for value in odd {
                let item = format!("{key}={value}");
                let output = run(scene, folder.path(), &[&item, "samples=5"]).output()?;
                let message = String::from_utf8(output.stderr)?;
                assert!(!message.contains("panicked"), "{scene}, {item}: {message}");
                let code = output.status.code();
                assert!(
                    code == Some(0) || !message.is_empty() && matches!(code, Some(1 | 2)),
                    "{scene}, {item}: {code:?}"
                );
            }
        }
    }
    Ok(())
}
