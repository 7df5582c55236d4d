//! Gauss–Seidel sweeps as steps of non-linear conjugate gradients.
//!
//! One symmetric sweep (forwards, backwards) moves the impulses by a preconditioned gradient: its
//! displacement d vanishes only at a solution. Conjugate directions are made of these displacements
//! as Fletcher and Reeves do, with sweeps in the place of line searches and a restart when progress
//! turns round (Silcowitz-Hansen, Niebe and Erleben, Vis. Comput. 26 (2010) 893). Differences: the
//! sweep is symmetric, so that in a system where everything sticks the displacement is a gradient in
//! a fixed metric; every extrapolated impulse is first brought back to what its contact admits; the
//! product of displacements counts torques as forces at the contact's lever.

use super::nsgs::Effort;
use super::operator::{Blind, Change, Impulse, Operator, Visit};

/// Buffers of the iteration, kept from step to step.
#[derive(Clone, Debug)]
pub struct Accelerated<I> {
    /// Impulses before the sweeps.
    start: Vec<I>,
    /// Conjugate direction.
    direction: Vec<I>,
}

impl<I> Default for Accelerated<I> {
    fn default() -> Self {
        Self {
            start: Vec::new(),
            direction: Vec::new(),
        }
    }
}

/// Work of an extrapolation (guess and fresh velocities) in sweeps, by measurement.
const EXTRAPOLATION: usize = 1;

impl<I: Impulse> Accelerated<I> {
    /// Iterates until a sweep changes the impulses by less than `tolerance`·P in the root mean
    /// square, or for `most` sweeps. An extrapolation counts as one.
    pub fn solve<O: Operator<Impulse = I>>(
        &mut self,
        problem: &mut O,
        tolerance: f64,
        most: usize,
    ) -> Effort {
        let contacts = problem.contacts();
        self.start.clear();
        self.start
            .extend((0..contacts).map(|contact| problem.impulse(contact)));
        self.direction.clear();
        self.direction.resize(contacts, I::default());
        let mut last_sq = f64::INFINITY;
        let mut sweeps = 0;
        while sweeps < most {
            let mut change = Change::default();
            problem.sweep(Visit::Forward, &mut Blind);
            problem.sweep(Visit::Backward, &mut change);
            sweeps += 2;
            if change.relative() <= tolerance {
                return Effort { sweeps, met: true };
            }
            let moved_sq = self.moved_sq(problem);
            // Fletcher and Reeves; a growing displacement starts anew.
            let beta = moved_sq / last_sq;
            last_sq = moved_sq;
            if beta <= 1.0 {
                self.extrapolate(problem, beta);
                sweeps += EXTRAPOLATION;
            } else {
                self.restart(problem);
            }
        }
        Effort { sweeps, met: false }
    }

    /// |displacement|², summed in the order of the contacts.
    fn moved_sq<O: Operator<Impulse = I>>(&self, problem: &O) -> f64 {
        let mut sum = 0.0;
        for (contact, start) in self.start.iter().enumerate() {
            let moved = problem.impulse(contact).plus_scaled(-1.0, start);
            sum += problem.dot(contact, &moved, &moved);
        }
        sum
    }

    /// Goes on along the old direction, and turns it.
    fn extrapolate<O: Operator<Impulse = I>>(&mut self, problem: &mut O, beta: f64) {
        for (contact, (start, direction)) in
            self.start.iter_mut().zip(&mut self.direction).enumerate()
        {
            let swept = problem.impulse(contact);
            let moved = swept.plus_scaled(-1.0, start);
            problem.guess(contact, &swept.plus_scaled(beta, direction));
            *start = problem.impulse(contact);
            *direction = moved.plus_scaled(beta, direction);
        }
        problem.refresh();
    }

    /// Forgets the direction.
    fn restart<O: Operator<Impulse = I>>(&mut self, problem: &O) {
        for (contact, (start, direction)) in
            self.start.iter_mut().zip(&mut self.direction).enumerate()
        {
            *start = problem.impulse(contact);
            *direction = I::default();
        }
    }
}
