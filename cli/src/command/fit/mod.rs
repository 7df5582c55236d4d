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

/// Fit a friction law to measurements by least squares, or compare all laws; or follow a filmed body (--track), take a
/// tribometer's strokes apart (--strokes), or find the pressure under a foot from pushes (--support).
///
/// Logs are read as they are: --look shows what is understood, --columns and --units say what is not. v,f is friction f of
/// steady sliding at velocities v [m/s]; t,v,f is a record over time [s], which laws with a memory need; a column sigma gives
/// points their weights. f is a coefficient, or a force [N]. --track takes t,x,y and perhaps angle; --strokes t,f and v or x;
/// --support dx,dy,dtheta,fx,fy,torque. docs/fit.md explains every line of the output and every warning.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Measurements, a table with the columns v,f or t,v,f and perhaps sigma; `-` for standard
    /// input.
    #[arg(required_unless_present = "support")]
    data: Option<PathBuf>,
    /// The law: coulomb, viscous, stribeck, tanh, arctan, rising, power, amontons, elastic-plastic, dahl, elasto-plastic,
    /// lugre, maxwell, rate-state, rate-state-slip; or all of them, compared.
    #[arg(long, required_unless_present_any = ["support", "strokes", "look", "track"], value_parser = law::parser(), hide_possible_values = true)]
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
    /// Print the fitted law as a program or as coefficients of a simulator: rust, c, python, scene, mujoco, newton, gazebo.
    #[arg(
        long = "as",
        value_name = "TARGET",
        value_enum,
        requires = "law",
        hide_possible_values = true
    )]
    target: Option<As>,
    /// Form of what is printed: text, unless json is asked for.
    #[arg(
        long,
        value_enum,
        default_value = "text",
        conflicts_with = "target",
        hide_possible_values = true,
        hide_default_value = true
    )]
    format: Format,
    /// Folder for tables and pictures, created if missing; files of an earlier command in it are removed first. The folder of a
    /// powder, a tip, a sweep or a report is refused.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  tribos fit --look scenes/data/disc.csv                   # what is understood of a file
  tribos fit --law all scenes/data/disc.csv --columns v=\"Disc speed\",f=Traction
  tribos fit --law stribeck forces.csv --load 12.5 --fix delta=2 --fix k=0 --out out/bearing
  tribos fit --law viscous scenes/data/servo.csv --inertia --offset
  tribos fit --law lugre pull.csv --as c                   # the law as a program
  tribos fit --law rate-state scenes/data/gouge.csv --spring fit --columns v=2
  tribos fit --track scenes/data/puck.csv --out out/puck
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
            return strokes::execute(data, &log, self.machine.load, form);
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
