//! `tribos golden`: results pinned and checked, every kind of difference told apart.

use crate::program::{Error, Outcome, assert_has, tribos};
use std::path::{Path, PathBuf};

/// Exit codes.
const DONE: Option<i32> = Some(0);
const BAD_INPUT: Option<i32> = Some(2);
const MISMATCH: Option<i32> = Some(3);

const DISK: &str = "speed = 1.0\nspin = 5.0\ngamma = 0.3\nalpha = 0.0\ngravity = 9.81\n\
                    radius = 0.08\nmass = 0.1\ninertia_ratio = 0.5\n";
const ROCK: &str = "body = \"curling\"\nmodel = \"scratch-guide\"\nspeed = 0.16\nspin = 20.0\n";
const POWDER: &str = "body = \"powder\"\nwidth = 6\nheight = 8\npressure = 0.02\nmax_steps = 60\n";

/// A folder with scenes in `in/` and their golden file.
fn pinned() -> Result<tempfile::TempDir, Error> {
    let folder = tempfile::tempdir()?;
    let scenes = folder.path().join("in");
    std::fs::create_dir(&scenes)?;
    for (name, text) in [("disk", DISK), ("rock", ROCK), ("powder", POWDER)] {
        std::fs::write(scenes.join(format!("{name}.toml")), text)?;
    }
    let write = "golden write in/disk.toml in/rock.toml in/powder.toml --out out/golden.toml";
    let (code, said, err) = tribos(folder.path(), write)?;
    assert_eq!(code, DONE, "{err}");
    assert!(said.contains("written to out/golden.toml"), "{said}");
    Ok(folder)
}

/// Replaces a text of a file, which must be there.
fn edit(file: PathBuf, from: &str, to: &str) -> Outcome {
    let text = std::fs::read_to_string(&file)?;
    assert!(text.contains(from), "{from}");
    std::fs::write(file, text.replacen(from, to, 1))?;
    Ok(())
}

/// The hexadecimal digits of the first number after `mark`, and the same with another last digit.
fn digits(file: &Path, mark: &str) -> Result<[String; 2], Error> {
    let text = std::fs::read_to_string(file)?;
    let after = text.split_once(mark).ok_or("no such mark")?.1;
    let from = after.find("\"0x").ok_or("no number")? + 1;
    let was = &after[from..from + 18];
    let last = if was.ends_with('0') { '1' } else { '0' };
    Ok([was.into(), format!("{}{last}", &was[..17])])
}

const VERIFY: [&str; 3] = ["golden", "verify", "out/golden.toml"];

#[test]
fn what_was_pinned_is_found_again_and_the_file_has_the_same_bytes() -> Outcome {
    let folder = pinned()?;
    let file = folder.path().join("out/golden.toml");
    let first = std::fs::read(&file)?;
    let (code, said, err) = tribos(folder.path(), VERIFY)?;
    assert_eq!(code, DONE, "{said}{err}");
    assert_eq!(said.lines().count(), 3);
    assert_has(
        &said,
        &[
            "../in/disk.toml: same, 201 rows",
            "../in/rock.toml: same",
            "../in/powder.toml: same",
        ],
    );
    let write = "golden write in/disk.toml in/rock.toml in/powder.toml --out out/golden.toml";
    tribos(folder.path(), write)?;
    assert_eq!(std::fs::read(&file)?, first);
    Ok(())
}

#[test]
fn a_changed_scene_is_told_from_changed_results() -> Outcome {
    let folder = pinned()?;
    edit(
        folder.path().join("in/powder.toml"),
        "width",
        "seed = 2\nwidth",
    )?;
    edit(
        folder.path().join("in/disk.toml"),
        "spin = 5.0",
        "spin = 5.5",
    )?;
    let (code, said, err) = tribos(folder.path(), VERIFY)?;
    assert_eq!(code, BAD_INPUT, "{said}");
    assert!(said.contains("disk.toml: the scene has changed"), "{said}");
    assert!(said.contains("`spin` is 0x4016000000000000 (5.5), pinned 0x4014000000000000 (5.0)"));
    assert!(said.contains("`seed` is 0x4000000000000000 (2.0), pinned"));
    assert!(said.contains("rock.toml: same"));
    assert!(err.contains("2 of 3 scenes"), "{err}");
    // Comments and the order of keys are no part of a scene.
    edit(folder.path().join("in/rock.toml"), "body", "# a rock\nbody")?;
    let only = ["--only", "../in/rock.toml"];
    assert_eq!(
        tribos(folder.path(), [&VERIFY[..], &only].concat())?.0,
        DONE
    );
    Ok(())
}

#[test]
fn a_changed_result_is_named() -> Outcome {
    let folder = pinned()?;
    let file = folder.path().join("out/golden.toml");
    let [was, is] = digits(&file, "\"distance\"")?;
    edit(file.clone(), &was, &is)?;
    let (code, said, err) = tribos(folder.path(), VERIFY)?;
    assert_eq!(code, MISMATCH, "{said}");
    let words = format!("disk.toml: summary \"distance\" is {was} (0.17686118530085");
    assert!(said.contains(&words), "{said}");
    assert!(
        said.contains(&format!("pinned {is} (0.17686118530085")),
        "{said}"
    );
    assert!(
        err.contains("1 of 3 scenes are not as in out/golden.toml"),
        "{err}"
    );

    // The series says when, the powder's state what.
    let [was, is] = digits(&file, "\"spin\" = [\n")?;
    edit(file.clone(), &was, &is)?;
    let [was, is] = digits(&file, "[scene.state]")?;
    edit(file, &was, &is)?;
    let (code, said, _) = tribos(folder.path(), VERIFY)?;
    assert_eq!(code, MISMATCH, "{said}");
    assert!(
        said.contains("series column \"spin\" differs first in rows 0..12 (time 0.0000 to 0.0"),
        "{said}"
    );
    assert!(
        said.contains("powder.toml: final state: contacts differ"),
        "{said}"
    );
    Ok(())
}

