//! Wrenches as text, JSON or CSV.

use super::given::{self, ContactParameter};
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

/// Names and values of an answer, in the order of its columns.
pub type Fields = Vec<(&'static str, f64)>;

const COLUMNS: [&str; 4] = ["speed", "spin", "force", "torque"];
const JACOBIAN: [&str; 4] = [
    "dforce_dspeed",
    "dforce_dspin",
    "dtorque_dspeed",
    "dtorque_dspin",
];
const LATERAL: &str = "lateral";
/// Units in SI, for people.
const UNITS: &[(&str, &str)] = &[
    ("velocity_x", "m/s"),
    ("velocity_y", "m/s"),
    ("force_x", "N"),
    ("force_y", "N"),
    ("dforce_x_dvelocity_x", "N s/m"),
    ("dforce_x_dvelocity_y", "N s/m"),
    ("dforce_x_dspin", "N s/rad"),
    ("dforce_y_dvelocity_x", "N s/m"),
    ("dforce_y_dvelocity_y", "N s/m"),
    ("dforce_y_dspin", "N s/rad"),
    ("dtorque_dvelocity_x", "N s"),
    ("dtorque_dvelocity_y", "N s"),
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
    pub fn fields(&self) -> Fields {
        let values = [self.twist[0], self.twist[1], self.force, self.torque];
        let mut fields: Vec<_> = COLUMNS.into_iter().zip(values).collect();
        fields.extend(self.lateral.map(|x| (LATERAL, x)));
        if let Some(jacobian) = self.jacobian {
            fields.extend(JACOBIAN.into_iter().zip(jacobian));
        }
        fields
    }
}

fn object(fields: &Fields) -> Value {
    let entry = |(name, x): &(&str, f64)| ((*name).to_owned(), json_number(*x));
    Value::Object(fields.iter().map(entry).collect::<Map<_, _>>())
}

fn text(fields: &Fields) -> String {
    let width = fields
        .iter()
        .fold(15, |most, (name, _)| most.max(name.len()));
    let line = |(name, x): &(&str, f64)| format!("{name:<width$} {} {}\n", shown(*x), unit(name));
    fields.iter().map(line).collect()
}

/// The unit of a column in SI, for people.
fn unit(name: &str) -> &'static str {
    let known = UNITS.iter().find(|(known, _)| *known == name);
    known.map_or("", |(_, unit)| unit)
}

impl Format {
    /// A single line in this format with the contact that it is for, where there is a place for it.
    pub fn one(self, line: &Fields, contact: &[ContactParameter]) -> String {
        match self {
            Self::Text => given::lines(contact) + &self.row(line),
            Self::Csv => self.begin(0, line) + &self.row(line),
            Self::Json => {
                let mut value = object(line);
                value["contact"] = given::json(contact);
                format!("{value:#}\n")
            }
        }
    }

    /// What comes before line `index` of many.
    pub fn begin(self, index: usize, line: &Fields) -> String {
        match (self, index) {
            (Self::Csv, 0) => {
                let names: Vec<&str> = line.iter().map(|field| field.0).collect();
                series_csv(&names, [])
            }
            (Self::Json, 0) => "[\n".into(),
            (Self::Json, _) => ",\n".into(),
            (Self::Text, 1..) => "\n".into(),
            _ => String::new(),
        }
    }

    /// One line of many.
    pub fn row(self, line: &Fields) -> String {
        match self {
            Self::Text => text(line),
            Self::Json => {
                let object = format!("{:#}", object(line));
                format!("  {}", object.replace('\n', "\n  "))
            }
            Self::Csv => {
                let cells = line.iter().map(|(_, x)| number(*x));
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
