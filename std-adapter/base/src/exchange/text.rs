//! Text files line by line: words as numbers, errors that name the line and the valid input.

use super::atoms::AtomsError;
use crate::scene::number_hint;

/// An error in a file, with its line.
///
/// ```
/// use tribos::md::{configuration::read, text::TextError};
/// let Err(refused) = read("1\nProperties=species:S:1:pos:R:3\nAr 0 zero 0\n") else {
///     unreachable!()
/// };
/// assert_eq!(refused.to_string(), "line 3: a coordinate must be a finite number, not `zero`");
/// let short = read("2\nProperties=species:S:1:pos:R:3\nAr 0 0 0\n");
/// assert!(matches!(short, Err(TextError::Missing { line: 4, .. }))); // of two atoms one
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TextError {
    /// An invalid word.
    #[error("line {line}: {what} must be {valid}, not `{given}`")]
    Value {
        /// Line number, from 1.
        line: usize,
        /// Meaning of the word.
        what: &'static str,
        /// Description of valid values.
        valid: String,
        /// The rejected value.
        given: String,
    },
    /// A required item is missing: the file or a line ends too early.
    #[error("line {line}: {what} is missing; {cure}")]
    Missing {
        /// Line, from 1, where the item was expected.
        line: usize,
        /// Name of the missing item.
        what: &'static str,
        /// How to correct it.
        cure: String,
    },
    /// An item that other programs accept, but Tribos does not.
    #[error("line {line}: {what} cannot be read; {cure}")]
    Unsupported {
        /// Line number, from 1.
        line: usize,
        /// Name of the item.
        what: String,
        /// How to correct it.
        cure: &'static str,
    },
    /// An item that occurs twice.
    #[error("line {line}: {what} {given} stands here for the second time")]
    Twice {
        /// Line number, from 1.
        line: usize,
        /// Name of the item.
        what: &'static str,
        /// The repeated value.
        given: String,
    },
    /// The atoms are invalid; messages number them in the order of the file.
    #[error(transparent)]
    Atoms(#[from] AtomsError),
}

/// A line with its number, from 1.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    /// Its number, from 1.
    pub number: usize,
    /// Its text.
    pub text: &'a str,
}

impl<'a> Line<'a> {
    /// The line without comment (from `#` on) and surrounding blanks.
    pub fn without_comment(self) -> Self {
        let text = self.text.split('#').next().unwrap_or_default().trim();
        Self { text, ..self }
    }

    /// What stands between blanks.
    pub fn words(self) -> Vec<&'a str> {
        self.text.split_whitespace().collect()
    }

    /// A finite number.
    pub fn number(self, what: &'static str, word: &str) -> Result<f64, TextError> {
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| {
            let hint = number_hint(word).map_or(String::new(), |hint| format!(" ({hint})"));
            self.invalid(what, format!("a finite number{hint}"), word)
        })
    }

    /// A finite number > 0.
    pub fn positive(self, what: &'static str, word: &str) -> Result<f64, TextError> {
        let number = self.number(what, word)?;
        if number > 0.0 {
            Ok(number)
        } else {
            Err(self.invalid(what, "a number > 0", word))
        }
    }

    /// A whole number in a range.
    pub fn whole(
        self,
        what: &'static str,
        range: std::ops::RangeInclusive<u64>,
        word: &str,
    ) -> Result<u64, TextError> {
        let number = word.parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| {
            let valid = match *range.end() {
                u64::MAX => format!("a whole number >= {}", range.start()),
                end => format!("a whole number from {} to {end}", range.start()),
            };
            self.invalid(what, valid, word)
        })
    }

    /// The error that a word of the line is invalid.
    pub fn invalid(self, what: &'static str, valid: impl Into<String>, given: &str) -> TextError {
        TextError::Value {
            line: self.number,
            what,
            valid: valid.into(),
            given: given.into(),
        }
    }

    /// The error that something is missing here.
    pub fn missing(self, what: &'static str, cure: impl Into<String>) -> TextError {
        TextError::Missing {
            line: self.number,
            what,
            cure: cure.into(),
        }
    }
}

/// The lines of a file, one after another.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    lines: std::iter::Peekable<std::iter::Enumerate<std::str::Lines<'a>>>,
    last: usize,
}

impl<'a> Lines<'a> {
    /// Those of a text.
    pub fn new(text: &'a str) -> Self {
        Self {
            lines: text.lines().enumerate().peekable(),
            last: 0,
        }
    }

    /// The next line; the error for a missing line names `what` was expected.
    pub fn need(&mut self, what: &'static str, cure: &str) -> Result<Line<'a>, TextError> {
        let here = self.here();
        self.next().ok_or_else(|| here.missing(what, cure))
    }

    /// The next line, or an empty one after the last.
    pub fn here(&mut self) -> Line<'a> {
        let number = self.last + 1;
        self.peek().unwrap_or(Line { number, text: "" })
    }

    /// The next line, without consuming it.
    pub fn peek(&mut self) -> Option<Line<'a>> {
        self.lines.peek().map(|&(index, text)| Line {
            number: index + 1,
            text,
        })
    }

    /// Skips blank lines.
    pub fn skip_blank_lines(&mut self) {
        while self.peek().is_some_and(|line| line.text.trim().is_empty()) {
            self.next();
        }
    }

    /// Skips lines that are blank or contain only a comment.
    pub fn skip_blank(&mut self) {
        while let Some(line) = self.peek()
            && line.without_comment().text.is_empty()
        {
            self.next();
        }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        let (index, text) = self.lines.next()?;
        self.last = index + 1;
        Some(Line {
            number: self.last,
            text,
        })
    }
}
