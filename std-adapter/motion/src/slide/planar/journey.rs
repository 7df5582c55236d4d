//! The motion to rest in the plane, integrated over the logarithm of the speed.
//!
//! With V = (v_x, v_y, w) = s e, |e| = 1, and L = −ln(s/s₀) as the independent variable, dV/dt = −A
//! becomes, with the power P = e·A > 0,
//!
//! ```text
//! de/dL = e − A/P,   dt/dL = s/P,   d(x, y)/dL = s² (e_x, e_y)/P,   dangle/dL = s² e_w/(R P)
//! ```
//!
//! There is no heading angle and no trigonometry: loops are rotations of e. Rest is L → ∞, where time and
//! position converge, so that no step can skip it. Errors of the sliding and of the spinning part of e
//! are scaled by their own lengths: a slow slide under a fast spin keeps its digits, and path and
//! angle each have a relative accuracy. Below e⁻⁶⁰⁰ of its initial value the speed is held constant in A,
//! which is homogeneous there, and only the time depends further on L.

mod ends;

use super::Resistance;
use crate::slide::{Launch, MotionError, SlideStopReason};
use tribos_core::Real;
use tribos_core::internals::runge_kutta;

/// State at one time of a journey that starts at time 0 in the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarState {
    /// Time, in s.
    pub time: f64,
    /// Position of the centre, in m.
    pub position: [f64; 2],
    /// Velocity of the centre, in m/s.
    pub velocity: [f64; 2],
    /// Spin, in rad/s.
    pub spin: f64,
    /// Angle turned, in rad.
    pub angle: f64,
    /// Length of the path, in m.
    pub distance: f64,
    /// Velocity ratio v/(|ω|R); its limit at rest (to 1e-12/(1−α) for 0 ≤ α < 1).
    pub ratio: f64,
    /// Work of friction per mass, integrated from its power, in m²/s².
    pub work: f64,
    /// Magnitude |l| of the pressure gradient.
    pub lean: f64,
}

/// The end of a journey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarResult {
    /// State at the end.
    pub point: PlanarState,
    /// Why the journey ended: `Rest` or `Faded`.
    pub ending: SlideStopReason,
    /// Largest |l| during the journey.
    pub most_lean: f64,
    /// Time at which |l| first exceeded 1 and the body began to tip, in s, located within the step.
    pub tips_at: Option<f64>,
    /// Number of steps taken.
    pub steps: u64,
}

/// Integration variables: e (3), time, x, y, angle × R, path length, work, L.
type State = [f64; 10];

/// Local error tolerance of a step: with it the tabulated stops of tall cylinders are met to
/// 4e-14; ten times more gives 5e-13, a tenth costs half as many steps again and gains nothing.
const TOLERANCE: f64 = 1e-13;
/// First step.
const FIRST: f64 = 1e-3;
/// Largest step, which keeps the path smooth between accepted steps.
const LARGEST: f64 = 0.25;
/// e-folds of the speed within the range of f64, with a wide margin.
const MOST_FOLDS: f64 = 600.0;
/// Largest number of steps, more than 300 loops need.
const MOST_STEPS: u64 = 200_000;
/// Parts of e, and lengths relative to others, that count as zero: their relative errors are rounding.
const NOTHING: f64 = 1e-200;
/// The sliding or spinning part of e is accurate relative to this fraction of its initial length.
const FLOOR: f64 = 1e-6;
/// Newton iterations for a time within a step; three are sufficient, and after the last the step is halved instead.
const MOST_CORRECTIONS: u32 = 8;
/// Distance from a time that is its rounding, in ulps.
const ROUNDING_ULPS: f64 = 2.0;
/// Squared cosine of 15 degrees, which gives 24 points for each turn of the path.
const BEND: f64 = 0.933_012_701_892_219_3;
/// Points of a turn are recorded while the remaining path exceeds this fraction of the whole.
const VISIBLE: f64 = 1e-6;

