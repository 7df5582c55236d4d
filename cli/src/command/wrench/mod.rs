//! `tribos wrench`: force and torque of one twist or of a file of twists.

mod output;
mod twists;

use super::number;
use super::tier::{self, Precision, Tabulated, Tier};
use crate::failure::Failure;
use output::{Format, Line};
use std::path::PathBuf;
use tribos::record::write_atomically;
use tribos_core::Real;
use tribos_core::coupling::{Coupling, PatchFriction};

/// Friction force and torque of a uniform disk under the local law
/// `coefficient` * |v|^`alpha`, as magnitudes that oppose the motion.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Exponent of the local law, > -1 (0 is Coulomb).
    #[arg(long, default_value = "0", value_parser = number::exponent, allow_negative_numbers = true)]
    alpha: f64,
    /// Friction coefficient [(s/m)^alpha].
    #[arg(long, default_value = "1", value_parser = number::not_negative, allow_negative_numbers = true)]
    coefficient: f64,
    /// Load [N].
    #[arg(long, default_value = "1", value_parser = number::not_negative, allow_negative_numbers = true)]
    load: f64,
    /// Radius of the contact [m].
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    radius: f64,
    /// Sliding speed [m/s]; its sign is ignored.
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true,
          required_unless_present = "twists", conflicts_with = "twists")]
    speed: Option<f64>,
    /// Spin [rad/s]; its sign is ignored.
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true,
          required_unless_present = "twists", conflicts_with = "twists")]
    spin: Option<f64>,
    /// CSV file with columns `speed,spin`, one twist a line (`-` for standard input).
    #[arg(long, value_name = "FILE")]
    twists: Option<PathBuf>,
    /// Add the derivatives dforce_dspeed, dforce_dspin, dtorque_dspeed, dtorque_dspin.
    #[arg(long)]
    jacobian: bool,
    /// Accuracy tier [default: table, or compact for alpha > 10].
    #[arg(long)]
    tier: Option<Tier>,
    /// Floating-point type.
    #[arg(long, default_value = "f64")]
    precision: Precision,
    /// Output format [default: text for one twist, csv for a file].
    #[arg(long)]
    format: Option<Format>,
    /// Write to this file instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  A puck of 0.17 kg and 3 cm radius at 2 m/s and 40 rad/s:
    tribos wrench --coefficient 0.25 --load 1.67 --radius 0.03 --speed 2 --spin 40
  The dimensionless functions F and T at the ratio 0.5, with derivatives, as JSON:
    tribos wrench --alpha 0.5 --speed 0.5 --spin 1 --jacobian --format json
  Many twists from a file, evaluated without tables in single precision:
    tribos wrench --twists twists.csv --tier compact --precision f32 --output wrenches.csv";

impl Arguments {
    /// Evaluates and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let twists = match (&self.twists, self.speed, self.spin) {
            (Some(path), ..) => twists::read(path)?,
            (None, Some(speed), Some(spin)) => vec![[speed, spin]],
            _ => return Err(Failure::input("give --speed and --spin, or --twists FILE")),
        };
        let lines = match self.precision {
            Precision::F64 => self.evaluate::<f64>(&twists)?,
            Precision::F32 => self.evaluate::<f32>(&twists)?,
        };
        let default = if self.twists.is_some() {
            Format::Csv
        } else {
            Format::Text
        };
        let text = self
            .format
            .unwrap_or(default)
            .render(&lines, self.twists.is_some());
        match &self.output {
            Some(path) => Ok(write_atomically(path, text.as_bytes())?),
            None => super::print(&text),
        }
    }

    fn evaluate<R: Tabulated>(&self, twists: &[[f64; 2]]) -> Result<Vec<Line>, Failure> {
        let coupling = tier::coupling::<R>(self.alpha, self.tier)?;
        let narrow = |name, x| in_range::<R>(name, x);
        let radius = narrow("radius", self.radius)?;
        let coefficient = narrow("coefficient", self.coefficient)?;
        let friction =
            PatchFriction::new(coupling.as_ref(), coefficient, radius).map_err(Failure::input)?;
        let load = narrow("load", self.load)?;
        twists
            .iter()
            .map(|&[speed, spin]| {
                let (v, w) = (narrow("speed", speed)?, narrow("spin", spin)?);
                Ok(self.line(&friction, load, [speed, spin], (v, w)))
            })
            .collect()
    }

    fn line<R: Real>(
        &self,
        friction: &PatchFriction<R, &dyn Coupling<R>>,
        load: R,
        twist: [f64; 2],
        (speed, spin): (R, R),
    ) -> Line {
        let wrench = friction.magnitudes(load, speed.abs(), spin.abs());
        let jacobian = self.jacobian.then(|| {
            let j = friction.magnitudes_jacobian(load, speed.abs(), spin.abs());
            [j.force_speed, j.force_spin, j.torque_speed, j.torque_spin].map(R::to_f64)
        });
        Line {
            twist,
            force: wrench.force.to_f64(),
            torque: wrench.torque.to_f64(),
            jacobian,
        }
    }
}

/// `x` in the precision asked for; refused if it overflows there.
fn in_range<R: Real>(name: &str, x: f64) -> Result<R, Failure> {
    let narrow = R::from_f64(x);
    if narrow.is_finite() {
        Ok(narrow)
    } else {
        Err(Failure::input(format!(
            "{name} {x} is too large for f32; use --precision f64"
        )))
    }
}
