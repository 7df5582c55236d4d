//! The implicit time step of many bodies alike, on one set or each under its own load.

use super::PlanarBody;
use super::step::{PlanarStep, is_beyond};
use crate::contact::TimeStep;
use crate::coupling::DryReducedFriction;
use crate::limit_surface::{FrictionSet, Projection, Region, RoundLimitSurface, without_gain};
use crate::real::Real;
use crate::twist::{Twist, Wrench};

/// Bodies whose wrenches are projected together: a multiple of all lanes.
const CHUNK: usize = 32;

/// A projection to write over.
fn blank<R: Real>() -> Projection<R> {
    Projection {
        wrench: Wrench::ZERO,
        region: Region::Inside,
    }
}

/// What friction carries of each body.
trait FrictionSets<R: Real> {
    /// The largest force and torque of friction of a body.
    fn limits(&self, body: usize) -> [R; 2];
    /// Projects wrenches onto the sets of bodies.
    fn project(
        &self,
        bodies: &[usize],
        wrenches: &[Wrench<R>],
        length: R,
        projections: &mut [Projection<R>],
    );
}

/// One set for all bodies.
struct OneSet<'a, R, S: ?Sized> {
    set: &'a S,
    limits: [R; 2],
}

impl<R: Real, S: FrictionSet<R> + ?Sized> FrictionSets<R> for OneSet<'_, R, S> {
    #[inline]
    fn limits(&self, _: usize) -> [R; 2] {
        self.limits
    }
    #[inline]
    fn project(
        &self,
        _: &[usize],
        wrenches: &[Wrench<R>],
        length: R,
        projections: &mut [Projection<R>],
    ) {
        self.set.project_each(wrenches, length, projections);
    }
}

/// One surface times a load for each body.
struct LoadedSurface<'a, R, C> {
    surface: &'a RoundLimitSurface<R, C>,
    loads: &'a [R],
}

impl<R: Real, C: DryReducedFriction<R>> LoadedSurface<'_, R, C> {
    #[inline]
    fn load(&self, body: usize) -> R {
        self.loads.get(body).map_or(R::NAN, |load| *load)
    }
}

impl<R: Real, C: DryReducedFriction<R>> FrictionSets<R> for LoadedSurface<'_, R, C> {
    #[inline]
    fn limits(&self, body: usize) -> [R; 2] {
        self.surface.limits_under(self.load(body))
    }
    #[inline]
    fn project(
        &self,
        bodies: &[usize],
        wrenches: &[Wrench<R>],
        length: R,
        projections: &mut [Projection<R>],
    ) {
        let mut loads = [R::NAN; CHUNK];
        for (load, body) in loads.iter_mut().zip(bodies) {
            *load = self.load(*body);
        }
        self.surface
            .project_batch(length, &loads, wrenches, projections);
    }
}

