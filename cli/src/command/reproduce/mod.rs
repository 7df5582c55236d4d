//! `tribos reproduce`: the thesis' results, claim by claim.

mod asymptotics;
mod classical;
mod contact_exhibits;
mod contact_laws;
mod contact_thresholds;
mod contact_trials;
mod coupling;
mod creep;
mod deposit;
mod document;
mod double_disk;
mod exhibit;
mod growth;
mod ice;
mod interval;
mod kept;
mod local_law;
mod lubrication;
mod odd;
mod packing;
mod pipe;
mod plan;
mod porosity;
mod pressure;
mod pressure_modes;
mod runs;
mod stopping;
mod stress;
mod tilted;
mod tip;

use super::interrupt;
use super::number;
use crate::failure::Failure;
use crate::folder::{Contents, OutputFolder};
use crate::report::image;
use crate::report::page::{FigureRef, Section};
use crate::report::verdict::Verdict;
use Maker::{Alone, Running};
use document::{claims_csv, counts, page};
use exhibit::Exhibit;
use kept::Kept;
use plan::{Plan, Seconds};
use runs::{Effort, Runs};
use std::path::PathBuf;
use std::time::Duration;
use tribos::record::{series_csv, write_atomically};

/// Reproduce the results of the thesis on friction laws and coupled friction (chapters 2 and 3,
/// section 5.1 and appendix A), on the compaction of cohesive powders (chapter 4) and on torsion
/// friction of atoms (section 5.3): every figure and table as CSV, SVG and PNG, and index.html with
/// the thesis' claims, our numbers, their uncertainty, a verdict and what it rests on, and with films.
///
/// Tells first what it will cost. It may be interrupted at any time: the same command goes on, to the
/// same files, from what DIR/kept has of it. Runs take all cores.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Folder for the report; made if missing; its own files in it are replaced. The folder of a
    /// sweep, or of a run of a powder or a tip, is refused.
    #[arg(long, value_name = "DIR", required_unless_present = "list")]
    out: Option<PathBuf>,
    /// What to reproduce, such as 3.4 or table-3.1; everything if left out.
    names: Vec<String>,
    /// Simulate everything that the thesis shows (4.6, 4.7, table 4.1, 5.2), not a sample of it: about
    /// half an hour on two cores instead of a minute.
    #[arg(long)]
    full: bool,
    /// A sample of what takes long: fewer seeds, coefficients and spheres, shorter times. The
    /// default; the page says where.
    #[arg(long, conflicts_with = "full")]
    quick: bool,
    /// Seconds from one checkpoint of a run to the next.
    #[arg(
        long,
        value_name = "SECONDS",
        default_value = "20",
        value_parser = number::not_negative,
        allow_negative_numbers = true
    )]
    checkpoint: f64,
    /// List the names and stop.
    #[arg(long)]
    list: bool,
}

const EXAMPLES: &str = "\
Examples:
  tribos reproduce --out out/thesis
  tribos reproduce --out out/thesis 3.4 3.13 table-3.1
  tribos reproduce --out out/porosity 4.7 --full
  tribos reproduce --list";

/// Makes one exhibit.
#[derive(Clone, Copy)]
enum Maker {
    /// In a moment.
    Alone(fn() -> Result<Exhibit, Failure>),
    /// From simulations, quick or full; compactions are shared. With the costs of both.
    Running(fn(&Runs) -> Result<Exhibit, Failure>, [Seconds; 2]),
}

/// What takes a moment costs.
const MOMENT: Seconds = 0.1;

impl Maker {
    fn make(self, runs: &Runs) -> Result<Exhibit, Failure> {
        match self {
            Self::Alone(make) => make(),
            Self::Running(make, _) => make(runs),
        }
    }

    fn cost(self, effort: Effort) -> Seconds {
        match (self, effort) {
            (Self::Alone(_), _) => MOMENT,
            (Self::Running(_, [quick, _]), Effort::Quick) => quick,
            (Self::Running(_, [_, full]), Effort::Full) => full,
        }
    }
}

/// All exhibits in the order of the thesis.
const EXHIBITS: &[(&str, Maker)] = &[
    ("2.5", Alone(classical::figure_2_5)),
    ("2.7", Alone(creep::figure_2_7)),
    ("2.8", Alone(lubrication::figure_2_8)),
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
    ("4.2", Alone(contact_exhibits::figure_4_2)),
    ("4.3", Alone(contact_exhibits::figure_4_3)),
    ("4.5", Alone(deposit::figure_4_5)),
    ("4.6", Running(packing::figure_4_6, [15.0, 50.0])),
    ("4.7", Running(porosity::figure_4_7, [75.0, 1000.0])),
    ("table-4.1", Running(stress::table_4_1, [1.0, 170.0])),
    ("section-5.1", Alone(pressure::section_5_1)),
    (
        "section-5.1-modes",
        Alone(pressure_modes::section_5_1_modes),
    ),
    ("5.1", Alone(tip::figure_5_1)),
    ("5.2", Running(tip::figure_5_2, [40.0, 2300.0])),
    ("appendix-a", Alone(odd::appendix_a)),
];

impl Arguments {
    /// Makes the report. Fails if a comparison does: a row that neither holds nor differs as it did before.
    pub fn execute(self) -> Result<(), Failure> {
        self.make().map_err(|failure| {
            if let Failure::Interrupted(_) = failure {
                return interrupt::ended_early("exhibits were made");
            }
            failure.going_on("Then give the same command again; a name after it makes one exhibit.")
        })
    }

