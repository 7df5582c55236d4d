//! The results of the thesis, claim by claim: figures, tables and sections recomputed, each claim
//! with the thesis' number, ours, and a verdict.

mod effort;
mod provenance;

// The tests of these stand beside the library, which is long to compile.
#[doc(hidden)]
pub mod asperities;
#[doc(hidden)]
pub mod coverage;
#[doc(hidden)]
pub mod document;
#[doc(hidden)]
pub mod exhibit;
#[doc(hidden)]
pub mod exhibits;
#[doc(hidden)]
pub mod front;
#[doc(hidden)]
pub mod fronts;
#[doc(hidden)]
pub mod plan;
#[doc(hidden)]
pub mod reference_integration;
#[doc(hidden)]
pub mod runs;
#[doc(hidden)]
pub mod section_cache;
#[doc(hidden)]
pub mod text;

use Maker::{Alone, Checked, Running};
use anyhow::{Result, bail, ensure};
use document::{claims_csv, counts, site};
pub use effort::Effort;
use exhibit::Exhibit;
use exhibits::*;
use plan::{Plan, Seconds};
use runs::Runs;
use section_cache::SectionCache;
use std::fmt;
use std::path::Path;
use std::time::{Duration, Instant};
use tribos::record::{series_csv, write_atomically};
use tribos::run::folder::{Contents, OutputFolder};
use tribos::run::{PackingRunError, RunError};
use tribos::tip::TipError;
use tribos_report::image;
use tribos_report::page::{FigureRef, Section};
use tribos_report::verdict::Verdict;

/// Makes one exhibit.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum Maker {
    /// In a moment.
    Alone(fn() -> Result<Exhibit>),
    /// In seconds: journeys, and bodies on points that check them.
    Checked(fn() -> Result<Exhibit>, Seconds),
    /// From simulations, quick or full; compactions are shared. With the costs of both.
    Running(fn(&Runs) -> Result<Exhibit>, [Seconds; 2]),
}

/// What takes a moment costs.
const MOMENT: Seconds = 0.1;

impl Maker {
    fn make(self, runs: &Runs) -> Result<Exhibit> {
        match self {
            Self::Alone(make) | Self::Checked(make, _) => make(),
            Self::Running(make, _) => make(runs),
        }
    }

    fn cost(self, effort: Effort) -> Seconds {
        match (self, effort) {
            (Self::Alone(_), _) => MOMENT,
            (Self::Checked(_, cost), _) => cost,
            (Self::Running(_, [quick, _]), Effort::Quick) => quick,
            (Self::Running(_, [_, full]), Effort::Full) => full,
        }
    }
}

/// All exhibits in the order of the thesis.
#[doc(hidden)]
pub const EXHIBITS: &[(&str, Maker)] = &[
    ("section-2.1", Alone(leonardo::section_2_1)),
    ("2.5", Alone(classical::figure_2_5)),
    ("2.7", Alone(creep::figure_2_7)),
    ("section-2.3", Alone(stick_slip::section_2_3)),
    ("2.8", Alone(lubrication::figure_2_8)),
    ("section-3.1", Alone(onset::section_3_1)),
    ("3.1", Checked(ring_and_disk::figure_3_1, 0.4)),
    ("section-3.1-board", Checked(board::section_3_1_board, 0.8)),
    (
        "section-3.1-inverse",
        Checked(inverse::section_3_1_inverse, 0.7),
    ),
    ("3.3", Alone(local_law::figure_3_3)),
    ("3.4", Alone(coupling::figure_3_4)),
    ("table-3.1", Alone(asymptotics::table_3_1)),
    ("3.6", Alone(growth::figure_3_6)),
    ("3.7", Alone(growth::figure_3_7)),
    ("3.8", Alone(growth::figure_3_8)),
    ("3.9", Alone(interval::figure_3_9)),
    ("table-3.2", Alone(interval::table_3_2)),
    ("3.10", Alone(interval::figure_3_10)),
    ("3.11", Alone(stopping::figure_3_11)),
    ("3.13", Alone(double_disk::figure_3_13)),
    ("3.16", Alone(tilted::figure_3_16)),
    ("3.17", Alone(pipe::figure_3_17)),
    ("3.19", Alone(ice::figure_3_19)),
    ("section-3.5.2", Checked(curling::section_3_5_2, 1.7)),
    ("section-4.1", Running(settling::section_4_1, [4.0, 300.0])),
    ("section-4.2", Running(reloading::section_4_2, [5.0, 200.0])),
    ("4.2", Alone(contact_exhibits::figure_4_2)),
    ("4.3", Alone(contact_exhibits::figure_4_3)),
    (
        "section-4.4.1",
        Running(three_methods::section_4_4_1, [3.0, 300.0]),
    ),
    (
        "section-4.4.2",
        Running(sweeps::section_4_4_2, [2.0, 300.0]),
    ),
    ("4.5", Alone(deposit::figure_4_5)),
    ("4.6", Running(packing::figure_4_6, [15.0, 50.0])),
    ("4.7", Running(porosity::figure_4_7, [75.0, 1000.0])),
    ("table-4.1", Running(stress::table_4_1, [1.0, 170.0])),
    (
        "section-4.6-choices",
        Running(choices::section_4_6_choices, [3.0, 3.0]),
    ),
    ("section-5.1", Alone(pressure::section_5_1)),
    (
        "section-5.1-modes",
        Alone(pressure_modes::section_5_1_modes),
    ),
    (
        "section-5.1-lateral",
        Checked(lateral_modes::section_5_1_lateral, 0.7),
    ),
    (
        "section-5.2",
        Running(outlook::section_5_2, [5.0, 15_000.0]),
    ),
    ("5.1", Alone(tip::figure_5_1)),
    ("5.2", Running(tip::figure_5_2, [44.0, 2300.0])),
    ("section-5.3", Running(tip_slid::section_5_3, [10.0, 400.0])),
    (
        "section-5.3-map",
        Running(tip_map::section_5_3_map, [15.0, 3600.0]),
    ),
    (
        "section-5.3-metals",
        Running(tip_metals::section_5_3_metals, [15.0, 300.0]),
    ),
    ("appendix-a", Alone(odd::appendix_a)),
    ("appendix-b", Running(films::appendix_b, [1.0, 10.0])),
];