#[test]
fn overrides_are_kept_with_the_scene() -> Outcome {
    let folder = pinned()?;
    let write = "golden write in/disk.toml --set spin=50 --set integrator=verlet --out fast.toml";
    assert_eq!(tribos(folder.path(), write)?.0, DONE);
    let (code, said, _) = tribos(folder.path(), "golden verify fast.toml")?;
    assert_eq!(code, DONE);
    let scene = "in/disk.toml spin=50 integrator=verlet: same";
    assert!(said.starts_with(scene), "{said}");
    let text = std::fs::read_to_string(folder.path().join("fast.toml"))?;
    assert!(
        text.contains("set = [\"spin=50\", \"integrator=verlet\"]"),
        "{text}"
    );
    Ok(())
}

#[test]
fn what_cannot_be_checked_is_refused_with_its_reason() -> Outcome {
    let folder = pinned()?;
    let file = folder.path().join("out/golden.toml");
    let good = std::fs::read_to_string(&file)?;
    let damages = [
        (
            "format = 1",
            "format = 7",
            "format 7 of golden files is not known, only 1",
        ),
        (
            "format = 1",
            "fromat = 1",
            "golden.toml:1: `format` is missing",
        ),
        ("format = 1", "format", "not TOML"),
        ("block_rows = 13", "block_rows = 0", "a whole number from 1"),
        ("block_rows = 13", "block_rows = 12", "must have 17 digests"),
        ("rows = 201", "rows = \"x\"", "a whole number from 1"),
        ("[scene.summary]", "[scene.summery]", "`summary` is missing"),
        ("scene_digest = \"0x", "scene_digest = \"1x", "hexadecimal"),
    ];
    for (from, to, words) in damages {
        edit(file.clone(), from, to)?;
        let (code, _, err) = tribos(folder.path(), VERIFY)?;
        assert_eq!(code, BAD_INPUT, "{to}");
        assert!(err.contains(words), "{to}: {err}");
        std::fs::write(&file, &good)?;
    }
    // A parameter edited in the golden file.
    let [was, is] = digits(&file, "\"gravity\"")?;
    edit(file.clone(), &was, &is)?;
    let (code, _, err) = tribos(folder.path(), VERIFY)?;
    assert_eq!(code, BAD_INPUT);
    assert!(
        err.contains("`scene_digest` is not that of the parameters"),
        "{err}"
    );
    std::fs::write(&file, &good)?;

    std::fs::remove_file(folder.path().join("in/rock.toml"))?;
    let (code, said, _) = tribos(folder.path(), VERIFY)?;
    assert_eq!(code, BAD_INPUT);
    assert!(said.contains("rock.toml: cannot read the scene"), "{said}");
    assert!(said.contains("powder.toml: same"), "{said}");
    let cases: [(&[&str], &str); 4] = [
        (&["golden", "verify", "none.toml"], "cannot read none.toml"),
        (
            &["golden", "verify", "out/golden.toml", "--only", "x"],
            "its scenes are ../in/disk.toml",
        ),
        (
            &["golden", "write", "in/none.toml", "--out", "new.toml"],
            "cannot read the scene",
        ),
        (
            &["golden", "write", "in/disk.toml", "--out", "in/disk.toml"],
            "name another file",
        ),
    ];
    for (arguments, words) in cases {
        let (code, _, err) = tribos(folder.path(), arguments)?;
        assert_eq!(code, BAD_INPUT, "{arguments:?}");
        assert!(err.contains(words), "{err}");
    }
    assert!(!folder.path().join("new.toml").exists());
    Ok(())
}

#[test]
fn pins_with_other_settings_are_added_and_renewed() -> Outcome {
    let folder = pinned()?;
    let file = folder.path().join("out/golden.toml");
    let once = std::fs::read(&file)?;
    let append = "golden write in/disk.toml --set spin=9 --append --out out/golden.toml";
    for _ in 0..2 {
        let (code, said, err) = tribos(folder.path(), append)?;
        assert_eq!(code, DONE, "{err}");
        assert_has(&said, &["../in/disk.toml spin=9: 201 rows"]);
    }
    let (code, said, err) = tribos(folder.path(), VERIFY)?;
    assert_eq!(code, DONE, "{said}{err}");
    assert_eq!(said.lines().count(), 4);
    assert_has(
        &said,
        &["../in/disk.toml: same", "../in/disk.toml spin=9: same"],
    );

    // A file that is no golden file is not added to, and stays.
    std::fs::write(&file, &once[..once.len() / 2])?;
    let (code, _, err) = tribos(folder.path(), append)?;
    assert_eq!(code, BAD_INPUT, "{err}");
    assert_eq!(std::fs::read(&file)?, once[..once.len() / 2]);

    // A new file is begun.
    let begin = "golden write in/disk.toml --set spin=9 --append --out out/new.toml";
    let (code, _, err) = tribos(folder.path(), begin)?;
    assert_eq!(code, DONE, "{err}");
    Ok(())
}
