//! Columns of a dump.

use crate::exchange::spheres::Weight;
use crate::exchange::text::{Line, TextError};

/// Indices of the columns that are read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub count: usize,
    /// None of spheres that are not numbered.
    pub id: Option<usize>,
    /// None of spheres that are all of one type.
    pub species: Option<usize>,
    pub place: [usize; 3],
    /// Whether positions are fractions of the box.
    pub is_scaled: bool,
    /// Columns of the image flags, if the positions are wrapped.
    pub images: Option<[usize; 3]>,
    pub velocity: Option<[usize; 3]>,
    pub forces: Option<[usize; 3]>,
    /// Column of the size of spheres, and its ratio to the radius.
    pub size: Option<(usize, f64)>,
    /// Column of density or mass of spheres.
    pub weight: Option<(usize, Weight)>,
    pub spin: Option<[usize; 3]>,
}

/// Names of position columns, preferred first, with whether they are fractions of the box and wrapped.
const PLACES: [([&str; 3], bool, bool); 4] = [
    (["xu", "yu", "zu"], false, false),
    (["x", "y", "z"], false, true),
    (["xsu", "ysu", "zsu"], true, false),
    (["xs", "ys", "zs"], true, true),
];

impl Columns {
    pub fn new(item: Line, names: &[&str]) -> Result<Self, TextError> {
        let find = |name: &str| names.iter().position(|given| *given == name);
        let three = |names: [&str; 3]| match names.map(find) {
            [Some(x), Some(y), Some(z)] => Some([x, y, z]),
            _ => None,
        };
        let need = |name: &'static str| {
            let cure = format!("dump it: ITEM: ATOMS names the columns {}", names.join(" "));
            item.missing(name, cure)
        };
        let mut places = PLACES.iter();
        let place = places.find_map(|&(names, is_scaled, is_wrapped)| {
            three(names).map(|place| (place, is_scaled, is_wrapped))
        });
        let (place, is_scaled, is_wrapped) = place.ok_or_else(|| {
            let cure = "dump x y z, xu yu zu, xs ys zs or xsu ysu zsu";
            item.missing("a place", cure)
        })?;
        let size = find("radius")
            .map(|at| (at, 1.0))
            .or(find("diameter").map(|at| (at, 0.5)));
        let density = find("density").map(|at| (at, Weight::Density));
        let mass = find("mass").map(|at| (at, Weight::Mass));
        let need = |name: &'static str| match (find(name), size) {
            (None, None) => Err(need(name)),
            (found, _) => Ok(found),
        };
        Ok(Self {
            count: names.len(),
            id: need("id")?,
            species: need("type")?,
            place,
            is_scaled,
            images: three(["ix", "iy", "iz"]).filter(|_| is_wrapped),
            velocity: three(["vx", "vy", "vz"]),
            forces: three(["fx", "fy", "fz"]),
            size,
            // A mass is a density where there is a size.
            weight: density.or(mass.filter(|_| size.is_some())),
            spin: three(["omegax", "omegay", "omegaz"]),
        })
    }
}
