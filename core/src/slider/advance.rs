//! The exact stepper: step sizes that shrink with the motion, and a closed form for its end.
//!
//! Friction of degree α makes the equations invariant under a common scale s of all speeds with
//! times measured in s^(1−α)/κ. Each substep therefore starts at (v, w)/s, a unit vector, and
//! covers a similar fraction of what is left: the approach to rest is a smooth geometric sequence
//! that never steps over zero. Once the direction has settled, the rest of the motion is a
//! straight line in (v, w) and closes analytically: with the loss rate k along it,
//! remaining time s^(1−α)/(κ k (1−α)), remaining distance v s^(1−α)/(κ k (2−α)).

use super::{Motion, Slider};
use crate::coupling::{Coupling, Profile, ReducedWrench};
use crate::real::Real;

/// What [`Slider::advance`] returns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Advance<R> {
    /// The motion at the end of the step.
    pub motion: Motion<R>,
    /// Set in the step in which the body comes to rest.
    pub rest: Option<Rest<R>>,
    /// Substeps taken.
    pub substeps: u32,
}

/// The end of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest<R> {
    /// Time, distance and angle at rest; speeds zero.
    pub motion: Motion<R>,
    /// Velocity ratio ε in the limit of rest.
    pub ratio: R,
    /// Substeps taken.
    pub substeps: u32,
}

/// Scaled velocities with their integrals over scaled time: V, W, ∫V, ∫W.
type Scaled<R> = [R; 4];

/// Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19: order 5 with an error estimate of
/// order 4; the last stage is the first of the next step.
const STAGES: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
        0.0,
        0.0,
    ],
    [
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
        0.0,
    ],
    [
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
/// Difference of the two orders' weights.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// First substep, in units of s^(1−α)/κ.
const FIRST: f64 = 1.0 / 16.0;
/// Largest substep as a fraction of the time to rest along the present direction.
const LARGEST_FRACTION: f64 = 0.5;
/// Step control: safety factor and bounds of change.
const SAFETY: f64 = 0.9;
const SHRINK: f64 = 0.2;
const GROW: f64 = 4.0;
/// Local error tolerance in units of the rounding error.
const TOLERANCE_ULPS: f64 = 4.0;
/// A direction that turns by less than this many rounding errors per e-fold has settled.
const SETTLED_ULPS: f64 = 16.0;
/// A scale this many orders of two below the start is rest for every purpose.
const DEEP_F64: f64 = 1e-120;
const DEEP_F32: f64 = 1e-18;
/// More substeps than any motion needs (a full stop takes a few thousand in f64).
const MAX_SUBSTEPS: u32 = 1_000_000;

impl<R: Real, P: Profile<R> + Coupling<R>> Slider<R, P> {
    /// Advances by `duration`, to rounding accuracy, through rest if it comes.
    ///
    /// *Domain*: `duration` ≥ 0, finite unless α < 1; a body at rest stays there.
    /// *Accuracy*: about 1e-13 relative in time and distance to rest (f64).
    /// *Cost*: one substep (7 wrenches) if `duration` is short against the time to rest.
    pub fn advance(&self, motion: &Motion<R>, duration: R) -> Advance<R> {
        let mut run = Run::new(self, motion);
        let end = run.go(duration);
        let rest = if end { Some(run.rest()) } else { None };
        let mut after = run.motion(motion);
        after.time = motion.time + duration;
        Advance {
            motion: after,
            rest,
            substeps: run.substeps,
        }
    }

    /// Follows the motion to rest. `None` for α ≥ 1, which never rests in finite time.
    pub fn to_rest(&self, motion: &Motion<R>) -> Option<Rest<R>> {
        if self.profile.exponent() >= R::ONE {
            return None;
        }
        let mut run = Run::new(self, motion);
        run.go(R::INFINITY).then(|| run.rest())
    }
}

/// One call's progress.
struct Run<'a, R, P> {
    slider: &'a Slider<R, P>,
    start: Motion<R>,
    alpha: R,
    /// Sliding and rim speed.
    velocity: [R; 2],
    /// Elapsed time, distance and rim path of this call.
    elapsed: R,
    path: [R; 2],
    /// Direction at the latest moving instant.
    ratio: R,
    substeps: u32,
}

impl<'a, R: Real, P: Profile<R> + Coupling<R>> Run<'a, R, P> {
    fn new(slider: &'a Slider<R, P>, motion: &Motion<R>) -> Self {
        let velocity = [motion.speed, (motion.spin * slider.radius).abs()];
        Self {
            slider,
            start: *motion,
            alpha: slider.profile.exponent(),
            velocity,
            elapsed: R::ZERO,
            path: [R::ZERO; 2],
            ratio: velocity[0] / velocity[1],
            substeps: 0,
        }
    }

