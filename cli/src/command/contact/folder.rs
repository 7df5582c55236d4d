//! Folders for the results of contact problems.

use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::run::folder::{Contents, Manifest, OutputFolder};

/// Name of the command in its folders.
const SOLVE: &str = "contact";
/// What a problem leaves behind.
pub const OF_A_PROBLEM: [&str; 4] = [
    "summary.json",
    "reactions.csv",
    "convergence.svg",
    "convergence.png",
];

/// The folder of one problem.
pub fn of_a_problem(path: &Path) -> Result<OutputFolder, Failure> {
    begin(path, &Contents::of(SOLVE, &OF_A_PROBLEM))
}

/// The folder of several problems, which have a folder each in it.
pub fn of_several(path: &Path, names: &[String]) -> Result<OutputFolder, Failure> {
    let contents = Contents {
        about: Value::from(names),
        ..Contents::of(SOLVE, &[])
    };
    begin(path, &contents)
}

/// A folder without what an earlier command left there, folders of several problems included.
pub fn begin(path: &Path, contents: &Contents<'_>) -> Result<OutputFolder, Failure> {
    let earlier = Manifest::read(path)?.filter(|earlier| earlier.command == SOLVE);
    let folder = OutputFolder::begin(path, contents)?;
    let names = earlier.map_or(Value::Null, |earlier| earlier.about);
    for name in names
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
    {
        // A folder in this one, whatever the manifest says.
        if Path::new(name).file_name() != Some(name.as_ref()) {
            continue;
        }
        let inner = path.join(name);
        let is_ours = Manifest::read(&inner)?.is_some_and(|inner| inner.command == SOLVE);
        if is_ours {
            drop(OutputFolder::begin(&inner, &Contents::of(SOLVE, &[]))?);
            std::fs::remove_file(inner.join("tribos.json")).map_err(Failure::input)?;
            // What others put there stays.
            let _ = std::fs::remove_dir(&inner);
        }
    }
    Ok(folder)
}
