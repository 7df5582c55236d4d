//! The command line of `cross`.

use super::platforms::PLATFORMS;
use std::path::PathBuf;

/// What `--help` prints.
pub const HELP: &str = "\
Computes the digests of the kernel's bits on every platform that can be built for and emulated
here, compares them with tests/digest/digests.txt and prints one table.

usage: cargo run -p tribos-tests --bin cross -- [options]

  --only NAME      this row only; may be repeated
  --out FILE       the table as Markdown
  --limit SECONDS  longest time for one program to run (default: 1200)
  --require-all    a promised row whose tools are missing is a failure, not a warning
  --help           this

Rows: ";

/// Longest run of one program in seconds, if nothing else is asked for.
const LIMIT: u64 = 1200;

/// What was asked for.
#[derive(Clone, Debug)]
pub struct Options {
    /// Names of rows; none means all.
    pub only: Vec<String>,
    /// Where the table goes besides the screen.
    pub out: Option<PathBuf>,
    /// Longest run of one program in seconds.
    pub limit: u64,
    /// What a missing tool counts as.
    pub missing: Missing,
    /// Whether only the help is wanted.
    pub help: bool,
}

/// What a row counts as whose tools are missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// The run may still succeed.
    Warning,
    /// It may not.
    Failure,
}

impl Options {
    /// Reads the arguments after the program's name.
    ///
    /// # Errors
    /// A message for an unknown flag, a missing value or a row that does not exist.
    pub fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self {
            only: Vec::new(),
            out: None,
            limit: LIMIT,
            missing: Missing::Warning,
            help: false,
        };
        while let Some(argument) = arguments.next() {
            let mut value = || {
                let next = arguments.next();
                next.ok_or(format!("{argument} needs a value; see --help"))
            };
            match argument.as_str() {
                "--only" => options.only.push(known(value()?)?),
                "--out" => options.out = Some(value()?.into()),
                "--limit" => {
                    let given = value()?;
                    let wrong = |_| format!("--limit {given}: not a number of seconds");
                    options.limit = given.parse().map_err(wrong)?;
                }
                "--require-all" => options.missing = Missing::Failure,
                "--help" | "-h" => options.help = true,
                other => return Err(format!("unknown argument {other}; see --help")),
            }
        }
        Ok(options)
    }

    /// True if the row is asked for.
    pub fn wants(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|only| only == name)
    }
}

/// The names of all rows.
pub fn names() -> String {
    PLATFORMS.map(|platform| platform.name).join(", ")
}

fn known(name: String) -> Result<String, String> {
    if PLATFORMS.iter().any(|platform| platform.name == name) {
        return Ok(name);
    }
    Err(format!("--only {name}: no such row; there are {}", names()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(line: &str) -> Result<Options, String> {
        Options::read(line.split_whitespace().map(String::from))
    }

    #[test]
    fn what_is_not_known_is_refused() {
        let options = read("--only aarch64 --only i686 --limit 9").unwrap();
        assert!(options.wants("i686") && !options.wants("wasm32"));
        assert_eq!(options.limit, 9);
        for wrong in ["--only m68k", "--limit soon", "--out", "--fast", "i686"] {
            read(wrong).unwrap_err();
        }
    }
}
