//! Growth, sphere by sphere.

use super::columns::{Columns, Meeting};
use super::{Ballistic, Deposit, DepositError, MOST_SPHERES, STREAM, Until};
use crate::random::Random;
use crate::space::PeriodicBox;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// A sphere that has come to rest.
struct Landed {
    position: Vector3<f64>,
    radius: f64,
    parent: Option<u32>,
}

/// How many times the spheres in a row above a cut would cover the base.
const COVERS: f64 = 10.0;

impl Ballistic {
    /// Grows a deposit; the same seed gives the same bits.
    ///
    /// *Domain*: a finite, positive height, a cut above the first sphere, one sphere or more.
    /// *Cost*: about a microsecond a sphere. *Accuracy*: touching distances to a few ulp of the
    /// coordinates.
    pub fn grow(&self, until: Until, seed: u64) -> Result<Deposit, DepositError> {
        match until {
            Until::Height(height) => {
                check_height(height)?;
                self.grow_while(seed, |deposit| deposit.height < height)
            }
            Until::Cut(height) => {
                check_height(height)?;
                let mut above = 0;
                let enough = self.cover();
                let whole = self.grow_while(seed, |deposit| {
                    above = if deposit.ends_above(height) {
                        above + 1
                    } else {
                        0
                    };
                    above < enough
                })?;
                let low = whole.cut(height);
                if low.positions.is_empty() {
                    return Err(DepositError::Empty);
                }
                Ok(low)
            }
            Until::Count(0) => Err(DepositError::Empty),
            Until::Count(count) if count > MOST_SPHERES => Err(DepositError::TooMany),
            Until::Count(count) => self.grow_while(seed, |deposit| deposit.positions.len() < count),
        }
    }

    /// Adds spheres as long as `goes_on` says so, one call each.
    fn grow_while(
        &self,
        seed: u64,
        mut goes_on: impl FnMut(&Deposit) -> bool,
    ) -> Result<Deposit, DepositError> {
        let [_, largest] = self.radii;
        let farthest = 2.0 * largest + self.capture_gap();
        let mut columns = Columns::new(self.space, self.width, farthest, largest);
        let mut random = Random::new(seed, STREAM);
        let mut deposit = Deposit {
            positions: Vec::new(),
            radii: Vec::new(),
            parents: Vec::new(),
            width: self.width,
            space: self.space,
            height: 0.0,
        };
        while goes_on(&deposit) {
            let index = deposit.positions.len();
            if index == MOST_SPHERES {
                return Err(DepositError::TooMany);
            }
            let sphere = self.drop_one(&columns, &mut random);
            columns.insert(index as u32, sphere.position, sphere.radius);
            deposit.height = deposit.height.max(sphere.position.z + sphere.radius);
            deposit.positions.push(sphere.position);
            deposit.radii.push(sphere.radius);
            deposit.parents.push(sphere.parent);
        }
        Ok(deposit)
    }

    /// Spheres that cover the base with their circles of capture, [`COVERS`] times.
    fn cover(&self) -> usize {
        let shares = self.width / self.capture_radius;
        (COVERS / PI * shares * shares).ceil() as usize
    }

    /// Lets one sphere fall and brings it to rest.
    fn drop_one(&self, columns: &Columns, random: &mut Random) -> Landed {
        let [x, y] = [(); 2].map(|()| self.width * random.unit());
        let [low, high] = self.radii;
        let radius = if low < high {
            low + (high - low) * random.unit()
        } else {
            low
        };
        // Captured by a sphere above the height where the substrate captures.
        let captured = Vector3::new(x, y, radius + self.substrate_gap());
        if let Some(meeting) = columns.first_meeting(captured, radius + self.capture_gap()) {
            return touching(&meeting, radius, &self.space);
        }
        // Drawn to the substrate, unless a sphere is in the way.
        let lying = Vector3::new(x, y, radius);
        match columns.first_meeting(lying, radius) {
            Some(meeting) => touching(&meeting, radius, &self.space),
            None => Landed {
                position: self.space.wrap(&lying),
                radius,
                parent: None,
            },
        }
    }
}

/// Moves a captured sphere along the line of centres until it touches.
fn touching(meeting: &Meeting, radius: f64, space: &PeriodicBox) -> Landed {
    let way = meeting.way * ((meeting.radius + radius) / meeting.way.norm());
    Landed {
        position: space.wrap(&(meeting.centre + way)),
        radius,
        parent: Some(meeting.index),
    }
}

impl Deposit {
    /// Whether the last sphere reaches above a height.
    fn ends_above(&self, height: f64) -> bool {
        let last = self.positions.last().zip(self.radii.last());
        last.is_some_and(|(centre, radius)| centre.z + radius > height)
    }
}

/// Refuses heights that are none.
fn check_height(given: f64) -> Result<(), DepositError> {
    if given.is_finite() && given > 0.0 {
        Ok(())
    } else {
        Err(DepositError::NotPositive {
            name: "height",
            given,
        })
    }
}
