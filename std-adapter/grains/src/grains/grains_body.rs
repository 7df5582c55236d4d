//! Grains under their loads, step by step: their measures and when they end.

use super::layout::Layout;
use super::loads::Loads;
use super::measure::{COLUMNS, PackingState};
use super::outcome::GrainsStopReason;
use crate::grains::scene::GrainsScene;
use crate::packing::{self, Body, MeasuredState, MeasurementSchedule, Packing, RunLimits};
use serde_json::{Map, Value};
use tribos_base::record::CheckpointError;
use tribos_base::record::checkpoint::damaged;
use tribos_base::scene::Key;

/// Slow steps after which the grains count as at rest.
const SLOW_STEPS: u64 = 100;

/// Grains in their box under its loads.
#[derive(Debug)]
pub(super) struct GrainsBody {
    pub scene: GrainsScene,
    pub layout: Layout,
    pub loads: Loads,
}

/// Number of steps for which the grains have been slow.
#[derive(Debug)]
pub(super) struct SlowStepCount(pub u64);

impl GrainsBody {
    /// The state after a step, for measurements.
    pub fn now<'a>(&'a self, seen: &'a MeasuredState) -> PackingState<'a> {
        PackingState {
            scene: &self.scene,
            layout: &self.layout,
            loads: &self.loads,
            packing: &*seen.packing,
            contacts: &seen.contacts,
            report: &seen.report,
        }
    }
}

impl Body<{ COLUMNS.len() }> for GrainsBody {
    type Monitor = SlowStepCount;
    type Ending = GrainsStopReason;

    const COLUMNS: [&'static str; COLUMNS.len()] = COLUMNS;
    const FORMAT: (&'static str, u64) = ("tribos_grains", 3);
    const KEYS: &'static [Key] = GrainsScene::KEYS;
    const CADENCE: MeasurementSchedule = MeasurementSchedule::Lines;

    fn scene(&self) -> Value {
        self.scene.json()
    }

    fn bounds(&self) -> RunLimits {
        bounds(&self.scene)
    }

    fn prepare(&self, _: &mut SlowStepCount, packing: &mut dyn Packing) {
        self.loads.apply(&self.layout, packing);
    }

    fn solid_fraction(&self, seen: &MeasuredState) -> f64 {
        let now = self.now(seen);
        now.solid_fraction(now.extents().map(|[low, high]| high - low))
    }

    fn line(&self, _: &SlowStepCount, seen: &MeasuredState) -> [f64; COLUMNS.len()] {
        self.now(seen).line()
    }

    /// Counts slow steps.
    fn is_over(&self, SlowStepCount(slow): &mut SlowStepCount, seen: &MeasuredState) -> bool {
        let rest = self.scene.rest_speed;
        let is_slow = rest.is_some_and(|rest| self.now(seen).speed() < rest);
        *slow = if is_slow { *slow + 1 } else { 0 };
        *slow >= SLOW_STEPS
    }

    fn write_checkpoint(SlowStepCount(slow): &SlowStepCount, map: &mut Map<String, Value>) {
        map.insert("slow".into(), (*slow).into());
    }

    fn read(value: &Value) -> Result<SlowStepCount, CheckpointError> {
        let slow = value["slow"].as_u64();
        Ok(SlowStepCount(slow.ok_or_else(|| damaged("slow"))?))
    }
}

/// Limits of a run of a scene.
pub(super) fn bounds(scene: &GrainsScene) -> RunLimits {
    RunLimits {
        duration: scene.duration,
        steps: scene.max_steps,
        samples: scene.sample_every,
    }
}

impl packing::Ending for GrainsStopReason {
    const OVER: Self = Self::Rest;
    const TIME: Self = Self::Time;
    const STEPS: Self = Self::Steps;

    fn name(self) -> &'static str {
        self.name()
    }
}
