//! The scatter of time against error.

use crate::written;
use std::path::Path;
use tribos_report::figure::{Axis, Color, Figure, Legend, Region, Series};

/// One method in the picture.
#[derive(Clone, Debug)]
pub struct PicturePoint {
    /// Name of the method.
    pub label: String,
    /// Group of methods that are drawn alike.
    pub group: String,
    /// Time and error.
    pub at: (f64, f64),
}

/// Height of a label above its point, and its size, as fractions of the axes.
const LIFT: f64 = 0.035;
const ROOM: [f64; 2] = [0.14, 0.035];

/// Writes `name`.svg: both axes logarithmic, a colour a group, methods named at their points. A name
/// that would cover an earlier one is left out.
pub fn scatter(
    folder: &Path,
    name: &str,
    title: &str,
    [x, y]: [&str; 2],
    places: Vec<PicturePoint>,
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
    let spans = [0, 1].map(|axis| span(&places, axis));
    let mut named: Vec<[f64; 2]> = Vec::new();
    for PicturePoint { label, at, .. } in places {
        let here = [at.0.log10() / spans[0], at.1.log10() / spans[1]];
        let covers = |other: &[f64; 2]| {
            let gap = |axis: usize| (here[axis] - other[axis]).abs();
            gap(0) < ROOM[0] && gap(1) < ROOM[1]
        };
        if named.iter().any(covers) {
            continue;
        }
        named.push(here);
        // A region without area carries the name.
        figure = figure.region(Region {
            label,
            outline: Vec::new(),
            fill: Color::pale(0),
            label_at: (at.0, at.1 * 10_f64.powf(LIFT * spans[1])),
        });
    }
    let svg = figure.svg().map_err(|error| error.to_string())?;
    written::write(folder, &format!("{name}.svg"), &svg)
}

/// Decades between the least and the largest place on an axis.
fn span(places: &[PicturePoint], axis: usize) -> f64 {
    let decades = places
        .iter()
        .map(|place| [place.at.0, place.at.1][axis].log10());
    let (least, most) = decades.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| {
        (least.min(x), most.max(x))
    });
    (most - least).max(1.0)
}
