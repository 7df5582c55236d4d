//! One time step: external forces and impacts, then sweeps over the contacts until convergence.

use super::member::LoadedBody;
use super::{ContactPair, ContactSystem, SolvedContact};
use crate::contact::{Contact, ContactFriction, ContactModes, ContactVector, TimeStep};
use crate::real::Real;
use nalgebra::Vector3;

/// Impulses with which the sweeps start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InitialGuess {
    /// The impulses of the last step, made admissible: contacts that last are nearly right at once.
    #[default]
    Last,
    /// No impulses.
    Zero,
}

/// Stopping criterion of the sweeps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SolverSettings<R> {
    /// Largest number of sweeps.
    pub max_iterations: u32,
    /// Relative change of the impulses in one sweep below which the sweeps end early. With 0 they end
    /// early only if nothing changes any more.
    pub tolerance: R,
}

/// Result of the sweeps.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::{Cohesion, NormalLaw, WallBody, SphereBody, IndependentFriction, TimeStep, ContactGeometry};
/// use tribos_core::manifold::{ContactSystem, SolverReport, InitialGuess, SolverSettings};
/// # let still = Vector3::new(0.0, 0.0, 0.0);
/// # let ball = SphereBody { velocity: still, spin: still, inv_mass: 1.0, inv_inertia: 1000.0 };
/// # let table = WallBody { velocity: still, inv_mass: 0.0 };
/// # let touch = ContactGeometry::plate(0.05_f64, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// // A ball on a table: one contact.
/// let mut lies = ContactSystem::<f64, _, 2, 1>::new(law, IndependentFriction::sliding(0.3)?);
/// let (ball, table) = (lies.push_sphere(ball)?, lies.push_plate(table)?);
/// lies.push_contact(ball, table, touch)?;
/// lies.set_gravity(Vector3::new(0.0, 0.0, -9.81));
/// let stop = SolverSettings { max_iterations: 50, tolerance: 1e-12 };
/// let SolverReport { iterations, converged, .. } = lies.solve(TimeStep::new(1e-3)?, InitialGuess::Zero, stop);
/// assert!(converged && iterations == 2); // one to solve it, one that changes nothing
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SolverReport<R> {
    /// Number of sweeps done.
    pub iterations: u32,
    /// Relative change of the impulses in the last sweep; torques count as their force at r_eff. The
    /// error itself is larger by 1/(1 − rate) where convergence is slow.
    pub residual: R,
    /// True if the residual is within the tolerance.
    pub converged: bool,
}

impl<R: Real, F: ContactFriction<R>, const BODIES: usize, const CONTACTS: usize>
    ContactSystem<R, F, BODIES, CONTACTS>
{
    /// Takes all bodies' velocities through one time step.
    ///
    /// With restitution impacts come first, one after the other, in the middle of the step's load
    /// (gravity and outer forces): contacts that would close in the step by their bodies'
    /// velocities, and faster than the load of a step makes them. Each is that of two bodies alone,
    /// which never raises the energy; where one body meets two others at the same time, the contact
    /// that was added first goes first. There are at most as many rounds over the contacts as sweeps.
    ///
    /// *Domain*: masses, lengths and times of any size for which velocities, impulses and the bodies'
    /// moments of inertia are in the number range. Other units of powers of two give the same bits as
    /// long as the squares of these are in the range too, and beyond that the same answer to rounding.
    /// *Special values*: NaN in a body or touch spreads to whatever it touches, and never converges.
    /// What converges has finite velocities; a force, or an impulse with that of several impacts, that
    /// is out of the number range is infinite.
    /// *Cost*: one [`Contact::update`] per contact and sweep.
    pub fn solve(
        &mut self,
        step: TimeStep<R>,
        start: InitialGuess,
        stop: SolverSettings<R>,
    ) -> SolverReport<R> {
        let dt = step.dt();
        self.prepare(dt, start);
        let rebounds = self.law.restitution() > R::ZERO;
        let load = if rebounds {
            let half = dt * R::HALF;
            self.accelerate(half);
            self.impact(dt, stop.max_iterations);
            half
        } else {
            dt
        };
        self.accelerate(load);
        self.apply_guesses();
        let mut report = SolverReport {
            iterations: 0,
            residual: R::INFINITY,
            converged: false,
        };
        while report.iterations < stop.max_iterations && !report.converged {
            let [change, total] = self.sweep();
            report.iterations += 1;
            report.residual = if change == R::ZERO {
                change
            } else {
                change / total
            };
            report.converged = report.residual <= stop.tolerance;
        }
        if rebounds {
            self.add_impacts();
        }
        report
    }

    /// Lets gravity and outer forces act for a time.
    fn accelerate(&mut self, time: R) {
        for body in &mut self.bodies {
            body.accelerate(&self.gravity, time);
        }
    }

    /// Contacts that last, from their geometry and the forces of the last step.
    fn prepare(&mut self, dt: R, start: InitialGuess) {
        let (inv_dt, law) = (R::ONE / dt, self.law.without_restitution());
        for joint in &mut self.contacts {
            let Some([a, b]) = pair(&mut self.bodies, joint.bodies) else {
                continue;
            };
            let mut contact = Contact::new(&joint.touch, &law, &a.member, &b.member, dt);
            if let (InitialGuess::Last, Some(last)) = (start, &joint.solved) {
                // Forces last, impulses grow with the step.
                let lasting = last.contact.impulse().minus(&joint.impact);
                let guess = ContactVector::default().plus_scaled(last.inv_dt * dt, &lasting);
                contact.set_impulse(&guess);
                contact.project_impulse(&self.friction);
            }
            joint.solved = Some(SolvedContact { contact, inv_dt });
        }
    }

    /// Gives the bodies the impulses that the sweeps begin with.
    fn apply_guesses(&mut self) {
        for ContactPair { bodies, solved, .. } in &mut self.contacts {
            if let (Some([a, b]), Some(SolvedContact { contact, .. })) =
                (pair(&mut self.bodies, *bodies), solved)
            {
                contact.apply(contact.impulse(), &mut a.member, &mut b.member);
            }
        }
    }

    /// Updates every contact once; returns the magnitudes of all changes and of all impulses.
    fn sweep(&mut self) -> [R; 2] {
        let (mut change, mut total) = (R::ZERO, R::ZERO);
        for ContactPair { bodies, solved, .. } in &mut self.contacts {
            if let (Some([a, b]), Some(SolvedContact { contact, .. })) =
                (pair(&mut self.bodies, *bodies), solved)
            {
                let moved = contact.update(&self.friction, &mut a.member, &mut b.member);
                change += size(&moved, contact.effective_radius());
                total += size(contact.impulse(), contact.effective_radius());
            }
        }
        [change, total]
    }
}

/// Two bodies at once.
#[inline]
pub(super) fn pair<R>(
    bodies: &mut [LoadedBody<R>],
    indices: [usize; 2],
) -> Option<[&mut LoadedBody<R>; 2]> {
    bodies.get_disjoint_mut(indices).ok()
}

/// Sum of an impulse's components: no square that could vanish for small grains.
fn size<R: Real, M: ContactModes<R>>(impulse: &ContactVector<R, M>, lever: R) -> R {
    let torques = impulse.torsion().abs() + sum(&impulse.rolling());
    impulse.normal.abs() + sum(&impulse.sliding()) + torques / lever
}

fn sum<R: Real>(v: &Vector3<R>) -> R {
    v.x.abs() + v.y.abs() + v.z.abs()
}
