//! Runs of planar scenes.

use super::cost::{EvaluationCost, resistance_cost};
use super::planar::{
    PlanarLaunch, PlanarResult, PlanarSimulation, PlanarState, PlanarStopReason, Resistance,
};
use super::{SlideError, energy_at_launch};
use crate::slide::scene::Tipping;
use serde_json::{Map, Value};
use tribos_base::record::json_number;
use tribos_base::scene::Body;
use tribos_friction::Evaluation;

/// Columns of the series: s, m, m, m/s, m/s, rad/s, rad, –, –, J, J.
pub const PATH_COLUMNS: [&str; 11] = [
    "time",
    "x",
    "y",
    "vx",
    "vy",
    "spin",
    "angle",
    "ratio",
    "lean",
    "kinetic_energy",
    "dissipated_energy",
];

/// Parameters common to all scenes of bodies in the plane. *Units*: SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarCourse {
    /// Initial speed, along x, in m/s.
    pub speed: f64,
    /// Initial spin, positive counterclockwise, in rad/s.
    pub spin: f64,
    /// Mass of the body, in kg.
    pub mass: f64,
    /// What happens when the body would tip.
    pub tipping: Tipping,
    /// Fraction of their initial values below which both speeds count as rest, for alpha ≥ 1.
    pub stop_fraction: f64,
    /// Number of time intervals in the series.
    pub samples: u32,
}

/// The scene of a body that follows a path in the plane.
///
/// ```
/// use tribos::scene::{CurlingScene, CylinderScene, PipeScene};
/// use tribos::slide::{PlanarScene, run_planar};
/// let scenes: [&dyn PlanarScene; 3] =
///     [&CylinderScene::default(), &PipeScene::default(), &CurlingScene::default()];
/// for scene in scenes {
///     let end = run_planar(scene)?.outcome.arrival.point;
///     assert!(end.distance > 0.1 && scene.course().samples == 200); // m
/// }
/// # Ok::<(), tribos::slide::SlideError>(())
/// ```
pub trait PlanarScene: Body {
    /// Launch, mass and stopping conditions.
    fn course(&self) -> PlanarCourse;

    /// Resistance that the body meets.
    fn resistance(&self) -> Result<Box<dyn Resistance>, SlideError>;

    /// Method by which force and torque are evaluated.
    fn evaluation(&self) -> Result<Evaluation, SlideError>;

    /// Times evaluations over a mix of speeds for some tenths of a second. *Accuracy*: a few per cent for the
    /// ratio of the two times, about ten per cent for the times.
    fn evaluation_cost(&self) -> Result<EvaluationCost, SlideError> {
        Ok(resistance_cost(&self.resistance()?))
    }
}

/// Series and summary of the run of a planar scene.
///
/// ```
/// use tribos::scene::PipeScene;
/// use tribos::slide::{PATH_COLUMNS, PlanarSummary, PathRun, run_planar};
/// let scene = PipeScene { spin: 0.0, speed: 1.74, gamma: 0.2, ..PipeScene::default() };
/// let PathRun { series, outcome } = run_planar(&scene)?;
/// // Without spin the pipe leans, but friction stays mu N.
/// let x = PATH_COLUMNS.iter().position(|name| *name == "x").ok_or("no x")?;
/// let way = series.last().ok_or("no rows")?[x];
/// assert!((way - 1.74 * 1.74 / (2.0 * 0.2 * 9.81)).abs() < 1e-12);
/// let PlanarSummary { arrival, energy_error, .. } = outcome;
/// assert!(arrival.most_lean > 0.0 && energy_error < 1e-12);
/// assert_eq!(outcome.json(&scene)["curl"], 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PathRun {
    /// Rows of the series, with the columns of [`PATH_COLUMNS`].
    pub series: Vec<[f64; PATH_COLUMNS.len()]>,
    /// The summary.
    pub outcome: PlanarSummary,
}

/// Results of the run of a planar scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarSummary {
    /// State at the end of the journey.
    pub arrival: PlanarResult,
    /// Kinetic energy at the launch, in J.
    pub initial_energy: f64,
    /// |work − loss of kinetic energy| / initial energy.
    pub energy_error: f64,
    /// Mass of the body, in kg.
    pub(super) mass: f64,
}

