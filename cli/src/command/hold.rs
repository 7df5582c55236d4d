//! `tribos hold`: whether a push moves a body at rest.

use super::digits::shown;
use super::number;
use super::wrench::{centre, patches};
use crate::failure::Failure;
use serde_json::{Value, json};
use std::fmt::Write;
use tribos::friction::{Area, Coefficients, ContactRadius, Patch, StictionTest};
use tribos::record::json_number;
use tribos_core::holding::{Stiction, StictionBounds};
use tribos_core::presliding::Presliding;
use tribos_core::twist::{Displacement, Twist, Wrench};

/// Whether a push moves a body at rest: holds, slips or undecided, with margins.
///
/// A push holds if kinetic friction (mu-d) alone would take more power in every motion than the push
/// gives: then nothing can start, whatever friction at rest is like. It slips if no friction up to the
/// static coefficient (mu-s) balances it. Between the two it depends on how the contact shares the push,
/// which no coefficient tells. The margins are factors: up to the first the push may grow and
/// is certain to be held, beyond the second it is certain to slip.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Contact patch.
    #[arg(long, default_value = "disk", long_help = format!("Contact patch: {}.", patches()))]
    patch: Patch,
    /// Centre of pressure of a box or a polygon, under a pressure that is linear [m].
    #[arg(long, value_name = "X,Y", value_parser = centre, allow_hyphen_values = true)]
    centre: Option<[f64; 2]>,
    /// Static coefficient of friction; also one along x and one along y, such as 0.5,0.9, or along an axis and across it,
    /// such as 0.5,0.9,30deg.
    #[arg(long, value_name = "MU[,MU_Y[,AXIS]]", value_parser = number::coefficients, allow_hyphen_values = true)]
    mu_s: Coefficients,
    /// Kinetic coefficient of friction, at most the static one [default: the static one].
    #[arg(long, value_name = "MU[,MU_Y[,AXIS]]", value_parser = number::coefficients, allow_hyphen_values = true)]
    mu_d: Option<Coefficients>,
    /// Load [N].
    #[arg(long, value_parser = number::not_negative, allow_negative_numbers = true)]
    load: f64,
    /// Radius of a round patch [m], or what makes it of the load, such as hertz:modulus=1e6,radius=0.01 [default: 1].
    #[arg(long, value_name = "R", value_parser = number::radius, allow_negative_numbers = true,
          long_help = number::radius_help("Radius of a round patch [m], or what makes it of the load [default: 1]."))]
    radius: Option<ContactRadius>,
    /// Force of the push on the body at the origin of the patch [N].
    #[arg(long, value_name = "X,Y", value_parser = force, allow_hyphen_values = true, default_value = "0,0")]
    force: [f64; 2],
    /// Torque of the push about the normal [N m].
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true, default_value = "0")]
    torque: f64,
    /// Tangential stiffness of the contact [N/m]: adds the displacement at which it carries the push.
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    stiffness: Option<f64>,
    /// Torsional stiffness of the contact [N m/rad]; stiffness R^2/2 on a uniform disk.
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true, requires = "stiffness")]
    torsional_stiffness: Option<f64>,
    /// Output format.
    #[arg(long, default_value = "text")]
    format: Format,
}

/// Format of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For people.
    Text,
    /// One object.
    Json,
}

const EXAMPLES: &str = "\
Examples:
  A fingertip that presses with 8 N on a disk of 6 mm, pulled by 3 N and twisted by 5 N mm:
    tribos hold --radius 0.006 --mu-s 0.8 --mu-d 0.6 --load 8 --force 3,0 --torque 0.005
  How far it gives way, with 20 N/mm and 0.36 N m/rad:
    tribos hold --radius 0.006 --mu-s 0.8 --load 8 --force 3,0 --torque 0.005 --stiffness 2e4 --torsional-stiffness 0.36
  A box on the floor that is pushed off its middle, as JSON:
    tribos hold --patch box:0.3x0.2 --mu-s 0.5 --mu-d 0.4 --load 20 --force 0,6 --torque 0.5 --format json";

/// The two parts of a force.
pub fn force(text: &str) -> Result<[f64; 2], String> {
    let parts = text.split_once(',');
    let (x, y) = parts.ok_or("give its two parts in N, such as 3,0")?;
    Ok([number::finite(x)?, number::finite(y)?])
}

/// What is known of one push.
struct Answer {
    push: Wrench<f64>,
    holding: StictionBounds<f64>,
    first_motion: Twist<f64>,
    displacement: Option<Displacement<f64>>,
}

impl Arguments {
    /// Judges and prints.
    pub fn execute(self) -> Result<(), Failure> {
        let answer = self.answer()?;
        match self.format {
            Format::Text => super::print(&answer.text()),
            Format::Json => super::print(&format!("{:#}\n", answer.json())),
        }
    }

