//! `tribos modes`: fixed points of the velocity ratio, the final mode, the phase diagram.

pub mod diagram;

use super::number;
use crate::failure::Failure;
use crate::report::image::Drawing;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use tribos::record::{json_number, write_atomically};
use tribos_core::coupling::compact::{self, Power};
use tribos_core::coupling::table::{self, Table64};
use tribos_core::modes::{FinalMode, FixedPoints, Modes, Stability, inertia_interval};

/// Where the velocity ratio v/(omega R) of a free slider goes: its fixed points for the exponent
/// alpha and the inertia ratio C = I/(M R^2), and what dominates just before rest.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    /// Exponent of the local law, > -1 (0 is Coulomb).
    #[arg(long, value_parser = number::exponent, allow_negative_numbers = true)]
    alpha: f64,
    /// C = I/(M R^2), with R the radius of the contact: 0.5 for a disk on its own face.
    #[arg(long, value_parser = number::positive, allow_negative_numbers = true)]
    inertia_ratio: f64,
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
  The phase diagram with this body marked:
    tribos modes --alpha 0 --inertia-ratio 0.5 --diagram diagram.svg";

/// The answer.
struct Answer {
    alpha: f64,
    inertia_ratio: f64,
    interval: (f64, f64),
    points: FixedPoints<f64>,
    mode: Option<FinalMode<f64>>,
}

impl Arguments {
    /// Computes, prints and draws.
    pub fn execute(self) -> Result<(), Failure> {
        let answer = if self.alpha == 0.0 {
            self.answer(Modes::new(table::Coulomb, self.inertia_ratio))
        } else if self.alpha <= table::MAX_EXPONENT {
            let table = Table64::new(self.alpha).map_err(Failure::input)?;
            self.answer(Modes::new(&table, self.inertia_ratio))
        } else {
            let power: compact::Power<f64> = Power::new(self.alpha).map_err(Failure::input)?;
            self.answer(Modes::new(power, self.inertia_ratio))
        }?;
        if let Some(path) = &self.diagram {
            write_diagram(path, &answer)?;
        }
        match self.format {
            Format::Text => print!("{}", answer.text()),
            Format::Json => println!("{:#}", answer.json()),
        }
        Ok(())
    }

    fn answer<P: tribos_core::coupling::Profile<f64>>(
        &self,
        modes: Result<Modes<f64, P>, tribos_core::modes::InertiaError>,
    ) -> Result<Answer, Failure> {
        let modes = modes.map_err(Failure::input)?;
        let points = modes.fixed_points();
        // Without a start the end is known only where it does not depend on it.
        let mode = match (self.initial_ratio, points.finite) {
            (Some(initial), _) => Some(modes.final_mode(initial)),
            (None, Some((_, Stability::Unstable))) => None,
            (None, None) if points.spinning == Stability::Semistable => None,
            (None, _) => Some(modes.final_mode(1.0)),
        };
        let interval = inertia_interval(self.alpha, 0.0);
        Ok(Answer {
            alpha: self.alpha,
            inertia_ratio: self.inertia_ratio,
            interval,
            points,
            mode,
        })
    }
}

/// Writes the diagram in the format that the file's ending names.
fn write_diagram(path: &Path, answer: &Answer) -> Result<(), Failure> {
    let ending = path
        .extension()
        .and_then(|ending| ending.to_str())
        .unwrap_or("");
    let bytes = match ending {
        "svg" => diagram::figure(Some((answer.alpha, answer.inertia_ratio)))
            .to_svg()?
            .into_bytes(),
        "png" => diagram::figure(Some((answer.alpha, answer.inertia_ratio))).to_png()?,
        "csv" => diagram::csv().into_bytes(),
        _ => {
            let message = format!(
                "--diagram {}: end the name in .svg, .png or .csv",
                path.display()
            );
            return Err(Failure::input(message));
        }
    };
    Ok(write_atomically(path, &bytes)?)
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
            (Some(FinalMode::Spinning), _) => ("spinning".into(), Some(0.0)),
            (Some(FinalMode::Sliding), _) => ("sliding".into(), Some(f64::INFINITY)),
            (Some(FinalMode::Together { ratio }), _) => ("together".into(), Some(ratio)),
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
            "alpha = {}, C = {}\nfinite fixed point for {low:.6} < C < {high:.6}\n",
            self.alpha, self.inertia_ratio
        );
        for (ratio, stability) in self.points() {
            text += &format!("  ratio {ratio:<22.15} {stability}\n");
        }
        let (mode, ratio) = self.mode();
        text += &match (mode.as_str(), ratio) {
            ("together", Some(ratio)) => {
                format!("final mode: both motions fade together at ratio {ratio:.15}\n")
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
