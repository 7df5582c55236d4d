//! A body on a turntable that is spun up: it turns with the table to the bit, lets go where the limit surface
//! of its patch is reached, and slides outward.
//!
//! At rest on the table at the distance r, friction has to give the body the acceleration of its circle and
//! its spin-up α together:
//!
//! ```text
//! (−m Ω² r, m α r, I α) in the static limit surface of the patch
//! ```
//!
//! Without the torque I α that is r √(Ω⁴ + α²) ≤ μ_s g. Afterwards the body is followed in the room, where only
//! friction acts: by the kernel's implicit planar step against the velocity of the table under it. Without friction
//! its path is straight to rounding, however quick the table is. Each step is compared with two of half its length.

mod path;

use crate::error::MotionError;
use crate::motion_run::{MotionRun, MotionScene, SceneRun};
use crate::stick::scene::TurntableScene;
use nalgebra::Vector2;
use path::{SlideState, State};
use tribos_base::bracket::Bracket;
use tribos_base::results::{Quantity, Reporting::*, Summary, SweepView, summary};
use tribos_core::Real;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};
use tribos_friction::Area;

/// Columns of the series.
const COLUMNS: [&str; 10] = [
    "time", "rate", "x", "y", "vx", "vy", "spin", "angle", "room_x", "room_y",
];

summary! {
    /// Results of a run of a body on a turntable.
    #[derive(Copy)]
    pub struct TurntableSummary;

    /// Whether the body `holds`, `slides` or `leaves` the table.
    ending: &'static str, "-";
    /// Time at which it lets go; none if it holds to the end.
    release_time: Option<f64>, "s", Swept;
    /// Angular velocity of the table then.
    release_rate: Option<f64>, "rad/s", Shown("rate");
    /// Centripetal acceleration then, in limits of static friction: omega^2 r/(mu_s g).
    release_share: Option<f64>, "-", Shown("omega^2 r/(mu_s g)");
    /// Time at which it reaches the rim of the table.
    leave_time: Option<f64>, "s", Shown("leaves");
    /// Place on the table at the end.
    x: f64, "m", Swept;
    /// Place on the table at the end, across.
    y: f64, "m", Swept;
    /// Speed relative to the table at the end.
    speed: f64, "m/s", Swept;
    /// Angle by which it has turned on the table.
    angle: f64, "rad", Swept;
}

/// The run of a scene, with these [`COLUMNS`].
type TurntableRun = SceneRun<TurntableSummary, { COLUMNS.len() }>;

impl TurntableScene {
    /// Runs the scene to its end.
    ///
    /// *Columns* of the series: s, rad/s, then relative to the table m, m, m/s, m/s, rad/s, rad, and the place in
    /// the room in m, m.
    ///
    /// *Accuracy*: the release to rounding; each step of the path to 1e-9 of the table's radius, and of its velocity to
    /// 1e-9 of the rim's or of √(μ_s g R).
    ///
    /// ```
    /// use tribos::scene::TurntableScene;
    /// let outcome = TurntableScene::default().run()?.outcome;
    /// let (release, left) = (outcome.release_time.ok_or("holds")?, outcome.leave_time.ok_or("stays")?);
    /// assert!(release < left && outcome.y < 0.0); // it stays behind
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(&self) -> Result<TurntableRun, MotionError> {
        watched(self, &mut |_| true)
    }
}

/// Runs a scene; `watch` sees the share of the time that is done, and ends the run by answering false.
fn watched(
    scene: &TurntableScene,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<TurntableRun, MotionError> {
    scene.check()?;
    let table = Table::new(scene)?;
    let release = table.release();
    let mut sliding: Option<SlideState> = None;
    let mut rows = vec![table.row(0.0, None)];
    let mut left = None;
    for index in 1..=scene.samples {
        let until = scene.duration * (f64::from(index) / f64::from(scene.samples));
        let mut time = until;
        if let Some(release) = release.filter(|release| release.time < until) {
            let sliding = sliding.get_or_insert_with(|| table.let_go(&release));
            left = sliding.until(&table, until, watch)?;
            time = sliding.state.time;
        }
        rows.push(table.row(time, sliding.as_ref().map(|sliding| &sliding.state)));
        if left.is_some() {
            break;
        }
    }
    let [.., x, y, vx, vy, _, angle, _, _] = rows[rows.len() - 1];
    let limit = scene.mu_static * scene.gravity;
    let share = |start: SlipStart| start.rate * start.rate * scene.distance / limit;
    let outcome = TurntableSummary {
        ending: match (release, left) {
            (None, _) => "holds",
            (_, None) => "slides",
            _ => "leaves",
        },
        release_time: release.map(|start| start.time),
        release_rate: release.map(|start| start.rate),
        release_share: release.map(share),
        leave_time: left,
        x,
        y,
        speed: Real::hypot(vx, vy),
        angle,
    };
    Ok(SceneRun {
        columns: &COLUMNS,
        rows,
        outcome,
    })
}

/// Time and rate at which the body lets go.
#[derive(Clone, Copy, Debug)]
struct SlipStart {
    time: f64,
    rate: f64,
}

/// The table and the body on it.
struct Table<'a> {
    scene: &'a TurntableScene,
    body: PlanarBody<f64>,
    at_rest: Box<dyn FrictionSet<f64>>,
    in_motion: Box<dyn FrictionSet<f64>>,
}

/// Halvings that exhaust the digits of a rate.
const HALVINGS: usize = 200;
/// Doublings from 1 rad/s that reach every rate that a number can square.
const DOUBLINGS: u32 = 500;

