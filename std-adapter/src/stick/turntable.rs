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
//! Without the torque I α that is r √(Ω⁴ + α²) ≤ μ_s g. Afterwards the motion relative to the table
//! obeys M u' = friction + centrifugal, Coriolis and Euler forces, by the kernel's implicit planar step.

use super::StickError;
use super::held::{HeldRun, HeldScene};
use crate::friction::limit_surface;
use crate::record::json_number;
use crate::scene::TurntableScene;
use nalgebra::Vector2;
use serde_json::{Map, Value};
use tribos_core::Real;
use tribos_core::contact::TimeStep;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};

/// Columns of the series: s, rad/s, then relative to the table m, m, m/s, m/s, rad/s, rad, and the
/// place in the room in m, m.
pub const TURNTABLE_COLUMNS: [&str; 10] = [
    "time", "rate", "x", "y", "vx", "vy", "spin", "angle", "room_x", "room_y",
];

/// The instant at which the body lets go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Release {
    /// Time, in s.
    pub time: f64,
    /// Angular velocity of the table, in rad/s.
    pub rate: f64,
}

/// Results of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurntableOutcome {
    /// When it lets go; none if it holds to the end.
    pub release: Option<Release>,
    /// When it reaches the rim of the table, in s.
    pub left: Option<f64>,
    /// Its place on the table at the end, in m.
    pub place: [f64; 2],
    /// Its velocity relative to the table at the end, in m/s.
    pub velocity: [f64; 2],
    /// Angle by which it has turned on the table, in rad.
    pub angle: f64,
}

/// Series and summary of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct TurntableRun {
    /// Rows of the series, with the columns of [`TURNTABLE_COLUMNS`].
    pub rows: Vec<[f64; TURNTABLE_COLUMNS.len()]>,
    /// The summary.
    pub outcome: TurntableOutcome,
}

/// Runs a scene to its end.
///
/// *Accuracy*: the release to rounding; the path of second order in the scene's `time_step`.
///
/// ```
/// use tribos::{scene::TurntableScene, stick::turntable::run};
/// let outcome = run(&TurntableScene::default())?.outcome;
/// let (release, left) = (outcome.release.ok_or("holds")?, outcome.left.ok_or("stays")?);
/// assert!(release.time < left && outcome.place[1] < 0.0); // it stays behind
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run(scene: &TurntableScene) -> Result<TurntableRun, StickError> {
    watched(scene, &mut |_| true)
}

/// The same; `watch` sees the share of the time that is done, and ends the run by answering false.
fn watched(
    scene: &TurntableScene,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Result<TurntableRun, StickError> {
    scene.check()?;
    let table = Table::new(scene)?;
    let release = table.release();
    let mut state = State::at_rest(scene.distance);
    let mut rows = vec![table.row(&state)];
    let mut left = None;
    for index in 1..=scene.samples {
        let until = scene.duration * (f64::from(index) / f64::from(scene.samples));
        match release.filter(|release| release.time < until) {
            None => state.time = until,
            Some(release) => {
                state.time = state.time.max(release.time);
                left = table.slide(&mut state, until, watch)?;
            }
        }
        rows.push(table.row(&state));
        if left.is_some() {
            break;
        }
    }
    let outcome = TurntableOutcome {
        release,
        left,
        place: state.place.into(),
        velocity: state.twist.velocity.into(),
        angle: state.angle,
    };
    Ok(TurntableRun { rows, outcome })
}

/// The body relative to the table.
#[derive(Clone, Debug)]
struct State {
    time: f64,
    place: Vector2<f64>,
    angle: f64,
    twist: Twist<f64>,
}

impl State {
    fn at_rest(distance: f64) -> Self {
        Self {
            time: 0.0,
            place: Vector2::new(distance, 0.0),
            angle: 0.0,
            twist: Twist::ZERO,
        }
    }
}

/// The table and the body on it.
struct Table<'a> {
    scene: &'a TurntableScene,
    body: PlanarBody<f64>,
    at_rest: Box<dyn FrictionSet<f64>>,
    in_motion: Box<dyn FrictionSet<f64>>,
}

/// Halvings that exhaust the digits of a rate.
const HALVINGS: u32 = 200;
/// Steps between two looks at the watch.
const BETWEEN: u64 = 1024;
/// Doublings from 1 rad/s that reach every rate that a number can square.
const DOUBLINGS: u32 = 500;

