//! `tribos wrench`: force and torque of one twist or of a file of twists.

mod contact;
mod extended_range;
mod extreme;
mod given;
mod output;
mod planar;

use super::{file, number, spool};
use crate::failure::Failure;
use contact::{Contact, Request, Resistance};
use extended_range::ExtendedRange;
use given::ContactParameter;
use number::in_range;
use output::{Fields, Format, Line};
pub use planar::centre;
use std::path::{Path, PathBuf};
use tribos::friction::{
    Coefficients, ContactRadius, FlatPatch, Law, Patch, Precision, Tier, load_of_feet,
};
use tribos::record::Rows;
use tribos::record::write_atomically;

/// Friction force and torque of a contact under the local law `coefficient` * |v|^`alpha`, or
/// another law.
///
/// `force` and `torque` are the resistance, with the signs of the motion that they oppose: the body
/// feels -force along x, along which it slides with `speed`, and -torque about z, about which it
/// spins counterclockwise with `spin`. Friction takes the power force*speed + torque*spin, and the
/// Jacobian is the derivative of just these. The answer repeats the contact that it is for.
///
/// Boxes, polygons, bars, meshes, ellipses, bolts and feet answer with the wrench on the body instead, force_x, force_y
/// and torque, which has the opposite sign.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Contact patch.
    #[arg(long, default_value = "disk", long_help = format!("Contact patch: {}.\n\
        A polynomial is the pressure a0 + a1 r^2 + ..., power:Q the pressure (1-r^2)^Q, r in radii. The file of points has columns x,y [m] and weight; the body slides along x, or with \
        --jacobian or --twists velocity_x,velocity_y,spin answers as boxes do. Boxes, polygons, bars and meshes are exact for \
        dry friction, boxes and polygons for every alpha too: the wrench is that on the body about the origin of the \
        corners, and --twists has columns velocity_x,velocity_y,spin.", patches()))]
    patch: Patch,
    /// Centre of pressure of a box or a polygon, under a pressure that is linear [m]; without it the
    /// pressure is uniform.
    #[arg(long, value_name = "X,Y", value_parser = planar::centre, allow_hyphen_values = true)]
    centre: Option<[f64; 2]>,
    /// Local law instead of coefficient and alpha; see `tribos laws`.
    #[arg(long, value_name = "NAME:KEY=VALUE,…", conflicts_with_all = ["alpha", "coefficient"])]
    law: Option<Law>,
    /// Lean of the pressure, p (1 + K x/radius) with x along the velocity; adds the column
    /// `lateral`, the force to the right of x.
    #[arg(long, value_name = "K", value_parser = number::finite, allow_negative_numbers = true,
          long_help = "Lean of the pressure, p (1 + K x/radius) with x along the velocity: \
          K = F H/(Fn radius <r^2>) for a body of height H braked by F, which is 2 F H/(Fn radius) \
          for the uniform disk (thesis eq. 3.37). Adds the column `lateral`: the force on the body \
          to the right of x, which is positive for counterclockwise spin and positive speed.")]
    tilt: Option<f64>,
    /// What to do if --tilt would make the pressure negative.
    #[arg(long, default_value = "error", value_enum)]
    on_lift: TippingPolicy,
    /// Exponent of the local law, > -1 (0 is Coulomb).
    #[arg(long, default_value = "0", value_parser = number::exponent, allow_negative_numbers = true)]
    alpha: f64,
    /// Friction coefficient [(s/m)^alpha]; of dry friction also one along x and one along y, such as 0.5,0.9, or along
    /// an axis and across it, such as 0.5,0.9,30deg.
    #[arg(long, default_value = "1", value_name = "MU[,MU_Y[,AXIS]]", value_parser = number::coefficients,
          allow_hyphen_values = true)]
    coefficient: Coefficients,
    /// CSV file of surfaces that move, columns `surface,x,y,velocity_x,velocity_y,spin`: two rows of one name are points
    /// of a border to whose left the surface lies, three or more the corners of a convex polygon [m, m/s, rad/s]. Beside
    /// them the floor is at rest.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["law", "alpha", "tier", "tilt"])]
    surface: Option<PathBuf>,
    /// Load [N] [default: the sum of the column load of feet, else 1].
    #[arg(long, value_parser = number::not_negative, allow_negative_numbers = true)]
    load: Option<f64>,
    /// Radius of the contact [m], or what makes it of the load, such as hertz:modulus=1e6,radius=0.01.
    #[arg(long, default_value = "1", value_name = "R", value_parser = number::radius, allow_negative_numbers = true,
          long_help = number::radius_help("Radius of the contact [m], or what makes it of the load."))]
    radius: ContactRadius,
    /// Sliding speed along x [m/s], of either sign [default: 0 where --spin is given].
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true,
          required_unless_present_any = ["twists", "spin", "surface"], conflicts_with = "twists")]
    speed: Option<f64>,
    /// Spin, counterclockwise if positive [rad/s] [default: 0 where --speed is given].
    #[arg(long, value_parser = number::finite, allow_negative_numbers = true, conflicts_with = "twists")]
    spin: Option<f64>,
    /// CSV file with columns `speed,spin`, one twist a line (`-` for standard input); for boxes,
    /// polygons, bars and meshes `velocity_x,velocity_y,spin`, for points either.
    #[arg(long, value_name = "FILE")]
    twists: Option<PathBuf>,
    /// Add the derivatives dforce_dspeed, dforce_dspin, dtorque_dspeed, dtorque_dspin; for boxes,
    /// polygons, bars, meshes and points the nine dforce_x_dvelocity_x ... dtorque_dspin.
    #[arg(long)]
    jacobian: bool,
    /// Accuracy tier [default: exact for coefficient * |v|^alpha, quadrature for other laws].
    #[arg(long, value_parser = number::named::<Tier, 2>([
        ("exact|table|compact", "To rounding: a form for Coulomb's law, a table up to alpha = 10, a series up to 128"),
        ("quadrature", "Quadrature on fixed nodes: about 1e-8 on disk and annulus; elsewhere 1e-3 of \
            the load, for alpha < 0 far less (1e-2 at -0.2, a third of the load at -0.5)"),
    ]))]
    tier: Option<Tier>,
    /// Floating-point type.
    #[arg(long, default_value = "f64")]
    precision: FloatType,
    /// Output format [default: text for one twist, csv for a file].
    #[arg(long)]
    format: Option<Format>,
    /// Write to this file instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Floating-point type of the evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum FloatType {
    /// 64 bit.
    F64,
    /// 32 bit.
    F32,
}

