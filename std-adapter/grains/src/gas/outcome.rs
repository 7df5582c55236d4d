//! What a gas leaves: columns of the series, why it ended, and the summary.

use crate::gas::scene::GasScene;
use crate::packing::PackingStopReason;
use serde_json::{Map, Value};
use tribos_base::record::json_number;

/// Columns of the series: temperatures in T0; energies a sphere; `theory` the mean-field temperatures after as
/// many collisions, `haff` the translational one after the same time.
pub const COLUMNS: [&str; 12] = [
    "time",
    "collisions",
    "temperature",
    "temperature_rotational",
    "theory",
    "theory_rotational",
    "haff",
    "enskog_rate",
    "energy",
    "lost",
    "momentum",
    "density_variance",
];

/// Indices of columns.
pub(super) const TIME: usize = 0;
pub(super) const COLLISIONS: usize = 1;
pub(super) const TRANSLATIONAL: usize = 2;
pub(super) const ROTATIONAL: usize = 3;
pub(super) const THEORY: usize = 4;
pub(super) const THEORY_ROTATIONAL: usize = 5;
pub(super) const HAFF: usize = 6;
pub(super) const ENERGY: usize = 8;
pub(super) const LOST: usize = 9;
pub(super) const MOMENTUM: usize = 10;
pub(super) const VARIANCE: usize = 11;

/// A row of the series.
pub(super) type Row = [f64; COLUMNS.len()];

/// Results of a gas, in the units of its scene.
///
/// ```
/// use tribos::gas::{GasSimulation, GasSummary};
/// use tribos::run::run_to_end;
/// # use tribos::scene::GasScene;
/// # let scene = GasScene { count: 200, collisions: 3.0, ..GasScene::default() };
/// let mut gas = GasSimulation::new(&scene)?;
/// run_to_end(&mut gas, |_, _| ())?;
/// let end: GasSummary = gas.outcome();
/// assert!((end.energy[0] - end.energy[1] - end.lost).abs() < 1e-10); // none is missing
/// assert_eq!(end.json(&scene)["ending"], "collisions");
/// # Ok::<(), tribos::gas::GasError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GasSummary {
    /// Why the run ended; `None` if it has not.
    pub ending: Option<PackingStopReason>,
    /// Time at the end.
    pub time: f64,
    /// Number of steps taken.
    pub steps: u64,
    /// Number of spheres.
    pub particles: usize,
    /// Edge of the cube.
    pub length: f64,
    /// Collisions a sphere.
    pub collisions: f64,
    /// Translational temperature at the end.
    pub temperature: f64,
    /// Rotational temperature at the end.
    pub temperature_rotational: f64,
    /// Translational temperature of mean-field theory after as many collisions.
    pub theory: f64,
    /// Rotational temperature of mean-field theory after as many collisions.
    pub theory_rotational: f64,
    /// Haff's law of smooth spheres after the same time.
    pub haff: f64,
    /// Kinetic energy a sphere, at the start and at the end.
    pub energy: [f64; 2],
    /// Energy a sphere that collisions took.
    pub lost: f64,
    /// Size of the total momentum.
    pub momentum: f64,
    /// Variance over mean of the numbers of spheres in cells of about eight, at the start and at the end.
    pub density_variance: [f64; 2],
    /// Collisions of pairs within the contact time, which lost no energy.
    pub cured: u64,
    /// Time steps whose impacts missed their tolerance.
    pub unmet: u64,
    /// Wall-clock time, in s.
    pub wall_seconds: f64,
}

impl GasSummary {
    /// The summary as JSON.
    pub fn json(&self, scene: &GasScene) -> Value {
        let mut map = Map::new();
        map.insert(
            "ending".into(),
            self.ending.map(PackingStopReason::name).into(),
        );
        for (name, number) in [
            ("temperature", self.temperature),
            ("temperature_rotational", self.temperature_rotational),
            ("theory", self.theory),
            ("theory_rotational", self.theory_rotational),
            ("haff", self.haff),
            ("collisions", self.collisions),
            ("time", self.time),
            ("energy_initial", self.energy[0]),
            ("energy_final", self.energy[1]),
            ("energy_lost", self.lost),
            ("momentum", self.momentum),
            ("density_variance_initial", self.density_variance[0]),
            ("density_variance_final", self.density_variance[1]),
            ("edge", self.length),
        ] {
            map.insert(name.into(), json_number(number));
        }
        for (name, count) in [
            ("particles", self.particles as u64),
            ("steps", self.steps),
            ("collisions_cured", self.cured),
            ("steps_unmet", self.unmet),
        ] {
            map.insert(name.into(), count.into());
        }
        map.insert("wall_seconds".into(), json_number(self.wall_seconds));
        map.insert("scene".into(), scene.json());
        map.insert("version".into(), env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }
}
