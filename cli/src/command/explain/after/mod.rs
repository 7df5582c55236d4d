//! Where the energy of a run went, and what could have been left out.

mod gas;
mod packing;
mod slide;
mod tip;

pub use gas::text as gas;
pub use packing::text as packing;
pub use slide::motion;
pub use tip::text as tip;

use crate::failure::Failure;
use serde_json::Value;
use std::path::Path;
use tribos::record::read_text;
use tribos::scene::{Key, with_present_names};

/// Bytes of a summary at most.
const MOST_BYTES: u64 = 64 << 20;

/// The summary of a finished run of the scene that these keys of `here` describe.
pub fn summary(out: &Path, keys: &[Key], here: &Value) -> Result<Value, Failure> {
    let path = out.join("summary.json");
    let text = read_text(&path, MOST_BYTES).map_err(|cause| {
        Failure::input(format!(
            "cannot read {}: {cause}; give the --out of a finished `tribos run`",
            path.display()
        ))
    })?;
    let summary: Value = serde_json::from_str(&text).map_err(|cause| {
        Failure::input(format!("{}: {cause}; run the scene again", path.display()))
    })?;
    let there = with_present_names(&summary["scene"]);
    same_scene(keys, here, &there, out)?;
    Ok(summary)
}

/// A budget of another scene would be no answer.
fn same_scene(keys: &[Key], here: &Value, there: &Value, out: &Path) -> Result<(), Failure> {
    let differs = |name: &&str| here.get(name).map(plain) != there.get(name).map(plain);
    match keys.iter().map(|key| key.name).find(|name| differs(name)) {
        None => Ok(()),
        Some(name) => Err(Failure::input(format!(
            "{} is of another scene: `{name}` is {} there, {} here; give the same scene and --set",
            out.display(),
            there.get(name).map_or("not set".into(), plain),
            here.get(name).map_or("not set".into(), plain)
        ))),
    }
}

/// A value without the digits that only bits need.
fn plain(value: &Value) -> String {
    match value.as_f64() {
        Some(x) => x.to_string(),
        None if value.is_null() => "not set".into(),
        None => value.to_string(),
    }
}

/// A number of a summary, NaN where it is missing.
fn number(summary: &Value, place: &str) -> f64 {
    let value = summary.pointer(place).and_then(Value::as_f64);
    value.unwrap_or(f64::NAN)
}
