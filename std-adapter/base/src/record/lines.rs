//! The lines of a text file, one after the other.

use super::encoding::{as_text, letters_of};
use super::read::packer;
use super::table::TableError;
use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

/// Most bytes of a line. What is longer is no table of numbers.
const LONGEST: usize = 65_536;
/// Mark of the byte order that some programs put before UTF-8 text.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// The control character of a new page, which a text may have.
const NEW_PAGE: u8 = 0x0c;
/// The letter that ends a text under DOS.
const DOS_END: u8 = 0x1a;

/// Lines of a file that are not blank, with their numbers; one of them is held in memory. Files may be packed by gzip,
/// in UTF-8, in UTF-16 with its mark, or in Windows' letters of one byte.
pub struct Lines<'a> {
    name: PathBuf,
    source: Box<dyn BufRead + 'a>,
    /// Whether nothing was read so far.
    is_new: bool,
    /// What was done to the source to make it text.
    unpacked: Option<&'static str>,
    /// The line read last, without its end.
    bytes: Vec<u8>,
    /// The same as text where its bytes are not UTF-8.
    converted: String,
    is_converted: bool,
    has_windows_letters: bool,
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

    /// Of a file that a command line names: `-` is standard input.
    pub fn asked_for(path: &Path) -> Result<Self, TableError> {
        if path == Path::new("-") {
            return Ok(Self::of(path, Box::new(io::stdin().lock())));
        }
        Self::open(path)
    }

    /// Of an open source with this name.
    pub fn of(path: &Path, source: Box<dyn BufRead + 'a>) -> Self {
        Self {
            name: path.to_path_buf(),
            source,
            is_new: true,
            unpacked: None,
            bytes: Vec::new(),
            converted: String::new(),
            is_converted: false,
            has_windows_letters: false,
            number: 0,
            ended_by_return: false,
        }
    }

    /// The next line that is neither blank nor a comment, which begins with #.
    pub fn next(&mut self) -> Result<Option<&str>, TableError> {
        while let Some(is_comment) = self.advance()? {
            if !is_comment {
                return Ok(Some(self.text()));
            }
        }
        Ok(None)
    }

    /// Goes to the next line that is not blank: whether it is a comment, or none at the end.
    pub(super) fn advance(&mut self) -> Result<Option<bool>, TableError> {
        loop {
            let read = self.read_line();
            if !read.map_err(|error| unreadable(&self.name, &error))? {
                return Ok(None);
            }
            self.refuse_what_is_no_text()?;
            let first = self.bytes.iter().find(|byte| !byte.is_ascii_whitespace());
            let Some(first) = first else {
                continue;
            };
            let is_comment = *first == b'#';
            self.is_converted = std::str::from_utf8(&self.bytes).is_err();
            if self.is_converted {
                self.has_windows_letters = true;
                letters_of(&self.bytes, &mut self.converted);
            }
            return Ok(Some(is_comment));
        }
    }

    /// The line read last.
    pub(super) fn text(&self) -> &str {
        let text = match self.is_converted {
            true => &self.converted,
            false => std::str::from_utf8(&self.bytes).unwrap_or_default(),
        };
        match self.number {
            1 => text.trim_start_matches(BYTE_ORDER_MARK),
            _ => text,
        }
    }

    /// The name of the source.
    pub(super) fn name(&self) -> String {
        self.name.display().to_string()
    }

    /// Words for an encoding other than UTF-8 that was met so far.
    pub(super) fn encoding(&self) -> Option<&'static str> {
        self.unpacked
            .or(self.has_windows_letters.then_some("Latin-1"))
    }

    fn refuse_what_is_no_text(&mut self) -> Result<(), TableError> {
        if self.number == 1
            && let Some(cure) = packer(&self.bytes)
        {
            return Err(self.refusal(&format!("the file is compressed ({cure}); unpack it first")));
        }
        if self.bytes.contains(&0) {
            return Err(
                self.refusal("the file is not text: it contains a zero byte; give plain CSV")
            );
        }
        if self.bytes.last() == Some(&DOS_END) {
            self.bytes.pop();
        }
        if self.bytes.iter().any(is_control) {
            return Err(self
                .refusal("the file is not text: it contains control characters; give plain CSV"));
        }
        if self.bytes.len() > LONGEST {
            let message = format!("longer than {LONGEST} bytes; give plain CSV");
            return Err(self.refusal(&message));
        }
        Ok(())
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
        if self.is_new {
            self.is_new = false;
            let raw = std::mem::replace(&mut self.source, Box::new(io::empty()));
            (self.source, self.unpacked) = as_text(raw)?;
        }
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

/// Whether no text has such a byte.
fn is_control(byte: &u8) -> bool {
    *byte < b' ' && !matches!(*byte, b'\t' | NEW_PAGE)
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
        let refused = lines(b"PK\x03\x04", 8).err().unwrap_or_default();
        assert!(refused.contains("(unzip); unpack it first"), "{refused}");
        let refused = lines(b"v\n\x01\xff\n", 8).err().unwrap_or_default();
        assert!(
            refused.starts_with("a:2: the file is not text"),
            "{refused}"
        );
    }

    #[test]
    fn bytes_that_are_no_unicode_are_letters_of_windows() {
        let read = lines(b"v\n\xb5m\n1\x1a", 8);
        let wanted = [(1, "v"), (2, "µm"), (3, "1")].map(|(at, text)| (at, text.to_owned()));
        assert_eq!(read, Ok(wanted.to_vec()));
    }
}
