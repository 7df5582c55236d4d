//! The summary of a slide.

use super::SlideError;
use crate::slide::scene::DiskScene;
use serde_json::{Map, Value};
use tribos_base::golden::{Measure, Measurement};
use tribos_base::record::json_number;
use tribos_core::modes::TerminalMode;

/// Columns of the series: SI units in SI scenes (s, m/s, rad/s, m, rad, -, J, J).
pub const COLUMNS: [&str; 8] = [
    "time",
    "speed",
    "spin",
    "distance",
    "angle",
    "ratio",
    "kinetic_energy",
    "dissipated_energy",
];

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlideStopReason {
    /// Sliding and spinning stopped at the same instant.
    Rest,
    /// Both speeds fell below the scene's `stop_fraction`.
    Faded,
    /// The scene's `duration` elapsed.
    Duration,
}

/// Results of a run, in the units of its scene.
///
/// ```
/// use tribos::kernel::modes::TerminalMode;
/// use tribos::scene::DiskScene;
/// use tribos::slide::{SlideStopReason, SlideSummary, run};
/// let scene = DiskScene::default(); // 1 m/s, 5 rad/s, 8 cm, 0.1 kg
/// let end: SlideSummary = run(&scene, |_| ())?.outcome;
/// assert_eq!(end.ending, SlideStopReason::Rest);
/// // A disk under Coulomb friction stops at v = 0.653 ωR, whatever the launch.
/// assert!((end.ratio - 0.653).abs() < 1e-3);
/// assert!(matches!(end.limit, TerminalMode::Together { ratio } if (ratio - end.ratio).abs() < 1e-6));
/// let energy = 0.5 * 0.1 * (1.0 + 0.5 * 0.4 * 0.4); // M (v² + C (ωR)²)/2
/// assert!((end.initial_energy - energy).abs() < 1e-15);
/// assert!((end.dissipated_energy - energy).abs() < 1e-9 * energy);
/// assert_eq!(end.json(&scene)["ending"], "rest");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlideSummary {
    /// Why the run ended.
    pub ending: SlideStopReason,
    /// Time at the end, in s; the stop time if the body comes to rest.
    pub time: f64,
    /// Distance covered, in m.
    pub distance: f64,
    /// Angle turned, in rad.
    pub angle: f64,
    /// Velocity ratio v/(|ω|R) at the end; its limit if the body comes to rest.
    pub ratio: f64,
    /// Final motion predicted by the theory of fixed points.
    pub limit: TerminalMode<f64>,
    /// Number of steps taken.
    pub steps: u64,
    /// Kinetic energy at the launch, in J.
    pub initial_energy: f64,
    /// Work of friction, integrated from its power, in J.
    pub dissipated_energy: f64,
    /// |work − loss of kinetic energy| / initial energy.
    pub energy_error: f64,
}

impl SlideSummary {
    /// The summary as JSON; `stop_time` is null if the body does not come to rest.
    pub fn json(&self, scene: &DiskScene) -> Value {
        let mut map = Map::new();
        let ending = match self.ending {
            SlideStopReason::Rest => "rest",
            SlideStopReason::Faded => "faded",
            SlideStopReason::Duration => "duration",
        };
        map.insert("ending".into(), ending.into());
        let rests = self.ending == SlideStopReason::Rest;
        let stop_time = if rests {
            json_number(self.time)
        } else {
            Value::Null
        };
        map.insert("stop_time".into(), stop_time);
        let (mode, limit) = match self.limit {
            TerminalMode::Spinning => ("spinning", 0.0),
            TerminalMode::Sliding => ("sliding", f64::INFINITY),
            TerminalMode::Together { ratio } => ("together", ratio),
        };
        for (name, value) in [
            ("end_time", self.time),
            ("distance", self.distance),
            ("angle", self.angle),
            ("final_ratio", self.ratio),
            ("limit_ratio", limit),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map.insert("final_mode".into(), mode.into());
        map.insert("steps".into(), self.steps.into());
        for (name, value) in [
            ("initial_energy", self.initial_energy),
            ("energy_dissipated", self.dissipated_energy),
            ("energy_error", self.energy_error),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map.insert("scene".into(), scene.json());
        map.insert("version".into(), env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }
}

impl Measure for DiskScene {
    type Error = SlideError;

    fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, SlideError> {
        let run = super::run(self, |_| watch())?;
        let rows = run.series.iter().map(|row| row.to_vec());
        let summary = run.outcome.json(self);
        Ok(Measurement::new(&summary, &COLUMNS, rows))
    }
}
