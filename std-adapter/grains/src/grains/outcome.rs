//! Summary of a run of grains.

use super::measure::COLUMNS;
use crate::grains::scene::{EndBoundary, GrainsScene};
use crate::packing::method::ContactMethod;
use crate::packing::{ContactStatistics, PackingStopReason, losses, object};
use serde_json::{Map, Value};
use tribos_base::record::json_number;
use tribos_contacts::cd::EnergyBalance;

/// Results of a run of grains, in the units of its scene.
///
/// [`GrainsScene`] has an example.
#[derive(Clone, Debug, PartialEq)]
pub struct GrainsSummary {
    /// Why the run ended; `None` if it has not.
    pub ending: Option<PackingStopReason>,
    /// Time at the end.
    pub time: f64,
    /// Number of steps taken.
    pub steps: u64,
    /// Number of grains.
    pub grains: usize,
    /// Mass of all grains.
    pub mass: f64,
    /// Force of the grains on the floor, downwards.
    pub floor_force: f64,
    /// Slopes of the lower and the upper half of the free surface along x, in degrees, positive where they fall
    /// towards +x: a heap has one of each sign, and its `surface_angle` says nothing.
    pub surface_angles: [f64; 2],
    /// The last line of the series, with the columns of [`COLUMNS`].
    pub last: [f64; COLUMNS.len()],
    /// Numbers and forces of the contacts at the end.
    pub statistics: ContactStatistics,
    /// Total number of sweeps.
    pub iterations: u64,
    /// Steps in which any tolerance or rule was not met.
    pub unmet: u64,
    /// Steps that sweeps handed over to a solver with factorisations.
    pub handed_over: u64,
    /// Energy balance.
    pub energy: EnergyBalance,
    /// Wall-clock time, in s.
    pub wall_seconds: f64,
}

impl GrainsSummary {
    /// A column of the last line of the series.
    pub fn column(&self, name: &str) -> Option<f64> {
        let column = COLUMNS.iter().position(|column| *column == name)?;
        self.last.get(column).copied()
    }

    /// Where the energy went: names and energies.
    pub fn dissipation(&self) -> [(&'static str, f64); 5] {
        losses(&self.energy)
    }

    /// The summary as JSON.
    pub fn json(&self, scene: &GrainsScene) -> Value {
        let mut map = Map::new();
        map.insert(
            "ending".into(),
            self.ending.map(PackingStopReason::name).into(),
        );
        let mut put = |name: &str, value: Value| map.insert(name.into(), value);
        put("grains", self.grains.into());
        put("mass", json_number(self.mass));
        put("time", json_number(self.time));
        put("steps", self.steps.into());
        put("iterations_total", self.iterations.into());
        put("steps_unmet", self.unmet.into());
        if self.handed_over > 0 {
            put("steps_handed_over", self.handed_over.into());
        }
        put("contacts", self.statistics.contacts.into());
        let energies = COLUMNS.iter().position(|name| *name == "work");
        let last = COLUMNS.iter().zip(self.last);
        for (name, value) in last.take(energies.unwrap_or(COLUMNS.len())) {
            if !["time", "step", "contacts", "kinetic"].contains(name) {
                put(name, json_number(value));
            }
        }
        if scene.boundary_z == EndBoundary::Floor {
            let angles = self.surface_angles.map(json_number).to_vec();
            put("surface_angles", angles.into());
        }
        put("max_overlap", json_number(self.statistics.max_overlap));
        put("statistics", self.statistics.json());
        put("dissipation", object(&self.dissipation()));
        let others = [
            ("work", self.energy.work),
            ("kinetic", self.energy.kinetic),
            ("imbalance", self.energy.imbalance()),
        ];
        let mut energy = object(&others);
        if let (ContactMethod::Soft, Value::Object(map)) = (scene.method, &mut energy) {
            map.insert("elastic".into(), json_number(self.energy.elastic));
        }
        put("energy", energy);
        put("wall_seconds", json_number(self.wall_seconds));
        put("scene", scene.json());
        put("version", env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }
}
