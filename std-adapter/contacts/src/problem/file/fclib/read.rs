//! Problems from HDF5: vectors first, because they tell the shapes of the matrices.

use super::super::ContactProblem;
use super::super::error::{Fault, FilePosition, LocatedFault};
use super::store::Store;
use super::{matrix, names};
use crate::problem::{
    ContactComponents, ContactThresholds, Friction, GlobalProblem, ProblemError, ReducedProblem,
};

pub(in super::super) fn read(bytes: &[u8]) -> Result<ContactProblem, LocatedFault> {
    let store = Store::open(bytes, &[names::LOCAL, names::GLOBAL].concat())?;
    for name in names::CONSTRAINTS {
        if store.has(name)? {
            let refusal = "equality constraints beside contacts are not supported";
            return Err((store.place(name), Fault::Unsupported(refusal)));
        }
    }
    let layout = layout(&store)?;
    let laws = laws(&store, layout)?;
    let size = layout.size() * laws.len();
    let problem = if names::LOCAL.contains(&store.group()) {
        let q = vector(&store, "vectors/q", size)?;
        let w = matrix::read(&store, "W", [size, size])?;
        ReducedProblem::new(layout, w, q, laws).map(ContactProblem::Reduced)
    } else {
        let f = store.numbers("vectors/f")?;
        let w = vector(&store, "vectors/w", size)?;
        let m = matrix::read(&store, "M", [f.len(), f.len()])?;
        let h = matrix::read(&store, "H", [f.len(), size])?;
        GlobalProblem::new(layout, m, h, f, w, laws).map(ContactProblem::Global)
    };
    problem.map_err(|error| (place(&store, &error), Fault::Problem(error)))
}

/// The vector that a refusal is about.
fn place(store: &Store, error: &ProblemError) -> FilePosition {
    let name = match *error {
        ProblemError::Law { what, .. } => match what {
            "the friction coefficient" => names::SLIDING,
            "the rolling threshold" => names::ROLLING,
            "the torsion threshold" => names::TORSION,
            _ => names::COHESION,
        },
        ProblemError::NotFinite { what: "q" } => "vectors/q",
        ProblemError::NotFinite { what: "f" } => "vectors/f",
        ProblemError::NotFinite { what: "w" } => "vectors/w",
        _ => return FilePosition::File,
    };
    store.place(name)
}

/// Components of each contact. A group without rolling may hold it all the same, but not the reverse: FCLib's
/// three components with rolling are normal, sliding and rolling in a plane, not those of [`ContactComponents::Space`].
fn layout(store: &Store) -> Result<ContactComponents, LocatedFault> {
    let size = store.integer(names::SIZE)?;
    let layout = usize::try_from(size)
        .ok()
        .and_then(ContactComponents::of_size);
    let with_rolling = [names::LOCAL[1], names::GLOBAL[1]].contains(&store.group());
    let wanted = match with_rolling {
        true => "5 or 6, as rolling in space has",
        false => "from 2 to 6",
    };
    layout
        .filter(|layout| !with_rolling || !layout.rolling().is_empty())
        .ok_or_else(|| {
            let what = "the number of components of a contact";
            store.wrong_count(names::SIZE, what, size, wanted)
        })
}

fn vector(store: &Store, name: &str, size: usize) -> Result<Vec<f64>, LocatedFault> {
    let numbers = store.numbers(name)?;
    if numbers.len() == size {
        return Ok(numbers);
    }
    Err(store.wrong_count(name, "the number of elements", numbers.len(), size))
}

/// Laws of all contacts. Rolling thresholds must be there if contacts have rolling components; else what a file
/// does not mention is zero.
fn laws(store: &Store, layout: ContactComponents) -> Result<Vec<ContactThresholds>, LocatedFault> {
    let sliding = store.numbers(names::SLIDING)?;
    let optional = |name| match store.has(name)? {
        true => vector(store, name, sliding.len()),
        false => Ok(vec![0.0; sliding.len()]),
    };
    let rolling = match layout.rolling().is_empty() {
        true => optional(names::ROLLING)?,
        false => vector(store, names::ROLLING, sliding.len())?,
    };
    let [torsion, cohesion] = [optional(names::TORSION)?, optional(names::COHESION)?];
    let friction = friction(store, sliding.len())?;
    Ok((0..sliding.len())
        .map(|contact| ContactThresholds {
            sliding: sliding[contact],
            rolling: rolling[contact],
            torsion: torsion[contact],
            cohesion: cohesion[contact],
            friction: friction[contact],
        })
        .collect())
}

fn friction(store: &Store, contacts: usize) -> Result<Vec<Friction>, LocatedFault> {
    if !store.has(names::ELLIPSOID)? {
        return Ok(vec![Friction::Separate; contacts]);
    }
    let marks = store.integers(names::ELLIPSOID)?;
    if marks.len() != contacts {
        let what = "the number of elements";
        return Err(store.wrong_count(names::ELLIPSOID, what, marks.len(), contacts));
    }
    let friction = |mark| match mark {
        0 => Ok(Friction::Separate),
        1 => Ok(Friction::Ellipsoid),
        _ => Err(store.wrong_count(names::ELLIPSOID, "a mark", mark, "0 or 1")),
    };
    marks.into_iter().map(friction).collect()
}
