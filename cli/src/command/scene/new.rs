//! `tribos scene new`.

use super::source;
use crate::command::suggestions::unknown;
use crate::failure::Failure;
use std::path::PathBuf;
use tribos::record::write_atomically;
use tribos::scene::{bodies, library_scene, template, vocabulary, with_all_keys};

/// Writes a scene of your own: a copy of one that comes with the program, or an example of a body,
/// with a commented line for every key that it leaves out. Never replaces a file.
#[derive(Debug, clap::Args)]
#[command(after_long_help = super::EXAMPLES)]
pub struct New {
    /// Name of a scene as `tribos scene list` has it, or a body such as powder or tip.
    #[arg(value_name = "NAME|BODY")]
    from: String,
    /// The file [default: NAME.toml].
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl New {
    /// Writes.
    pub fn execute(self) -> Result<(), Failure> {
        let text = text(&self.from)?;
        let path = self
            .out
            .unwrap_or_else(|| format!("{}.toml", self.from).into());
        if path.symlink_metadata().is_ok() {
            return Err(Failure::input(format!(
                "{} exists already; name another file with --out",
                path.display()
            )));
        }
        write_atomically(&path, text.as_bytes())?;
        crate::command::print(&format!(
            "written to    {0}; run it with `tribos run {0} --out DIR`\n",
            path.display()
        ))
    }
}

fn text(from: &str) -> Result<String, Failure> {
    let copy = library_scene(from).map(|scene| with_all_keys(scene.text));
    let example = || vocabulary(from).map(|known| template(&known));
    copy.or_else(example).ok_or_else(|| {
        let known = source::all().chain(bodies());
        Failure::input(unknown(
            &format!("`{from}` is neither a scene nor a body"),
            from,
            known,
        ))
    })
}
