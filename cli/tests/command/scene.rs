//! `tribos scene`: scenes that come with the program work anywhere, and editors get a schema.

use crate::program::{Outcome, succeed, tribos};
use serde_json::Value;

#[test]
fn scenes_are_run_by_name_anywhere() -> Outcome {
    let folder = tempfile::tempdir()?;
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/disk.toml");
    succeed(folder.path(), "run disk --out by-name")?;
    tribos(folder.path(), ["run", file, "--out", "by-file"])?;
    let summary = |out: &str| std::fs::read(folder.path().join(out).join("summary.json"));
    assert_eq!(summary("by-name")?, summary("by-file")?);
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
    Ok(())
}
