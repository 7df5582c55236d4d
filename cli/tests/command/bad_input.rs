//! Bad input ends with exit code 2 and a message that names the place and the cure.

use crate::program::{Outcome, assert_has, assert_refused_scenes, refusal, refused};
use assert_cmd::Command;

const GOOD: &str = "speed = 1.0\nspin = 5.0\ngamma = 0.3\nalpha = 0.0\ngravity = 9.81\n\
                    radius = 0.08\nmass = 0.1\ninertia_ratio = 0.5\n";

#[test]
fn every_kind_of_bad_scene_is_refused_with_its_line_and_cure() -> Outcome {
    let cases = r#"
        mass = 0.1 | mass = -1 | scene.toml:7 | `mass` must be a finite number > 0, not -1
        mass = 0.1 | mass = 0 | scene.toml:7 | > 0
        speed = 1.0 | speed = nan | scene.toml:1 | `speed` must be a finite number >= 0, not NaN
        spin = 5.0 | spin = -inf | scene.toml:2 | `spin` must be a finite number
        radius = 0.08 | radius = "big" | scene.toml:6 | got "big"
        alpha = 0.0 | alpha = -1 | scene.toml:4 | > -1 and <= 128
        alpha = 0.0 | alpha = [0] | scene.toml:4 | not an array
        gravity = 9.81\n |  | scene.toml: | `gravity` is missing
        gravity | gravitiy | scene.toml:5 | did you mean `gravity`?
        gravity | colour | scene.toml:5 | the keys are body, speed, spin,
        mass = 0.1 | mass 0.1 | scene.toml:7 | not TOML
        mass = 0.1 | mass = 0.1\nmass = 0.2 | scene.toml:8 | duplicate
        mass = 0.1 | mass = 1e999 | scene.toml:7 | `mass` must be
    "#;
    assert_refused_scenes(GOOD, cases)
}

#[test]
fn overrides_are_checked_like_the_file() -> Outcome {
    for (item, words) in [
        ("mass=-1", "`mass` must be"),
        ("nonsense", "not of the form key=value"),
        ("=3", "not of the form key=value"),
        ("integrator=leapfrog", "one of \"exact\", \"verlet\""),
        ("units=cgs", "one of \"si\", \"dimensionless\""),
        ("samples=2.5", "a whole number"),
        ("time_step=1e-300", "use at least"),
        ("speed=0 ", "nothing moves"),
    ] {
        let more: &[&str] = if words == "nothing moves" {
            &[item, "spin=0"]
        } else {
            &[item]
        };
        let (code, message) = refusal(GOOD.as_bytes(), more)?;
        assert_eq!(code, Some(2), "{item}: {message}");
        assert!(message.contains(words), "{item}: {message}");
    }
    Ok(())
}

#[test]
fn all_problems_are_told_at_once() -> Outcome {
    let text = GOOD
        .replace("mass = 0.1", "mass = -1")
        .replace("speed = 1.0\n", "");
    let (_, message) = refusal(text.as_bytes(), &["alpha=nan"])?;
    assert_has(&message, &["`mass`", "`speed` is missing", "`alpha`"]);
    Ok(())
}

#[test]
fn scenes_that_are_not_text_or_not_there_are_refused() -> Outcome {
    let (code, message) = refusal([0xff, 0xfe, 0x00], &[])?;
    assert_eq!(code, Some(2), "{message}");
    assert!(refused(".", ["run", "/nowhere.toml", "--out", "x"])?.contains("/nowhere.toml"));
    Ok(())
}

#[test]
fn bad_arguments_of_wrench_are_refused() -> Outcome {
    let twist = ["--speed", "1", "--spin", "1"];
    for (bad, words) in [
        (vec!["--alpha", "-1"], "> -1 and <= 128"),
        (vec!["--alpha", "nan"], "finite"),
        (vec!["--load", "-1"], ">= 0"),
        (vec!["--radius", "0"], "> 0"),
        (vec!["--coefficient", "inf"], "finite"),
        (vec!["--alpha", "11", "--tier", "table"], "--tier compact"),
        (
            vec!["--load", "1e300", "--precision", "f32"],
            "--precision f64",
        ),
        (vec!["--tier", "perfect"], "table, compact, quadrature"),
        (vec!["--twists", "x.csv"], "cannot be used with"),
    ] {
        let arguments = [&["wrench"][..], &twist, &bad].concat();
        let message = refused(".", &arguments)?;
        assert!(message.contains(words), "{bad:?}: {message}");
    }
    Ok(())
}

#[test]
fn bad_files_of_twists_are_refused_with_their_line() -> Outcome {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("twists.csv");
    for (text, words) in [
        ("", "column `speed` is missing"),
        ("speed,spin\n", "no rows"),
        ("speed\n1\n", "1: column `spin` is missing"),
        ("speed,spin,load\n1,2,3\n", "unknown column `load`"),
        (
            "speed,spin,speed\n1,2,3\n",
            ":1: column `speed` occurs twice",
        ),
        ("speed,spin\n1,2\n3\n", ":3: 1 columns instead of 2"),
        ("speed,spin\n1,2\n\n1,x\n", ":4: spin is `x`"),
        ("speed,spin\n1,nan\n", ":2: spin is `nan`"),
        ("speed,spin\n1,\n", ":2: spin is ``"),
    ] {
        std::fs::write(&path, text)?;
        let output = Command::cargo_bin("tribos")?
            .args(["wrench", "--twists"])
            .arg(&path)
            .output()?;
        let message = String::from_utf8(output.stderr)?;
        assert_eq!(output.status.code(), Some(2), "{text:?}: {message}");
        assert!(message.contains(words), "{text:?}: {message}");
    }
    Ok(())
}

#[test]
fn pure_spin_without_inertia_and_diagram_endings_are_refused() -> Outcome {
    let folder = tempfile::tempdir()?;
    let out = folder.path().display().to_string();
    let diagram = format!("{out}/diagram.pdf");
    for (arguments, words) in [
        (vec!["modes", "--alpha", "0", "--inertia-ratio", "0"], "> 0"),
        (
            vec![
                "modes",
                "--alpha",
                "0",
                "--inertia-ratio",
                "1",
                "--diagram",
                &diagram,
            ],
            "end the name in .svg, .png or .csv",
        ),
    ] {
        let message = refused(".", &arguments)?;
        assert!(message.contains(words), "{arguments:?}: {message}");
    }
    Ok(())
}

#[test]
fn a_folder_that_cannot_be_made_is_a_failed_run() -> Outcome {
    let folder = tempfile::tempdir()?;
    let (scene, blocked) = (folder.path().join("scene.toml"), folder.path().join("file"));
    std::fs::write(&scene, GOOD)?;
    std::fs::write(&blocked, "")?;
    let output = Command::cargo_bin("tribos")?
        .arg("run")
        .arg(&scene)
        .arg("--out")
        .arg(blocked.join("x"))
        .output()?;
    assert_eq!(output.status.code(), Some(1));
    Ok(())
}
