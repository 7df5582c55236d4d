//! Growth of a deposit, sphere by sphere.

use super::columns::{Columns, FallContact};
use super::{Ballistic, Deposit, DepositTarget, MOST_SPHERES, STREAM};
use crate::packing::PlacementError;
use nalgebra::Vector3;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use tribos_base::random::Random;
use tribos_base::space::PeriodicBox;

/// A sphere that has come to rest.
struct SettledSphere {
    position: Vector3<f64>,
    radius: f64,
    parent: Option<u32>,
}

/// Number of times that the spheres in a row above a cut would cover the base.
const COVERS: f64 = 10.0;
/// Spheres between two calls of the observer: one or two milliseconds.
const WATCHED: usize = 1024;

impl Ballistic {
    /// Grows a deposit; the same seed gives the same bits.
    ///
    /// *Domain*: a finite, positive height, a cut above the first sphere, at least one sphere.
    /// *Cost*: one to two microseconds per sphere; a million spheres take two seconds and 100 MB.
    /// *Accuracy*: distances of touching spheres to a few ulp of the coordinates.
    pub fn grow(&self, until: DepositTarget, seed: u64) -> Result<Deposit, PlacementError> {
        self.grow_watched(until, seed, |_| ControlFlow::Continue(()))
    }

    /// Like [`grow`](Self::grow); `watch` receives the number of spheres after every 1024 spheres, and can
    /// stop the growth.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use tribos::powder::deposit::{Ballistic, DepositTarget};
    /// use tribos::run::PlacementError;
    /// let wide = Ballistic::new(100.0, 1.0, 3.0)?;
    /// let stopped = wide.grow_watched(DepositTarget::Cut(1e9), 1, |spheres| {
    ///     if spheres < 5000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    /// });
    /// assert_eq!(stopped, Err(PlacementError::Stopped));
    /// # Ok::<(), PlacementError>(())
    /// ```
    pub fn grow_watched(
        &self,
        until: DepositTarget,
        seed: u64,
        mut watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Deposit, PlacementError> {
        let watch = &mut watch;
        match until {
            DepositTarget::Height(height) => {
                check_height(height)?;
                self.grow_while(seed, watch, |deposit| deposit.height < height)
            }
            DepositTarget::Cut(height) => {
                check_height(height)?;
                let mut above = 0;
                let enough = self.cover();
                let whole = self.grow_while(seed, watch, |deposit| {
                    above = if deposit.ends_above(height) {
                        above + 1
                    } else {
                        0
                    };
                    above < enough
                })?;
                let low = whole.cut(height);
                if low.positions.is_empty() {
                    return Err(PlacementError::Empty);
                }
                Ok(low)
            }
            DepositTarget::Count(0) => Err(PlacementError::Empty),
            DepositTarget::Count(count) if count > MOST_SPHERES => Err(PlacementError::TooMany),
            DepositTarget::Count(count) => {
                self.grow_while(seed, watch, |deposit| deposit.positions.len() < count)
            }
        }
    }

    /// Estimated number of spheres of a deposit before it is grown.
    ///
    /// *Formula*: the volume up to the height times the solid fraction 0.1535 (2r̄/r_capt)^1.72 of the
    /// bulk, over the mean volume of a sphere. *Accuracy*: a tenth for 2r̄ ≤ r_capt ≤ 10r̄ and heights
    /// of at least ten radii: a fit to means of five deposits on 40R × 40R, cut at 200R.
    ///
    /// ```
    /// use tribos::powder::deposit::{Ballistic, DepositTarget};
    /// let small = Ballistic::new(20.0, 1.0, 3.0)?;
    /// let told = small.expected_spheres(DepositTarget::Cut(61.5));
    /// assert!((told / 470.0 - 1.0).abs() < 0.1); // the thesis' small system
    /// assert_eq!(small.expected_spheres(DepositTarget::Count(7)), 7.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn expected_spheres(&self, until: DepositTarget) -> f64 {
        /// Solid fraction of spheres that stick where they touch, and the exponent of its decrease.
        const TOUCHING: f64 = 0.1535;
        const POWER: f64 = 1.72;
        let height = match until {
            DepositTarget::Count(count) => return count as f64,
            DepositTarget::Height(height) | DepositTarget::Cut(height) => height,
        };
        let solid = TOUCHING * libm::pow(self.radii.two_means() / self.capture_radius, POWER);
        let sphere = 4.0 / 3.0 * PI * self.radii.mean_cube();
        (solid * self.width * self.width * height / sphere).max(1.0)
    }

    /// Adds spheres while `goes_on`, which is called once per sphere, returns true.
    fn grow_while(
        &self,
        seed: u64,
        watch: &mut impl FnMut(usize) -> ControlFlow<()>,
        mut goes_on: impl FnMut(&Deposit) -> bool,
    ) -> Result<Deposit, PlacementError> {
        let [_, largest] = self.radii.bounds();
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
                return Err(PlacementError::TooMany);
            }
            if index.is_multiple_of(WATCHED) && watch(index).is_break() {
                return Err(PlacementError::Stopped);
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

    /// Number of spheres that cover the base with their capture circles, [`COVERS`] times.
    fn cover(&self) -> usize {
        let shares = self.width / self.capture_radius;
        (COVERS / PI * shares * shares).ceil() as usize
    }

    /// Drops one sphere and brings it to rest.
    fn drop_one(&self, columns: &Columns, random: &mut Random) -> SettledSphere {
        let [x, y] = [(); 2].map(|()| self.width * random.unit());
        let radius = if self.radii.are_equal() {
            self.radii.at(0.0)
        } else {
            self.radii.at(random.unit())
        };
        // The sphere is captured by another one above the height at which the substrate captures.
        let captured = Vector3::new(x, y, radius + self.substrate_gap());
        if let Some(meeting) = columns.first_meeting(captured, radius + self.capture_gap()) {
            return touching(&meeting, radius, &self.space);
        }
        // The sphere moves to the substrate, unless another sphere is in the way.
        let lying = Vector3::new(x, y, radius);
        match columns.first_meeting(lying, radius) {
            Some(meeting) => touching(&meeting, radius, &self.space),
            None => SettledSphere {
                position: self.space.wrap(&lying),
                radius,
                parent: None,
            },
        }
    }
}

/// Moves a captured sphere along the line of centres until it touches.
fn touching(meeting: &FallContact, radius: f64, space: &PeriodicBox) -> SettledSphere {
    let way = meeting.way * ((meeting.radius + radius) / meeting.way.norm());
    SettledSphere {
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

/// Refuses heights that are not positive and finite.
fn check_height(given: f64) -> Result<(), PlacementError> {
    if given.is_finite() && given > 0.0 {
        Ok(())
    } else {
        Err(PlacementError::NotPositive {
            name: "height",
            given,
        })
    }
}
