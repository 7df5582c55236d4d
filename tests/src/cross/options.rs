//! The command line of `cross`.

use super::platforms::PLATFORMS;
use std::path::PathBuf;

/// Computes the digests of the kernel's bits on every platform that can be built for and emulated
/// here, compares them with tests/subjects/digests.txt and prints one table.
#[derive(Clone, Debug, clap::Parser)]
pub struct Options {
    /// This row only; may be repeated
    #[arg(long, value_name = "NAME", value_parser = PLATFORMS.map(|platform| platform.name))]
    pub only: Vec<String>,
    /// The table as Markdown
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Longest time for one program to run
    #[arg(long, value_name = "SECONDS", default_value_t = 1200)]
    pub limit: u64,
    /// Instructions are not counted, which lets the emulators run faster
    #[arg(long)]
    pub quick: bool,
    /// A promised row whose tools are missing is a failure, not a warning
    #[arg(long)]
    pub require_all: bool,
}

impl Options {
    /// True if the row is asked for.
    pub fn wants(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|only| only == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    fn read(line: &str) -> Result<Options, clap::Error> {
        Options::try_parse_from(["cross"].into_iter().chain(line.split_whitespace()))
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
