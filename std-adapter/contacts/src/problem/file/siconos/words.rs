//! Words of a text and the lines that they stand in.

use super::super::error::{Fault, FilePosition, LocatedFault};
use crate::problem::ProblemError;

/// Most characters of a word in a message.
const SHOWN: usize = 40;

/// The part of a text that was not read yet.
#[derive(Clone)]
pub(super) struct TokenReader<'a> {
    rest: &'a str,
    /// Line of the last word.
    line: usize,
}

fn newlines(text: &str) -> usize {
    text.bytes().filter(|&byte| byte == b'\n').count()
}

impl<'a> TokenReader<'a> {
    pub fn new(text: &'a str) -> Self {
        Self {
            rest: text,
            line: 1,
        }
    }

    /// The next word, if there is one.
    pub fn next_word(&mut self) -> Option<&'a str> {
        let word_on = self.rest.trim_start();
        let space = &self.rest[..self.rest.len() - word_on.len()];
        self.line += newlines(space);
        let end = word_on
            .find(|c: char| c.is_whitespace())
            .unwrap_or(word_on.len());
        let (word, rest) = word_on.split_at(end);
        self.rest = rest;
        (!word.is_empty()).then_some(word)
    }

    /// The most words that the rest can hold: each takes a character and a space.
    pub fn room(&self) -> usize {
        self.rest.len().div_ceil(2)
    }

    /// Place of the last word.
    pub fn place(&self) -> FilePosition {
        FilePosition::Line(self.line)
    }

    /// The rest of the line.
    pub fn skip_line(&mut self) {
        let end = self.rest.find('\n').unwrap_or(self.rest.len());
        self.rest = &self.rest[end..];
    }

    /// The next word; `wanted` says what it should be.
    pub fn word(&mut self, wanted: &str) -> Result<&'a str, LocatedFault> {
        self.next_word()
            .ok_or_else(|| (self.place(), Fault::Ended(wanted.to_string())))
    }

    /// Demands a word.
    pub fn exactly(&mut self, wanted: &str) -> Result<(), LocatedFault> {
        let found = self.word(wanted)?;
        if found == wanted {
            return Ok(());
        }
        Err(self.wrong_word(found, wanted))
    }

    pub fn wrong_word(&self, found: &str, wanted: &str) -> LocatedFault {
        let fault = Fault::Word {
            found: shortened(found),
            wanted: wanted.to_string(),
        };
        (self.place(), fault)
    }

    /// An integer in a range.
    pub fn integer(&mut self, what: &str, range: [i128; 2]) -> Result<i128, LocatedFault> {
        let word = self.word(what)?;
        self.integer_of(word, what, range)
    }

    /// The integer that a word is.
    pub fn integer_of(
        &self,
        word: &str,
        what: &str,
        range: [i128; 2],
    ) -> Result<i128, LocatedFault> {
        let number: i128 = word.parse().map_err(|_| self.wrong_word(word, what))?;
        let [least, most] = range;
        if (least..=most).contains(&number) {
            return Ok(number);
        }
        let wanted = match least == most {
            true => least.to_string(),
            false if number < 0 && least == 0 => "0 or more".to_string(),
            false => format!("between {least} and {most}"),
        };
        Err(self.wrong_count(what, number, wanted))
    }

    pub fn wrong_count(
        &self,
        what: &str,
        found: impl TryInto<i128>,
        wanted: String,
    ) -> LocatedFault {
        let fault = Fault::Count {
            what: what.to_string(),
            found: found.try_into().unwrap_or(i128::MAX),
            wanted,
        };
        (self.place(), fault)
    }

    /// A number of things, at most `most`.
    pub fn count(&mut self, what: &str, most: usize) -> Result<usize, LocatedFault> {
        let number = self.integer(what, [0, most as i128])?;
        Ok(number as usize)
    }

    /// A number of things that take a word each, at least.
    pub fn amount(&mut self, what: &str) -> Result<usize, LocatedFault> {
        let most = self.room();
        let number = self.integer(what, [0, i128::MAX])?;
        match usize::try_from(number) {
            Ok(amount) if amount <= most => Ok(amount),
            _ => {
                let wanted = format!("at most {most}, for which the file has room");
                Err(self.wrong_count(what, number, wanted))
            }
        }
    }

    /// A count that must be `wanted`.
    pub fn same(&mut self, what: &str, wanted: usize) -> Result<(), LocatedFault> {
        self.integer(what, [wanted as i128; 2]).map(|_| ())
    }

    /// A finite number.
    pub fn number(&mut self, what: &str) -> Result<f64, LocatedFault> {
        let word = self.word(what)?;
        match word.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(self.wrong_word(word, &format!("{what}, a finite number"))),
        }
    }

    /// Finite numbers.
    pub fn numbers(&mut self, what: &str, count: usize) -> Result<Vec<f64>, LocatedFault> {
        let mut numbers = Vec::with_capacity(count.min(self.room()));
        for _ in 0..count {
            numbers.push(self.number(what)?);
        }
        Ok(numbers)
    }

    pub fn not_a_problem(&self, error: ProblemError) -> LocatedFault {
        (self.place(), Fault::Problem(error))
    }
}

/// The beginning of a word, for messages.
pub(super) fn shortened(word: &str) -> String {
    match word.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}…", &word[..end]),
        None => word.to_string(),
    }
}
