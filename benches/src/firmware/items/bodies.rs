//! Items built on a coupling: patches with dimensions, limit surfaces, motions.

use super::{BOTH, Code, Item, NARROW, item, round};

/// Modules of every item built on the disk's Coulomb table.
macro_rules! on_form {
    ($($more:literal),*) => {
        round!("coupling::coulomb coupling::coulomb::form coupling::coulomb::terms special::log_part special::log_quotient coupling::batch::ways" $(, $more)*)
    };
}

/// The same with the modules of the limit surface.
macro_rules! surface {
    () => {
        on_form!("limit_surface limit_surface::round limit_surface::searches limit_surface::meridian limit_surface::polar limit_surface::ratio_search coupling::coulomb::curve limit_surface::curve_approximation limit_surface::curve_point")
    };
}

const WRENCH: &str = "whole(&object.wrench(given.load, &given.twist))";
const TALL_WRENCH: &str = "whole(&object.wrench(given.load, &given.twist).wrench)";
const SURFACE: &str = "RoundLimitSurface::new(coulomb::CoulombDisk, 1.0 as R, 1.0).ok()?";
const PROJECTION: &str = "whole(&object.project(&given.push).wrench)";

/// Each with the fitted form of Coulomb friction, unless named otherwise.
pub const BODIES: [Item; 10] = [
    item(
        ["body", "disk with dimensions"],
        BOTH,
        on_form!(),
        Code::new("disk(coulomb::CoulombDisk)?", WRENCH),
    ),
    item(
        ["body", "tall: front-back"],
        NARROW,
        on_form!("coupling::load_transfer"),
        Code::new(
            "LoadTransferFriction::<_, _, LongitudinalGradient>::new(disk(coulomb::CoulombDisk)?, 0.25).ok()?",
            TALL_WRENCH,
        ),
    ),
    item(
        ["body", "tall: all round"],
        NARROW,
        on_form!("coupling::load_transfer"),
        Code::new(
            "LoadTransferFriction::<_, _, FullGradient>::new(disk(coulomb::CoulombDisk)?, 0.25).ok()?",
            TALL_WRENCH,
        ),
    ),
    item(
        ["limit surface", "gauge"],
        NARROW,
        surface!(),
        Code::new(SURFACE, "object.gauge(&given.push)"),
    ),
    item(
        ["limit surface", "projection"],
        BOTH,
        surface!(),
        Code::new(SURFACE, PROJECTION),
    ),
    item(
        ["limit surface", "ellipsoid: projection"],
        NARROW,
        "limit_surface limit_surface::ellipsoid limit_surface::round limit_surface::searches limit_surface::meridian limit_surface::polar limit_surface::ratio_search coupling::coulomb::curve limit_surface::curve_approximation limit_surface::curve_point",
        Code::new(
            "LimitEllipsoid::new(1.0 as R, 1.0, 0.625).ok()?",
            PROJECTION,
        ),
    ),
    item(
        ["motion", "final modes"],
        NARROW,
        on_form!("modes"),
        Code::new(
            "coulomb::CoulombDisk",
            "TerminalMotion::new(*object, b).ok().and_then(|modes| modes.finite_fixed_point()).unwrap_or(0.0)",
        ),
    ),
    item(
        ["motion", "slider to rest"],
        BOTH,
        on_form!(
            "modes slider slider::rest slider::direction_arc slider::march slider::march::arcs slider::march::finish slider::march::panel slider::march::rates slider::gauss_legendre slider::final_decay special::legendre"
        ),
        Code::new(
            "slider()?",
            "object.to_rest(&given.motion).map_or(0.0, |rest| state(&rest.motion))",
        ),
    ),
    item(
        ["motion", "slider: a given time"],
        NARROW,
        on_form!(
            "modes slider slider::rest slider::advance slider::runge_kutta slider::short_f32 slider::direction_arc slider::march slider::march::arcs slider::march::finish slider::march::panel slider::march::rates slider::gauss_legendre slider::final_decay special::legendre"
        ),
        Code::new(
            "slider()?",
            "state(&object.advance(&given.motion, given.duration).motion)",
        ),
    ),
    item(
        ["motion", "slider: Verlet step"],
        BOTH,
        on_form!("slider slider::verlet"),
        Code::new(
            "slider()?",
            "state(&object.verlet_step(&given.motion, given.duration))",
        ),
    ),
];
