//! Several surfaces under a patch, several feet, and two coefficients.

use super::store;
use crate::exchange::{Refused, said};
use crate::friction::{row_of, row_of_twist, twist_of, wrench_of};
use crate::patch::Patch;
use alloc::format;
use alloc::vec::Vec;
use tribos_core::contact::TimeStep;
use tribos_core::floor::{FloorStep, SteadyMotion, SteadyState};
use tribos_core::planar::PlanarBody;
use tribos_core::twist::{Twist, Wrench};
use tribos_friction::{Area, Coefficients, Floor, FootOnFloor, Surface};

/// Numbers of a foot in a row: patch, radius, coefficient, load, place, angle in degrees, motion of the surface.
pub const FOOT: usize = 10;
/// Twist, friction, the foot that rests or −1, evaluations or imbalance.
pub const STEADY: usize = 8;

/// A surface: the corners of a convex polygon, or two points of a border to whose left it lies; and its motion.
pub fn surface(corners: &[[f64; 2]], twist: [f64; 3]) -> Result<Surface, Refused> {
    let twist = twist_of(twist);
    Ok(match *corners {
        [from, to] => Surface::half_plane(from, [to[0] - from[0], to[1] - from[1]], twist)?,
        _ => Surface::polygon(corners, twist)?,
    })
}

/// The area of a patch under dry friction, and its coefficient.
fn dry(patch: &Patch) -> Result<(Area, Coefficients), Refused> {
    if patch.handle == 0 {
        let area = Area::round(tribos_friction::Patch::Disk, patch.radius)?;
        return Ok((area, Coefficients::isotropic(patch.mu)?));
    }
    store::with(patch.handle, |prepared| match prepared.power() {
        [mu, 0.0] => Ok((prepared.area.clone(), Coefficients::isotropic(mu)?)),
        _ => Err(said(format!(
            "surfaces, feet and two coefficients need dry friction, with mu, not {}",
            prepared.law()
        ))),
    })
}

/// A patch whose coefficient is the larger one of two, along an axis at `angle` and across it.
pub fn two_coefficients(patch: &Patch, mu: [f64; 2], angle: f64) -> Result<Area, Refused> {
    let (area, _) = dry(patch)?;
    Ok(Coefficients::along_and_across(mu, angle)?.on(area)?)
}

/// A patch on surfaces, of which the first counts where two lie over each other.
pub fn under(patch: &Patch, load: f64, surfaces: &[Surface]) -> Result<Floor, Refused> {
    let (area, mu) = dry(patch)?;
    Ok(Floor::under(&area, &mu, load, surfaces)?)
}

/// A body on several feet.
pub fn feet(rows: &[[f64; FOOT]]) -> Result<Floor, Refused> {
    let patches = rows.iter().map(|&[handle, radius, mu, ..]| {
        // Exact: it comes from a whole number.
        let handle = handle as u32;
        dry(&Patch { handle, radius, mu })
    });
    let patches: Vec<_> = patches.collect::<Result<_, Refused>>()?;
    let feet = rows.iter().zip(&patches).map(|(row, (area, mu))| {
        let [.., load, x, y, degrees, vx, vy, spin] = *row;
        FootOnFloor {
            area,
            mu: *mu,
            load,
            place: [x, y],
            degrees,
            surface: twist_of([vx, vy, spin]),
        }
    });
    Ok(Floor::feet(&feet.collect::<Vec<_>>())?)
}

/// The motion in which friction balances a push.
pub fn steady(floor: &Floor, push: [f64; 3]) -> Result<[f64; STEADY], Refused> {
    match floor.steady_motion(&wrench_of(push)) {
        SteadyState::Balanced(found) => Ok(row_of_steady(&found)),
        SteadyState::Accelerates => Err(said(format!(
            "no motion is steady: the push is more than the {} N that friction carries, or turns harder",
            floor.limit()
        ))),
        SteadyState::Missed(_) => Err(Refused::Because(
            "the search for the steady motion has missed it: give points a small area, such as a disk",
        )),
    }
}

/// A time step of a body, of mass and moment of inertia.
pub fn step(
    floor: &Floor,
    [mass, inertia, dt]: [f64; 3],
    twist: [f64; 3],
    push: [f64; 3],
) -> Result<[f64; STEADY], Refused> {
    let (body, dt) = (PlanarBody::new(mass, inertia)?, TimeStep::new(dt)?);
    let end = floor.step(&body, &twist_of(twist), &wrench_of(push), dt);
    let FloorStep {
        twist,
        friction,
        carried_by,
        imbalance,
    } = end.ok_or(Refused::Because("there is no foot"))?;
    Ok(row(&twist, &friction, carried_by, imbalance))
}

/// A steady motion as a row.
pub fn row_of_steady(found: &SteadyMotion<f64>) -> [f64; STEADY] {
    let evaluations = found.evaluations as f64;
    row(&found.twist, &found.friction, found.carried_by, evaluations)
}

fn row(
    twist: &Twist<f64>,
    friction: &Wrench<f64>,
    carried_by: Option<usize>,
    last: f64,
) -> [f64; STEADY] {
    let [vx, vy, spin] = row_of_twist(twist);
    let [fx, fy, torque] = row_of(friction);
    let carried_by = carried_by.map_or(-1.0, |foot| foot as f64);
    [vx, vy, spin, fx, fy, torque, carried_by, last]
}
