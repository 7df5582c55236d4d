//! `tribos scene`: scenes that come with the program work anywhere, and files are judged as by
//! `tribos run`.

use crate::program::{Outcome, tribos};
use serde_json::Value;

#[test]
fn scenes_are_listed_shown_and_run_by_name_anywhere() -> Outcome {
    let folder = tempfile::tempdir()?;
    let (code, list, _) = tribos(folder.path(), "scene list")?;
    assert_eq!(code, Some(0));
    assert!(list.contains("compaction-4193") && list.contains("a moment"));
    let (_, text, _) = tribos(folder.path(), "scene show disk")?;
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/disk.toml");
    assert_eq!(text, std::fs::read_to_string(file)?);

    let (code, _, said) = tribos(folder.path(), "run disk --out by-name")?;
    assert_eq!(code, Some(0), "{said}");
    tribos(folder.path(), ["run", file, "--out", "by-file"])?;
    let summary = |out: &str| std::fs::read(folder.path().join(out).join("summary.json"));
    assert_eq!(summary("by-name")?, summary("by-file")?);

    let (code, _, said) = tribos(folder.path(), "run dsk --out out")?;
    assert_eq!(code, Some(2));
    assert!(said.contains("`dsk`; did you mean `disk`?"), "{said}");
    // A file of that name comes first.
    std::fs::write(folder.path().join("disk"), "speed = -1\n")?;
    let (_, _, said) = tribos(folder.path(), "scene check disk")?;
    assert!(said.contains("disk:1: `speed` must be"), "{said}");
    Ok(())
}

#[test]
fn a_new_scene_is_right_and_nothing_is_overwritten() -> Outcome {
    let folder = tempfile::tempdir()?;
    for from in ["disk", "pipe", "powder", "tip", "compaction-small"] {
        let name = format!("{from}.toml");
        let (code, _, said) = tribos(folder.path(), ["scene", "new", from])?;
        assert_eq!(code, Some(0), "{said}");
        let (code, told, _) = tribos(folder.path(), ["scene", "check", &name])?;
        assert_eq!(code, Some(0));
        assert!(told.starts_with(&format!("{name}: OK")), "{told}");
    }
    let before = std::fs::read(folder.path().join("tip.toml"))?;
    let (code, _, said) = tribos(
        folder.path(),
        ["scene", "new", "powder", "--out", "tip.toml"],
    )?;
    assert!(code == Some(2) && said.contains("exists already"), "{said}");
    assert_eq!(std::fs::read(folder.path().join("tip.toml"))?, before);
    let (code, _, said) = tribos(folder.path(), "scene new brick")?;
    assert!(code == Some(2) && said.contains("powder"), "{said}");
    Ok(())
}

#[test]
fn every_file_is_checked_also_after_a_wrong_one() -> Outcome {
    let folder = tempfile::tempdir()?;
    std::fs::write(
        folder.path().join("bad.toml"),
        "body = \"tip\"\nlamda = 1\n",
    )?;
    let (code, told, said) = tribos(folder.path(), "scene check bad.toml disk")?;
    assert_eq!(code, Some(2));
    assert!(said.contains("bad.toml:2: unknown key `lamda`; did you mean `lambda`?"));
    assert!(said.contains("`lambda` is missing"));
    assert!(told.contains("disk: OK") && told.contains("inertia_ratio      = 0.5"));
    let (code, told, _) = tribos(folder.path(), ["scene", "check", "disk", "--set", "spin=7"])?;
    assert!(
        code == Some(0) && told.contains("spin               = 7.0"),
        "{told}"
    );
    Ok(())
}

#[test]
fn the_schema_is_json_with_a_branch_for_each_body() -> Outcome {
    let folder = tempfile::tempdir()?;
    let (_, text, _) = tribos(folder.path(), "scene schema")?;
    let schema: Value = serde_json::from_str(&text)?;
    let branches = schema["oneOf"].as_array().map_or(0, Vec::len);
    assert_eq!(branches, tribos::scene::bodies().count());
    let (_, _, _) = tribos(
        folder.path(),
        ["scene", "schema", "tip", "--out", "tip.json"],
    )?;
    let tip: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.path().join("tip.json"))?)?;
    assert_eq!(tip["properties"]["load"]["type"], "number");
    let (code, _, said) = tribos(folder.path(), "scene schema brick")?;
    assert!(
        code == Some(2) && said.contains("there are disk, cylinder"),
        "{said}"
    );
    Ok(())
}