/// Who follows a report while it is made.
pub trait Reader: Sync {
    /// An exhibit is made, or the whole report: a line for standard output.
    fn result(&self, line: fmt::Arguments<'_>);
    /// How far the work is: a line for people.
    fn progress(&self, line: fmt::Arguments<'_>);
    /// Whether the work is to end; what is finished is kept.
    fn is_cancelled(&self) -> bool;
}

/// The reader cancelled the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("interrupted while exhibits were made")]
pub struct Interrupted;

/// Whether the reader cancelled the report: between exhibits, or within a run.
pub fn is_interruption(error: &anyhow::Error) -> bool {
    fn is_cancelled<E: std::error::Error + Send + Sync + 'static>(error: &anyhow::Error) -> bool {
        use RunError::{Cancelled, CancelledEarly};
        matches!(
            error.downcast_ref::<RunError<E>>(),
            Some(Cancelled(_) | CancelledEarly)
        )
    }
    error.is::<Interrupted>()
        || is_cancelled::<PackingRunError>(error)
        || is_cancelled::<TipError>(error)
}

/// A name that is no exhibit's.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is unknown; the names are {all}", all = names().collect::<Vec<_>>().join(", "))]
pub struct UnknownName(String);

/// What is to be reproduced, and how.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Report {
    /// Names of exhibits, in their order; see [`chosen`].
    pub exhibits: Vec<&'static str>,
    /// How much is computed.
    pub effort: Effort,
    /// Time from one checkpoint of a run to the next.
    pub pause: Duration,
}

impl Report {
    /// Writes the report into a folder, or goes on with one that was interrupted. Fails if a
    /// comparison does: a row that neither holds nor differs for a known cause.
    pub fn write(&self, out: &Path, reader: &dyn Reader) -> Result<()> {
        let started = Instant::now();
        let files = ["index.html", "claims.csv"];
        let folder = OutputFolder::reopen(out, &Contents::of("reproduce", &files))?;
        let kept = SectionCache::open(folder.lock().clone(), self.pause)?;
        let runs = Runs::new(self.effort, kept, reader);
        let sections = self.sections(&folder, &runs, reader)?;
        let claims = || sections.iter().flat_map(|section| &section.claims);
        let all = counts(claims());
        let failed: Vec<String> = claims()
            .filter(|claim| claim.verdict == Verdict::Failed)
            .map(|claim| claim.statement.clone())
            .collect();
        folder.check()?;
        write_atomically(&out.join("claims.csv"), claims_csv(&sections).as_bytes())?;
        let site = site(sections, self.effort, started.elapsed())?;
        for (name, page) in site.pages() {
            folder.add(&[name])?;
            write_atomically(&out.join(name), page.as_bytes())?;
        }
        let (together, seconds) = (all.words(), started.elapsed().as_secs());
        reader.result(format_args!("{:<17} {together}", "together"));
        reader.progress(format_args!("made in {seconds} s"));
        reader.result(format_args!("open {}", out.join("index.html").display()));
        ensure!(
            failed.is_empty(),
            "{} comparisons failed for no known reason: {}",
            failed.len(),
            failed.join("; ")
        );
        Ok(())
    }

