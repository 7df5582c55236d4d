//! Problems to HDF5.

use super::super::ContactProblem;
use super::super::error::{Fault, FilePosition, LocatedFault};
use super::{matrix, names};
use crate::problem::{ContactThresholds, Friction};
use hdf5_pure::{FileBuilder, GroupBuilder, LibVer};

/// Bytes of a file that HDF5 1.8 and later read.
pub(in super::super) fn write(problem: &ContactProblem) -> Result<Vec<u8>, LocatedFault> {
    let with_rolling = usize::from(!problem.layout().rolling().is_empty());
    let kind = match problem {
        ContactProblem::Reduced(_) => names::LOCAL,
        ContactProblem::Global(_) => names::GLOBAL,
    };
    let mut file = FileBuilder::new();
    file.with_libver_bounds(LibVer::Earliest, LibVer::V18);
    let mut group = file.create_group(kind[with_rolling]);
    // From 2 to 6.
    let size = problem.layout().size() as i32;
    group.create_dataset(names::SIZE).with_i32_data(&[size]);
    let mut vectors = group.create_group("vectors");
    let matrices = match problem {
        ContactProblem::Reduced(reduced) => {
            vectors.create_dataset("q").with_f64_data(reduced.q());
            matrix::write(&mut group, "W", reduced.w())
        }
        ContactProblem::Global(global) => {
            vectors.create_dataset("f").with_f64_data(global.f());
            vectors.create_dataset("w").with_f64_data(global.w());
            matrix::write(&mut group, "M", global.m())
                .and_then(|()| matrix::write(&mut group, "H", global.h()))
        }
    };
    if matrices.is_none() {
        let refusal = "a matrix has more than 2147483647 rows, columns or entries, the most that FCLib can count";
        return Err((FilePosition::File, Fault::Unsupported(refusal)));
    }
    laws(&mut vectors, problem.laws(), with_rolling == 1);
    group.add_group(vectors.finish());
    file.add_group(group.finish());
    file.finish()
        .map_err(|error| (FilePosition::File, Fault::Hdf5(error.to_string())))
}

/// Friction coefficients, and what else any law has.
fn laws(vectors: &mut GroupBuilder, laws: &[ContactThresholds], with_rolling: bool) {
    let mut add = |path: &str, always: bool, value: fn(&ContactThresholds) -> f64| {
        let numbers: Vec<f64> = laws.iter().map(value).collect();
        if always || numbers.iter().any(|&number| number != 0.0) {
            vectors.create_dataset(name(path)).with_f64_data(&numbers);
        }
    };
    add(names::SLIDING, true, |law| law.sliding);
    add(names::ROLLING, with_rolling, |law| law.rolling);
    add(names::TORSION, false, |law| law.torsion);
    add(names::COHESION, false, |law| law.cohesion);
    let ellipsoid = |law: &ContactThresholds| i32::from(law.friction == Friction::Ellipsoid);
    let marks: Vec<i32> = laws.iter().map(ellipsoid).collect();
    if marks.contains(&1) {
        vectors
            .create_dataset(name(names::ELLIPSOID))
            .with_i32_data(&marks);
    }
}

/// The last part of a path.
fn name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}
