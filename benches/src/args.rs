//! Command line of the fronts.

use crate::fronts::Front;
use std::path::PathBuf;

/// Shown for `--help`.
pub const HELP: &str = "\
Speed against error: makes every front that the documentation shows, or some of them.

Usage: cargo run --release -p tribos-benches --bin fronts -- [OPTIONS]

  --only NAME   this front alone; again, or NAME,NAME, for more of them:
                  kernel       force and torque: tiers, precisions, targets, and what else there is
                  patches      every patch, law and tier
                  integrators  a disk brought to rest: step, order, error, cost
                  contacts     contacts of packings: updates, residual against work, size
                  atoms        molecular dynamics: speed, conserved energy against the step
                  firmware     flash, stack and instructions of each item; budgets
  --quick       few rounds and small problems: a look, not for publication
  --out DIR     where tables and pictures go (docs/fronts; with --quick target/fronts)
  --help        this text

Instructions need qemu-system-arm and the targets thumbv7em-none-eabihf and thumbv6m-none-eabi of
rustup. Without QEMU the firmware front tells flash alone, and the kernel's columns say so.
The atoms front runs LAMMPS beside ours if `lmp` is on the PATH (Debian: lammps).
";

/// Options: what to make, where, and how long to measure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Folder for the results.
    pub out: PathBuf,
    /// Whether to take few rounds: for a quick check, not for publication.
    pub quick: bool,
    /// Fronts wanted, in the order of the index.
    pub fronts: Vec<Front>,
}

/// Request of the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Request {
    /// The help text.
    Help,
    /// Fronts.
    Fronts(Options),
}

impl Request {
    /// Reads `[--only NAME]… [--quick] [--out DIR] [--help]`.
    pub fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let (mut out, mut quick, mut wanted) = (None, false, Vec::new());
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--help" | "-h" => return Ok(Self::Help),
                "--quick" => quick = true,
                "--out" => out = Some(arguments.next().ok_or("--out needs a folder after it")?),
                "--only" => {
                    let names = arguments.next().ok_or("--only needs a front after it")?;
                    for name in names.split(',') {
                        wanted.push(Front::named(name)?);
                    }
                }
                other => {
                    return Err(format!(
                        "unknown argument {other}; known: --only NAME, --quick, --out DIR, --help"
                    ));
                }
            }
        }
        let is_wanted = |front: &Front| wanted.is_empty() || wanted.contains(front);
        Ok(Self::Fronts(Options {
            out: out.map_or_else(|| default_folder(quick), PathBuf::from),
            quick,
            fronts: Front::ALL.into_iter().filter(is_wanted).collect(),
        }))
    }
}

impl Options {
    /// The command that reproduces the results, except for the folder.
    pub fn command(&self) -> String {
        let mut words = vec!["cargo run --release -p tribos-benches --bin fronts".to_string()];
        if self.quick || self.fronts.len() < Front::ALL.len() {
            words.push("--".into());
        }
        if self.fronts.len() < Front::ALL.len() {
            let names: Vec<&str> = self.fronts.iter().map(|front| front.name()).collect();
            words.push(format!("--only {}", names.join(",")));
        }
        if self.quick {
            words.push("--quick".into());
        }
        words.join(" ")
    }
}

/// A quick run does not replace published results.
fn default_folder(quick: bool) -> PathBuf {
    let root = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    root.join(if quick {
        "target/fronts"
    } else {
        "docs/fronts"
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(words: &[&str]) -> Result<Request, String> {
        Request::read(words.iter().map(ToString::to_string))
    }

    fn options(words: &[&str]) -> Options {
        match read(words).unwrap() {
            Request::Fronts(options) => options,
            Request::Help => panic!("help for {words:?}"),
        }
    }

    #[test]
    fn options_are_read_or_refused_with_a_reason() {
        let some = options(&["--quick", "--out", "here", "--only", "firmware,kernel"]);
        assert!(some.quick && some.out.ends_with("here"));
        assert_eq!(some.fronts, [Front::Kernel, Front::Firmware]);
        assert!(read(&["--out"]).unwrap_err().contains("folder"));
        assert!(read(&["--fast"]).unwrap_err().contains("--fast"));
        let unknown = read(&["--only", "wheels"]).unwrap_err();
        assert!(unknown.contains("wheels") && unknown.contains("contacts"));
        assert_eq!(read(&["--help"]), Ok(Request::Help));
    }

    #[test]
    fn a_quick_look_leaves_the_published_fronts_alone() {
        assert!(options(&[]).out.ends_with("docs/fronts"));
        assert!(options(&["--quick"]).out.ends_with("target/fronts"));
    }

    #[test]
    fn the_command_told_makes_the_same_fronts() {
        for words in [&["--only", "patches", "--quick"][..], &["--quick"], &[]] {
            let told = options(words).command();
            let again: Vec<&str> = told.split(' ').skip_while(|&word| word != "--").collect();
            assert_eq!(options(again.get(1..).unwrap_or_default()), options(words));
        }
    }
}
