//! Reading text dumps.

use super::bounds::{bounds, tilted};
use super::columns::Columns;
use super::data::vector;
use crate::exchange::atoms::{Atoms, MOST_SPECIES};
use crate::exchange::configuration::Configuration;
use crate::exchange::spheres::Spheres;
use crate::exchange::text::{Line, Lines, TextError};
use nalgebra::Vector3;
use std::collections::HashSet;

const CUT_SHORT: &str = "is the file cut short?";

/// All frames of a dump, in order. Columns may be in any order; `id`, `type` and one of
/// `xu yu zu`, `x y z`, `xsu ysu zsu`, `xs ys zs` are required; velocities, forces and image flags
/// are optional, other columns are ignored. A dump has no masses: all are 1.
///
/// ```
/// use tribos::md::lammps::{frames, last_frame};
/// // One atom whose place is given in parts of a box of 4 × 4 × 9.
/// let head = |step: u64| {
///     format!(
///         "ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n1\n\
///          ITEM: BOX BOUNDS pp pp ff\n0 4\n0 4\n0 9\nITEM: ATOMS id type xs ys zs\n"
///     )
/// };
/// let text = head(0) + "7 1 0.25 0.5 0.5\n" + &head(100) + "7 1 0.5 0.5 0.5\n";
/// let steps: Vec<u64> = frames(&text).flatten().map(|frame| frame.step).collect();
/// assert_eq!(steps, [0, 100]);
/// let last = last_frame(&text)?;
/// assert_eq!(last.ids, [7]);
/// assert_eq!(last.atoms.positions[0].as_slice(), [2.0, 2.0, 4.5]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn frames(text: &str) -> impl Iterator<Item = Result<Configuration, TextError>> {
    sphere_frames(text).map(|frame| {
        let (frame, spheres) = frame?;
        spheres.upright()?;
        Ok(frame)
    })
}

/// All frames with the columns of spheres: `radius` or `diameter`, and `omegax omegay omegaz`.
pub fn sphere_frames(
    text: &str,
) -> impl Iterator<Item = Result<(Configuration, Spheres), TextError>> {
    let mut lines = Lines::new(text);
    let mut is_over = false;
    std::iter::from_fn(move || {
        lines.skip_blank_lines();
        if is_over || lines.peek().is_none() {
            return None;
        }
        let frame = frame(&mut lines);
        is_over = frame.is_err();
        Some(frame)
    })
}

/// The last frame of a dump; all before it must be readable.
pub fn last_frame(text: &str) -> Result<Configuration, TextError> {
    let mut last = None;
    for frame in frames(text) {
        last = Some(frame?);
    }
    last.ok_or_else(|| {
        Lines::new("")
            .here()
            .missing("a frame", "is the file empty?")
    })
}

fn frame(lines: &mut Lines) -> Result<(Configuration, Spheres), TextError> {
    let mut head = Head::default();
    loop {
        let line = lines.need("ITEM: ATOMS", CUT_SHORT)?;
        let Some(item) = line.text.trim().strip_prefix("ITEM:") else {
            return Err(line.invalid("what follows an item", "a line `ITEM: …`", line.text));
        };
        let words: Vec<&str> = item.split_whitespace().collect();
        match words.as_slice() {
            ["TIMESTEP"] => head.step = count(lines, "the step", u64::MAX)?,
            ["NUMBER", "OF", "ATOMS"] => {
                head.atoms = Some(count(lines, "the number of atoms", u64::from(u32::MAX))?);
            }
            ["BOX", "BOUNDS", flags @ ..] => head.read_box(line, flags, lines)?,
            // Units, time and a title are not needed.
            ["UNITS" | "TIME" | "LABEL"] => {
                lines.need("what follows an item", CUT_SHORT)?;
            }
            ["ATOMS", columns @ ..] => {
                let columns = Columns::new(line, columns)?;
                return head.atoms(line, &columns, lines);
            }
            _ => {
                return Err(TextError::Unsupported {
                    line: line.number,
                    what: format!("`{}`", line.text.trim()),
                    cure: "known are TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS and ATOMS",
                });
            }
        }
    }
}

/// Whether a box can lean along x over z: both axes repeat.
fn is_sheared([x, _, z]: [bool; 3]) -> bool {
    x && z
}

/// A whole number on a line of its own.
fn count(lines: &mut Lines, what: &'static str, most: u64) -> Result<u64, TextError> {
    let line = lines.need(what, CUT_SHORT)?;
    line.whole(what, 0..=most, line.text.trim())
}

/// The header of a frame.
#[derive(Default)]
struct Head {
    step: u64,
    atoms: Option<u64>,
    space: Option<([[f64; 2]; 3], [bool; 3])>,
    /// Tilt xz of the box.
    tilt: f64,
    /// Whether the box does not say which axes are periodic.
    is_silent: bool,
}

