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
/// *Accuracy*: the release to rounding; each step of the path to 1e-9 of the table's radius, and of its velocity to
/// 1e-9 of the rim's or of √(μ_s g R).
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
    let mut sliding: Option<Sliding> = None;
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
    let outcome = TurntableOutcome {
        release,
        left,
        place: [x, y],
        velocity: [vx, vy],
        angle,
    };
    Ok(TurntableRun { rows, outcome })
}

/// The body in the room.
#[derive(Clone, Copy, Debug)]
struct State {
    time: f64,
    place: Vector2<f64>,
    angle: f64,
    twist: Twist<f64>,
}

/// A body that has let go, and the length of its next step.
#[derive(Clone, Debug)]
struct Sliding {
    state: State,
    next: f64,
    steps: u64,
}

/// Largest error of a step, in units of the table's radius and of the speed of its rim.
const TOLERANCE: f64 = 1e-9;
/// Safety and bounds of the change of a step's length.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.2;
const GROW: f64 = 5.0;
/// Order of the error of a step in its length.
const ORDER: f64 = 3.0;
/// Rejections in a row that say that no step will do.
const MOST_REJECTIONS: u32 = 200;
/// Most steps of a run: some minutes.
const MOST_STEPS: u64 = 100_000_000;

impl Sliding {
    /// Slides on to a time, to the rim of the table at most; returns when it reached that.
    fn until(
        &mut self,
        table: &Table<'_>,
        until: f64,
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Option<f64>, StickError> {
        while self.state.time < until {
            let before = self.state;
            let time = before.time;
            if self.steps.is_multiple_of(BETWEEN) && !watch(time / table.scene.duration) {
                return Err(StickError::Interrupted { time });
            }
            let step = self.step(table, until)?;
            let rim = table.scene.table_radius;
            if self.state.place.norm() >= rim {
                // The path is all but straight within a step.
                let share = share_to(&before.place, &self.state.place, rim);
                self.state = table.halves(&before, share * step)?;
                return Ok(Some(self.state.time));
            }
        }
        Ok(None)
    }

    /// One step whose error is within the tolerance; returns its length.
    fn step(&mut self, table: &Table<'_>, until: f64) -> Result<f64, StickError> {
        let time = self.state.time;
        if self.steps >= MOST_STEPS {
            let steps = self.steps;
            return Err(StickError::TooManySteps { steps, time });
        }
        for _ in 0..MOST_REJECTIONS {
            let longest = self.next.min(table.scene.time_step);
            let is_cut = longest >= until - time;
            let step = if is_cut { until - time } else { longest };
            let whole = table.step(&self.state, step)?;
            let mut halves = table.halves(&self.state, step)?;
            let share = table.error(&whole, &halves) / TOLERANCE;
            let change = SAFETY / Real::pow(share, 1.0 / ORDER);
            if share <= 1.0 {
                let proposed = step * change.min(GROW);
                if !is_cut || proposed > self.next {
                    self.next = proposed;
                }
                if is_cut {
                    halves.time = until;
                }
                self.state = halves;
                self.steps += 1;
                return Ok(step);
            }
            self.next = step * if change > SHRINK { change } else { SHRINK };
            if time + self.next <= time {
                break;
            }
        }
        Err(StickError::NotFinite { time })
    }
}

/// Share of the way from a place within a circle about 0 to one outside at which it is crossed.
fn share_to(from: &Vector2<f64>, to: &Vector2<f64>, radius: f64) -> f64 {
    let way = to - from;
    let (along, length_sq) = (from.dot(&way), way.norm_squared());
    let inside = radius * radius - from.norm_squared();
    // The positive root of |from + s way|² = radius², without a difference of nearly equal numbers.
    let root = (along * along + length_sq * inside).sqrt();
    if along > 0.0 {
        inside / (root + along)
    } else {
        (root - along) / length_sq
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

    /// Angle by which the table has turned.
    fn turned(&self, time: f64) -> f64 {
        0.5 * self.scene.spin_up * time * time
    }

    /// The body that turns with the table, at its release.
    fn let_go(&self, release: &Release) -> Sliding {
        let angle = self.turned(release.time);
        let place = rotated(Vector2::new(self.scene.distance, 0.0), angle);
        let state = State {
            time: release.time,
            place,
            angle,
            twist: self.under(release.time, &place),
        };
        Sliding {
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

    /// Two steps of half the length.
    fn halves(&self, state: &State, step: f64) -> Result<State, StickError> {
        let middle = self.step(state, 0.5 * step)?;
        self.step(&middle, 0.5 * step)
    }

    /// One step: where it leads and how the body is turned at half time is found from two first passes.
    fn step(&self, state: &State, step: f64) -> Result<State, StickError> {
        let dt = TimeStep::new(step).map_err(tribos_core::Error::from)?;
        let free = self.pass(state, state, dt);
        let first = self.pass(state, &free, dt);
        Ok(self.pass(state, &first, dt))
    }

    /// The state after a step from `state`, if the table has the motion that is under `end` then.
    fn pass(&self, state: &State, end: &State, dt: TimeStep<f64>) -> State {
        let (step, angle) = (dt.dt(), 0.5 * (state.angle + end.angle));
        let time = state.time + step;
        let [before, after] = [
            self.under(state.time, &state.place),
            self.under(time, &end.place),
        ];
        // Against the table the body is pushed by what the table gains. The surface is that of the body: it turns
        // with it.
        let [mass, inertia] = [self.body.mass(), self.body.inertia()];
        let gained = (before.velocity - after.velocity) * (mass / step);
        let push = Wrench::new(
            gained.x,
            gained.y,
            (before.spin - after.spin) * (inertia / step),
        );
        let slip = turned(&difference(&state.twist, &before), -angle);
        let push = turned_wrench(&push, -angle);
        let friction = self.body.step(&*self.in_motion, &slip, &push, dt).friction;
        let friction = turned_wrench(&friction, angle);
        let twist = Twist {
            velocity: state.twist.velocity + friction.force * (step / mass),
            spin: state.twist.spin + friction.torque * (step / inertia),
        };
        State {
            time,
            place: state.place + (state.twist.velocity + twist.velocity) * (0.5 * step),
            angle: state.angle + 0.5 * step * (state.twist.spin + twist.spin),
            twist,
        }
    }

    /// Difference of two states, in units of the table's radius and of the speed of its rim.
    fn error(&self, a: &State, b: &State) -> f64 {
        let scene = self.scene;
        let gyration = self.body.gyration();
        let by_friction = (scene.mu_static * scene.gravity * scene.table_radius).sqrt();
        let speed = (self.rate(b.time) * scene.table_radius).max(by_friction);
        let apart = difference(&a.twist, &b.twist);
        let places = (a.place - b.place).norm() + gyration * (a.angle - b.angle).abs();
        let speeds = apart.velocity.norm() + gyration * apart.spin.abs();
        places / scene.table_radius + speeds / speed
    }

    /// A row of the series; without a state the body turns with the table.
    fn row(&self, time: f64, state: Option<&State>) -> [f64; TURNTABLE_COLUMNS.len()] {
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
                "limit surface at rest, the implicit planar step in the room in motion, its error controlled"
                    .into(),
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

    /// A body without size on a quick table, by explicit midpoint steps of 2 µs in the room.
    fn followed(scene: &TurntableScene, release: Release) -> f64 {
        let dt = 2e-6;
        let pull = scene.mu_dynamic * scene.gravity;
        let mut time = release.time;
        let mut x = Vector2::new(scene.distance, 0.0);
        let mut v = Vector2::new(0.0, release.rate * scene.distance);
        let slowed = |time: f64, x: Vector2<f64>, v: Vector2<f64>| {
            let slip = v - Vector2::new(-x.y, x.x) * (scene.spin_up * time);
            slip * (-pull / slip.norm().max(f64::MIN_POSITIVE))
        };
        while x.norm() < scene.table_radius {
            let half = slowed(time, x, v) * (0.5 * dt);
            let a = slowed(time + 0.5 * dt, x + v * (0.5 * dt), v + half);
            x += (v + a * (0.5 * dt)) * dt;
            v += a * dt;
            time += dt;
        }
        time
    }

    #[test]
    fn a_body_leaves_a_quick_table_when_an_independent_integration_says_at_any_step() {
        let quick = TurntableScene {
            mu_static: 0.2,
            mu_dynamic: 0.05,
            radius: 1e-7,
            gyration_radius: 1e-9,
            distance: 0.05,
            spin_up: 50.0,
            duration: 5.0,
            ..TurntableScene::default()
        };
        let release = run(&quick).unwrap().outcome.release.unwrap();
        let expected = followed(&quick, release);
        for (time_step, samples) in [(5e-4, 400), (1e-2, 400), (0.5, 7)] {
            let scene = TurntableScene {
                time_step,
                samples,
                ..quick.clone()
            };
            let left = run(&scene).unwrap().outcome.left.unwrap();
            assert!(
                (left - expected).abs() < 1e-5,
                "{time_step}: {left} {expected}"
            );
        }
    }

    #[test]
    fn without_friction_a_body_keeps_its_straight_path_on_a_table_of_any_speed() {
        for spin_up in [1.0, 1e3, 1e5] {
            let scene = TurntableScene {
                mu_dynamic: 0.0,
                mu_static: 0.03 * spin_up,
                spin_up,
                time_step: 0.1,
                ..TurntableScene::default()
            };
            let TurntableOutcome { release, left, .. } = run(&scene).unwrap().outcome;
            // √(R² − r²) along the tangent, at Ω r.
            let (release, left) = (release.unwrap(), left.unwrap());
            let way = (0.5_f64 * 0.5 - 0.2 * 0.2).sqrt();
            let expected = release.time + way / (release.rate * scene.distance);
            assert!((left / expected - 1.0).abs() < 1e-12, "{left} {expected}");
        }
        // A table that starts with a jerk leaves the body where it is in the room.
        let jerked = TurntableScene {
            mu_dynamic: 0.0,
            mu_static: 0.01,
            spin_up: 40.0,
            time_step: 0.1,
            ..TurntableScene::default()
        };
        let result = run(&jerked).unwrap();
        assert_eq!(result.outcome.release.unwrap().rate, 0.0);
        for row in &result.rows {
            assert_eq!(row[8..], [0.2, 0.0]);
        }
    }

    #[test]
    fn a_wide_body_has_the_same_path_at_steps_of_any_length() {
        let left = |time_step: f64| {
            let scene = TurntableScene {
                time_step,
                samples: 1,
                patch: "box:0.06x0.02".parse().unwrap(),
                ..TurntableScene::default()
            };
            run(&scene).unwrap().outcome
        };
        let fine = left(1e-5);
        for time_step in [4e-3, 1.0] {
            let coarse = left(time_step);
            for (a, b) in coarse.place.into_iter().zip(fine.place) {
                assert!((a - b).abs() < 1e-6, "{coarse:?} {fine:?}");
            }
        }
    }
}
