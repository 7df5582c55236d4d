//! `tribos coefficients`: the torsional coefficients of engines that fit a patch best.

mod engines;
mod output;
mod torsion;

use super::number;
use super::wrench::{centre, patches};
use crate::failure::Failure;
use output::Report;
use torsion::Torsion;
use tribos::friction::{Area, Patch};

/// The torsional coefficient that fits a patch best in engines that limit friction at points, and the error
/// that remains.
///
/// MuJoCo, Newton, Gazebo, Bullet and others let one contact point stand for a patch and give it a torsional
/// friction: a length, largest torque over load. The exact torque of the patch depends on how fast it
/// slides beside its spin, and a coefficient is right at one ratio at most. Two are given: the one that is exact where the patch spins alone,
/// T0/N, and the one with the least largest error over all ratios, under the engine's own model. The
/// errors are shares of T0; on patches that are not round they are those of the worst direction of sliding, and sliding is that of the centre of pressure.
///
/// Rolling coefficients are 0: dry friction on a flat patch has no rolling resistance, which is a loss
/// within the bodies. Without --patch a table has T0/(mu N) of all patches with a name.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Contact patch [default: a table of patches].
    #[arg(long, long_help = format!("Contact patch: {}. Without it a table of patches is printed.", patches()))]
    patch: Option<Patch>,
    /// Centre of pressure of a box or a polygon, under a pressure that is linear [m].
    #[arg(long, value_name = "X,Y", value_parser = centre, allow_hyphen_values = true, requires = "patch")]
    centre: Option<[f64; 2]>,
    /// Friction coefficient mu.
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    coefficient: f64,
    /// Radius of a round patch [m] [default: 1].
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    radius: Option<f64>,
    /// Output format.
    #[arg(long, default_value = "text")]
    format: Format,
}

/// Format of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// For people.
    Text,
    /// One object.
    Json,
    /// A header and a line for each engine, or patch.
    Csv,
}

const EXAMPLES: &str = "\
Examples:
  T0/(mu N) of every named patch:
    tribos coefficients
  A rubber foot of 4 x 2 cm at mu 0.8 that one contact point stands for:
    tribos coefficients --patch box:0.04x0.02 --coefficient 0.8
  A fingertip of 6 mm radius for a script, as JSON:
    tribos coefficients --patch hertz --radius 0.006 --coefficient 0.8 --format json";

/// Patches of the table: round ones of radius 1, others of the size in their name.
const NAMED: [&str; 12] = [
    "disk",
    "ring",
    "annulus:0.5",
    "hertz",
    "punch",
    "paraboloid",
    "box:1x1",
    "box:2x1",
    "box:4x1",
    "box:10x1",
    "bar:1",
    "power:2",
];

impl Arguments {
    /// Fits and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let Some(patch) = &self.patch else {
            return self.print_table();
        };
        let own_size = matches!(patch, Patch::Flat(_) | Patch::Points(_));
        if own_size && self.radius.is_some() {
            return Err(Failure::input(
                "a patch of straight edges, triangles or points has its own size: leave out --radius",
            ));
        }
        let area = Area::named(patch, self.radius.unwrap_or(1.0), self.centre)?;
        let torsion = Torsion::new(&area)?;
        let report = Report::new(&torsion, self.coefficient);
        super::print(&match self.format {
            Format::Text => report.text(),
            Format::Json => format!("{:#}\n", report.json()),
            Format::Csv => report.csv(),
        })
    }

    /// T₀/(μN) of the named patches.
    fn print_table(&self) -> Result<(), Failure> {
        let radius = self.radius.unwrap_or(1.0);
        let rows: Result<Vec<_>, Failure> = NAMED
            .iter()
            .map(|name| {
                let patch: Patch = name.parse()?;
                Ok((*name, Torsion::new(&Area::named(&patch, radius, None)?)?))
            })
            .collect();
        let rows = rows?;
        super::print(&match self.format {
            Format::Text => output::patches_text(&rows),
            Format::Json => format!("{:#}\n", output::patches_json(&rows)),
            Format::Csv => output::patches_csv(&rows),
        })
    }
}
