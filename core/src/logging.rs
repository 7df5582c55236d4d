//! `defmt::Format` of the types for which it cannot be derived: those with vectors of nalgebra, and
//! tables, whose numbers are left out.

use crate::contact::internals::{InPlane, PreparedContact, TangentialLoad};
use crate::contact::{Contact, ContactGeometry, ContactModes, ContactVector, SphereBody, WallBody};
use crate::coupling::disk::Disk;
use crate::coupling::flat::{Motion, PatchShape, PointLoad, PolygonPowerLaw, Reduced, SplitMotion};
use crate::coupling::load_transfer::LoadTransferWrench;
use crate::coupling::round::{LateralPolynomialTable, PolynomialTable, RoundTable};
use crate::coupling::table::Table;
use crate::coupling::{
    DryReducedFriction, LateralFriction, PowerLawFriction, compact::CompactPower,
};
use crate::floor::{Feet, FloorStep, Foot, SteadyMotion, SteadyState};
use crate::limit_surface::{
    FrictionSet, LimitEllipsoid, RoundLimitSurface, ShapeLimitSurface, UnknownPressureSet,
};
use crate::patch::affine_image::AffineMap;
use crate::patch::anisotropic::{AnisotropicPatch, AxisCoefficients};
use crate::patch::arcs::{ArcOutline, Side};
use crate::patch::bar::Bar;
use crate::patch::ellipse::Ellipse;
use crate::patch::feet::CompoundPatch;
use crate::patch::mesh::{Mesh, Triangle};
use crate::patch::nodes::{NodeBuffer, NodeList, NodePatch, NodeSlice};
use crate::patch::outline::{Edge, Polygon, PressureField};
use crate::patch::piece::HalfPlane;
use crate::patch::points::PointPatch;
use crate::patch::round::RoundPatch;
use crate::planar::{ElasticState, ElasticStep, PlanarStep, PointContacts};
use crate::presliding::{
    Anchor, PointPresliding, PointPreslidingStep, Pose, PreslidingStep, Settled,
};
use crate::real::Real;
use crate::twist::{Displacement, Twist, Wrench};
use defmt::{Format, Formatter, write};
use nalgebra::Vector3;

/// A vector by its components.
struct Components<R>(Vector3<R>);

/// `Format` of each type: its generics, then the text and the values in it.
macro_rules! formats {
    ($([$($generics:tt)*] $type:ty: |$this:ident| $text:literal, $($value:expr),*;)*) => {
        $(
            impl<$($generics)*> Format for $type {
                fn format(&self, f: Formatter) {
                    let $this = self;
                    write!(f, $text, $($value),*);
                }
            }
        )*
    };
}

