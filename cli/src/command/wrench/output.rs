//! Wrenches as text, JSON or CSV.

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
    pub jacobian: Option<[f64; 4]>,
}

const COLUMNS: [&str; 4] = ["speed", "spin", "force", "torque"];
const JACOBIAN: [&str; 4] = [
    "dforce_dspeed",
    "dforce_dspin",
    "dtorque_dspeed",
    "dtorque_dspin",
];
/// Units of all eight in SI, for people.
const UNITS: [&str; 8] = [
    "m/s",
    "rad/s",
    "N",
    "N m",
    "N s/m",
    "N s/rad",
    "N s",
    "N m s/rad",
];

impl Line {
    /// Names and values.
    fn fields(&self) -> Vec<(&'static str, f64)> {
        let values = [self.twist[0], self.twist[1], self.force, self.torque];
        let mut fields: Vec<_> = COLUMNS.into_iter().zip(values).collect();
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
        let lines = self.fields().into_iter().zip(UNITS);
        lines
            .map(|((name, x), unit)| format!("{name:<15} {x:.16e} {unit}\n"))
            .collect()
    }
}

impl Format {
    /// The lines in this format; `many` makes an array of JSON even for a single line.
    pub fn render(self, lines: &[Line], many: bool) -> String {
        match self {
            Self::Text => lines.iter().map(Line::text).collect::<Vec<_>>().join("\n"),
            Self::Json => {
                let value = match lines {
                    [line] if !many => line.json(),
                    _ => Value::Array(lines.iter().map(Line::json).collect()),
                };
                format!("{value:#}\n")
            }
            Self::Csv => {
                let rows: Vec<Vec<f64>> = lines
                    .iter()
                    .map(|line| line.fields().iter().map(|f| f.1).collect())
                    .collect();
                let with_jacobian = lines.iter().any(|line| line.jacobian.is_some());
                let more: &[&str] = if with_jacobian { &JACOBIAN } else { &[] };
                let columns = [&COLUMNS[..], more].concat();
                series_csv(&columns, rows.iter().map(Vec::as_slice))
            }
        }
    }
}
