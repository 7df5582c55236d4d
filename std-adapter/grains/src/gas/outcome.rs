//! Summary of a gas.

use super::error::GasError;
use super::run::{COLUMNS, GasSimulation, GasStopReason};
use crate::gas::scene::GasScene;
use serde_json::{Map, Value};
use tribos_base::golden::{Measure, Measurement, digest};
use tribos_base::record::json_number;
use tribos_base::run::run_to_end;

/// Results of a gas, in the units of its scene.
///
/// ```
/// use tribos::gas::{GasSimulation, GasSummary};
/// use tribos::run::drive;
/// # use tribos::scene::GasScene;
/// # let scene = GasScene { count: 200, collisions: 3.0, ..GasScene::default() };
/// let mut gas = GasSimulation::new(&scene)?;
/// drive(&mut gas, |_, _| ())?;
/// let end: GasSummary = gas.outcome();
/// assert!((end.energy[0] - end.energy[1] - end.lost).abs() < 1e-10); // none is missing
/// assert_eq!(end.json(&scene)["ending"], "collisions");
/// # Ok::<(), tribos::gas::GasError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GasSummary {
    /// Why the run ended; `None` if it has not.
    pub ending: Option<GasStopReason>,
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
        map.insert("ending".into(), self.ending.map(GasStopReason::name).into());
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

impl Measure for GasScene {
    type Error = GasError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, GasError> {
        let mut gas = GasSimulation::new(self)?;
        run_to_end(&mut gas, |_, _| watch())?;
        let rows = gas.series().iter().map(|row| row.to_vec());
        let summary = gas.outcome().json(self);
        let mut measurement = Measurement::new(&summary, &COLUMNS, rows);
        measurement.state = gas.with_snapshot(|end| {
            vec![
                ("positions", digest(end.positions)),
                ("velocities", digest(end.velocities.unwrap_or_default())),
                ("spins", digest(end.spins.unwrap_or_default())),
            ]
        })?;
        Ok(measurement)
    }
}
