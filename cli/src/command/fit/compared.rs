//! `tribos fit --law all`: all laws on the same data.

use super::apparatus::Machine;
use super::output::{Report, shown_value};
use super::progress::Progress;
use super::table::Table;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::Path;
use tribos::fit::{Compared, FitError, FitLaw, FitOptions, compare};
use tribos::record::{json_number, number, write_atomically};

/// Files of a comparison.
pub const FILES: [&str; 2] = ["laws.csv", "laws.json"];

/// The laws, the best first, and those that these data do not admit.
#[derive(Debug)]
pub struct Comparison<'a> {
    table: &'a Table,
    laws: Vec<Compared>,
    refused: Vec<(FitLaw, FitError)>,
}

impl<'a> Comparison<'a> {
    /// Fits all laws.
    pub fn of(
        table: &'a Table,
        machine: &'a Machine,
        options: &FitOptions,
    ) -> Result<Self, Failure> {
        let mut progress = Progress::default();
        let mut watch = |law, at| progress.at(law, at);
        let apparatus = machine.apparatus();
        let (laws, refused) = compare(&table.data, apparatus, options, &mut watch);
        if laws.is_empty() {
            let first = refused.into_iter().next();
            let why = first.map_or("no law".into(), |(_, error)| error.to_string());
            return Err(Failure::input(format!("no law can be fitted: {why}")));
        }
        Ok(Self {
            table,
            laws,
            refused,
        })
    }

    /// For the person at the terminal.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for line in &self.table.told {
            text += &format!("read          {line}\n");
        }
        text += &format!(
            "{:<16} {:>10} {:>10} {:>10} {:>8}  parameters\n",
            "law", "rms", "foretold", "AIC", "starts"
        );
        for one in &self.laws {
            let fit = &one.fit;
            let foretold = if one.foretold.is_nan() {
                "-".into()
            } else {
                shown_value(one.foretold)
            };
            let values = fit.parameters.iter().map(|estimate| {
                format!(
                    "{} {}",
                    estimate.parameter.name,
                    shown_value(estimate.value)
                )
            });
            text += &format!(
                "{:<16} {:>10} {foretold:>10} {:>10} {:>8}  {}\n",
                one.law.name(),
                shown_value(self.rms(one)),
                format!("{:+.1}", one.akaike),
                format!("{}/{}", fit.at_best, fit.starts),
                values.collect::<Vec<_>>().join(", ")
            );
        }
        text += &format!("best          {}", self.laws[0].law.name());
        let alike: Vec<&str> = self.alike().map(FitLaw::name).collect();
        text += &match alike.as_slice() {
            [] => "; the others foretell worse\n".to_owned(),
            names => format!("; the data cannot tell it from {}\n", names.join(", ")),
        };
        if self.laws[0].fit.error_factor > 1.0 {
            text += "warning       residuals of the best law follow each other: it lacks something too\n";
        }
        for (law, why) in &self.refused {
            text += &format!("left out      {}: {why}\n", law.name());
        }
        text
    }

    /// Laws that the data do not tell from the best one.
    fn alike(&self) -> impl Iterator<Item = FitLaw> + '_ {
        let others = self.laws.iter().skip(1);
        others.filter(|one| !one.is_told_apart).map(|one| one.law)
    }

    /// Root mean square of the residuals.
    fn rms(&self, one: &Compared) -> f64 {
        self.report(one).rms()
    }

    fn report<'b>(&'b self, one: &'b Compared) -> Report<'b> {
        Report {
            law: one.law,
            table: self.table,
            fit: &one.fit,
        }
    }

    /// The same for programs.
    pub fn json(&self) -> Value {
        let laws = self.laws.iter().map(|one| {
            let mut law = self.report(one).json();
            law["foretold"] = json_number(one.foretold);
            law["akaike"] = json_number(one.akaike);
            law["told_apart"] = json!(one.is_told_apart);
            law
        });
        let left_out = self
            .refused
            .iter()
            .map(|(law, why)| json!({"law": law.name(), "why": why.to_string()}));
        json!({
            "best": self.laws[0].law.name(),
            "alike": self.alike().map(FitLaw::name).collect::<Vec<_>>(),
            "laws": laws.collect::<Vec<_>>(),
            "left_out": left_out.collect::<Vec<_>>(),
        })
    }

    /// Writes laws.csv and, last, laws.json.
    pub fn write(&self, out: &Path) -> Result<(), Failure> {
        let mut text = "law,parameters,rms,foretold,akaike,told_apart\n".to_owned();
        for one in &self.laws {
            text += &format!(
                "{},{},{},{},{},{}\n",
                one.law.name(),
                one.fit.parameters.len(),
                number(self.rms(one)),
                number(one.foretold),
                number(one.akaike),
                one.is_told_apart
            );
        }
        write_atomically(&out.join("laws.csv"), text.as_bytes())?;
        let json = format!("{:#}\n", self.json());
        Ok(write_atomically(&out.join("laws.json"), json.as_bytes())?)
    }
}
