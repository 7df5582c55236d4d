//! The exact limit surface of one foot, prepared once and scaled by the friction limit of each step.

use tribos_core::contact::TimeStep;
use tribos_core::coupling::closed::Ring;
use tribos_core::coupling::table::Coulomb;
use tribos_core::limit_surface::{FrictionSet, LimitSurface, PatchSurface, Scaled};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::twist::{Twist, Wrench};

/// All wrenches that a foot carries under a friction limit of 1 N, in the foot's axes.
#[derive(Debug)]
pub(crate) enum Surface {
    Disk(LimitSurface<f32, Coulomb>),
    Ring(LimitSurface<f32, Ring>),
    Polygon(PatchSurface<f32, Polygon<f32, Vec<Edge<f32>>>>),
    Bar(PatchSurface<f32, Bar<f32>>),
}

impl Surface {
    pub(crate) fn disk(radius: f32) -> Option<Self> {
        LimitSurface::new(Coulomb, 1.0, radius).ok().map(Self::Disk)
    }

    pub(crate) fn ring(radius: f32) -> Option<Self> {
        LimitSurface::new(Ring, 1.0, radius).ok().map(Self::Ring)
    }

    /// `None` if edges touch.
    pub(crate) fn polygon(corners: Vec<[f32; 2]>) -> Option<Self> {
        let memory = vec![Edge::default(); corners.len()];
        let outline = Polygon::with_holes(&[&corners], memory).ok()?;
        PatchSurface::new(outline, 1.0).ok().map(Self::Polygon)
    }

    pub(crate) fn bar(from: [f32; 2], to: [f32; 2]) -> Option<Self> {
        let bar = Bar::new(from, to).ok()?;
        PatchSurface::new(bar, 1.0).ok().map(Self::Bar)
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
        match self {
            Self::Disk(set) => step(set, limit, body, twist, push, dt),
            Self::Ring(set) => step(set, limit, body, twist, push, dt),
            Self::Polygon(set) => turned_step(set, limit, axis, body, twist, push, dt),
            Self::Bar(set) => turned_step(set, limit, axis, body, twist, push, dt),
        }
    }

    /// `friction` as a fraction of the largest that this foot alone can carry.
    pub(crate) fn share(&self, limit: f32, axis: [f64; 2], friction: &Wrench<f32>) -> f32 {
        let gauge = match self {
            Self::Disk(set) => set.gauge(friction),
            Self::Ring(set) => set.gauge(friction),
            Self::Polygon(set) => set.gauge(&to_foot_wrench(axis, friction)),
            Self::Bar(set) => set.gauge(&to_foot_wrench(axis, friction)),
        };
        let share = gauge / limit;
        // No friction under no load: no fraction.
        if share > 0.0 { share.min(1.0) } else { 0.0 }
    }
}

fn step<S: FrictionSet<f32>>(
    set: &S,
    limit: f32,
    body: &PlanarBody<f32>,
    twist: &Twist<f32>,
    push: &Wrench<f32>,
    dt: TimeStep<f32>,
) -> Option<PlanarStep<f32>> {
    let set = Scaled::new(set, limit).ok()?;
    Some(body.step(&set, twist, push, dt))
}

/// The step in the axes of the foot.
fn turned_step<S: FrictionSet<f32>>(
    set: &S,
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
        let friction = body.needed_for_rest(twist, push, dt.dt());
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