impl Head {
    fn read_box(&mut self, item: Line, flags: &[&str], lines: &mut Lines) -> Result<(), TextError> {
        let is_periodic = match flags {
            // Old dumps do not specify the boundaries.
            [] => [true; 3],
            &[x, y, z] | &["xy", "xz", "yz", x, y, z] => [x, y, z].map(|flag| flag == "pp"),
            _ => return Err(tilted(item)),
        };
        let mut ends = [[0.0; 2]; 3];
        let mut tilts = [0.0; 3];
        for (ends, tilt) in ends.iter_mut().zip(&mut tilts) {
            let line = lines.need("an axis of the box", CUT_SHORT)?;
            match (line.words().as_slice(), flags.len() > 3) {
                (&[low, high], false) => *ends = bounds(line, low, high)?,
                (&[low, high, leans], true) => {
                    *ends = bounds(line, low, high)?;
                    *tilt = line.number("a tilt factor", leans)?;
                }
                ([_, _, _], false) => return Err(tilted(line)),
                (_, false) => {
                    return Err(line.invalid("an axis of the box", "LOW HIGH", line.text));
                }
                (_, true) => {
                    return Err(line.invalid("an axis of the box", "LOW HIGH TILT", line.text));
                }
            }
        }
        let [_, tilt, _] = tilts;
        if tilts != [0.0, tilt, 0.0] || (tilt != 0.0 && !is_sheared(is_periodic)) {
            return Err(tilted(item));
        }
        // The ends of a slanted box are those of what encloses it.
        ends[0] = [ends[0][0] - tilt.min(0.0), ends[0][1] - tilt.max(0.0)];
        self.tilt = tilt;
        self.is_silent = flags.is_empty();
        self.space = Some((ends, is_periodic));
        Ok(())
    }

    fn atoms(
        self,
        item: Line,
        columns: &Columns,
        lines: &mut Lines,
    ) -> Result<(Configuration, Spheres), TextError> {
        let before = |what: &str| format!("give ITEM: {what} before ITEM: ATOMS");
        let count = self.atoms;
        let count = count.ok_or_else(|| item.missing("their number", before("NUMBER OF ATOMS")))?;
        let (bounds, is_periodic) = self
            .space
            .ok_or_else(|| item.missing("the box", before("BOX BOUNDS")))?;
        let mut all = Configuration {
            atoms: Atoms::at(Vec::new()),
            ids: Vec::new(),
            names: None,
            bounds,
            has_box: true,
            is_periodic,
            step: self.step,
            forces: columns.forces.map(|_| Vec::new()),
        };
        let has = [
            columns.size.is_some(),
            columns.spin.is_some(),
            columns.weight.is_some(),
        ];
        let mut spheres = Spheres::begin(item, has);
        spheres.tilt = self.tilt;
        spheres.is_silent = self.is_silent;
        let mut seen = HashSet::new();
        for _ in 0..count {
            let line = lines.need("an atom", CUT_SHORT)?;
            atom(&mut all, columns, spheres.tilt, line)?;
            sphere(&mut spheres, columns, line)?;
            if let Some(id) = all.ids.last().filter(|&&id| !seen.insert(id)) {
                return Err(TextError::Twice {
                    line: line.number,
                    what: "atom",
                    given: id.to_string(),
                });
            }
        }
        let species = all.atoms.species.iter().max();
        all.atoms.masses = vec![1.0; species.map_or(1, |&most| usize::from(most) + 1)];
        all.atoms.check()?;
        Ok((all, spheres))
    }
}

fn sphere(spheres: &mut Spheres, columns: &Columns, line: Line) -> Result<(), TextError> {
    let words = line.words();
    if let Some((at, factor)) = columns.size {
        spheres.add_radius(line, words[at], factor)?;
    }
    if let Some((at, kind)) = columns.weight {
        spheres.add_density(line, words[at], kind)?;
    }
    if let (Some(at), Some(spins)) = (columns.spin, &mut spheres.spins) {
        let words = at.map(|column| words[column]);
        spins.push(vector(line, "an angular velocity", words)?);
    }
    Ok(())
}

fn atom(
    all: &mut Configuration,
    columns: &Columns,
    tilt: f64,
    line: Line,
) -> Result<(), TextError> {
    let words = line.words();
    if words.len() != columns.count {
        let valid = format!("{} columns as in ITEM: ATOMS", columns.count);
        return Err(line.invalid("a line of an atom", valid, line.text));
    }
    let three = |what, at: [usize; 3]| vector(line, what, at.map(|column| words[column]));
    let id = match columns.id {
        Some(at) => line.whole("the number of an atom", 1..=u64::MAX, words[at])?,
        None => all.ids.len() as u64 + 1,
    };
    let kinds = 1..=MOST_SPECIES as u64;
    let species = match columns.species {
        Some(at) => line.whole("the type", kinds, words[at])?,
        None => 1,
    };
    let mut place = three("a coordinate", columns.place)?;
    let lengths = all.lengths();
    if columns.is_scaled {
        place.x += place.z * (tilt / lengths[0]);
        for axis in 0..3 {
            place[axis] = all.bounds[axis][0] + place[axis] * lengths[axis];
        }
    }
    if let Some(flags) = columns.images {
        let images = three("an image flag", flags)?;
        for axis in 0..3 {
            if images[axis] != 0.0 {
                place[axis] += images[axis] * lengths[axis];
            }
        }
        place.x += images[2] * tilt;
    }
    let velocity = columns.velocity.map(|at| three("a velocity", at));
    all.ids.push(id);
    all.atoms.species.push(species as u8 - 1);
    all.atoms.positions.push(place);
    let velocity = velocity.transpose()?.unwrap_or_else(Vector3::zeros);
    all.atoms.velocities.push(velocity);
    if let (Some(forces), Some(at)) = (&mut all.forces, columns.forces) {
        forces.push(three("a force", at)?);
    }
    Ok(())
}
