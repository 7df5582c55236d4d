//! A file of twists.

use crate::failure::Failure;
use std::io::Read;
use std::path::Path;

/// Columns that the file must have, in any order, and no others.
const COLUMNS: [&str; 2] = ["speed", "spin"];

/// Reads speed and spin of every line; every refusal names the file and the line.
pub fn read(path: &Path) -> Result<Vec<[f64; 2]>, Failure> {
    let name = path.display();
    let fail = |error: std::io::Error| Failure::input(format!("cannot read {name}: {error}"));
    let mut text = Vec::new();
    if path == Path::new("-") {
        std::io::stdin().read_to_end(&mut text).map_err(fail)?;
    } else {
        text = std::fs::read(path).map_err(fail)?;
    }
    parse(&text).map_err(|message| Failure::input(format!("{name}:{message}")))
}

fn parse(text: &[u8]) -> Result<Vec<[f64; 2]>, String> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(text);
    let headers = reader.headers().map_err(|error| in_words(&error))?.clone();
    let mut columns = [0; 2];
    for (column, name) in columns.iter_mut().zip(COLUMNS) {
        *column = headers
            .iter()
            .position(|header| header == name)
            .ok_or(format!(
                "1: column `{name}` is missing; the header must be speed,spin"
            ))?;
    }
    if let Some(extra) = headers.iter().find(|header| !COLUMNS.contains(header)) {
        return Err(format!(
            "1: unknown column `{extra}`; the header must be speed,spin"
        ));
    }
    let mut twists = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| in_words(&error))?;
        let line = record
            .position()
            .map_or(0, |position| line_of(text, position));
        let mut twist = [0.0; 2];
        for ((value, column), name) in twist.iter_mut().zip(columns).zip(COLUMNS) {
            let text = record.get(column).unwrap_or("");
            *value = crate::command::number::finite(text)
                .map_err(|cure| format!("{line}: {name} is `{text}`; {cure}"))?;
        }
        twists.push(twist);
    }
    if twists.is_empty() {
        return Err("2: no twists; give one speed,spin pair a line".into());
    }
    Ok(twists)
}

/// Line of a record, past the blank lines that the reader counts to it.
fn line_of(text: &[u8], position: &csv::Position) -> u64 {
    let rest = text.iter().skip(position.byte() as usize);
    let blank = rest.take_while(|byte| byte.is_ascii_whitespace());
    position.line() + blank.filter(|&&byte| byte == b'\n').count() as u64
}

/// A CSV error with its line first.
fn in_words(error: &csv::Error) -> String {
    let line = error.position().map_or(1, csv::Position::line);
    match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => {
            format!("{line}: {len} columns instead of {expected_len}; give speed,spin")
        }
        csv::ErrorKind::Utf8 { .. } => {
            format!("{line}: not UTF-8 text; save the file as plain CSV")
        }
        _ => format!("{line}: {error}"),
    }
}
