//! Patches with straight edges, bars and ellipses: every accepted one has friction and a limit surface.

use super::planes::{dissipates, parts, rates, stepped, twist, wrench};
use super::sets::asked;
use crate::{Input, Verdict};
use tribos_core::coupling::flat::{
    PatchShape, PolygonPowerLaw, PowerLawPatch, ShapeFriction, ShapePowerFriction,
};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::arcs::{ArcOutline, Border, Side};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::ellipse::{Ellipse, EllipsePressure};
use tribos_core::patch::feet::{CompoundPatch, PatchPart};
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::{Node, NodePatch, Nodes};
use tribos_core::patch::outline::{Edge, Polygon, PressureField};
use tribos_core::patch::points::PointPatch;
use tribos_core::real::Real;
use tribos_core::twist::{Twist, Wrench, WrenchJacobian};

/// Room for edges.
const ROOM: usize = 16;

type Shape<R, K> = Polygon<R, [Edge<R>; ROOM], K>;

/// One patch.
pub fn polygons<R: Real>(input: &mut Input<'_>) -> Verdict {
    match input.below(11) {
        0 => any_corners::<R>(input),
        1 => {
            let ends = [(); 2].map(|()| [input.number::<R>(), input.number()]);
            let bar = input.taken(Bar::new(ends[0], ends[1]))?;
            placed(input, &bar.centre(), bar.radius())?;
            rubs(input, &bar)?;
            tilted(input, bar)
        }
        2 => blade::<R>(input),
        3 => faces::<R>(input),
        4 => spikes::<R>(input),
        5 => sledge::<R>(input),
        6 => oval::<R>(input),
        7 => cut::<R>(input),
        _ => star::<R>(input),
    }
}

/// A place that is not far from the origin in units of `size`.
pub fn near<R: Real>(input: &mut Input<'_>, size: R) -> [R; 2] {
    [(); 2].map(|()| size * R::from_f64(4.0 * input.unit::<f64>() - 2.0))
}

/// A place near the origin if the input is mild, else anywhere.
fn place<R: Real>(input: &mut Input<'_>, size: R) -> [R; 2] {
    if input.is_mild() {
        near(input, size)
    } else {
        [input.number(), input.number()]
    }
}

/// Corners anywhere: a patch may be as thin as rounding lets it.
fn any_corners<R: Real>(input: &mut Input<'_>) -> Verdict {
    let corners = [(); 3].map(|()| [input.number::<R>(), input.number()]);
    let fourth = [input.number::<R>(), input.number()];
    if let Ok(triangle) = input.taken(Polygon::new(corners)) {
        placed(input, &triangle.centre(), triangle.radius())?;
        let friction = ShapeFriction::new(triangle, input.size());
        let (load, motion) = (input.size(), twist::<R>(input));
        if let Ok(friction) = input.taken(friction) {
            let (met, _) = friction.wrench_and_jacobian(load, &motion);
            input.finite("friction of a triangle", parts(&met))?;
        }
    }
    let [a, b, c] = corners;
    let loops = [&[a, b, c, fourth][..input.below(5)], &[b, c, a]];
    let frame = Polygon::with_holes(&loops[..input.below(3)], [Edge::default(); ROOM]);
    let frame = input.taken(frame)?;
    placed(input, &frame.centre(), frame.radius())
}

/// The set of a bar, not far from the origin: about a distant one it is lost in rounding.
fn blade<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let bar = Bar::new(near(input, size), near(input, size));
    let bar = input.taken(bar)?;
    let set = ShapeLimitSurface::new(bar, input.size());
    let set = input.taken(set)?;
    asked(input, &set)
}

/// The same under linear pressure, if it carries it.
fn tilted<R: Real>(input: &mut Input<'_>, bar: Bar<R>) -> Verdict {
    let part = R::from_f64(2.4 * input.unit::<f64>() - 1.2);
    let made = match input.below(3) {
        0 => bar.with_slope(part / bar.radius()),
        1 => bar.with_centre_of_pressure(part * bar.radius() / R::from_f64(3.0)),
        _ => bar.with_slope(input.number()),
    };
    let wedge = input.taken(made)?;
    placed(input, &wedge.centre(), wedge.radius())?;
    rubs(input, &wedge)
}