impl<'a> Table<'a> {
    fn new(scene: &'a TurntableScene) -> Result<Self, StickError> {
        let weight = scene.mass * scene.gravity;
        let surface = |mu: f64| limit_surface(&scene.patch, mu * weight, scene.radius, None);
        let gyration = scene.gyration_radius;
        Ok(Self {
            scene,
            body: PlanarBody::new(scene.mass, scene.mass * gyration * gyration)
                .map_err(tribos_core::Error::from)?,
            at_rest: surface(scene.mu_static)?,
            in_motion: surface(scene.mu_dynamic)?,
        })
    }

    /// What friction has to carry at rest over what it can, at a rate of the table.
    fn gauge(&self, rate: f64) -> f64 {
        let [mass, inertia] = [self.body.mass(), self.body.inertia()];
        let (arm, spin_up) = (self.scene.distance, self.scene.spin_up);
        let inward = -mass * rate * rate * arm;
        self.at_rest.gauge(&Wrench::new(
            inward,
            mass * spin_up * arm,
            inertia * spin_up,
        ))
    }

    /// The gauge is convex in Ω²: from below 1 at rest it passes 1 once.
    fn release(&self) -> Option<Release> {
        let last = self.scene.spin_up * self.scene.duration;
        if self.gauge(0.0) > 1.0 {
            let (time, rate) = (0.0, 0.0);
            return Some(Release { time, rate });
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..DOUBLINGS {
            if self.gauge(high) > 1.0 {
                break;
            }
            high *= 2.0;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.gauge(middle) > 1.0 {
                high = middle;
            } else {
                low = middle;
            }
        }
        let (rate, time) = (high, high / self.scene.spin_up);
        (rate <= last).then_some(Release { time, rate })
    }

    fn rate(&self, time: f64) -> f64 {
        self.scene.spin_up * time
    }

    /// Centrifugal, Coriolis and Euler forces in the frame of the table.
    fn push(&self, time: f64, place: Vector2<f64>, velocity: Vector2<f64>) -> Wrench<f64> {
        let (rate, spin_up) = (self.rate(time), self.scene.spin_up);
        let right = |v: Vector2<f64>| Vector2::new(v.y, -v.x);
        let force = place * (rate * rate) + right(velocity) * (2.0 * rate) + right(place) * spin_up;
        let force = force * self.body.mass();
        Wrench::new(force.x, force.y, -self.body.inertia() * spin_up)
    }

    /// Slides on to a time, to the rim of the table at most; returns when it reached that.
    fn slide(
        &self,
        state: &mut State,
        until: f64,
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Option<f64>, StickError> {
        let mut steps = 0_u64;
        while state.time < until {
            steps += 1;
            if steps.is_multiple_of(BETWEEN) && !watch(state.time / self.scene.duration) {
                let time = state.time;
                return Err(StickError::Interrupted { time });
            }
            let step = self.scene.time_step.min(until - state.time);
            let before = state.clone();
            self.step(state, step)?;
            let [inner, outer] = [before.place.norm(), state.place.norm()];
            if !outer.is_finite() {
                return Err(StickError::NotFinite { time: before.time });
            }
            if outer >= self.scene.table_radius {
                // The distance is all but linear within a step.
                let share = (self.scene.table_radius - inner) / (outer - inner);
                *state = before;
                self.step(state, share * step)?;
                return Ok(Some(state.time));
            }
        }
        Ok(None)
    }

    /// One step: the forces of the frame at half time, found from a first pass.
    fn step(&self, state: &mut State, step: f64) -> Result<(), StickError> {
        let dt = TimeStep::new(step).map_err(tribos_core::Error::from)?;
        let first = self.pass(state, state, dt);
        *state = self.pass(state, &halfway(state, &first), dt);
        Ok(())
    }

    /// The state after a step from `state` under the forces at `middle`.
    fn pass(&self, state: &State, middle: &State, dt: TimeStep<f64>) -> State {
        let (step, angle) = (dt.dt(), middle.angle);
        let push = self.push(state.time + 0.5 * step, middle.place, middle.twist.velocity);
        // The surface is that of the body: it turns with it.
        let (twist, push) = (turned(&state.twist, -angle), turned_wrench(&push, -angle));
        let after = self.body.step(&*self.in_motion, &twist, &push, dt).twist;
        let after = turned(&after, angle);
        State {
            time: state.time + step,
            place: state.place + (state.twist.velocity + after.velocity) * (0.5 * step),
            angle: state.angle + 0.5 * step * (state.twist.spin + after.spin),
            twist: after,
        }
    }

    fn row(&self, state: &State) -> [f64; TURNTABLE_COLUMNS.len()] {
        let turned = 0.5 * self.scene.spin_up * state.time * state.time;
        let room = rotated(state.place, turned);
        let velocity = state.twist.velocity;
        [
            state.time,
            self.rate(state.time),
            state.place.x,
            state.place.y,
            velocity.x,
            velocity.y,
            state.twist.spin,
            state.angle,
            room.x,
            room.y,
        ]
    }
}

/// The mean of two states.
fn halfway(a: &State, b: &State) -> State {
    let velocity = (a.twist.velocity + b.twist.velocity) * 0.5;
    State {
        time: 0.5 * (a.time + b.time),
        place: (a.place + b.place) * 0.5,
        angle: 0.5 * (a.angle + b.angle),
        twist: Twist::new(velocity.x, velocity.y, 0.5 * (a.twist.spin + b.twist.spin)),
    }
}

fn rotated(v: Vector2<f64>, angle: f64) -> Vector2<f64> {
    let (sin, cos) = (Real::sin(angle), Real::cos(angle));
    Vector2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y)
}

fn turned(twist: &Twist<f64>, angle: f64) -> Twist<f64> {
    let v = rotated(twist.velocity, angle);
    Twist::new(v.x, v.y, twist.spin)
}

fn turned_wrench(wrench: &Wrench<f64>, angle: f64) -> Wrench<f64> {
    let f = rotated(wrench.force, angle);
    Wrench::new(f.x, f.y, wrench.torque)
}

impl TurntableOutcome {
    fn json(&self, scene: &TurntableScene) -> Map<String, Value> {
        let mut map = Map::new();
        let ending = match (self.release, self.left) {
            (None, _) => "holds",
            (_, None) => "slides",
            _ => "leaves",
        };
        map.insert("ending".into(), ending.into());
        let some = |value: Option<f64>| value.map_or(Value::Null, json_number);
        let release = |part: fn(&Release) -> f64| some(self.release.as_ref().map(part));
        map.insert("release_time".into(), release(|release| release.time));
        map.insert("release_rate".into(), release(|release| release.rate));
        let limit = scene.mu_static * scene.gravity;
        let share = self
            .release
            .map(|release| release.rate * release.rate * scene.distance / limit);
        map.insert("release_share".into(), some(share));
        map.insert("leave_time".into(), some(self.left));
        for (name, value) in [
            ("x", self.place[0]),
            ("y", self.place[1]),
            ("speed", Real::hypot(self.velocity[0], self.velocity[1])),
            ("angle", self.angle),
        ] {
            map.insert(name.into(), json_number(value));
        }
        map
    }
}

impl HeldScene for TurntableScene {
    fn follow(&self, watch: &mut dyn FnMut(f64) -> bool) -> Result<HeldRun, StickError> {
        let result = watched(self, watch)?;
        let outcome = &result.outcome;
        let mut told = Vec::new();
        match outcome.release {
            None => told.push(("ending", "turns with the table to the end".into())),
            Some(release) => told.push((
                "lets go",
                format!(
                    "at {:.6} s and {:.6} rad/s, omega^2 r = {:.6} mu_s g",
                    release.time,
                    release.rate,
                    release.rate * release.rate * self.distance / (self.mu_static * self.gravity)
                ),
            )),
        }
        if let Some(left) = outcome.left {
            let [x, y] = outcome.place;
            told.push((
                "leaves",
                format!("the table at {left:.6} s, at {x:.6} m, {y:.6} m on it"),
            ));
            told.push(("turns", format!("{:.6} rad on the table", outcome.angle)));
        }
        Ok(HeldRun {
            columns: &TURNTABLE_COLUMNS,
            rows: result.rows.iter().map(|row| row.to_vec()).collect(),
            outcome: outcome.json(self),
            told,
            drawn: (&["x", "y"], "place on the table [m]"),
        })
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
                "limit surface at rest, the implicit planar step in motion".into(),
            ),
        ]
    }
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests compare with the platform")]
mod tests {
    use super::*;