    fn make(self) -> Result<(), Failure> {
        let chosen = chosen(&self.names)?;
        let Some(out) = self.out.filter(|_| !self.list) else {
            for (name, _) in chosen {
                super::print(&format!("{name}\n"))?;
            }
            return Ok(());
        };
        let effort = if self.full {
            Effort::Full
        } else {
            Effort::Quick
        };
        interrupt::watch()?;
        let files = ["index.html", "claims.csv"];
        let folder = OutputFolder::go_on(&out, &Contents::of("reproduce", &files))?;
        let pause = Duration::try_from_secs_f64(self.checkpoint).unwrap_or(Duration::MAX);
        let runs = Runs::new(effort, Kept::open(folder.lock().clone(), pause)?);
        let sections = sections(&folder, &chosen, &runs)?;
        let all = counts(sections.iter().flat_map(|section| &section.claims));
        let failed = sections.iter().flat_map(|section| &section.claims);
        let failed = failed.filter(|claim| claim.verdict == Verdict::Failed);
        let failed: Vec<String> = failed.map(|claim| claim.statement.clone()).collect();
        folder.check()?;
        write_atomically(&out.join("claims.csv"), claims_csv(&sections).as_bytes())?;
        write_atomically(
            &out.join("index.html"),
            page(sections, effort).html().as_bytes(),
        )?;
        let page = out.join("index.html");
        super::print(&format!(
            "{:<17} {}\nopen {}\n",
            "together",
            all.words(),
            page.display()
        ))?;
        if failed.is_empty() {
            return Ok(());
        }
        Err(Failure::run(format!(
            "{} comparisons failed for no known reason: {}",
            failed.len(),
            failed.join("; ")
        )))
    }
}

/// The sections in order: those that are finished as they are kept, the others made now.
fn sections(
    folder: &OutputFolder,
    chosen: &[(&'static str, Maker)],
    runs: &Runs,
) -> Result<Vec<Section>, Failure> {
    let (effort, kept) = (runs.effort(), runs.kept());
    let mut finished: Vec<Option<Section>> = chosen
        .iter()
        .map(|(name, _)| kept.section(name, effort))
        .collect();
    let missing = chosen
        .iter()
        .zip(&finished)
        .filter(|(_, kept)| kept.is_none());
    let cost = |(_, maker): &(&str, Maker)| maker.cost(effort);
    let mut plan = Plan::new(missing.clone().map(|(exhibit, _)| cost(exhibit)).sum());
    let count = missing.count();
    super::tell(format_args!(
        "{count} of {} exhibits to make, about {} on this machine ({})",
        chosen.len(),
        plan::told(plan.whole()),
        effort.name()
    ));
    for (exhibit, slot) in chosen.iter().zip(&mut finished) {
        let (name, maker) = exhibit;
        if interrupt::is_asked() {
            return Err(interrupt::ended_early("exhibits were made"));
        }
        let left = match slot {
            Some(section) => {
                super::print(&format!(
                    "{name:<17} {}, kept\n",
                    counts(&section.claims).words()
                ))?;
                continue;
            }
            None => {
                let section = write_exhibit(folder, name, maker.make(runs)?)?;
                kept.keep(name, effort, &section)?;
                super::print(&format!("{name:<17} {}\n", counts(&section.claims).words()))?;
                *slot = Some(section);
                plan.finish(cost(exhibit))
            }
        };
        if !left.is_zero() {
            super::tell(format_args!("about {} left", plan::told(left)));
        }
    }
    Ok(finished.into_iter().flatten().collect())
}

/// Names of all exhibits, in the order of the thesis.
pub fn names() -> impl Iterator<Item = &'static str> {
    EXHIBITS.iter().map(|(name, _)| *name)
}

/// The exhibits that the names mean; `fig3.4`, `figure-3.4` and `3.4` are the same.
fn chosen(names: &[String]) -> Result<Vec<(&'static str, Maker)>, Failure> {
    if names.is_empty() {
        return Ok(EXHIBITS.to_vec());
    }
    let plain = |name: &str| {
        let lower = name.to_lowercase().replace(['-', '_', ' '], "");
        ["figure", "fig"]
            .iter()
            .fold(lower, |name, word| name.replace(word, ""))
    };
    names
        .iter()
        .map(|name| {
            EXHIBITS
                .iter()
                .find(|(known, _)| plain(known) == plain(name))
                .copied()
                .ok_or_else(|| {
                    let all: Vec<&str> = EXHIBITS.iter().map(|(known, _)| *known).collect();
                    Failure::input(format!(
                        "`{name}` is unknown; the names are {}",
                        all.join(", ")
                    ))
                })
        })
        .collect()
}

/// Writes the exhibit's files and makes its section of the page.
fn write_exhibit(folder: &OutputFolder, name: &str, exhibit: Exhibit) -> Result<Section, Failure> {
    let out = folder.path();
    let stem = match name.chars().next() {
        Some('2'..='5') => format!("figure-{name}"),
        _ => name.to_owned(),
    };
    let files = ["csv", "svg", "png"].map(|ending| format!("{stem}.{ending}"));
    folder.add(&files.each_ref().map(String::as_str))?;
    let rows = exhibit.rows.iter().map(Vec::as_slice);
    let csv = series_csv(&exhibit.columns, rows);
    write_atomically(&out.join(format!("{stem}.csv")), csv.as_bytes())?;
    let svg = image::write_both(out, &stem, exhibit.drawing.as_ref())?;
    Ok(Section {
        id: stem,
        heading: exhibit.heading,
        text: exhibit.text,
        figure: Some(FigureRef {
            svg,
            files: files.to_vec(),
            caption: exhibit.caption,
        }),
        film: exhibit.film.map(|film| film.fragment()),
        claims: exhibit.claims,
    })
}

#[cfg(test)]
mod tests;