/// The motion of a body in progress.
///
/// ```
/// use tribos::slide::planar::{PlanarResult, SlideStopReason, PlanarSimulation, Launch, PlanarState, TallCylinder};
/// let puck = TallCylinder::solid(0.3, 0.08).body(9.81)?; // flat; mu, R
/// let launch = Launch { velocity: [1.0, 0.0], spin: 0.0 };
/// let stop = 1.0 / (0.3 * 9.81); // v/(mu g)
/// let mut seen: Vec<PlanarState> = Vec::new();
/// let observe = |point: &PlanarState| seen.push(*point);
/// let end: PlanarResult = PlanarSimulation::new(&puck, &launch, 1e-4)?.follow(&[0.5 * stop], observe)?;
/// assert_eq!(end.ending, SlideStopReason::Rest);
/// assert!((end.point.time - stop).abs() < 1e-12);
/// // After half of the time half of the speed and a quarter of the way are left.
/// assert!((seen[1].velocity[0] - 0.5).abs() < 1e-12);
/// assert!((seen[1].distance - 0.75 * end.point.distance).abs() < 1e-12);
/// # Ok::<(), tribos::slide::MotionError>(())
/// ```
#[derive(Debug)]
pub struct PlanarSimulation<'a, B> {
    body: &'a B,
    scale: f64,
    /// Initial lengths of the sliding and the spinning part of e.
    lengths: [f64; 2],
    /// Lengths below which a part of e is accurate relative to them.
    floors: [f64; 2],
    state: State,
    /// Speeds that count as rest under laws that never reach it.
    stop_fraction: f64,
}

impl<'a, B: Resistance> PlanarSimulation<'a, B> {
    /// Starts a journey; `stop_fraction` matters only for laws that never reach rest.
    ///
    /// *Domain*: a finite launch with nonzero motion, otherwise [`MotionError::NotFinite`].
    ///
    /// *Accuracy*: time, path length and angle at the end each have this relative accuracy, whichever
    /// motion ends first: 2e-12 for upright bodies with α ≤ 0.9, inertia ratios from 1e-3 to 1e3 and
    /// minor speeds down to 1e-12 of the others; for 0.9 < α < 1 the time is accurate to 1e-12/(1−α). A
    /// motion that fades (α ≥ 1) ends when the slower of the two speeds to fade reaches
    /// `stop_fraction`, to 1e-11 in time.
    pub fn new(body: &'a B, launch: &Launch, stop_fraction: f64) -> Result<Self, MotionError> {
        let [x, y] = launch.velocity;
        let rim = launch.spin * body.radius();
        let slide = Real::hypot(x, y);
        let scale = Real::hypot(slide, rim);
        if scale == 0.0 || !scale.is_finite() {
            return Err(MotionError::NotFinite { step: 0 });
        }
        let lengths = [slide / scale, rim.abs() / scale];
        // Motions that cause each other are accurate relative to both.
        let floors = if body.is_round() {
            lengths.map(|length| length * FLOOR)
        } else {
            [1.0; 2]
        };
        let mut state = [0.0; 10];
        [state[0], state[1], state[2]] = [x / scale, y / scale, rim / scale];
        Ok(Self {
            body,
            scale,
            lengths,
            floors,
            state,
            stop_fraction,
        })
    }

    /// Follows the motion to its end.
    pub fn to_end(self) -> Result<PlanarResult, MotionError> {
        self.follow(&[], |_| ())
    }

    /// Like [`PlanarSimulation::to_end`]; `observe` receives the launch, the given times, which must ascend,
    /// intermediate points wherever the path has turned by 15 degrees, and the end.
    pub fn follow(
        self,
        times: &[f64],
        observe: impl FnMut(&PlanarState),
    ) -> Result<PlanarResult, MotionError> {
        self.watched(times, observe, &mut |_| true)
    }

