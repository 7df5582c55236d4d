//! Pictures of packings: the spheres at both ends and the final forces, and series over time.

use crate::drawing_grid::DrawingGrid;
use crate::figure::{Axis, Figure, Series};
use crate::packing::{Contact, Packing, PackingError, PackingPicture};
use tribos::grains::PlateOutline;
use tribos::record::{ContactRow, Snapshot};

/// Size of a picture in pixels: letters of three beside each other can be read on a page of the report.
const SIZE: (u32, u32) = (370, 620);

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

/// Initial and final spheres in one scale, and the final forces: the name of the drawing, the axis of the colours and
/// the unit of the forces; each end with its title and the height of its piston, if it has one; the sides of the cell
/// along x and y; the height of the pictures, and the plates of a hopper or a drum.
pub(super) fn both(
    [name, axis, unit]: [&str; 3],
    ends: &[(&State, String, Option<f64>); 2],
    sides: [f64; 2],
    (top, plates): (f64, &[PlateOutline]),
) -> Result<DrawingGrid, PackingError> {
    let [(before, ..), (after, _, piston)] = ends;
    // Both are coloured by height at the start, which shows how layers sink and mix.
    let layers: Vec<f64> = before.positions.iter().map(|[_, _, z]| *z).collect();
    let mut grid = DrawingGrid::new(name, 3);
    for (state, title, piston) in ends {
        let picture = PackingPicture::spheres(title, &state.packing(sides, *piston)?);
        grid = grid.drawing(
            picture
                .size(SIZE.0, SIZE.1)
                .headroom(top)
                .plates(plates)
                .color_by(Axis::linear(axis), &layers)?,
        );
    }
    let end = after.packing(sides, *piston)?;
    let forces = PackingPicture::forces("Final forces", &end, &after.contacts)?
        .full_force(after.largest_force(), unit)
        .size(SIZE.0, SIZE.1)
        .headroom(top)
        .plates(plates);
    Ok(grid.drawing(forces))
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
        column.map_or(Vec::new(), |column| {
            rows.iter().map(|row| (row[0], row[column])).collect()
        })
    };
    let figure = Figure::new("", time, axis);
    curves.iter().fold(figure, |figure, (label, name)| {
        // The work is dashed beside where it went.
        let (label, points) = (label.to_string(), curve(name));
        figure.series(if *name == "work" {
            Series::dashed(label, points)
        } else {
            Series::line(label, points)
        })
    })
}
