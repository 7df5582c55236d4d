//! Patches with straight edges and bars: every accepted one has friction and a limit surface.

use super::check::{all_nan, finite, holds};
use super::planes::{dissipates, stepped, twist, wrench};
use super::sets::asked;
use super::supports::supports;
use super::{Broken, Source};
use tribos_core::coupling::flat::{
    PatchShape, PolygonPowerLaw, PowerLawPatch, ShapeFriction, ShapePowerFriction,
};
use tribos_core::limit_surface::{FrictionSet, ShapeLimitSurface};
use tribos_core::patch::bar::Bar;
use tribos_core::patch::feet::{CompoundPatch, PatchPart};
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::{Node, NodePatch, Nodes};
use tribos_core::patch::outline::{Edge, Polygon, PressureField};
use tribos_core::patch::points::PointPatch;
use tribos_core::real::Real;

/// Room for edges.
const ROOM: usize = 16;

type Shape<R, K> = Polygon<R, [Edge<R>; ROOM], K>;

/// One patch in either precision.
pub fn polygons(source: &mut Source) -> Result<(), Broken> {
    if source.one_in(2) {
        of::<f64>(source)
    } else {
        of::<f32>(source)
    }
}

fn of<R: Real>(source: &mut Source) -> Result<(), Broken> {
    match source.below(11) {
        6 => faces::<R>(source),
        7 => spikes::<R>(source),
        8 => sledge::<R>(source),
        0 => any_corners::<R>(source),
        1 => {
            let ends = [(); 2].map(|()| [source.number::<R>(), source.number()]);
            let Ok(bar) = Bar::new(ends[0], ends[1]) else {
                return Ok(());
            };
            placed(&bar.centre(), bar.radius())?;
            rubs(source, &bar)
        }
        2 => blade::<R>(source),
        3 | 4 => supports::<R>(source),
        _ => star::<R>(source),
    }
}

/// Corners anywhere: a patch may be as thin as rounding lets it.
fn any_corners<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let corners = [(); 3].map(|()| [source.number::<R>(), source.number()]);
    let fourth = [source.number::<R>(), source.number()];
    if let Ok(triangle) = Polygon::new(corners) {
        placed(&triangle.centre(), triangle.radius())?;
        let friction = ShapeFriction::new(triangle, source.size());
        let (load, motion) = (source.size(), twist::<R>(source));
        let met = friction.map(|friction| friction.wrench_and_jacobian(load, &motion));
        if let Ok((met, _)) = met {
            let parts = [met.force.x, met.force.y, met.torque];
            finite(source, "friction of a triangle", parts)?;
        }
    }
    let [a, b, c] = corners;
    let loops = [&[a, b, c, fourth][..source.below(5)], &[b, c, a]];
    let frame = Polygon::with_holes(&loops[..source.below(3)], [Edge::default(); ROOM]);
    frame.map_or(Ok(()), |frame| placed(&frame.centre(), frame.radius()))
}

/// The set of a bar, not far from the origin: about a distant one it is lost in rounding.
fn blade<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let size = source.ordinary::<R>();
    let mut end = || [(); 2].map(|()| size * R::from_f64(4.0 * source.unit::<f64>() - 2.0));
    let Ok(bar) = Bar::new(end(), end()) else {
        return Ok(());
    };
    let set = ShapeLimitSurface::new(bar, source.size());
    set.map_or(Ok(()), |set| asked(source, &set))
}

/// Triangles anywhere, or around a middle.
fn faces<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let is_ordinary = source.is_mild();
    let size = source.ordinary::<R>();
    let mut vertex = || {
        let [x, y] = [(); 2].map(|()| {
            if is_ordinary {
                size * R::from_f64(4.0 * source.unit::<f64>() - 2.0)
            } else {
                source.number()
            }
        });
        let pressure = if is_ordinary {
            source.unit()
        } else {
            source.number()
        };
        Vertex { x, y, pressure }
    };
    let vertices = [(); 6].map(|()| vertex());
    let named = [(); 4].map(|()| [source.below(7), source.below(6), source.below(6)]);
    let Ok(mesh) = Mesh::with_vertices(&vertices, &named, [Triangle::default(); 4]) else {
        return Ok(());
    };
    let load = mesh.load();
    holds(load >= R::ZERO, "a load", &[load])?;
    placed(&mesh.centre(), mesh.radius())?;
    let [a, b, c, ..] = vertices;
    if let Ok(lone) = Mesh::new([[a, b, c]]) {
        placed(&lone.centre(), lone.radius())?;
    }
    if is_ordinary {
        borne(source, &mesh)
    } else {
        Ok(())
    }
}