formats! {
    [R: Real + Format] Components<R>: |v| "[{}, {}, {}]", v.0.x, v.0.y, v.0.z;
    [R: Real + Format] Twist<R>: |t| "twist [{}, {}; {}]", t.velocity.x, t.velocity.y, t.spin;
    [R: Real + Format] Wrench<R>: |w| "wrench [{}, {}; {}]", w.force.x, w.force.y, w.torque;
    [R: Real + Format] Displacement<R>: |d| "displacement [{}, {}; {}]",
        d.shift.x, d.shift.y, d.turn;
    [R: Real + Format] Pose<R>: |p| "pose [{}, {}; {}]", p.position.x, p.position.y, p.angle;
    [R: Real + Format] Anchor<R>: |a| "anchor at {}", a.pose;
    [R: Real + Format] Settled<R>: |s| "{} under {}, slip {}, dissipated {}, {}",
        s.strain, s.friction, s.slip, s.dissipated, s.grip;
    [R: Real + Format] PreslidingStep<R>: |s| "{} under {}, slip {}, dissipated {}, {}",
        s.anchor, s.friction, s.slip, s.dissipated, s.grip;
    [R: Real + Format] PointPreslidingStep<R>: |s| "under {}, dissipated {}, {} points slip",
        s.friction, s.dissipated, s.slipping;
    [R: Real + Format, P: NodePatch<R>, const CAPACITY: usize] PointPresliding<R, P, CAPACITY>: |p|
        "bonds of {} points, stiffness {}, limit {}",
        p.patch().nodes().len(), p.stiffness(), p.force_limit();
    [R: Real + Format] SphereBody<R>: |s| "sphere at velocity {}, spin {}, 1/m {}, 1/I {}",
        Components(s.velocity), Components(s.spin), s.inv_mass, s.inv_inertia;
    [R: Real + Format] WallBody<R>: |p| "plate at velocity {}, 1/m {}",
        Components(p.velocity), p.inv_mass;
    [R: Real + Format] TangentialLoad<R>: |l| "sliding {}, torsion {}",
        Components(l.sliding), l.torsion;
    [R: Real + Format] InPlane<R>: |v| "{}", Components(v.0);
    [R: Real + Format, M: ContactModes<R>] ContactVector<R, M>: |m|
        "normal {}, sliding {}, rolling {}, torsion {}",
        m.normal, Components(m.sliding()), Components(m.rolling()), m.torsion();
    [R: Real + Format] ContactGeometry<R>: |t| "touch along {}, gap {}", Components(t.normal), t.gap;
    [R: Real + Format, M: ContactModes<R>] Contact<R, M>: |c|
        "contact along {}, bound {}, impulse {}",
        Components(*c.normal()), c.bound(), c.impulse();
    [R: Real + Format] PreparedContact<R>: |c| "prepared contact along {}, {}",
        Components(c.normal), c.block;
    [R: Real + Format] LoadTransferWrench<R>: |w| "{}, lean [{}, {}], lifts: {}",
        w.wrench, w.lean.x, w.lean.y, w.is_lifting;
    [R: Real + Format, C: DryReducedFriction<R> + Format] RoundLimitSurface<R, C>: |s|
        "limit surface of {}, force {}, radius {}", s.coupling(), s.force_limit(), s.radius();
    [R: Real + Format] LimitEllipsoid<R>: |e| "ellipsoid of force {}, torque {}, radius {}",
        e.force_limit(), e.torque_limit(), e.radius();
    [R: Real + Format, const CELLS: usize, const TERMS: usize] Table<R, CELLS, TERMS>: |t|
        "table of the disk, exponent {}", t.exponent();
    [R: Real + Format, const CELLS: usize, const TERMS: usize] Disk<R, CELLS, TERMS>: |t|
        "table of the disk without a power, exponent {}", t.exponent();
    [R: Real + Format, const CELLS: usize, const TERMS: usize] RoundTable<R, CELLS, TERMS>: |t|
        "table of exponent {}, mean r² {}", t.exponent(), t.mean_square_radius();
    [] PolynomialTable: |t| "table of a polynomial pressure, exponent {}", t.exponent();
    [] LateralPolynomialTable: |t| "table of exponent {}, mean r² {}",
        t.exponent(), t.mean_square_radius();
    [R: Real + Format] CompactPower<R>: |p| "compact, exponent {}, mean r² {}",
        p.exponent(), p.mean_square_radius();
    [R: Real + Format, const CAPACITY: usize] NodeList<R, CAPACITY>: |l| "{}", l.nodes();
    [R: Real + Format] NodeSlice<'_, R>: |s| "nodes {}", s.nodes();
    [R: Real + Format] NodeBuffer<'_, R>: |b| "nodes {}", b.nodes();
    [R: Real + Format, S: AsRef<[Edge<R>]>, K: PressureField<R>] Polygon<R, S, K>: |p|
        "polygon of {} edges, radius {}", p.edges().len(), p.radius();
    [R: Real + Format, S: AsRef<[Triangle<R>]>] Mesh<R, S>: |m|
        "mesh of {} triangles, radius {}", m.triangles().len(), m.radius();
    [R: Real + Format, P: NodePatch<R>] PointPatch<R, P>: |p|
        "{} points, radius {}", p.nodes().nodes().len(), p.radius();
    [R: Real + Format, P: PatchShape<R>] CompoundPatch<'_, R, P>: |f|
        "{} feet, radius {}", f.feet().len(), f.radius();
    [R: Real + Format] PointLoad<R>: |p| "share {} at [{}, {}]", p.share, p.place.x, p.place.y;
    [R: Real + Format, K: PressureField<R>] Bar<R, K>: |b| "bar, radius {}", b.radius();
    [R: Real + Format] Side<R>: |s| "arc: {}", s.is_arc();
    [R: Real + Format, S: AsRef<[Side<R>]>] ArcOutline<R, S>: |p|
        "patch of {} sides, radius {}", p.sides().len(), p.radius();
    [R: Real + Format] Ellipse<R>: |e| "ellipse of semi-axes [{}, {}], pressure {}",
        e.semi_axes()[0], e.semi_axes()[1], e.pressure();
    [R: Real + Format] AffineMap<R>: |m| "rows [{}, {}], [{}, {}], shift [{}, {}]",
        m.rows[0].x, m.rows[0].y, m.rows[1].x, m.rows[1].y, m.shift.x, m.shift.y;
    [R: Real + Format] AxisCoefficients<R>: |c| "coefficients [{}, {}]", c.mu()[0], c.mu()[1];
    [R: Real + Format, P: Format] AnisotropicPatch<R, P>: |p|
        "{} stretched, shares [{}, {}]", p.stretched, p.shares[0], p.shares[1];
    [R: Real + Format, C: Format] RoundPatch<R, C>: |p| "round patch of {}, radius {}",
        p.coupling(), p.radius();
    [R: Real + Format] HalfPlane<R>: |h| "half-plane along [{}, {}]", h.along.x, h.along.y;
    [R: Real + Format, P: Format] Foot<R, P>: |f| "{}, limit {}, surface {}",
        f.patch, f.limit, f.surface;
    [R: Real + Format, P: PatchShape<R>] Feet<'_, R, P>: |f| "{} feet", f.feet().len();
    [R: Real + Format] SteadyMotion<R>: |m| "{} under {}, carried by {}",
        m.twist, m.friction, m.carried_by;
    [R: Real + Format] SteadyState<R>: |s| "{}", match s {
        SteadyState::Balanced(motion) | SteadyState::Missed(motion) => Some(*motion),
        SteadyState::Accelerates => None,
    };
    [R: Real + Format] FloorStep<R>: |s| "{} under {}, carried by {}, imbalance {}",
        s.twist, s.friction, s.carried_by, s.imbalance;
    [R: Real + Format, P: PatchShape<R>] ShapeLimitSurface<R, P>: |s|
        "limit surface of force {}, torque {}, radius {}",
        s.force_limit(), s.torque_limit(), s.radius();
    [R: Real + Format, S: AsRef<[[R; 2]]>] UnknownPressureSet<R, S>: |s|
        "support of force {}, centre [{}, {}], radius {}",
        s.force_limit(), s.centre().x, s.centre().y, s.radius();
    [R: Real + Format] Reduced<R>: |r| "force [{}, {}], torque {}", r.force.x, r.force.y, r.torque;
    [R: Real + Format] PolygonPowerLaw<R>: |p| "prepared law of exponent {}", p.alpha();
    [R: Real + Format] Motion<R>: |m| "{}",
        Components(Vector3::new(m.velocity.x, m.velocity.y, m.rim));
    [R: Real + Format] SplitMotion<R>: |m| "{}", match m {
        SplitMotion::Turns { centre, spin } => Components(Vector3::new(centre.x, centre.y, *spin)),
        SplitMotion::Slides { direction, turn, .. } => {
            Components(Vector3::new(direction.x, direction.y, *turn))
        }
    };
    [R: Real + Format] PlanarStep<R>: |s| "{} under {}, at rest: {}",
        s.twist, s.friction, s.is_at_rest;
    [R: Real + Format] ElasticState<R>: |s| "{}, {}, {}", s.pose, s.twist, s.anchor;
    [R: Real + Format] ElasticStep<R>: |s| "{} under {}, slip {}, lost {}, {}",
        s.state, s.friction, s.slip, s.lost_energy(), s.grip;
    [R: Real + Format, P: NodePatch<R>, const CAPACITY: usize] PointContacts<R, P, CAPACITY>: |p|
        "foot of {} points, limit {}", p.patch().nodes().len(), p.force_limit();
}
