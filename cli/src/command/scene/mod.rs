//! `tribos scene`: the scenes that come with the program, their keys, and whether a file is right.

mod check;
mod keys;
mod list;
mod new;
mod source;

pub use keys::line as key_line;
pub use source::{built_in, note_earlier_names, read, text};

use crate::command::suggestions::unknown;
use crate::failure::Failure;
use std::path::PathBuf;
use tribos::record::write_atomically;
use tribos::scene::{Vocabulary, bodies, schema, vocabulary};

/// Scenes that come with the program: list and show them, start your own from one, check a file, and
/// write a schema for editors.
///
/// Every command that takes a scene file also takes one of these names.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    action: Action,
}

/// What to do.
#[derive(Debug, clap::Subcommand)]
enum Action {
    /// Name, body and time of every scene that comes with the program.
    #[command(after_long_help = EXAMPLES)]
    List,
    /// Print a scene.
    #[command(after_long_help = EXAMPLES)]
    Show {
        /// Its name, as `tribos scene list` has it.
        name: String,
    },
    /// Read scenes as `tribos run` does: the values in force, or everything that is wrong.
    Check(check::Check),
    /// The keys of a body: unit, meaning, default, what each may be.
    Keys(keys::Keys),
    /// What the runs of a body leave in their summaries: unit, meaning, column of a sweep.
    Results(keys::Results),
    /// Start a scene of your own: a commented file with every key.
    New(new::New),
    /// JSON Schema of scenes, with which editors complete and check them.
    Schema(Schema),
}

/// The schema of all scenes, or of those of one body.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
struct Schema {
    /// A body such as powder; all if left out.
    body: Option<String>,
    /// File for it; printed if left out.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  tribos scene list
  tribos scene show compaction-small
  tribos run compaction-small --out out/powder
  tribos scene new compaction-small --out mine.toml
  tribos scene new tip --out tip.toml
  tribos scene check mine.toml --set mu_rolling=0.3
  tribos scene keys powder
  tribos scene results disk
  tribos scene schema --out tribos-scene.json
With `#:schema ./tribos-scene.json` as its first line editors that know taplo check a scene as it
is written.";

impl Arguments {
    /// Does it.
    pub fn execute(self) -> Result<(), Failure> {
        match self.action {
            Action::List => super::print(&list::text()),
            Action::Show { name } => super::print(source::named(&name)?.text),
            Action::Check(check) => check.execute(),
            Action::Keys(keys) => keys.execute(),
            Action::Results(results) => results.execute(),
            Action::New(new) => new.execute(),
            Action::Schema(schema) => schema.execute(),
        }
    }
}

impl Schema {
    fn execute(self) -> Result<(), Failure> {
        let known = self.body.as_deref().map(body).transpose()?;
        let text = format!("{:#}\n", schema(known.as_ref()));
        match self.out {
            None => super::print(&text),
            Some(path) => {
                write_atomically(&path, text.as_bytes())?;
                super::print(&format!("written to    {}\n", path.display()))
            }
        }
    }
}

/// The vocabulary of a body, or which bodies there are.
fn body(name: &str) -> Result<Vocabulary, Failure> {
    vocabulary(name)
        .ok_or_else(|| Failure::input(unknown(&format!("`{name}` is no body"), name, bodies())))
}
