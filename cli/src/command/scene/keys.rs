//! `tribos scene keys` and `tribos scene results`.

use super::source;
use crate::command::suggestions::unknown;
use crate::failure::Failure;
use serde_json::Value;
use tribos::results::{Quantity, entries};
use tribos::scene::{Key, Vocabulary, bodies, library_scene, toml_value, vocabulary};

/// The keys of a body's scenes with unit, meaning, default and what each may be; without one, which
/// bodies there are.
#[derive(Debug, clap::Args)]
#[command(after_long_help = super::EXAMPLES)]
pub struct Keys {
    /// A body such as disk or powder, or a scene of it as `tribos scene list` has it.
    #[arg(value_name = "BODY")]
    of: Option<String>,
}

impl Keys {
    /// Prints.
    pub fn execute(self) -> Result<(), Failure> {
        let text = match &self.of {
            Some(word) => text(&of(word)?),
            None => all(),
        };
        crate::command::print(&text)
    }
}

/// The entries of the summaries of a body's runs with unit and meaning, and the columns that a sweep has of them.
#[derive(Debug, clap::Args)]
#[command(after_long_help = super::EXAMPLES)]
pub struct Results {
    /// A body such as disk or gas, or a scene of it as `tribos scene list` has it.
    #[arg(value_name = "BODY")]
    of: String,
}

impl Results {
    /// Prints.
    pub fn execute(self) -> Result<(), Failure> {
        let known = of(&self.of)?;
        let mut text = format!(
            "Entries of the summary of a run with body = \"{}\":\n",
            known.body
        );
        for (path, entry) in entries(known.results) {
            text += &result(&path.join("."), entry);
        }
        crate::command::print(&text)
    }
}

fn result(name: &str, entry: &Quantity) -> String {
    let column = entry.column();
    let column = column.map_or(String::new(), |name| format!(" Sweep: `{name}`."));
    format!("  {name:<24} [{}] {}{column}\n", entry.unit, entry.meaning)
}

/// The vocabulary that a word asks for.
fn of(word: &str) -> Result<Vocabulary, Failure> {
    let body = library_scene(word).map_or(word, |scene| scene.body());
    vocabulary(body).ok_or_else(|| {
        let known = bodies().chain(source::all());
        Failure::input(unknown(&format!("`{word}` is no body"), word, known))
    })
}

/// A line a body.
fn all() -> String {
    let mut text = String::from("Bodies, the value of the key `body`:\n");
    for known in bodies().filter_map(vocabulary) {
        let needed: Vec<&str> = known.least().iter().map(|(name, _)| *name).collect();
        text += &format!(
            "  {:<9} {:>2} keys; needs {}\n",
            known.body,
            known.keys.len(),
            needed.join(", ")
        );
    }
    text + "`tribos scene keys BODY` lists them, `tribos scene new BODY` starts a file with all of them.\n"
}

/// A line a key.
fn text(known: &Vocabulary) -> String {
    let mut text = format!("Keys of a scene with body = \"{}\":\n", known.body);
    let defaults = known.defaults();
    for key in known.keys {
        text += &line(key, defaults.get(key.name));
    }
    text
}

/// Name, unit, meaning and, as a sentence of its own, what the key may be.
pub fn line(key: &Key, default: Option<&Value>) -> String {
    let default = default.and_then(|value| toml_value(key, value));
    let default = default.map_or(String::new(), |value| format!("; default {value}"));
    let domain = key.domain.describe();
    let mut letters = domain.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let domain: String = first.chain(letters).collect();
    format!(
        "  {:<18} [{}] {} {domain}{default}\n",
        key.name, key.unit, key.meaning
    )
}
