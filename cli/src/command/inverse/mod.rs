//! `tribos inverse`: how to launch a body that shall come to rest at a wanted pose.

mod angle;
mod output;
mod plot;

use super::number;
use crate::command::digits::shown;
use crate::failure::Failure;
use output::Format;
use std::num::NonZeroU32;
use std::path::PathBuf;
use tribos::friction::{Patch, upright};
use tribos::record::write_atomically;
use tribos::slide::inverse::{LaunchLimits, Launches, Pose, RestMap, Turns};
use tribos_report::image::Drawing;

/// Find every launch (speed, direction, spin) after which a flat body comes to rest at the wanted
/// pose, in order of kinetic energy. The body starts at the origin with angle 0 and slides under the local
/// law `coefficient` * |v|^`alpha`, alpha < 1.
///
/// A pose that no launch within the limits reaches is refused with exit code 2; the message gives
/// the launch that it would need and the reach of the limits.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// First coordinate of the position at rest [m].
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true)]
    x: f64,
    /// Second coordinate of the position at rest [m].
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true)]
    y: f64,
    /// Angle at rest [rad, or with the suffix deg].
    #[arg(long, value_parser = angle::parse, allow_hyphen_values = true)]
    angle: angle::Angle,
    /// What the angle means.
    #[arg(long, default_value = "modulo")]
    turns: Meaning,
    /// Order of the body's rotational symmetry: orientations repeat after 360/N degrees.
    #[arg(long, value_name = "N", default_value = "1", value_parser = number::count)]
    symmetry: NonZeroU32,
    /// Friction coefficient [(s/m)^alpha].
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    coefficient: f64,
    /// Exponent of the local law, -1 < alpha < 1 (0 is Coulomb).
    #[arg(long, default_value = "0", value_parser = number::exponent, allow_negative_numbers = true)]
    alpha: f64,
    /// Acceleration that presses the body down [m/s^2].
    #[arg(long, default_value = "9.81", value_parser = number::positive, allow_negative_numbers = true)]
    gravity: f64,
    /// Radius of the contact [m].
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    radius: f64,
    /// C = I/(M R^2), with R the radius of the contact: 0.5 for a disk on its own face.
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    inertia_ratio: f64,
    /// Contact: disk, ring, annulus:INNER (inner over outer radius), hertz, punch, paraboloid or
    /// polynomial:a0,a1,... (pressure a0 + a1 r^2 + ..., r in radii).
    #[arg(long, default_value = "disk")]
    patch: Patch,
    /// Largest speed of a launch [m/s].
    #[arg(long, value_parser = number::not_negative, allow_negative_numbers = true)]
    max_speed: f64,
    /// Largest spin of a launch, in either sense [rad/s].
    #[arg(long, value_parser = number::not_negative, allow_negative_numbers = true)]
    max_spin: f64,
    /// Largest number of launches that are computed and listed, those with the fewest turns, up to
    /// 100000; the total number is always printed.
    #[arg(long, value_name = "N", default_value = "1000", value_parser = most)]
    most: u64,
    /// Add the derivatives of the pose (x, y, angle) by the launch (vx, vy, spin).
    #[arg(long)]
    jacobian: bool,
    /// Output format.
    #[arg(long, default_value = "text")]
    format: Format,
    /// Draw the poses within the limits, distance against turns, with the solutions: FILE.svg or
    /// FILE.png.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// Most launches that are listed.
const MOST_LISTED: u64 = 100_000;

fn most(text: &str) -> Result<u64, String> {
    let most = text.trim().parse::<u64>().ok();
    most.filter(|most| (1..=MOST_LISTED).contains(most))
        .ok_or(format!(
            "give a whole number from 1 to {MOST_LISTED}; each launch that is listed takes about \
             5 kB of memory: for more, lower --max-spin or narrow --angle with --turns exact"
        ))
}

/// What the wanted angle means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Meaning {
    /// The orientation at rest, after any number of turns in either sense.
    Modulo,
    /// The total angle turned.
    Exact,
}

const EXAMPLES: &str = "\
Examples:
  A puck of 8 cm that shall lie 1.2 m ahead, 0.3 m aside, turned by a quarter:
    tribos inverse --x 1.2 --y 0.3 --angle 90deg --coefficient 0.3 --radius 0.08 \\
      --inertia-ratio 0.5 --max-speed 3 --max-spin 100
  The same for a square part on a ring contact, as JSON with derivatives:
    tribos inverse --x 1.2 --y 0.3 --angle 90deg --symmetry 4 --patch ring --coefficient 0.3 \\
      --radius 0.08 --inertia-ratio 0.5 --max-speed 3 --max-spin 100 --jacobian --format json
  Exactly two turns and a half, with a map of what the limits reach:
    tribos inverse --x 1 --y 0 --angle 900deg --turns exact --coefficient 0.3 --radius 0.08 \\
      --inertia-ratio 0.5 --max-speed 3 --max-spin 100 --plot reach.svg";

impl Arguments {
    /// Solves, draws and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let law = upright(&self.patch, self.alpha)?;
        let deceleration = self.coefficient * self.gravity;
        let map = RestMap::new(&*law, deceleration, self.radius, self.inertia_ratio)
            .map_err(Failure::input)?;
        let limits = LaunchLimits::new(self.max_speed, self.max_spin).map_err(Failure::input)?;
        let target = Pose {
            x: self.x,
            y: self.y,
            angle: self.angle.radians,
        };
        if let Some(hint) = self.angle.hint() {
            super::note(format_args!("note: {hint}"));
        }
        let Launches { count, solutions } = map
            .fewest_turns(&target, self.meaning(), &limits, self.most)
            .map_err(Failure::input)?;
        let listed = solutions.len() as u64;
        if listed < count {
            let many = match count {
                u64::MAX => format!("more than {count}"),
                _ => count.to_string(),
            };
            let cure = if count <= MOST_LISTED {
                format!("--most {count} for all")
            } else {
                "lower --max-spin for fewer".into()
            };
            let listed = match listed {
                1 => "the one with the fewest turns is".into(),
                _ => format!("the {listed} with the fewest turns are"),
            };
            super::note(format_args!(
                "note: {many} launches lead there; {listed} listed ({cure})"
            ));
        }
        if let Some(path) = &self.plot {
            let figure = plot::figure(&map, &limits, &target, &solutions);
            let bytes = match path.extension().and_then(|ending| ending.to_str()) {
                Some("svg") => figure.to_svg()?.into_bytes(),
                Some("png") => figure.to_png()?,
                _ => {
                    let name = path.display();
                    let message = format!("--plot {name}: end the name in .svg or .png");
                    return Err(Failure::input(message));
                }
            };
            write_atomically(path, &bytes)?;
        }
        let rows: Vec<output::Row> = solutions
            .iter()
            .map(|solution| output::Row {
                solution: *solution,
                jacobian: self.jacobian.then(|| map.jacobian(&solution.launch)),
            })
            .collect();
        let wanted = format!(
            "to x {} m, y {} m, angle {}",
            shown(self.x),
            shown(self.y),
            self.angle.text()
        );
        output::print(&self.format.render(&rows, &wanted))
    }

    fn meaning(&self) -> Turns {
        match self.turns {
            Meaning::Exact => Turns::Exact,
            Meaning::Modulo => Turns::Modulo {
                symmetry: self.symmetry,
            },
        }
    }
}
