//! Solutions as text, JSON or CSV.

use crate::command::digits::shown;
use crate::failure::Failure;
use serde_json::{Map, Value};
use std::io::Write;
use tribos::record::{json_number, series_csv};
use tribos::slide::inverse::{LaunchSolution, PoseJacobian};

/// Format of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For people.
    Text,
    /// An array of objects.
    Json,
    /// A header and a line a solution.
    Csv,
}

/// One solution with the derivatives asked for.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    pub solution: LaunchSolution,
    pub jacobian: Option<PoseJacobian>,
}

const JACOBIAN: [[&str; 3]; 3] = [
    ["dx_dvx", "dx_dvy", "dx_dspin"],
    ["dy_dvx", "dy_dvy", "dy_dspin"],
    ["dangle_dvx", "dangle_dvy", "dangle_dspin"],
];

impl Row {
    /// Names, values and units.
    fn fields(&self) -> Vec<(&'static str, f64, &'static str)> {
        let solution = &self.solution;
        let [vx, vy] = solution.launch.velocity;
        let mut fields = vec![
            ("speed", solution.speed, "m/s"),
            ("spin", solution.launch.spin, "rad/s"),
            ("direction", solution.direction, "rad"),
            ("vx", vx, "m/s"),
            ("vy", vy, "m/s"),
            ("angle", solution.angle, "rad"),
            ("turns", solution.turns(), ""),
            ("time", solution.time, "s"),
            ("energy_per_mass", solution.energy_per_mass, "J/kg"),
        ];
        let entries = self.jacobian.iter().flatten().flatten();
        let units = [
            "s", "s", "m s/rad", "s", "s", "m s/rad", "rad s/m", "rad s/m", "s",
        ];
        let names = JACOBIAN.as_flattened().iter().zip(units);
        fields.extend(
            names
                .zip(entries)
                .map(|((name, unit), x)| (*name, *x, unit)),
        );
        fields
    }

    fn json(&self) -> Value {
        let fields = self.fields().into_iter();
        Value::Object(
            fields
                .map(|(name, x, _)| (name.into(), json_number(x)))
                .collect::<Map<_, _>>(),
        )
    }

    fn text(&self) -> String {
        let lines = self.fields().into_iter();
        lines
            .map(|(name, x, unit)| {
                format!("{name:<15} {} {unit}", shown(x))
                    .trim_end()
                    .to_owned()
                    + "\n"
            })
            .collect()
    }
}

impl Format {
    /// All solutions in this format; for people with what was `wanted`.
    pub fn render(self, rows: &[Row], wanted: &str) -> String {
        match self {
            Self::Text => {
                let head = match rows.len() {
                    1 => format!("1 launch {wanted}\n"),
                    many => format!("{many} launches {wanted}, the least energy first\n"),
                };
                let blocks: Vec<String> = rows.iter().map(Row::text).collect();
                format!("{head}\n{}", blocks.join("\n"))
            }
            Self::Json => {
                let all = Value::Array(rows.iter().map(Row::json).collect());
                format!("{all:#}\n")
            }
            Self::Csv => {
                let fields: Vec<_> = rows.iter().map(Row::fields).collect();
                let columns: Vec<&str> = fields.iter().take(1).flatten().map(|f| f.0).collect();
                let values: Vec<Vec<f64>> = fields
                    .iter()
                    .map(|row| row.iter().map(|field| field.1).collect())
                    .collect();
                series_csv(&columns, values.iter().map(Vec::as_slice))
            }
        }
    }
}

/// Prints; a reader that went away is not an error.
pub fn print(text: &str) -> Result<(), Failure> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::run(format!(
            "cannot write to standard output: {error}"
        ))),
        _ => Ok(()),
    }
}
