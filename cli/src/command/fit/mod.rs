//! `tribos fit`: parameters of a friction law, or the pressure under a foot, from measurements.

pub mod log;
mod output;
mod plot;
mod progress;
mod support;
mod table;

use crate::failure::Failure;
use log::LogArguments;
use progress::Progress;
use std::num::NonZero;
use std::path::PathBuf;
use table::Table;
use tribos::fit::{FitLaw, FitOptions, fit_watched};
use tribos::friction::Patch;
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::image;

/// Fit a friction law to measurements by least squares and print its parameters with standard errors,
/// the parameters that the data do not determine, and how many of several starts agree; or, with
/// --support, the pressure under a foot to measured pushes.
///
/// The columns of the file decide: `v,f` is friction f of steady sliding at speeds v [m/s]; `t,v,f`
/// is a record over time [s], for laws with a memory (lugre, rate-state). A column `sigma` with the
/// standard deviation of f gives points their weights. f is a coefficient, or a force [N] that --load
/// makes a coefficient; forces of lugre may stay forces.
///
/// Logs are read as they are: commas, semicolons, tabs or blanks between columns, decimal points or commas, lines
/// before the header, units in names or in a line of their own, gzip and UTF-16. Usual names of columns in English and
/// German are known; --columns names others, --look shows what is understood. Rows without a number, and rows whose time
/// does not rise, are dropped and counted. Without a velocity, one is made from a position.
///
/// With more than 4,000 points the starts search a sample of about 2,000, and the distinct minima
/// found on it are refined on all points. A fit longer than two seconds reports its progress.
///
/// --support takes quasi-static pushes with the columns dx,dy,dtheta [m, rad], of which the direction
/// counts, and fx,fy,torque [N, N m], the wrench on the body, in the frame of the body. The loads of points
/// come from non-negative least squares; the motions that they foretell are compared with the measured
/// ones, beside those of an ellipsoid and a convex quartic fitted to the same pushes.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Measurements, a table with the columns v,f or t,v,f and perhaps sigma; `-` for standard
    /// input.
    #[arg(required_unless_present = "support")]
    data: Option<PathBuf>,
    /// The law.
    #[arg(long, required_unless_present_any = ["support", "look"], value_parser = super::number::named::<FitLaw, 5>(
        FitLaw::ALL.map(|(_, name, help)| (name, help)),
    ))]
    law: Option<FitLaw>,
    /// Measured pushes, a CSV file with the columns dx,dy,dtheta,fx,fy,torque (`-` for standard input).
    #[arg(long, value_name = "PUSHES.csv", conflicts_with_all = ["data", "law", "load", "fixed", "starts", "look"])]
    support: Option<PathBuf>,
    #[command(flatten)]
    log: LogArguments,
    /// The support under the pushed body, if it is known: box:AxB, polygon:FILE, bar:L, mesh:FILE or points:FILE (weights are loads), in the frame of the pushes.
    #[arg(long, requires = "support")]
    patch: Option<Patch>,
    /// Load [N] at which forces were measured; friction is divided by it.
    #[arg(long, value_name = "N", value_parser = super::number::positive)]
    load: Option<f64>,
    /// Keep a parameter at a value; may be repeated.
    #[arg(long = "fix", value_name = "NAME=VALUE", value_parser = fixed)]
    fixed: Vec<(String, f64)>,
    /// Number of starts of the search, spread over the range that the data allow.
    #[arg(long, default_value = "16", value_parser = starts)]
    starts: NonZero<usize>,
    /// Folder for fit.toml, covariance.csv, residuals.csv, fit.svg and fit.png, or for pressure.csv,
    /// pressure.svg, pressure.png and summary.json, created if missing; files of an earlier command in it are removed first.
    /// The folder of a powder, a tip, a sweep or a report is refused.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  tribos fit --law stribeck bearing.csv --out out/bearing
  tribos fit --law stribeck forces.csv --load 12.5 --fix delta=2 --fix k=0
  tribos fit --law power ice.csv
  tribos fit --look log.txt                                # what is understood of a log
  tribos fit --law lugre log.txt --columns t=Time,f=-Fx --units f=mN
  tribos fit --law lugre pull.csv --out out/joint          # t,v,f: bristles too
  tribos fit --law rate-state steps.csv --fix v0=1e-6 --fix eta=0
  tribos fit --support scenes/data/pushes.csv --patch box:0.2x0.1 --out out/pushes
bearing.csv:
  v,f,sigma
  0.001,0.148,0.002
  0.01,0.121,0.002
The result as a law for other commands:
  tribos wrench --law stribeck:mu_s=0.15,mu_d=0.08,vs=0.02,delta=1.5,k=0.1 --patch hertz \\
      --radius 0.01 --speed 0.1 --spin 5";

/// Most starts of a search.
const MOST_STARTS: usize = 10_000;

fn starts(text: &str) -> Result<NonZero<usize>, String> {
    let number = text.trim().parse().ok();
    number
        .filter(|starts: &NonZero<usize>| starts.get() <= MOST_STARTS)
        .ok_or(format!("give a whole number from 1 to {MOST_STARTS}"))
}

/// NAME=VALUE
fn fixed(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text
        .split_once('=')
        .ok_or("give NAME=VALUE, such as delta=2")?;
    Ok((name.trim().to_owned(), super::number::finite(value)?))
}

/// What was understood of a log.
fn told(table: &Table) -> String {
    let lines = table
        .told
        .iter()
        .map(|line| format!("read          {line}\n"));
    lines.collect()
}

impl Arguments {
    /// Fits, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        if let Some(pushes) = &self.support {
            let options = self.log.options();
            return support::execute(pushes, &options, self.patch.as_ref(), self.out.as_deref());
        }
        if let Some(data) = self.data.as_ref().filter(|_| self.log.look) {
            return self.log.show(data, &log::ROLES);
        }
        let (Some(data), Some(law)) = (&self.data, self.law) else {
            return Err(Failure::input("give measurements and --law, or --support"));
        };
        self.fixed_once()?;
        let table = Table::read(data, &self.log.options(), self.load)?;
        let fail = |error| table.refusal(error);
        let data = &table.data;
        let model = law.model(data).map_err(fail)?;
        let options = FitOptions {
            fixed: self.fixed.clone(),
            starts: self.starts.get(),
        };
        let mut progress = Progress::default();
        let found =
            fit_watched(model.as_ref(), data, &options, &mut |at| progress.at(at)).map_err(fail)?;
        let report = output::Report {
            law,
            table: &table,
            fit: &found,
            is_per_load: self.load.is_some(),
        };
        if let Some(out) = &self.out {
            let figure = plot::panels(law, data, &found)?;
            let files = [
                "covariance.csv",
                "residuals.csv",
                "fit.toml",
                "fit.svg",
                "fit.png",
            ];
            let _folder = OutputFolder::begin(out, &Contents::of("fit", &files))?;
            image::write_both(out, "fit", &figure)?;
            report.write(out)?;
        }
        super::print(&(told(&table) + &report.text()))?;
        match &self.out {
            Some(out) => super::print(&format!("written to    {}\n", out.display())),
            None => Ok(()),
        }
    }

    /// Refuses a parameter that is kept at two values.
    fn fixed_once(&self) -> Result<(), Failure> {
        let names = || self.fixed.iter().map(|(name, _)| name);
        let twice = names()
            .enumerate()
            .find(|(at, name)| names().take(*at).any(|earlier| earlier == *name));
        twice.map_or(Ok(()), |(_, name)| {
            let message = format!("--fix: `{name}` is given twice; give one value");
            Err(Failure::input(message))
        })
    }
}
