//! The feet of the polygons' front, about their centroids.

use tribos_core::Real;
use tribos_core::coupling::flat::ShapeFriction;
use tribos_core::patch::outline::{Edge, LinearPressure, Polygon};
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

/// Force and torque about the centroid, with 150 digits.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    /// Slope of the pressure over its mean.
    pub slope: [f64; 2],
    /// The motion of the centroid.
    pub twist: Twist<f64>,
    /// Force and torque for a μN of 1.
    pub wrench: [f64; 3],
}

/// Names in the table of the tests, and what they are.
const NAMES: [(&str, &str); 10] = [
    ("square", "square"),
    ("rectangle", "4:1"),
    ("plank", "10:1"),
    ("triangle", "triangle"),
    ("ell", "L"),
    ("octagon", "octagon"),
    ("foot", "foot"),
    ("hexagon", "hexagon"),
    ("star", "star"),
    ("u", "U"),
];
/// Polygons of random corners.
const RANDOM: usize = 3;

/// The shapes of the table, and others that the table has not: strips, wedges, a polygon of 64 corners and random ones.
pub fn shapes() -> Vec<Shape> {
    let known = outlines();
    let of_table = NAMES.iter().filter_map(|(name, told)| {
        let outline = known.iter().find(|outline| outline.name == *name)?;
        Some(Shape::about_centroid(told, outline.loops.first()?))
    });
    let mut all: Vec<Shape> = of_table.collect();
    let strip = |half: f64| vec![[-half, -0.5], [half, -0.5], [half, 0.5], [-half, 0.5]];
    let wedge = |width: f64| vec![[0.0, 0.0], [1.0, -0.5 * width], [1.0, 0.5 * width]];
    let ring = |radius: &dyn Fn(usize) -> f64, corners: usize| -> Vec<[f64; 2]> {
        let turn = core::f64::consts::TAU / corners as f64;
        let corner = |i: usize| (radius(i), turn * i as f64);
        let corners = (0..corners).map(corner);
        corners
            .map(|(r, angle)| [r * angle.cos(), r * angle.sin()])
            .collect()
    };
    let mut other = vec![
        ("20:1".to_owned(), strip(10.0)),
        ("50:1".to_owned(), strip(25.0)),
        ("wedge 1:4".to_owned(), wedge(0.25)),
        ("wedge 1:20".to_owned(), wedge(0.05)),
        ("64-gon".to_owned(), ring(&|_| 1.0, 64)),
    ];
    for seed in 1..=RANDOM {
        // Radii from 0.3 to 1 that golden ratios spread.
        let radius = |i: usize| 0.3 + 0.7 * (0.618_033_988_7 * (i * seed + seed) as f64).fract();
        other.push((format!("random {seed}"), ring(&radius, 4 + 3 * seed)));
    }
    all.extend(
        other
            .iter()
            .map(|(name, corners)| Shape::about_centroid(name, corners)),
    );
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

    /// Friction under linear pressure, with this slope over the mean, for μN = 1.
    pub fn sloped(&self, slope: [f64; 2]) -> SlopedFriction {
        let patch = self.patch().with_slope(slope);
        ShapeFriction::new(patch.expect("a pressure that is nowhere negative"), 1.0)
            .expect("1 is a valid coefficient")
    }

    /// Line integrals of 150 digits; none of a shape that the table has not. The centroid's own rounding limits the
    /// torque to 1e-16 of μN R.
    pub fn references(&self) -> Vec<Reference> {
        let Some((name, _)) = NAMES.iter().find(|(_, told)| *told == self.name) else {
            return Vec::new();
        };
        let [x, y] = self.centroid;
        let table = Table::read("polygons.csv");
        let rows = table.rows().filter(|row| row.text("shape") == *name);
        let one = |row: tribos_tests::tables::Row<'_>| {
            let [vx, vy, spin] = ["velocity_x", "velocity_y", "spin"].map(|name| row.number(name));
            let [fx, fy, torque] = ["force_x", "force_y", "torque"].map(|name| row.number(name));
            Reference {
                slope: ["slope_x", "slope_y"].map(|name| row.number(name)),
                twist: Twist::new(vx - spin * y, vy + spin * x, spin),
                wrench: [fx, fy, torque - (x * fy - y * fx)],
            }
        };
        rows.map(one).collect()
    }
}

/// Friction of a shape under linear pressure.
pub type SlopedFriction = ShapeFriction<f64, Polygon<f64, Vec<Edge<f64>>, LinearPressure<f64>>>;

fn made<R: Real>(corners: &[[f64; 2]]) -> Polygon<R, Vec<Edge<R>>> {
    let corners: Vec<[R; 2]> = corners
        .iter()
        .map(|corner| corner.map(R::from_f64))
        .collect();
    Polygon::with_holes(&[&corners], vec![Edge::default(); corners.len()])
        .expect("the shapes are simple polygons")
}