/// What to do with a body that tips.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum TippingPolicy {
    /// Refuse.
    Error,
    /// Hold the lean where the trailing edge is free of load.
    Clamp,
}

const EXAMPLES: &str = "\
Examples:
  A puck of 0.17 kg and 3 cm radius at 2 m/s and 40 rad/s:
    tribos wrench --coefficient 0.25 --load 1.67 --radius 0.03 --speed 2 --spin 40
  The dimensionless functions F and T at the ratio 0.5, with derivatives, as JSON:
    tribos wrench --alpha 0.5 --speed 0.5 --spin 1 --jacobian --format json
  A ball on a soft pad with a Stribeck law, and a tall cylinder's sideways force:
    tribos wrench --patch hertz --law stribeck:mu_s=0.2,mu_d=0.1,vs=0.01 --radius 0.01 --speed 0.1 --spin 5
    tribos wrench --tilt 0.6 --coefficient 0.2 --load 10 --radius 0.08 --speed 1 --spin 5
  A box whose weight is towards its front, and one half of which lies on a belt:
    tribos wrench --patch box:0.3x0.2 --centre 0.03,0 --coefficient 0.4 --load 20 --speed 0.5 --spin 3
    tribos wrench --patch box:0.3x0.2 --coefficient 0.4 --load 20 --speed 0 --surface belts.csv
  The contact face of a solver, triangles with a pressure at each corner:
    tribos wrench --patch mesh:face.csv --coefficient 0.5 --load 80 --speed 0.1 --spin 2 --jacobian
  Many twists from a file, in single precision:
    tribos wrench --twists twists.csv --precision f32 --output wrenches.csv";

/// All patches as they are written.
pub fn patches() -> String {
    let all: Vec<&str> = Patch::SYNTAX.iter().map(|(syntax, _)| *syntax).collect();
    all.join(", ")
}

