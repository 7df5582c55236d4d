//! Wrenches as text, JSON or CSV.

use super::given::{self, Given};
use crate::command::digits::shown;
use serde_json::{Map, Value};
use tribos::record::{json_number, number, series_csv};

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
    /// True if a result left the number range.
    pub is_beyond: bool,
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
    /// A single line in this format with the contact that it is for, where there is a place for it.
    pub fn one(self, line: &Line, contact: &[Given]) -> String {
        match self {
            Self::Text => given::lines(contact) + &self.row(line),
            Self::Csv => self.begin(0, line) + &self.row(line),
            Self::Json => {
                let mut value = line.json();
                value["contact"] = given::json(contact);
                format!("{value:#}\n")
            }
        }
    }

    /// What comes before line `index` of many.
    pub fn begin(self, index: usize, line: &Line) -> String {
        match (self, index) {
            (Self::Csv, 0) => {
                let names: Vec<&str> = line.fields().iter().map(|field| field.0).collect();
                series_csv(&names, [])
            }
            (Self::Json, 0) => "[\n".into(),
            (Self::Json, _) => ",\n".into(),
            (Self::Text, 1..) => "\n".into(),
            _ => String::new(),
        }
    }

    /// One line of many.
    pub fn row(self, line: &Line) -> String {
        match self {
            Self::Text => line.text(),
            Self::Json => {
                let object = format!("{:#}", line.json());
                format!("  {}", object.replace('\n', "\n  "))
            }
            Self::Csv => {
                let cells = line.fields().into_iter().map(|(_, x)| number(x));
                cells.collect::<Vec<_>>().join(",") + "\n"
            }
        }
    }

    /// What comes after the last of many.
    pub fn end(self) -> &'static str {
        match self {
            Self::Json => "\n]\n",
            _ => "",
        }
    }
}
