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
pub mod patches;
pub mod polygons;
pub mod problems;
pub mod scale;

use crate::args::Options;
use crate::written::{self, Sheet};
use std::path::Path;
use std::time::Instant;

/// A front.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Front {
    /// One evaluation of force and torque.
    Kernel,
    /// Calls one by one and in batches.
    Batch,
    /// Every patch, law and tier.
    Patches,
    /// Flat feet with straight edges.
    Polygons,
    /// One stop of a sliding, spinning disk.
    Integrators,
    /// Contacts of packings and their solvers.
    Contacts,
    /// Sweeps of packings from a thousand to a million spheres.
    Scale,
    /// Events, contact dynamics and soft particles.
    Methods,
    /// Contact problems beside Siconos.
    Problems,
    /// Molecular dynamics beside LAMMPS.
    Atoms,
    /// What each item costs a microcontroller.
    Firmware,
}

impl Front {
    /// In the order of the index.
    pub const ALL: [Self; 11] = [
        Self::Kernel,
        Self::Batch,
        Self::Patches,
        Self::Polygons,
        Self::Integrators,
        Self::Contacts,
        Self::Scale,
        Self::Methods,
        Self::Problems,
        Self::Atoms,
        Self::Firmware,
    ];

    /// The order of work: what builds comes before what is timed, and the kernel's front shows
    /// instructions that the firmware's counts.
    const WORK: [Self; 11] = [
        Self::Firmware,
        Self::Kernel,
        Self::Batch,
        Self::Patches,
        Self::Polygons,
        Self::Integrators,
        Self::Contacts,
        Self::Scale,
        Self::Methods,
        Self::Problems,
        Self::Atoms,
    ];

    /// Of the option, and of the front's files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Kernel => "kernel",
            Self::Batch => "batch",
            Self::Patches => "patches",
            Self::Polygons => "polygons",
            Self::Integrators => "integrators",
            Self::Contacts => "contacts",
            Self::Scale => "scale",
            Self::Methods => "methods",
            Self::Problems => "problems",
            Self::Atoms => "atoms",
            Self::Firmware => "firmware",
        }
    }

    /// The heading of its page.
    pub fn title(self) -> &'static str {
        match self {
            Self::Kernel => "Force and torque: speed against error",
            Self::Batch => "One by one and in batches: time, instructions",
            Self::Patches => "Every patch, law and tier: speed, error, size",
            Self::Polygons => "Flat feet: speed against error",
            Self::Integrators => "A disk brought to rest: step, order, error, cost",
            Self::Contacts => "Contacts of packings: speed, residual, size",
            Self::Scale => "Packings up to a million spheres: speed, order, threads, memory",
            Self::Methods => "Three methods: error against time",
            Self::Problems => "Contact problems: speed and reliability beside Siconos",
            Self::Atoms => "Atoms in motion: speed, conserved energy",
            Self::Firmware => "What the kernel costs a microcontroller",
        }
    }
}

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
                counted = Some(rows);
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
        };
        index::enter(&setting, front, &finding)?;
        let seconds = clock.elapsed().as_secs();
        println!("{} ({seconds} s): {}", front.name(), finding.line);
    }
    println!("written to {}", out.display());
    Ok(())
}
