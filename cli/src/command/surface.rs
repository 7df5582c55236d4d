//! `tribos surface`: the limit surface of a patch as a table and a picture; pushes and their motions.

use super::fit::log::TableArguments;
use super::wrench::{centre, load, patches};
use super::{digits, file, number, spool};
use crate::failure::Failure;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use tribos::friction::{Area, Coefficients, ContactRadius, Patch};
use tribos::record::Rows;
use tribos::record::{number as shortest, series_csv, write_atomically};
use tribos_core::Real;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::twist::{Twist, Wrench};
use tribos_report::figure::{Axis, Figure, Series};
use tribos_report::image;
use tribos_report::limit_surface::LimitSurfacePage;

/// The limit surface of a patch: all force and torque that its dry friction carries, exact to
/// rounding.
///
/// On a terminal the limits are printed; with --output, --points or in a pipe a table of points with
/// the motion under each, and without --points the limits on standard error. A row has the push (force on the body in its plane, torque about the origin of the patch) and the
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
    /// Friction coefficient; also one along x and one along y, such as 0.5,0.9, or along an axis and across it, such as
    /// 0.5,0.9,30deg.
    #[arg(long, default_value = "1", value_name = "MU[,MU_Y[,AXIS]]", value_parser = number::coefficients,
          allow_hyphen_values = true)]
    coefficient: Coefficients,
    /// Load [N] [default: the sum of the column load of feet, else 1].
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    load: Option<f64>,
    /// Radius of a round patch [m], or what makes it of the load, such as hertz:modulus=1e6,radius=0.01.
    #[arg(long, default_value = "1", value_name = "R", value_parser = number::radius, allow_negative_numbers = true,
          long_help = number::radius_help("Radius of a round patch [m], or what makes it of the load."))]
    radius: ContactRadius,
    /// CSV file with columns `force_x,force_y,torque`, one push a line (`-` for standard input).
    #[arg(long, value_name = "FILE", conflicts_with = "points")]
    pushes: Option<PathBuf>,
    #[command(flatten)]
    table: TableArguments,
    /// Number of points of the table [default: 1000].
    #[arg(long, value_parser = number::whole(1..=10_000_000))]
    points: Option<u32>,
    /// Write the table to this file instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw sections of the surface: FILE.svg, FILE.png or FILE.csv.
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
    /// Write a page that shows the surface in space, to be turned and read in a browser.
    #[arg(long, value_name = "FILE.html")]
    page: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  What holds a box of 30 x 20 cm under 20 N at mu 0.4, and how it moves when pushed:
    tribos surface --patch box:0.3x0.2 --coefficient 0.4 --load 20 --picture box.svg --page box.html
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
const CURE: &str = "For a table give --output FILE or --points N, for pictures --picture FILE and --page FILE.html.\n";
/// Points of a table.
const POINTS: u32 = 1000;
/// Points of a section.
const SECTION: usize = 721;
/// Points of a page, by share of spin and by direction.
const GRID: [usize; 2] = [65, 120];

