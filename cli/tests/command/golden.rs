//! `tribos golden`: differences are named, and overrides are kept.

use crate::program::{Error, Outcome, tribos};
use std::path::{Path, PathBuf};

/// Exit codes.
const DONE: Option<i32> = Some(0);
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
