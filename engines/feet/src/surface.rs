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

    /// The kernel's step of a body on this foot alone, whose x axis has the direction `axis`, by its limit and the strength of
    /// friction at rest.
    pub(crate) fn step(
        &self,
        limits: [f32; 2],
        axis: [f64; 2],
        body: &PlanarBody<f32>,
        motion: Motion<'_>,
    ) -> Option<PlanarStep<f32>> {
        if self.is_round {
            return step(&self.set, limits, body, motion);
        }
        turned_step(&self.set, limits, axis, body, motion)
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

/// A body's motion, what pushes it, and for how long.
#[derive(Clone, Copy)]
pub(crate) struct Motion<'a> {
    pub(crate) before: &'a Twist<f32>,
    pub(crate) push: &'a Wrench<f32>,
    pub(crate) dt: TimeStep<f32>,
}

fn step(
    set: &Prepared,
    [limit, strength]: [f32; 2],
    body: &PlanarBody<f32>,
    Motion { before, push, dt }: Motion<'_>,
) -> Option<PlanarStep<f32>> {
    Some(body.step_sticking(&set.under(limit)?, strength, before, push, dt))
}

/// The step in the axes of the foot.
fn turned_step(
    set: &Prepared,
    limits: [f32; 2],
    axis: [f64; 2],
    body: &PlanarBody<f32>,
    Motion { before, push, dt }: Motion<'_>,
) -> Option<PlanarStep<f32>> {
    let [x, y] = to_foot(axis, [before.velocity.x, before.velocity.y]);
    let motion = Motion {
        before: &Twist::new(x, y, before.spin),
        push: &to_foot_wrench(axis, push),
        dt,
    };
    let end = step(set, limits, body, motion)?;
    if end.is_at_rest {
        // All of the push is held: without the rounding of the rotation.
        let friction = body.stopping_wrench(before, push, dt.dt());
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