impl Arguments {
    /// Tabulates, draws and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let outputs = [
            ("--output", &self.output),
            ("--picture", &self.picture),
            ("--page", &self.page),
        ];
        for (name, output) in outputs {
            for (output, input) in output.iter().zip(
                self.pushes
                    .iter()
                    .map(PathBuf::as_path)
                    .chain(self.patch.file()),
            ) {
                file::refuse_input(name, output, input)?;
            }
        }
        if matches!(self.patch, Patch::Flat(_) | Patch::Points(_))
            && self.radius != ContactRadius::Given(1.0)
        {
            return Err(Failure::input(
                "a patch of straight edges, triangles or points has its own size: leave out --radius",
            ));
        }
        if self.pushes.is_none() && !self.table.is_silent() {
            return Err(Failure::input(
                "--columns, --units and --skip say how --pushes are read: give a file of pushes",
            ));
        }
        let standard_input = Some(Path::new("-"));
        if self.page.is_some() && self.pushes.as_deref() == standard_input {
            return Err(Failure::input(
                "a page and a table both read the pushes: give them as a file",
            ));
        }
        let load = load(self.load, &self.patch)?;
        let limit = self.coefficient.largest() * load;
        if limit <= 0.0 {
            return Err(Failure::input(
                "--coefficient 0 carries nothing: give one above 0",
            ));
        }
        let area = Area::named(&self.patch, self.radius.at(load)?, self.centre)?;
        let set = self.coefficient.on(area)?.limit_surface(limit)?;
        if let Some(path) = &self.picture {
            draw(path, &self.patch, &*set)?;
            super::note(format_args!("written to    {}", path.display()));
        }
        if let Some(path) = &self.page {
            let pushes = self.pushes.as_deref();
            let pushes = pushes.map_or(Ok(Vec::new()), |file| read(file, &self.table))?;
            let page = page(&self.patch, &*set, pushes);
            write_atomically(path, page.html().as_bytes())?;
            super::note(format_args!("written to    {}", path.display()));
        }
        let is_drawn = self.picture.is_some() || self.page.is_some();
        match (&self.pushes, self.points) {
            (Some(file), _) => self.judge(file, &*set)?,
            // A picture alone needs no table.
            (None, None) if is_drawn && self.output.is_none() => {}
            (None, None) if self.output.is_none() && std::io::stdout().is_terminal() => {
                super::print(&(limits(&*set) + CURE))?;
            }
            (None, points) => {
                // Whoever names the points wants them alone.
                if points.is_none() {
                    super::note(format_args!("{}", limits(&*set).trim_end()));
                }
                self.tabulate(&*set, points.unwrap_or(POINTS))?;
            }
        }
        if let Some(path) = &self.output {
            super::note(format_args!("written to    {}", path.display()));
        }
        Ok(())
    }

    /// Points under motions that are spread evenly over all directions.
    fn tabulate(&self, set: &dyn FrictionSet<f64>, points: u32) -> Result<(), Failure> {
        spool::deliver(self.output.as_deref(), |sink| {
            sink.put(&series_csv(&COLUMNS, []))?;
            for i in 0..points {
                let motion = direction(i, points, set.radius());
                let push = -set.wrench(&motion);
                sink.put(&row([push_of(&push), twist_of(&motion)].as_flattened()))?;
            }
            Ok(())
        })
    }

    /// Gauge and motion of every push of a file.
    fn judge(&self, file: &Path, set: &dyn FrictionSet<f64>) -> Result<(), Failure> {
        let mut rows = Rows::with_options(file, &self.table.options(), |_| &PUSH)?;
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

/// All pushes of a file.
fn read(file: &Path, table: &TableArguments) -> Result<Vec<[f64; 3]>, Failure> {
    let rows = Rows::with_options(file, &table.options(), |_| &PUSH)?;
    Ok(rows.all(usize::MAX)?)
}

/// What the set carries at most, for people.
fn limits(set: &dyn FrictionSet<f64>) -> String {
    let spinning = -set.wrench(&Twist::new(0.0, 0.0, 1.0));
    let about = match (spinning.force.x, spinning.force.y) {
        (0.0, 0.0) => String::new(),
        (x, y) => format!(
            ", together with the force ({}, {}) N",
            digits::shown(x),
            digits::shown(y)
        ),
    };
    let [x, y] = [[1.0, 0.0], [0.0, 1.0]].map(|[x, y]| {
        let straight = -set.wrench(&Twist::new(x, y, 0.0));
        digits::shown(straight.torque)
    });
    format!(
        "largest force    {} N, in any direction\n\
         \x20 along x        with the torque {x} N m about the origin\n\
         \x20 along y        with the torque {y} N m\n\
         largest torque   {} N m about the origin{about}\n\
         farthest point   {} m from the origin\n",
        digits::shown(set.force_limit()),
        digits::shown(spinning.torque),
        digits::shown(set.radius()),
    )
}

/// The surface in space.
fn page(patch: &Patch, set: &dyn FrictionSet<f64>, pushes: Vec<[f64; 3]>) -> LimitSurfacePage {
    let torque = set.support(&Twist::new(0.0, 0.0, 1.0));
    let arm = torque / set.force_limit();
    let [rows, columns] = GRID;
    let point = |i: usize, j: usize| {
        let share = std::f64::consts::PI * (i as f64 / (rows - 1) as f64 - 0.5);
        let angle = std::f64::consts::TAU * j as f64 / columns as f64;
        let slide = Real::cos(share);
        let motion = Twist::new(
            slide * Real::cos(angle),
            slide * Real::sin(angle),
            Real::sin(share) / arm,
        );
        let [x, y, torque] = push_of(&-set.wrench(&motion));
        let [vx, vy, spin] = twist_of(&motion);
        [x, y, torque, vx, vy, spin]
    };
    LimitSurfacePage {
        title: format!("Limit surface of {patch}"),
        limits: [set.force_limit(), torque],
        grid: (0..rows)
            .map(|i| (0..columns).map(|j| point(i, j)).collect())
            .collect(),
        pushes,
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
    // No minus before a zero.
    let cells: Vec<String> = values.iter().map(|&x| shortest(x + 0.0)).collect();
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
