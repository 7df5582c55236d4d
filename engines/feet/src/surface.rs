//! The exact limit surface of one foot, prepared once and scaled by the friction limit of each step.

use crate::pressed::Prepared;
use core::fmt;
use tribos_core::contact::TimeStep;
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::twist::{Twist, Wrench};
use tribos_friction::{Area, FrictionError};

/// All wrenches that a foot carries under a friction limit of 1 N, in the foot's axes.
pub(crate) struct Surface {
    set: Prepared,
    /// The foot's axes do not matter.
    is_round: bool,
}

impl Surface {
    pub(crate) fn of(area: &Area<f32>) -> Result<Self, FrictionError> {
        Ok(Self {
            set: Prepared::new(area.limit_surface(1.0)?),
            is_round: area.is_round(),
        })
    }

    /// The kernel's step of a body on this foot alone, whose x axis has the direction `axis`.
    pub(crate) fn step(
        &self,
        limit: f32,
        axis: [f64; 2],
        body: &PlanarBody<f32>,
        twist: &Twist<f32>,
        push: &Wrench<f32>,
        dt: TimeStep<f32>,
    ) -> Option<PlanarStep<f32>> {
        if self.is_round {
            return step(&self.set, limit, body, twist, push, dt);
        }
        turned_step(&self.set, limit, axis, body, twist, push, dt)
    }

    /// `friction` as a fraction of the largest that this foot alone can carry.
    pub(crate) fn share(&self, limit: f32, axis: [f64; 2], friction: &Wrench<f32>) -> f32 {
        let gauge = if self.is_round {
            self.set.set.gauge(friction)
        } else {
            self.set.set.gauge(&to_foot_wrench(axis, friction))
        };
        let share = gauge / limit;
        // No friction under no load: no fraction.
        if share > 0.0 { share.min(1.0) } else { 0.0 }
    }
}

impl fmt::Debug for Surface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Surface").finish_non_exhaustive()
    }
}

fn step(
    set: &Prepared,
    limit: f32,
    body: &PlanarBody<f32>,
    twist: &Twist<f32>,
    push: &Wrench<f32>,
    dt: TimeStep<f32>,
) -> Option<PlanarStep<f32>> {
    Some(body.step(&set.under(limit)?, twist, push, dt))
}

/// The step in the axes of the foot.
fn turned_step(
    set: &Prepared,
    limit: f32,
    axis: [f64; 2],
    body: &PlanarBody<f32>,
    twist: &Twist<f32>,
    push: &Wrench<f32>,
    dt: TimeStep<f32>,
) -> Option<PlanarStep<f32>> {
    let [x, y] = to_foot(axis, [twist.velocity.x, twist.velocity.y]);
    let in_foot = Twist::new(x, y, twist.spin);
    let end = step(set, limit, body, &in_foot, &to_foot_wrench(axis, push), dt)?;
    if end.is_at_rest {
        // All of the push is held: without the rounding of the rotation.
        let friction = body.stopping_wrench(twist, push, dt.dt());
        return Some(PlanarStep { friction, ..end });
    }
    let back = [axis[0], -axis[1]];
    let [x, y] = to_foot(back, [end.twist.velocity.x, end.twist.velocity.y]);
    Some(PlanarStep {
        twist: Twist::new(x, y, end.twist.spin),
        friction: to_foot_wrench(back, &end.friction),
        ..end
    })
}

/// Components in the foot's axes.
fn to_foot([c, s]: [f64; 2], [x, y]: [f32; 2]) -> [f32; 2] {
    let [x, y] = [x, y].map(f64::from);
    [(c * x + s * y) as f32, (c * y - s * x) as f32]
}

fn to_foot_wrench(axis: [f64; 2], wrench: &Wrench<f32>) -> Wrench<f32> {
    let [x, y] = to_foot(axis, [wrench.force.x, wrench.force.y]);
    Wrench::new(x, y, wrench.torque)
}
