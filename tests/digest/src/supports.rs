//! Bits of supports of unknown pressure: support functions, yaw limits, gauges, refusals.

use crate::hash::{Fnv, in_both};
use crate::inputs::pairs_of_ends;
use crate::planes::ends_of_twists;
use tribos_core::limit_surface::{ShapeLimitSurface, UnknownPressureSet};
use tribos_core::patch::outline::Polygon;
use tribos_core::real::Real;
use tribos_core::twist::Wrench;

/// Digest of supports, f64 and f32.
pub fn supports() -> u64 {
    in_both(supports_of::<f64>, supports_of::<f32>)
}

const CORNERS: [[f64; 2]; 5] = [
    [-0.0625, -0.0625],
    [0.1875, -0.03125],
    [0.25, 0.03125],
    [0.125, 0.0625],
    [-0.0625, 0.03125],
];
/// Inside, on an edge, at a corner.
const CENTRES: [[f64; 2]; 4] = [
    [0.0625, 0.0],
    [0.15625, 0.03125],
    [-0.0625, 0.0],
    [0.25, 0.03125],
];

fn supports_of<R: Real>(hash: &mut Fnv) {
    let corners = CORNERS.map(|corner| corner.map(R::from_f64));
    for centre in CENTRES {
        let centre = centre.map(R::from_f64);
        let foot = UnknownPressureSet::new(corners, centre, R::from_f64(420.0)).expect("a support");
        hash.numbers([foot.force_limit(), foot.radius()]);
        hash.numbers([foot.centre().x, foot.centre().y]);
        for twist in ends_of_twists::<R>(101) {
            hash.numbers([foot.support(&twist)]);
            hash.wrench(&foot.wrench(&twist));
            let push = Wrench::new(twist.velocity.x, twist.velocity.y, twist.spin);
            hash.numbers(foot.gauge_bounds(&push));
            let yaw = foot.torque_limits([push.force.x, push.force.y]);
            hash.feed(u64::from(yaw.is_some()));
            if let Some(yaw) = yaw {
                hash.numbers(yaw.certain);
                hash.numbers(yaw.possible);
            }
        }
    }
    let sole = Polygon::new(corners).expect("a polygon");
    let floor = ShapeLimitSurface::new(sole, R::from_f64(420.0)).expect("a set");
    for twist in ends_of_twists::<R>(101) {
        let yaw = floor.torque_limits([twist.velocity.x, twist.velocity.y]);
        hash.feed(u64::from(yaw.is_some()));
        hash.numbers(yaw.unwrap_or([R::ZERO; 2]));
    }
    for (x, y) in pairs_of_ends::<R>().step_by(3) {
        hash.verdict(&UnknownPressureSet::new(corners, [x, y], R::ONE));
        hash.verdict(&UnknownPressureSet::new([[x, y]], [x, y], y));
    }
}
