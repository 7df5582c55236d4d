//! What a fit leaves behind, and what it says.

use super::table::Table;
use crate::command::spool;
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::Path;
use tribos::fit::{Estimate, Fit, FitLaw, FitParameter, FittedLaw, Uncertainty};
use tribos::record::{json_number, number, series_csv, significant, write_atomically};

/// A fit with what it came from.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// The law.
    pub law: FitLaw,
    /// The measurements.
    pub table: &'a Table,
    /// The result.
    pub fit: &'a Fit,
}

impl Report<'_> {
    /// For the person at the terminal.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for line in &self.table.told {
            text += &format!("read          {line}\n");
        }
        let formula = self.law.formula(self.table.is_record());
        text += &format!("law           {}: {formula}\n", self.law.name());
        for estimate in &self.fit.parameters {
            text += &line(estimate, &self.unit(&estimate.parameter));
        }
        text += &self.quality();
        for caution in &self.fit.cautions {
            text += &format!("warning       {caution}\n");
        }
        match self.spec() {
            Some(spec) => text + &format!("as a law      {spec}\n"),
            None => text,
        }
    }

    /// Whether parameters are per load, as coefficients are: friction was a force at known loads.
    pub fn is_per_load(&self) -> bool {
        let is_force = self.table.units[0].is_some_and(|unit| unit != "-");
        let per_load = self.law.is_per_load(&self.table.data, self.fit);
        per_load && (!is_force || self.table.data.load().is_some())
    }

    /// The unit of a parameter: per load if loads are known, else that of the friction in the file; what the machine adds
    /// stays a force.
    fn unit(&self, parameter: &FitParameter) -> String {
        let is_own = !matches!(parameter.name, "inertia" | "offset" | "adhesion");
        let [force, speed] = self.table.units;
        let force = force.filter(|unit| *unit != "-");
        let unit = if self.table.data.load().is_some() && is_own {
            per_load(parameter.unit).to_owned()
        } else {
            force.map_or(parameter.unit.to_owned(), |force| {
                of_force(parameter, force)
            })
        };
        match (speed, unit.as_str(), unit.strip_suffix("/m")) {
            (Some("rad/s"), "m/s", _) => "rad/s".to_owned(),
            (Some("rad/s"), _, Some(first)) => format!("{first}/rad"),
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
        format!(
            "residuals     {residuals}\nstarts        {} of {} ended at the best minimum{}\n",
            fit.at_best,
            fit.starts,
            self.sampled()
        )
    }

    /// Names and values of all parameters.
    pub fn values(&self) -> Vec<(&'static str, f64)> {
        let all = self.fit.parameters.iter();
        all.map(|estimate| (estimate.parameter.name, estimate.value))
            .collect()
    }

    /// The law as other commands take it: its steady form.
    fn spec(&self) -> Option<String> {
        let parameters = self.values();
        let fitted = FittedLaw {
            law: self.law.name(),
            parameters: &parameters,
            is_per_load: self.is_per_load(),
        };
        fitted.spec().ok().flatten()
    }

    /// Root mean square of the residuals, in the unit of friction.
    pub fn rms(&self) -> f64 {
        let pairs = self.table.data.friction().iter().zip(&self.fit.predictions);
        let sum: f64 = pairs.map(|(f, p)| (f - p) * (f - p)).sum();
        (sum / self.fit.predictions.len() as f64).sqrt()
    }

    /// The same for programs.
    pub fn json(&self) -> Value {
        let parameters = self.fit.parameters.iter();
        let parameters =
            parameters.map(|estimate| parameter_json(estimate, &self.unit(&estimate.parameter)));
        let dropped: u64 = self.table.dropped.iter().map(|(_, count)| count).sum();
        let reasons = self.table.dropped.iter();
        let reasons = reasons.map(|(why, count)| json!({"why": why, "rows": count}));
        json!({
            "law": self.law.name(),
            "formula": self.law.formula(self.table.is_record()),
            "parameters": parameters.collect::<Vec<_>>(),
            "rms": json_number(self.rms()),
            "rows": self.fit.predictions.len(),
            "dropped": dropped,
            "dropped_because": reasons.collect::<Vec<_>>(),
            "read": self.table.told,
            "degrees_of_freedom": self.fit.freedoms,
            "error_factor": json_number(self.fit.error_factor),
            "starts": self.fit.starts,
            "starts_at_best": self.fit.at_best,
            "converged": self.fit.converged,
            "warnings": self.fit.cautions.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "as_a_law": self.spec(),
        })
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
             law = \"{}\"\nfitted = \"{}\"\npoints = {}\ndegrees_of_freedom = {}\nsum_of_squares = {}\n",
            self.spec().unwrap_or_default(),
            self.law.name(),
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
        text += &format!("error_factor = {:?}\n", fit.error_factor);
        let cautions = fit
            .cautions
            .iter()
            .map(|caution| format!("{:?}", caution.to_string()));
        text += &format!("warnings = [{}]\n", cautions.collect::<Vec<_>>().join(", "));
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
            "\n[parameters.{}]    # {}\nvalue = {:?}\nunit = \"{}\"\n{known}interval = [{}, {}]\n",
            parameter.name,
            parameter.meaning,
            estimate.value,
            self.unit(parameter),
            toml_number(estimate.interval[0]),
            toml_number(estimate.interval[1])
        )
    }
}

