//! Prepared patches, laws, supports.

use super::rows;
use crate::all::catalogue;
use crate::all::launches::LaunchTarget;
use crate::all::prepared::Prepared;
use crate::all::store::{self, Item, OTHER};
use crate::exchange::{Refused, answer, counted, said, say, status};
use crate::friction::{row_of, twist_of, wrench_of};
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::num::NonZeroU32;
use tribos_core::law::LocalLaw;
use tribos_core::limit_surface::UnknownPressureSet;
use tribos_core::patch::mesh::Vertex;
use tribos_core::patch::nodes::Node;
use tribos_core::slider::SliderParameters;
use tribos_friction::{Area, FrictionError, Law};

/// A text of the caller.
pub(super) unsafe fn text<'a>(from: *const u8, length: usize) -> Result<&'a str, Refused> {
    core::str::from_utf8(core::slice::from_raw_parts(from, length)).map_err(said)
}

/// Keeps a patch: handle, radius, centre, coefficient and exponent.
fn keep(area: Result<Area, FrictionError>, law: Result<&str, Refused>) -> u32 {
    match law {
        Ok(law) => keep_area(area.map_err(Refused::from), law),
        Err(refused) => status(Err(refused)),
    }
}

/// The same of an area that this crate made.
pub(super) fn keep_area(area: Result<Area, Refused>, law: &str) -> u32 {
    let made = area.and_then(|area| Prepared::new(area, law));
    status(made.map(|patch| {
        let (radius, [x, y]) = (patch.area.radius(), patch.area.centre());
        let [coefficient, alpha] = patch.power();
        let handle = store::keep(Item::Patch(Box::new(patch)));
        answer([handle.into(), radius, x, y, coefficient, alpha]);
    }))
}

/// A patch as scenes write it; one with an axis has this radius.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_named(
    name: *const u8,
    name_length: usize,
    radius: f64,
    law: *const u8,
    law_length: usize,
) -> u32 {
    let name = match text(name, name_length) {
        Ok(name) => name,
        Err(refused) => return status(Err(refused)),
    };
    let area = name
        .parse()
        .and_then(|patch| Area::named(&patch, radius, None));
    keep(area, text(law, law_length))
}

/// A polygon, by the corners of its loops and the number of each; a centre of pressure, or NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_polygon(
    corners: *mut [f64; 2],
    corner_count: usize,
    counts: *mut [f64; 1],
    loop_count: usize,
    centre_x: f64,
    centre_y: f64,
    law: *const u8,
    law_length: usize,
) -> u32 {
    let loops = loops_of(rows(corners, corner_count), rows(counts, loop_count));
    let is_uniform = centre_x.is_nan() && centre_y.is_nan();
    let centre = (!is_uniform).then_some([centre_x, centre_y]);
    keep(Area::polygon(&loops, centre), text(law, law_length))
}

/// The corners of each loop, by the number that each has.
pub(super) fn loops_of<'a>(corners: &'a [[f64; 2]], counts: &[[f64; 1]]) -> Vec<&'a [[f64; 2]]> {
    let mut rest = corners;
    // Exact: they come from whole numbers.
    let loops = counts.iter().map(|[count]| {
        let (corners, after) = rest.split_at(rest.len().min(*count as usize));
        rest = after;
        corners
    });
    loops.collect()
}

/// Points with weights.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_points(
    points: *mut [f64; 3],
    count: usize,
    law: *const u8,
    law_length: usize,
) -> u32 {
    let node = |&[x, y, weight]: &[f64; 3]| Node { x, y, weight };
    let nodes = rows(points, count).iter().map(node).collect();
    keep(Area::points(nodes), text(law, law_length))
}

/// Triangles, by their vertices x, y, pressure and the three numbers of each among them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_mesh(
    vertices: *mut [f64; 3],
    vertex_count: usize,
    triangles: *mut [f64; 3],
    count: usize,
    law: *const u8,
    law_length: usize,
) -> u32 {
    let vertex = |&[x, y, pressure]: &[f64; 3]| Vertex { x, y, pressure };
    let vertices = rows(vertices, vertex_count).iter().map(vertex);
    let vertices: Vec<Vertex<f64>> = vertices.collect();
    // Exact: they come from whole numbers.
    let triangles = rows(triangles, count).iter();
    let triangles: Vec<[usize; 3]> = triangles
        .map(|corners| corners.map(|n| n as usize))
        .collect();
    keep(Area::mesh(&vertices, &triangles), text(law, law_length))
}

/// Frees what has the handle.
#[unsafe(no_mangle)]
pub extern "C" fn release(handle: u32) {
    store::release(handle);
}

/// Number of things that are kept.
#[unsafe(no_mangle)]
pub extern "C" fn kept() -> usize {
    store::kept()
}