/// The load in N: the one that is given, what the rows of a file of feet add up to, or 1.
pub fn load(given: Option<f64>, patch: &Patch) -> Result<f64, Failure> {
    match (given, patch) {
        (Some(load), _) => Ok(load),
        (None, Patch::Flat(FlatPatch::Feet(file))) => Ok(load_of_feet(file)?.unwrap_or(1.0)),
        (None, _) => Ok(1.0),
    }
}

impl Arguments {
    /// Evaluates and prints.
    pub fn execute(self) -> Result<(), Failure> {
        match self.precision {
            FloatType::F64 => self.evaluate::<f64>(),
            FloatType::F32 => self.evaluate::<f32>(),
        }
    }

    fn evaluate<R: Precision>(&self) -> Result<(), Failure> {
        if let Some(output) = &self.output {
            let files = self.twists.iter().chain(&self.surface);
            for input in files.map(PathBuf::as_path).chain(self.patch.file()) {
                file::refuse_input("--output", output, input)?;
            }
        }
        let is_planar = self.surface.is_some() || !self.coefficient.is_isotropic();
        if is_planar || matches!(self.patch, Patch::Flat(_) | Patch::WornAnnulus(_)) {
            return planar::of_edges::<R>(self);
        }
        if let Patch::Points(points) = &self.patch
            && planar::is_asked_of_points(self)?
        {
            return planar::of_points::<R>(self, points);
        }
        if self.centre.is_some() {
            return Err(Failure::input(
                "--centre is for boxes and polygons; --tilt leans the pressure of a round patch",
            ));
        }
        let contact = Contact::<R>::new(&self.request()?)?;
        let load = in_range("load", self.load()?)?;
        if let Some(caveat) = contact.caveat() {
            super::warn(format_args!("warning: {caveat}"));
        }
        let at = |twist| self.line(&contact, load, twist);
        match &self.twists {
            Some(file) => {
                let given = given::contact(self, contact.tier())?;
                let at = |twist| at(twist).map(|line: Line| (line.fields(), line.is_beyond));
                self.all(file, &["speed", "spin"], &given, at)
            }
            None => {
                let format = self.format.unwrap_or(Format::Text);
                let given = given::contact(self, contact.tier())?;
                let line = at(self.twist())?;
                warn_of_beyond(u64::from(line.is_beyond));
                self.deliver(&format.one(&line.fields(), &given), format, &given)
            }
        }
    }

    /// The radius under the load, in m.
    fn radius(&self) -> Result<f64, Failure> {
        Ok(self.radius.at(self.load()?)?)
    }

    fn load(&self) -> Result<f64, Failure> {
        load(self.load, &self.patch)
    }

    /// Whether a radius was asked for that is not the default.
    fn has_radius(&self) -> bool {
        self.radius != ContactRadius::Given(1.0)
    }

    /// The one twist: what is not given is 0.
    fn twist(&self) -> [f64; 2] {
        [self.speed, self.spin].map(|part| part.unwrap_or(0.0))
    }

    /// Prints one answer, or writes it to the file that was asked for.
    fn deliver(
        &self,
        text: &str,
        format: Format,
        given: &[ContactParameter],
    ) -> Result<(), Failure> {
        if format == Format::Csv {
            // Columns have no place for the contact.
            super::note(format_args!("contact: {}", given::sentence(given)));
        }
        match &self.output {
            Some(path) => {
                write_atomically(path, text.as_bytes())?;
                super::note(format_args!("written to    {}", path.display()));
                Ok(())
            }
            None => super::print(text),
        }
    }

