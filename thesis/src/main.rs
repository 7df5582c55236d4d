//! `tribos-thesis`: the thesis' results, claim by claim. `tribos reproduce` starts this program.

use anyhow::Error;
use clap::Parser;
use std::ffi::OsString;
use std::fmt;
use std::io::{ErrorKind, Write, stderr, stdout};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use tribos::friction::finite_number;
use tribos::record::RecordError;
use tribos::run::program::{self, Program};
use tribos_thesis::{Effort, Reader, Report, UnknownName, chosen, is_interruption};

/// Exit code of a report that failed.
const FAILED: u8 = 1;
/// Exit code of bad usage or input; clap uses the same.
const BAD_INPUT: u8 = 2;
/// Exit code of an interrupted report, as shells have it for SIGINT.
const INTERRUPTED: u8 = 130;

/// Reproduce the results of the thesis on friction laws and coupled friction (chapters 2 and 3,
/// section 5.1 and appendix A), on the compaction of cohesive powders (chapter 4 and section 5.2) and
/// on torsion friction of atoms (section 5.3): every figure and table as CSV (whose first line, with a #, says
/// how it was made), SVG and PNG; index.html, whose first screen says what holds; a page for each chapter with the
/// thesis' claims, our numbers, their uncertainty, a verdict and its grounds, and with films, those of
/// appendix B on pages of their own; and claims.csv, all rows with their numbers.
///
/// The expected cost is printed first. The program may be interrupted at any time; the same command
/// continues from DIR/kept and ends with the same files. Runs use all cores.
#[derive(Debug, Parser)]
#[command(name = "tribos-thesis", version, after_long_help = EXAMPLES)]
struct Arguments {
    /// Folder for the report, created if missing; files of an earlier report in it are replaced. The folder of a
    /// sweep, or of a run of a powder or a tip, is refused.
    #[arg(long, value_name = "DIR", required_unless_present = "list")]
    out: Option<PathBuf>,
    /// What to reproduce, such as 3.4 or table-3.1; everything if left out.
    names: Vec<String>,
    /// Simulate everything that the thesis shows (4.6, 4.7, table 4.1, 5.2), and the map of section 5.2,
    /// not a sample of it: some hours on two cores instead of a minute or two.
    #[arg(long)]
    full: bool,
    /// Simulate a sample where the whole takes long: fewer seeds, coefficients and spheres, shorter
    /// times. This is the default; the page marks the places.
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// Seconds between checkpoints of a run.
    #[arg(long, value_name = "SECONDS", default_value = "20", value_parser = pause)]
    #[arg(allow_negative_numbers = true)]
    checkpoint: Duration,
    /// List the names only.
    #[arg(long)]
    list: bool,
    /// Do not report progress; results, warnings and errors are still written.
    #[arg(long, short)]
    quiet: bool,
}

const EXAMPLES: &str = "\
Examples:
  tribos-thesis --out out/thesis
  tribos-thesis --out out/thesis 3.4 3.13 table-3.1
  tribos-thesis --out out/porosity 4.7 --full
  tribos-thesis --list
Exit codes: 0 done, 1 a comparison fails for no known reason, or a file cannot be written, 2 bad usage or
bad input, 130 interrupted.";

/// A number of seconds ≥ 0.
fn pause(text: &str) -> Result<Duration, String> {
    match finite_number(text)? {
        seconds if seconds >= 0.0 => {
            Ok(Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX))
        }
        _ => Err("give a number >= 0".into()),
    }
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    host();
    match arguments.execute() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let (code, text) = explain(&error);
            say(format_args!("{text}"));
            code.into()
        }
    }
}

/// What locks and messages of folders call this program.
fn host() {
    let words = ["tribos", "reproduce"].map(OsString::from);
    program::host(Program {
        line: words
            .into_iter()
            .chain(std::env::args_os().skip(1))
            .collect(),
        command: None,
        library: std::env::current_exe().unwrap_or_default(),
    });
}

impl Arguments {
    /// Makes the report.
    fn execute(self) -> Result<(), Error> {
        let exhibits = chosen(&self.names)?;
        let Some(out) = self.out.filter(|_| !self.list) else {
            let lines: String = exhibits.iter().map(|name| format!("{name}\n")).collect();
            print(&lines);
            return Ok(());
        };
        let effort = if self.full {
            Effort::Full
        } else {
            Effort::Quick
        };
        let report = Report {
            exhibits,
            effort,
            pause: self.checkpoint,
        };
        let terminal = Terminal {
            is_quiet: self.quiet,
            is_asked_to_end: watch()?,
        };
        report.write(&out, &terminal)
    }
}

/// The exit code of a report that ended early, and what is said of it.
fn explain(error: &Error) -> (u8, String) {
    if is_interruption(error) {
        let text = "interrupted while exhibits were made; what was finished is kept\n  Give the same command again.";
        return (INTERRUPTED, text.into());
    }
    let is_refused = matches!(error.downcast_ref(), Some(RecordError::Refused(_)));
    let text = format!("error: {}", causes(error));
    if is_refused || error.is::<UnknownName>() {
        return (BAD_INPUT, text);
    }
    let is_out_of_room = |kind: ErrorKind| {
        use ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
        matches!(kind, StorageFull | QuotaExceeded | FileTooLarge)
    };
    let mut refusals = error
        .chain()
        .filter_map(<dyn std::error::Error>::downcast_ref);
    if refusals.any(|refusal: &std::io::Error| is_out_of_room(refusal.kind())) {
        let advice = "Files written before it are whole and kept, also one of this name. Make room.\n  \
            Then give the same command again; a name after it makes one exhibit.";
        return (FAILED, format!("{text}\n  {advice}"));
    }
    (FAILED, text)
}

/// The error with its causes, but for those that it names itself.
fn causes(error: &Error) -> String {
    let mut causes = error.chain().map(ToString::to_string);
    let first = causes.next().unwrap_or_default();
    causes.fold(first, |text, cause| match text.ends_with(&cause) {
        true => text,
        false => format!("{text}: {cause}"),
    })
}

/// From now on the first Ctrl-C or SIGTERM is noted, and the second ends the process at once.
fn watch() -> Result<Arc<AtomicBool>, Error> {
    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::flag::{register, register_conditional_shutdown};
    let asked = Arc::default();
    for signal in [SIGINT, SIGTERM] {
        // In this order: the first signal finds that nobody has asked yet.
        register_conditional_shutdown(signal, INTERRUPTED.into(), Arc::clone(&asked))?;
        register(signal, Arc::clone(&asked))?;
    }
    Ok(asked)
}

/// The person at the terminal.
struct Terminal {
    is_quiet: bool,
    is_asked_to_end: Arc<AtomicBool>,
}

impl Reader for Terminal {
    fn result(&self, line: fmt::Arguments<'_>) {
        print(&format!("{line}\n"));
    }

    fn progress(&self, line: fmt::Arguments<'_>) {
        if !self.is_quiet {
            say(line);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.is_asked_to_end.load(Ordering::Relaxed)
    }
}

/// Prints; a reader that went away does not stop the work.
fn print(text: &str) {
    let _ = stdout().lock().write_all(text.as_bytes());
}

/// A line on standard error, in one write, so that lines of several threads do not mix.
fn say(line: fmt::Arguments<'_>) {
    let _ = stderr().lock().write_all(format!("{line}\n").as_bytes());
}
