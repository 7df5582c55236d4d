//! Bits of patches with straight edges and of bars: friction, limit surfaces, steps, refusals.

use crate::hash::{Fnv, in_both};
use crate::inputs::{Lcg, ends, pairs_of_ends, twist, unit};
use crate::planes::ends_of_twists;
use crate::sets::questions;
use tribos_core::contact::TimeStep;
use tribos_core::coupling::flat::{PatchShape, ShapeFriction};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::outline::{Edge, Polygon, PressureField};
use tribos_core::planar::PlanarBody;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench};

/// Digest of polygons and bars, f64 and f32.
pub fn polygons() -> u64 {
    in_both(polygons_of::<f64>, polygons_of::<f32>)
}

/// Room for the edges of every shape, so that all have one type.
type Memory<R> = [Edge<R>; 9];

const TRIANGLE: [[f64; 2]; 3] = [[0.0, 0.0], [0.75, 0.0], [0.25, 0.5]];
/// Clockwise.
const ELL: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [0.0, 1.5],
    [0.25, 1.5],
    [0.25, 0.5],
    [1.0, 0.5],
    [1.0, 0.0],
];
const OUTSIDE: [[f64; 2]; 4] = [[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]];
const HOLE: [[f64; 2]; 4] = [[-0.5, -0.25], [0.75, -0.25], [0.75, 0.25], [-0.5, 0.25]];

fn real<R: Real, const N: usize>(corners: [[f64; 2]; N]) -> [[R; 2]; N] {
    corners.map(|corner| corner.map(R::from_f64))
}

fn polygons_of<R: Real>(hash: &mut Fnv) {
    let patch =
        |loops: &[&[[R; 2]]]| Polygon::with_holes(loops, Memory::default()).expect("a patch");
    let triangle = patch(&[&real::<R, 3>(TRIANGLE)]);
    let ell = patch(&[&real::<R, 6>(ELL)]);
    let frame = patch(&[&real::<R, 4>(OUTSIDE), &real::<R, 4>(HOLE)]);
    let [slope, place] = [[0.25, -0.125], [0.375, 0.5]].map(|pair| pair.map(R::from_f64));
    let tilted = frame.with_slope(slope).expect("it does not lift off");
    let shifted = ell
        .with_centre_of_pressure(place)
        .expect("it does not lift off");
    let [from, to] = real::<R, 2>([[-0.25, 0.5], [0.5, 0.75]]);
    let bar = Bar::new(from, to).expect("a bar");
    shape(hash, &triangle);
    shape(hash, &ell);
    shape(hash, &frame);
    shape(hash, &tilted);
    shape(hash, &shifted);
    hash.numbers([bar.centre().x, bar.centre().y, bar.radius()]);
    friction(hash, bar);
    surface(hash, triangle);
    surface(hash, ell);
    surface(hash, tilted);
    surface(hash, bar);
    refusals(hash, [triangle.centre().x, triangle.centre().y]);
}

fn shape<R: Real, K: PressureField<R>>(hash: &mut Fnv, patch: &Polygon<R, Memory<R>, K>) {
    hash.numbers([patch.centre().x, patch.centre().y]);
    hash.numbers([patch.radius(), patch.area(), patch.radius_of_gyration()]);
    friction(hash, *patch);
}

/// Wrenches and Jacobians, about centres of rotation near the patch and far away.
pub(crate) fn friction<R: Real, P: PatchShape<R>>(hash: &mut Fnv, patch: P) {
    let centre = patch.centre();
    hash.numbers([centre.x, centre.y, patch.radius()]);
    let friction = ShapeFriction::new(patch, R::from_f64(0.375)).expect("in range");
    hash.numbers([friction.coefficient(), friction.patch().radius()]);
    let mut rng = Lcg::new(167);
    let anyhow = [(); 24].map(|()| twist::<R>(&mut rng));
    let about = [(); 48].map(|()| {
        let [x, y] = [(); 2].map(|()| R::from_f64(8.0) * (unit::<R>(&mut rng) - R::HALF));
        Twist::new(y, -x, R::ONE)
    });
    let all = anyhow.into_iter().chain(about).chain(ends_of_twists(61));
    for motion in all {
        let load = R::from_f64(1.75);
        hash.wrench(&friction.wrench(load, &motion));
        let (wrench, jacobian) = friction.wrench_and_jacobian(load, &motion);
        hash.wrench(&wrench);
        hash.numbers(jacobian.iter().copied());
    }
    for load in ends() {
        hash.wrench(&friction.wrench(load, &about[0]));
    }
}

