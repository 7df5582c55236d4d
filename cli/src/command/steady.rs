//! `tribos steady`: the motion in which friction of a floor that moves by part balances a push.

use super::digits::shown;
use super::hold::{Format, force};
use super::number;
use super::wrench::{centre, load, patches};
use crate::failure::Failure;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;
use tribos::friction::{Area, Coefficients, FlatPatch, Floor, Patch, Surface};
use tribos::record::json_number;
use tribos_core::floor::{SteadyMotion, SteadyState};
use tribos_core::twist::{Twist, Wrench};

/// The motion that a body on moving surfaces comes to: a box on two belts, a robot that turns in place, a part on a
/// turntable.
///
/// Every part of the contact slides over its own surface; the body moves such that friction of all parts and a push are
/// in balance. Places are in the coordinates of the body.
///
/// Wheels and treads that a body drives are surfaces too: a foot whose wheel drives the body forwards with 0.3 m/s has a
/// surface of velocity_x 0.3, the velocity at which the body would not slip.
///
/// Where no motion is steady, because the push is more than all parts carry together, the exit code is 4.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Contact patch.
    #[arg(long, default_value = "disk", long_help = format!("Contact patch: {}. Feet may have columns velocity_x,velocity_y,spin: \
        how the surface under each of them moves.", patches()))]
    patch: Patch,
    /// Centre of pressure of a box or a polygon, under a pressure that is linear [m].
    #[arg(long, value_name = "X,Y", value_parser = centre, allow_hyphen_values = true)]
    centre: Option<[f64; 2]>,
    /// Friction coefficient; also one along x and one along y, such as 0.5,0.9, or along an axis and across it, such as
    /// 0.5,0.9,30deg. Feet of a file share what all carry, coefficient times load, by the products of theirs.
    #[arg(long, default_value = "1", value_name = "MU[,MU_Y[,AXIS]]", value_parser = number::coefficients,
          allow_hyphen_values = true)]
    coefficient: Coefficients,
    /// Load [N] [default: the sum of the column load of feet, else 1].
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    load: Option<f64>,
    /// Radius of a round patch [m].
    #[arg(long, default_value = "1", value_parser = number::positive, allow_negative_numbers = true)]
    radius: f64,
    /// CSV file of surfaces that move, columns `surface,x,y,velocity_x,velocity_y,spin`: two rows of one name are points
    /// of a border to whose left the surface lies, three or more the corners of a convex polygon [m, m/s, rad/s]. Beside
    /// them the floor is at rest.
    #[arg(long, value_name = "FILE")]
    surface: Option<PathBuf>,
    /// Force of the push on the body at the origin of the patch [N].
    #[arg(long, value_name = "X,Y", value_parser = force, allow_hyphen_values = true, default_value = "0,0")]
    force: [f64; 2],
    /// Torque of the push about the normal [N m].
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true, default_value = "0")]
    torque: f64,
    /// Output format.
    #[arg(long, default_value = "text")]
    format: Format,
}

const EXAMPLES: &str = "\
Examples:
  A box whose halves lie on two belts that run against each other (a CSV file of surfaces):
    tribos steady --patch box:0.3x0.2 --coefficient 0.4 --load 20 --surface belts.csv
  A robot on four wheels (a CSV file of feet with columns patch,x,y,radius,velocity_x,velocity_y,spin):
    tribos steady --patch feet:robot.csv --coefficient 0.7 --load 300
  The same with a cart behind it, as JSON:
    tribos steady --patch feet:robot.csv --coefficient 0.7 --load 300 --force -40,0 --format json";