/// Runs a scene to its end.
///
/// ```
/// use tribos::{scene::{CurlingScene, IceModel}, slide::run_planar};
/// let model = IceModel::ScratchGuide;
/// let scene = CurlingScene { model, speed: 1.9866, spin: 1.5, ..CurlingScene::default() };
/// let end = run_planar(&scene)?.outcome.arrival.point;
/// assert!(end.position[0] > 28.3 && end.position[1] > 0.9); // m, left
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run_planar(scene: &dyn PlanarScene) -> Result<PathRun, SlideError> {
    follow_path(scene, &mut |_| true)
}

/// The same; `watch` sees the share of the work that is done, roughly, and ends the run by answering false.
#[doc(hidden)]
pub fn follow_path(
    scene: &dyn PlanarScene,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<PathRun, SlideError> {
    scene.check()?;
    let body = scene.resistance()?;
    let scene = scene.course();
    let launch = PlanarLaunch {
        velocity: [scene.speed, 0.0],
        spin: scene.spin,
    };
    let journey = || PlanarSimulation::new(&body, &launch, scene.stop_fraction);
    let rim = scene.spin * body.radius();
    let per_mass = 0.5 * (scene.speed * scene.speed + body.inertia_ratio() * rim * rim);
    energy_at_launch(scene.mass * per_mass)?;
    // Twice the same way: to its end, then with a row at each time.
    let scouted = journey()?.watched(&[], |_| (), &mut |share| watch(0.5 * share))?;
    if let (Tipping::Refuse, Some(time)) = (scene.tipping, scouted.tips_at) {
        let lean = scouted.most_lean;
        return Err(SlideError::Tips { time, lean });
    }
    let interval = scouted.point.time / f64::from(scene.samples);
    let times: Vec<f64> = (1..scene.samples)
        .map(|k| interval * f64::from(k))
        .collect();
    let energy = |point: &PlanarState| scene.mass * energy_per_mass(&body, point);
    let mut series = Vec::new();
    let observe = |point: &PlanarState| series.push(row(point, energy(point), scene.mass));
    let arrival = journey()?.watched(&times, observe, &mut |share| watch(0.5 + 0.5 * share))?;
    let initial_energy = series.first().map_or(f64::NAN, |row| row[9]);
    let lost = initial_energy - energy(&arrival.point);
    let work = scene.mass * arrival.point.work;
    Ok(PathRun {
        series,
        outcome: PlanarSummary {
            arrival,
            initial_energy,
            energy_error: (work - lost).abs() / initial_energy,
            mass: scene.mass,
        },
    })
}

/// Kinetic energy per mass, (v² + C (ωR)²)/2.
pub(super) fn energy_per_mass(body: &impl Resistance, point: &PlanarState) -> f64 {
    let [x, y] = point.velocity;
    let rim = point.spin * body.radius();
    0.5 * (x * x + y * y + body.inertia_ratio() * rim * rim)
}

fn row(point: &PlanarState, energy: f64, mass: f64) -> [f64; PATH_COLUMNS.len()] {
    let ([x, y], [vx, vy]) = (point.position, point.velocity);
    [
        point.time,
        x,
        y,
        vx,
        vy,
        point.spin,
        point.angle,
        point.ratio,
        point.lean,
        energy,
        mass * point.work,
    ]
}

impl PlanarSummary {
    /// The summary as JSON; `stop_time` is null if the body does not come to rest.
    pub fn json(&self, scene: &dyn PlanarScene) -> Value {
        let PlanarResult {
            point,
            ending,
            most_lean,
            tips_at,
            steps,
        } = self.arrival;
        let (name, stop_time) = match ending {
            PlanarStopReason::Rest => ("rest", json_number(point.time)),
            PlanarStopReason::Faded => ("faded", Value::Null),
        };
        let mut map = Map::new();
        map.insert("ending".into(), name.into());
        map.insert("stop_time".into(), stop_time);
        for (name, value) in [
            ("end_time", point.time),
            ("x", point.position[0]),
            ("y", point.position[1]),
            ("curl", point.position[1]),
            ("path_length", point.distance),
            ("angle", point.angle),
            ("final_ratio", point.ratio),
            ("max_lean", most_lean),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map.insert("tipped".into(), tips_at.is_some().into());
        let tipped_at = tips_at.map_or(Value::Null, json_number);
        map.insert("tipped_at".into(), tipped_at);
        map.insert("steps".into(), steps.into());
        for (name, value) in [
            ("initial_energy", self.initial_energy),
            ("energy_dissipated", self.mass * point.work),
            ("energy_error", self.energy_error),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map.insert("scene".into(), scene.json());
        map.insert("version".into(), env!("CARGO_PKG_VERSION").into());
        Value::Object(map)
    }
}
