//! The feet of the polygons' front, about their centroids.

use tribos_core::Real;
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::twist::Twist;
use tribos_tests::outlines::outlines;
use tribos_tests::tables::Table;

/// A simple polygon about its centroid.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Its name.
    pub name: String,
    /// Its corners.
    pub corners: Vec<[f64; 2]>,
    /// Its centroid in the coordinates of the table.
    centroid: [f64; 2],
}

/// Names in the table of the tests, and what they are.
const NAMES: [(&str, &str); 7] = [
    ("square", "square"),
    ("rectangle", "4:1"),
    ("plank", "10:1"),
    ("triangle", "triangle"),
    ("ell", "L"),
    ("octagon", "octagon"),
    ("foot", "foot"),
];

/// The shapes of the table, and a strip of 20:1, which the table has not.
pub fn shapes() -> Vec<Shape> {
    let known = outlines();
    let of_table = NAMES.iter().filter_map(|(name, told)| {
        let outline = known.iter().find(|outline| outline.name == *name)?;
        Some(Shape::about_centroid(told, outline.loops.first()?))
    });
    let strip = [[-10.0, -0.5], [10.0, -0.5], [10.0, 0.5], [-10.0, 0.5]];
    let mut all: Vec<Shape> = of_table.collect();
    all.insert(3.min(all.len()), Shape::about_centroid("20:1", &strip));
    all
}

impl Shape {
    fn about_centroid(name: &str, corners: &[[f64; 2]]) -> Self {
        let patch = made::<f64>(corners);
        let [x, y] = [patch.centre().x, patch.centre().y];
        Self {
            name: name.into(),
            corners: corners.iter().map(|[a, b]| [a - x, b - y]).collect(),
            centroid: [x, y],
        }
    }

    /// The patch.
    pub fn patch<R: Real>(&self) -> Polygon<R, Vec<Edge<R>>> {
        made(&self.corners)
    }

    /// Twists about the centroid with force and torque there, by line integrals of 150 digits; none of a shape that
    /// the table has not. The centroid's own rounding limits the torque to 1e-16 of μN R.
    pub fn references(&self) -> Vec<(Twist<f64>, [f64; 3])> {
        let Some((name, _)) = NAMES.iter().find(|(_, told)| *told == self.name) else {
            return Vec::new();
        };
        let [x, y] = self.centroid;
        let table = Table::read("polygons.csv");
        let is_mine = |row: &tribos_tests::tables::Row<'_>| {
            row.text("shape") == *name
                && row.number("slope_x") == 0.0
                && row.number("slope_y") == 0.0
        };
        let one = |row: tribos_tests::tables::Row<'_>| {
            let [vx, vy, spin] = ["velocity_x", "velocity_y", "spin"].map(|name| row.number(name));
            let [fx, fy, torque] = ["force_x", "force_y", "torque"].map(|name| row.number(name));
            let twist = Twist::new(vx - spin * y, vy + spin * x, spin);
            (twist, [fx, fy, torque - (x * fy - y * fx)])
        };
        table.rows().filter(is_mine).map(one).collect()
    }
}

fn made<R: Real>(corners: &[[f64; 2]]) -> Polygon<R, Vec<Edge<R>>> {
    let corners: Vec<[R; 2]> = corners
        .iter()
        .map(|corner| corner.map(R::from_f64))
        .collect();
    Polygon::with_holes(&[&corners], vec![Edge::default(); corners.len()])
        .expect("the shapes are simple polygons")
}
