//! A block on an incline that is raised: it holds to the bit, lets go at Euler's angle and slides down.
//!
//! The block's weight pulls with m g sin θ through the centre of its patch, which presses with m g cos θ. The
//! patch holds what lies in its limit surface; a push through the centre is the largest force of every
//! patch, so that neither size nor shape nor load matter:
//!
//! ```text
//! holds while tan θ ≤ μ_s(age);    then a = g (sin θ − μ_d cos θ)
//! ```

use crate::error::MotionError;
use crate::motion_run::{MotionRun, MotionScene, SceneRun};
use crate::stick::scene::InclineScene;
use tribos_base::bracket::Bracket;
use tribos_base::results::{Quantity, Reporting::*, Summary, SweepView, summary};
use tribos_core::Real;
use tribos_core::law::{RestTime, StaticAgeing};
use tribos_core::twist::Wrench;
use tribos_friction::Area;

/// Columns of the series.
const COLUMNS: [&str; 6] = ["time", "angle", "position", "velocity", "drive", "friction"];

summary! {
    /// Results of a run of a block on an incline.
    #[derive(Copy)]
    pub struct InclineSummary;

    /// Whether the block `slides` in the end or `holds`.
    ending: &'static str, "-";
    /// Time at which it lets go; none if it holds to the end.
    release_time: Option<f64>, "s", Shown("time");
    /// Angle of the incline then.
    release_angle: Option<f64>, "rad", Shown("angle");
    /// Slope of the incline then.
    release_slope: Option<f64>, "-", Shown("slope");
    /// Acceleration with which it starts: the jump from mu_s to mu_d.
    release_acceleration: Option<f64>, "m/s^2", Swept;
    /// Distance slid: zero to the bit while it holds.
    distance: f64, "m", Swept;
    /// Speed at the end.
    speed: f64, "m/s", Swept;
    /// Angle of the incline at the end.
    end_angle: f64, "rad", Swept;
}

/// The run of a scene, with these [`COLUMNS`].
type InclineRun = SceneRun<InclineSummary, { COLUMNS.len() }>;

impl InclineScene {
    /// Runs the scene to its end.
    ///
    /// *Columns* of the series: s, rad, m, m/s, N, N.
    ///
    /// *Accuracy*: rounding. *Special values*: while the block holds, position and velocity are zero to the bit.
    ///
    /// ```
    /// use tribos::scene::InclineScene;
    /// let fixed = InclineScene { start_angle: 0.6, tilt_rate: 0.0, duration: 2.0, ..InclineScene::default() };
    /// let end = fixed.run()?.outcome;
    /// let acceleration = 9.81 * (0.6_f64.sin() - 0.3 * 0.6_f64.cos());
    /// assert!((end.distance / (0.5 * acceleration * 4.0) - 1.0).abs() < 1e-14);
    /// # Ok::<(), tribos::stick::MotionError>(())
    /// ```
    pub fn run(&self) -> Result<InclineRun, MotionError> {
        self.check()?;
        let slope = InclineProblem::new(self)?;
        let release = slope.release();
        let mut state = SlideState::default();
        let mut rows = vec![slope.row(0.0, &state, release)];
        let samples = self.samples;
        for index in 1..=samples {
            let time = self.duration * (f64::from(index) / f64::from(samples));
            if let Some(start) = release.filter(|start| *start < time) {
                state.time = state.time.max(start);
                slope.slide(&mut state, time);
            }
            rows.push(slope.row(time, &state, release));
        }
        let release_angle = release.map(|time| slope.angle(time));
        let outcome = InclineSummary {
            ending: if release.is_some() { "slides" } else { "holds" },
            release_time: release,
            release_angle,
            release_slope: release_angle.map(libm::tan),
            release_acceleration: release_angle.map(|angle| slope.acceleration(angle)),
            distance: state.position,
            speed: state.velocity,
            end_angle: slope.angle(self.duration),
        };
        Ok(SceneRun {
            columns: &COLUMNS,
            rows,
            outcome,
        })
    }
}

/// What the block has done since it let go.
#[derive(Debug, Default)]
struct SlideState {
    time: f64,
    position: f64,
    velocity: f64,
}

/// The incline under its block.
struct InclineProblem<'a> {
    scene: &'a InclineScene,
    ageing: StaticAgeing<f64>,
    /// Push through the centre over the largest that the patch carries, per unit of both: 1.
    gauge: f64,
}