/// A fitted parameter for the person at the terminal.
pub fn line(estimate: &Estimate, unit: &str) -> String {
    let parameter = &estimate.parameter;
    let (value, how) = match &estimate.known {
        Uncertainty::StandardError(error) => value_with_error(estimate.value, *error),
        Uncertainty::Fixed => (plain(estimate.value), "fixed".into()),
        Uncertainty::AtBound => (plain(estimate.value), "at its bound".into()),
        Uncertainty::Undetermined(_) => {
            (format!("{:.3e}", estimate.value), "not determined".into())
        }
    };
    let interval = match &estimate.known {
        Uncertainty::Fixed | Uncertainty::Undetermined(_) => String::new(),
        _ if estimate.interval.iter().all(|end| end.is_infinite()) => String::new(),
        _ => interval(estimate.interval),
    };
    format!(
        "{:<13} {value:<14} {how:<14} {interval:<23} [{unit}] {}\n",
        parameter.name, parameter.meaning
    )
}

/// A fitted parameter for programs.
pub fn parameter_json(estimate: &Estimate, unit: &str) -> Value {
    let (error, state) = match &estimate.known {
        Uncertainty::StandardError(error) => (*error, "determined"),
        Uncertainty::Fixed => (0.0, "fixed"),
        Uncertainty::AtBound => (f64::NAN, "at its bound"),
        Uncertainty::Undetermined(_) => (f64::NAN, "not determined"),
    };
    json!({
        "name": estimate.parameter.name,
        "value": json_number(estimate.value),
        "error": json_number(error),
        "interval": estimate.interval.map(json_number),
        "unit": unit,
        "state": state,
    })
}

/// A unit divided by that of the load.
fn per_load(unit: &'static str) -> &'static str {
    match unit {
        "N" => "-",
        "N/m" => "1/m",
        "N s/m" => "s/m",
        unit => unit,
    }
}

/// The unit of a parameter where friction is a force or a torque.
fn of_force(parameter: &FitParameter, force: &str) -> String {
    let is_coefficient = matches!(
        parameter.name,
        "mu" | "mu_s" | "mu_d" | "mu_f" | "mu0" | "a" | "b"
    );
    match parameter.unit {
        "-" if is_coefficient => force.to_owned(),
        "s/m" => format!("{force} s/m"),
        "N" => force.to_owned(),
        "N/m" => format!("{force}/m"),
        "N s/m" => format!("{force} s/m"),
        "kg" if force == "N m" => "kg m²".to_owned(),
        unit => unit.to_owned(),
    }
}

/// A number as TOML has it.
fn toml_number(x: f64) -> String {
    match x {
        x if x.is_finite() => format!("{x:?}"),
        x if x.is_nan() => "nan".into(),
        x if x > 0.0 => "inf".into(),
        _ => "-inf".into(),
    }
}

/// The ends of an interval, with two digits of its width.
fn interval([low, high]: [f64; 2]) -> String {
    let width = high - low;
    let end = |x: f64| match x {
        0.0 => "0".to_owned(),
        x if x.is_finite() && width.is_finite() => value_with_error(x, width).0,
        x => shown_value(x),
    };
    format!("[{}, {}]", end(low), end(high))
}

/// A value for people, with four digits.
pub fn shown_value(x: f64) -> String {
    match x {
        x if x.is_finite() => significant(x, 4),
        x if x.is_nan() => "?".into(),
        x if x > 0.0 => "∞".into(),
        _ => "-∞".into(),
    }
}

/// A value that has no error.
fn plain(value: f64) -> String {
    if value == 0.0 {
        "0".into()
    } else {
        format!("{value:.6e}")
    }
}

/// Value and error with two digits of the error.
fn value_with_error(value: f64, error: f64) -> (String, String) {
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
