//! Grains under their loads, step by step: their measures and when they end.

use super::layout::Layout;
use super::loads::Loads;
use super::measure::{COLUMNS, Now};
use super::run::Ending;
use crate::grains::scene::GrainsScene;
use crate::packing::{self, Body, Bounds, Cadence, Packing, Seen};
use serde_json::{Map, Value};
use tribos_base::record::CheckpointError;
use tribos_base::record::kept::damaged;
use tribos_base::scene::Key;

/// Slow steps after which the grains count as at rest.
const SLOW_STEPS: u64 = 100;

/// Grains in their box under its loads.
#[derive(Debug)]
pub(super) struct Laden {
    pub scene: GrainsScene,
    pub layout: Layout,
    pub loads: Loads,
}

/// Number of steps for which the grains have been slow.
#[derive(Debug)]
pub(super) struct Slow(pub u64);

impl Laden {
    /// The state after a step, for measurements.
    pub fn now<'a>(&'a self, seen: &'a Seen) -> Now<'a> {
        Now {
            scene: &self.scene,
            layout: &self.layout,
            loads: &self.loads,
            packing: &*seen.packing,
            contacts: &seen.contacts,
            report: &seen.report,
        }
    }
}

impl Body<{ COLUMNS.len() }> for Laden {
    type Watch = Slow;
    type Ending = Ending;

    const COLUMNS: [&'static str; COLUMNS.len()] = COLUMNS;
    const FORMAT: (&'static str, u64) = ("tribos_grains", 3);
    const KEYS: &'static [Key] = GrainsScene::KEYS;
    const CADENCE: Cadence = Cadence::Lines;

    fn scene(&self) -> Value {
        self.scene.json()
    }

    fn bounds(&self) -> Bounds {
        bounds(&self.scene)
    }

    fn prepare(&self, _: &mut Slow, packing: &mut dyn Packing) {
        self.loads.apply(&self.layout, packing);
    }

    fn solid_fraction(&self, seen: &Seen) -> f64 {
        let now = self.now(seen);
        now.solid_fraction(now.extents().map(|[low, high]| high - low))
    }

    fn line(&self, _: &Slow, seen: &Seen) -> [f64; COLUMNS.len()] {
        self.now(seen).line()
    }

    /// Counts slow steps.
    fn is_over(&self, Slow(slow): &mut Slow, seen: &Seen) -> bool {
        let rest = self.scene.rest_speed;
        let is_slow = rest.is_some_and(|rest| self.now(seen).speed() < rest);
        *slow = if is_slow { *slow + 1 } else { 0 };
        *slow >= SLOW_STEPS
    }

    fn put(Slow(slow): &Slow, map: &mut Map<String, Value>) {
        map.insert("slow".into(), (*slow).into());
    }

    fn read(value: &Value) -> Result<Slow, CheckpointError> {
        let slow = value["slow"].as_u64();
        Ok(Slow(slow.ok_or_else(|| damaged("slow"))?))
    }
}

/// Limits of a run of a scene.
pub(super) fn bounds(scene: &GrainsScene) -> Bounds {
    Bounds {
        duration: scene.duration,
        steps: scene.max_steps,
        samples: scene.sample_every,
    }
}

impl packing::Ending for Ending {
    const OVER: Self = Self::Rest;
    const TIME: Self = Self::Time;
    const STEPS: Self = Self::Steps;

    fn name(self) -> &'static str {
        self.name()
    }
}
