//! `setfl`: three lines of comment, the names, the grids, then F and ρ of each element and rφ of each
//! pair.

use super::values::{end, values};
use super::{Element, Grids, PotentialFile, number_and_mass};
use crate::md::atoms::MOST_SPECIES;
use crate::md::text::{Lines, TextError};

const CUT_SHORT: &str = "is the file cut short?";

pub(super) fn read(text: &str) -> Result<PotentialFile, TextError> {
    let mut lines = Lines::new(text);
    for _ in 0..3 {
        lines.need("a line of comment", CUT_SHORT)?;
    }
    let names = names(&mut lines)?;
    let grids = Grids::read(&mut lines)?;
    let mut file = PotentialFile {
        elements: Vec::new(),
        cutoff: grids.cutoff,
        density_step: grids.density_step,
        distance_step: grids.distance_step,
        embeddings: Vec::new(),
        densities: Vec::new(),
        pairs: Vec::new(),
    };
    let pairs = names.len() * (names.len() + 1) / 2;
    refuse_finnis_sinclair(text, names.len(), &grids)?;
    for name in names {
        let line = lines.need("the line of an element", CUT_SHORT)?;
        let (number, mass) = number_and_mass(line)?;
        let name = Some(name);
        file.elements.push(Element { name, number, mass });
        let embedding = values(&mut lines, "the embedding energy", grids.density_knots)?;
        file.embeddings.push(embedding);
        let density = values(&mut lines, "the density", grids.distance_knots)?;
        file.densities.push(density);
    }
    for _ in 0..pairs {
        let pair = values(&mut lines, "the pair energy", grids.distance_knots)?;
        file.pairs.push(pair);
    }
    end(&mut lines)?;
    Ok(file)
}

/// Refuses tables with a density for each pair of elements, as `pair_style eam/fs` has them: these have more
/// numbers than the lines of the elements could add to a `setfl` file.
fn refuse_finnis_sinclair(text: &str, elements: usize, grids: &Grids) -> Result<(), TextError> {
    let (embedding, distances) = (grids.density_knots as u64, grids.distance_knots as u64);
    let elements = elements as u64;
    let pairs = elements * (elements + 1) / 2;
    let needed = elements * embedding + (elements * elements + pairs) * distances;
    let words = text.lines().skip(5).flat_map(str::split_whitespace).count() as u64;
    if elements > 1 && words >= needed {
        return Err(TextError::Unsupported {
            line: 4,
            what: "a Finnis-Sinclair file (*.eam.fs) of several elements, a density for each pair,"
                .into(),
            cure: "give setfl (*.eam.alloy), with one density for each element",
        });
    }
    Ok(())
}

/// The line `count name name …`.
fn names(lines: &mut Lines) -> Result<Vec<String>, TextError> {
    const WHAT: &str = "the line of elements";
    let line = lines.need(WHAT, CUT_SHORT)?;
    let words = line.words();
    let Some((&first, names)) = words.split_first() else {
        return Err(line.missing(WHAT, "give their number and names, as in `2 Cu Ni`"));
    };
    let count = line.whole("the number of elements", 1..=MOST_SPECIES as u64, first)?;
    if names.len() as u64 != count {
        let valid = format!("{count} names after their number");
        return Err(line.invalid(WHAT, valid, line.text.trim()));
    }
    for (index, name) in names.iter().enumerate() {
        if names[..index].contains(name) {
            return Err(TextError::Twice {
                line: line.number,
                what: "the element",
                given: (*name).into(),
            });
        }
    }
    Ok(names.iter().map(|&name| name.into()).collect())
}