    /// The same; `watch` sees the share of the e-folds that is done, roughly that of the steps, and ends the
    /// motion by answering false.
    pub(in crate::slide) fn watched(
        mut self,
        times: &[f64],
        mut observe: impl FnMut(&PlanarState),
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> Result<PlanarResult, MotionError> {
        let mut times = times.iter().copied().peekable();
        let mut shown = self.state;
        let start = self.point(&shown);
        let mut uprightness = TippingMonitor::default();
        uprightness.see(&start);
        observe(&start);
        let mut size = FIRST;
        let mut steps = 0;
        while !self.is_over() {
            let from = self.state;
            if !watch((from[9] / ends::FOLDS).min(1.0)) {
                return Err(MotionError::Interrupted { steps });
            }
            let taken = self.step(&mut size, &mut steps)?;
            let taken = self.truncate_at_decay(&from, taken);
            while let Some(time) = times.next_if(|&time| time < self.state[3]) {
                if time > from[3] {
                    let at = self.at_time(&from, taken, time);
                    observe(&self.point(&at));
                }
            }
            let mut here = self.point(&self.state);
            if here.lean > 1.0 && uprightness.tips_at.is_none() {
                let limit = self.first(&from, taken, |at| self.point(at).lean > 1.0);
                uprightness.see(&self.point(&limit.1));
            }
            uprightness.see(&here);
            if self.zero_decayed_part() {
                here = self.point(&self.state);
            }
            if self.has_turned(&shown) {
                observe(&here);
                shown = self.state;
            }
        }
        let arrival = self.arrival(uprightness, steps);
        observe(&arrival.point);
        Ok(arrival)
    }

    /// Takes one accepted step and returns its length.
    fn step(&mut self, size: &mut f64, steps: &mut u64) -> Result<f64, MotionError> {
        loop {
            *steps += 1;
            let largest = self.largest_step();
            let taken = if *size > largest { largest } else { *size };
            let (next, error) = runge_kutta::step(&self.state, taken, |y| self.derivative(y));
            let error = self.error_norm(&next, &error);
            let (accepted, factor) = runge_kutta::judge(error, self.tolerance(), true);
            *size = taken * factor;
            let fits = self.state[9] <= MOST_FOLDS || self.body.exponent() < 1.0;
            let advances = fits && self.state[9] + *size > self.state[9];
            if !advances {
                return Err(MotionError::NotFinite { step: *steps });
            }
            if *steps >= MOST_STEPS {
                let (steps, folds) = (*steps, self.state[9]);
                return Err(MotionError::TooStiff { steps, folds });
            }
            if accepted {
                self.state = normalized(next);
                return Ok(taken);
            }
        }
    }

    fn tolerance(&self) -> f64 {
        let accuracy = self.body.accuracy();
        if accuracy > TOLERANCE {
            accuracy
        } else {
            TOLERANCE
        }
    }

    fn derivative(&self, state: &State) -> State {
        let [x, y, w, ..] = self.direction(state);
        let speed = self.speed(state);
        let angle = state[6] / self.body.radius();
        let velocity = [speed * x, speed * y, speed * w];
        let [ax, ay, aw] = self.body.deceleration_at(velocity, angle);
        let power = x * ax + y * ay + w * aw;
        // A motion to which friction adds energy has no end.
        let power = if power > 0.0 { power } else { f64::NAN };
        let (pace, reach) = (speed / power, speed * speed / power);
        let pace = pace * self.held_pace(state);
        let work = x * ax + y * ay + self.body.inertia_ratio() * w * aw;
        [
            x - ax / power,
            y - ay / power,
            w - aw / power,
            pace,
            reach * x,
            reach * y,
            reach * w,
            reach * Real::hypot(x, y),
            reach * work,
            1.0,
        ]
    }

    /// s = s₀ e^(−L), held constant where it would leave the range of numbers.
    fn speed(&self, state: &State) -> f64 {
        let folds = state[9];
        let folds = if folds > MOST_FOLDS {
            MOST_FOLDS
        } else {
            folds
        };
        self.scale * Real::exp(-folds)
    }

    /// The largest error: each part relative to itself, the position relative to the path.
    fn error_norm(&self, at: &State, error: &State) -> f64 {
        let least = |length: f64, floor: f64| {
            let length = if length < floor { floor } else { length };
            length + NOTHING
        };
        let over = |error: f64, of: f64| error.abs() / (of.abs() + NOTHING);
        let slide = least(Real::hypot(at[0], at[1]), self.floors[0]);
        let terms = [
            Real::hypot(error[0], error[1]) / slide,
            error[2].abs() / least(at[2].abs(), self.floors[1]),
            over(error[3], at[3]),
            over(error[4], at[7]),
            over(error[5], at[7]),
            over(
                error[6],
                if self.body.is_round() {
                    at[6]
                } else {
                    at[6].abs() + at[7]
                },
            ),
            over(error[8], at[8]),
        ];
        terms
            .into_iter()
            .fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
    }

    /// The state at a time within the step of length `taken` from `from`, to the rounding of the step's end.
    fn at_time(&self, from: &State, taken: f64, time: f64) -> State {
        let mut part = taken * (time - from[3]) / (self.state[3] - from[3]);
        for _ in 0..MOST_CORRECTIONS {
            let at = runge_kutta::step(from, part, |y| self.derivative(y)).0;
            let off = time - at[3];
            if off.abs() <= ROUNDING_ULPS * f64::EPSILON * time {
                return normalized(at);
            }
            part += off / self.derivative(&at)[3];
        }
        self.first(from, taken, |at| at[3] >= time).1
    }

    /// True if the path has turned by 15 degrees since `shown` and the remaining path is visible.
    fn has_turned(&self, shown: &State) -> bool {
        let [x, y, ..] = self.state;
        let along = x * shown[0] + y * shown[1];
        let lengths = (x * x + y * y) * (shown[0] * shown[0] + shown[1] * shown[1]);
        let turned = along < 0.0 || along * along < BEND * lengths;
        turned && self.derivative(&self.state)[7] > VISIBLE * self.state[7]
    }

    fn point(&self, state: &State) -> PlanarState {
        let speed = self.speed(state);
        let velocity = [speed * state[0], speed * state[1]];
        let radius = self.body.radius();
        PlanarState {
            time: state[3],
            position: [state[4], state[5]],
            velocity,
            spin: speed * state[2] / radius,
            angle: state[6] / radius,
            distance: state[7],
            ratio: Real::hypot(state[0], state[1]) / state[2].abs(),
            work: state[8],
            lean: self.body.lean([velocity[0], velocity[1], speed * state[2]]),
        }
    }

    /// The end: the remaining time follows as a power of the speed, everything else is negligible.
    fn arrival(&self, uprightness: TippingMonitor, steps: u64) -> PlanarResult {
        let mut point = self.point(&self.state);
        let beta = 1.0 - self.body.exponent();
        let ending = if beta > 0.0 {
            point.time += self.derivative(&self.state)[3] / beta;
            point.velocity = [0.0, 0.0];
            point.spin = 0.0;
            SlideStopReason::Rest
        } else {
            SlideStopReason::Faded
        };
        PlanarResult {
            point,
            ending,
            most_lean: uprightness.most_lean,
            tips_at: uprightness.tips_at,
            steps,
        }
    }
}

/// Largest lean so far, and the time at which the body began to tip.
#[derive(Clone, Copy, Debug, Default)]
struct TippingMonitor {
    most_lean: f64,
    tips_at: Option<f64>,
}

impl TippingMonitor {
    fn see(&mut self, point: &PlanarState) {
        if point.lean > self.most_lean {
            self.most_lean = point.lean;
        }
        if point.lean > 1.0 && self.tips_at.is_none() {
            self.tips_at = Some(point.time);
        }
    }
}

/// The direction, normalised to the unit sphere.
fn normalized(mut state: State) -> State {
    let length = Real::hypot(Real::hypot(state[0], state[1]), state[2]);
    for part in state.iter_mut().take(3) {
        *part /= length;
    }
    state
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::slide::planar::TallCylinder;

    #[test]
    fn times_within_a_step_are_met_to_rounding_by_corrections_and_by_halvings() {
        let puck = TallCylinder {
            height: 0.1,
            ..TallCylinder::solid(0.3, 0.08)
        };
        let body = puck.body(9.81).unwrap();
        let launch = Launch {
            velocity: [1.0, 0.0],
            spin: 20.0,
        };
        let mut journey = PlanarSimulation::new(&body, &launch, 1e-4).unwrap();
        let (mut size, mut steps) = (FIRST, 0);
        for _ in 0..40 {
            let from = journey.state;
            let taken = journey.step(&mut size, &mut steps).unwrap();
            for share in [0.01, 0.3, 0.5, 0.99] {
                let time = from[3] + share * (journey.state[3] - from[3]);
                let at = journey.at_time(&from, taken, time);
                let halved = journey.first(&from, taken, |at| at[3] >= time).1;
                for found in [&at, &halved] {
                    let off = (found[3] - time).abs();
                    assert!(
                        off <= 4.0 * f64::EPSILON * journey.state[3],
                        "{share}: {found:?}"
                    );
                }
                for (part, other) in at.iter().zip(&halved) {
                    assert!((part - other).abs() <= 1e-14, "{share}: {at:?} {halved:?}");
                }
            }
        }
    }
}