impl Arguments {
    /// Solves and prints.
    pub fn execute(self) -> Result<(), Failure> {
        if !self.patch.has_axis() && self.radius != 1.0 {
            return Err(Failure::input(
                "a patch of straight edges, triangles or points has its own size: leave out --radius",
            ));
        }
        let floor = self.floor()?;
        let [x, y] = self.force;
        let push = Wrench::new(x, y, self.torque);
        let motion = match floor.steady_motion(&push) {
            SteadyState::Balanced(motion) => motion,
            SteadyState::Accelerates => {
                return Err(Failure::Unsolved(format!(
                    "no motion is steady: the push is more than the {} N that friction carries, or turns harder; give a \
                     smaller one",
                    shown(floor.limit())
                )));
            }
            SteadyState::Missed(_) => {
                return Err(Failure::Unsolved(
                    "the search for the steady motion has missed it: give points a small area, such as disk with its radius"
                        .into(),
                ));
            }
        };
        match self.format {
            Format::Text => super::print(&text(&motion, floor.limit())),
            Format::Json => super::print(&format!("{:#}\n", json(&motion))),
        }
    }

    fn floor(&self) -> Result<Floor, Failure> {
        let surfaces = self
            .surface
            .as_deref()
            .map_or(Ok(Vec::new()), Surface::read)?;
        match &self.patch {
            Patch::Flat(FlatPatch::Feet(file)) if surfaces.is_empty() => {
                if !self.coefficient.is_isotropic() {
                    return Err(Failure::input(
                        "feet have coefficients of their own: give --coefficient one number and the file the columns mu \
                         and mu_across",
                    ));
                }
                Ok(Floor::feet_of(
                    file,
                    self.coefficient.largest() * load(self.load, &self.patch)?,
                )?)
            }
            patch => {
                let area = Area::named(patch, self.radius, self.centre)?;
                Ok(Floor::under(
                    &area,
                    &self.coefficient,
                    load(self.load, &self.patch)?,
                    &surfaces,
                )?)
            }
        }
    }
}

/// What is less than this share of a whole is rounding.
const ROUNDING: f64 = 1e-12;

/// A number, or 0 where it is rounding of `whole`.
fn told(x: f64, whole: f64) -> String {
    let is_nothing = x.abs() <= ROUNDING * whole;
    shown(if is_nothing { 0.0 } else { x })
}

/// The place of a motion that does not move.
fn pivot(twist: &Twist<f64>) -> Option<[f64; 2]> {
    let at = [
        -twist.velocity.y / twist.spin,
        twist.velocity.x / twist.spin,
    ];
    at.iter().all(|x| x.is_finite()).then_some(at)
}

fn text(motion: &SteadyMotion<f64>, limit: f64) -> String {
    let mut text = String::new();
    let mut line = |name: &str, value: String| {
        let _ = writeln!(text, "{name:<15} {value}");
    };
    let Twist { velocity, spin } = motion.twist;
    let fastest = velocity.x.abs().max(velocity.y.abs()).max(spin.abs());
    let [x, y, turn] = [velocity.x, velocity.y, spin].map(|x| told(x, fastest));
    line("motion", format!("({x}, {y}) m/s, {turn} rad/s"));
    // Far away it is the rounding of a spin that is none.
    let pivot = pivot(&motion.twist).filter(|_| spin.abs() > ROUNDING * fastest);
    if let Some([x, y]) = pivot {
        line(
            "turns about",
            format!("({}, {}) m", told(x, 1.0), told(y, 1.0)),
        );
    }
    let Wrench { force, torque } = motion.friction;
    let [x, y, torque] = [force.x, force.y, torque].map(|x| told(x, limit));
    line("friction", format!("({x}, {y}) N, {torque} N m"));
    if let Some(foot) = motion.carried_by {
        let which = format!(
            "part {} rests on its surface, which takes the body along",
            foot + 1
        );
        line("carried", which);
    }
    text
}

fn json(motion: &SteadyMotion<f64>) -> Value {
    let all =
        |values: &[f64]| -> Vec<Value> { values.iter().map(|x| json_number(x + 0.0)).collect() };
    let Twist { velocity, spin } = motion.twist;
    let Wrench { force, torque } = motion.friction;
    json!({
        "velocity": all(&[velocity.x, velocity.y]),
        "spin": json_number(spin + 0.0),
        "turns_about": pivot(&motion.twist).map(|at| all(&at)),
        "force": all(&[force.x, force.y]),
        "torque": json_number(torque + 0.0),
        "carried_by": motion.carried_by.map(|foot| foot + 1),
        "evaluations": motion.evaluations,
    })
}
