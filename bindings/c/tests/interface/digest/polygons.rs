//! Patches with straight edges.

use super::stream::{Precision, Range, Stream};
use super::surfaces::feed_projection;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::twist::{Twist, Wrench};

pub fn leaning<R: Precision>(s: &mut Stream, range: Range) {
    let x: [R; 8] = s.draws(Range::Fit);
    let p: [R; 4] = s.draws(Range::Fit);
    let shift: [R; 2] = s.draws(Range::Mild);
    let (twist, push) = (s.twist(range), s.wrench(range));
    let loops = 1 + (s.bits() >> 63) as usize;
    let outer = [[x[0], x[1]], [-x[2], x[3]], [-x[4], -x[5]], [x[6], -x[7]]];
    let quarter = R::from_f64(0.25);
    let hole = outer.map(|corner| corner.map(|part| part * quarter));
    let loops = &[&outer[..], &hole][..loops];
    let patch = Polygon::with_holes(loops, [Edge::default(); 8]);
    let Some(patch) = s.ok(patch) else { return };
    feed(s, &patch, &p, &twist, &push);
    let by = shift.map(|part| part / R::from_f64(8.0));
    let centre = [patch.centre().x + by[0], patch.centre().y + by[1]];
    if let Some(patch) = s.ok(patch.with_centre_of_pressure(centre)) {
        feed(s, &patch, &p, &twist, &push);
    }
}

fn feed<R: Precision>(
    s: &mut Stream,
    patch: &impl PatchShape<R>,
    [coefficient, load, force_limit, length]: &[R; 4],
    twist: &Twist<R>,
    push: &Wrench<R>,
) {
    let centre = patch.centre();
    s.numbers([centre.x, centre.y, patch.radius()]);
    let friction = ShapeFriction::new(patch, *coefficient);
    let friction = friction.as_ref().map_err(|_| ());
    s.wrench_of(friction.map(|f| f.wrench(*load, twist)));
    let both = friction.map(|f| f.wrench_and_jacobian(*load, twist));
    s.wrench_of(both.map(|(wrench, _)| wrench));
    s.jacobian_of(both.map(|(_, jacobian)| jacobian));
    let set = ShapeLimitSurface::new(patch, *force_limit);
    let set = set.as_ref().map_err(|_| ());
    s.result(set.map(|set| set.gauge(push)));
    s.twist_of(set.map(|set| set.twist_normal_to(push)));
    // In C a length of 0 represents the radius.
    let nearest = set.map(|set| {
        if *length == R::ZERO {
            set.project(push)
        } else {
            set.project_with_length(push, *length)
        }
    });
    feed_projection(s, nearest.ok());
    feed_projection(s, set.ok().map(|set| set.project(push)));
}