/// Triangles anywhere, or around a middle.
fn faces<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let vertices = [(); 6].map(|()| {
        let [x, y] = place(input, size);
        let pressure = if input.is_mild() {
            input.unit()
        } else {
            input.number()
        };
        Vertex { x, y, pressure }
    });
    let named = [(); 4].map(|()| [input.below(7), input.below(6), input.below(6)]);
    let mesh = input.taken(Mesh::with_vertices(
        &vertices,
        &named,
        [Triangle::default(); 4],
    ))?;
    let load = mesh.load();
    input.holds(load >= R::ZERO, "a load", &[load])?;
    placed(input, &mesh.centre(), mesh.radius())?;
    let [a, b, c, ..] = vertices;
    if let Ok(lone) = input.taken(Mesh::new([[a, b, c]])) {
        placed(input, &lone.centre(), lone.radius())?;
    }
    borne_if_mild(input, &mesh)
}

/// Points, and their set near the origin.
fn spikes<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let nodes = [(); 4].map(|()| {
        let [x, y] = place(input, size);
        let weight = input.unit::<R>();
        Node { x, y, weight }
    });
    let points = input.taken(Nodes::new(nodes).and_then(PointPatch::new))?;
    placed(input, &points.centre(), points.radius())?;
    let total: R = points.nodes().total_weight();
    input.holds(total > R::ZERO, "a weight", &[total])?;
    borne_if_mild(input, &points)
}

/// Two blades under one body.
fn sledge<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let ends = [(); 4].map(|()| near(input, size));
    let one = input.taken(Bar::new(ends[0], ends[1]))?;
    let other = input.taken(Bar::new(ends[2], ends[3]))?;
    let feet = [one, other].map(|patch| PatchPart {
        patch,
        load: input.size::<R>(),
    });
    let body = input.taken(CompoundPatch::new(&feet))?;
    let radius = body.radius();
    input.holds(body.feet().len() == 2, "two feet", &[radius])?;
    placed(input, &body.centre(), body.radius())?;
    borne(input, &body)
}

/// An ellipse with axes in any direction, or a linear image of one.
fn oval<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let centre = near(input, size);
    let pressure = input.one_of(&[
        EllipsePressure::FlatPunch,
        EllipsePressure::Uniform,
        EllipsePressure::Hertz,
        EllipsePressure::Paraboloid,
    ]);
    let made = if input.one_in(2) {
        Ellipse::new(centre, place(input, size), pressure)
    } else {
        let half_diameters = [place(input, size), place(input, size)];
        Ellipse::with_half_diameters(centre, half_diameters, pressure)
    };
    let patch = input.taken(made)?;
    placed(input, &patch.centre(), patch.radius())?;
    let [a, b] = patch.semi_axes();
    let axis = patch.major_axis();
    input.holds(a >= b && b > R::ZERO, "axes in their order", &[a, b])?;
    input.finite("a direction", [axis.x, axis.y])?;
    borne_if_mild(input, &patch)
}

/// A part of an ellipse, or borders that may bound nothing.
fn cut<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let centre = near(input, size);
    let made = if input.one_in(2) {
        let semi_axes = [(); 2].map(|()| size * (R::from_f64(0.2) + input.unit::<R>()));
        let ellipse = Ellipse::new(centre, semi_axes, EllipsePressure::Uniform);
        let ellipse = input.taken(ellipse)?;
        let [[a, b], [c, d]] = [near(input, size), near(input, size)];
        let ([left, right], [low, high]) = (in_order(a, c), in_order(b, d));
        let corners = [[left, low], [right, low], [right, high], [left, high]];
        ArcOutline::cut(&ellipse, &corners, [Side::default(); ROOM])
    } else {
        let half_diameters = [place(input, size), place(input, size)];
        let [px, py] = half_diameters[0];
        let (from, to) = if input.is_mild() {
            (R::ZERO, R::PI)
        } else {
            (input.number(), input.number())
        };
        let borders = [
            Border::Arc {
                centre,
                half_diameters,
                from,
                to,
            },
            Border::Line {
                from: [centre[0] - px, centre[1] - py],
                to: [centre[0] + px, centre[1] + py],
            },
        ];
        let count = 1 + input.below(2);
        ArcOutline::new(&borders[..count], [Side::default(); ROOM])
    };
    let patch = input.taken(made)?;
    placed(input, &patch.centre(), patch.radius())?;
    let area = patch.area();
    input.holds(
        area > R::ZERO && !patch.sides().is_empty(),
        "an area",
        &[area],
    )?;
    borne_if_mild(input, &patch)
}