/// A law by its line: handle, coefficient and exponent; name and parameters as text.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_law(line: *const u8, length: usize) -> u32 {
    let made = text(line, length).and_then(|line| {
        let law: Law = line.parse().map_err(said)?;
        let made = law.build::<f64>().map_err(said)?;
        Ok((law, made))
    });
    status(made.map(|(law, made)| {
        say(catalogue::parts(&law));
        let [coefficient, alpha] = law.power_of_speed().unwrap_or([f64::NAN; 2]);
        let handle = store::keep(Item::Law(law, made));
        answer([handle.into(), coefficient, alpha]);
    }))
}

/// Friction per load of `count` speeds, in place.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn law_frictions(law: u32, speeds: *mut [f64; 1], count: usize) -> u32 {
    let speeds = rows(speeds, count);
    status(with_law(law, |law| {
        for [speed] in speeds {
            *speed = law.friction(speed.abs());
        }
    }))
}

/// Friction per load at a speed, and its slope.
#[unsafe(no_mangle)]
pub extern "C" fn law_at(law: u32, speed: f64) -> u32 {
    let made = with_law(law, |law| {
        [law.friction(speed.abs()), law.slope(speed.abs())]
    });
    status(made.map(answer))
}

fn with_law<T>(handle: u32, work: impl FnOnce(&dyn LocalLaw<f64>) -> T) -> Result<T, Refused> {
    match &*store::item(handle)? {
        Item::Law(_, law) => Ok(work(law)),
        _ => Err(OTHER),
    }
}

/// All laws of the library, as text.
#[unsafe(no_mangle)]
pub extern "C" fn laws() -> u32 {
    say(catalogue::laws());
    0
}

/// At most `count` launches to a pose, those with the fewest turns; a symmetry of 0 for the exact angle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn launches(
    patch: u32,
    deceleration: f64,
    radius: f64,
    inertia_ratio: f64,
    x: f64,
    y: f64,
    angle: f64,
    max_speed: f64,
    max_spin: f64,
    symmetry: u32,
    out: *mut [f64; 8],
    count: usize,
) -> u32 {
    let wanted = LaunchTarget {
        parameters: SliderParameters {
            deceleration,
            radius,
            inertia_ratio,
        },
        pose: [x, y, angle],
        max_speed,
        max_spin,
        symmetry: NonZeroU32::new(symmetry),
    };
    counted(wanted.launches(patch, rows(out, count)))
}

/// A support with unknown pressure: handle and radius.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make_any_pressure(
    corners: *mut [f64; 2],
    count: usize,
    centre_x: f64,
    centre_y: f64,
    force_limit: f64,
) -> u32 {
    let corners = rows(corners, count).to_vec();
    let made = UnknownPressureSet::new(corners, [centre_x, centre_y], force_limit);
    status(made.map_err(said).map(|support| {
        let radius = support.radius();
        answer([store::keep(Item::AnyPressure(support)).into(), radius]);
    }))
}

/// Largest power over all pressures, and the friction of one that attains it.
#[unsafe(no_mangle)]
pub extern "C" fn any_pressure_at(support: u32, vx: f64, vy: f64, spin: f64) -> u32 {
    let twist = twist_of([vx, vy, spin]);
    let made = with_support(support, |support| {
        let [fx, fy, torque] = row_of(&support.wrench(&twist));
        [support.support(&twist), fx, fy, torque]
    });
    status(made.map(answer))
}

/// Torques with a force: lowest and highest that are carried, then the outer limits; NaN where the force is not
/// carried.
#[unsafe(no_mangle)]
pub extern "C" fn any_pressure_torques(support: u32, fx: f64, fy: f64) -> u32 {
    let made = with_support(support, |support| {
        let Some(limits) = support.torque_limits([fx, fy]) else {
            return [f64::NAN; 4];
        };
        let ([low, high], [lower, higher]) = (limits.certain, limits.possible);
        [low, high, lower, higher]
    });
    status(made.map(answer))
}

/// Lower and upper bound of the gauge.
#[unsafe(no_mangle)]
pub extern "C" fn any_pressure_gauge(support: u32, fx: f64, fy: f64, torque: f64) -> u32 {
    let wrench = wrench_of([fx, fy, torque]);
    let made = with_support(support, |support| support.gauge_bounds(&wrench));
    status(made.map(answer))
}

fn with_support<T>(
    handle: u32,
    work: impl FnOnce(&UnknownPressureSet<f64, Vec<[f64; 2]>>) -> T,
) -> Result<T, Refused> {
    match &*store::item(handle)? {
        Item::AnyPressure(support) => Ok(work(support)),
        _ => Err(OTHER),
    }
}
