//! The frames of a film.

use super::Options;
use crate::failure::Failure;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use tribos::fit::FitError;
use tribos::fit::track::Track;
use tribos::record::Rows;

/// A film that was read.
#[derive(Debug)]
pub struct Film {
    pub track: Track,
    pub name: PathBuf,
    /// Line of each frame.
    pub lines: Vec<u64>,
}

const COLUMNS: [&str; 4] = ["t", "x", "y", "angle"];
/// Units that are known: of times, lengths and angles.
const UNITS: [(&str, &[&str], f64); 10] = [
    ("s", &["t"], 1.0),
    ("ms", &["t"], 1e-3),
    ("us", &["t"], 1e-6),
    ("m", &["x", "y"], 1.0),
    ("cm", &["x", "y"], 1e-2),
    ("mm", &["x", "y"], 1e-3),
    ("in", &["x", "y"], 0.0254),
    ("rad", &["angle"], 1.0),
    ("deg", &["angle"], PI / 180.0),
    ("turn", &["angle"], 2.0 * PI),
];

/// NAME=UNIT: the column and its factor.
pub fn unit(text: &str) -> Result<(String, f64), String> {
    let (name, unit) = text.split_once('=').ok_or("give NAME=UNIT, such as x=mm")?;
    let (name, unit) = (name.trim(), unit.trim());
    if unit == "px" {
        return Err(
            "pixels have no length: give --scale METRES_PER_PIXEL, or lengths such as x=mm,y=mm"
                .into(),
        );
    }
    if unit == "frame" || unit == "frames" {
        return Err("frames have no duration: give --frame-rate HZ".into());
    }
    let found = UNITS
        .iter()
        .find(|(known, of, _)| *known == unit && of.contains(&name));
    found
        .map(|(.., factor)| (name.to_owned(), *factor))
        .ok_or_else(|| {
            let fitting = UNITS.iter().filter(|(_, of, _)| of.contains(&name));
            let fitting: Vec<&str> = fitting.map(|(unit, ..)| *unit).collect();
            if fitting.is_empty() {
                format!(
                    "there is no column `{name}`; the columns are {}",
                    COLUMNS.join(", ")
                )
            } else {
                format!("`{unit}` is no unit of {name}; give {}", fitting.join(", "))
            }
        })
}

impl Options {
    /// Reads `t,x,y` or `t,x,y,angle`, in SI units.
    pub(super) fn read(&self, path: &Path) -> Result<Film, Failure> {
        let mut names: &'static [&'static str] = &COLUMNS;
        let mut rows = Rows::asked_for(path, |header| {
            if !header.contains(&"angle") {
                names = &COLUMNS[..3];
            }
            names
        })?;
        let mut columns = vec![Vec::new(); names.len()];
        let mut row = vec![0.0; names.len()];
        let mut lines = Vec::new();
        while let Some(line) = rows.next(&mut row)? {
            lines.push(line);
            for ((column, value), name) in columns.iter_mut().zip(&row).zip(names) {
                column.push(value * self.factor(name));
            }
        }
        let mut columns = columns.into_iter();
        let mut next = || columns.next();
        let [t, x, y] = [next(), next(), next()].map(Option::unwrap_or_default);
        let track = Track::new(t, x, y, next()).map_err(|error| refusal(path, &lines, error))?;
        let name = path.to_path_buf();
        Ok(Film { track, name, lines })
    }

    /// SI units per unit of a column.
    fn factor(&self, name: &str) -> f64 {
        let given = self.units.iter().find(|(column, _)| column == name);
        let own = match name {
            "t" => self.frame_rate.map(|rate| 1.0 / rate),
            "x" | "y" => self.scale,
            _ => None,
        };
        own.unwrap_or_else(|| given.map_or(1.0, |(_, factor)| *factor))
    }
}

/// A refusal with file and line, where it is about a frame.
pub fn refusal(path: &Path, lines: &[u64], error: FitError) -> Failure {
    let name = path.display();
    match error {
        FitError::Point { point, message } => {
            let line = lines.get(point).copied().unwrap_or(1);
            Failure::input(format!("{name}:{line}: {message}"))
        }
        FitError::NoParameter { .. } | FitError::Range { .. } | FitError::NothingFree => {
            Failure::input(format!("--fix: {error}"))
        }
        error => Failure::input(format!("{name}: {error}")),
    }
}
