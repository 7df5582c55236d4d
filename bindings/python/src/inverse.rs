//! Launches that end at a wanted pose.

use crate::arrays::refused;
use crate::modes::PowerLawProfile;
use crate::threads::detached;
use pyo3::prelude::*;
use std::num::NonZeroU32;
use tribos::slide::inverse::{LaunchLimits, LaunchSolution, Pose, RestMap, Turns};

/// Velocity, spin, speed, direction, angle, time and energy per mass.
type Row = ((f64, f64), f64, f64, f64, f64, f64, f64);

/// What is launched, to where, and how fast at most.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct LaunchTarget {
    x: f64,
    y: f64,
    angle: f64,
    gravity: f64,
    inertia_ratio: f64,
    max_speed: f64,
    max_spin: f64,
    /// Order of the symmetry; None for the exact angle.
    symmetry: Option<NonZeroU32>,
    /// Number of launches to be listed; None for all.
    most: Option<u64>,
}

/// Launches to a pose in the order of their energy; `wanted` is a dictionary.
#[pyfunction]
pub fn launches(
    py: Python<'_>,
    friction: &PowerLawProfile,
    wanted: &Bound<'_, PyAny>,
) -> PyResult<Vec<Row>> {
    let wanted: LaunchTarget = wanted.extract()?;
    let found = detached(py, || {
        let deceleration = friction.coefficient * wanted.gravity;
        let map = RestMap::new(
            &*friction.profile,
            deceleration,
            friction.radius,
            wanted.inertia_ratio,
        )?;
        let limits = LaunchLimits::new(wanted.max_speed, wanted.max_spin)?;
        let target = Pose {
            x: wanted.x,
            y: wanted.y,
            angle: wanted.angle,
        };
        let turns = match wanted.symmetry {
            Some(symmetry) => Turns::Modulo { symmetry },
            None => Turns::Exact,
        };
        match wanted.most {
            Some(most) => {
                let found = map.fewest_turns(&target, turns, &limits, most);
                found.map(|found| found.solutions)
            }
            None => map.launches(&target, turns, &limits),
        }
    })?;
    Ok(found.map_err(refused)?.iter().map(row).collect())
}

fn row(solution: &LaunchSolution) -> Row {
    let LaunchSolution {
        launch,
        speed,
        direction,
        angle,
        time,
        energy_per_mass,
    } = *solution;
    (
        launch.velocity.into(),
        launch.spin,
        speed,
        direction,
        angle,
        time,
        energy_per_mass,
    )
}
