//! Everything that a golden file pins of a run.

use super::digest::Digest;
use super::quantity::{Quantity, leaves};
use crate::record::{ContactRow, Partner};
use crate::scene::{BODY, DEFAULT_BODY, Key};
use nalgebra::Vector3;
use serde_json::Value;
use std::collections::BTreeMap;

/// Results of a scene.
///
/// ```
/// use tribos::golden::{Measurement, measure};
/// use tribos::scene::DiskScene;
/// let disk = DiskScene { speed: 1.0, spin: 0.0, gamma: 0.3, ..DiskScene::default() };
/// let run: Measurement = measure(&disk.into(), || ())?;
/// assert_eq!(run.columns[0], "time");
/// let stop = run.rows.last().ok_or("no rows")?[0];
/// assert!((stop - 1.0 / (0.3 * 9.81)).abs() < 1e-13); // v/(mu g)
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Measurement {
    /// Resolved parameters of the scene, defaults included.
    pub parameters: BTreeMap<String, Quantity>,
    /// Quantities of the summary in its order, without clock times.
    pub summary: Vec<(String, Quantity)>,
    /// Names of the series' columns; the first is the time.
    pub columns: Vec<String>,
    /// Lines of the series.
    pub rows: Vec<Vec<f64>>,
    /// Digests of the final state, for powders and tips.
    pub state: Vec<(&'static str, u64)>,
    /// Keys of the scene, by which the parameters of pins from earlier versions are found.
    #[doc(hidden)]
    pub keys: &'static [Key],
    /// Parameters of the default scene: those that pins of earlier versions lack, and that have these values, are
    /// no change.
    #[doc(hidden)]
    pub defaults: BTreeMap<String, Quantity>,
}

/// Branches of a summary that are not results; averages follow from the series.
const NO_RESULTS: [&str; 4] = ["averages", "scene", "version", "wall_seconds"];

/// A scene that can be run to the end for its results.
pub trait Measure {
    /// Why a run ends early.
    type Error;

    /// Runs the scene; `watch` is called after every step.
    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, Self::Error>;
}

impl Measurement {
    /// A measurement from a summary, which contains the scene, and a series.
    pub fn new(
        summary: &Value,
        columns: &[impl ToString],
        rows: impl Iterator<Item = Vec<f64>>,
    ) -> Self {
        let mut parameters = values(&summary["scene"]);
        // A disk's scene need not name its body.
        parameters
            .entry(BODY.name.into())
            .or_insert_with(|| Quantity::Text(DEFAULT_BODY.into()));
        Self {
            parameters,
            summary: leaves(summary, |name| NO_RESULTS.contains(&name)),
            columns: columns.iter().map(ToString::to_string).collect(),
            rows: rows.collect(),
            state: Vec::new(),
            keys: &[],
            defaults: BTreeMap::new(),
        }
    }

    /// Digests of one column over blocks of `block_rows` rows, the last one shorter.
    pub(super) fn blocks(&self, column: usize, block_rows: usize) -> Vec<u64> {
        let cell = |row: &Vec<f64>| row.get(column).copied().unwrap_or(f64::NAN);
        self.rows
            .chunks(block_rows.max(1))
            .map(|rows| Digest::of(rows.iter().map(cell)))
            .collect()
    }
}

/// The values in force in a scene, by their keys.
pub fn values(scene: &Value) -> BTreeMap<String, Quantity> {
    leaves(scene, |_| false).into_iter().collect()
}

/// Digest of the components of vectors.
pub fn digest(vectors: &[Vector3<f64>]) -> u64 {
    Digest::of(vectors.iter().flat_map(components))
}

/// Digest of the pairs in contact, with gaps, normals, forces and torques.
pub fn contacts(rows: &[ContactRow]) -> u64 {
    let mut digest = Digest::EMPTY;
    for row in rows {
        let (kind, partner) = match row.b {
            Partner::Particle(index) => (0.0, index),
            Partner::Wall(index) => (1.0, index),
        };
        let names = [f64::from(row.a), kind, f64::from(partner), row.gap];
        let vectors = [row.normal, row.force, row.torque];
        for number in names.into_iter().chain(vectors.iter().flat_map(components)) {
            digest.number(number);
        }
    }
    digest.value()
}

fn components(vector: &Vector3<f64>) -> [f64; 3] {
    [vector.x, vector.y, vector.z]
}
