//! The polygons of `polygons.csv`.

use crate::tables::Table;
use tribos_core::Real;
use tribos_core::patch::outline::{Edge, Polygon};

/// A polygon of the tables with its corners.
#[derive(Clone, Debug)]
pub struct Outline {
    /// Its name.
    pub name: String,
    /// Outer loop and holes.
    pub loops: Vec<Vec<[f64; 2]>>,
}

/// All polygons, in the order of the table.
pub fn outlines() -> Vec<Outline> {
    let table = Table::read("polygon_shapes.csv");
    let mut outlines: Vec<Outline> = Vec::new();
    for row in table.rows() {
        let name = row.text("shape");
        if outlines.last().is_none_or(|last| last.name != name) {
            outlines.push(Outline {
                name: name.to_owned(),
                loops: Vec::new(),
            });
        }
        let loops = &mut outlines.last_mut().expect("pushed").loops;
        let number = row.number("loop") as usize;
        loops.resize(loops.len().max(number + 1), Vec::new());
        loops[number].push([row.number("x"), row.number("y")]);
    }
    outlines
}

impl Outline {
    /// The patch under uniform pressure, in either precision.
    ///
    /// # Panics
    /// If it is refused.
    pub fn patch<R: Real>(&self) -> Polygon<R, Vec<Edge<R>>> {
        let convert = |corner: &[f64; 2]| corner.map(R::from_f64);
        let loops: Vec<Vec<[R; 2]>> = self
            .loops
            .iter()
            .map(|one| one.iter().map(convert).collect())
            .collect();
        let slices: Vec<&[[R; 2]]> = loops.iter().map(Vec::as_slice).collect();
        let count = slices.iter().map(|one| one.len()).sum();
        Polygon::with_holes(&slices, vec![Edge::default(); count]).expect(&self.name)
    }
}
