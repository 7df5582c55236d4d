//! Reading extended XYZ, as ASE and OVITO write it; orthogonal cells, and of spheres those that lean along x over z.

mod header;

use super::atoms::{Atoms, MOST_SPECIES};
use super::configuration::Configuration;
use super::spheres::{Cell, Spheres};
use super::text::{Line, Lines, TextError};
use header::Header;
use nalgebra::Vector3;
use std::collections::HashSet;

const CUT_SHORT: &str = "is the file cut short?";
/// Species of spheres in a file without them.
const NAMELESS: &str = "X";

/// The last frame of a file; all before it must be readable.
///
/// ```
/// use tribos::md::extended_xyz::last_frame;
/// // One atom of argon on its way along x, at two times.
/// let head = "1\nLattice=\"5 0 0 0 5 0 0 0 9\" pbc=\"T T F\" \
///             Properties=species:S:1:pos:R:3:vel:R:3\n";
/// let text = format!("{head}Ar 1 2 3 0.5 0 0\n{head}Ar 2 2 3 0.5 0 0\n");
/// let last = last_frame(&text)?;
/// assert_eq!(last.atoms.positions[0].x, 2.0);
/// assert_eq!(last.atoms.velocities[0].x, 0.5);
/// assert_eq!(last.space()?.lengths(), [Some(5.0), Some(5.0), None]); // open along z
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Columns `species` and `pos` are required, `vel` (or `velo`, `velocities`) and `id` are optional,
/// others are ignored; a file with a column `radius` or `diameter` may do without `species`. Species that are all
/// numbers from 1 keep them; names are numbered in the order of their first appearance. Masses are 1.
/// Without `Lattice` all axes are open and the box encloses the atoms.
pub fn last_frame(text: &str) -> Result<Configuration, TextError> {
    let mut last = None;
    each_frame(text, |frame, spheres| last = Some((frame, spheres)))?;
    let last = last.ok_or_else(|| {
        Lines::new("")
            .here()
            .missing("a frame", "is the file empty?")
    });
    let (frame, spheres) = last?;
    spheres.upright()?;
    Ok(frame)
}

/// Reads all frames, of which there is one at least.
pub fn each_frame(
    text: &str,
    mut take: impl FnMut(Configuration, Spheres),
) -> Result<(), TextError> {
    let mut lines = Lines::new(text);
    let mut is_first = true;
    loop {
        lines.skip_blank_lines();
        if lines.peek().is_none() && !is_first {
            return Ok(());
        }
        is_first = false;
        let (frame, spheres) = frame(&mut lines)?;
        take(frame, spheres);
    }
}

#[doc(hidden)]
/// The cell that a line of keys such as `Lattice`, `Origin` and `pbc` says; open without them.
pub fn cell(line: Line<'_>) -> Result<Cell, TextError> {
    header::cell(line)
}

fn frame(lines: &mut Lines) -> Result<(Configuration, Spheres), TextError> {
    let line = lines.need("the number of atoms", "is the file empty?")?;
    let most = u64::from(u32::MAX);
    let count = line.whole("the number of atoms", 0..=most, line.text.trim())?;
    let line = lines.need("the line of properties", CUT_SHORT)?;
    let header = Header::read(line)?;
    let has = [
        header.size.is_some(),
        header.spin.is_some(),
        header.weight.is_some(),
    ];
    let mut spheres = Spheres {
        materials: header.material.map(|_| Vec::new()),
        tilt: header.cell.tilt,
        is_silent: header.cell.is_silent,
        ..Spheres::begin(line, has)
    };
    let mut atoms = Atoms::at(Vec::new());
    let (mut ids, mut names) = (Vec::new(), Vec::new());
    let mut seen = HashSet::new();
    for index in 0..count {
        let line = lines.need("an atom", CUT_SHORT)?;
        let words = line.words();
        if words.len() != header.count {
            let valid = format!("{} columns as in Properties", header.count);
            return Err(line.invalid("a line of an atom", valid, line.text));
        }
        atoms
            .positions
            .push(vector(line, "a coordinate", &words, header.place)?);
        let velocity = header
            .velocity
            .map(|at| vector(line, "a velocity", &words, at));
        let velocity = velocity.transpose()?.unwrap_or_else(Vector3::zeros);
        atoms.velocities.push(velocity);
        if let Some((at, factor)) = header.size {
            spheres.add_radius(line, words[at], factor)?;
        }
        if let Some((at, kind)) = header.weight {
            spheres.add_density(line, words[at], kind)?;
        }
        if let (Some(at), Some(materials)) = (header.material, &mut spheres.materials) {
            let kinds = 1..=MOST_SPECIES as u64;
            materials.push(line.whole("the material", kinds, words[at])? as u8);
        }
        if let (Some(at), Some(spins)) = (header.spin, &mut spheres.spins) {
            spins.push(vector(line, "an angular velocity", &words, at)?);
        }
        names.push((line, header.species.map_or(NAMELESS, |at| words[at])));
        let id = match header.id {
            Some(at) => line.whole("the number of an atom", 0..=u64::MAX, words[at])?,
            None => index + 1,
        };
        if !seen.insert(id) {
            return Err(TextError::Twice {
                line: line.number,
                what: "atom",
                given: id.to_string(),
            });
        }
        ids.push(id);
    }
    let names = number_species(&mut atoms, &names)?;
    atoms.check()?;
    let bounds = header.cell.bounds;
    let has_box = bounds.is_some();
    let bounds = bounds.unwrap_or_else(|| extent(&atoms.positions));
    let configuration = Configuration {
        atoms,
        ids,
        names,
        bounds,
        has_box,
        is_periodic: header.cell.is_periodic,
        step: 0,
        forces: None,
    };
    Ok((configuration, spheres))
}

/// A vector from three columns.
fn vector(
    line: Line,
    what: &'static str,
    words: &[&str],
    from: usize,
) -> Result<Vector3<f64>, TextError> {
    let [x, y, z] = [0, 1, 2].map(|axis| line.number(what, words[from + axis]));
    Ok(Vector3::new(x?, y?, z?))
}

/// Numbers the species of all atoms; returns the names unless they are numbers.
fn number_species(
    atoms: &mut Atoms,
    words: &[(Line, &str)],
) -> Result<Option<Vec<String>>, TextError> {
    let range = 1..=MOST_SPECIES;
    let number = |(_, word): &(Line, &str)| word.parse().ok().filter(|n| range.contains(n));
    let numbers: Option<Vec<usize>> = words.iter().map(number).collect();
    if let Some(numbers) = numbers {
        let most = numbers.iter().max().copied().unwrap_or(1);
        atoms.species = numbers.iter().map(|number| (number - 1) as u8).collect();
        atoms.masses = vec![1.0; most];
        return Ok(None);
    }
    let mut names: Vec<String> = Vec::new();
    for &(line, word) in words {
        let known = names.iter().position(|name| name == word);
        let species = known.unwrap_or(names.len());
        if known.is_none() {
            names.push(word.into());
        }
        if species >= MOST_SPECIES {
            let valid = format!("one of at most {MOST_SPECIES}");
            return Err(line.invalid("the species", valid, word));
        }
        atoms.species.push(species as u8);
    }
    atoms.masses = vec![1.0; names.len()];
    Ok(Some(names))
}

/// Lowest and highest coordinate along each axis.
fn extent(places: &[Vector3<f64>]) -> [[f64; 2]; 3] {
    std::array::from_fn(|axis| {
        let mut along = places.iter().map(|place| place[axis]);
        let first = along.next().unwrap_or(0.0);
        along.fold([first; 2], |[low, high], x| [low.min(x), high.max(x)])
    })
}
