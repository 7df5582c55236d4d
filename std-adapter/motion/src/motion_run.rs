//! What the scenes of all bodies in motion have in common: each runs in a moment, to a series and a summary.

use crate::error::MotionError;
use crate::scene::DiskScene;
use crate::slide::{self, FrictionWork, PlanarScene, PlanarSummary, SlideSummary};
use serde_json::{Map, Value};
use tribos_base::golden::Measurement;
use tribos_base::results::{Quantity, Summary, SweepView, file};
use tribos_base::scene::Body;

/// Series and summary of the run of a scene.
///
/// ```
/// use tribos::run::SceneRun;
/// use tribos::scene::SpringScene;
/// let SceneRun { columns, rows, outcome } = SpringScene::default().run()?;
/// let time = columns.iter().position(|name| *name == "time").ok_or("no time")?;
/// assert_eq!(rows.last().map(|last| last[time]), Some(outcome.end_time));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SceneRun<S, const N: usize> {
    /// Names of the columns; the first is the time.
    pub columns: &'static [&'static str; N],
    /// Rows of the series.
    pub rows: Vec<[f64; N]>,
    /// The summary.
    pub outcome: S,
}

impl<S: Summary, const N: usize> SceneRun<S, N> {
    /// The run without its type, with what a terminal and a figure show.
    pub(crate) fn shown(
        self,
        told: Vec<(&'static str, String)>,
        drawn: (&'static [&'static str], &'static str),
    ) -> MotionRun {
        MotionRun {
            columns: self.columns,
            rows: self.rows.iter().map(|row| row.to_vec()).collect(),
            outcome: self.outcome.entries(),
            told,
            spent: None,
            drawn,
        }
    }
}

/// Series and summary of a run of any body.
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
        let run = slide::follow(self, |done| {
            watch(done);
        })?;
        Ok(MotionRun {
            spent: Some(run.spent(self)),
            ..run.shown(Vec::new(), (&[], ""))
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
            spent: Some(run.spent(self)),
            ..run.shown(Vec::new(), (&[], ""))
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
