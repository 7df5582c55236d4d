//! `tribos deposit`: ballistic deposits of spheres, and their porosity over the capture radius.

use super::digits::shown;
use super::number;
use super::run::resource_check::{MemoryPermission, check, describe_size};
use crate::failure::Failure;
use serde_json::{Map, Value};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use tribos::powder::deposit::curve::{COLUMNS as CURVE_COLUMNS, PorosityCurve};
use tribos::powder::deposit::{Ballistic, Deposit, DepositTarget};
use tribos::record::{
    contacts_vtp, extended_xyz, json_number, particles_vtp, series_csv, write_atomically,
};
use tribos::run::RunSize;
use tribos::run::folder::{Contents, OutputFolder};
use tribos_report::image;
use tribos_report::runs::deposit::porosity;

/// Let spheres fall one by one on a square base, periodic in x and y, where each sticks to the first
/// sphere that it comes near, or to the substrate (thesis, section 4.5). All lengths are in radii of
/// a sphere.
///
/// Writes deposit.xyz (OVITO, ASE), deposit.vtp and contacts.vtp (ParaView) and summary.json; with
/// --porosity-curve porosity.csv and a plot of it instead.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
#[command(group(clap::ArgGroup::new("until").required(true).args(["cut", "height", "count"])))]
pub struct Arguments {
    /// Side of the square base in radii, at least twice the capture radius.
    #[arg(long, default_value = "20", value_parser = number::positive, allow_negative_numbers = true)]
    width: f64,
    /// Grow higher and cut at this height in radii, as in the thesis: spheres that reach above it
    /// are removed.
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    cut: Option<f64>,
    /// Stop with the first sphere whose highest point reaches this height in radii.
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    height: Option<f64>,
    /// Stop at this number of spheres.
    #[arg(long)]
    count: Option<usize>,
    /// Distance of centres, in radii, at which a sphere is captured; at least 2. It then moves on
    /// until it touches.
    #[arg(long, default_value = "3", value_parser = number::positive, allow_negative_numbers = true)]
    capture_radius: f64,
    /// Radii uniform from 1 - SPREAD to 1 + SPREAD.
    #[arg(long, default_value = "0", value_parser = number::not_negative, allow_negative_numbers = true)]
    spread: f64,
    /// Seed of the random numbers; the same seed gives the same deposit.
    #[arg(long, default_value = "1")]
    seed: u64,
    /// Porosity over 1/capture radius instead, each point from five deposits of this and the next
    /// seeds.
    #[arg(long, conflicts_with_all = ["count", "capture_radius", "spread"])]
    porosity_curve: bool,
    /// Folder for the results, created if missing. Results of an earlier command in it are removed
    /// first; files that tribos did not write are never replaced. The folder of a powder's run, a
    /// tip, a sweep or a report is refused.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Grow it even if more than 4 GB of memory is expected.
    #[arg(long)]
    allow_large: bool,
}

/// Memory of a sphere while it is grown and exported, in bytes, and its time, in s: measured with 200,000.
const BYTES_A_SPHERE: f64 = 1.3e3;
const SECONDS_A_SPHERE: f64 = 20e-6;
/// Spheres from which the size is told.
const LARGE: f64 = 1e5;

const EXAMPLES: &str = "\
Examples:
  The small system of the thesis, about 470 spheres and 92 % empty:
    tribos deposit --cut 61.5 --out out/deposit
  Spheres that stick where they touch, 10,000 of them:
    tribos deposit --width 40 --count 10000 --capture-radius 2 --out out/touching
  Radii between 0.8 and 1.2, another seed:
    tribos deposit --cut 61.5 --spread 0.2 --seed 7 --out out/uneven
  Porosity over the capture radius (fig. 4.5):
    tribos deposit --width 40 --cut 200 --porosity-curve --out out/porosity";

impl Arguments {
    /// Grows and writes.
    pub fn execute(self) -> Result<(), Failure> {
        // The parser sees to it that one of the three is given.
        let until = match (self.cut, self.height) {
            (Some(height), _) => DepositTarget::Cut(height),
            (None, Some(height)) => DepositTarget::Height(height),
            (None, None) => DepositTarget::Count(self.count.unwrap_or_default()),
        };
        if self.porosity_curve {
            self.curve(until)
        } else {
            self.deposit(until)
        }
    }

