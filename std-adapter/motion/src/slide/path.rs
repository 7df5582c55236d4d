//! Runs of planar scenes.

use super::cost::{EvaluationCost, resistance_cost};
use super::planar::{Launch, PlanarSimulation, PlanarState, Resistance, SlideStopReason};
use super::{MotionError, energy_at_launch};
use crate::motion_run::SceneRun;
use crate::slide::scene::{CurlingScene, CylinderScene, PipeScene, PlateScene, Tipping};
use tribos_base::results::{Reporting::*, summary};
use tribos_base::scene::Body;
use tribos_friction::Evaluation;

/// Columns of the series.
const COLUMNS: [&str; 11] = [
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
/// use tribos::slide::{PlanarScene, follow_path};
/// let scenes: [&dyn PlanarScene; 3] =
///     [&CylinderScene::default(), &PipeScene::default(), &CurlingScene::default()];
/// for scene in scenes {
///     let end = follow_path(scene, &mut |_| true)?.outcome;
///     assert!(end.path_length > 0.1 && scene.course().samples == 200); // m
/// }
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
pub trait PlanarScene: Body + Sync {
    /// Launch, mass and stopping conditions.
    fn course(&self) -> PlanarCourse;

    /// Resistance that the body meets.
    fn resistance(&self) -> Result<Box<dyn Resistance>, MotionError>;

    /// Method by which force and torque are evaluated.
    fn evaluation(&self) -> Result<Evaluation, MotionError>;

    /// Times evaluations over a mix of speeds for some tenths of a second. *Accuracy*: a few per cent for the
    /// ratio of the two times, about ten per cent for the times.
    fn evaluation_cost(&self) -> Result<EvaluationCost, MotionError> {
        Ok(resistance_cost(&self.resistance()?))
    }
}

summary! {
    /// Results of the run of a planar scene.
    ///
    /// ```
    /// use tribos::scene::PipeScene;
    /// use tribos::{run::SceneRun, slide::PlanarSummary};
    /// let scene = PipeScene { spin: 0.0, speed: 1.74, gamma: 0.2, ..PipeScene::default() };
    /// let SceneRun { columns, rows, outcome } = scene.run()?;
    /// // Without spin the pipe leans, but friction stays mu N.
    /// let x = columns.iter().position(|name| *name == "x").ok_or("no x")?;
    /// let way = rows.last().ok_or("no rows")?[x];
    /// assert!((way - 1.74 * 1.74 / (2.0 * 0.2 * 9.81)).abs() < 1e-12);
    /// let PlanarSummary { max_lean, energy_error, .. } = outcome;
    /// assert!(max_lean > 0.0 && energy_error < 1e-12);
    /// assert_eq!(outcome.json(&scene)["curl"], 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[derive(Copy)]
    pub struct PlanarSummary;

    /// Why the run ended: `Rest` or `Faded`.
    ending: SlideStopReason, "-";
    /// Time at which the body comes to rest; none if it does not.
    stop_time: Option<f64>, "s";
    /// Time at the end.
    end_time: f64, "s", Shown("time");
    /// Way forward, along the launch.
    x: f64, "m", Shown("forward");
    /// Way to the left.
    y: f64, "m";
    /// Way to the left of the launch.
    curl: f64, "m", ShownAs("curl", "curl, left");
    /// Length of the path.
    path_length: f64, "m", Swept;
    /// Angle turned.
    angle: f64, "rad", Shown("angle");
    /// Velocity ratio v/(|ω|R) at the end; its limit if the body comes to rest.
    final_ratio: f64, "-", Shown("final ratio");
    /// Largest pressure gradient |l|; from 1 on a body tips that its foot does not hold.
    max_lean: f64, "-", Shown("lean");
    /// Whether the lean was held at its limit.
    tipped: bool, "-";
    /// Time from which on it was; none if it was not.
    tipped_at: Option<f64>, "s";
    /// Number of steps taken.
    steps: u64, "-", Swept;
    /// Kinetic energy at the launch.
    initial_energy: f64, "J", Swept;
    /// Work of friction, integrated from its power.
    energy_dissipated: f64, "J", Swept;
    /// |work − loss of kinetic energy| / initial energy.
    energy_error: f64, "-", Swept;
}

/// The run of a scene, with these [`COLUMNS`].
pub(super) type PathRun = SceneRun<PlanarSummary, { COLUMNS.len() }>;

/// Gives planar scenes the method that runs them.
macro_rules! run {
    ($($scene:ty),+) => {$(
        impl $scene {
            /// Runs the scene to its end.
            ///
            /// *Columns* of the series: s, m, m, m/s, m/s, rad/s, rad, –, –, J, J.
            pub fn run(&self) -> Result<PathRun, MotionError> {
                follow_path(self, &mut |_| true)
            }
        }
    )+};
}
run!(CurlingScene, CylinderScene, PipeScene, PlateScene);

/// Runs a scene; `watch` sees the share of the work that is done, roughly, and ends the run by answering false.
#[doc(hidden)]
pub fn follow_path(
    scene: &dyn PlanarScene,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<PathRun, MotionError> {
    scene.check()?;
    let body = scene.resistance()?;
    let scene = scene.course();
    let launch = Launch {
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
        return Err(MotionError::Tips { time, lean });
    }
    let interval = scouted.point.time / f64::from(scene.samples);
    let times: Vec<f64> = (1..scene.samples)
        .map(|k| interval * f64::from(k))
        .collect();
    let energy = |point: &PlanarState| scene.mass * energy_per_mass(&body, point);
    let mut rows = Vec::new();
    let observe = |point: &PlanarState| rows.push(row(point, energy(point), scene.mass));
    let arrival = journey()?.watched(&times, observe, &mut |share| watch(0.5 + 0.5 * share))?;
    let initial_energy = rows.first().map_or(f64::NAN, |row| row[9]);
    let lost = initial_energy - energy(&arrival.point);
    let work = scene.mass * arrival.point.work;
    let (end, [x, y]) = (arrival.point, arrival.point.position);
    let outcome = PlanarSummary {
        ending: arrival.ending,
        stop_time: (arrival.ending == SlideStopReason::Rest).then_some(end.time),
        end_time: end.time,
        x,
        y,
        curl: y,
        path_length: end.distance,
        angle: end.angle,
        final_ratio: end.ratio,
        max_lean: arrival.most_lean,
        tipped: arrival.tips_at.is_some(),
        tipped_at: arrival.tips_at,
        steps: arrival.steps,
        initial_energy,
        energy_dissipated: work,
        energy_error: (work - lost).abs() / initial_energy,
    };
    Ok(SceneRun {
        columns: &COLUMNS,
        rows,
        outcome,
    })
}

/// Kinetic energy per mass, (v² + C (ωR)²)/2.
pub(super) fn energy_per_mass(body: &impl Resistance, point: &PlanarState) -> f64 {
    let [x, y] = point.velocity;
    let rim = point.spin * body.radius();
    0.5 * (x * x + y * y + body.inertia_ratio() * rim * rim)
}

fn row(point: &PlanarState, energy: f64, mass: f64) -> [f64; COLUMNS.len()] {
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
