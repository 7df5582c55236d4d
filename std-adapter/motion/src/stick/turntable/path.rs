//! The path of a body that slides on a turntable, in the room.

use super::{Table, difference, rotated};
use crate::stick::MotionError;
use nalgebra::Vector2;
use tribos_core::Real;
use tribos_core::contact::TimeStep;
use tribos_core::twist::{Twist, Wrench};

/// The body in the room.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub time: f64,
    pub place: Vector2<f64>,
    pub angle: f64,
    pub twist: Twist<f64>,
}

/// A body that has let go, and the length of its next step.
#[derive(Clone, Debug)]
pub(super) struct SlideState {
    pub state: State,
    pub next: f64,
    pub steps: u64,
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

/// Steps between two looks at the watch.
const BETWEEN: u64 = 1024;

impl SlideState {
    /// Slides on to a time, to the rim of the table at most; returns when it reached that.
    pub fn until(
        &mut self,
        table: &Table<'_>,
        until: f64,
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Option<f64>, MotionError> {
        while self.state.time < until {
            let before = self.state;
            let time = before.time;
            if self.steps.is_multiple_of(BETWEEN) && !watch(time / table.scene.duration) {
                return Err(MotionError::InterruptedAt { time });
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
    fn step(&mut self, table: &Table<'_>, until: f64) -> Result<f64, MotionError> {
        let time = self.state.time;
        if self.steps >= MOST_STEPS {
            let steps = self.steps;
            return Err(MotionError::TooManyStepsAt { steps, time });
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
        Err(MotionError::NotFiniteAt { time })
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

impl Table<'_> {
    /// Two steps of half the length.
    fn halves(&self, state: &State, step: f64) -> Result<State, MotionError> {
        let middle = self.step(state, 0.5 * step)?;
        self.step(&middle, 0.5 * step)
    }

    /// One step: where it leads and how the body is turned at half time is found from two first passes.
    fn step(&self, state: &State, step: f64) -> Result<State, MotionError> {
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
}

fn turned(twist: &Twist<f64>, angle: f64) -> Twist<f64> {
    let v = rotated(twist.velocity, angle);
    Twist::new(v.x, v.y, twist.spin)
}

fn turned_wrench(wrench: &Wrench<f64>, angle: f64) -> Wrench<f64> {
    let f = rotated(wrench.force, angle);
    Wrench::new(f.x, f.y, wrench.torque)
}
