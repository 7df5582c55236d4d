//! Files of feet and of surfaces.

use super::coefficients::quarters;
use super::flat::Flat;
use super::owned_feet::OwnedFeet;
use super::{Area, Coefficients, Floor, FootOnFloor, FrictionError, Patch, Precision, Surface};
use std::path::Path;
use std::sync::LazyLock;
use tribos_base::record::{Rows, TableError};
use tribos_core::patch::PatchError;
use tribos_core::patch::affine_image::{AffineImage, AffineMap};
use tribos_core::patch::feet::PatchPart;
use tribos_core::twist::Twist;

/// Most feet of a body, and most corners of surfaces.
const MOST: usize = 10_000;
/// Columns of feet that may be left out, and what then stands for them; motions come together.
const OPTIONAL: [(&str, f64); 8] = [
    ("radius", 1.0),
    ("angle_deg", 0.0),
    ("load", 1.0),
    ("mu", 1.0),
    ("mu_across", 0.0),
    ("velocity_x", 0.0),
    ("velocity_y", 0.0),
    ("spin", 0.0),
];
/// Columns of surfaces.
const SURFACE: [&str; 6] = ["x", "y", "velocity_x", "velocity_y", "spin", "surface"];

/// The columns of feet by which of the optional ones are there.
static COLUMNS: LazyLock<Vec<Vec<&'static str>>> = LazyLock::new(|| {
    let chosen = |set: usize| {
        let optional = OPTIONAL.iter().enumerate();
        let there = optional.filter(|(bit, _)| set >> bit & 1 == 1);
        let mut columns = vec!["x", "y"];
        columns.extend(there.map(|(_, (name, _))| *name));
        columns.push("patch");
        columns
    };
    (0..1 << OPTIONAL.len()).map(chosen).collect()
});

/// One foot as a row says.
struct FootRow {
    patch: Patch,
    place: [f64; 2],
    /// Values of the optional columns.
    values: [f64; OPTIONAL.len()],
}

/// The feet of a file, with what `of` makes of each, and its columns.
fn rows<T>(
    path: &Path,
    mut of: impl FnMut(FootRow) -> Result<T, FrictionError>,
) -> Result<(Vec<T>, &'static [&'static str]), FrictionError> {
    let mut columns: &'static [&'static str] = &[];
    let opened = Rows::open(path, |header| {
        let bits = OPTIONAL.iter().enumerate();
        let set = bits.filter(|(_, (name, _))| header.contains(name));
        let set = set.fold(0, |set, (bit, _)| set | 1 << bit);
        columns = COLUMNS.get(set).map_or(&[], Vec::as_slice);
        columns
    });
    let refused = |error: TableError| FrictionError::Syntax(error.to_string());
    let mut rows = opened.map_err(|error| {
        let text = error.to_string();
        let names = OPTIONAL.map(|(name, _)| name).join(", ");
        FrictionError::Syntax(match text.contains("the header must be") {
            true => format!("{text}; beside them there may be {names}"),
            false => text,
        })
    })?;
    let mut all = Vec::new();
    let mut numbers = vec![0.0; columns.len() - 1];
    while rows.next(&mut numbers).map_err(refused)?.is_some() {
        let mut values = OPTIONAL.map(|(_, default)| default);
        for (value, (name, _)) in values.iter_mut().zip(OPTIONAL) {
            if let Some(at) = columns.iter().position(|column| *column == name) {
                *value = numbers[at];
            }
        }
        let made = rows.words().concat().parse().and_then(|patch| {
            of(FootRow {
                patch,
                place: [numbers[0], numbers[1]],
                values,
            })
        });
        all.push(made.map_err(|error| refused(rows.refusal(&error.to_string())))?);
        if all.len() > MOST {
            return Err(refused(rows.refusal(&format!("more than {MOST} feet"))));
        }
    }
    Ok((all, columns))
}

impl FootRow {
    fn area<R: Precision>(&self) -> Result<Area<R>, FrictionError> {
        if let Patch::Flat(super::FlatPatch::Feet(_)) = self.patch {
            return Err(FrictionError::Syntax(
                "a foot has no feet of its own".into(),
            ));
        }
        Area::named(&self.patch, R::from_f64(self.values[0]), None)
    }

    fn coefficients(&self) -> Result<Coefficients, FrictionError> {
        let [_, _, _, mu, across, ..] = self.values;
        match across {
            0.0 => Coefficients::isotropic(mu),
            _ => Coefficients::along_and_across([mu, across], 0.0),
        }
    }
}

