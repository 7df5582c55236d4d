//! Many wrenches at once, each under its own load.
//!
//! Every wrench goes through the searches of its own call, so that the bits are the same; a group of them goes
//! on point by point, and a processor computes the points of one while those of another wait for a root.

use super::meridian::Meridian;
use super::searches::{SurfaceSearch, inside};
use super::{Projection, RoundLimitSurface};
use crate::coupling::DryReducedFriction;
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Searches that go on side by side.
const GROUP: usize = 8;

impl<R: Real, C: DryReducedFriction<R>> RoundLimitSurface<R, C> {
    /// Gauges of many wrenches: the force limit of each is that of this surface times its load.
    ///
    /// A contact's load changes from step to step, and its surface with it in size alone: prepare it with the
    /// friction coefficient as force limit. Elements beyond the shortest slice are not changed.
    ///
    /// *Domain*: 0 ≤ load < ∞. *Special values*: NaN for a negative load and every wrench but zero.
    /// *Accuracy*: bit for bit [`super::FrictionSet::gauge`] of the surface with that force limit.
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
    /// use tribos_core::twist::Wrench;
    /// let puck = RoundLimitSurface::new(CoulombDisk, 0.3_f64, 0.04)?; // coefficient, radius in m
    /// let pushes = [Wrench::new(0.2, 0.0, 0.004); 2]; // N, N m
    /// let mut gauges = [0.0; 2];
    /// puck.gauge_batch(&[1.7, 0.6], &pushes, &mut gauges); // loads in N
    /// assert!(gauges[0] < 1.0 && gauges[1] > 1.0); // one holds, one slips
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn gauge_batch(&self, loads: &[R], wrenches: &[Wrench<R>], gauges: &mut [R]) {
        side_by_side(
            self.meridian(),
            loads.iter().zip(wrenches),
            gauges,
            |(load, wrench), gauge| self.loaded(*load).gauge(wrench).open(gauge),
        );
    }

    /// Motions that many pushes cause, whatever the load. Elements beyond the shorter slice are not changed.
    ///
    /// *Accuracy*: bit for bit [`super::FrictionSet::twist_normal_to`].
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface};
    /// use tribos_core::twist::{Twist, Wrench};
    /// let puck = RoundLimitSurface::new(CoulombDisk, 0.3_f64, 0.04)?;
    /// let pushes = [1.0, -1.0].map(|sign| Wrench::new(sign * 0.2, 0.0, sign * 0.004));
    /// let mut motions = [Twist::ZERO; 2];
    /// puck.twist_normal_to_batch(&pushes, &mut motions);
    /// assert_eq!(motions[0], -motions[1]);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn twist_normal_to_batch(&self, pushes: &[Wrench<R>], twists: &mut [Twist<R>]) {
        side_by_side(self.meridian(), pushes.iter(), twists, |push, twist| {
            self.loaded(R::ONE).twist_normal_to(push).open(twist)
        });
    }

    /// Projections of many wrenches: the force limit of each is that of this surface times its load, as in
    /// [`RoundLimitSurface::gauge_batch`]. Elements beyond the shortest slice are not changed.
    ///
    /// *Domain*: 0 ≤ load < ∞; `length` as in [`super::FrictionSet::project_with_length`], usually the radius.
    /// *Special values*: NaN for a negative load and every wrench but zero. *Accuracy*: bit for bit that of the surface with that force limit.
    ///
    /// ```
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::{FrictionSet, RoundLimitSurface, Projection, Region};
    /// use tribos_core::twist::Wrench;
    /// let puck = RoundLimitSurface::new(CoulombDisk, 0.3_f64, 0.04)?; // coefficient, radius in m
    /// let pushes = [Wrench::new(0.2, 0.0, 0.004); 2]; // N, N m
    /// let mut carried = pushes.map(|wrench| Projection { wrench, region: Region::Inside });
    /// puck.project_batch(puck.radius(), &[1.7, 0.6], &pushes, &mut carried); // loads in N
    /// assert!(carried[0].region == Region::Inside && carried[1].region != Region::Inside);
    /// assert!(carried[1].wrench.force.x < 0.3 * 0.6);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn project_batch(
        &self,
        length: R,
        loads: &[R],
        wrenches: &[Wrench<R>],
        projections: &mut [Projection<R>],
    ) {
        side_by_side(
            self.meridian(),
            loads.iter().zip(wrenches),
            projections,
            |(load, wrench), projection| {
                let set = self.loaded(*load);
                if set.is_deep_inside(wrench) {
                    *projection = inside(wrench);
                    return None;
                }
                set.project(wrench, length).open(projection)
            },
        );
    }
}

/// Starts the tasks of a group, and advances them by turns until all are done. `start` puts an answer that
/// needs no search in its place.
#[inline]
fn side_by_side<R, C, I, S>(
    curve: &Meridian<R, C>,
    mut inputs: impl Iterator<Item = I>,
    answers: &mut [S::Answer],
    start: impl Fn(I, &mut S::Answer) -> Option<S>,
) where
    R: Real,
    C: DryReducedFriction<R>,
    S: SurfaceSearch<R>,
{
    for answers in answers.chunks_mut(GROUP) {
        let mut open = [const { None }; GROUP];
        let mut left = 0;
        for (slot, (answer, input)) in open.iter_mut().zip(answers.iter_mut().zip(&mut inputs)) {
            *slot = start(input, answer);
            left += usize::from(slot.is_some());
        }
        while left > 0 {
            for (slot, answer) in open.iter_mut().zip(answers.iter_mut()) {
                if let Some(task) = slot
                    && let Some(found) = task.advance(curve)
                {
                    *answer = found;
                    *slot = None;
                    left -= 1;
                }
            }
        }
    }
}
