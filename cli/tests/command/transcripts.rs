//! `tests/transcripts`: what the command says to a reader, line for line.
//!
//! A line `$ COMMAND` is given to a shell, with the lines `< ` after it as standard input. What follows is what the
//! command said: `> ` on standard output, `! ` on standard error, `= CODE` where its exit code is not 0. All other
//! lines are prose. Blanks at the end of a line do not count, and `[..]` stands for any part of one: times on the
//! clock, speeds of this machine.
//!
//! With TRIBOS_TRANSCRIPTS=write the test writes what it found, and keeps prose and `[..]`.
#![cfg(unix)]

use crate::help::commands;
use crate::program::{Error, Outcome};
use crate::reader::{prepare, said};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/transcripts");
const GAP: &str = "[..]";
/// Exit code of bad input.
const REFUSED: Option<i32> = Some(2);

#[test]
fn the_command_says_what_its_transcripts_show() -> Outcome {
    let files: Result<Vec<PathBuf>, _> = fs::read_dir(FOLDER)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect();
    let is_written = std::env::var("TRIBOS_TRANSCRIPTS").is_ok_and(|how| how == "write");
    let found: Vec<Result<Option<String>, String>> = files?
        .par_iter()
        .map(|file| {
            judged(file, is_written).map_err(|error| format!("{}: {error}", file.display()))
        })
        .collect();
    let found = found.into_iter().collect::<Result<Vec<_>, _>>()?;
    let changed: Vec<String> = found.into_iter().flatten().collect();
    assert!(changed.is_empty(), "{}", changed.join("\n"));
    Ok(())
}

#[test]
fn every_command_shows_its_help_in_a_transcript() -> Outcome {
    let mut texts = String::new();
    for entry in fs::read_dir(FOLDER)? {
        texts += &fs::read_to_string(entry?.path())?;
    }
    let own = commands().into_iter().map(|(path, _)| path);
    // That of the thesis is another program's.
    for path in own.filter(|path| path[0] != "reproduce") {
        let line = format!("$ tribos {} --help\n", path.join(" "));
        assert!(texts.contains(&line), "{line}");
    }
    Ok(())
}

/// What is not as in the file, unless it is written there.
fn judged(file: &Path, is_written: bool) -> Result<Option<String>, Error> {
    let shown = fs::read_to_string(file)?;
    let folder = tempfile::tempdir()?;
    prepare(folder.path())?;
    let found = played(&shown, folder.path())?;
    if found == shown {
        return Ok(None);
    }
    if is_written {
        fs::write(file, found)?;
        return Ok(None);
    }
    Ok(Some(difference(file, &shown, &found)))
}

/// The same transcript with what its commands say now.
fn played(shown: &str, folder: &Path) -> Result<String, Error> {
    let mut found = String::new();
    let mut lines = shown.lines().peekable();
    while let Some(line) = lines.next() {
        found += &format!("{line}\n");
        let Some(command) = line.strip_prefix("$ ") else {
            continue;
        };
        let mut input = String::new();
        while let Some(line) = lines.next_if(|line| line.starts_with('<')) {
            found += &format!("{line}\n");
            input += &format!("{}\n", line.get(2..).unwrap_or_default());
        }
        let mut before = Vec::new();
        while let Some(line) = lines.next_if(|line| line.starts_with(['>', '!', '='])) {
            before.push(line);
        }
        found += &answer(command, &input, folder, &before)?;
    }
    Ok(found)
}

/// What a command says and its exit code, as lines of a transcript; a refused one leaves nothing behind.
fn answer(command: &str, input: &str, folder: &Path, before: &[&str]) -> Result<String, Error> {
    let there = names(folder)?;
    let (code, out, err) = said(folder, command, input)?;
    let is_its = command
        .rsplit("; ")
        .next()
        .is_some_and(|last| last.starts_with("tribos "));
    if code == REFUSED && is_its {
        let now = names(folder)?;
        let is_given = |name: &&String| command.contains(&format!("> {name}"));
        if let Some(name) = now.difference(&there).find(|name| !is_given(name)) {
            return Err(format!("{command}: refused, and {name} is there").into());
        }
    }
    if err.contains("panicked") {
        return Err(format!("{command}: {err}").into());
    }
    let mut lines = Vec::new();
    for (mark, text) in [(">", out), ("!", err)] {
        lines.extend(
            text.lines()
                .map(|line| format!("{mark} {line}").trim_end().to_owned()),
        );
        if !text.is_empty() && !text.ends_with('\n') {
            lines.push(format!("{mark}(no end of line)"));
        }
    }
    if code != Some(0) {
        let code = code.ok_or_else(|| format!("{command}: ended by a signal"))?;
        lines.push(format!("= {code}"));
    }
    let kept = |line: String| match before.iter().find(|gapped| stands_for(gapped, &line)) {
        Some(gapped) => format!("{gapped}\n"),
        None => line + "\n",
    };
    Ok(lines.into_iter().map(kept).collect())
}

/// True of a line with gaps that has all other parts of the line found, in their order.
fn stands_for(gapped: &str, line: &str) -> bool {
    let mut parts = gapped.split(GAP);
    let Some(mut rest) = parts.next().and_then(|first| line.strip_prefix(first)) else {
        return false;
    };
    let mut parts = parts.peekable();
    while let Some(part) = parts.next() {
        if parts.peek().is_none() {
            return rest.ends_with(part);
        }
        let Some((_, after)) = rest.split_once(part) else {
            return false;
        };
        rest = after;
    }
    false
}

/// All files and folders in a folder.
fn names(folder: &Path) -> Result<BTreeSet<String>, Error> {
    let mut names = BTreeSet::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(here) = folders.pop() {
        for entry in fs::read_dir(&here)? {
            let path = entry?.path();
            names.insert(path.strip_prefix(folder)?.display().to_string());
            if path.is_dir() && !path.is_symlink() {
                folders.push(path);
            }
        }
    }
    Ok(names)
}

/// Each command whose answer is another: as the file has it, and as it is now.
fn difference(file: &Path, shown: &str, found: &str) -> String {
    let pairs = shown.split("\n$ ").zip(found.split("\n$ "));
    let changed = pairs.filter(|(shown, found)| shown != found);
    let told = changed.map(|(shown, found)| format!("$ {shown}\nis now\n$ {found}\n"));
    format!(
        "{}: (TRIBOS_TRANSCRIPTS=write takes what is now)\n{}",
        file.display(),
        told.collect::<String>()
    )
}

#[test]
fn a_gap_stands_for_any_part_of_a_line_and_for_nothing_else() {
    for (gapped, line, stands) in [
        ("> took [..] s", "> took 1.5 s", true),
        ("> took [..] s", "> took  s", true),
        ("> took [..] s", "! took 1.5 s", false),
        ("> took [..] s", "> took 1.5 s more", false),
        ("> [..] of [..] s", "> 1 of 2 s", true),
        ("> [..] of [..] s", "> 1 s", false),
        ("> a[..]ab", "> ab", false),
        ("> the same", "> the same", false),
    ] {
        assert_eq!(stands_for(gapped, line), stands, "{gapped} {line}");
    }
}
