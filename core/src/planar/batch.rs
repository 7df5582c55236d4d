//! The implicit time step of many bodies alike on one set.

use super::PlanarBody;
use super::step::{PlanarStep, is_beyond};
use crate::contact::TimeStep;
use crate::limit_surface::{FrictionSet, Projection, Region, without_gain};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Bodies whose wrenches are projected together: a multiple of all lanes.
const CHUNK: usize = 32;

/// Wrenches to project, and the bodies that ask for them.
struct WrenchesToProject<R: Real> {
    wrenches: [Wrench<R>; CHUNK],
    bodies: [usize; CHUNK],
    count: usize,
}

impl<R: Real> WrenchesToProject<R> {
    fn new() -> Self {
        Self {
            wrenches: [Wrench::ZERO; CHUNK],
            bodies: [0; CHUNK],
            count: 0,
        }
    }

    #[inline]
    fn push(&mut self, body: usize, wrench: Wrench<R>) {
        let mut slots = self.wrenches.iter_mut().zip(&mut self.bodies);
        if let Some((slot, of)) = slots.nth(self.count) {
            (*slot, *of) = (wrench, body);
            self.count += 1;
        }
    }

    /// The nearest wrenches of a set, none of which gives energy, in the places of their bodies.
    #[inline]
    fn nearest(
        &self,
        set: &(impl FrictionSet<R> + ?Sized),
        length: R,
        found: &mut [Option<Wrench<R>>; CHUNK],
    ) {
        let blank = Projection {
            wrench: Wrench::ZERO,
            region: Region::Inside,
        };
        let mut nearest = [blank; CHUNK];
        let asked = self.wrenches.get(..self.count).unwrap_or_default();
        set.project_each(asked, length, &mut nearest);
        for ((wanted, body), nearest) in asked.iter().zip(&self.bodies).zip(&nearest) {
            if let Some(slot) = found.get_mut(*body) {
                *slot = Some(without_gain(&nearest.wrench, wanted, length));
            }
        }
    }
}

impl<R: Real> PlanarBody<R> {
    /// [`PlanarBody::step`] of many bodies alike, each with its motion and push, to the same bits. Elements beyond the
    /// shortest slice are not changed.
    ///
    /// *Cost*: on a round patch about half of single steps where the processor has vectors.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::RoundLimitSurface;
    /// use tribos_core::planar::{PlanarBody, PlanarStep};
    /// use tribos_core::twist::{Twist, Wrench};
    /// let puck = PlanarBody::new(0.17_f64, 1.36e-4)?; // kg, kg m²
    /// let ice = RoundLimitSurface::new(CoulombDisk, 0.05, 0.04)?; // N, m
    /// let (motions, pushes) = ([Twist::new(2.0, 0.0, 5.0), Twist::ZERO], [Wrench::ZERO; 2]);
    /// let blank = PlanarStep { twist: Twist::ZERO, friction: Wrench::ZERO, is_at_rest: true };
    /// let mut steps = [blank; 2];
    /// puck.step_batch(&ice, &motions, &pushes, TimeStep::new(0.01)?, &mut steps);
    /// assert!(!steps[0].is_at_rest && steps[1].is_at_rest);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step_batch<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        twists: &[Twist<R>],
        pushes: &[Wrench<R>],
        dt: TimeStep<R>,
        steps: &mut [PlanarStep<R>],
    ) {
        let limits = self.limits(set);
        let given = twists.chunks(CHUNK).zip(pushes.chunks(CHUNK));
        for ((twists, pushes), steps) in given.zip(steps.chunks_mut(CHUNK)) {
            self.step_chunk(set, limits, (twists, pushes), dt, steps);
        }
    }

    fn step_chunk<S: FrictionSet<R> + ?Sized>(
        &self,
        set: &S,
        limits: [R; 2],
        (twists, pushes): (&[Twist<R>], &[Wrench<R>]),
        dt: TimeStep<R>,
        steps: &mut [PlanarStep<R>],
    ) {
        let length = self.gyration();
        let bodies = || twists.iter().zip(pushes).zip(0..steps.len());
        let (mut ends, mut midways) = ([None; CHUNK], [None; CHUNK]);
        // Friction that would end the step at rest, where that is possible.
        let mut asked = WrenchesToProject::new();
        for ((twist, push), body) in bodies() {
            let at_end = self.stopping_wrench(twist, push, dt.dt());
            if !is_beyond(&at_end, limits) {
                asked.push(body, at_end);
            }
        }
        asked.nearest(set, length, &mut ends);
        // The motion at half time, of all that do not rest.
        let mut asked = WrenchesToProject::new();
        for (((twist, push), body), end) in bodies().zip(&ends) {
            let at_end = self.stopping_wrench(twist, push, dt.dt());
            if *end != Some(at_end) {
                asked.push(body, self.stopping_wrench(twist, push, R::HALF * dt.dt()));
            }
        }
        asked.nearest(set, length, &mut midways);
        let found = ends.into_iter().zip(midways);
        for (((twist, push), step), (ended, midway)) in
            twists.iter().zip(pushes).zip(steps).zip(found)
        {
            let nearest = |needed: &Wrench<R>| set.project_with_length(needed, length).wrench;
            (*step, _) = self.step_found(twist, push, dt, [ended, midway], nearest);
        }
    }
}
