//! Table of all platforms.

use super::platforms::Platform;
use super::work::Answer;
use std::fmt::Write;
use std::time::Duration;
use tribos_subjects::{SUBJECTS, Subject, whole};

/// Result of a row.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// The platform computed its digests.
    Ran {
        /// Its digests.
        answers: Vec<Answer>,
        /// Number of programs among which the subjects were divided.
        images: usize,
        /// Running time on the machine.
        time: Duration,
    },
    /// A required program is not installed: the commands that install it.
    Missing(Vec<String>),
    /// The build or the run failed: the reason.
    Failed(String),
}

/// A platform and its result.
#[derive(Clone, Debug)]
pub struct Row {
    /// The platform.
    pub platform: Platform,
    /// Its result.
    pub outcome: Outcome,
}

const HEADER: &str = "\
| row | target | machine | subjects | digest | equal | instructions | seconds |
|---|---|---|---:|---|---|---:|---:|
";

/// The first subject whose digest differs from the pinned one.
pub fn first_difference(answers: &[Answer]) -> Option<&'static str> {
    let differs = |answer: &&Answer| SUBJECTS[answer.subject].pinned() != Some(answer.digest);
    answers
        .iter()
        .find(differs)
        .map(|answer| SUBJECTS[answer.subject].name)
}

impl Row {
    /// True if the platform broke its promise.
    pub fn is_broken(&self) -> bool {
        match &self.outcome {
            Outcome::Ran { answers, .. } => {
                self.platform.promised && first_difference(answers).is_some()
            }
            Outcome::Missing(_) => false,
            Outcome::Failed(_) => self.platform.promised,
        }
    }

    /// True if a promise could not be checked.
    pub fn is_lacking(&self) -> bool {
        self.platform.promised && matches!(self.outcome, Outcome::Missing(_))
    }

    /// The row as a line of Markdown.
    pub fn line(&self) -> String {
        let platform = &self.platform;
        let (name, target) = (platform.name, platform.target.unwrap_or("this one"));
        let machine = platform.machine_name();
        let cells = match &self.outcome {
            Outcome::Ran {
                answers,
                images,
                time,
            } => ran(platform, answers, *images, *time),
            Outcome::Missing(_) => "- | - | missing | - | -".into(),
            Outcome::Failed(_) => "- | - | failed | - | -".into(),
        };
        format!("| {name} | {target} | {machine} | {cells} |")
    }
}

fn ran(platform: &Platform, answers: &[Answer], images: usize, time: Duration) -> String {
    let subjects = match images {
        1 => answers.len().to_string(),
        _ => format!("{} in {images} images", answers.len()),
    };
    let digest = whole(answers.iter().map(|answer| answer.digest));
    let promise = if platform.promised { "" } else { "outside: " };
    let equal = match first_difference(answers) {
        None => "yes".into(),
        Some(name) => format!("no, first in \"{name}\""),
    };
    let counts: Option<u64> = answers.iter().map(|answer| answer.instructions).sum();
    let counts = counts.map_or("-".into(), grouped);
    let seconds = time.as_secs_f64();
    format!("{subjects} | `{digest:016x}` | {promise}{equal} | {counts} | {seconds:.1}")
}

/// A number with digits in groups of three.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut out = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            out.push(' ');
        }
        out.push(digit);
    }
    out
}

/// The whole table, with instructions for rows that did not run.
pub fn table(rows: &[Row]) -> String {
    let mut out = String::from(HEADER);
    for row in rows {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", row.line());
    }
    out.push_str(
        "\nEqual: every subject has the digest of tests/subjects/digests.txt. The digest of a row is \
         over the subjects it ran.\nNot promised: x87 registers (i586), compilers that contract \
         a product and a sum (`-ffp-contract=fast`).\n",
    );
    for row in rows {
        let name = row.platform.name;
        let _ = match &row.outcome {
            Outcome::Missing(commands) => {
                writeln!(
                    out,
                    "\n{name} did not run; for it: {}",
                    commands.join(" && ")
                )
            }
            Outcome::Failed(message) => writeln!(out, "\n{name} failed: {message}"),
            Outcome::Ran { answers, .. } => differences(&mut out, name, answers),
        };
    }
    out
}

/// Every subject with differing digests, with both digests.
fn differences(out: &mut String, row: &str, answers: &[Answer]) -> std::fmt::Result {
    for answer in answers {
        let Subject { name, .. } = SUBJECTS[answer.subject];
        let wanted = SUBJECTS[answer.subject].pinned().unwrap_or_default();
        let got = answer.digest;
        if got != wanted {
            writeln!(
                out,
                "\n{row}: \"{name}\" is {got:#018x}, not {wanted:#018x}"
            )?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cross::platforms::PLATFORMS;

    fn row(change: u64) -> Row {
        let answers = (0..SUBJECTS.len()).map(|subject| Answer {
            subject,
            digest: SUBJECTS[subject].pinned().unwrap() ^ if subject == 4 { change } else { 0 },
            instructions: Some(1000),
        });
        let outcome = Outcome::Ran {
            answers: answers.collect(),
            images: 1,
            time: Duration::from_secs(1),
        };
        let platform = PLATFORMS[0];
        Row { platform, outcome }
    }

    #[test]
    fn one_bit_breaks_a_row_and_is_named() {
        assert!(!row(0).is_broken() && row(0).line().contains("| yes |"));
        let broken = row(1);
        assert!(broken.is_broken());
        assert!(broken.line().contains(SUBJECTS[4].name));
    }

    #[test]
    fn numbers_are_grouped_from_the_right() {
        assert_eq!(
            [7, 1234, 1_000_000].map(grouped),
            ["7", "1 234", "1 000 000"]
        );
    }
}
