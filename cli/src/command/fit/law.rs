//! `tribos fit --law`: one law, or all of them.

use super::apparatus::{Machine, Spring};
use super::log::Format;
use super::progress::Progress;
use super::table::Table;
use super::usage::{self, As};
use super::{compared, output, plot};
use crate::command::number;
use crate::failure::Failure;
use clap::builder::TypedValueParser;
use std::path::Path;
use std::str::FromStr;
use tribos::fit::{Caution, Fit, FitLaw, FitOptions, FittedLaw, fit_watched};
use tribos::record::LogOptions;
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::image;

/// What is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawChoice {
    /// One law.
    One(FitLaw),
    /// All laws that the data admit.
    All,
}

impl FromStr for LawChoice {
    type Err = tribos::friction::FrictionError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "all" => Ok(Self::All),
            name => name.parse().map(Self::One),
        }
    }
}

/// The names of the laws, and `all`.
pub fn parser() -> impl TypedValueParser<Value = LawChoice> {
    const LAWS: usize = FitLaw::ALL.len();
    let words: [(&'static str, &'static str); LAWS + 1] = std::array::from_fn(|k| {
        let all = ("all", "All of them, compared");
        FitLaw::ALL
            .get(k)
            .map_or(all, |(_, name, help)| (*name, *help))
    });
    number::named(words)
}

/// A fit that was asked for.
#[derive(Debug)]
pub struct Request<'a> {
    pub data: &'a Path,
    pub log: LogOptions,
    pub machine: Machine,
    pub fixed: Vec<(String, f64)>,
    pub starts: usize,
    pub target: Option<As>,
    pub format: Format,
    pub out: Option<&'a Path>,
}

/// Deviation of the residuals with a spring, over that without one, from which on the spring is believed.
const MUCH_BETTER: f64 = 0.8;
/// Files of a fit.
const FILES: [&str; 5] = [
    "covariance.csv",
    "residuals.csv",
    "fit.toml",
    "fit.svg",
    "fit.png",
];

impl Request<'_> {
    /// Fits, writes and prints.
    pub fn execute(self, choice: LawChoice) -> Result<(), Failure> {
        let law = match choice {
            LawChoice::One(law) => law,
            LawChoice::All => return self.compare(),
        };
        let table = Table::read(self.data, &self.log, &self.machine, Some(law))?;
        let mut found = self.fit(&table, law, &self.machine)?;
        found.cautions.extend(self.spring(&table, law, &found));
        let report = output::Report {
            law,
            table: &table,
            fit: &found,
        };
        if let Some(out) = self.out {
            let figure = plot::panels(law, &table.data, &found)?;
            let _folder = OutputFolder::begin(out, &Contents::of("fit", &FILES))?;
            image::write_both(out, "fit", &figure)?;
            report.write(out)?;
        }
        let text = match (self.target, self.format) {
            (Some(target), _) => {
                let parameters = report.values();
                let fitted = FittedLaw {
                    law: law.name(),
                    parameters: &parameters,
                    is_per_load: report.is_per_load(),
                };
                usage::text(target, &fitted)?
            }
            (None, Format::Json) => format!("{:#}\n", report.json()),
            (None, Format::Text) => report.text() + &written(self.out),
        };
        crate::command::print(&text)
    }

    fn fit(&self, table: &Table, law: FitLaw, machine: &Machine) -> Result<Fit, Failure> {
        let fail = |error| table.refusal(error);
        let model = law
            .model_on(&table.data, machine.apparatus())
            .map_err(fail)?;
        let mut progress = Progress::default();
        let mut watch = |at| progress.at(law, at);
        fit_watched(model.as_ref(), &table.data, &self.options(), &mut watch).map_err(fail)
    }

    /// The spring that explains residuals of rate and state, where v is the speed of the load point.
    fn spring(&self, table: &Table, law: FitLaw, found: &Fit) -> Option<Caution> {
        let is_suspect = found.error_factor > 1.0 && table.is_record();
        if !is_suspect || !law.has_age() || self.machine.spring.is_some() {
            return None;
        }
        let machine = Machine {
            spring: Some(Spring::Fitted),
            ..self.machine
        };
        let sprung = self.fit(table, law, &machine).ok()?;
        let is_better = sprung.deviation() < MUCH_BETTER * found.deviation();
        is_better.then(|| Caution::LoadPoint {
            spring: sprung.value("spring").unwrap_or(f64::NAN),
            deviations: [found.deviation(), sprung.deviation()],
        })
    }

    fn options(&self) -> FitOptions {
        FitOptions {
            fixed: self.fixed.clone(),
            starts: self.starts,
        }
    }

    fn compare(&self) -> Result<(), Failure> {
        if self.target.is_some() {
            return Err(Failure::input("--as: choose a law of the comparison first"));
        }
        let table = Table::read(self.data, &self.log, &self.machine, None)?;
        let found = compared::Comparison::of(&table, &self.machine, &self.options())?;
        if let Some(out) = self.out {
            let _folder = OutputFolder::begin(out, &Contents::of("fit", &compared::FILES))?;
            found.write(out)?;
        }
        crate::command::print(&match self.format {
            Format::Json => format!("{:#}\n", found.json()),
            Format::Text => found.text() + &written(self.out),
        })
    }
}

fn written(out: Option<&Path>) -> String {
    out.map(|out| format!("written to    {}\n", out.display()))
        .unwrap_or_default()
}