/// The feet of a file as one area, as if all stood on one surface: what they carry is spread in proportion to load times
/// coefficient.
pub(super) fn feet<R: Precision>(path: &Path) -> Result<Flat<R>, FrictionError> {
    let (parts, _) = rows(path, |row| {
        let [_, degrees, load, ..] = row.values;
        let mu = row.coefficients()?;
        let turn = quarters(degrees).map(R::from_f64);
        let map = AffineMap::placed(turn, row.place.map(R::from_f64));
        let patch = mu.on(row.area()?)?.into_flat()?.image(&map);
        Ok(PatchPart {
            patch: patch.ok_or(PatchError::NoImage)?,
            load: R::from_f64(mu.largest() * load),
        })
    })?;
    let made = OwnedFeet::new(parts);
    let whole = |error: PatchError| FrictionError::Syntax(format!("{}: {error}", path.display()));
    Ok(Flat::Feet(made.map_err(whole)?))
}

/// The sum of the loads of a file of feet, in N; `None` if it has no column `load`.
#[doc(hidden)]
pub fn load_of_feet(path: &Path) -> Result<Option<f64>, FrictionError> {
    let (loads, columns) = rows(path, |row| Ok(row.values[2]))?;
    Ok(columns.contains(&"load").then(|| loads.iter().sum()))
}

impl Floor {
    /// The feet of a CSV file, with columns `patch,x,y` and, where they differ, `radius` (of round ones), `angle_deg`,
    /// `load`, `mu`, `mu_across` and the motion of the surface, `velocity_x,velocity_y,spin`, in SI units. Loads and
    /// coefficients share `limit`, what all carry together, in proportion to their products.
    pub fn feet_of(path: &Path, limit: f64) -> Result<Self, FrictionError> {
        let (rows, _) = rows(path, |row| {
            Ok((row.area::<f64>()?, row.coefficients()?, row))
        })?;
        let strength = |(_, mu, row): &(Area, Coefficients, FootRow)| mu.largest() * row.values[2];
        let total: f64 = rows.iter().map(strength).sum();
        let feet: Vec<_> = rows
            .iter()
            .map(|(area, mu, row)| {
                let [_, degrees, load, _, _, vx, vy, spin] = row.values;
                FootOnFloor {
                    area,
                    mu: *mu,
                    load: load * (limit / total),
                    place: row.place,
                    degrees,
                    surface: Twist::new(vx, vy, spin),
                }
            })
            .collect();
        Self::feet(&feet)
    }
}

impl Surface {
    /// The surfaces of a CSV file with columns `surface,x,y,velocity_x,velocity_y,spin`, in SI units: two rows of one name
    /// are two points of a border to whose left the surface lies, three or more the corners of a convex polygon. The
    /// motion is that of a name's first row.
    ///
    /// ```
    /// use tribos::friction::Surface;
    /// let file = std::env::temp_dir().join(format!("belts-{}.csv", std::process::id()));
    /// std::fs::write(&file, "surface,x,y,velocity_x,velocity_y,spin\nbelt,0,0,0.5,0,0\nbelt,1,0,0.5,0,0\n")?;
    /// assert_eq!(Surface::read(&file)?.len(), 1);
    /// # std::fs::remove_file(&file)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn read(path: &Path) -> Result<Vec<Self>, FrictionError> {
        let refused = |error: TableError| FrictionError::Syntax(error.to_string());
        let mut rows = Rows::open(path, |_| &SURFACE).map_err(refused)?;
        let mut named: Vec<(String, Vec<[f64; 2]>, Twist<f64>)> = Vec::new();
        let mut row = [0.0; 5];
        while rows.next(&mut row).map_err(refused)?.is_some() {
            let (name, [x, y, vx, vy, spin]) = (rows.words().concat(), row);
            let twist = Twist::new(vx, vy, spin);
            let known = named.iter().position(|(known, ..)| *known == name);
            let Some(at) = known else {
                if named.len() == MOST {
                    return Err(refused(rows.refusal(&format!("more than {MOST} surfaces"))));
                }
                named.push((name, vec![[x, y]], twist));
                continue;
            };
            let (_, corners, motion) = &mut named[at];
            if *motion != twist {
                let reason =
                    format!("surface {name} moves in two ways: give all of its rows one motion");
                return Err(refused(rows.refusal(&reason)));
            }
            corners.push([x, y]);
        }
        let surface = |(name, corners, twist): (String, Vec<[f64; 2]>, Twist<f64>)| {
            let made = match *corners.as_slice() {
                [from, to] => Self::half_plane(from, [to[0] - from[0], to[1] - from[1]], twist),
                _ => Self::polygon(&corners, twist),
            };
            made.map_err(|error| {
                FrictionError::Syntax(format!("{}: surface {name}: {error}", path.display()))
            })
        };
        named.into_iter().map(surface).collect()
    }
}