    #[test]
    fn a_small_body_lets_go_where_its_whole_acceleration_meets_friction() {
        for (mu, arm, spin_up) in [(0.4, 0.2, 1.0), (0.1, 0.4, 2.0), (0.9, 0.01, 300.0)] {
            let scene = TurntableScene {
                radius: 1e-6,
                gyration_radius: 1e-9,
                mu_static: mu,
                mu_dynamic: 0.05,
                distance: arm,
                spin_up,
                ..TurntableScene::default()
            };
            let release = run(&scene).unwrap().outcome.release.unwrap();
            // r √(Ω⁴ + α²) = μ_s g
            let limit: f64 = mu * 9.81 / arm;
            let expected = (limit * limit - spin_up * spin_up).sqrt().sqrt();
            assert!(
                (release.rate / expected - 1.0).abs() < 1e-9,
                "{release:?} {expected}"
            );
        }
    }

    /// A thin ring carries |F|, |T| with its elliptic integrals; near pure torque the limit is R μ m g.
    #[test]
    fn the_torque_of_the_spin_up_lets_a_wide_body_go_earlier() {
        let narrow = TurntableScene {
            gyration_radius: 1e-9,
            spin_up: 5.0,
            ..TurntableScene::default()
        };
        let rates = [1e-9, 0.03, 0.1, 0.15].map(|gyration_radius| {
            let scene = TurntableScene {
                gyration_radius,
                ..narrow.clone()
            };
            run(&scene).unwrap().outcome.release.unwrap().rate
        });
        assert!(rates.windows(2).all(|pair| pair[1] < pair[0]), "{rates:?}");
        // I α above the torque (2/3) R μ_s m g that a disk carries: it turns at once.
        let wide = TurntableScene {
            gyration_radius: (2.0 / 3.0 * 0.03 * 0.4 * 9.81 / 5.0_f64).sqrt() * 1.001,
            ..narrow
        };
        assert_eq!(run(&wide).unwrap().outcome.release.unwrap().rate, 0.0);
    }

