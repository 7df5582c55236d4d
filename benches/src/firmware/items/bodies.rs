//! Items built on a coupling: patches with dimensions, limit surfaces, motions.

use super::{BOTH, Code, Item, NARROW, item, round};

/// Modules of every item built on the disk's Coulomb table.
macro_rules! on_table {
    ($($more:literal),*) => {
        round!("coupling::table coupling::disk coupling::tip special::log_quotient coupling::side coupling::batch::ways" $(, $more)*)
    };
}

/// The same with the modules of the limit surface.
macro_rules! surface {
    () => {
        on_table!("limit_surface limit_surface::exact limit_surface::loaded limit_surface::meridian limit_surface::polar limit_surface::rising limit_surface::sketch")
    };
}

const WRENCH: &str = "whole(&object.wrench(given.load, &given.twist))";
const TALL_WRENCH: &str = "whole(&object.wrench(given.load, &given.twist).wrench)";
const SURFACE: &str = "LimitSurface::new(table::Coulomb, 1.0 as R, 1.0).ok()?";
const PROJECTION: &str = "whole(&object.project(&given.push).wrench)";

/// Each with the Coulomb table of its precision, unless named otherwise.
pub const BODIES: [Item; 11] = [
    item(
        ["body", "disk with dimensions"],
        BOTH,
        on_table!(),
        Code::new("disk(table::Coulomb)?", WRENCH),
    ),
    item(
        ["body", "disk with dimensions: compact"],
        BOTH,
        round!("coupling::compact special::elliptic"),
        Code::new("disk(compact::CompactCoulomb)?", WRENCH),
    ),
    item(
        ["body", "tall: front-back"],
        NARROW,
        on_table!("coupling::tall"),
        Code::new(
            "TallFriction::<_, _, FrontBack>::new(disk(table::Coulomb)?, 0.25).ok()?",
            TALL_WRENCH,
        ),
    ),
    item(
        ["body", "tall: all round"],
        NARROW,
        on_table!("coupling::tall"),
        Code::new(
            "TallFriction::<_, _, AllRound>::new(disk(table::Coulomb)?, 0.25).ok()?",
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
        "limit_surface limit_surface::ellipsoid limit_surface::exact limit_surface::loaded limit_surface::meridian limit_surface::polar limit_surface::rising limit_surface::sketch",
        Code::new("Ellipsoid::new(1.0 as R, 1.0, 0.625).ok()?", PROJECTION),
    ),
    item(
        ["motion", "final modes"],
        NARROW,
        on_table!("modes"),
        Code::new(
            "table::Coulomb",
            "Modes::new(*object, b).ok().and_then(|modes| modes.finite_fixed_point()).unwrap_or(0.0)",
        ),
    ),
    item(
        ["motion", "slider to rest"],
        BOTH,
        on_table!(
            "modes slider slider::rest slider::leg slider::march slider::march::course slider::march::finish slider::march::panel slider::march::rates slider::rule slider::tail special::legendre"
        ),
        Code::new(
            "slider()?",
            "object.to_rest(&given.motion).map_or(0.0, |rest| state(&rest.motion))",
        ),
    ),
    item(
        ["motion", "slider: a given time"],
        NARROW,
        on_table!(
            "modes slider slider::rest slider::advance slider::runge_kutta slider::single slider::leg slider::march slider::march::course slider::march::finish slider::march::panel slider::march::rates slider::rule slider::tail special::legendre"
        ),
        Code::new(
            "slider()?",
            "state(&object.advance(&given.motion, given.duration).motion)",
        ),
    ),
    item(
        ["motion", "slider: Verlet step"],
        BOTH,
        on_table!("slider slider::verlet"),
        Code::new(
            "slider()?",
            "state(&object.verlet_step(&given.motion, given.duration))",
        ),
    ),
];
