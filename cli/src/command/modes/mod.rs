//! `tribos modes`: fixed points of the velocity ratio, the final mode, the phase diagram.

use super::digits::shown;
use super::number;
use crate::failure::Failure;
use serde_json::{Map, Value, json};
use std::path::PathBuf;
use tribos::friction::{Patch, leaning, upright};
use tribos::record::json_number;
use tribos_core::coupling::PowerLawFriction;
use tribos_core::modes::{FixedPoints, Stability, TerminalMode, TerminalMotion};
use tribos_report::diagram::Diagram;
use tribos_report::image;

/// Where the velocity ratio v/(omega R) of a free slider goes: its fixed points for the exponent
/// alpha, the inertia ratio C = I/(M R^2) and the patch, and what dominates just before rest.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Exponent of the local law, > -1 (0 is Coulomb).
    #[arg(long, value_parser = number::exponent, allow_negative_numbers = true)]
    alpha: f64,
    /// C = I/(M R^2), with R the radius of the contact: 0.5 for a disk on its own face.
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    inertia_ratio: f64,
    /// Contact patch: disk, ring, annulus:INNER, hertz, punch, paraboloid or
    /// polynomial:a0,a1,... (r in radii).
    #[arg(long, default_value = "disk")]
    patch: Patch,
    /// Lean of a tall body, mu H/(radius <r^2>) for a body of height H: 2 mu H/radius for a
    /// cylinder. Dry friction only; from 0 (flat) to 1.
    #[arg(long, default_value = "0", value_parser = number::lean, allow_negative_numbers = true)]
    lean: f64,
    /// Ratio at the launch; decides between two stable ends.
    #[arg(long, value_parser = number::ratio, allow_negative_numbers = true)]
    initial_ratio: Option<f64>,
    /// Output format.
    #[arg(long, default_value = "text")]
    format: Format,
    /// Write the phase diagram in the (alpha, C) plane: FILE.svg, FILE.png or FILE.csv.
    #[arg(long, value_name = "FILE")]
    diagram: Option<PathBuf>,
}

/// Format of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    Text,
    Json,
}

const EXAMPLES: &str = "\
Examples:
  A disk under dry friction stops sliding and spinning together:
    tribos modes --alpha 0 --inertia-ratio 0.5
  Under cubic drag its end depends on its start:
    tribos modes --alpha 3 --inertia-ratio 0.5 --initial-ratio 0.7 --format json
  A curling rock on its running band, under friction that falls with speed:
    tribos modes --alpha -0.5 --inertia-ratio 2.69 --patch ring
  A tall cylinder leans on its front edge and settles at a larger ratio:
    tribos modes --alpha 0 --inertia-ratio 0.5 --lean 0.8
  The phase diagram with this body marked:
    tribos modes --alpha 0 --inertia-ratio 0.5 --diagram diagram.svg";

/// The answer.
struct Answer {
    alpha: f64,
    inertia_ratio: f64,
    interval: (f64, f64),
    points: FixedPoints<f64>,
    mode: Option<TerminalMode<f64>>,
}

impl Arguments {
    /// Computes, prints and draws.
    pub fn execute(self) -> Result<(), Failure> {
        let answer = self.answer()?;
        if let Some(path) = &self.diagram {
            let interval = |alpha| {
                let profile = upright(&self.patch, alpha)?;
                // The interval does not depend on the body.
                let modes = TerminalMotion::new(&*profile, 1.0).map_err(Failure::input)?;
                Ok::<_, Failure>(modes.inertia_interval())
            };
            let diagram = Diagram::whole(format!("{:?}", self.patch).to_lowercase(), interval)?;
            let figure = diagram.figure(Some((answer.alpha, answer.inertia_ratio)));
            image::write_as_named(path, &figure, || diagram.csv())?;
        }
        match self.format {
            Format::Text => {
                let written = self.diagram.as_ref().map_or(String::new(), |path| {
                    format!("written to {}\n", path.display())
                });
                super::print(&(answer.text() + &written))
            }
            Format::Json => super::print(&format!("{:#}\n", answer.json())),
        }
    }