    fn answer(&self) -> Result<Answer, Failure> {
        let own_size = matches!(self.patch, Patch::Flat(_) | Patch::Points(_));
        if own_size && self.radius.is_some() {
            return Err(Failure::input(
                "a patch of straight edges, triangles or points has its own size: leave out --radius",
            ));
        }
        let mu_d = self.mu_d.unwrap_or(self.mu_s);
        let radius = self.radius.map_or(Ok(1.0), |radius| radius.at(self.load))?;
        let area = Area::named(&self.patch, radius, self.centre)?;
        let contact = StictionTest::new(&area, [self.mu_s, mu_d], self.load)?;
        let [x, y] = self.force;
        let push = Wrench::new(x, y, self.torque);
        let holding = contact.holding(&push);
        let displacement = self.displacement(&push)?;
        Ok(Answer {
            push,
            holding,
            first_motion: contact.first_motion(&push),
            displacement: displacement.filter(|_| holding.stiction != Stiction::Slips),
        })
    }

    /// Where bonds of the given stiffness carry the push.
    fn displacement(&self, push: &Wrench<f64>) -> Result<Option<Displacement<f64>>, Failure> {
        let Some(stiffness) = self.stiffness else {
            return Ok(None);
        };
        // Without torque any torsional stiffness gives no angle.
        let torsional = match self.torsional_stiffness {
            Some(torsional) => torsional,
            None if push.torque == 0.0 => stiffness,
            None => {
                return Err(Failure::input(
                    "--torque turns the contact: give --torsional-stiffness too, \
                     stiffness R^2/2 on a uniform disk",
                ));
            }
        };
        let bonds = Presliding::new(stiffness, torsional);
        let bonds = bonds.map_err(|error| Failure::input(error.to_string()))?;
        Ok(Some(bonds.strain_under(push)))
    }
}

/// The answer in a word.
fn word(hold: Stiction) -> &'static str {
    match hold {
        Stiction::Holds => "holds",
        Stiction::Slips => "slips",
        Stiction::Undecided => "undecided",
    }
}

/// The answer in a sentence.
fn reason(hold: Stiction) -> &'static str {
    match hold {
        Stiction::Holds => {
            "kinetic friction alone takes more power in every motion than the push gives"
        }
        Stiction::Slips => "no friction up to the static coefficient balances the push",
        Stiction::Undecided => "it depends on how the contact shares the push",
    }
}

impl Answer {
    fn text(&self) -> String {
        let StictionBounds {
            stiction: hold,
            certain_gauge,
            possible_gauge,
        } = self.holding;
        let mut text = format!("{:<17} {}\n", word(hold), reason(hold));
        let mut line = |name: &str, value: String| {
            let _ = writeln!(text, "{name:<17} {value}");
        };
        let Wrench { force, torque } = self.push;
        let in_plane = |x: f64, y: f64| format!("({}, {})", shown(x), shown(y));
        let pushed = format!("{} N, {} N m", in_plane(force.x, force.y), shown(torque));
        line("push", pushed);
        let [held, slipping] = [self.holding.certain_scale(), self.holding.possible_scale()];
        let margin = |gauge: f64, scale: f64| {
            format!("{} times the push (gauge {})", shown(scale), shown(gauge))
        };
        line(
            "surely held",
            format!("up to {}", margin(certain_gauge, held)),
        );
        line(
            "surely slips",
            format!("from {}", margin(possible_gauge, slipping)),
        );
        let Twist { velocity, spin } = self.first_motion;
        if self.push != Wrench::ZERO && spin.is_finite() {
            let motion = format!(
                "{} m/s, {} rad/s",
                in_plane(velocity.x, velocity.y),
                shown(spin)
            );
            line("first motion", motion);
        }
        if let Some(Displacement { shift, turn }) = self.displacement {
            let moved = format!("{} m, {} rad", in_plane(shift.x, shift.y), shown(turn));
            line("displacement", moved);
        }
        text
    }

    fn json(&self) -> Value {
        let Wrench { force, torque } = self.push;
        let Twist { velocity, spin } = self.first_motion;
        let all = |values: &[f64]| -> Vec<Value> {
            values.iter().map(|x| json_number(x + 0.0)).collect()
        };
        let mut value = json!({
            "hold": word(self.holding.stiction),
            "force": all(&[force.x, force.y]),
            "torque": json_number(torque),
            "certain_gauge": json_number(self.holding.certain_gauge),
            "possible_gauge": json_number(self.holding.possible_gauge),
            "surely_held_scale": json_number(self.holding.certain_scale()),
            "surely_slipping_scale": json_number(self.holding.possible_scale()),
            "first_motion": all(&[velocity.x, velocity.y, spin]),
        });
        if let Some(Displacement { shift, turn }) = self.displacement {
            value["displacement"] = all(&[shift.x, shift.y, turn]).into();
        }
        value
    }
}
