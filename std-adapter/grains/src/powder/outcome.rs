//! Summary of a compaction.

use super::blocked::Means;
use crate::packing::method::ContactMethod;
use crate::packing::{ContactStatistics, PackingStopReason, losses, object};
use crate::powder::scene::PowderScene;
use nalgebra::Matrix3;
use serde_json::{Map, Value};
use tribos_base::record::json_number;
use tribos_contacts::cd::EnergyBalance;

/// Columns of the series, in the units of the scene; `stress_zz` in units of the applied pressure.
pub const COLUMNS: [&str; 15] = [
    "time",
    "step",
    "piston_height",
    "porosity",
    "contacts",
    "stress_zz",
    "sweeps",
    "residual",
    "kinetic",
    "dissipated_normal",
    "dissipated_sliding",
    "dissipated_rolling",
    "dissipated_torsion",
    "dissipated_cohesion",
    "work",
];

/// Results of a compaction, in the units of its scene.
///
/// ```
/// use tribos::powder::{PowderSimulation, PowderSummary};
/// use tribos::run::Simulation;
/// # use tribos::scene::PowderScene;
/// # let scene = PowderScene { width: 6.0, height: 8.0, pressure: 0.02, ..PowderScene::default() };
/// // A compaction after a hundred steps.
/// let mut compaction = PowderSimulation::new(&scene)?;
/// for _ in 0..100 {
///     compaction.step()?;
/// }
/// let outcome: PowderSummary = compaction.outcome();
/// assert_eq!((outcome.ending, outcome.steps), (None, 100));
/// // What pushes and what pulls add up.
/// let [all, pushes, pulls] = outcome.stress_zz();
/// assert!((all - pushes - pulls).abs() < 1e-12 && pulls <= 0.0);
/// // The work of the piston's load is lost or kept, and none is missing.
/// let lost: f64 = outcome.dissipation().iter().map(|(_, energy)| energy).sum();
/// let book = &outcome.energy;
/// let missing = book.work - lost - book.stilled - book.kinetic;
/// assert!(missing.abs() < 1e-9 * book.work);
/// assert_eq!(outcome.json(&scene)["steps"], 100);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PowderSummary {
    /// Why the run ended; `None` if it has not.
    pub ending: Option<PackingStopReason>,
    /// Time at the end.
    pub time: f64,
    /// Number of steps taken.
    pub steps: u64,
    /// Number of spheres.
    pub particles: usize,
    /// Height of the piston at the start and at the end.
    pub heights: [f64; 2],
    /// Porosity below the piston, at the start and at the end (thesis, eq. 4.5).
    pub porosity: [f64; 2],
    /// Porosity in the middle half of the height, at the end.
    pub bulk_porosity: f64,
    /// Means over the last window of steps.
    pub means: Means,
    /// Pressure on the piston.
    pub pressure: f64,
    /// Area of the piston.
    pub area: f64,
    /// Number of contacts at the end.
    pub statistics: ContactStatistics,
    /// Relative residual of the contact laws in the last step.
    pub residual: f64,
    /// Total number of sweeps.
    pub iterations: u64,
    /// Steps in which any tolerance or rule was not met: the union of the next three.
    pub unmet: u64,
    /// Steps in which the solver for lasting contacts missed its stopping rule.
    pub solver_unmet: u64,
    /// Steps that sweeps handed over to a solver with factorisations.
    pub handed_over: u64,
    /// Steps in which impacts with restitution still caused further impacts after the last round.
    pub impacts_cut: u64,
    /// Steps in which a reflection of impacts, or friction under it, missed its tolerance.
    pub impacts_unmet: u64,
    /// Energy balance.
    pub energy: EnergyBalance,
    /// Wall-clock time, in s.
    pub wall_seconds: f64,
}

impl PowderSummary {
    /// σ_zz of all contacts, of those that push and of those that pull, in units of the applied
    /// pressure (thesis, table 4.1).
    pub fn stress_zz(&self) -> [f64; 3] {
        let stress = &self.means.stress;
        [stress.total(), stress.plus, stress.minus].map(|tensor| tensor.m33 / self.pressure)
    }

    /// Where the energy went: names and energies.
    pub fn dissipation(&self) -> [(&'static str, f64); 5] {
        losses(&self.energy)
    }

    /// The summary as JSON; `stress_zz` and its shares in units of the applied pressure, the
    /// tensors in F_coh/R².
    pub fn json(&self, scene: &PowderScene) -> Value {
        let mut map = Map::new();
        map.insert(
            "ending".into(),
            self.ending.map(PackingStopReason::name).into(),
        );
        let mut put = |name: &str, value: Value| map.insert(name.into(), value);
        put("porosity_initial", json_number(self.porosity[0]));
        put("porosity_final", json_number(self.porosity[1]));
        put("porosity_bulk", json_number(self.bulk_porosity));
        put("height_initial", json_number(self.heights[0]));
        put("height_final", json_number(self.heights[1]));
        put("particles", self.particles.into());
        put("contacts", self.statistics.contacts.into());
        put("time", json_number(self.time));
        put("steps", self.steps.into());
        put("iterations_total", self.iterations.into());
        put("steps_unmet", self.unmet.into());
        if self.handed_over > 0 {
            put("steps_handed_over", self.handed_over.into());
        }
        if scene.restitution > 0.0 {
            put("steps_solver_unmet", self.solver_unmet.into());
            put("steps_impacts_cut", self.impacts_cut.into());
            put("steps_impacts_unmet", self.impacts_unmet.into());
        }
        let names = ["stress_zz", "stress_zz_plus", "stress_zz_minus"];
        for (name, stress) in names.iter().zip(self.stress_zz()) {
            put(name, json_number(stress));
        }
        put("residual_final", json_number(self.residual));
        put("max_overlap", json_number(self.statistics.max_overlap));
        put("balance", self.balance());
        put("stress", self.stress());
        put("statistics", self.statistics.json());
        let energies = self.dissipation();
        put("dissipation", object(&energies));
        let others = [
            ("work", self.energy.work),
            ("stilled", self.energy.stilled),
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

    /// What the criterion of blocked packings looks at.
    fn balance(&self) -> Value {
        object(&[
            ("piston_moved", self.means.moved),
            (
                "piston_force",
                self.means.piston / (self.pressure * self.area),
            ),
            ("net_force", self.means.net / self.means.contact),
        ])
    }

    /// The tensors, row by row.
    fn stress(&self) -> Value {
        let stress = &self.means.stress;
        let mut map = Map::new();
        for (name, tensor) in [
            ("total", stress.total()),
            ("plus", stress.plus),
            ("minus", stress.minus),
        ] {
            map.insert(name.into(), rows(&tensor));
        }
        Value::Object(map)
    }
}

fn rows(tensor: &Matrix3<f64>) -> Value {
    let row = |i: usize| (0..3).map(|j| json_number(tensor[(i, j)])).collect();
    Value::Array((0..3).map(row).map(Value::Array).collect())
}
