//! Limit surfaces.

use super::stream::{Precision, Range, Stream};
use tribos_core::coupling::table::Coulomb;
use tribos_core::limit_surface::{Ellipsoid, FrictionSet, LimitSurface, Projection, Region};
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

pub fn both<R: Precision>(s: &mut Stream, range: Range) {
    let [limit, radius, spin_torque, length]: [R; 4] = s.draws(Range::Fit);
    let (twist, wrench) = (s.twist(range), s.wrench(range));
    let disk = LimitSurface::new(Coulomb, limit, radius);
    feed(s, disk.ok(), &twist, &wrench, length);
    // Only the disk is also asked for its own length.
    feed_projection(s, disk.ok().map(|set| set.project(&wrench)));
    let usual = Ellipsoid::new(limit, radius, spin_torque);
    feed(s, usual.ok(), &twist, &wrench, length);
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
