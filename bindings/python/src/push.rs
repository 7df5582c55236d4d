//! Quasi-static pushing.

use crate::arrays::{Numbers, Output, Rows, View, broadcast, refused};
use crate::model::numbers;
use crate::model::{twist_numbers, twist_of};
use crate::surface::LimitSurface;
use crate::threads::{detached, fill};
use pyo3::prelude::*;
use tribos::push::{
    ContactMode, LineContact, PathEnd, PathSample, PointContact, Pose, PushError, PushPath,
    PushedSide, Pusher, QuasiStaticPush,
};
use tribos_core::limit_surface::FrictionSet;

/// Nanoseconds that a push takes, about.
const COST: usize = 5_000;

/// Place, inward normal, coefficient.
fn contact([x, y, nx, ny, mu]: [f64; 5]) -> Result<PointContact, PushError> {
    PointContact::new([x, y], [nx, ny], mu)
}

/// What `of` makes of each row and the surface of each force limit, in rows of `M`.
fn each<'py, const N: usize, const M: usize>(
    py: Python<'py>,
    surface: &LimitSurface,
    limits: &Bound<'py, PyAny>,
    rows: &Bound<'py, PyAny>,
    of: impl Fn(&dyn FrictionSet<f64>, [f64; N]) -> Result<[f64; M], PushError> + Sync,
) -> PyResult<Bound<'py, PyAny>> {
    let limits = Numbers::new("force limit", limits)?;
    let rows = Rows::<N>::new("contacts and velocities", rows)?;
    let batch = broadcast(&[&rows, &limits])?;
    let (rows, limits) = (rows.over(&batch)?, limits.over(&batch)?);
    let (rows, limits) = (rows.view()?, limits.view()?);
    let mut output = Output::new(py, &batch, &[M], None)?;
    fill(py, output.rows::<M>()?, COST, |from, piece| {
        let count = piece.len();
        // One surface serves all elements with one limit.
        let together = if matches!(limits, View::One(_)) {
            count.max(1)
        } else {
            1
        };
        for (part, out) in piece.chunks_mut(together).enumerate() {
            let at = from + part * together;
            let [limit] = limits.at(at);
            let answer = surface.sets.with(limit, |set| {
                (at..).zip(out.iter_mut()).try_for_each(|(index, row)| {
                    *row = of(set, rows.at(index))?;
                    Ok(())
                })
            })?;
            answer.map_err(|error: PushError| refused(error))?;
        }
        Ok(())
    })?;
    output.finish()
}

/// The parts of an answer in one row.
fn joined<const M: usize>(parts: &[&[f64]]) -> [f64; M] {
    let mut row = [f64::NAN; M];
    for (to, from) in row.iter_mut().zip(parts.iter().copied().flatten()) {
        *to = *from;
    }
    row
}

fn edge_numbers(edge: &QuasiStaticPush) -> [f64; 8] {
    joined(&[
        &numbers(&edge.wrench),
        &twist_numbers(&edge.twist),
        edge.contact_velocity.as_slice(),
    ])
}

/// Inward normal of the side of straight edges nearest to a place, and its reach to the right and to the left.
#[pyfunction]
pub fn nearest_side(loops: Vec<Vec<[f64; 2]>>, at: [f64; 2]) -> [[f64; 2]; 2] {
    tribos::push::straight_side(loops, at)
}

/// Names of the modes, by their numbers in a row.
#[pyfunction]
pub fn push_modes() -> [&'static str; 4] {
    ["sticking", "sliding left", "sliding right", "separating"]
}

fn push_numbers(push: &QuasiStaticPush) -> [f64; 11] {
    let mode = match push.mode {
        ContactMode::Sticking => 0.0,
        ContactMode::SlidingLeft => 1.0,
        ContactMode::SlidingRight => 2.0,
        ContactMode::Separating => 3.0,
    };
    joined(&[
        &[mode],
        &twist_numbers(&push.twist),
        push.contact_velocity.as_slice(),
        push.slip.as_slice(),
        &numbers(&push.wrench),
    ])
}

