//! Pictures of packings: the spheres at both ends and the final forces, and series over time.

use crate::drawing_grid::DrawingGrid;
use crate::figure::{Axis, Figure, Series};
use crate::packing::{Contact, Packing, PackingError, PackingPicture};
use tribos::record::{ContactRow, Snapshot};

/// A snapshot for pictures.
#[derive(Debug)]
pub struct State {
    /// Centres.
    pub positions: Vec<[f64; 3]>,
    radii: Vec<f64>,
    contacts: Vec<Contact>,
}

impl State {
    /// A snapshot.
    pub fn of(snapshot: &Snapshot<'_>) -> Self {
        let contact = |row: &ContactRow| Contact {
            a: row.a as usize,
            b: row.b.particle().map(|b| b as usize),
            normal_force: row.normal_force(),
        };
        Self {
            positions: snapshot.positions.iter().map(|x| [x.x, x.y, x.z]).collect(),
            radii: snapshot.radii.to_vec(),
            contacts: snapshot.contacts.iter().map(contact).collect(),
        }
    }

    /// The packing in a cell of these sides, below a piston if there is one.
    fn packing(&self, sides: [f64; 2], piston: Option<f64>) -> Result<Packing<'_>, PackingError> {
        Packing::new(&self.positions, &self.radii, sides, piston)
    }

    /// The largest magnitude of a normal force.
    fn largest_force(&self) -> f64 {
        let forces = self.contacts.iter().map(|contact| contact.normal_force);
        forces.map(f64::abs).fold(0.0, f64::max)
    }
}

/// Both ends of a run, to be drawn side by side.
#[derive(Debug)]
pub(super) struct Ends<'a> {
    pub name: String,
    pub titles: [String; 2],
    pub states: [&'a State; 2],
    /// Sides of the cell along x and y.
    pub sides: [f64; 2],
    /// Height of the piston at both ends, where there is one.
    pub pistons: [Option<f64>; 2],
    /// Height of the pictures.
    pub top: f64,
    /// Axis of the colours, and unit of the forces.
    pub words: [&'a str; 2],
}

impl Ends<'_> {
    /// Initial and final spheres in one scale, and the final forces.
    pub fn draw(self) -> Result<DrawingGrid, PackingError> {
        let [before, after] = self.states;
        let [first, last] = self.pistons;
        let initial = before.packing(self.sides, first)?;
        let end = after.packing(self.sides, last)?;
        // Both are coloured by height at the start, which shows how layers sink and mix.
        let layers: Vec<f64> = before.positions.iter().map(|[_, _, z]| *z).collect();
        let [axis, unit] = self.words;
        let picture = |title: String, packing: &Packing<'_>| {
            let picture = PackingPicture::spheres(title, packing).headroom(self.top);
            picture.color_by(Axis::linear(axis), &layers)
        };
        let forces = PackingPicture::forces("Final forces", &end, &after.contacts)?
            .full_force(after.largest_force(), unit)
            .headroom(self.top);
        let [initial_title, end_title] = self.titles;
        Ok(DrawingGrid::new(self.name, 3)
            .drawing(picture(initial_title, &initial)?)
            .drawing(picture(end_title, &end)?)
            .drawing(forces))
    }
}

/// Columns of a series over time, each with its label.
pub(super) fn over_time<const N: usize>(
    (rows, columns): (&[[f64; N]], [&str; N]),
    axes: [&str; 2],
    curves: &[(&str, &str)],
) -> Figure {
    let [time, axis] = axes.map(Axis::linear);
    let curve = |name: &str| -> Vec<(f64, f64)> {
        let column = columns.iter().position(|known| *known == name);
        let column = column.unwrap_or_default();
        rows.iter().map(|row| (row[0], row[column])).collect()
    };
    let figure = Figure::new("", time, axis);
    curves.iter().fold(figure, |figure, (label, name)| {
        // The work is dashed beside where it went.
        let drawn = if *name == "work" {
            Series::dashed
        } else {
            Series::line
        };
        figure.series(drawn(*label, curve(name)))
    })
}
