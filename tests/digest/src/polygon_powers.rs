//! Bits of power laws on patches with straight edges.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, twist, unit};
use crate::planes::ends_of_twists;
use tribos_core::coupling::flat::{PolygonPowerLaw, PowerLawPatch, ShapePowerFriction};
use tribos_core::patch::outline::{Edge, Polygon};
use tribos_core::real::Real;
use tribos_core::twist::Twist;

/// Digest of power laws on polygons, f64 and f32.
pub fn polygon_powers() -> u64 {
    in_both(powers::<f64>, powers::<f32>)
}

/// Exponents of each kind: weakening, next to an even one, even, none of them.
const ALPHAS: [f64; 6] = [-0.5, 0.0, 0.5, 1.0, 2.125, 3.0];

fn powers<R: Real>(hash: &mut Fnv) {
    let corners = |all: [[f64; 2]; 4]| all.map(|corner| corner.map(R::from_f64));
    let outside = corners([[-1.0, -0.5], [1.0, -0.5], [1.0, 0.75], [-1.0, 0.5]]);
    let hole = corners([[-0.5, -0.25], [0.75, -0.25], [0.75, 0.25], [-0.5, 0.25]]);
    let frame = Polygon::with_holes(&[&outside, &hole], [Edge::default(); 8]).expect("a patch");
    let slope = [0.25, -0.125].map(R::from_f64);
    let tilted = frame.with_slope(slope).expect("it does not lift off");
    for alpha in ALPHAS {
        let power = PolygonPowerLaw::new(R::from_f64(alpha)).expect("in range");
        friction(hash, frame, power);
        friction(hash, tilted, power);
    }
    for given in ends::<R>() {
        let power = PolygonPowerLaw::new(given);
        hash.verdict(&power);
        if let Ok(power) = power {
            hash.numbers([power.alpha()]);
            hash.verdict(&ShapePowerFriction::new(frame, given, power));
        }
    }
}

/// Wrenches and Jacobians, about centres of rotation near the patch and far away.
fn friction<R: Real, P: PowerLawPatch<R>>(hash: &mut Fnv, patch: P, power: PolygonPowerLaw<R>) {
    let friction = ShapePowerFriction::new(patch, R::from_f64(0.375), power).expect("in range");
    hash.numbers([friction.coefficient(), friction.patch().radius()]);
    hash.numbers([friction.power().alpha()]);
    let mut rng = Lcg::new(179);
    let anyhow = [(); 12].map(|()| twist::<R>(&mut rng));
    let about = [(); 24].map(|()| {
        let [x, y] = [(); 2].map(|()| R::from_f64(8.0) * (unit::<R>(&mut rng) - R::HALF));
        Twist::new(y, -x, R::ONE)
    });
    for motion in anyhow.into_iter().chain(about).chain(ends_of_twists(61)) {
        let load = R::from_f64(1.75);
        hash.wrench(&friction.wrench(load, &motion));
        let (wrench, jacobian) = friction.wrench_and_jacobian(load, &motion);
        hash.wrench(&wrench);
        hash.numbers(jacobian.iter().copied());
    }
}
