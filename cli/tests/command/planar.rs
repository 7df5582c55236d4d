//! `tribos run` of bodies that slide along a path in the plane.

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Runs a scene that ships with the project, or any other file.
fn run(scene: &str, out: &Path, overrides: &[&str]) -> Result<Value, Box<dyn std::error::Error>> {
    let path = format!("{}/../scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut command = Command::cargo_bin("tribos")?;
    command.args(["run", &path, "--out"]).arg(out);
    for item in overrides {
        command.args(["--set", item]);
    }
    let output = command.output()?;
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    Ok(serde_json::from_str(&std::fs::read_to_string(
        out.join("summary.json"),
    )?)?)
}

/// What a bad scene is answered with; nothing may have been written.
fn refusal(
    text: &str,
    overrides: &[&str],
) -> Result<(Option<i32>, String), Box<dyn std::error::Error>> {
    let folder = tempfile::tempdir()?;
    let (scene, out) = (folder.path().join("scene.toml"), folder.path().join("out"));
    std::fs::write(&scene, text)?;
    let mut command = Command::cargo_bin("tribos")?;
    command.arg("run").arg(&scene).arg("--out").arg(&out);
    for item in overrides {
        command.args(["--set", item]);
    }
    let output = command.output()?;
    assert!(!out.exists(), "work was done before the refusal");
    Ok((output.status.code(), String::from_utf8(output.stderr)?))
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or(f64::NAN)
}

#[test]
fn the_cylinder_ends_where_the_table_says_and_leaves_complete_results() -> Outcome {
    let folder = tempfile::tempdir()?;
    let summary = run("cylinder", folder.path(), &[])?;
    // tests/tables/tilted_cylinder.csv, "full", 5 rad/s.
    assert!((number(&summary, "stop_time") / 0.563_721_099_858_319_1 - 1.0).abs() < 1e-12);
    assert!((number(&summary, "x") / 0.265_924_351_225_834_87 - 1.0).abs() < 1e-12);
    assert!((number(&summary, "curl") / -0.014_632_310_204_878_707 - 1.0).abs() < 1e-12);
    assert!(number(&summary, "energy_error") < 1e-13);
    assert_eq!(summary["tipped"], false);
    assert_eq!(summary["scene"]["gradient"], "all-round");
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
    let summary = run("cylinder", folder.path(), &["gradient=front-back"])?;
    assert!((number(&summary, "y") / -0.013_837_666_364_369_062 - 1.0).abs() < 1e-12);
    Ok(())
}

#[test]
fn the_same_path_gives_the_same_bytes() -> Outcome {
    let (one, two) = (tempfile::tempdir()?, tempfile::tempdir()?);
    for folder in [&one, &two] {
        run("curling-slow", folder.path(), &["model=film"])?;
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
    let curl = |scene, overrides: &[&str]| -> Result<f64, Box<dyn std::error::Error>> {
        Ok(number(&run(scene, folder.path(), overrides)?, "curl"))
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
    let draw = run("curling-draw", folder.path(), &[])?;
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
        let summary = run("curling-draw", folder.path(), &[&format!("model={model}")])?;
        let curl = number(&summary, "curl");
        assert!(range.contains(&curl), "{model}: {curl}");
        assert!((number(&summary, "x") - 28.35).abs() < 0.1, "{model}");
        assert!(number(&summary, "energy_error") < 1e-8, "{model}");
    }
    Ok(())
}

#[test]
fn bad_scenes_are_refused_with_their_line_and_cure() -> Outcome {
    const PIPE: &str = "body = \"pipe\"\nspeed = 1.7\nspin = 10\ncoefficient = 0.2\n\
                        gravity = 9.81\nradius = 0.05\ninner_radius = 0.046\nheight = 0.15\n\
                        mass = 0.5\n";
    const DRAW: &str = "body = \"curling\"\nspeed = 2.0\nspin = 1.5\n";
    for (text, old, new, place, words) in [
        (
            PIPE,
            "\"pipe\"",
            "\"tube\"",
            "scene.toml:1",
            "one of \"disk\", \"cylinder\"",
        ),
        (PIPE, "\"pipe\"", "3", "scene.toml:1", "not a number"),
        (
            PIPE,
            "0.046",
            "0.06",
            "scene.toml:7",
            "must not exceed `radius`",
        ),
        (PIPE, "mass = 0.5\n", "", "scene.toml:", "`mass` is missing"),
        (
            PIPE,
            "inner_radius",
            "inner_radios",
            "scene.toml:7",
            "did you mean `inner_radius`?",
        ),
        (PIPE, "height = 0.15", "height = -1", "scene.toml:8", ">= 0"),
        // A disk's key, not a pipe's.
        (
            PIPE,
            "mass = 0.5",
            "mass = 0.5\nstepper = \"exact\"",
            "scene.toml:10",
            "unknown key",
        ),
        (
            PIPE,
            "height = 0.15",
            "height = 1.5",
            "error",
            "tipping = \"clamp\"",
        ),
        (
            DRAW,
            "spin = 1.5",
            "model = \"magic\"\nspin = 1",
            "scene.toml:3",
            "\"scratch-guide\"",
        ),
        (
            DRAW,
            "spin = 1.5",
            "spin = 1\npivot = 0.1",
            "scene.toml:4",
            "is for model \"pivot-slide\"",
        ),
        (
            DRAW,
            "spin = 1.5",
            "spin = 1\nmodel = \"dry\"\nalpha = -0.5",
            "scene.toml:5",
            "`alpha` is 0",
        ),
        (
            DRAW,
            "spin = 1.5",
            "spin = 1\nband_width = 1",
            "scene.toml:4",
            "`band_width` must not",
        ),
        (
            DRAW,
            "spin = 1.5",
            "spin = 1\nmodel = \"film\"\nfilm_back = 2",
            "scene.toml:5",
            "from 0 to 1",
        ),
        (
            DRAW,
            "spin = 1.5",
            "spin = 1\nalpha = 1",
            "scene.toml:4",
            "<= 0.9",
        ),
        (
            DRAW,
            "speed = 2.0\nspin = 1.5",
            "speed = 0\nspin = 0",
            "scene.toml:2",
            "nothing moves",
        ),
    ] {
        let (code, message) = refusal(&text.replacen(old, new, 1), &[])?;
        assert_eq!(code, Some(2), "{new}: {message}");
        assert!(
            message.contains(place) && message.contains(words),
            "{new}: {message}"
        );
    }
    Ok(())
}

#[test]
fn all_problems_of_a_body_are_told_at_once() -> Outcome {
    let text = "body = \"cylinder\"\nspeed = nan\nheight = -1\nradius = 0.1\n";
    let (code, message) = refusal(text, &["mass=0", "pressure=square"])?;
    assert_eq!(code, Some(2));
    for words in [
        "scene.toml:2: `speed`",
        "scene.toml:3: `height`",
        "--set: `mass`",
        "--set: `pressure` must be one of",
        "`coefficient` is missing",
        "`spin` is missing",
        "`gravity` is missing",
    ] {
        assert!(message.contains(words), "{words}: {message}");
    }
    Ok(())
}

#[test]
fn a_body_that_may_tip_is_held_at_the_edge_when_asked() -> Outcome {
    let folder = tempfile::tempdir()?;
    let summary = run("cylinder", folder.path(), &["height=0.4", "tipping=clamp"])?;
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
    let scenes = format!("{}/../scenes", env!("CARGO_MANIFEST_DIR"));
    for (scene, keys) in [
        (
            "cylinder",
            &["speed", "spin", "coefficient", "radius", "height"][..],
        ),
        ("pipe-a", &["inner_radius", "alpha", "gravity"]),
        (
            "curling-draw",
            &["spin", "alpha", "scratch", "scratch_onset", "inertia_ratio"],
        ),
    ] {
        for key in keys {
            for value in odd {
                let item = format!("{key}={value}");
                let output = Command::cargo_bin("tribos")?
                    .args(["run", &format!("{scenes}/{scene}.toml"), "--set", &item])
                    .args(["--set", "samples=5", "--out"])
                    .arg(folder.path())
                    .output()?;
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
