//! The scatter of time against error.

use crate::written;
use std::path::Path;
use tribos_cli::report::figure::{Axis, Color, Figure, Legend, Region, Series};

/// One method in the picture.
#[derive(Clone, Debug)]
pub struct Place {
    /// Its own name.
    pub label: String,
    /// What it is drawn with.
    pub group: String,
    /// Time and error.
    pub at: (f64, f64),
}

/// Labels stand this factor above their point.
const LIFT: f64 = 7.0;

/// Writes `name`.svg: both axes logarithmic, a colour a group, every method named at its point.
pub fn scatter(
    folder: &Path,
    name: &str,
    title: &str,
    [x, y]: [&str; 2],
    places: Vec<Place>,
) -> Result<(), String> {
    let mut groups: Vec<&str> = places.iter().map(|place| place.group.as_str()).collect();
    groups.sort_unstable();
    groups.dedup();
    let mut figure = Figure::new(title, Axis::log10(x), Axis::log10(y))
        .legend(Legend::Below)
        .size(1000, 640);
    for group in groups {
        let members = places.iter().filter(|place| place.group == group);
        figure = figure.series(Series::points(
            group,
            members.map(|place| place.at).collect(),
        ));
    }
    for Place { label, at, .. } in places {
        // A region without area carries the name.
        figure = figure.region(Region {
            label,
            outline: Vec::new(),
            fill: Color::pale(0),
            label_at: (at.0, LIFT * at.1),
        });
    }
    let svg = figure.svg().map_err(|error| error.to_string())?;
    written::write(folder, &format!("{name}.svg"), &svg)
}
