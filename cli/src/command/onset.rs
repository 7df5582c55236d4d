//! `tribos onset`: what bonds hold under force and torque before a body slides.

use super::wrench::{centre, patches};
use super::{digits, file, number, spool};
use crate::failure::Failure;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tribos::friction::Patch;
use tribos::onset::{Bond, OnsetContact, OnsetPoint, OnsetSummary, OnsetSurface};
use tribos::record::{json_number, series_csv};
use tribos_report::figure::{Axis, Figure, Series};
use tribos_report::image;

/// The onset of sliding of a patch on bonds: force F and torque T at which the body lets go, from a
/// pure push (F_s) to a pure rotation (T_s).
///
/// Bonds are strained by a small displacement of the body and break, or yield, or break and re-form. The body
/// lets go where their stiffness first turns singular. T_s/(F_s R) and the bulge of the curve tell how the
/// strengths of bonds are spread: between the limit surface of dry friction (plastic bonds) and a straight line
/// (all break at one strain). Bonds that re-form have a static friction above the dynamic one, by a factor
/// between 1 and 2; the table has it for every ratio of torque to force.
///
/// A row has the share of the rotation in the displacement (0 deg pushed, 90 deg turned), force and torque about
/// the centre of pressure, the displacement reached, the push over the one that dry friction with the
/// same static coefficient carries along its ray (of_limit), and over that of steady sliding
/// (static_over_dynamic; nan for bonds that break for good). This is a model in the spirit of Dahmen, Farkas, Hinrichsen and Wolf (2005); it has
/// none of their equations.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Contact patch.
    #[arg(long, default_value = "disk", long_help = format!("Contact patch: {}.", patches()))]
    patch: Patch,
    /// Law of the bonds.
    #[arg(long, default_value = "exponential", long_help = bonds())]
    bond: Bond,
    /// Centre of pressure of a box or a polygon, under a pressure that is linear [m].
    #[arg(long, value_name = "X,Y", value_parser = centre, allow_hyphen_values = true)]
    centre: Option<[f64; 2]>,
    /// Static friction coefficient: the largest force of the bonds, per load.
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    coefficient: f64,
    /// Load [N].
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    load: f64,
    /// Radius of a round patch [m].
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    radius: f64,
    /// Strain x0 of the bonds: it scales the displacements and no force [m].
    #[arg(long, default_value = "1e-6", value_parser = number::positive, allow_negative_numbers = true)]
    strain: f64,
    /// Direction of the push, from the first axis [deg].
    #[arg(long, default_value = "0", value_parser = number::finite, allow_negative_numbers = true)]
    heading: f64,
    /// Number of points, from pushed to turned.
    #[arg(long, default_value = "19", value_parser = number::whole(2..=10_000))]
    points: u32,
    /// Output format.
    #[arg(long, default_value = "text")]
    format: Format,
    /// Write the table as CSV to this file.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw the curve beside those of dry friction: FILE.svg, FILE.png or FILE.csv.
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
}

/// Format of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    Text,
    Csv,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  A disk whose bonds are nearly equally strong:
    tribos onset --bond weibull:m=8
  A box of 30 x 20 cm under 20 N, pushed along its short side, beside its limit surface:
    tribos onset --patch box:0.3x0.2 --bond one-strength --coefficient 0.4 --load 20 --heading 90 --picture box.svg
  How torque takes from the difference of static and dynamic friction:
    tribos onset --bond re-forming:n=64 --points 10 --format csv";

/// The laws of bonds, for the help.
fn bonds() -> String {
    let list: Vec<String> = Bond::SYNTAX
        .iter()
        .map(|(syntax, meaning)| format!("  {syntax:<24} {meaning}"))
        .collect();
    format!("Law of the bonds:\n{}", list.join("\n"))
}

const COLUMNS: [&str; 9] = [
    "share",
    "force_x",
    "force_y",
    "torque",
    "displacement_x",
    "displacement_y",
    "turn",
    "of_limit",
    "static_over_dynamic",
];

impl Arguments {
    /// Computes, draws, writes and prints.
    pub fn execute(self) -> Result<(), Failure> {
        self.check()?;
        let contact = OnsetContact {
            coefficient: self.coefficient,
            load: self.load,
            radius: self.radius,
            strain: self.strain,
            heading: self.heading,
            centre: self.centre,
        };
        let surface = OnsetSurface::new(&self.patch, self.bond, &contact, self.points as usize)?;
        if let Some(path) = &self.picture {
            self.draw(path, &surface)?;
            super::note(format_args!("written to    {}", path.display()));
        }
        if let Some(path) = &self.output {
            spool::deliver(Some(path), |sink| sink.put(&csv(&surface)))?;
            super::note(format_args!("written to    {}", path.display()));
        }
        let text = match self.format {
            Format::Text => self.text(&surface),
            Format::Csv => csv(&surface),
            Format::Json => format!("{:#}\n", self.json(&surface)),
        };
        super::print(&text)
    }