    /// Evaluates a file of twists row by row: memory does not grow with their number. Nothing is
    /// printed, and no file replaced, before all of them are evaluated.
    fn all<const N: usize>(
        &self,
        file: &Path,
        columns: &'static [&'static str; N],
        given: &[ContactParameter],
        at: impl Fn([f64; N]) -> Result<(Fields, bool), Failure>,
    ) -> Result<(), Failure> {
        let mut rows = Rows::asked_for(file, |_| columns)?;
        let format = self.format.unwrap_or(Format::Csv);
        let mut beyond = 0;
        spool::deliver(self.output.as_deref(), |sink| {
            let mut twist = [0.0; N];
            let mut count = 0;
            while rows.next(&mut twist)?.is_some() {
                let answer = at(twist).map_err(|failure| rows.refusal(&failure.to_string()));
                let (fields, is_beyond) = answer?;
                sink.put(&format.begin(count, &fields))?;
                sink.put(&format.row(&fields))?;
                beyond += u64::from(is_beyond);
                count += 1;
            }
            sink.put(format.end())
        })?;
        warn_of_beyond(beyond);
        super::note(format_args!("contact: {}", given::sentence(given)));
        if let Some(path) = &self.output {
            super::note(format_args!("written to    {}", path.display()));
        }
        Ok(())
    }

    /// The contact asked for; what makes no sense together is refused.
    fn request(&self) -> Result<Request<'_>, Failure> {
        let tilted = self.tilt.is_some_and(|tilt| tilt != 0.0);
        let tilt = match (self.tilt, self.on_lift) {
            (Some(tilt), TippingPolicy::Error) if tilt.abs() > 1.0 => {
                return Err(Failure::input(format!(
                    "--tilt {tilt} makes the pressure negative: the body tips; \
                     give -1 <= K <= 1, or --on-lift clamp"
                )));
            }
            (tilt, _) => tilt.map(|tilt| tilt.clamp(-1.0, 1.0)),
        };
        if self.jacobian && tilted {
            return Err(Failure::input(
                "--jacobian is for upright patches: leave out --tilt",
            ));
        }
        Ok(Request {
            patch: &self.patch,
            law: self.law,
            alpha: self.alpha,
            tier: self.tier,
            coefficient: self.coefficient.largest(),
            radius: self.radius()?,
            tilt,
        })
    }

    fn line<R: Precision>(
        &self,
        contact: &Contact<R>,
        load: R,
        twist: [f64; 2],
    ) -> Result<Line, Failure> {
        let [speed, spin] = twist;
        let (speed, spin): (R, R) = (in_range("speed", speed)?, in_range("spin", spin)?);
        let is_round = !matches!(self.patch, Patch::Points(_));
        // Those of a round patch are mirrored afterwards.
        let (v, w) = if is_round {
            (speed.abs(), spin.abs())
        } else {
            (speed, spin)
        };
        let is_ordinary = contact.is_ordinary(load, v, w);
        let mut is_beyond = false;
        let mut value = |product: ExtendedRange| {
            let (x, is_right) = product.narrowed::<R>();
            is_beyond |= !is_right;
            x.to_f64()
        };
        let resistance = if is_ordinary {
            contact.resistance(load, v, w).map(R::to_f64)
        } else {
            contact.extreme_resistance(load, v, w)?.map(&mut value)
        };
        let resistance = if is_round {
            resistance.signed(twist)
        } else {
            resistance
        };
        let jacobian = if !self.jacobian {
            None
        } else if is_ordinary {
            let entries = contact.jacobian(load, v, w);
            Some(entries.map(|entries| entries.map(R::to_f64)))
        } else {
            let entries = contact.extreme_jacobian(load, v, w)?;
            Some(entries.map(|entries| entries.map(&mut value)))
        };
        let jacobian = match jacobian {
            None => None,
            Some(Some([force_speed, mixed, torque_spin])) => {
                let opposed = (twist[0] < 0.0) != (twist[1] < 0.0);
                let mixed = if opposed { 0.0 - mixed } else { mixed };
                Some([force_speed, mixed, mixed, torque_spin])
            }
            Some(None) => {
                return Err(Failure::input(
                    "--jacobian is not served by nodes; use --patch disk or annulus with --law, \
                     or another tier",
                ));
            }
        };
        let with_lateral = self.tilt.is_some() || !is_round;
        let Resistance {
            force,
            lateral,
            torque,
        } = resistance;
        let shown = [force, torque, if with_lateral { lateral } else { 0.0 }];
        let no_number = shown
            .iter()
            .chain(jacobian.iter().flatten())
            .any(|x| x.is_nan());
        Ok(Line {
            twist,
            force,
            torque,
            lateral: with_lateral.then_some(lateral),
            jacobian,
            is_beyond: is_beyond || no_number,
        })
    }
}

/// Says that results left the number range, if any did.
fn warn_of_beyond(lines: u64) {
    if lines > 0 {
        super::warn(format_args!(
            "warning: {} {} results that are no normal numbers of the precision: too large ones are \
             inf, too small ones 0 or short of digits, others nan",
            lines,
            if lines == 1 { "line has" } else { "lines have" },
        ));
    }
}