    /// The sections in order: those that are finished as they are kept, the others made now.
    fn sections(
        &self,
        folder: &OutputFolder,
        runs: &Runs<'_>,
        reader: &dyn Reader,
    ) -> Result<Vec<Section>> {
        let (effort, kept) = (self.effort, runs.kept());
        let chosen = EXHIBITS
            .iter()
            .filter(|(name, _)| self.exhibits.contains(name));
        let chosen: Vec<_> = chosen
            .map(|(name, maker)| (*name, *maker, kept.section(name, effort)))
            .collect();
        let missing = chosen.iter().filter(|(_, _, kept)| kept.is_none());
        let costs = missing.clone().map(|(_, maker, _)| maker.cost(effort));
        let mut plan = Plan::new(costs.sum());
        reader.progress(format_args!(
            "{} of {} exhibits to make, about {} on this machine ({})",
            missing.count(),
            chosen.len(),
            plan::told(plan.whole()),
            effort.name()
        ));
        let mut sections = Vec::new();
        for (name, maker, finished) in chosen {
            if reader.is_cancelled() {
                return Err(Interrupted.into());
            }
            if let Some(section) = finished {
                let words = counts(&section.claims).words();
                reader.result(format_args!("{name:<17} {words}, kept"));
                sections.push(section);
                continue;
            }
            let section = write_exhibit(folder, (name, effort), maker.make(runs)?)?;
            kept.keep(name, effort, &section)?;
            let words = counts(&section.claims).words();
            reader.result(format_args!("{name:<17} {words}"));
            sections.push(section);
            let left = plan.finish(maker.cost(effort));
            if !left.is_zero() {
                reader.progress(format_args!("about {} left", plan::told(left)));
            }
        }
        Ok(sections)
    }
}

/// Names of all exhibits, in the order of the thesis.
pub fn names() -> impl Iterator<Item = &'static str> {
    EXHIBITS.iter().map(|(name, _)| *name)
}

/// The exhibits that the names mean, all if there are none; `fig3.4`, `figure-3.4` and `3.4` are the
/// same.
pub fn chosen(given: &[String]) -> Result<Vec<&'static str>, UnknownName> {
    let plain = |name: &str| {
        let lower = name.to_lowercase().replace(['-', '_', ' '], "");
        ["figure", "fig"]
            .iter()
            .fold(lower, |name, word| name.replace(word, ""))
    };
    if given.is_empty() {
        return Ok(names().collect());
    }
    given
        .iter()
        .map(|name| {
            let mut all = names();
            let known = all.find(|known| plain(known) == plain(name));
            known.ok_or_else(|| UnknownName(name.clone()))
        })
        .collect()
}

/// Writes the exhibit's files and makes its section of the page.
fn write_exhibit(
    folder: &OutputFolder,
    (name, effort): (&str, Effort),
    exhibit: Exhibit,
) -> Result<Section> {
    let out = folder.path();
    if let Some(text) = exhibit.unfilled() {
        bail!("a text of {name} has a placeholder without a value: {text}");
    }
    let stem = match name.chars().next() {
        Some('2'..='5') => format!("figure-{name}"),
        _ => name.to_owned(),
    };
    let mut files = ["csv", "svg", "png"]
        .map(|ending| format!("{stem}.{ending}"))
        .to_vec();
    files.extend(exhibit.pages.iter().map(|(name, _)| name.clone()));
    folder.add(&files.iter().map(String::as_str).collect::<Vec<_>>())?;
    let rows = exhibit.rows.iter().map(Vec::as_slice);
    let made = provenance::line(name, effort, &exhibit.seeds, &exhibit.source);
    let head = made.replace('`', "");
    let csv = format!("# {head}\n{}", series_csv(&exhibit.columns, rows));
    write_atomically(&out.join(format!("{stem}.csv")), csv.as_bytes())?;
    for (name, film) in &exhibit.pages {
        write_atomically(&out.join(name), film.page().as_bytes())?;
    }
    let svg = image::write_both(out, &stem, exhibit.drawing.as_ref())?;
    Ok(Section {
        id: stem,
        heading: exhibit.prose.heading,
        made,
        text: exhibit.prose.paragraphs,
        figure: Some(FigureRef {
            svg,
            files,
            caption: exhibit.prose.caption,
        }),
        film: exhibit.film.map(|film| film.fragment()),
        claims: exhibit.claims,
    })
}