/// Points, and their set near the origin.
fn spikes<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let is_ordinary = source.is_mild();
    let size = source.ordinary::<R>();
    let nodes = [(); 4].map(|()| {
        let [x, y] = [(); 2].map(|()| {
            if is_ordinary {
                size * R::from_f64(4.0 * source.unit::<f64>() - 2.0)
            } else {
                source.number()
            }
        });
        let weight = source.unit::<R>();
        Node { x, y, weight }
    });
    let Ok(points) = Nodes::new(nodes).and_then(PointPatch::new) else {
        return Ok(());
    };
    placed(&points.centre(), points.radius())?;
    let total: R = points.nodes().total_weight();
    holds(total > R::ZERO, "a weight", &[total])?;
    if !is_ordinary {
        return Ok(());
    }
    borne(source, &points)
}

/// Two blades under one body.
fn sledge<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let size = source.ordinary::<R>();
    let mut end = || [(); 2].map(|()| size * R::from_f64(4.0 * source.unit::<f64>() - 2.0));
    let ends = [(); 2].map(|()| [end(), end()]);
    let [one, other] = ends.map(|[from, to]| Bar::new(from, to));
    let (Ok(one), Ok(other)) = (one, other) else {
        return Ok(());
    };
    let feet = [one, other].map(|patch| PatchPart {
        patch,
        load: source.size::<R>(),
    });
    let Ok(body) = CompoundPatch::new(&feet) else {
        return Ok(());
    };
    let radius = body.radius();
    holds(body.feet().len() == 2, "two feet", &[radius])?;
    placed(&body.centre(), body.radius())?;
    borne(source, &body)
}

