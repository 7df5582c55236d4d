//! Command line of the fronts.

use crate::front::Front;
use clap::Parser;
use std::path::PathBuf;

/// Speed against error: makes every front that the documentation shows, or some of them.
#[derive(Clone, Debug, PartialEq, Eq, Parser)]
#[command(after_help = "\
Instructions need qemu-system-arm and the targets thumbv7em-none-eabihf and thumbv6m-none-eabi of
rustup. Without QEMU the firmware front tells flash alone, and the kernel's columns say so.
The batch front counts instructions with Valgrind if it is installed (Debian: valgrind).
The atoms front runs LAMMPS beside ours if `lmp` is on the PATH (Debian: lammps).
The problems front runs Siconos beside ours if gcc and its library are installed (Debian: gcc,
libsiconos-numerics-dev).")]
pub struct Options {
    /// These fronts only: again, or NAME,NAME, for more of them
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    only: Vec<Front>,
    /// Few rounds and small problems: a look, not for publication
    #[arg(long)]
    pub quick: bool,
    /// Where tables and pictures go (docs/fronts; with --quick target/fronts)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Folder of contact problems for the problems front (those of the library's tests)
    #[arg(long, value_name = "DIR")]
    problems: Option<PathBuf>,
    /// Runs the items of the batch front once, for the count of their instructions
    #[arg(long, hide = true)]
    pub run_batch_items: bool,
}

impl Options {
    /// Fronts wanted, in the order of the index.
    pub fn fronts(&self) -> Vec<Front> {
        let wanted = |front: &Front| self.only.is_empty() || self.only.contains(front);
        Front::ALL.into_iter().filter(wanted).collect()
    }

    /// Folder for the results: a quick look does not replace what is published.
    pub fn out(&self) -> PathBuf {
        let folder = if self.quick {
            "target/fronts"
        } else {
            "docs/fronts"
        };
        let usual = || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(folder);
        self.out.clone().unwrap_or_else(usual)
    }

    /// Folder of contact problems.
    pub fn problems(&self) -> PathBuf {
        let usual = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../std-adapter/contacts/src/problem/file/samples"
        );
        self.problems.clone().unwrap_or_else(|| usual.into())
    }

    /// The command that makes the same, but for the folders.
    pub fn command(&self) -> String {
        let mut words = vec!["cargo run --profile dist -p tribos-benches --bin fronts".to_string()];
        if self.quick || !self.only.is_empty() || self.problems.is_some() {
            words.push("--".into());
        }
        if !self.only.is_empty() {
            let names: Vec<&str> = self.only.iter().map(|front| front.name()).collect();
            words.push(format!("--only {}", names.join(",")));
        }
        if self.quick {
            words.push("--quick".into());
        }
        if self.problems.is_some() {
            words.push("--problems DIR".into());
        }
        words.join(" ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(words: &[&str]) -> Result<Options, String> {
        let words = ["fronts"].iter().chain(words);
        Options::try_parse_from(words).map_err(|error| error.to_string())
    }

    #[test]
    fn options_are_read_or_refused_with_a_reason() {
        let some = read(&["--quick", "--out", "here", "--only", "firmware,kernel"]).unwrap();
        assert!(some.quick && some.out().ends_with("here"));
        assert_eq!(some.fronts(), [Front::Kernel, Front::Firmware]);
        assert!(read(&["--fast"]).unwrap_err().contains("--fast"));
        let unknown = read(&["--only", "wheels"]).unwrap_err();
        assert!(unknown.contains("wheels") && unknown.contains("contacts"));
    }

    #[test]
    fn a_quick_look_leaves_the_published_fronts_alone() {
        assert!(read(&[]).unwrap().out().ends_with("docs/fronts"));
        assert!(read(&["--quick"]).unwrap().out().ends_with("target/fronts"));
    }

    #[test]
    fn the_command_told_makes_the_same_fronts() {
        for words in [
            &["--only", "patches", "--quick"][..],
            &["--quick"],
            &["--problems", "here"],
            &[],
        ] {
            let options = read(words).unwrap();
            let told = options.command();
            let again: Vec<&str> = told.split(' ').skip_while(|&word| word != "--").collect();
            let again = read(again.get(1..).unwrap_or_default()).unwrap();
            assert_eq!(
                (again.fronts(), again.quick),
                (options.fronts(), options.quick)
            );
        }
    }
}
