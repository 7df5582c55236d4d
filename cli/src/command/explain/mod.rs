//! `tribos explain`: which laws, modes and unknowns a scene carries, and what they cost.

pub mod after;
pub mod gas;
pub mod grains;
pub mod packing;
pub mod patience;
pub mod powder;
pub mod slide;
pub mod tip;

use super::{bodies, scene};
use crate::failure::Failure;
use std::path::PathBuf;

/// Show which laws, modes and unknowns a scene uses and what they cost, so that it models only what it
/// needs. Costs are measured on this machine, in a fraction of a second.
///
/// The energy balance follows, with the parts that could be left out: for a sliding body at once, where
/// it runs in a moment, else the time that the run takes; for powders, grains, gases and tips with --out DIR of a finished run.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// The scene: a TOML file, or a name that `tribos scene list` has.
    scene: PathBuf,
    /// Replace or add a key of the scene, or leave one out (`KEY=`); may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Folder of a finished run of this scene, for its energy balance.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  tribos explain compaction-small
  tribos explain compaction-small --set mu_rolling=0.1 --set mu_torsion=0.1 --set coupling=exact
  tribos explain tip-reversible --set cutoff=3
  tribos explain cylinder --set pressure=hertz
  tribos run compaction-small --set mu_torsion=0.1 --out out/powder
  tribos explain compaction-small --set mu_torsion=0.1 --out out/powder
  tribos run tip-reversible --set drive_time=200 --out out/tip
  tribos explain tip-reversible --set drive_time=200 --out out/tip";

impl Arguments {
    /// Prints.
    pub fn execute(self) -> Result<(), Failure> {
        let read = scene::read(&self.scene, &self.overrides)?;
        let body = bodies::of(&read);
        let out = self.out.as_deref();
        let command = out.map(|out| self.command(out)).unwrap_or_default();
        let after = body.account(out, &command)?;
        let text = body.explanation()?;
        let gap = if after.is_empty() { "" } else { "\n" };
        super::print(&(text + gap + &after))
    }

    /// The command that runs the scene beside `out`, to be completed by one more override.
    fn command(&self, out: &std::path::Path) -> String {
        let sets: String = self
            .overrides
            .iter()
            .map(|item| format!(" --set {item}"))
            .collect();
        format!(
            "tribos run {}{sets} --out {}-less",
            self.scene.display(),
            out.display()
        )
    }
}

/// A line with a head in the first column.
fn line(head: &str, text: impl AsRef<str>) -> String {
    format!("{head:<14}{}\n", text.as_ref())
}

/// Lines of heads and texts.
pub fn lines(parts: &[(&str, String)]) -> String {
    parts.iter().map(|(head, text)| line(head, text)).collect()
}

/// A time in words.
fn duration(seconds: f64) -> String {
    const MINUTE: f64 = 60.0;
    const HOUR: f64 = 3600.0;
    if seconds < 1.0 {
        "less than a second".into()
    } else if seconds < 2.0 * MINUTE {
        format!("about {seconds:.0} s")
    } else if seconds < 2.0 * HOUR {
        format!("about {:.0} min", seconds / MINUTE)
    } else {
        format!("about {:.1} h", seconds / HOUR)
    }
}

/// A number of bytes in words.
fn bytes(count: usize) -> String {
    const KILO: f64 = 1000.0;
    let count = count as f64;
    if count < KILO * KILO {
        format!("{:.0} kB", count / KILO)
    } else {
        format!("{:.1} MB", count / (KILO * KILO))
    }
}
