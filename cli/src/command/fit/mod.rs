//! `tribos fit`: parameters of a friction law, or the pressure under a foot, from measurements.

mod apparatus;
mod compared;
mod law;
pub mod log;
mod output;
mod plot;
mod progress;
mod strokes;
mod strokes_picture;
mod support;
mod table;
mod track;
mod usage;

use crate::failure::Failure;
use apparatus::Machine;
use law::LawChoice;
use log::{Format, LogArguments};
use std::num::NonZero;
use std::path::PathBuf;
use tribos::friction::Patch;
use usage::As;

/// Fit a friction law to measurements by least squares: parameters with standard errors and intervals, what the data do not
/// determine, and what to be careful of. Or compare all laws (--law all), follow a filmed body (--track), take a tribometer's
/// strokes apart (--strokes), or find the pressure under a foot from pushes (--support).
///
/// Logs are read as they are: commas, semicolons, tabs or blanks between columns, decimal points or commas, lines
/// before the header, units in names or in a line of their own, gzip and UTF-16. Usual names of columns in English and
/// German are known; --columns names others, --look shows what is understood. Rows without a number, and rows whose time
/// does not rise, are dropped and counted. Without a velocity, one is made from a position.
///
/// The columns decide: v,f is friction f of steady sliding at velocities v [m/s], in one direction or both; t,v,f is a record
/// over time [s], which laws with a memory need. A column sigma with the standard deviation of f gives points their weights.
/// f is a coefficient, or a force [N] that --load or a column load makes a coefficient; forces of bristles may stay forces.
///
/// The machine is part of the fit: --inertia, --offset, --spring. Over time steps are taken between the rows until the answer no
/// longer depends on them. Errors grow with the correlation of the residuals. Intervals cover the truth in 95 of 100 cases
/// and come from profiles.
///
/// With more than 4,000 points the starts search a sample of about 2,000, and the distinct minima found on it are refined on
/// all points; more starts follow while fewer than three agree. A fit longer than two seconds reports its progress.
///
/// --track takes the columns t,x,y [s, m, m] and perhaps angle [rad] of a body that slides on a level floor.
///
/// --strokes takes t,f and v or x, and perhaps load: mean friction, static peak, run-in, stick-slip and the offset of the
/// directions, a row for each stroke.
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
    /// The law, or all of them for a comparison.
    #[arg(long, required_unless_present_any = ["support", "strokes", "look", "track"], value_parser = law::parser())]
    law: Option<LawChoice>,
    #[command(flatten)]
    log: LogArguments,
    #[command(flatten)]
    machine: Machine,
    /// Keep a parameter at a value; may be repeated.
    #[arg(long = "fix", value_name = "NAME=VALUE", value_parser = fixed)]
    fixed: Vec<(String, f64)>,
    /// Number of starts of the search, spread about a first guess from the data.
    #[arg(long, default_value = "16", value_parser = starts)]
    starts: NonZero<usize>,
    #[command(flatten)]
    film: track::FilmArguments,
    #[command(flatten)]
    strokes: strokes::StrokeArguments,
    /// Measured pushes, a table with the columns dx,dy,dtheta,fx,fy,torque (`-` for standard input).
    #[arg(long, value_name = "PUSHES.csv", conflicts_with_all = ["data", "law", "load", "inertia", "offset", "spring", "fixed", "starts", "strokes", "track", "look"])]
    support: Option<PathBuf>,
    /// The support under the pushed body, if it is known, or the patch of the filmed one (disk unless it is given): disk, ring, punch, hertz, box:AxB, polygon:FILE, bar:L, mesh:FILE or points:FILE (weights are loads), in the frame of the pushes.
    #[arg(long)]
    patch: Option<Patch>,
    /// Print the fitted law as a program or as coefficients of a simulator, in place of the report.
    #[arg(long = "as", value_name = "TARGET", value_enum, requires = "law")]
    target: Option<As>,
    /// Form of what is printed.
    #[arg(long, value_enum, default_value = "text", conflicts_with = "target")]
    format: Format,
    /// Folder for fit.toml, covariance.csv, residuals.csv, fit.svg and fit.png; for laws.csv and laws.json of a comparison;
    /// for pressure.csv, pressure.svg, pressure.png and summary.json; or for strokes.csv, strokes.svg, strokes.png and
    /// summary.json. It is created if missing; files of an earlier command in it are removed first. The folder of a
    /// powder, a tip, a sweep or a report is refused.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  tribos fit --look log.txt                                # what is understood of a file
  tribos fit --law stribeck bearing.csv --out out/bearing
  tribos fit --law stribeck forces.csv --load 12.5 --fix delta=2 --fix k=0
  tribos fit --law all log.csv --columns t=Time,v=\"v [mm/s]\",f=COF
  tribos fit --law viscous joint.csv --inertia --offset    # a servo joint
  tribos fit --law lugre pull.csv --out out/joint          # t,v,f: bristles too
  tribos fit --law lugre pull.csv --as c                   # the law as a program
  tribos fit --law rate-state steps.csv --spring fit       # v is the load point's
  tribos fit --track puck.csv --units x=mm,y=mm,angle=deg --from 0.4 --out out/puck
  tribos fit --strokes scenes/data/tribometer.csv --load 20 --out out/strokes
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

impl Arguments {
    /// Fits, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        if let Some(pushes) = &self.support {
            let options = self.log.options();
            return support::execute(pushes, &options, self.patch.as_ref(), self.out.as_deref());
        }
        let Some(data) = &self.data else {
            return Err(Failure::input("give measurements and --law, or --support"));
        };
        self.fixed_once()?;
        if self.film.track {
            if self.log.look {
                return self.log.show(data, &track::ROLES, self.format);
            }
            return self.film.execute(data, &self.film_request()?);
        }
        if self.patch.is_some() {
            return Err(Failure::input("--patch: give it with --support or --track"));
        }
        if self.log.look {
            return self.log.show(data, &table::ROLES, self.format);
        }
        if self.strokes.strokes {
            let log = self.log.options();
            let form = (self.format, self.out.as_deref());
            return strokes::execute(data, &log, self.machine.load, &self.strokes, form);
        }
        let Some(choice) = self.law else {
            return Err(Failure::input("give a law by --law, or --law all"));
        };
        let mut fixed = self.fixed.clone();
        fixed.extend(self.machine.fixed());
        law::Request {
            data,
            log: self.log.options(),
            machine: self.machine,
            fixed,
            starts: self.starts.get(),
            target: self.target,
            format: self.format,
            out: self.out.as_deref(),
        }
        .execute(choice)
    }

    /// What a film takes of the common options.
    fn film_request(&self) -> Result<track::Common<'_>, Failure> {
        let law = match self.law {
            None => None,
            Some(LawChoice::One(law)) => Some(law),
            Some(LawChoice::All) => {
                return Err(Failure::input("--law: a film is fitted under one law"));
            }
        };
        Ok(track::Common {
            law,
            patch: self.patch.as_ref(),
            log: self.log.options(),
            fixed: &self.fixed,
            starts: self.starts.get(),
            format: self.format,
            out: self.out.as_deref(),
        })
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
