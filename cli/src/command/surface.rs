//! `tribos surface`: the limit surface of a patch as a table and a picture; pushes and their motions.

use super::columns::Rows;
use super::wrench::{centre, patches};
use super::{file, number, spool};
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use tribos::friction::{FlatPatch, Patch, limit_surface};
use tribos::record::{number as shortest, series_csv};
use tribos_core::Real;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::twist::{Twist, Wrench};
use tribos_report::figure::{Axis, Figure, Series};
use tribos_report::image;

/// The limit surface of a patch: all force and torque that its dry friction carries, exact to
/// rounding, as points with the motion under each.
///
/// A row has the push (force on the body in its plane, torque about the origin of the patch) and the
/// unit motion that it causes, velocity and spin with |velocity|^2 + (spin*R)^2 = 1 for the
/// farthest distance R of the patch from the origin. With --pushes the motion of each given push is
/// added, and its gauge: below 1 friction holds, from 1 on the body slides.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Contact patch.
    #[arg(long, default_value = "disk", long_help = format!("Contact patch: {}. The surface of points has flat facets: the motion under them is the rotation about a point.", patches()))]
    patch: Patch,
    /// Centre of pressure of a box or a polygon, under a pressure that is linear [m].
    #[arg(long, value_name = "X,Y", value_parser = centre, allow_hyphen_values = true)]
    centre: Option<[f64; 2]>,
    /// Friction coefficient.
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    coefficient: f64,
    /// Load [N].
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    load: f64,
    /// Radius of a round patch [m].
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    radius: f64,
    /// CSV file with columns `force_x,force_y,torque`, one push a line (`-` for standard input).
    #[arg(long, value_name = "FILE", conflicts_with = "points")]
    pushes: Option<PathBuf>,
    /// Number of points of the table.
    #[arg(long, default_value = "1000", value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    points: u32,
    /// Write the table to this file instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw sections of the surface: FILE.svg, FILE.png or FILE.csv.
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  What holds a box of 30 x 20 cm under 20 N at mu 0.4, and how it moves when pushed:
    tribos surface --patch box:0.3x0.2 --coefficient 0.4 --load 20 --picture box.svg --output box.csv
  Measured pushes, their gauge (1 on the surface) and motion:
    tribos surface --patch polygon:sole.csv --coefficient 0.6 --load 400 --pushes pushes.csv";

const PUSH: [&str; 3] = ["force_x", "force_y", "torque"];
const COLUMNS: [&str; 6] = [
    "force_x",
    "force_y",
    "torque",
    "velocity_x",
    "velocity_y",
    "spin",
];
const JUDGED: [&str; 7] = [
    "force_x",
    "force_y",
    "torque",
    "gauge",
    "velocity_x",
    "velocity_y",
    "spin",
];
/// Points of a section.
const SECTION: usize = 721;