    /// Goes on for `duration`; true if the body came to rest on the way.
    fn go(&mut self, duration: R) -> bool {
        let first_scale = self.velocity[0].hypot(self.velocity[1]);
        let deep = first_scale
            * R::from_f64(if R::EPSILON.to_f64() > 1e-10 {
                DEEP_F32
            } else {
                DEEP_F64
            });
        let mut size = R::from_f64(FIRST);
        while self.substeps < MAX_SUBSTEPS {
            let scale = self.velocity[0].hypot(self.velocity[1]);
            let left = duration - self.elapsed;
            // False for NaN too.
            let moving = left > R::ZERO && scale > R::ZERO;
            if !moving {
                return false;
            }
            let unit = [self.velocity[0] / scale, self.velocity[1] / scale];
            let time_unit = scale.pow(R::ONE - self.alpha) / self.slider.deceleration;
            let rates = self.rates(&unit);
            let loss = -(rates[0] * unit[0] + rates[1] * unit[1]);
            let turning = (rates[0] * unit[1] - rates[1] * unit[0]).abs();
            self.ratio = unit[0] / unit[1];
            if self.alpha < R::ONE {
                let settled = turning <= R::from_f64(SETTLED_ULPS) * R::EPSILON * loss;
                let tail = time_unit / (loss * (R::ONE - self.alpha));
                if (settled || scale <= deep) && tail <= left {
                    self.close(time_unit, loss, tail);
                    return true;
                }
            }
            let limit = R::from_f64(LARGEST_FRACTION) / loss;
            size = if size > limit { limit } else { size };
            size = self.substep(scale, unit, time_unit, size, left / time_unit);
        }
        false
    }

    /// Derivatives of the scaled velocities.
    fn rates(&self, v: &[R; 2]) -> [R; 2] {
        let ReducedWrench { force, torque } = self.slider.profile.reduced_wrench(v[0], v[1]);
        [-force, -torque / self.slider.inertia_ratio]
    }

    /// The closed form along the present direction.
    fn close(&mut self, time_unit: R, loss: R, tail: R) {
        let reach = time_unit / (loss * (R::TWO - self.alpha));
        self.path[0] += self.velocity[0] * reach;
        self.path[1] += self.velocity[1] * reach;
        self.elapsed += tail;
        self.velocity = [R::ZERO; 2];
    }

    /// Tries a substep of `size`, at most `left`; returns the size to try next.
    fn substep(&mut self, scale: R, unit: [R; 2], time_unit: R, size: R, left: R) -> R {
        self.substeps += 1;
        let h = if size < left { size } else { left };
        let from = [unit[0], unit[1], R::ZERO, R::ZERO];
        let (to, error) = self.dormand_prince(&from, h);
        let tolerance = R::from_f64(TOLERANCE_ULPS) * R::EPSILON;
        let accepted = error <= tolerance && to[0] >= R::ZERO && to[1] >= R::ZERO;
        if accepted {
            self.velocity = [scale * to[0], scale * to[1]];
            self.path[0] += scale * time_unit * to[2];
            self.path[1] += scale * time_unit * to[3];
            self.elapsed = if h == left {
                self.elapsed + left * time_unit
            } else {
                self.elapsed + h * time_unit
            };
        }
        let factor = if error > R::ZERO {
            R::from_f64(SAFETY) * (tolerance / error).pow(R::from_f64(0.2))
        } else {
            R::from_f64(GROW)
        };
        let (shrink, grow) = (R::from_f64(SHRINK), R::from_f64(GROW));
        let factor = if factor < shrink || !accepted && factor >= R::ONE {
            shrink
        } else {
            factor
        };
        let next = h * if factor > grow { grow } else { factor };
        // A step cut short by the end of the call says nothing against a larger one.
        if accepted && next < size {
            if h < size { size } else { next }
        } else {
            next
        }
    }

    /// One step of the pair; returns the end point and the largest error of V and W.
    fn dormand_prince(&self, from: &Scaled<R>, h: R) -> (Scaled<R>, R) {
        let derivative = |y: &Scaled<R>| {
            let [a, b] = self.rates(&[y[0], y[1]]);
            [a, b, y[0], y[1]]
        };
        let mut slopes = [[R::ZERO; 4]; 7];
        slopes[0] = derivative(from);
        let mut point = *from;
        for (stage, row) in STAGES.iter().enumerate() {
            point = *from;
            for (slope, &weight) in slopes.iter().zip(row).take(stage + 1) {
                add_scaled(&mut point, slope, h * R::from_f64(weight));
            }
            slopes[stage + 1] = derivative(&point);
        }
        let mut error = [R::ZERO; 4];
        for (slope, &weight) in slopes.iter().zip(&ERROR) {
            add_scaled(&mut error, slope, h * R::from_f64(weight));
        }
        let (a, b) = (error[0].abs(), error[1].abs());
        (point, if a > b { a } else { b })
    }

    /// The motion after this call, without its time.
    fn motion(&self, before: &Motion<R>) -> Motion<R> {
        let radius = self.slider.radius;
        Motion {
            time: before.time + self.elapsed,
            speed: self.velocity[0],
            spin: (self.velocity[1] / radius).copysign(before.spin),
            distance: before.distance + self.path[0],
            angle: before.angle + (self.path[1] / radius).copysign(before.spin),
        }
    }

    fn rest(&self) -> Rest<R> {
        let mut motion = self.motion(&self.start);
        motion.spin = R::ZERO;
        Rest {
            motion,
            ratio: self.ratio,
            substeps: self.substeps,
        }
    }
}

fn add_scaled<R: Real>(sum: &mut Scaled<R>, term: &Scaled<R>, factor: R) {
    for (s, t) in sum.iter_mut().zip(term) {
        *s += factor * *t;
    }
}