    #[test]
    fn it_rests_on_the_table_to_the_bit_until_it_lets_go() {
        let result = run(&TurntableScene::default()).unwrap();
        let release = result.outcome.release.unwrap();
        let held = result.rows.iter().filter(|row| row[0] <= release.time);
        assert!(held.clone().count() > 100);
        for row in held {
            let [_, _, x, y, vx, vy, spin, angle, ..] = *row;
            assert_eq!([x, y, vx, vy, spin, angle], [0.2, 0.0, 0.0, 0.0, 0.0, 0.0]);
        }
    }

    /// Without friction the path in the room is the tangent of the circle.
    #[test]
    fn almost_without_friction_it_leaves_along_the_tangent() {
        let scene = TurntableScene {
            mu_dynamic: 1e-9,
            time_step: 1e-4,
            samples: 2000,
            ..TurntableScene::default()
        };
        let result = run(&scene).unwrap();
        let release = result.outcome.release.unwrap();
        let turned = 0.5 * scene.spin_up * release.time * release.time;
        let start = rotated(Vector2::new(scene.distance, 0.0), turned);
        let speed = rotated(Vector2::new(0.0, release.rate * scene.distance), turned);
        let mut seen = 0;
        for row in result.rows.iter().filter(|row| row[0] > release.time) {
            let room = start + speed * (row[0] - release.time);
            assert!(
                (Vector2::new(row[8], row[9]) - room).norm() < 1e-6,
                "{row:?} {room}"
            );
            seen += 1;
        }
        assert!(seen > 10);
    }

    #[test]
    fn half_the_step_has_a_quarter_of_the_error() {
        let leave = |time_step: f64| {
            let scene = TurntableScene {
                time_step,
                samples: 1,
                patch: "box:0.06x0.02".parse().unwrap(),
                ..TurntableScene::default()
            };
            run(&scene).unwrap().outcome.place[1]
        };
        let [coarse, fine, finer] = [4e-3, 2e-3, 1e-3].map(leave);
        let order = ((coarse - fine) / (fine - finer)).abs().log2();
        assert!(order > 1.5, "{order} {coarse} {fine} {finer}");
    }
}