impl Arguments {
    /// Tabulates, draws and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let corners = match &self.patch {
            Patch::Points(file) | Patch::Flat(FlatPatch::Polygon(file) | FlatPatch::Mesh(file)) => {
                Some(file)
            }
            _ => None,
        };
        let outputs = [("--output", &self.output), ("--picture", &self.picture)];
        for (name, output) in outputs {
            for (output, input) in output.iter().zip(self.pushes.iter().chain(corners)) {
                file::refuse_input(name, output, input)?;
            }
        }
        if matches!(self.patch, Patch::Flat(_) | Patch::Points(_)) && self.radius != 1.0 {
            return Err(Failure::input(
                "a patch of straight edges, triangles or points has its own size: leave out --radius",
            ));
        }
        let limit = self.coefficient * self.load;
        let set = limit_surface(&self.patch, limit, self.radius, self.centre)?;
        if let Some(path) = &self.picture {
            draw(path, &self.patch, &*set)?;
            super::tell(format_args!("written to    {}", path.display()));
        }
        match &self.pushes {
            Some(file) => self.judge(file, &*set)?,
            // A picture alone needs no table.
            None if self.picture.is_some() && self.output.is_none() => {}
            None => self.tabulate(&*set)?,
        }
        if let Some(path) = &self.output {
            super::tell(format_args!("written to    {}", path.display()));
        }
        Ok(())
    }

    /// Points under motions that are spread evenly over all directions.
    fn tabulate(&self, set: &dyn FrictionSet<f64>) -> Result<(), Failure> {
        spool::deliver(self.output.as_deref(), |sink| {
            sink.put(&series_csv(&COLUMNS, []))?;
            for i in 0..self.points {
                let motion = direction(i, self.points, set.radius());
                let push = -set.wrench(&motion);
                sink.put(&row([push_of(&push), twist_of(&motion)].as_flattened()))?;
            }
            Ok(())
        })
    }

    /// Gauge and motion of every push of a file.
    fn judge(&self, file: &Path, set: &dyn FrictionSet<f64>) -> Result<(), Failure> {
        let mut rows = Rows::open(file, |_| &PUSH)?;
        spool::deliver(self.output.as_deref(), |sink| {
            sink.put(&series_csv(&JUDGED, []))?;
            let mut push = [0.0; 3];
            while rows.next(&mut push)?.is_some() {
                let [x, y, torque] = push;
                let wrench = Wrench::new(x, y, torque);
                let [vx, vy, spin] = twist_of(&set.twist_normal_to(&wrench));
                sink.put(&row(&[x, y, torque, set.gauge(&wrench), vx, vy, spin]))?;
            }
            Ok(())
        })
    }
}

/// Motion `i` of `count`, on a spiral that covers the sphere of motions of length 1 evenly.
fn direction(i: u32, count: u32, radius: f64) -> Twist<f64> {
    // Turns of the golden angle, in which no two points come close.
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let rim = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
    let slide = (1.0 - rim * rim).sqrt();
    let angle = golden * f64::from(i);
    Twist::new(
        slide * Real::cos(angle),
        slide * Real::sin(angle),
        rim / radius,
    )
}

fn push_of(wrench: &Wrench<f64>) -> [f64; 3] {
    [wrench.force.x, wrench.force.y, wrench.torque]
}

fn twist_of(twist: &Twist<f64>) -> [f64; 3] {
    [twist.velocity.x, twist.velocity.y, twist.spin]
}

fn row(values: &[f64]) -> String {
    let cells: Vec<String> = values.iter().map(|&x| shortest(x)).collect();
    cells.join(",") + "\n"
}

/// Torque over force for pushes along three directions, and over the ellipsoid's.
fn draw(path: &Path, patch: &Patch, set: &dyn FrictionSet<f64>) -> Result<(), Failure> {
    let mut figure = Figure::new(
        format!("Limit surface of {patch}"),
        Axis::linear("force [N]"),
        Axis::linear("torque [N m]"),
    );
    let mut rows = vec![Vec::new(); SECTION];
    let mut columns = Vec::new();
    for degrees in [0, 45, 90] {
        let angle = f64::from(degrees) * std::f64::consts::PI / 180.0;
        let (c, s) = (Real::cos(angle), Real::sin(angle));
        let ray = |i: usize| {
            let turn = std::f64::consts::TAU * i as f64 / (SECTION - 1) as f64;
            let force = set.force_limit() * Real::cos(turn);
            let torque = set.force_limit() * set.radius() * Real::sin(turn);
            let on = set.scale_to_surface(&Wrench::new(force * c, force * s, torque));
            (on.force.x * c + on.force.y * s, on.torque)
        };
        let points: Vec<(f64, f64)> = (0..SECTION).map(ray).collect();
        for (row, (force, torque)) in rows.iter_mut().zip(&points) {
            row.extend([*force, *torque]);
        }
        columns.extend([format!("force_{degrees}"), format!("torque_{degrees}")]);
        figure = figure.series(Series::line(format!("pushed at {degrees} deg"), points));
    }
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let csv = || series_csv(&columns, rows.iter().map(Vec::as_slice));
    Ok(image::write_as_named(path, &figure, csv)?)
}