/// Motion cones of contacts (place, inward normal, coefficient): of the right and of the left edge wrench,
/// twist and contact's velocity, then both angles.
#[pyfunction]
pub fn motion_cone<'py>(
    py: Python<'py>,
    surface: &LimitSurface,
    force_limit: &Bound<'py, PyAny>,
    contacts: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    each::<5, 18>(py, surface, force_limit, contacts, |set, row| {
        let cone = contact(row)?.motion_cone(set)?;
        Ok(joined(&[
            &edge_numbers(&cone.right),
            &edge_numbers(&cone.left),
            &cone.angles(),
        ]))
    })
}

/// Pushes by contacts with velocities: mode, twist, contact's velocity, slip, wrench.
#[pyfunction]
pub fn pushes<'py>(
    py: Python<'py>,
    surface: &LimitSurface,
    force_limit: &Bound<'py, PyAny>,
    contacts: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    each::<7, 11>(
        py,
        surface,
        force_limit,
        contacts,
        |set, [x, y, nx, ny, mu, u, v]| {
            let contact = contact([x, y, nx, ny, mu])?;
            Ok(push_numbers(&contact.push(set, [u, v])?))
        },
    )
}

/// Time, pose, contact, push.
fn moment_numbers(moment: &PathSample) -> [f64; 17] {
    let pose = &moment.pose;
    joined(&[
        &[moment.time],
        &[pose.x, pose.y],
        &[pose.angle],
        moment.contact.as_slice(),
        &push_numbers(&moment.push),
    ])
}

/// The path under a pusher of constant velocity; a straight side has a reach to the right and to the left.
/// Returns rows of time, pose, contact and push, how it ended, and the number of steps.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "Python's half names them")]
pub fn push_along<'py>(
    py: Python<'py>,
    surface: &LimitSurface,
    force_limit: f64,
    at: [f64; 5],
    side: Option<[f64; 2]>,
    start: [f64; 3],
    velocity: [f64; 2],
    duration: f64,
    samples: u32,
    tolerance: f64,
) -> PyResult<(Bound<'py, PyAny>, &'static str, usize)> {
    let [x, y, angle] = start;
    let drive = Pusher {
        contact: contact(at).map_err(refused)?,
        side: match side {
            Some([right, left]) => PushedSide::Straight { right, left },
            None => PushedSide::Round,
        },
        start: Pose { x, y, angle },
        velocity,
        duration,
        samples,
        tolerance,
    };
    let journey: PushPath = detached(py, || {
        let journey = surface.sets.with(force_limit, |set| drive.path(set))?;
        journey.map_err(refused)
    })??;
    let end = match journey.end {
        PathEnd::Done => "done",
        PathEnd::Slipped => "slipped",
        PathEnd::Separated => "separated",
        PathEnd::Loose => "loose",
    };
    let mut output = Output::new(py, &[journey.moments.len()], &[17], None)?;
    for (row, moment) in output.rows::<17>()?.iter_mut().zip(&journey.moments) {
        *row = moment_numbers(moment);
    }
    Ok((output.finish()?, end, journey.steps))
}

fn line([x0, y0, x1, y1, mu]: [f64; 5]) -> Result<LineContact, PushError> {
    LineContact::new([[x0, y0], [x1, y1]], mu)
}

/// What a straight pusher (both ends, coefficient) has to give for motions: whether it can, the wrench, the
/// place along the line and the share of friction.
#[pyfunction]
pub fn line_grip<'py>(
    py: Python<'py>,
    surface: &LimitSurface,
    force_limit: &Bound<'py, PyAny>,
    ends: [f64; 5],
    twists: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let line = line(ends).map_err(refused)?;
    each::<3, 6>(py, surface, force_limit, twists, |set, row| {
        let grip = line.stable_push(set, &twist_of(row));
        Ok(joined(&[
            &[f64::from(u8::from(grip.is_stable))],
            &numbers(&grip.wrench),
            &[grip.place, grip.friction],
        ]))
    })
}

/// Motions on the boundary of those that a straight pusher holds.
#[pyfunction]
pub fn line_boundary(
    surface: &LimitSurface,
    force_limit: f64,
    ends: [f64; 5],
    count: usize,
) -> PyResult<Vec<[f64; 3]>> {
    let line = line(ends).map_err(refused)?;
    surface.sets.with(force_limit, |set| {
        let motions = line.stable_boundary(set, count);
        motions.iter().map(twist_numbers).collect()
    })
}
