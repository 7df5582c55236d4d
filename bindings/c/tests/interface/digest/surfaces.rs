//! Limit surfaces.

use super::stream::{Precision, Range, Stream};
use tribos_core::contact::TimeStep;
use tribos_core::coupling::DryReducedFriction;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::limit_surface::{
    FrictionSet, LimitEllipsoid, Projection, Region, RoundLimitSurface,
};
use tribos_core::planar::{PlanarBody, PlanarStep};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

pub fn both<R: Precision>(s: &mut Stream, range: Range) {
    let [limit, radius, spin_torque, length]: [R; 4] = s.draws(Range::Fit);
    let (twist, wrench) = (s.twist(range), s.wrench(range));
    let disk = RoundLimitSurface::new(CoulombDisk, limit, radius);
    feed(s, disk.ok(), &twist, &wrench, length);
    // Only the disk is also asked for its own length.
    feed_projection(s, disk.ok().map(|set| set.project(&wrench)));
    let usual = LimitEllipsoid::new(limit, radius, spin_torque);
    feed(s, usual.ok(), &twist, &wrench, length);
    batches(s, disk.ok(), length, range);
    steps(
        s,
        [disk.ok().map(Sets::Disk), usual.ok().map(Sets::Ellipsoid)],
        range,
    );
}

/// More than are converted at once.
pub const BATCH: usize = 21;

fn batches<R: Precision>(
    s: &mut Stream,
    set: Option<RoundLimitSurface<R, CoulombDisk>>,
    length: R,
    range: Range,
) {
    let loads: [R; BATCH] = s.draws(range);
    let pushes = [(); BATCH].map(|()| s.wrench(range));
    let mut gauges = [R::ZERO; BATCH];
    let mut motions = [Twist::ZERO; BATCH];
    let set = set.ok_or(());
    if let Some(set) = s.ok(set) {
        set.gauge_batch(&loads, &pushes, &mut gauges);
        s.numbers(gauges);
    }
    if let Some(set) = s.ok(set) {
        set.twist_normal_to_batch(&pushes, &mut motions);
        for motion in motions {
            s.numbers([motion.velocity.x, motion.velocity.y, motion.spin]);
        }
    }
    feed_projections(s, set, &loads, &pushes, length);
}

/// Projections of a batch; a length of 0 represents the radius.
pub fn feed_projections<R: Precision, C: DryReducedFriction<R>>(
    s: &mut Stream,
    set: Result<RoundLimitSurface<R, C>, ()>,
    loads: &[R; BATCH],
    pushes: &[Wrench<R>; BATCH],
    length: R,
) {
    let Some(set) = s.ok(set) else { return };
    let length = if length == R::ZERO {
        set.radius()
    } else {
        length
    };
    let mut nearest = pushes.map(|wrench| Projection {
        wrench,
        region: Region::Inside,
    });
    set.project_batch(length, loads, pushes, &mut nearest);
    for projection in nearest {
        feed_projection(s, Some(projection));
    }
}

#[derive(Clone, Copy)]
enum Sets<R> {
    Disk(RoundLimitSurface<R, CoulombDisk>),
    Ellipsoid(LimitEllipsoid<R>),
}

fn steps<R: Precision>(s: &mut Stream, sets: [Option<Sets<R>>; 2], range: Range) {
    let [mass, inertia, dt]: [R; 3] = s.draws(Range::Fit);
    let (twist, push) = (s.twist(range), s.wrench(range));
    let body = PlanarBody::new(mass, inertia).ok();
    for set in sets {
        let step = (|| {
            let (body, set, dt) = (body?, set?, TimeStep::new(dt).ok()?);
            Some(match set {
                Sets::Disk(set) => body.step(&set, &twist, &push, dt),
                Sets::Ellipsoid(set) => body.step(&set, &twist, &push, dt),
            })
        })();
        feed_step(s, step);
    }
    let many = [(); BATCH].map(|()| (s.draw(range), s.twist(range), s.wrench(range)));
    let disk = sets[0];
    let Some((body, disk, dt)) =
        s.ok((|| Some((body?, disk?, TimeStep::new(dt).ok()?)))().ok_or(()))
    else {
        return;
    };
    let Sets::Disk(disk) = disk else { return };
    for (load, twist, push) in many {
        // One by one: the batch has their bits.
        let blank = body.step(&disk, &Twist::ZERO, &Wrench::ZERO, dt);
        let mut step = [blank];
        body.step_batch_under_loads(&disk, &[load], &[twist], &[push], dt, &mut step);
        let [step] = step;
        feed_step(s, Some(step));
    }
}

pub fn feed_step<R: Precision>(s: &mut Stream, step: Option<PlanarStep<R>>) {
    if let Some(step) = s.ok(step.ok_or(())) {
        s.feed_bits(step.is_at_rest.into());
        let PlanarStep {
            twist, friction, ..
        } = step;
        s.twist_and_friction(&twist, &friction);
    }
}

fn feed<R: Precision, S: FrictionSet<R>>(
    s: &mut Stream,
    set: Option<S>,
    twist: &Twist<R>,
    wrench: &Wrench<R>,
    length: R,
) {
    let set = set.as_ref().ok_or(());
    s.result(set.map(|set| set.support(twist)));
    s.wrench_of(set.map(|set| set.wrench(twist)));
    s.result(set.map(|set| set.gauge(wrench)));
    s.twist_of(set.map(|set| set.twist_normal_to(wrench)));
    s.wrench_of(set.map(|set| set.scale_to_surface(wrench)));
    // In C a length of 0 represents the radius.
    let nearest = set.map(|set| {
        if length == R::ZERO {
            set.project(wrench)
        } else {
            set.project_with_length(wrench, length)
        }
    });
    feed_projection(s, nearest.ok());
}

pub fn feed_projection<R: Real>(s: &mut Stream, projection: Option<Projection<R>>) {
    if let Some(p) = s.ok(projection.ok_or(())) {
        let (slides, normal) = match p.region {
            Region::Inside => (0, Twist::ZERO),
            Region::OnSurface { normal } => (1, normal),
        };
        s.feed_bits(slides);
        s.numbers([p.wrench.force.x, p.wrench.force.y, p.wrench.torque]);
        s.numbers([normal.velocity.x, normal.velocity.y, normal.spin]);
    }
}