/// A patch that is at most a few times as long as wide, at times with a hole.
fn star<R: Real>(source: &mut Source) -> Result<(), Broken> {
    let size = source.ordinary::<R>();
    let centre = [(); 2].map(|()| size * R::from_f64(4.0 * source.unit::<f64>() - 2.0));
    let corners: Vec<[R; 2]> = DIRECTIONS
        .iter()
        .map(|direction| {
            let far = size * (R::ONE + source.unit::<R>());
            [0, 1].map(|axis| centre[axis] + far * R::from_f64(direction[axis]))
        })
        .collect();
    let hole = corners.iter().map(|corner| {
        [0, 1].map(|axis| centre[axis] + R::from_f64(0.25) * (corner[axis] - centre[axis]))
    });
    let hole: Vec<[R; 2]> = hole.collect();
    let loops = [&corners[..], &hole];
    let count = 1 + source.below(2);
    let patch = Polygon::with_holes(&loops[..count], [Edge::default(); ROOM])
        .map_err(|error| format!("a star is refused: {error}"))?;
    match source.below(3) {
        0 => {
            let part = [(); 2].map(|()| R::from_f64(0.4 * source.unit::<f64>() - 0.2) / size);
            let slope = if source.is_mild() {
                part
            } else {
                [source.number(), source.number()]
            };
            let tilted = patch.with_slope(slope);
            tilted.map_or(Ok(()), |tilted| used(source, &tilted))
        }
        1 => {
            let [x, y] = [(); 2].map(|()| source.number::<R>());
            let place = [centre[0] + x, centre[1] + y];
            let shifted = patch.with_centre_of_pressure(place);
            shifted.map_or(Ok(()), |shifted| used(source, &shifted))
        }
        _ => used(source, &patch),
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

fn placed<R: Real>(centre: &nalgebra::Vector2<R>, radius: R) -> Result<(), Broken> {
    let fine = centre.x.is_finite() && centre.y.is_finite() && radius.is_finite();
    holds(
        fine && radius > R::ZERO,
        "a finite place and radius",
        &[centre.x, centre.y, radius],
    )
}

fn used<R: Real, K: PressureField<R>>(
    source: &mut Source,
    patch: &Shape<R, K>,
) -> Result<(), Broken> {
    let area = patch.area();
    holds(area > R::ZERO, "an area", &[area])?;
    placed(&patch.centre(), patch.radius())?;
    let gyration = patch.radius_of_gyration();
    holds(gyration >= R::ZERO, "a radius of gyration", &[gyration])?;
    if source.one_in(2) {
        rubs(source, patch)?;
        return resists(source, patch);
    }
    let Ok(set) = ShapeLimitSurface::new(*patch, source.size()) else {
        return Ok(());
    };
    holds(
        set.torque_limit() <= set.force_limit() * set.radius() * R::TWO,
        "no arm beyond the radius",
        &[set.torque_limit(), set.patch().radius()],
    )?;
    match source.below(3) {
        0 => asked(source, &set),
        1 => stepped(source, |body, twist, push, dt| {
            body.step(&set, twist, push, dt)
        }),
        _ => derived(source, &set),
    }
}

/// Friction at any motion, or the set of what is carried.
fn borne<R: Real>(source: &mut Source, patch: &impl PatchShape<R>) -> Result<(), Broken> {
    if source.one_in(2) {
        return rubs(source, patch);
    }
    match ShapeLimitSurface::new(patch, source.size()) {
        Ok(set) => asked(source, &set),
        Err(_) => Ok(()),
    }
}

/// Friction at any motion.
fn rubs<R: Real>(source: &mut Source, patch: &impl PatchShape<R>) -> Result<(), Broken> {
    let Ok(friction) = ShapeFriction::new(patch, source.size::<R>()) else {
        return Ok(());
    };
    let coefficient = friction.coefficient();
    holds(coefficient >= R::ZERO, "coefficient ≥ 0", &[coefficient])?;
    let (load, motion) = (source.size(), twist::<R>(source));
    let met = friction.wrench(load, &motion);
    let (same, jacobian) = friction.wrench_and_jacobian(load, &motion);
    let parts = [met.force.x, met.force.y, met.torque];
    let all = [motion.velocity.x, motion.velocity.y, motion.spin];
    if all.iter().any(|x| x.is_nan()) {
        return all_nan("wrench", parts);
    }
    if parts.iter().all(|x| !x.is_nan()) {
        holds(same == met, "the same wrench with its Jacobian", &parts)?;
    }
    finite(source, "Jacobian of a wrench", jacobian.iter().copied())?;
    dissipates(source, &met, &motion)
}

/// Friction of any power of the speed at any motion.
fn resists<R: Real>(source: &mut Source, patch: &impl PowerLawPatch<R>) -> Result<(), Broken> {
    let alpha = if source.is_mild() {
        R::from_f64(2.5 * source.unit::<f64>() - 0.5)
    } else {
        source.number()
    };
    let Ok(power) = PolygonPowerLaw::new(alpha) else {
        let is_in = alpha > -R::ONE && alpha.to_f64() <= PolygonPowerLaw::<R>::MAX_EXPONENT;
        return holds(!is_in, "an exponent in range is taken", &[alpha]);
    };
    let Ok(friction) = ShapePowerFriction::new(patch, source.size::<R>(), power) else {
        return Ok(());
    };
    let own = [friction.power().alpha(), friction.coefficient()];
    let fits = own[0] == alpha && own[1] >= R::ZERO && friction.patch().radius() > R::ZERO;
    holds(fits, "its parts", &own)?;
    let (load, motion) = (source.size(), twist::<R>(source));
    let met = friction.wrench(load, &motion);
    let (same, jacobian) = friction.wrench_and_jacobian(load, &motion);
    let parts = [met.force.x, met.force.y, met.torque];
    let all = [motion.velocity.x, motion.velocity.y, motion.spin];
    if all.iter().any(|x| x.is_nan()) {
        return all_nan("wrench", parts);
    }
    if parts.iter().all(|x| !x.is_nan()) {
        holds(same == met, "the same wrench with its Jacobian", &parts)?;
    }
    // A weakening law's derivatives grow without bound towards rest.
    if alpha >= R::ONE {
        finite(source, "Jacobian of a power", jacobian.iter().copied())?;
    }
    dissipates(source, &met, &motion)
}

/// The derivatives at any push.
fn derived<R: Real, P: PatchShape<R>>(
    source: &mut Source,
    set: &ShapeLimitSurface<R, P>,
) -> Result<(), Broken> {
    let (push, length) = (wrench::<R>(source), source.positive::<R>());
    let (normal, curvature) = set.gauge_derivatives(&push);
    let (carried, rate) = set.project_with_jacobian(&push, length);
    let parts = [push.force.x, push.force.y, push.torque];
    if let Some([low, high]) = set.torque_limits([push.force.x, push.force.y]) {
        let is_ordered = low <= high || parts[0].is_nan() || parts[1].is_nan();
        holds(
            is_ordered || !source.is_mild(),
            "torques in their order",
            &[low, high],
        )?;
    }
    if parts.iter().any(|x| x.is_nan()) {
        return all_nan("normal", [normal.spin]);
    }
    if set.contains(&push) {
        let stays = set.project(&push).wrench == push;
        holds(stays || !source.is_mild(), "a carried wrench stays", &parts)?;
    }
    let near = carried.wrench;
    finite(
        source,
        "projection",
        [near.force.x, near.force.y, near.torque],
    )?;
    if set.force_limit() > R::ZERO && parts.iter().any(|x| *x != R::ZERO) {
        finite(source, "normal", [normal.spin])?;
        finite(source, "curvature", curvature.iter().copied())?;
        finite(source, "rate", rate.iter().copied())?;
    }
    Ok(())
}
