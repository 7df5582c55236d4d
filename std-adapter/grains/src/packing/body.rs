//! What a body says of the runs of its packing.

use super::Packing;
use serde_json::{Map, Value};
use std::fmt::Debug;
use tribos_base::record::{CheckpointError, ContactRow};
use tribos_base::scene::Key;
use tribos_contacts::cd::StepReport;

/// What a body says of the runs of its packing: its loads, its measures and when they end. `N` is the number of
/// columns of its series.
pub(crate) trait Body<const N: usize>: Debug {
    /// What is remembered from step to step, beside the state of the packing.
    type Monitor: Debug;
    /// Why a run ends.
    type Ending: Ending;

    /// Columns of the series.
    const COLUMNS: [&'static str; N];
    /// First key of a checkpoint, and the version of its format.
    const FORMAT: (&'static str, u64);
    /// Keys of the scene.
    const KEYS: &'static [Key];
    /// When contacts are found and measured.
    const CADENCE: MeasurementSchedule;

    /// The scene of the run, as it is written into files.
    fn scene(&self) -> Value;
    /// When a run ends in any case, and how often it writes.
    fn bounds(&self) -> RunLimits;
    /// Sets the loads of the next step.
    fn prepare(&self, watch: &mut Self::Monitor, packing: &mut dyn Packing);
    /// Measures after a step, in the cadence of the body.
    fn measure(&self, _watch: &mut Self::Monitor, _seen: &MeasuredState) {}
    /// Share of the volume below the lid, or of the area, that is solid.
    fn solid_fraction(&self, seen: &MeasuredState) -> f64;
    /// The current line of the series.
    fn line(&self, watch: &Self::Monitor, seen: &MeasuredState) -> [f64; N];
    /// Whether the run is over before its bounds, asked once after every step.
    fn is_over(&self, watch: &mut Self::Monitor, seen: &MeasuredState) -> bool;

    /// Adds what is remembered to a checkpoint.
    fn write_checkpoint(watch: &Self::Monitor, map: &mut Map<String, Value>);
    /// Reads what is remembered from a checkpoint.
    fn read(value: &Value) -> Result<Self::Monitor, CheckpointError>;
}

/// Why a run ends: by a measure of its body, or by its bounds.
pub(crate) trait Ending: Copy + Debug + PartialEq {
    /// The body says that the run is over.
    const OVER: Self;
    /// The duration elapsed.
    const TIME: Self;
    /// The number of steps was reached.
    const STEPS: Self;

    /// Name in summaries and checkpoints.
    fn name(self) -> &'static str;

    /// The ending of a name.
    fn named(name: &str) -> Option<Self> {
        let mut all = [Self::OVER, Self::TIME, Self::STEPS].into_iter();
        all.find(|ending| ending.name() == name)
    }
}

/// When the contacts of a run are found and measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MeasurementSchedule {
    /// After every step.
    Steps,
    /// For every line of the series.
    Lines,
}

/// When a run ends in any case, and how often it writes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RunLimits {
    /// Time after which a run ends; infinite for none.
    pub duration: f64,
    /// Steps after which a run ends.
    pub steps: u64,
    /// Steps from one line of the series to the next.
    pub samples: u64,
}

/// A packing between two steps.
#[derive(Debug)]
pub(crate) struct MeasuredState {
    pub packing: Box<dyn Packing>,
    /// Contacts with their forces, as of the last measurement.
    pub contacts: Vec<ContactRow>,
    /// Report of the last step.
    pub report: StepReport,
}

impl RunLimits {
    /// The bound that is reached.
    pub fn reached<E: Ending>(&self, (time, steps): (f64, u64)) -> Option<E> {
        if time >= self.duration {
            Some(E::TIME)
        } else {
            (steps >= self.steps).then_some(E::STEPS)
        }
    }

    /// Share of the run that is done.
    pub fn progress(&self, (time, steps): (f64, u64)) -> f64 {
        let of_time = time / self.duration;
        of_time.max(steps as f64 / self.steps as f64).min(1.0)
    }
}
