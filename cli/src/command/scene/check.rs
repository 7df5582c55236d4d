//! `tribos scene check`.

use super::source;
use crate::failure::Failure;
use serde_json::Value;
use std::path::PathBuf;
use tribos::scene::{Scene, toml_value};

/// Reads scenes as `tribos run` does and prints the values in force; or everything that is wrong,
/// with file and line and what would be valid. Exit code 2 if anything is.
#[derive(Debug, clap::Args)]
#[command(after_long_help = super::EXAMPLES)]
pub struct Check {
    /// Scenes: files, or names as `tribos scene list` has them.
    #[arg(required = true, value_name = "FILE")]
    scenes: Vec<PathBuf>,
    /// Replace or add a key of the scenes; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl Check {
    /// Reads all, also after one that is wrong.
    pub fn execute(self) -> Result<(), Failure> {
        let mut wrong = Vec::new();
        for path in &self.scenes {
            match source::read(path, &self.overrides) {
                Ok(scene) => {
                    let values = resolved(&scene);
                    crate::command::print(&format!("{}: OK\n{values}", path.display()))?;
                }
                // Problems of overrides do not name the file themselves.
                Err(failure) if self.scenes.len() > 1 => {
                    wrong.push(format!("{}:\n{failure}", path.display()));
                }
                Err(failure) => wrong.push(failure.to_string()),
            }
        }
        if wrong.is_empty() {
            Ok(())
        } else {
            Err(Failure::Input(wrong.join("\n")))
        }
    }
}

/// Every key with the value in force and its unit.
fn resolved(scene: &Scene) -> String {
    let values = scene.json();
    let mut text = String::new();
    for key in scene.as_body().keys() {
        let value = match values.get(key.name) {
            Some(value) => toml_value(key, value).unwrap_or_else(|| off(value)),
            None if key.name == "body" => format!("\"{}\"", scene.body()),
            // A key of another model than the chosen one.
            None => continue,
        };
        let unit = match key.unit {
            "-" => String::new(),
            unit => format!("# {unit}"),
        };
        let line = format!("  {:<18} = {value:<16} {unit}", key.name);
        text += line.trim_end();
        text.push('\n');
    }
    text
}

fn off(value: &Value) -> String {
    if value.is_null() {
        "not set".into()
    } else {
        value.to_string()
    }
}
