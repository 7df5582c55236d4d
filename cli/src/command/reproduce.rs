//! `tribos reproduce`: the thesis' results, claim by claim.

use super::{interrupt, number};
use crate::failure::Failure;
use std::fmt;
use std::path::PathBuf;
use std::time::Duration;
use tribos::powder::CompactionError;
use tribos::record::WriteError;
use tribos::run::RunError;
use tribos::run::folder::FolderError;
use tribos::tip::TipError;
use tribos_report::image::ImageError;
use tribos_report::runs::FilmError;
pub use tribos_thesis::names;
use tribos_thesis::{Effort, Interrupted, Reader, Report, chosen};

/// Reproduce the results of the thesis on friction laws and coupled friction (chapters 2 and 3,
/// section 5.1 and appendix A), on the compaction of cohesive powders (chapter 4 and section 5.2) and
/// on torsion friction of atoms (section 5.3): every figure and table as CSV, SVG and PNG, and
/// index.html with the thesis' claims, our numbers, their uncertainty, a verdict and its grounds, and
/// with films; those of appendix B are pages of their own.
///
/// The expected cost is printed first. The command may be interrupted at any time; the same command
/// continues from DIR/kept and ends with the same files. Runs use all cores.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
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
    #[arg(long, value_name = "SECONDS", default_value = "20", value_parser = number::pause)]
    #[arg(allow_negative_numbers = true)]
    checkpoint: Duration,
    /// List the names only.
    #[arg(long)]
    list: bool,
}

const EXAMPLES: &str = "\
Examples:
  tribos reproduce --out out/thesis
  tribos reproduce --out out/thesis 3.4 3.13 table-3.1
  tribos reproduce --out out/porosity 4.7 --full
  tribos reproduce --list";

/// The person at the terminal.
struct Terminal;

impl Reader for Terminal {
    fn result(&self, line: fmt::Arguments<'_>) {
        // A reader that went away does not stop the work.
        let _ = super::print(&format!("{line}\n"));
    }

    fn progress(&self, line: fmt::Arguments<'_>) {
        super::note(line);
    }

    fn is_cancelled(&self) -> bool {
        interrupt::is_asked()
    }
}

impl Arguments {
    /// Makes the report.
    pub fn execute(self) -> Result<(), Failure> {
        let exhibits = chosen(&self.names).map_err(Failure::input)?;
        let Some(out) = self.out.filter(|_| !self.list) else {
            let lines: String = exhibits.iter().map(|name| format!("{name}\n")).collect();
            return super::print(&lines);
        };
        let effort = if self.full {
            Effort::Full
        } else {
            Effort::Quick
        };
        interrupt::watch()?;
        let report = Report {
            exhibits,
            effort,
            pause: self.checkpoint,
        };
        report.write(&out, &Terminal).map_err(failure)
    }
}

/// What kind of failure ended the report.
fn failure(error: anyhow::Error) -> Failure {
    let failure = downcast::<Interrupted>(error)
        .or_else(downcast::<WriteError>)
        .or_else(downcast::<FolderError>)
        .or_else(downcast::<ImageError>)
        .or_else(downcast::<FilmError>)
        .or_else(downcast::<RunError<CompactionError>>)
        .or_else(downcast::<RunError<TipError>>)
        .unwrap_or_else(|error| Failure::run(format!("{error:#}")));
    match failure {
        Failure::Interrupted(_) => Failure::ended_early("exhibits were made"),
        failure => failure
            .resume_hint("Then give the same command again; a name after it makes one exhibit."),
    }
}

fn downcast<E>(error: anyhow::Error) -> Result<Failure, anyhow::Error>
where
    E: std::error::Error + Into<Failure> + Send + Sync + 'static,
{
    error.downcast::<E>().map(Into::into)
}

impl From<Interrupted> for Failure {
    fn from(error: Interrupted) -> Self {
        Self::Interrupted(error.to_string())
    }
}
