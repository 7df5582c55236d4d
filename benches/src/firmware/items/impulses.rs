//! Impulses of contacts: one update of a ball on a plate or another ball, and a manifold of two.

use super::{BOTH, Code, Item, NARROW, item, round};

/// Modules of one contact under thresholds.
macro_rules! impulse {
    ($($more:literal),*) => {
        concat!(
            "contact contact::block contact::body contact::update contact::disc contact::friction ",
            "contact::modes contact::normal contact::geometry contact::vector",
            $(" ", $more),*
        )
    };
}

/// Modules of a contact under the exact coupled set.
macro_rules! exact {
    ($($more:literal),*) => {
        round!(
            "coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways",
            "limit_surface limit_surface::round limit_surface::searches limit_surface::meridian limit_surface::polar limit_surface::ratio_search coupling::coulomb::curve limit_surface::curve_approximation limit_surface::curve_point",
            "contact contact::block contact::body contact::update contact::coupled",
            "contact::friction contact::modes contact::normal contact::sliding_rolling",
            "contact::geometry contact::vector" $(, $more)*
        )
    };
}

/// Modules of a contact under the ellipsoid.
macro_rules! ellipsoid {
    () => {
        impulse!(
            "limit_surface limit_surface::ellipsoid limit_surface::round",
            "limit_surface::searches limit_surface::meridian limit_surface::polar limit_surface::ratio_search coupling::coulomb::curve limit_surface::curve_approximation limit_surface::curve_point",
            "contact::coupled contact::sliding_rolling"
        )
    };
}

const fn struck(
    name: &'static str,
    precisions: &'static [&'static str],
    modules: &'static str,
    prepare: &'static str,
) -> Item {
    let code = Code::new(prepare, "object.update()").with_ready("object.ready(given)");
    item(["impulse", name], precisions, modules, code)
}

/// One update in every set of modes; the contact's masses and directions are prepared.
pub const IMPULSES: [Item; 11] = [
    struck(
        "frictionless",
        NARROW,
        impulse!(),
        "Struck::on_floor(IndependentFriction::none())?",
    ),
    struck(
        "sliding",
        BOTH,
        impulse!(),
        "Struck::on_floor(IndependentFriction::sliding(b).ok()?)?",
    ),
    struck(
        "sliding, torsion",
        NARROW,
        impulse!(),
        "Struck::on_floor(IndependentFriction::sliding_torsion(b, b).ok()?)?",
    ),
    struck(
        "sliding, rolling",
        NARROW,
        impulse!("contact::sliding_rolling"),
        "Struck::on_floor(IndependentFriction::sliding_rolling(b, a).ok()?)?",
    ),
    struck(
        "sliding, rolling, torsion",
        BOTH,
        impulse!("contact::sliding_rolling"),
        "Struck::on_floor(IndependentFriction::all(b, a, b).ok()?)?",
    ),
    struck(
        "sliding, rolling, torsion: two balls",
        NARROW,
        impulse!("contact::sliding_rolling"),
        "Struck::on_ball(IndependentFriction::all(b, a, b).ok()?)?",
    ),
    struck(
        "coupled: exact",
        NARROW,
        exact!(),
        "Struck::on_floor(CoupledFriction::sliding_torsion(RoundLimitSurface::new(coulomb::CoulombDisk, b, 0.5).ok()?))?",
    ),
    struck(
        "coupled: exact, and rolling",
        NARROW,
        exact!("contact::disc"),
        "Struck::on_floor(CoupledFriction::all(RoundLimitSurface::new(coulomb::CoulombDisk, b, 0.5).ok()?, a).ok()?)?",
    ),
    struck(
        "coupled: ellipsoid",
        NARROW,
        ellipsoid!(),
        "Struck::on_floor(CoupledFriction::sliding_torsion(LimitEllipsoid::new(b, 0.5, 0.625).ok()?))?",
    ),
    struck(
        "coupled: ellipsoid, and rolling",
        NARROW,
        ellipsoid!(),
        "Struck::on_floor(CoupledFriction::all(LimitEllipsoid::new(b, 0.5, 0.625).ok()?, a).ok()?)?",
    ),
    item(
        ["impulse", "manifold: sliding"],
        BOTH,
        impulse!("manifold manifold::impact manifold::member manifold::solve contact::time_step"),
        Code::new(
            "Gripped::new(IndependentFriction::sliding(b).ok()?)?",
            "object.solve()",
        )
        .with_ready("object.ready(given)"),
    ),
];
