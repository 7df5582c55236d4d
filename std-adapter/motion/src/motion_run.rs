//! What the scenes of all bodies in motion have in common: each runs in a moment, to a series and a summary.

use crate::scene::DiskScene;
use crate::slide::{
    self, FrictionWork, PATH_COLUMNS, PlanarScene, PlanarSummary, SlideError, SlideSummary,
};
use crate::stick::StickError;
use serde_json::{Map, Value};
use tribos_base::golden::Measurement;
use tribos_base::results::{Quantity, Summary, SweepView, file};
use tribos_base::scene::Body;

/// Series and summary of a run.
#[derive(Clone, Debug)]
pub struct MotionRun {
    /// Names of the columns; the first is the time.
    pub columns: &'static [&'static str],
    /// Rows of the series.
    pub rows: Vec<Vec<f64>>,
    /// The summary without the scene.
    pub outcome: Map<String, Value>,
    /// Work of friction, by the motion that lost the energy; none of a body that holds.
    pub spent: Option<FrictionWork>,
    /// The outcome in a few lines for a terminal, head and text; none where the quantities say it.
    pub told: Vec<(&'static str, String)>,
    /// Columns that a figure draws over the time, with the label of their axis; none for a figure of its own.
    pub drawn: (&'static [&'static str], &'static str),
}

impl MotionRun {
    /// The summary as JSON.
    pub fn json(&self, scene: &dyn Body) -> Value {
        file(self.outcome.clone(), scene)
    }
}

/// Why a scene of a body in motion has no result.
#[derive(Debug, thiserror::Error)]
pub enum MotionError {
    /// A sliding body.
    #[error(transparent)]
    Slide(#[from] SlideError),
    /// A body that holds and slips.
    #[error(transparent)]
    Stick(#[from] StickError),
}

impl MotionError {
    /// Whether whoever asked for the run ended it.
    pub fn is_interruption(&self) -> bool {
        matches!(
            self,
            Self::Slide(SlideError::Interrupted { .. })
                | Self::Stick(StickError::Interrupted { .. })
        )
    }
}

/// The scene of a body that slides, or holds and slips.
pub trait MotionScene: Body + Sync {
    /// The quantities of its summary.
    fn quantities(&self) -> &'static [Quantity];

    /// What a sweep shows of them.
    fn sweep_view(&self) -> SweepView;

    /// Runs the scene to its end. `watch` sees now and then the share of the run that is done, and ends the run by
    /// answering false; that of a disk, which takes a moment, goes on.
    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<MotionRun, MotionError>;

    /// Unknowns, law and method, head and text, of a body that holds.
    fn carried(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }
}

impl MotionScene for DiskScene {
    fn quantities(&self) -> &'static [Quantity] {
        SlideSummary::QUANTITIES
    }

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "distance",
            title: "Distance to rest",
            share: ["rest", "/ending", "rest"],
        }
    }

    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<MotionRun, MotionError> {
        let run = slide::run(self, |done| {
            watch(done);
        })?;
        Ok(MotionRun {
            columns: &slide::COLUMNS,
            rows: run.series.iter().map(|row| row.to_vec()).collect(),
            outcome: run.outcome.entries(),
            spent: Some(run.spent(self)),
            told: Vec::new(),
            drawn: (&[], ""),
        })
    }
}

impl<T: PlanarScene> MotionScene for T {
    fn quantities(&self) -> &'static [Quantity] {
        PlanarSummary::QUANTITIES
    }

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "curl",
            title: "Curl, to the left if positive",
            share: ["rest", "/ending", "rest"],
        }
    }

    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<MotionRun, MotionError> {
        let run = slide::follow_path(self, watch)?;
        Ok(MotionRun {
            columns: &PATH_COLUMNS,
            rows: run.series.iter().map(|row| row.to_vec()).collect(),
            outcome: run.outcome.entries(),
            spent: Some(run.spent(self)),
            told: Vec::new(),
            drawn: (&[], ""),
        })
    }
}

/// What golden files pin of a run; `watch` is called now and then.
pub fn measured_motion(
    scene: &dyn MotionScene,
    watch: &mut dyn FnMut(),
) -> Result<Measurement, MotionError> {
    let run = scene.follow(&mut |_| {
        watch();
        true
    })?;
    let summary = run.json(scene);
    Ok(Measurement::new(
        &summary,
        run.columns,
        run.rows.into_iter(),
    ))
}
