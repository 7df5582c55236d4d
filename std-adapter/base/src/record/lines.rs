//! The lines of a text file, one after the other.

use super::read::packer;
use super::table::TableError;
use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

/// Most bytes of a line. What is longer is no table of numbers.
const LONGEST: usize = 65_536;
/// Mark of the byte order that some programs put before UTF-8 text.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Lines of a file that are not blank, with their numbers; one of them is held in memory.
pub struct Lines<'a> {
    name: PathBuf,
    source: Box<dyn BufRead + 'a>,
    /// The line read last, without its end.
    bytes: Vec<u8>,
    number: u64,
    /// Whether the line read last ended with a carriage return, to which a line feed belongs.
    ended_by_return: bool,
}

impl<'a> Lines<'a> {
    /// Of a file.
    pub fn open(path: &Path) -> Result<Self, TableError> {
        let file = File::open(path).map_err(|error| unreadable(path, &error))?;
        Ok(Self::of(path, Box::new(BufReader::new(file))))
    }

    /// Of an open source with this name.
    pub fn of(path: &Path, source: Box<dyn BufRead + 'a>) -> Self {
        Self {
            name: path.to_path_buf(),
            source,
            bytes: Vec::new(),
            number: 0,
            ended_by_return: false,
        }
    }

    /// The next line that is neither blank nor a comment, which begins with #.
    pub fn next(&mut self) -> Result<Option<&str>, TableError> {
        loop {
            let read = self.read_line();
            if !read.map_err(|error| unreadable(&self.name, &error))? {
                return Ok(None);
            }
            if self.number == 1
                && let Some(cure) = packer(&self.bytes)
            {
                return Err(
                    self.refusal(&format!("the file is compressed ({cure}); unpack it first"))
                );
            }
            if self.bytes.contains(&0) {
                return Err(
                    self.refusal("the file is not text: it contains a zero byte; give plain CSV")
                );
            }
            if self.bytes.len() > LONGEST {
                let message = format!("longer than {LONGEST} bytes; give plain CSV");
                return Err(self.refusal(&message));
            }
            let first = self.bytes.iter().find(|byte| !byte.is_ascii_whitespace());
            if first.is_some_and(|byte| *byte != b'#') {
                break;
            }
        }
        match std::str::from_utf8(&self.bytes) {
            Ok(text) if self.number == 1 => Ok(Some(text.trim_start_matches(BYTE_ORDER_MARK))),
            Ok(text) => Ok(Some(text)),
            Err(_) => Err(self.refusal("not UTF-8 text; save the file as plain CSV")),
        }
    }

    /// Number of the line read last, from 1; 0 before the first.
    pub fn number(&self) -> u64 {
        self.number
    }

    /// The refusal of what stands in the line read last.
    pub fn refusal(&self, message: &str) -> TableError {
        self.refusal_at(self.number.max(1), message)
    }

    /// The refusal of what stands in a line.
    pub fn refusal_at(&self, line: u64, message: &str) -> TableError {
        TableError::Line {
            file: self.name.display().to_string(),
            line,
            reason: message.into(),
        }
    }

    /// Reads up to the next line feed or carriage return, or past [`LONGEST`] bytes; false at the
    /// end of the file.
    fn read_line(&mut self) -> io::Result<bool> {
        self.bytes.clear();
        let mut has_any = false;
        loop {
            let mut ahead = match self.source.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                other => other?,
            };
            let mut taken = 0;
            if self.ended_by_return && !has_any && ahead.first() == Some(&b'\n') {
                ahead = &ahead[1..];
                taken = 1;
                self.ended_by_return = false;
                if ahead.is_empty() {
                    self.source.consume(taken);
                    continue;
                }
            }
            if ahead.is_empty() {
                self.number += u64::from(has_any);
                return Ok(has_any);
            }
            has_any = true;
            let end = ahead.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            let length = end.unwrap_or(ahead.len());
            self.bytes.extend_from_slice(&ahead[..length]);
            self.ended_by_return = end.is_some_and(|at| ahead[at] == b'\r');
            self.source
                .consume(taken + length + usize::from(end.is_some()));
            if end.is_some() || self.bytes.len() > LONGEST {
                self.number += 1;
                return Ok(true);
            }
        }
    }
}

fn unreadable(path: &Path, error: &io::Error) -> TableError {
    TableError::Access {
        file: path.display().to_string(),
        reason: error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines with their numbers, read through a buffer of so many bytes.
    fn lines(bytes: &'static [u8], buffer: usize) -> Result<Vec<(u64, String)>, String> {
        let source = Box::new(BufReader::with_capacity(buffer, bytes));
        let mut lines = Lines::of(Path::new("a"), source);
        let mut all = Vec::new();
        loop {
            let found = lines.next().map_err(|failure| failure.to_string())?;
            let Some(text) = found.map(str::to_owned) else {
                return Ok(all);
            };
            all.push((lines.number(), text));
        }
    }

    #[test]
    fn all_ends_of_lines_count_alike() {
        let texts: [&[u8]; 5] = [
            b"a\n\nb",
            b"a\r\n\r\nb\r\n",
            b"a\r\rb\r",
            b"\xef\xbb\xbfa\n \nb\n\n",
            b"a\n\r\nb",
        ];
        let wanted = vec![(1, "a".to_owned()), (3, "b".to_owned())];
        for (text, buffer) in texts
            .iter()
            .flat_map(|text| [1, 2, 3, 64].map(|n| (text, n)))
        {
            assert_eq!(lines(text, buffer), Ok(wanted.clone()), "{text:?} {buffer}");
        }
        assert_eq!(lines(b"", 8), Ok(vec![]));
    }

    #[test]
    fn a_file_without_lines_and_one_that_is_no_text_are_refused() {
        static ENDLESS: [u8; LONGEST + 2] = [b'0'; LONGEST + 2];
        let refused = lines(&ENDLESS, 4096).err().unwrap_or_default();
        assert!(refused.starts_with("a:1: longer than"), "{refused}");
        let refused = lines(b"\x1f\x8b\x08\0", 8).err().unwrap_or_default();
        assert!(refused.contains("(gunzip); unpack it first"), "{refused}");
        let refused = lines(b"v\n\xff\n", 8).err().unwrap_or_default();
        assert!(refused.starts_with("a:2: not UTF-8"), "{refused}");
    }
}
