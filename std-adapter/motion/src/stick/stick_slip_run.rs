//! What the scenes of held bodies have in common.

use super::StickError;
use serde_json::{Map, Value};
use tribos_base::golden::{Measure, Measurement};
use tribos_base::scene::Body;

/// Series and summary of a run.
#[derive(Clone, Debug)]
pub struct StickSlipRun {
    /// Names of the columns; the first is the time.
    pub columns: &'static [&'static str],
    /// Rows of the series.
    pub rows: Vec<Vec<f64>>,
    /// The summary without the scene.
    pub outcome: Map<String, Value>,
    /// The outcome in a few lines for a terminal: head and text.
    pub told: Vec<(&'static str, String)>,
    /// Columns that a figure draws over the time, with the label of their axis.
    pub drawn: (&'static [&'static str], &'static str),
}

/// The scene of a body that holds and slips.
pub trait StickSlipScene: Body {
    /// Runs the scene to its end. `watch` sees now and then the share of the time that is done, and ends the run by
    /// answering false.
    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<StickSlipRun, StickError>;

    /// Unknowns, law and method, for `tribos explain`: head and text.
    fn carried(&self) -> Vec<(&'static str, String)>;
}

impl StickSlipRun {
    /// The summary as JSON.
    pub fn json(&self, scene: &(impl Body + ?Sized)) -> Value {
        let mut map = self.outcome.clone();
        map.insert("scene".into(), scene.json());
        map.insert("version".into(), env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }
}

/// For golden files.
pub(crate) fn measured(
    scene: &impl StickSlipScene,
    watch: &mut dyn FnMut(),
) -> Result<Measurement, StickError> {
    let run = scene.follow(&mut |_| true)?;
    watch();
    let summary = run.json(scene);
    let columns = run.columns;
    Ok(Measurement::new(&summary, columns, run.rows.into_iter()))
}

/// Implements what golden files ask of scenes.
macro_rules! measured {
    ($($scene:ty),+) => {$(
        impl Measure for $scene {
            type Error = StickError;

        fn measured(&self, watch: &mut dyn FnMut()) -> Result<Measurement, StickError> {
                measured(self, watch)
            }
        }
    )+};
}
measured!(
    crate::stick::scene::ClampScene,
    crate::stick::scene::InclineScene,
    crate::stick::scene::SpringScene,
    crate::stick::scene::TurntableScene
);
