//! The two options that the front programs share.

use std::path::PathBuf;

/// Where results go and how long to measure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// Folder for the results.
    pub out: PathBuf,
    /// Few rounds: for a look, not for publication.
    pub quick: bool,
}

impl Options {
    /// Reads `[--out DIR] [--quick]`; DIR is `docs/front` of the project if not given.
    pub fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/front");
        let mut options = Self {
            out: PathBuf::from(root),
            quick: false,
        };
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--quick" => options.quick = true,
                "--out" => {
                    let folder = arguments.next();
                    options.out = folder.ok_or("--out needs a folder after it")?.into();
                }
                other => {
                    return Err(format!(
                        "unknown argument {other}; known: --out DIR, --quick"
                    ));
                }
            }
        }
        Ok(options)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(words: &[&str]) -> Result<Options, String> {
        Options::read(words.iter().map(ToString::to_string))
    }

    #[test]
    fn options_are_read_or_refused_with_a_reason() {
        let options = read(&["--quick", "--out", "here"]).unwrap();
        assert!(options.quick && options.out.ends_with("here"));
        assert!(read(&["--out"]).unwrap_err().contains("folder"));
        assert!(read(&["--fast"]).unwrap_err().contains("--fast"));
    }
}
