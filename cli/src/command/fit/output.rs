//! What a fit leaves behind, and what it says.

use super::Law;
use super::table::Table;
use crate::command::laws;
use crate::failure::Failure;
use std::path::Path;
use tribos::fit::{Estimate, Fit, Known};
use tribos::record::{number, series_csv, write_atomically};

/// Correlation beyond which two parameters are hardly told apart.
const ENTANGLED: f64 = 0.99;

/// A fit with what it came from.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// The law.
    pub law: Law,
    /// The measurements.
    pub table: &'a Table,
    /// The result.
    pub fit: &'a Fit,
    /// Whether friction was divided by the load.
    pub is_per_load: bool,
}

impl Report<'_> {
    /// For the person at the terminal.
    pub fn text(&self) -> String {
        let formula = laws::find(self.law.catalogued()).map_or("", |entry| entry.formula);
        let mut text = format!("law           {}: {formula}\n", self.law.catalogued());
        for estimate in &self.fit.parameters {
            text += &self.line(estimate);
        }
        text += &self.quality();
        text += &self.entangled();
        text + &format!("as a law      {}\n", self.spec())
    }

    fn line(&self, estimate: &Estimate) -> String {
        let parameter = &estimate.parameter;
        let (value, how) = match &estimate.known {
            Known::StandardError(error) => told(estimate.value, *error),
            Known::Fixed => (format!("{:.6e}", estimate.value), "fixed".into()),
            Known::AtBound => (format!("{:.6e}", estimate.value), "at its bound".into()),
            Known::Undetermined(others) if others.is_empty() => {
                let how = format!("not determined; give --fix {}=VALUE", parameter.name);
                (format!("{:.3e}", estimate.value), how)
            }
            Known::Undetermined(others) => {
                let how = format!(
                    "not determined: the data fix only a combination with {}; give --fix {}=VALUE",
                    others.join(", "),
                    parameter.name
                );
                (format!("{:.3e}", estimate.value), how)
            }
        };
        let unit = self.unit(parameter.unit);
        format!(
            "{:<13} {value:<15} {how:<16} [{unit}] {}\n",
            parameter.name, parameter.meaning
        )
    }

    /// The unit, per load if friction is.
    fn unit(&self, unit: &'static str) -> &'static str {
        match (self.is_per_load, unit) {
            (true, "N") => "-",
            (true, "N/m") => "1/m",
            (true, "N s/m") => "s/m",
            _ => unit,
        }
    }

    fn quality(&self) -> String {
        let fit = self.fit;
        let freedoms = fit.freedoms;
        let residuals = if fit.is_weighted {
            format!(
                "reduced chi^2 {:.4} over {freedoms} degrees of freedom",
                fit.deviation().powi(2)
            )
        } else {
            format!(
                "{:.3e} in the root mean square over {freedoms} degrees of freedom",
                fit.deviation()
            )
        };
        let mut text = format!(
            "residuals     {residuals}\nstarts        {} of {} ended at the best minimum\n",
            fit.at_best, fit.starts
        );
        if fit.at_best == 1 && fit.starts > 1 {
            text += "warning       only one start ended there; try more --starts, or --fix a parameter\n";
        }
        if !fit.converged {
            text += "warning       the search did not come to its end: standard errors are rough\n";
        }
        text
    }

    /// Pairs that the data hardly tell apart.
    fn entangled(&self) -> String {
        let names: Vec<&str> = self.fit.determined().map(|e| e.parameter.name).collect();
        let mut text = String::new();
        for b in 0..names.len() {
            for a in 0..b {
                let correlation = self.fit.correlation(a, b);
                if correlation.abs() > ENTANGLED {
                    text += &format!(
                        "warning       correlation of {} and {} is {correlation:.4}: the data hardly \
                         tell these apart; fix one\n",
                        names[a], names[b]
                    );
                }
            }
        }
        text
    }

    /// The law as other commands take it: its steady form.
    fn spec(&self) -> String {
        let known = laws::find(self.law.catalogued()).map_or(&[][..], |entry| entry.parameters);
        let values = known.iter().filter_map(|parameter| {
            // Steady sliding does not depend on the memory length.
            let value = self
                .fit
                .value(parameter.name)
                .or((parameter.name == "dc").then_some(1.0))?;
            Some(format!("{}={value:?}", parameter.name))
        });
        format!(
            "{}:{}",
            self.law.catalogued(),
            values.collect::<Vec<_>>().join(",")
        )
    }

    /// Writes covariance.csv, residuals.csv and, last, fit.toml.
    pub fn write(&self, out: &Path) -> Result<(), Failure> {
        write_atomically(&out.join("covariance.csv"), self.covariance().as_bytes())?;
        write_atomically(&out.join("residuals.csv"), self.residuals().as_bytes())?;
        Ok(write_atomically(
            &out.join("fit.toml"),
            self.toml().as_bytes(),
        )?)
    }

    /// A row and a column for each parameter with a standard error.
    fn covariance(&self) -> String {
        let names: Vec<&str> = self.fit.determined().map(|e| e.parameter.name).collect();
        let mut text = format!("parameter,{}\n", names.join(","));
        for (name, row) in names.iter().zip(self.fit.covariance.row_iter()) {
            let cells: Vec<String> = row.iter().map(|x| number(*x)).collect();
            text += &format!("{name},{}\n", cells.join(","));
        }
        text
    }

    fn residuals(&self) -> String {
        let mut columns = self.table.columns();
        let friction = columns.last().map_or(&[][..], |(_, values)| *values);
        let pairs = friction.iter().zip(&self.fit.predictions);
        let residuals: Vec<f64> = pairs.map(|(f, p)| f - p).collect();
        columns.push(("prediction", &self.fit.predictions));
        columns.push(("residual", &residuals));
        columns.extend(self.table.sigma().map(|sigma| ("sigma", sigma)));
        let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
        let rows: Vec<Vec<f64>> = (0..friction.len())
            .map(|i| {
                columns
                    .iter()
                    .filter_map(|(_, values)| values.get(i).copied())
                    .collect()
            })
            .collect();
        series_csv(&names, rows.iter().map(Vec::as_slice))
    }

    fn toml(&self) -> String {
        let fit = self.fit;
        let mut text = format!(
            "# A fit by `tribos fit`: friction of the data less that of the law has the least square.\n\
             # `law` is for --law of `tribos wrench` and --curve of `tribos laws` (steady sliding).\n\
             law = \"{}\"\npoints = {}\ndegrees_of_freedom = {}\nsum_of_squares = {:?}\n",
            self.spec(),
            fit.predictions.len(),
            fit.freedoms,
            fit.cost
        );
        let quality = if fit.is_weighted {
            format!("reduced_chi_squared = {:?}", fit.deviation().powi(2))
        } else {
            format!("residual_deviation = {:?}", fit.deviation())
        };
        text += &format!(
            "{quality}\nconverged = {}\nstarts = {}\nstarts_at_best = {}\n",
            fit.converged, fit.starts, fit.at_best
        );
        for estimate in &fit.parameters {
            text += &self.toml_parameter(estimate);
        }
        text
    }

    fn toml_parameter(&self, estimate: &Estimate) -> String {
        let parameter = &estimate.parameter;
        let known = match &estimate.known {
            Known::StandardError(error) => {
                format!("known = \"fitted\"\nstandard_error = {error:?}\n")
            }
            Known::Fixed => "known = \"fixed\"\n".into(),
            Known::AtBound => "known = \"at its bound\"\n".into(),
            Known::Undetermined(others) => {
                format!("known = \"not determined\"\ntrades_with = {others:?}\n")
            }
        };
        format!(
            "\n[parameters.{}]    # {}\nvalue = {:?}\nunit = \"{}\"\n{known}",
            parameter.name,
            parameter.meaning,
            estimate.value,
            self.unit(parameter.unit)
        )
    }
}

/// Value and error with as many digits as the error tells.
fn told(value: f64, error: f64) -> (String, String) {
    /// Two digits of the error; f64 has no more than 16 of a value.
    const MOST_DIGITS: f64 = 16.0;
    let digits = if error > 0.0 && value != 0.0 {
        ((value.abs() / error).log10().floor() + 1.0).clamp(1.0, MOST_DIGITS)
    } else {
        MOST_DIGITS
    };
    (
        format!("{value:.*e}", digits as usize),
        format!("± {error:.1e}"),
    )
}
