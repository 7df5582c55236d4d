//! The areas of a body's colliders.

use crate::feet::PlacedFoot;
use rapier2d::parry::bounding_volume::Aabb;
use rapier2d::prelude::*;
use std::sync::Arc;
use tribos_core::real::Real;
use tribos_feet::Footprint;

/// Corners up to which a rounded shape is fine.
const MOST_CORNERS: usize = 38;

/// The feet of a body by the shapes of its colliders, with what they were derived from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Derived {
    from: Vec<Source>,
    pub(crate) feet: Arc<[PlacedFoot]>,
}

/// What the foot of a collider depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Source {
    /// Address of the shape.
    shape: usize,
    bounds: Aabb,
    pose: Pose,
    mass: f32,
}

impl Source {
    fn of(collider: &Collider) -> Option<Self> {
        let carries = collider.is_enabled() && !collider.is_sensor();
        let pose = collider.position_wrt_parent().filter(|_| carries)?;
        let shape = collider.shared_shape();
        Some(Self {
            shape: Arc::as_ptr(&shape.0).cast::<()>() as usize,
            bounds: shape.compute_local_aabb(),
            pose: *pose,
            mass: collider.mass(),
        })
    }
}

impl Derived {
    /// Derives the feet anew if colliders, their shapes, places or masses have changed.
    pub(crate) fn renew(&mut self, body: &RigidBody, colliders: &ColliderSet) {
        let parts = || {
            body.colliders()
                .iter()
                .filter_map(|&part| colliders.get(part))
        };
        if parts().filter_map(Source::of).eq(self.from.iter().copied()) {
            return;
        }
        self.from = parts().filter_map(Source::of).collect();
        let mut feet = Vec::new();
        for collider in parts() {
            if let Some(Source { pose, mass, .. }) = Source::of(collider) {
                add_feet(collider.shape(), &pose, mass, &mut feet);
            }
        }
        // Without masses of their own, colliders share the load evenly.
        let have_mass = |foot: &PlacedFoot| foot.share > 0.0;
        if feet.iter().any(have_mass) {
            feet.retain(have_mass);
        } else {
            feet.iter_mut().for_each(|foot| foot.share = 1.0);
        }
        self.feet = feet.into();
    }
}

/// Adds the areas of a shape with this mass. Shapes without area carry nothing.
fn add_feet(shape: &dyn Shape, pose: &Pose, mass: f32, feet: &mut Vec<PlacedFoot>) {
    if let TypedShape::Compound(compound) = shape.as_typed_shape() {
        let parts = compound.shapes();
        let areas = parts
            .iter()
            .map(|(_, part)| part.mass_properties(1.0).mass());
        let whole: f32 = areas.clone().sum();
        for ((place, part), area) in parts.iter().zip(areas) {
            add_feet(&*part.0, &(pose * place), mass * (area / whole), feet);
        }
        return;
    }
    let found = footprint(shape);
    feet.extend(found.map(|(footprint, place)| PlacedFoot {
        footprint,
        pose: pose * &place,
        share: mass,
    }));
}

/// The area of a simple shape about its middle, and its place in the shape's frame.
fn footprint(shape: &dyn Shape) -> Option<(Footprint, Pose)> {
    match shape.as_typed_shape() {
        TypedShape::Ball(ball) => Some((Footprint::disk(ball.radius).ok()?, Pose::identity())),
        TypedShape::Cuboid(cuboid) => polygon(&corners(cuboid.half_extents), 0.0),
        TypedShape::RoundCuboid(round) => {
            let half = round.inner_shape.half_extents;
            polygon(&corners(half), round.border_radius)
        }
        TypedShape::Capsule(capsule) => {
            polygon(&[capsule.segment.a, capsule.segment.b], capsule.radius)
        }
        TypedShape::Triangle(triangle) => polygon(triangle.vertices(), 0.0),
        TypedShape::RoundTriangle(round) => {
            polygon(round.inner_shape.vertices(), round.border_radius)
        }
        TypedShape::ConvexPolygon(convex) => polygon(convex.points(), 0.0),
        TypedShape::RoundConvexPolygon(round) => {
            polygon(round.inner_shape.points(), round.border_radius)
        }
        TypedShape::Segment(segment) => {
            let half = 0.5 * (segment.b - segment.a);
            let rotation = Rotation::from_rotation_arc(Vector::X, half.try_normalize()?);
            let place = Pose::from_parts(segment.a + half, rotation);
            Some((Footprint::bar(half.length()).ok()?, place))
        }
        _ => None,
    }
}

fn corners(half: Vector) -> [Vector; 4] {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| Vector::new(x, y) * half)
}

/// A convex polygon with its corners rounded by a radius; two points are a rounded segment.
fn polygon(points: &[Vector], border: f32) -> Option<(Footprint, Pose)> {
    let turns = if signed_area(points) < 0.0 { -1.0 } else { 1.0 };
    let outline = match border > 0.0 {
        true => rounded(points, border, turns),
        false => points.to_vec(),
    };
    let corners: Vec<[f32; 2]> = outline.into_iter().map(Into::into).collect();
    let (footprint, middle) = Footprint::convex(&corners).ok()?;
    Some((footprint, Pose::from_translation(middle.into())))
}

/// Each corner becomes an arc of points, on a circle such that the arc's area is kept.
fn rounded(points: &[Vector], border: f32, turns: f32) -> Vec<Vector> {
    let sides = points.len();
    let most = MOST_CORNERS / sides;
    let halvings = if most > 4 { 2 } else { most / 3 };
    let out = |from: usize| {
        let along = points[(from + 1) % sides] - points[from];
        (-turns * along.perp()).try_normalize()
    };
    let mut outline = Vec::new();
    for at in 0..sides {
        let (Some(before), Some(after)) = (out((at + sides - 1) % sides), out(at)) else {
            continue;
        };
        let mut arc = vec![before, after];
        for _ in 0..halvings {
            let mut finer = vec![arc[0]];
            for pair in arc.windows(2) {
                finer.extend([between(pair[0], pair[1], turns), pair[1]]);
            }
            arc = finer;
        }
        let sine = arc[0].perp_dot(arc[1]).abs();
        let scale = if sine > 0.0 {
            (Real::asin(sine) / sine).sqrt()
        } else {
            1.0
        };
        outline.extend(
            arc.into_iter()
                .map(|out| points[at] + out * (border * scale)),
        );
    }
    outline
}

/// The direction halfway from one to another, up to half a turn.
fn between(from: Vector, to: Vector, turns: f32) -> Vector {
    match from.dot(to) > 0.0 {
        true => (from + to).normalize(),
        false => ((from - to).perp() * turns).normalize(),
    }
}

/// Area of a polygon in m², negative if its corners run clockwise.
fn signed_area(corners: &[Vector]) -> f32 {
    let cross = |(a, b): (&Vector, &Vector)| 0.5 * a.perp_dot(*b);
    corners
        .iter()
        .zip(corners.iter().cycle().skip(1))
        .map(cross)
        .sum()
}
