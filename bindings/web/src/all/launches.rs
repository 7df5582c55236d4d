//! Launches that end at a wanted pose.

use super::prepared::profile;
use super::store;
use crate::exchange::{Refused, said};
use core::num::NonZeroU32;
use tribos_core::coupling::coulomb::CoulombDisk;
use tribos_core::coupling::{PowerLawFriction, ReducedFriction};
use tribos_core::slider::SliderParameters;
use tribos_motion::slide::inverse::{LaunchLimits, LaunchSolution, Pose, RestMap, Turns};

/// What is launched, to where, and how fast at most.
#[derive(Clone, Copy, Debug)]
pub struct LaunchTarget {
    /// Deceleration of pure sliding, radius and I/(M R²).
    pub parameters: SliderParameters<f64>,
    /// The pose at rest.
    pub pose: [f64; 3],
    /// In m/s.
    pub max_speed: f64,
    /// In rad/s.
    pub max_spin: f64,
    /// Order of the symmetry; `None` for the exact angle.
    pub symmetry: Option<NonZeroU32>,
}

impl LaunchTarget {
    /// Fills rows of velocity, spin, speed, direction, angle, time and energy per mass, in the order of energy.
    /// Returns their number.
    pub fn launches(&self, patch: u32, rows: &mut [[f64; 8]]) -> Result<usize, Refused> {
        if patch == 0 {
            return self.with(CoulombDisk, rows);
        }
        store::with(patch, |prepared| self.with(&*profile(prepared)?, rows))
    }

    fn with<P: PowerLawFriction<f64> + ReducedFriction<f64>>(
        &self,
        profile: P,
        rows: &mut [[f64; 8]],
    ) -> Result<usize, Refused> {
        let SliderParameters {
            deceleration,
            radius,
            inertia_ratio,
        } = self.parameters;
        let map = RestMap::new(profile, deceleration, radius, inertia_ratio).map_err(said)?;
        let limits = LaunchLimits::new(self.max_speed, self.max_spin).map_err(said)?;
        let [x, y, angle] = self.pose;
        let target = Pose { x, y, angle };
        let turns = match self.symmetry {
            Some(symmetry) => Turns::Modulo { symmetry },
            None => Turns::Exact,
        };
        let found = map.fewest_turns(&target, turns, &limits, rows.len() as u64);
        let found = found.map_err(said)?.solutions;
        for (row, solution) in rows.iter_mut().zip(&found) {
            *row = numbers(solution);
        }
        Ok(found.len().min(rows.len()))
    }
}

fn numbers(solution: &LaunchSolution) -> [f64; 8] {
    let LaunchSolution {
        launch,
        speed,
        direction,
        angle,
        time,
        energy_per_mass,
    } = *solution;
    let [vx, vy] = launch.velocity;
    [
        vx,
        vy,
        launch.spin,
        speed,
        direction,
        angle,
        time,
        energy_per_mass,
    ]
}
