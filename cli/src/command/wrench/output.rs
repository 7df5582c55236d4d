//! Wrenches as text, JSON or CSV.

use super::given::{self, Given};
use crate::command::digits::shown;
use serde_json::{Map, Value};
use tribos::record::{json_number, series_csv};

/// Format of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For people.
    Text,
    /// One object, or an array of them for a file of twists.
    Json,
    /// A header and a line a twist.
    Csv,
}

/// One evaluated twist.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    pub twist: [f64; 2],
    pub force: f64,
    pub torque: f64,
    /// Only where something can be lateral.
    pub lateral: Option<f64>,
    pub jacobian: Option<[f64; 4]>,
}

const COLUMNS: [&str; 4] = ["speed", "spin", "force", "torque"];
const JACOBIAN: [&str; 4] = [
    "dforce_dspeed",
    "dforce_dspin",
    "dtorque_dspeed",
    "dtorque_dspin",
];
const LATERAL: &str = "lateral";
/// Units in SI, for people.
const UNITS: [(&str, &str); 9] = [
    ("speed", "m/s"),
    ("spin", "rad/s"),
    ("force", "N"),
    ("torque", "N m"),
    (LATERAL, "N"),
    ("dforce_dspeed", "N s/m"),
    ("dforce_dspin", "N s/rad"),
    ("dtorque_dspeed", "N s"),
    ("dtorque_dspin", "N m s/rad"),
];

impl Line {
    /// Names and values.
    fn fields(&self) -> Vec<(&'static str, f64)> {
        let values = [self.twist[0], self.twist[1], self.force, self.torque];
        let mut fields: Vec<_> = COLUMNS.into_iter().zip(values).collect();
        fields.extend(self.lateral.map(|x| (LATERAL, x)));
        if let Some(jacobian) = self.jacobian {
            fields.extend(JACOBIAN.into_iter().zip(jacobian));
        }
        fields
    }

    fn json(&self) -> Value {
        let fields = self.fields().into_iter();
        Value::Object(
            fields
                .map(|(name, x)| (name.into(), json_number(x)))
                .collect::<Map<_, _>>(),
        )
    }

    fn text(&self) -> String {
        let unit = |name| {
            let known = UNITS.iter().find(|(known, _)| *known == name);
            known.map_or("", |(_, unit)| unit)
        };
        self.fields()
            .into_iter()
            .map(|(name, x)| format!("{name:<15} {} {}\n", shown(x), unit(name)))
            .collect()
    }
}

impl Format {
    /// The lines in this format with the contact that they are for, where there is a place for it;
    /// `many` makes an array of JSON even for a single line.
    pub fn render(self, lines: &[Line], contact: &[Given], many: bool) -> String {
        match self {
            Self::Text => {
                let head = if many {
                    String::new()
                } else {
                    given::lines(contact)
                };
                head + &lines.iter().map(Line::text).collect::<Vec<_>>().join("\n")
            }
            Self::Json => {
                let value = match lines {
                    [line] if !many => {
                        let mut value = line.json();
                        value["contact"] = given::json(contact);
                        value
                    }
                    _ => Value::Array(lines.iter().map(Line::json).collect()),
                };
                format!("{value:#}\n")
            }
            Self::Csv => {
                let rows: Vec<Vec<f64>> = lines
                    .iter()
                    .map(|line| line.fields().iter().map(|f| f.1).collect())
                    .collect();
                let columns: Vec<&str> = lines
                    .first()
                    .map(|line| line.fields().iter().map(|f| f.0).collect())
                    .unwrap_or_default();
                series_csv(&columns, rows.iter().map(Vec::as_slice))
            }
        }
    }
}
