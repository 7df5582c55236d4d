//! A state as VTK PolyData, and the collection that assigns times to states.

use super::{State, Values};
use crate::record::number;
use crate::record::vtk::{cell, document, integers, scalars, vectors};

/// Beginning and end of a collection.
pub(super) const COLLECTION_BEGIN: &str = "<?xml version=\"1.0\"?>\n\
    <VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
pub(super) const COLLECTION_END: &str = "</Collection>\n</VTKFile>\n";

/// A state of the collection.
pub(super) fn entry(time: f64, file: &str) -> String {
    let time = number(time);
    format!("<DataSet timestep=\"{time}\" group=\"\" part=\"0\" file=\"{file}\"/>\n")
}

/// Bodies as points with their properties.
pub(super) fn file(state: &State) -> String {
    let count = state.places.len() as i64;
    let mut data = String::new();
    for column in &state.columns {
        data += &match &column.values {
            Values::Integers(values) => integers(column.name, values.iter().copied()),
            Values::Numbers(values) => scalars(column.name, values.iter().copied()),
            Values::Vectors(values) => vectors(column.name, values.iter().copied()),
        };
    }
    let points = vectors("Points", state.places.iter().copied());
    let verts = integers("connectivity", 0..count) + &integers("offsets", 1..=count);
    document(
        state.time,
        &cell(
            state.sides.map(|side| [side.low, side.high]),
            state.sides.map(|side| side.is_periodic),
            state.tilt,
        ),
        &format!("NumberOfPoints=\"{count}\" NumberOfVerts=\"{count}\""),
        &format!(
            "<PointData>\n{data}</PointData>\n<Points>\n{points}</Points>\n\
             <Verts>\n{verts}</Verts>\n"
        ),
    )
}
