//! What a fit leaves behind, and what it says.

use super::table::Table;
use crate::command::spool;
use crate::failure::Failure;
use std::path::Path;
use tribos::fit::{Estimate, Fit, FitLaw, Uncertainty};
use tribos::friction::find;
use tribos::record::{number, series_csv, write_atomically};

/// Correlation beyond which two parameters are hardly told apart.
const ENTANGLED: f64 = 0.99;

/// Standard deviations, of its own, by which a reduced χ² may exceed 1.
const BEYOND: f64 = 5.0;

/// A fit with what it came from.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// The law.
    pub law: FitLaw,
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
        let name = if self.table.is_record() {
            self.law.over_time()
        } else {
            self.law.steady()
        };
        let formula = find(name).map_or("", |entry| entry.formula);
        let mut text = format!("law           {name}: {formula}\n");
        for estimate in &self.fit.parameters {
            text += &self.line(estimate);
        }
        text += &self.quality();
        text += &self.undetermined();
        text += &self.entangled();
        text + &format!("as a law      {}\n", self.spec())
    }

    fn line(&self, estimate: &Estimate) -> String {
        let parameter = &estimate.parameter;
        let (value, how) = match &estimate.known {
            Uncertainty::StandardError(error) => value_with_error(estimate.value, *error),
            Uncertainty::Fixed => (plain(estimate.value), "fixed".into()),
            Uncertainty::AtBound => (plain(estimate.value), "at its bound".into()),
            Uncertainty::Undetermined(_) => {
                (format!("{:.3e}", estimate.value), "not determined".into())
            }
        };
        let unit = self.unit(parameter.unit);
        format!(
            "{:<13} {value:<14} {how:<14} [{unit}] {}\n",
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

    /// Of many points: on how many the starts were searched.
    fn sampled(&self) -> String {
        let all = self.fit.predictions.len();
        match self.fit.searched {
            searched if searched == all => String::new(),
            searched => format!(" of a sample of {searched} points; refined on all {all}"),
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
            "residuals     {residuals}\nstarts        {} of {} ended at the best minimum{}\n",
            fit.at_best,
            fit.starts,
            self.sampled()
        );
        let scatter = (2.0 / freedoms as f64).sqrt();
        if fit.is_weighted && fit.deviation() * fit.deviation() > 1.0 + BEYOND * scatter {
            text +=
                "warning       residuals are larger than sigma allows: the law or sigma is wrong\n";
        }
        if fit.at_best == 1 && fit.starts > 1 {
            text += "warning       only one start ended there; try more --starts, or --fix a parameter\n";
        }
        if !fit.converged {
            text += "warning       the search did not converge: standard errors are rough\n";
        }
        text
    }

    /// Parameters of which the data tell nothing, or only a combination.
    fn undetermined(&self) -> String {
        let mut groups: Vec<Vec<&str>> = Vec::new();
        for estimate in &self.fit.parameters {
            if let Uncertainty::Undetermined(others) = &estimate.known {
                let mut group = others.clone();
                group.push(estimate.parameter.name);
                group.sort_unstable();
                if !groups.contains(&group) {
                    groups.push(group);
                }
            }
        }
        let told = groups.iter().map(|group| match group.as_slice() {
            [name] => format!("warning       the data do not determine {name}; give --fix {name}=VALUE\n"),
            names => format!(
                "warning       the data determine only a combination of {}; give --fix NAME=VALUE for one\n",
                names.join(" and ")
            ),
        });
        told.collect()
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
        let known = find(self.law.steady()).map_or(&[][..], |entry| entry.parameters);
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
            self.law.steady(),
            values.collect::<Vec<_>>().join(",")
        )
    }

    /// Writes covariance.csv, residuals.csv and, last, fit.toml.
    pub fn write(&self, out: &Path) -> Result<(), Failure> {
        write_atomically(&out.join("covariance.csv"), self.covariance().as_bytes())?;
        self.write_residuals(&out.join("residuals.csv"))?;
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

    /// A row a point, written as it is made: there may be millions.
    fn write_residuals(&self, file: &Path) -> Result<(), Failure> {
        let mut columns = self.table.columns();
        let friction = self.table.data.friction();
        let pairs = friction.iter().zip(&self.fit.predictions);
        let residuals: Vec<f64> = pairs.map(|(f, p)| f - p).collect();
        columns.push(("prediction", &self.fit.predictions));
        columns.push(("residual", &residuals));
        columns.extend(self.table.data.sigma().map(|sigma| ("sigma", sigma)));
        let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
        spool::deliver(Some(file), |sink| {
            sink.put(&series_csv(&names, []))?;
            for i in 0..friction.len() {
                let cells = columns.iter().filter_map(|(_, values)| values.get(i));
                let cells: Vec<String> = cells.map(|x| number(*x)).collect();
                sink.put(&(cells.join(",") + "\n"))?;
            }
            Ok(())
        })
    }

    fn toml(&self) -> String {
        let fit = self.fit;
        let mut text = format!(
            "# A fit by `tribos fit`: friction of the data less that of the law has the least square.\n\
             # `law` is for --law of `tribos wrench` and --curve of `tribos laws` (steady sliding).\n\
             law = \"{}\"\npoints = {}\ndegrees_of_freedom = {}\nsum_of_squares = {}\n",
            self.spec(),
            fit.predictions.len(),
            fit.freedoms,
            toml_number(fit.cost)
        );
        let quality = if fit.is_weighted {
            format!("reduced_chi_squared = {:?}", fit.deviation().powi(2))
        } else {
            format!("residual_deviation = {:?}", fit.deviation())
        };
        text += &format!(
            "{quality}\nconverged = {}\nstarts = {}\nstarts_at_best = {}\npoints_searched = {}\n",
            fit.converged, fit.starts, fit.at_best, fit.searched
        );
        for estimate in &fit.parameters {
            text += &self.toml_parameter(estimate);
        }
        text
    }

    fn toml_parameter(&self, estimate: &Estimate) -> String {
        let parameter = &estimate.parameter;
        let known = match &estimate.known {
            Uncertainty::StandardError(error) => {
                format!("known = \"fitted\"\nstandard_error = {error:?}\n")
            }
            Uncertainty::Fixed => "known = \"fixed\"\n".into(),
            Uncertainty::AtBound => "known = \"at its bound\"\n".into(),
            Uncertainty::Undetermined(others) => {
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

/// A number as TOML has it.
fn toml_number(x: f64) -> String {
    if x.is_finite() {
        format!("{x:?}")
    } else {
        number(x)
    }
}

/// A value that has no error.
pub fn plain(value: f64) -> String {
    if value == 0.0 {
        "0".into()
    } else {
        format!("{value:.6e}")
    }
}

/// Value and error with two digits of the error.
pub fn value_with_error(value: f64, error: f64) -> (String, String) {
    /// Values that are written without a power of ten.
    const EVERYDAY: std::ops::Range<f64> = 1e-3..1e5;
    /// f64 has no more digits.
    const MOST_DIGITS: f64 = 15.0;
    let power = |x: f64| if x > 0.0 { x.log10().floor() } else { 0.0 };
    if EVERYDAY.contains(&value.abs()) {
        let decimals = (1.0 - power(error)).clamp(0.0, MOST_DIGITS) as usize;
        return (
            format!("{value:.decimals$}"),
            format!("± {error:.decimals$}"),
        );
    }
    let digits = (power(value.abs()) - power(error) + 1.0).clamp(1.0, MOST_DIGITS) as usize;
    (format!("{value:.digits$e}"), format!("± {error:.1e}"))
}
