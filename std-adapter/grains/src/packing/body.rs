//! What a body says of the runs of its packing.

use super::{
    Bodies, InitialSpheres, Method, Mixture, OptionalFeatures, Packing, PackingRun,
    PackingRunError, PackingStopReason, WorldSnapshot, build_with,
};
use nalgebra::Vector3;
use serde_json::{Map, Value};
use std::fmt::Debug;
use std::ops::ControlFlow;
use tribos_base::record::frames::Kind;
use tribos_base::record::{CheckpointError, ContactRow};
use tribos_base::scene::table::Table;
use tribos_contacts::cd::StepReport;

/// What a body says of the runs of its packing: its spheres, its loads, its measures and when they end. `N` is the
/// number of columns of its series.
pub trait PackingBody<const N: usize>: Debug + Sized {
    /// Description from which a run starts.
    type Scene: Table;
    /// What is remembered from step to step, beside the state of the packing.
    type Monitor: Debug;

    /// Columns of the series.
    const COLUMNS: [&'static str; N];
    /// Number of its first columns that checkpoints of earlier versions have.
    const FORMER_COLUMNS: usize = N;
    /// First key of a checkpoint, and the version of its format.
    const FORMAT: (&'static str, u64);
    /// What a film shows.
    const KIND: Kind;
    /// When contacts are found and measured.
    const CADENCE: MeasurementSchedule;
    /// Why a run ends before its bounds.
    const OVER: PackingStopReason;

    /// Places the spheres of a scene, or reads what it names; `watch` receives the number placed so far and can
    /// stop the placement.
    fn place(
        scene: &Self::Scene,
        watch: &mut dyn FnMut(usize) -> ControlFlow<()>,
    ) -> Result<(Self, InitialSpheres), PackingRunError>;
    /// Checks that a run of the scene can start.
    fn check(scene: &Self::Scene) -> Result<(), PackingRunError> {
        PackingRun::<Self, N>::new(scene).map(|_| ())
    }

    /// The scene of the run.
    fn scene(&self) -> &Self::Scene;
    /// Materials of the spheres and how their contacts are solved.
    fn contact_keys(&self) -> ContactKeys;
    /// When a run ends in any case, and how often it writes.
    fn bounds(&self) -> RunLimits;
    /// Number of walls.
    fn walls(&self) -> usize;
    /// Corners of a wall of triangles beside these; none without one.
    fn corners(&self) -> Vec<Vector3<f64>> {
        Vec::new()
    }
    /// Spheres and walls at the start.
    fn bodies(&self, start: &InitialSpheres, features: &OptionalFeatures) -> Bodies;
    /// What the body has beside material and walls; the spheres' kinds are added to it.
    fn features(&self, _start: &InitialSpheres) -> OptionalFeatures {
        OptionalFeatures::default()
    }
    /// What is remembered at the start.
    fn monitor(&self) -> Self::Monitor;

    /// Sets the loads of the next step.
    fn prepare(&self, watch: &mut Self::Monitor, packing: &mut dyn Packing);
    /// Measures after a step, in the cadence of the body.
    fn measure(&self, _watch: &mut Self::Monitor, _seen: &MeasuredState) {}
    /// Share of the volume below the lid, or of the area, that is free.
    fn porosity(&self, seen: &MeasuredState) -> f64;
    /// The current line of the series.
    fn line(&self, watch: &Self::Monitor, seen: &MeasuredState) -> [f64; N];
    /// Whether the run is over before its bounds, asked once after every step.
    fn is_over(&self, watch: &mut Self::Monitor, seen: &MeasuredState) -> bool;

    /// Low and high coordinates of the box.
    fn extents(&self, seen: &MeasuredState) -> [[f64; 2]; 3];
    /// Sides of the box along x and y in a film.
    fn sides(&self) -> [f64; 2];
    /// Height of the packing in a film.
    fn height(&self, seen: &MeasuredState) -> f64;

    /// Adds what is remembered to a checkpoint.
    fn write_checkpoint(watch: &Self::Monitor, map: &mut Map<String, Value>);
    /// Reads what is remembered from a checkpoint.
    fn read(value: &Value) -> Result<Self::Monitor, CheckpointError>;
}

/// What a scene says of the contacts of its spheres.
#[derive(Debug)]
pub struct ContactKeys {
    pub(crate) mixture: Mixture,
    pub(crate) method: Method,
}

/// When the contacts of a run are found and measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasurementSchedule {
    /// After every step.
    Steps,
    /// For every line of the series.
    Lines,
}

/// When a run ends in any case, and how often it writes.
#[derive(Clone, Copy, Debug)]
pub struct RunLimits {
    /// Time after which a run ends; infinite for none.
    pub duration: f64,
    /// Steps after which a run ends.
    pub steps: u64,
    /// Steps from one line of the series to the next.
    pub samples: u64,
}

/// A packing between two steps.
#[derive(Debug)]
pub struct MeasuredState {
    pub packing: Box<dyn Packing>,
    /// Contacts with their forces, as of the last measurement.
    pub contacts: Vec<ContactRow>,
    /// Report of the last step.
    pub report: StepReport,
}

impl RunLimits {
    /// The bound that is reached.
    pub fn reached(&self, (time, steps): (f64, u64)) -> Option<PackingStopReason> {
        if time >= self.duration {
            Some(PackingStopReason::Time)
        } else {
            (steps >= self.steps).then_some(PackingStopReason::Steps)
        }
    }

    /// Share of the run that is done.
    pub fn progress(&self, (time, steps): (f64, u64)) -> f64 {
        let of_time = time / self.duration;
        of_time.max(steps as f64 / self.steps as f64).min(1.0)
    }
}

/// The packing of a body, at its start or from a stored state.
pub(crate) fn packing_of<B: PackingBody<N>, const N: usize>(
    body: &B,
    start: &InitialSpheres,
    frozen: Option<&WorldSnapshot>,
) -> Result<Box<dyn Packing>, PackingRunError> {
    let keys = body.contact_keys();
    let indices = start.kinds.indices(&keys.mixture);
    let mixture = (keys.mixture, indices);
    let first = *mixture.0.first();
    let features = OptionalFeatures {
        mixture: Some(mixture).filter(|(mixture, indices)| mixture.differs(indices)),
        densities: start.kinds.densities.clone(),
        ..body.features(start)
    };
    let bodies = (body.bodies(start, &features), &features);
    let mut packing = build_with(&first, bodies, &keys.method, frozen)?;
    // A stored state has its walls where they were.
    if frozen.is_none() {
        body.prepare(&mut body.monitor(), &mut *packing);
    }
    Ok(packing)
}