/// Nodes and weights of Gauss and Legendre's rule of five points on [0, 1].
const RULE: [[f64; 2]; 5] = [
    [0.046_910_077_030_668, 0.118_463_442_528_094_54],
    [0.230_765_344_947_158_45, 0.239_314_335_249_683_23],
    [0.5, 0.284_444_444_444_444_44],
    [0.769_234_655_052_841_5, 0.239_314_335_249_683_23],
    [0.953_089_922_969_332, 0.118_463_442_528_094_54],
];
/// Largest turn, in rad, over which the rule is exact to rounding.
const TURN: f64 = 0.1;
/// Halvings that exhaust the digits of a time.
const HALVINGS: usize = 200;

impl<'a> InclineProblem<'a> {
    fn new(scene: &'a InclineScene) -> Result<Self, MotionError> {
        let surface = Area::named(&scene.patch, scene.radius, None)?.limit_surface(1.0)?;
        Ok(Self {
            scene,
            ageing: StaticAgeing::new(
                scene.mu_static,
                scene.ageing_rate,
                scene.ageing_cutoff_time,
            )?,
            gauge: surface.gauge(&Wrench::new(1.0, 0.0, 0.0)),
        })
    }

    fn angle(&self, time: f64) -> f64 {
        let raised = self.scene.start_angle + self.scene.tilt_rate * time;
        raised.min(self.scene.end_angle)
    }

    /// Time at which the incline reaches an angle.
    fn time_of(&self, angle: f64) -> f64 {
        if angle <= self.scene.start_angle {
            0.0
        } else if angle > self.scene.end_angle {
            f64::INFINITY
        } else {
            (angle - self.scene.start_angle) / self.scene.tilt_rate
        }
    }

    /// Time at which the block lets go, within the run.
    fn release(&self) -> Option<f64> {
        let young = self.time_of(Real::atan(self.scene.mu_static / self.gauge));
        let grows = self.scene.ageing_rate > 0.0 && young > self.scene.ageing_cutoff_time;
        let release = if grows { self.aged_release() } else { young };
        (release <= self.scene.duration).then_some(release)
    }

    /// The same for contacts that have grown stronger. What is missing to slip is convex in the time, and
    /// negative at the cut-off: it has one root or none.
    fn aged_release(&self) -> f64 {
        let excess = |time: f64| {
            let angle = self.angle(time);
            let held = self.ageing.mu_static(RestTime { time }) * Real::cos(angle);
            Real::sin(angle) * self.gauge - held
        };
        let high = self.time_of(self.scene.end_angle);
        if !(high.is_finite() && excess(high) > 0.0) {
            return f64::INFINITY;
        }
        let slips = |time: f64| excess(time) > 0.0;
        let around = Bracket::new(self.scene.ageing_cutoff_time, high);
        around.halved(HALVINGS, slips).high
    }

    fn acceleration(&self, angle: f64) -> f64 {
        let friction = self.scene.mu_dynamic / self.gauge;
        self.scene.gravity * (Real::sin(angle) - friction * Real::cos(angle))
    }

    /// Slides on to a time, in pieces over which the angle hardly turns.
    fn slide(&self, state: &mut SlideState, until: f64) {
        let top = self.time_of(self.scene.end_angle);
        while state.time < until {
            let mut end = until;
            if state.time < top && self.scene.tilt_rate > 0.0 {
                end = end.min(top).min(state.time + TURN / self.scene.tilt_rate);
            }
            let step = end - state.time;
            let (mut gained, mut moved) = (0.0, 0.0);
            for [node, weight] in RULE {
                let acceleration = self.acceleration(self.angle(state.time + node * step));
                gained += weight * acceleration;
                moved += weight * (1.0 - node) * acceleration;
            }
            state.position += step * (state.velocity + step * moved);
            state.velocity += step * gained;
            state.time = end;
        }
    }

    fn row(&self, time: f64, state: &SlideState, release: Option<f64>) -> [f64; COLUMNS.len()] {
        let angle = self.angle(time);
        let weight = self.scene.mass * self.scene.gravity;
        let drive = weight * Real::sin(angle);
        let friction = if release.is_some_and(|release| release < time) {
            weight * Real::cos(angle) * self.scene.mu_dynamic / self.gauge
        } else {
            drive
        };
        [time, angle, state.position, state.velocity, drive, friction]
    }
}