impl<'a> Table<'a> {
    fn new(scene: &'a TurntableScene) -> Result<Self, MotionError> {
        let weight = scene.mass * scene.gravity;
        let area = Area::named(&scene.patch, scene.radius, None)?;
        let gyration = scene.gyration_radius;
        Ok(Self {
            scene,
            body: PlanarBody::new(scene.mass, scene.mass * gyration * gyration)
                .map_err(tribos_core::Error::from)?,
            at_rest: area.limit_surface(scene.mu_static * weight)?,
            in_motion: area.limit_surface(scene.mu_dynamic * weight)?,
        })
    }

    /// What friction has to carry at rest over what it can, at a rate of the table.
    fn gauge(&self, rate: f64) -> f64 {
        let [mass, inertia] = [self.body.mass(), self.body.inertia()];
        let (arm, spin_up) = (self.scene.distance, self.scene.table_angular_acceleration);
        let inward = -mass * rate * rate * arm;
        self.at_rest.gauge(&Wrench::new(
            inward,
            mass * spin_up * arm,
            inertia * spin_up,
        ))
    }

    /// The gauge is convex in Ω²: from below 1 at rest it passes 1 once.
    fn release(&self) -> Option<SlipStart> {
        let last = self.scene.table_angular_acceleration * self.scene.duration;
        if self.gauge(0.0) > 1.0 {
            let (time, rate) = (0.0, 0.0);
            return Some(SlipStart { time, rate });
        }
        let mut high = 1.0;
        for _ in 0..DOUBLINGS {
            if self.gauge(high) > 1.0 {
                break;
            }
            high *= 2.0;
        }
        let slips = |rate: f64| self.gauge(rate) > 1.0;
        let high = Bracket::new(0.0, high).halved(HALVINGS, slips).high;
        let (rate, time) = (high, high / self.scene.table_angular_acceleration);
        (rate <= last).then_some(SlipStart { time, rate })
    }

    fn rate(&self, time: f64) -> f64 {
        self.scene.table_angular_acceleration * time
    }

    /// Angle by which the table has turned.
    fn turned(&self, time: f64) -> f64 {
        0.5 * self.scene.table_angular_acceleration * time * time
    }

    /// The body that turns with the table, at its release.
    fn let_go(&self, release: &SlipStart) -> SlideState {
        let angle = self.turned(release.time);
        let place = rotated(Vector2::new(self.scene.distance, 0.0), angle);
        let state = State {
            time: release.time,
            place,
            angle,
            twist: self.under(release.time, &place),
        };
        SlideState {
            state,
            next: self.scene.time_step,
            steps: 0,
        }
    }

    /// Motion of the table at a place.
    fn under(&self, time: f64, place: &Vector2<f64>) -> Twist<f64> {
        let rate = self.rate(time);
        Twist::new(-rate * place.y, rate * place.x, rate)
    }

    /// A row of the series; without a state the body turns with the table.
    fn row(&self, time: f64, state: Option<&State>) -> [f64; COLUMNS.len()] {
        let (rate, turned) = (self.rate(time), self.turned(time));
        let (place, velocity, spin, angle, room) = match state {
            None => {
                let place = Vector2::new(self.scene.distance, 0.0);
                (place, Vector2::zeros(), 0.0, 0.0, rotated(place, turned))
            }
            Some(state) => {
                let slip = difference(&state.twist, &self.under(time, &state.place));
                let [place, velocity] = [state.place, slip.velocity].map(|v| rotated(v, -turned));
                (
                    place,
                    velocity,
                    slip.spin,
                    state.angle - turned,
                    state.place,
                )
            }
        };
        [
            time, rate, place.x, place.y, velocity.x, velocity.y, spin, angle, room.x, room.y,
        ]
    }
}

fn difference(a: &Twist<f64>, b: &Twist<f64>) -> Twist<f64> {
    Twist {
        velocity: a.velocity - b.velocity,
        spin: a.spin - b.spin,
    }
}

fn rotated(v: Vector2<f64>, angle: f64) -> Vector2<f64> {
    let (sin, cos) = (Real::sin(angle), Real::cos(angle));
    Vector2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
}

impl MotionScene for TurntableScene {
    fn quantities(&self) -> &'static [Quantity] {
        TurntableSummary::QUANTITIES
    }

    fn sweep_view(&self) -> SweepView {
        SweepView {
            drawn: "release_rate",
            title: "Rate at which the body lets go",
            share: ["leaves", "/ending", "leaves"],
        }
    }

    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<MotionRun, MotionError> {
        let result = watched(self, watch)?;
        let outcome = &result.outcome;
        let mut told = Vec::new();
        match (
            outcome.release_time,
            outcome.release_rate,
            outcome.release_share,
        ) {
            (Some(time), Some(rate), Some(share)) => told.push((
                "lets go",
                format!("at {time:.6} s and {rate:.6} rad/s, omega^2 r = {share:.6} mu_s g"),
            )),
            _ => told.push(("ending", "turns with the table to the end".into())),
        }
        if let Some(left) = outcome.leave_time {
            let (x, y) = (outcome.x, outcome.y);
            told.push((
                "leaves",
                format!("the table at {left:.6} s, at {x:.6} m, {y:.6} m on it"),
            ));
            told.push(("turns", format!("{:.6} rad on the table", outcome.angle)));
        }
        Ok(result.shown(told, (&["x", "y"], "place on the table [m]")))
    }

    fn carried(&self) -> Vec<(&'static str, String)> {
        vec![
            (
                "unknowns",
                "3: two of the velocity, and the spin, relative to the table".into(),
            ),
            (
                "law",
                format!("dry, mu_s = {}, mu_d = {}", self.mu_static, self.mu_dynamic),
            ),
            ("patch", self.patch.to_string()),
            (
                "method",
                "limit surface at rest, the implicit planar step in the room in motion, its error controlled"
                    .into(),
            ),
        ]
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests;