    fn answer(&self) -> Result<Answer, Failure> {
        if self.lean == 0.0 {
            return self.answer_of(&*upright(&self.patch, self.alpha)?);
        }
        if self.alpha != 0.0 {
            return Err(Failure::input(
                "--lean needs --alpha 0: under other laws the lean changes with the speed, and \
                 the velocity ratio obeys no equation of its own",
            ));
        }
        self.answer_of(&*leaning(&self.patch, self.lean)?)
    }

    fn answer_of<P: PowerLawFriction<f64> + ?Sized>(&self, profile: &P) -> Result<Answer, Failure> {
        let modes = TerminalMotion::new(profile, self.inertia_ratio).map_err(Failure::input)?;
        let points = modes.fixed_points();
        // Without a start the end is known only where it does not depend on it.
        let mode = match (self.initial_ratio, points.finite) {
            (Some(initial), _) => Some(modes.terminal_mode(initial)),
            (None, Some((_, Stability::Unstable))) => None,
            (None, None) if points.spinning == Stability::Semistable => None,
            (None, _) => Some(modes.terminal_mode(1.0)),
        };
        Ok(Answer {
            alpha: self.alpha,
            inertia_ratio: self.inertia_ratio,
            interval: modes.inertia_interval(),
            points,
            mode,
        })
    }
}

/// A stability in lower case.
fn in_words(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Semistable => "semistable",
        Stability::Unstable => "unstable",
    }
}

impl Answer {
    /// All fixed points by increasing ratio.
    fn points(&self) -> Vec<(f64, &'static str)> {
        let mut points = vec![(0.0, in_words(self.points.spinning))];
        points.extend(
            self.points
                .finite
                .map(|(ratio, stability)| (ratio, in_words(stability))),
        );
        points.push((f64::INFINITY, in_words(self.points.sliding)));
        points
    }

    /// The final mode's name and ratio.
    fn mode(&self) -> (String, Option<f64>) {
        match (self.mode, self.points.finite) {
            (Some(TerminalMode::Spinning), _) => ("spinning".into(), Some(0.0)),
            (Some(TerminalMode::Sliding), _) => ("sliding".into(), Some(f64::INFINITY)),
            (Some(TerminalMode::Together { ratio }), _) => ("together".into(), Some(ratio)),
            (None, Some(_)) => ("depends on the initial ratio".into(), None),
            (None, None) => ("keeps the initial ratio".into(), None),
        }
    }

    fn json(&self) -> Value {
        let points: Vec<Value> = self
            .points()
            .into_iter()
            .map(|(ratio, stability)| json!({"ratio": json_number(ratio), "stability": stability}))
            .collect();
        let (mode, ratio) = self.mode();
        let mut map = Map::new();
        map.insert("alpha".into(), json_number(self.alpha));
        map.insert("inertia_ratio".into(), json_number(self.inertia_ratio));
        map.insert("c_min".into(), json_number(self.interval.0));
        map.insert("c_max".into(), json_number(self.interval.1));
        map.insert("fixed_points".into(), points.into());
        map.insert("final_mode".into(), mode.into());
        map.insert("final_ratio".into(), ratio.map_or(Value::Null, json_number));
        map.insert("rests_in_finite_time".into(), (self.alpha < 1.0).into());
        Value::Object(map)
    }

    fn text(&self) -> String {
        let (low, high) = self.interval;
        let mut text = format!(
            "alpha = {}, C = {}\nfinite fixed point for {} < C < {}\n",
            self.alpha,
            self.inertia_ratio,
            shown(low),
            shown(high)
        );
        for (ratio, stability) in self.points() {
            text += &format!("  ratio {:<12} {stability}\n", shown(ratio));
        }
        let (mode, ratio) = self.mode();
        text += &match (mode.as_str(), ratio) {
            ("together", Some(ratio)) => {
                format!(
                    "final mode: both motions fade together at ratio {}\n",
                    shown(ratio)
                )
            }
            _ => format!("final mode: {mode}\n"),
        };
        text += if self.alpha < 1.0 {
            "rest after a finite time\n"
        } else {
            "rest only in the limit of infinite time\n"
        };
        text
    }
}
