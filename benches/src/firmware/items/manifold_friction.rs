//! Friction of an engine's manifolds: one projection for each outline, and what stands beside it.

use super::{BOTH, Code, Item, NARROW, item};

/// Modules of one projection.
macro_rules! projection {
    ($($more:literal),*) => {
        concat!(
            "manifold_friction manifold_friction::outline manifold_friction::project",
            $(" ", $more),*
        )
    };
}

/// One projection a call; what the outline needs is prepared.
pub const MANIFOLD_FRICTION: [Item; 6] = [
    item(
        ["manifold friction", "compact area"],
        BOTH,
        projection!(),
        Code::new(
            "IsotropicLimitCurve::<R>::area()",
            "whole_impulse(&carried(object, &given.push, given.load))",
        ),
    ),
    item(
        ["manifold friction", "ellipsoid"],
        NARROW,
        projection!(),
        Code::new(
            "IsotropicLimitCurve::<R>::ellipsoid()",
            "whole_impulse(&carried(object, &given.push, given.load))",
        ),
    ),
    item(
        ["manifold friction", "area of the corners"],
        NARROW,
        projection!("manifold_friction::area"),
        Code::new(
            "ManifoldArea::of_corners(&[[-a, -b], [a, -b], [a, b], [-a, b]]).outline",
            "whole_impulse(&carried(object, &given.push, given.load))",
        ),
    ),
    item(
        ["manifold friction", "making an area of four corners"],
        NARROW,
        "manifold_friction manifold_friction::area manifold_friction::outline",
        Code::new(
            "[[-a, -b], [a, -b], [a, b], [-a, b]]",
            "{ object[2] = [given.a, given.b]; black_box(ManifoldArea::of_corners(object)).torsion_radius }",
        ),
    ),
    item(
        ["manifold friction", "compact area, two coefficients"],
        NARROW,
        projection!("manifold_friction::anisotropy"),
        Code::new(
            "AnisotropicFriction::new([a, b])",
            concat!(
                "{ let last = FrictionImpulse { tangential: [0.0, 0.0], angular: 0.0 };",
                " let motion = &given.twist;",
                " let moved = [motion.velocity.x, motion.velocity.y];",
                " let pushed = object.candidate(&last, moved, motion.spin, &MASSES);",
                " let carried = carried_of(&IsotropicLimitCurve::area(), &pushed, object.largest() * given.load);",
                " whole_impulse(&object.unstretched(&carried)) }",
            ),
        ),
    ),
    item(
        ["manifold friction", "rolling beside it"],
        NARROW,
        "manifold_friction manifold_friction::rolling",
        Code::new("()", "project_rolling([given.a, given.b], given.load)[0]"),
    ),
];
