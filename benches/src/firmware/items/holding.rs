//! What holds: bonds before sliding, elastic contacts, and the question whether a push is held.

use super::{Code, Item, NARROW, item, round};

const fn bond(name: &'static str, modules: &'static str, prepare: &'static str) -> Item {
    item(
        ["bond", name],
        NARROW,
        modules,
        Code::new(prepare, "object.friction(a)"),
    )
}

/// The modules of an ellipsoid's projection with those named.
macro_rules! ellipsoid {
    ($more:literal) => {
        concat!(
            "limit_surface limit_surface::ellipsoid limit_surface::round limit_surface::searches limit_surface::meridian limit_surface::polar limit_surface::ratio_search coupling::coulomb::curve limit_surface::curve_approximation limit_surface::curve_point ",
            $more
        )
    };
}

const ELLIPSOID: &str = "LimitEllipsoid::new(1.0 as R, 1.0, 0.625).ok()?";
const ON_ELLIPSOID: &str =
    "(LimitEllipsoid::new(1.0 as R, 1.0, 0.625).ok()?, Presliding::new(64.0, 32.0).ok()?)";

/// Bonds by one law each; the rest on the ellipsoid, beside its projection in the limit surfaces.
pub const HOLDING: [Item; 12] = [
    bond(
        "exponential",
        "bond::exponential law",
        "ExponentialBond::new(2.0, b).ok()?",
    ),
    bond(
        "Weibull",
        "bond::weibull law",
        "WeibullBond::new(2.0, b, 4.0).ok()?",
    ),
    bond(
        "saturating",
        "bond::saturating law",
        "PlasticBond::new(2.0, b).ok()?",
    ),
    bond(
        "one strength",
        "bond::one_strength",
        "BrittleBond::new(2.0, b).ok()?",
    ),
    bond(
        "re-forming",
        "bond::re_forming bond::renewal law",
        "ReformingBond::new(2.0, b, 16).ok()?",
    ),
    item(
        ["bond", "three points: wrench"],
        NARROW,
        "bond::bonds bond::exponential coupling::nodes law patch::nodes",
        Code::new(
            "Bonds::new(ExponentialBond::new(2.0, 1.0).ok()?, feet(b)?).ok()?",
            "whole(&object.wrench(given.load, &given.twist))",
        ),
    ),
    item(
        ["holding", "holds, slips or undecided: disk"],
        NARROW,
        round!(
            "coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways holding limit_surface limit_surface::round limit_surface::searches limit_surface::meridian limit_surface::polar limit_surface::ratio_search coupling::coulomb::curve limit_surface::curve_approximation limit_surface::curve_point"
        ),
        Code::new(
            "(RoundLimitSurface::new(coulomb::CoulombDisk, 1.0 as R, 1.0).ok()?, RoundLimitSurface::new(coulomb::CoulombDisk, 1.5 as R, 1.0).ok()?)",
            "StictionBounds::of(&object.0, &object.1, &given.push).certain_scale()",
        ),
    ),
    item(
        ["holding", "scaled set: projection"],
        NARROW,
        ellipsoid!("limit_surface::scaled"),
        Code::new(
            ELLIPSOID,
            "ScaledSet::new(&*object, b).map_or(R::NAN, |set| whole(&set.project(&given.push).wrench))",
        ),
    ),
    item(
        ["holding", "presliding"],
        NARROW,
        ellipsoid!("presliding::stiffness presliding::pose presliding::step"),
        Code::new(
            ON_ELLIPSOID,
            "whole(&object.1.step(&object.0, &Anchor::at(Pose::new(0.0, 0.0, 0.0)), &pose(&given.twist)).friction)",
        ),
    ),
    item(
        ["holding", "gradual presliding"],
        NARROW,
        ellipsoid!(
            "presliding::stiffness presliding::microslip presliding::pose presliding::root presliding::step"
        ),
        Code::new(
            "(LimitEllipsoid::new(1.0 as R, 1.0, 0.625).ok()?, MicroslipPresliding::new(Presliding::new(64.0, 32.0).ok()?, 0.25, 1.0).ok()?)",
            "whole(&object.1.step(&object.0, &Anchor::at(Pose::new(0.0, 0.0, 0.0)), [&Pose::new(0.0, 0.0, 0.0), &pose(&given.twist)]).friction)",
        ),
    ),
    item(
        ["holding", "presliding of three points"],
        NARROW,
        "patch::nodes presliding::nodes presliding::pose",
        Code::new(
            "PointPresliding::<R, _, 3>::new(feet(b)?, 64.0, 1.0, &Pose::new(0.0, 0.0, 0.0)).ok()?",
            "whole(&object.step(&pose(&given.twist)).friction)",
        ),
    ),
    item(
        ["holding", "body on elastic bonds"],
        NARROW,
        ellipsoid!(
            "planar planar::elastic presliding::stiffness presliding::pose presliding::step"
        ),
        Code::new(
            "(LimitEllipsoid::new(1.0 as R, 1.0, 0.625).ok()?, Presliding::new(64.0, 32.0).ok()?, PlanarBody::new(1.0, 0.5).ok()?, TimeStep::new(0.0625).ok()?)",
            "whole(&object.2.step_elastic(&object.1, &object.0, &ElasticState { twist: given.twist, ..ElasticState::at_rest(Pose::new(0.0, 0.0, 0.0)) }, &given.push, object.3).friction)",
        ),
    ),
];