/// All that can be asked of a limit surface, its derivatives, and steps on it.
pub(crate) fn surface<R: Real, P: PatchShape<R>>(hash: &mut Fnv, patch: P) {
    let set = ShapeLimitSurface::new(patch, R::from_f64(0.75)).expect("in range");
    hash.numbers([set.torque_limit(), set.patch().radius()]);
    questions(hash, &set, 8);
    let mut rng = Lcg::new(173);
    for _ in 0..16 {
        let part = [(); 3].map(|()| R::TWO * unit::<R>(&mut rng) - R::ONE);
        derivatives(hash, &set, &Wrench::new(part[0], part[1], part[2]));
    }
    for push in ends_of_twists::<R>(211) {
        let push = Wrench::new(push.velocity.x, push.velocity.y, push.spin);
        derivatives(hash, &set, &push);
    }
    let body = PlanarBody::new(R::HALF, R::from_f64(0.0625)).expect("in range");
    let dt = TimeStep::new(R::from_f64(1.0 / 16.0)).expect("in range");
    let mut motion = Twist::new(R::HALF, R::ONE, R::TWO);
    for _ in 0..12 {
        let push = Wrench::new(R::from_f64(0.0625), R::ZERO, R::from_f64(0.03125));
        let next = body.step(&set, &motion, &push, dt);
        hash.twist(&next.twist);
        hash.feed(u64::from(next.is_at_rest));
        motion = next.twist;
    }
}

fn derivatives<R: Real, P: PatchShape<R>>(
    hash: &mut Fnv,
    set: &ShapeLimitSurface<R, P>,
    push: &Wrench<R>,
) {
    let (normal, hessian) = set.gauge_derivatives(push);
    hash.twist(&normal);
    hash.numbers(hessian.iter().copied());
    let (carried, rate) = set.project_with_jacobian(push, set.radius());
    hash.wrench(&carried.wrench);
    hash.numbers(rate.iter().copied());
}

/// What is taken of numbers at the ends, of loops that cross, and of pressures that lift off.
fn refusals<R: Real>(hash: &mut Fnv, inside: [R; 2]) {
    let (corners, hole) = (real::<R, 4>(OUTSIDE), real::<R, 4>(HOLE));
    let away = corners.map(|[x, y]| [x + R::TWO + R::ONE, y]);
    for loops in [
        &[&corners[..], &away[..]][..],
        &[&corners[..], &corners[..]],
        &[&corners[..], &hole[..2]],
        &[&corners[..], &hole[..]],
        &[&hole[..], &corners[..]],
        &[],
    ] {
        let mut memory = [Edge::default(); 8];
        hash.verdict(&Polygon::with_holes(loops, &mut memory[..]));
        hash.verdict(&Polygon::with_holes(loops, &mut memory[..7]));
    }
    let patch = Polygon::new(corners).expect("a rectangle");
    let bar = Bar::new(corners[0], corners[1]).expect("a bar");
    for (x, y) in pairs_of_ends::<R>().step_by(3) {
        let triangle = Polygon::new([[x, y], corners[1], corners[2]]);
        hash.verdict(&triangle);
        if let Ok(triangle) = triangle {
            hash.numbers([triangle.centre().x, triangle.radius(), triangle.area()]);
        }
        hash.verdict(&patch.with_slope([x, y]));
        hash.verdict(&patch.with_centre_of_pressure([x, y]));
        hash.verdict(&Bar::new([x, y], inside));
        hash.verdict(&ShapeFriction::new(bar, x));
        hash.verdict(&ShapeLimitSurface::new(patch, y));
    }
}