    fn deposit(&self, until: DepositTarget) -> Result<(), Failure> {
        if self.spread >= 1.0 {
            return Err(Failure::input("--spread must be less than 1"));
        }
        let radii = [1.0 - self.spread, 1.0 + self.spread];
        let ballistic =
            Ballistic::uneven(self.width, radii, self.capture_radius).map_err(Failure::input)?;
        self.check(&ballistic, until)?;
        let deposit = self.grow(&ballistic, until)?;
        let files = ["summary.json", "deposit.xyz", "deposit.vtp", "contacts.vtp"];
        let _folder = OutputFolder::begin(&self.out, &Contents::of("deposit", &files))?;
        let contacts = deposit.contacts();
        let snapshot = deposit.snapshot(&contacts);
        for (name, text) in [
            ("deposit.xyz", extended_xyz(&snapshot)),
            ("deposit.vtp", particles_vtp(&snapshot)),
            ("contacts.vtp", contacts_vtp(&snapshot)),
        ] {
            let text = text.map_err(Failure::run)?;
            write_atomically(&self.out.join(name), text.as_bytes())?;
        }
        // Last: a summary stands only beside complete results.
        let summary = format!("{:#}\n", self.summary(&deposit));
        write_atomically(&self.out.join("summary.json"), summary.as_bytes())?;
        self.report(&deposit)
    }

    /// Refuses what is too large, before it grows.
    fn check(&self, ballistic: &Ballistic, until: DepositTarget) -> Result<(), Failure> {
        let bodies = ballistic.expected_spheres(until);
        let size = RunSize {
            bodies,
            bytes: BYTES_A_SPHERE * bodies,
            seconds: SECONDS_A_SPHERE * bodies,
        };
        check(&size, "spheres", MemoryPermission::of(self.allow_large))?;
        if bodies > LARGE {
            super::note(format_args!("{}", describe_size(&size, "spheres")));
        }
        Ok(())
    }

    /// Grows it and tells, once a second, how far it is.
    fn grow(&self, ballistic: &Ballistic, until: DepositTarget) -> Result<Deposit, Failure> {
        let expected = ballistic.expected_spheres(until);
        let mut last = Instant::now();
        let grown = ballistic.grow_watched(until, self.seed, |spheres| {
            if last.elapsed() >= Duration::from_secs(1) {
                last = Instant::now();
                super::note(format_args!(
                    "{spheres} spheres have fallen, about {expected:.0} will stay"
                ));
            }
            ControlFlow::Continue(())
        });
        grown.map_err(Failure::input)
    }

    fn summary(&self, deposit: &Deposit) -> Value {
        let mut map = Map::new();
        let on_spheres = deposit.parents.iter().flatten().count();
        let particles = deposit.positions.len();
        map.insert("particles".into(), particles.into());
        map.insert("contacts".into(), on_spheres.into());
        map.insert("on_substrate".into(), (particles - on_spheres).into());
        for (name, value) in [
            ("height", deposit.height),
            ("porosity", deposit.porosity()),
            ("bulk_porosity", deposit.bulk_porosity()),
            ("width", deposit.width),
            ("capture_radius", self.capture_radius),
            ("spread", self.spread),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map.insert("seed".into(), self.seed.into());
        map.insert("version".into(), env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }

    /// A few lines for the person at the terminal.
    fn report(&self, deposit: &Deposit) -> Result<(), Failure> {
        let share = |porosity: f64| format!("{} %", shown(100.0 * porosity));
        super::print(&format!(
            "particles      {}\nheight         {}\nporosity       {} below the highest point\n\
             bulk porosity  {} in the middle half\nwritten to     {}\n",
            deposit.positions.len(),
            shown(deposit.height),
            share(deposit.porosity()),
            share(deposit.bulk_porosity()),
            self.out.display()
        ))
    }

    fn curve(&self, until: DepositTarget) -> Result<(), Failure> {
        // The densest of its deposits.
        let dense = Ballistic::new(self.width, 1.0, 2.0).map_err(Failure::input)?;
        self.check(&dense, until)?;
        let curve = PorosityCurve::new(self.width, until, self.seed).map_err(Failure::input)?;
        let files = ["porosity.csv", "porosity.svg", "porosity.png"];
        let _folder = OutputFolder::begin(&self.out, &Contents::of("deposit", &files))?;
        let rows = curve
            .rows
            .iter()
            .map(<[f64; CURVE_COLUMNS.len()]>::as_slice);
        let csv = series_csv(&CURVE_COLUMNS, rows);
        write_atomically(&self.out.join("porosity.csv"), csv.as_bytes())?;
        image::write_both(&self.out, "porosity", &porosity(&curve))?;
        super::print(&format!("written to     {}\n", self.out.display()))
    }
}
