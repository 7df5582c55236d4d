//! The fronts of the documentation: each is a page, tables and pictures in one folder.

pub mod atoms;
pub mod batch;
pub mod contacts;
pub mod firmware;
pub mod index;
pub mod integrators;
pub mod kernel;
pub mod made;
pub mod methods;
pub mod modes;
pub mod patches;
mod places;
pub mod polygons;
pub mod problems;
pub mod scale;

use crate::args::Options;
use crate::front::Front;
use crate::written::{self, Sheet};
use std::path::Path;
use std::time::Instant;

/// Output folder of a front, length of its measurements, and text above its tables.
#[derive(Clone, Debug)]
pub struct Setting<'a> {
    /// Folder for the results.
    pub out: &'a Path,
    /// Few rounds.
    pub quick: bool,
    /// Date, machine, compiler and command.
    pub made: &'a str,
}

impl Setting<'_> {
    /// Writes a table as `stem`.csv.
    fn table(&self, stem: &str, sheet: &Sheet) -> Result<(), String> {
        let text = format!("# {}\n{}", self.made, sheet.csv());
        written::write(self.out, &format!("{stem}.csv"), &text)
    }

    /// Writes the page of a front.
    fn page(&self, front: Front, body: &str) -> Result<(), String> {
        let text = format!("# {}\n\n{}.\n\n{body}", front.title(), self.made);
        written::write(self.out, &format!("{}.md", front.name()), &text)
    }
}

/// Summary of a front in one line, and its picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// One line, with the figures of this run.
    pub line: String,
    /// Name of a file beside the page.
    pub picture: &'static str,
}

/// Makes the fronts asked for, and their part of the index.
pub fn run(options: &Options) -> Result<(), String> {
    if options.run_batch_items {
        return batch::run_once();
    }
    let made = made::now(options);
    let (out, fronts) = (options.out(), options.fronts());
    let setting = Setting {
        out: &out,
        quick: options.quick,
        made: &made,
    };
    println!("{made}");
    let mut counted = None;
    let wanted = |front: &Front| fronts.contains(front);
    for front in Front::WORK.into_iter().filter(wanted) {
        let clock = Instant::now();
        let finding = match front {
            Front::Firmware => {
                let (finding, rows) = firmware::run(&setting)?;
                // A quick look has not measured all tiers.
                counted = (!setting.quick).then_some(rows);
                finding
            }
            Front::Kernel => kernel::run(&setting, counted.as_deref())?,
            Front::Batch => batch::run(&setting)?,
            Front::Patches => patches::run(&setting).map_err(|error| error.to_string())?,
            Front::Polygons => polygons::run(&setting)?,
            Front::Integrators => integrators::run(&setting)?,
            Front::Contacts => contacts::run(&setting)?,
            Front::Scale => scale::run(&setting)?,
            Front::Methods => methods::run(&setting)?,
            Front::Problems => problems::run(&setting, &options.problems())?,
            Front::Atoms => atoms::run(&setting)?,
            Front::Modes => modes::run(&setting)?,
        };
        index::enter(&setting, front, &finding)?;
        let seconds = clock.elapsed().as_secs();
        println!("{} ({seconds} s): {}", front.name(), finding.line);
    }
    println!("written to {}", out.display());
    Ok(())
}
