//! Time steps of a body that is pushed and turned on its patch.

use crate::exchange::Refused;
use crate::friction::{row_of, row_of_twist, twist_of, wrench_of};
use crate::surface::Surface;
use tribos_core::contact::TimeStep;
use tribos_core::limit_surface::FrictionSet;
use tribos_core::planar::PlanarBody;
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// Twist and friction after a step, and whether friction holds the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepResult {
    /// In m/s and rad/s.
    pub twist: [f64; 3],
    /// In N and N m.
    pub friction: [f64; 3],
    /// Whether the motion is zero to the last bit.
    pub is_at_rest: bool,
}

impl StepResult {
    /// As numbers; 1 at rest.
    pub fn row(&self) -> [f64; 7] {
        let [vx, vy, spin] = self.twist;
        let [fx, fy, torque] = self.friction;
        let rests = if self.is_at_rest { 1.0 } else { 0.0 };
        [vx, vy, spin, fx, fy, torque, rests]
    }
}

/// A body with its time step.
#[derive(Clone, Copy, Debug)]
pub struct Stepper {
    body: PlanarBody<f64>,
    dt: TimeStep<f64>,
    strength: f64,
}

impl Stepper {
    /// Mass in kg, moment of inertia in kg m² and step in s, each positive and finite.
    pub fn new(mass: f64, inertia: f64, dt: f64) -> Result<Self, Refused> {
        Ok(Self {
            body: PlanarBody::new(mass, inertia)?,
            dt: TimeStep::new(dt)?,
            strength: 1.0,
        })
    }

    /// The same with static friction that is `strength` times kinetic friction. The small module has no code for it.
    pub fn sticking(self, strength: f64) -> Self {
        Self { strength, ..self }
    }

    /// A step of a body whose patch is turned by `angle`, in rad.
    pub fn step(
        &self,
        set: &dyn FrictionSet<f64>,
        angle: f64,
        twist: [f64; 3],
        push: [f64; 3],
    ) -> StepResult {
        // The small module has round patches alone, to which it does not matter.
        if angle == 0.0 || cfg!(not(feature = "all")) {
            return self.step_along_axes(set, twist, push);
        }
        let (sin, cos) = (Real::sin(angle), Real::cos(angle));
        let into = |[x, y, turn]: [f64; 3]| [cos * x + sin * y, cos * y - sin * x, turn];
        let back = |[x, y, turn]: [f64; 3]| [cos * x - sin * y, cos * y + sin * x, turn];
        let step = self.step_along_axes(set, into(twist), into(push));
        let twist = if step.is_at_rest {
            [0.0; 3]
        } else {
            back(step.twist)
        };
        StepResult {
            twist,
            friction: back(step.friction),
            ..step
        }
    }

    fn step_along_axes(
        &self,
        set: &dyn FrictionSet<f64>,
        twist: [f64; 3],
        push: [f64; 3],
    ) -> StepResult {
        let (body, dt, strength) = (&self.body, self.dt, self.strength);
        let (twist, push) = (twist_of(twist), wrench_of(push));
        let step = if cfg!(feature = "all") && strength > 1.0 {
            body.step_sticking(set, strength, &twist, &push, dt)
        } else {
            body.step(set, &twist, &push, dt)
        };
        StepResult {
            twist: row_of_twist(&step.twist),
            friction: row_of(&step.friction),
            is_at_rest: step.is_at_rest,
        }
    }
}

/// A course of many steps: what it starts from, and what it repeats.
#[derive(Clone, Copy, Debug)]
pub struct Trajectory {
    /// Motion at the start.
    pub twist: [f64; 3],
    /// Place and angle at the start.
    pub pose: [f64; 3],
    /// Force and torque of all but friction.
    pub push: [f64; 3],
    /// Whether the patch turns with the body in a way that matters.
    pub turns: bool,
}

impl Trajectory {
    /// Fills rows of time, pose and twist: the start, and one for each step. Position and angle are integrated by
    /// the trapezoidal rule, which is exact under the mean friction of a step; a patch that turns is taken at its
    /// angle at half time. Without a push the rows end with the first at rest. Returns their number.
    pub fn follow(
        &self,
        set: &dyn FrictionSet<f64>,
        stepper: &Stepper,
        rows: &mut [[f64; 7]],
    ) -> usize {
        let (mut twist, mut pose) = (self.twist, self.pose);
        let half = 0.5 * stepper.dt.dt();
        let is_free = self.push == [0.0; 3];
        let mut is_at_rest = twist == [0.0; 3];
        let mut count = 0;
        for row in rows {
            if count > 0 {
                if is_free && is_at_rest {
                    break;
                }
                let angle = if self.turns {
                    pose[2] + half * twist[2]
                } else {
                    0.0
                };
                let done = stepper.step(set, angle, twist, self.push);
                for ((place, before), after) in pose.iter_mut().zip(twist).zip(done.twist) {
                    *place += half * (before + after);
                }
                (twist, is_at_rest) = (done.twist, done.is_at_rest);
            }
            let ([x, y, angle], [vx, vy, spin]) = (pose, twist);
            *row = [count as f64 * stepper.dt.dt(), x, y, angle, vx, vy, spin];
            count += 1;
        }
        count
    }
}

/// Rows of the course of a free body to rest in about `count` steps. Returns their number.
pub fn to_rest(
    surface: &Surface,
    [mass, inertia]: [f64; 2],
    twist: [f64; 3],
    count: usize,
    rows: &mut [[f64; 7]],
) -> Result<usize, Refused> {
    surface.with(|set| {
        // Both motions fade at once, so that the sum of their times alone is more than is needed.
        let [vx, vy, spin] = twist;
        let torque = set.support(&Twist::new(0.0, 0.0, 1.0));
        let time = mass * Real::hypot(vx, vy) / set.force_limit() + inertia * spin.abs() / torque;
        if time.is_nan() || time.is_infinite() {
            return Err(Refused::Because(
                "the body does not come to rest: friction is 0, or the motion is not finite",
            ));
        }
        // At rest any step keeps it there.
        let dt = if time > 0.0 { time / count as f64 } else { 1.0 };
        let course = Trajectory {
            twist,
            pose: [0.0; 3],
            push: [0.0; 3],
            turns: surface.patch.turns(),
        };
        Ok(course.follow(set, &Stepper::new(mass, inertia, dt)?, rows))
    })?
}