    /// Refuses outputs that are inputs, and a size where the patch has its own.
    fn check(&self) -> Result<(), Failure> {
        for (name, output) in [("--output", &self.output), ("--picture", &self.picture)] {
            for (output, input) in output.iter().zip(self.patch.file()) {
                file::refuse_input(name, output, input)?;
            }
        }
        if !self.patch.has_axis() && self.radius != 1.0 {
            return Err(Failure::input(
                "a patch of straight edges, triangles or points has its own size: leave out --radius",
            ));
        }
        Ok(())
    }

    fn text(&self, surface: &OnsetSurface) -> String {
        let OnsetSummary {
            force,
            torque,
            reach,
            static_over_dynamic,
        } = surface.summary();
        let shown = digits::shown;
        let mut text = format!(
            "patch               {}\n\
             bonds               {} (a model)\n\
             force F_s           {} N, pushed without turning\n\
             torque T_s          {} N m, turned about the centre of pressure\n\
             T_s/(F_s R)         {} for the farthest distance R = {} m\n",
            self.patch,
            self.bond,
            shown(force),
            shown(torque),
            shown(surface.summary().arm_ratio()),
            shown(reach),
        );
        if let Some(ratio) = static_over_dynamic {
            text += &format!("static over dynamic {} for a pure push\n", shown(ratio));
        }
        let last = static_over_dynamic.map_or("", |_| "static/dynamic");
        text += &format!(
            "\n{:>9} {:>12} {:>12} {:>12} {last:>14}\n",
            "share/deg", "F/F_s", "T/T_s", "of limit"
        );
        for point in surface.points() {
            let ratio = point.static_over_dynamic.map_or(String::new(), shown);
            text += &format!(
                "{:>9} {:>12} {:>12} {:>12} {ratio:>14}\n",
                shown(point.share),
                shown(without_noise(force_of(point) / force)),
                shown(without_noise(point.onset.push.torque / torque)),
                shown(point.of_limit),
            );
        }
        // No blanks at the ends of lines.
        let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
        lines.join("\n") + "\n"
    }

    fn json(&self, surface: &OnsetSurface) -> Value {
        let summary = surface.summary();
        let points: Vec<Value> = surface
            .points()
            .iter()
            .map(|point| {
                let named = COLUMNS.iter().zip(row(point));
                let fields = named.map(|(name, x)| ((*name).to_owned(), json_number(x)));
                Value::Object(fields.collect())
            })
            .collect();
        json!({
            "patch": self.patch.to_string(),
            "bond": self.bond.to_string(),
            "force": json_number(summary.force),
            "torque": json_number(summary.torque),
            "reach": json_number(summary.reach),
            "arm_ratio": json_number(summary.arm_ratio()),
            "static_over_dynamic": summary.static_over_dynamic.map(json_number),
            "points": points,
        })
    }

    /// Torque over force, in units of F_s and F_s R.
    fn draw(&self, path: &Path, surface: &OnsetSurface) -> Result<(), Failure> {
        let OnsetSummary { force, reach, .. } = surface.summary();
        let curve = |over: &dyn Fn(&OnsetPoint) -> Option<f64>| -> Vec<(f64, f64)> {
            let points = surface.points().iter();
            let place = |point: &OnsetPoint| {
                let scale = over(point)? * force;
                let torque = point.onset.push.torque / reach;
                Some((force_of(point) / scale, torque / scale))
            };
            points.filter_map(place).collect()
        };
        let mut figure = Figure::new(
            format!(
                "Onset of sliding: {}, {} bonds (a model)",
                self.patch, self.bond
            ),
            Axis::linear("force/F_s"),
            Axis::linear("torque/(F_s R)"),
        )
        .series(Series::line("onset", curve(&|_| Some(1.0))))
        .series(Series::dashed(
            "limit surface, static coefficient",
            curve(&|point| Some(point.of_limit)),
        ));
        if surface.summary().static_over_dynamic.is_some() {
            let dynamic = curve(&|point| point.static_over_dynamic);
            figure = figure.series(Series::dashed("limit surface, steady sliding", dynamic));
        }
        Ok(image::write_as_named(path, &figure, || csv(surface))?)
    }
}

/// |F| with the sign of a push.
fn force_of(point: &OnsetPoint) -> f64 {
    point.onset.push.force.norm()
}

/// Zero for a share that is a rounding error.
fn without_noise(share: f64) -> f64 {
    if share.abs() < ROUNDING { 0.0 } else { share }
}

/// Rounding errors of sums over nodes, of their largest value.
const ROUNDING: f64 = 1e-13;

/// One row of the table; NaN where bonds do not re-form.
fn row(point: &OnsetPoint) -> [f64; 9] {
    let (push, displacement) = (&point.onset.push, &point.onset.displacement);
    let ratio = point.static_over_dynamic.unwrap_or(f64::NAN);
    [
        point.share,
        push.force.x,
        push.force.y,
        push.torque,
        displacement.velocity.x,
        displacement.velocity.y,
        displacement.spin,
        point.of_limit,
        ratio,
    ]
    // No minus before a zero.
    .map(|x| x + 0.0)
}

fn csv(surface: &OnsetSurface) -> String {
    let rows: Vec<[f64; 9]> = surface.points().iter().map(row).collect();
    series_csv(&COLUMNS, rows.iter().map(<[f64; 9]>::as_slice))
}