fn in_order<R: Real>(a: R, b: R) -> [R; 2] {
    if a < b { [a, b] } else { [b, a] }
}

/// A patch that is at most a few times as long as wide, at times with a hole.
fn star<R: Real>(input: &mut Input<'_>) -> Verdict {
    let size = input.ordinary::<R>();
    let centre = near(input, size);
    let corners = DIRECTIONS.map(|direction| {
        let far = size * (R::ONE + input.unit::<R>());
        [0, 1].map(|axis| centre[axis] + far * R::from_f64(direction[axis]))
    });
    let hole = corners.map(|corner| {
        [0, 1].map(|axis| centre[axis] + R::from_f64(0.25) * (corner[axis] - centre[axis]))
    });
    let loops = [&corners[..], &hole];
    let count = 1 + input.below(2);
    let patch = Polygon::with_holes(&loops[..count], [Edge::default(); ROOM]);
    input.holds(patch.is_ok(), "a star is taken", &centre)?;
    let patch = input.taken(patch)?;
    match input.below(3) {
        0 => {
            let part = [(); 2].map(|()| R::from_f64(0.4 * input.unit::<f64>() - 0.2) / size);
            let slope = if input.is_mild() {
                part
            } else {
                [input.number(), input.number()]
            };
            let tilted = patch.with_slope(slope);
            let tilted = input.taken(tilted)?;
            used(input, &tilted)
        }
        1 => {
            let [x, y] = [(); 2].map(|()| input.number::<R>());
            let place = [centre[0] + x, centre[1] + y];
            let shifted = patch.with_centre_of_pressure(place);
            let shifted = input.taken(shifted)?;
            used(input, &shifted)
        }
        _ => used(input, &patch),
    }
}

/// The eight compass directions, roughly.
const DIRECTIONS: [[f64; 2]; 8] = [
    [1.0, 0.0],
    [0.75, 0.75],
    [0.0, 1.0],
    [-0.75, 0.75],
    [-1.0, 0.0],
    [-0.75, -0.75],
    [0.0, -1.0],
    [0.75, -0.75],
];

pub fn placed<R: Real>(input: &mut Input<'_>, centre: &nalgebra::Vector2<R>, radius: R) -> Verdict {
    let fine = centre.x.is_finite() && centre.y.is_finite() && radius.is_finite();
    input.holds(
        fine && radius > R::ZERO,
        "a finite place and radius",
        &[centre.x, centre.y, radius],
    )
}

fn used<R: Real, K: PressureField<R>>(input: &mut Input<'_>, patch: &Shape<R, K>) -> Verdict {
    let area = patch.area();
    input.holds(area > R::ZERO, "an area", &[area])?;
    placed(input, &patch.centre(), patch.radius())?;
    let gyration = patch.radius_of_gyration();
    input.holds(gyration >= R::ZERO, "a radius of gyration", &[gyration])?;
    if input.one_in(2) {
        rubs(input, patch)?;
        return resists(input, patch);
    }
    let set = ShapeLimitSurface::new(*patch, input.size());
    let set = input.taken(set)?;
    input.holds(
        set.torque_limit() <= set.force_limit() * set.radius() * R::TWO,
        "no arm beyond the radius",
        &[set.torque_limit(), set.patch().radius()],
    )?;
    match input.below(3) {
        0 => asked(input, &set),
        1 => stepped(input, |body, twist, push, dt| {
            body.step(&set, twist, push, dt)
        }),
        _ => derived(input, &set),
    }
}

/// The same of a mild input; another may lie anywhere, where it is lost in rounding.
fn borne_if_mild<R: Real>(input: &mut Input<'_>, patch: &impl PatchShape<R>) -> Verdict {
    if input.is_mild() {
        borne(input, patch)
    } else {
        Ok(())
    }
}

/// Friction at any motion, or the set of what is carried.
pub fn borne<R: Real>(input: &mut Input<'_>, patch: &impl PatchShape<R>) -> Verdict {
    if input.one_in(2) {
        return rubs(input, patch);
    }
    let set = ShapeLimitSurface::new(patch, input.size());
    let set = input.taken(set)?;
    asked(input, &set)
}