impl MotionScene for InclineScene {
    fn quantities(&self) -> &'static [Quantity] {
        InclineSummary::QUANTITIES
    }

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "release_angle",
            title: "Angle at which the block lets go",
            share: ["slides", "/ending", "slides"],
        }
    }

    fn follow(&self, _: &mut dyn FnMut(f64) -> bool) -> Result<MotionRun, MotionError> {
        let result = self.run()?;
        let outcome = &result.outcome;
        let told = match (outcome.release_time, outcome.release_angle) {
            (Some(time), Some(angle)) => vec![
                (
                    "lets go",
                    format!(
                        "at {time:.6} s and {angle:.6} rad, a slope of {:.6}",
                        libm::tan(angle)
                    ),
                ),
                (
                    "starts with",
                    format!(
                        "{:.6} m/s^2",
                        outcome.release_acceleration.unwrap_or(f64::NAN)
                    ),
                ),
                (
                    "slides",
                    format!("{:.6} m, to {:.6} m/s", outcome.distance, outcome.speed),
                ),
            ],
            _ => vec![(
                "ending",
                format!("holds up to {:.6} rad", outcome.end_angle),
            )],
        };
        Ok(result.shown(
            told,
            (&["drive", "friction"], "force along the incline [N]"),
        ))
    }

    fn carried(&self) -> Vec<(&'static str, String)> {
        vec![
            ("unknowns", "1: velocity down the incline".into()),
            (
                "law",
                format!("dry, mu_s = {}, mu_d = {}", self.mu_static, self.mu_dynamic),
            ),
            ("patch", self.patch.to_string()),
            (
                "method",
                "limit surface at rest, integrals to rounding in motion".into(),
            ),
        ]
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    #[test]
    fn below_eulers_angle_a_block_stays_to_the_bit_and_above_it_starts_with_the_jump() {
        for (mu_static, mu_dynamic, patch, mass) in [
            (0.5, 0.3, "disk", 1.0),
            (0.25, 0.25, "box:0.3x0.01", 1e-3),
            (1.0, 0.2, "hertz", 40.0),
            (0.05, 0.0, "bar:0.2", 1e6),
        ] {
            let scene = InclineScene {
                patch: patch.parse().unwrap(),
                mass,
                mu_static,
                mu_dynamic,
                end_angle: 1.4,
                duration: 28.0,
                samples: 1000,
                ..InclineScene::default()
            };
            let result = scene.run().unwrap();
            let outcome = &result.outcome;
            let [release, start, acceleration] = [
                outcome.release_time,
                outcome.release_angle,
                outcome.release_acceleration,
            ]
            .map(Option::unwrap);
            assert!((start.tan() / mu_static - 1.0).abs() < 1e-13, "{patch}");
            let jump = 9.81 * (mu_static - mu_dynamic) * start.cos();
            assert!((acceleration - jump).abs() < 1e-12 * 9.81);
            for row in &result.rows {
                let [time, angle, position, velocity, drive, friction] = *row;
                if time <= release {
                    assert_eq!((position.to_bits(), velocity.to_bits()), (0, 0));
                    assert_eq!(drive, friction);
                    continue;
                }
                // Energy per mass: the work of weight and friction along the way.
                let raised = 0.05;
                let [t, s] = [start, angle].map(|at| at.min(1.4));
                let gained =
                    9.81 / raised * ((t.cos() - s.cos()) - mu_dynamic * (s.sin() - t.sin()));
                let beyond = time - (1.4 / raised).min(time);
                let gained = gained + beyond * 9.81 * (s.sin() - mu_dynamic * s.cos());
                assert!(
                    (velocity - gained).abs() < 1e-10,
                    "{time} {velocity} {gained}"
                );
            }
        }
    }

    #[test]
    fn a_fixed_incline_below_the_angle_holds_for_any_time() {
        let scene = InclineScene {
            start_angle: Real::atan(0.5) - 1e-12,
            tilt_rate: 0.0,
            duration: 1e9,
            ..InclineScene::default()
        };
        let outcome = scene.run().unwrap().outcome;
        assert_eq!((outcome.release_time, outcome.distance), (None, 0.0));
        let steeper = InclineScene {
            start_angle: FRAC_PI_4,
            duration: 3.0,
            ..scene
        };
        let outcome = steeper.run().unwrap().outcome;
        let acceleration = 9.81 * (1.0 - 0.3) / 2_f64.sqrt();
        assert!((outcome.distance / (4.5 * acceleration) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn a_contact_that_ages_holds_longer_and_lets_go_where_the_slope_meets_its_age() {
        for rate in [0.05, 1e-3, 1e-5] {
            let scene = InclineScene {
                ageing_rate: 0.02,
                tilt_rate: rate,
                duration: 2.0 / rate,
                ..InclineScene::default()
            };
            let outcome = scene.run().unwrap().outcome;
            let (release, start) = (
                outcome.release_time.unwrap(),
                outcome.release_angle.unwrap(),
            );
            let held = 0.5 + 0.02 * release.ln();
            assert!((start.tan() / held - 1.0).abs() < 1e-12, "{rate}");
            assert!(start > Real::atan(0.5));
        }
    }
}