/// The nearest wrench of the set of a body.
fn nearest<R: Real>(
    sets: &impl FrictionSets<R>,
    body: usize,
    needed: &Wrench<R>,
    length: R,
) -> Wrench<R> {
    let mut nearest = [blank()];
    sets.project(&[body], &[*needed], length, &mut nearest);
    let [Projection { wrench, .. }] = nearest;
    wrench
}

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

    /// The nearest wrenches of the sets, none of which gives energy, in the places of their bodies.
    #[inline]
    fn nearest(
        &self,
        sets: &impl FrictionSets<R>,
        length: R,
        found: &mut [Option<Wrench<R>>; CHUNK],
    ) {
        let mut nearest = [blank(); CHUNK];
        let asked = self.wrenches.get(..self.count).unwrap_or_default();
        sets.project(&self.bodies, asked, length, &mut nearest);
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
        let sets = OneSet { set, limits };
        let given = twists.chunks(CHUNK).zip(pushes.chunks(CHUNK));
        for (given, steps) in given.zip(steps.chunks_mut(CHUNK)) {
            self.step_chunk(&sets, given, dt, steps);
        }
    }

    /// The same on a round patch where each body has a load of its own, and with it a friction coefficient: the force
    /// limit of each is that of `surface` times its load, as in [`RoundLimitSurface::project_batch`].
    ///
    /// *Domain*: 0 ≤ load < ∞. *Special values*: NaN for a load that is negative or NaN, unless the body rests without
    /// push. *Accuracy*: bit for bit [`PlanarBody::step`] on the surface with that force limit.
    ///
    /// ```
    /// use tribos_core::contact::TimeStep;
    /// use tribos_core::coupling::coulomb::CoulombDisk;
    /// use tribos_core::limit_surface::RoundLimitSurface;
    /// use tribos_core::planar::{PlanarBody, PlanarStep};
    /// use tribos_core::twist::{Twist, Wrench};
    /// let puck = PlanarBody::new(0.17_f64, 1.36e-4)?; // kg, kg m²
    /// let unit = RoundLimitSurface::new(CoulombDisk, 1.0, 0.04)?; // N, m
    /// let push = [Wrench::new(0.1, 0.0, 0.0); 2]; // N
    /// let blank = PlanarStep { twist: Twist::ZERO, friction: Wrench::ZERO, is_at_rest: true };
    /// let (mut steps, dt) = ([blank; 2], TimeStep::new(0.01)?);
    /// puck.step_batch_under_loads(&unit, &[0.05, 0.2], &[Twist::ZERO; 2], &push, dt, &mut steps);
    /// assert!(!steps[0].is_at_rest && steps[1].is_at_rest); // 0.1 N on 0.05 N, and on 0.2 N
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn step_batch_under_loads<C: DryReducedFriction<R>>(
        &self,
        surface: &RoundLimitSurface<R, C>,
        loads: &[R],
        twists: &[Twist<R>],
        pushes: &[Wrench<R>],
        dt: TimeStep<R>,
        steps: &mut [PlanarStep<R>],
    ) {
        let given = twists.chunks(CHUNK).zip(pushes.chunks(CHUNK));
        let given = loads.chunks(CHUNK).zip(given);
        for ((loads, given), steps) in given.zip(steps.chunks_mut(CHUNK)) {
            let sets = LoadedSurface { surface, loads };
            let count = loads.len().min(steps.len());
            let steps = steps.get_mut(..count).unwrap_or_default();
            self.step_chunk(&sets, given, dt, steps);
        }
    }

    fn step_chunk(
        &self,
        sets: &impl FrictionSets<R>,
        (twists, pushes): (&[Twist<R>], &[Wrench<R>]),
        dt: TimeStep<R>,
        steps: &mut [PlanarStep<R>],
    ) {
        let length = self.gyration();
        if let ([twist, ..], [push, ..], [step]) = (twists, pushes, &mut *steps) {
            *step = self.step_alone(sets, twist, push, dt);
            return;
        }
        let bodies = || twists.iter().zip(pushes).zip(0..steps.len());
        let (mut ends, mut midways) = ([None; CHUNK], [None; CHUNK]);
        // Friction that would end the step at rest, where that is possible.
        let mut asked = WrenchesToProject::new();
        for ((twist, push), body) in bodies() {
            let at_end = self.stopping_wrench(twist, push, dt.dt());
            if !is_beyond(&at_end, sets.limits(body)) {
                asked.push(body, at_end);
            }
        }
        asked.nearest(sets, length, &mut ends);
        // The motion at half time, of all that do not rest.
        let mut asked = WrenchesToProject::new();
        for (((twist, push), body), end) in bodies().zip(&ends) {
            let at_end = self.stopping_wrench(twist, push, dt.dt());
            if *end != Some(at_end) {
                asked.push(body, self.stopping_wrench(twist, push, R::HALF * dt.dt()));
            }
        }
        asked.nearest(sets, length, &mut midways);
        let found = ends.into_iter().zip(midways);
        let given = twists.iter().zip(pushes).zip(0..);
        for ((((twist, push), body), step), (ended, midway)) in given.zip(steps).zip(found) {
            let nearest = |needed: &Wrench<R>| nearest(sets, body, needed, length);
            (*step, _) = self.step_found(twist, push, dt, [ended, midway], nearest);
        }
    }

    /// Without room for others.
    #[inline(never)]
    fn step_alone(
        &self,
        sets: &impl FrictionSets<R>,
        twist: &Twist<R>,
        push: &Wrench<R>,
        dt: TimeStep<R>,
    ) -> PlanarStep<R> {
        let nearest = |needed: &Wrench<R>| nearest(sets, 0, needed, self.gyration());
        let (step, _) = self.step_within(twist, push, dt, sets.limits(0), nearest);
        step
    }
}