/// Friction at any motion.
pub fn rubs<R: Real>(input: &mut Input<'_>, patch: &impl PatchShape<R>) -> Verdict {
    let friction = ShapeFriction::new(patch, input.size::<R>());
    let friction = input.taken(friction)?;
    let coefficient = friction.coefficient();
    input.holds(coefficient >= R::ZERO, "coefficient ≥ 0", &[coefficient])?;
    let (load, motion) = (input.size(), twist::<R>(input));
    let met = friction.wrench(load, &motion);
    met_with_jacobian(
        input,
        &motion,
        &met,
        friction.wrench_and_jacobian(load, &motion),
        true,
    )
}

/// Friction of any power of the speed at any motion.
fn resists<R: Real>(input: &mut Input<'_>, patch: &impl PowerLawPatch<R>) -> Verdict {
    let alpha = if input.is_mild() {
        R::from_f64(2.5 * input.unit::<f64>() - 0.5)
    } else {
        input.number()
    };
    let power = PolygonPowerLaw::new(alpha);
    let is_in = alpha > -R::ONE && alpha.to_f64() <= PolygonPowerLaw::<R>::MAX_EXPONENT;
    input.holds(
        power.is_ok() || !is_in,
        "an exponent in range is taken",
        &[alpha],
    )?;
    let power = input.taken(power)?;
    let friction = ShapePowerFriction::new(patch, input.size::<R>(), power);
    let friction = input.taken(friction)?;
    let own = [friction.power().alpha(), friction.coefficient()];
    let fits = own[0] == alpha && own[1] >= R::ZERO && friction.patch().radius() > R::ZERO;
    input.holds(fits, "its parts", &own)?;
    let (load, motion) = (input.size(), twist::<R>(input));
    let met = friction.wrench(load, &motion);
    let with_jacobian = friction.wrench_and_jacobian(load, &motion);
    // A weakening law's derivatives grow without bound towards rest.
    met_with_jacobian(input, &motion, &met, with_jacobian, alpha >= R::ONE)
}

/// Friction alone and with its Jacobian: NaN for NaN, one wrench, dissipation.
fn met_with_jacobian<R: Real>(
    input: &mut Input<'_>,
    motion: &Twist<R>,
    met: &Wrench<R>,
    (same, jacobian): (Wrench<R>, WrenchJacobian<R>),
    is_smooth: bool,
) -> Verdict {
    input.give(parts(&same).into_iter().chain(jacobian.iter().copied()));
    let all = parts(met);
    if rates(motion).iter().any(|x| x.is_nan()) {
        return input.all_nan("wrench", all);
    }
    let is_same = same == *met || all.iter().any(|x| x.is_nan());
    input.holds(is_same, "the same wrench with its Jacobian", &all)?;
    if is_smooth {
        input.finite("Jacobian of a wrench", jacobian.iter().copied())?;
    }
    dissipates(input, met, motion)
}

/// The derivatives at any push.
fn derived<R: Real, P: PatchShape<R>>(
    input: &mut Input<'_>,
    set: &ShapeLimitSurface<R, P>,
) -> Verdict {
    let (push, length) = (wrench::<R>(input), input.positive::<R>());
    let (normal, curvature) = set.gauge_derivatives(&push);
    let (carried, rate) = set.project_with_jacobian(&push, length);
    let all = parts(&push);
    input.give(rates(&normal).into_iter().chain(curvature.iter().copied()));
    input.give(rate.iter().copied());
    if let Some([low, high]) = set.torque_limits([all[0], all[1]]) {
        let is_ordered = low <= high || all[0].is_nan() || all[1].is_nan();
        let is_fine = is_ordered || !input.is_mild();
        input.holds(is_fine, "torques in their order", &[low, high])?;
    }
    if all.iter().any(|x| x.is_nan()) {
        return input.all_nan("normal", [normal.spin]);
    }
    if set.contains(&push) {
        let stays = set.project(&push).wrench == push;
        input.holds(stays || !input.is_mild(), "a carried wrench stays", &all)?;
    }
    input.finite("projection", parts(&carried.wrench))?;
    if set.force_limit() > R::ZERO && all.iter().any(|x| *x != R::ZERO) {
        input.finite("normal", [normal.spin])?;
        input.finite("curvature", curvature.iter().copied())?;
        input.finite("rate", rate.iter().copied())?;
    }
    Ok(())
}
