//! A few contacts solved together, without an allocator: a ball between fingers, a stack.
//!
//! A [`ContactSystem`] holds up to `BODIES` spheres and plates and up to `CONTACTS` contacts between
//! them, and gives all their impulses in one time step by the non-linear Gauss–Seidel method (Jean
//! 1999). The caller moves the bodies by their velocities and
//! updates the geometry of the contacts.
//!
//! ```
//! use nalgebra::Vector3;
//! use tribos_core::contact::{Cohesion, NormalLaw, WallBody, SphereBody, IndependentFriction, TimeStep, ContactGeometry};
//! use tribos_core::manifold::{ContactSystem, InitialGuess, SolverSettings};
//!
//! // A ball of 1 kg and 5 cm held by two fingers that press with 40 N each.
//! let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
//! let friction = IndependentFriction::sliding_torsion(0.3_f32, 0.02)?;
//! let mut grip = ContactSystem::<f32, _, 3, 2>::new(law, friction);
//! let still = Vector3::new(0.0, 0.0, 0.0);
//! let ball = SphereBody { velocity: still, spin: still, inv_mass: 1.0, inv_inertia: 1000.0 };
//! let ball = grip.push_sphere(ball)?;
//! let mut contacts = [None; 2];
//! for (contact, inwards) in contacts.iter_mut().zip([1.0, -1.0]) {
//!     let finger = grip.push_plate(WallBody { velocity: still, inv_mass: 10.0 })?;
//!     grip.set_force(finger, Vector3::new(40.0 * inwards, 0.0, 0.0), still)?;
//!     let touch = ContactGeometry::plate(0.05, &Vector3::new(inwards, 0.0, 0.0), 0.05)?;
//!     *contact = Some(grip.push_contact(ball, finger, touch)?);
//! }
//! grip.set_gravity(Vector3::new(0.0, 0.0, -9.81));
//! let report = grip.solve(TimeStep::new(1e-3)?, InitialGuess::Last, SolverSettings { max_iterations: 50, tolerance: 1e-5 });
//! assert!(report.converged);
//! // 9.81 N by friction, of which 24 N are to be had: it does not fall.
//! assert!(grip.body(ball).is_some_and(|body| body.velocity().z.abs() < 1e-6));
//! let force = contacts[0].and_then(|contact| grip.force(contact));
//! assert!(force.is_some_and(|force| (force.normal - 40.0).abs() < 1e-2));
//! # use tribos_core::contact::ContactBody;
//! # Ok::<(), tribos_core::Error>(())
//! ```

mod impact;
#[cfg(feature = "defmt")]
mod logging;
mod member;
mod solve;

pub use member::SystemBody;
pub use solve::{InitialGuess, SolverReport, SolverSettings};

use crate::contact::{
    Contact, ContactFriction, ContactGeometry, ContactVector, NormalLaw, SphereBody, WallBody,
};
use crate::real::Real;
use heapless::Vec;
use member::LoadedBody;
use nalgebra::Vector3;

/// A body of a manifold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BodyHandle(usize);

/// A contact of a manifold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ContactHandle(usize);

/// An invalid call of a manifold.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos_core::contact::{Cohesion, NormalLaw, WallBody, SphereBody, IndependentFriction, ContactGeometry};
/// use tribos_core::manifold::{BodyHandle, ContactHandle, ContactSystem, ContactSystemError};
/// # let still = Vector3::new(0.0, 0.0, 0.0);
/// # let ball = SphereBody { velocity: still, spin: still, inv_mass: 1.0, inv_inertia: 1000.0 };
/// # let table = WallBody { velocity: still, inv_mass: 0.0 };
/// # let touch = ContactGeometry::plate(0.05_f64, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
/// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
/// let mut pair = ContactSystem::<f64, _, 2, 1>::new(law, IndependentFriction::none());
/// let first: BodyHandle = pair.push_sphere(ball)?;
/// let second: BodyHandle = pair.push_plate(table)?;
/// assert_eq!(pair.push_sphere(ball), Err(ContactSystemError::Full { capacity: 2 }));
/// assert_eq!(pair.push_contact(first, first, touch), Err(ContactSystemError::SameBody));
/// let contact: ContactHandle = pair.push_contact(first, second, touch)?;
/// pair.clear_contacts();
/// assert_eq!(pair.set_geometry(contact, touch), Err(ContactSystemError::Unknown));
/// # Ok::<(), tribos_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ContactSystemError {
    /// There is no room for another body or contact.
    Full {
        /// How many there is room for.
        capacity: usize,
    },
    /// No body or contact here has that handle: it is from another manifold, or from before the
    /// contacts were cleared.
    Unknown,
    /// A body cannot touch itself.
    SameBody,
}

impl core::fmt::Display for ContactSystemError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Full { capacity } => write!(f, "there is room for {capacity} only"),
            Self::Unknown => f.write_str("the handle names nothing in this manifold"),
            Self::SameBody => f.write_str("a contact needs two different bodies"),
        }
    }
}

impl core::error::Error for ContactSystemError {}

/// Up to `CONTACTS` contacts of one law between up to `BODIES` bodies.
///
/// *Units*: any consistent set. *Size* in f64 with all modes: 120 bytes a body, 312 a contact.
#[derive(Clone, Debug)]
pub struct ContactSystem<R: Real, F: ContactFriction<R>, const BODIES: usize, const CONTACTS: usize>
{
    law: NormalLaw<R>,
    friction: F,
    gravity: Vector3<R>,
    bodies: Vec<LoadedBody<R>, BODIES>,
    contacts: Vec<ContactPair<R, F>, CONTACTS>,
}

/// Two bodies that touch.
#[derive(Clone, Copy, Debug)]
struct ContactPair<R: Real, F: ContactFriction<R>> {
    bodies: [usize; 2],
    touch: ContactGeometry<R>,
    /// Nothing before the first step.
    solved: Option<SolvedContact<R, F>>,
    /// Impulse of the impacts of the last step, a part of what was solved.
    impact: ContactVector<R, F::Modes>,
}

/// A contact in its last step.
#[derive(Clone, Copy, Debug)]
struct SolvedContact<R: Real, F: ContactFriction<R>> {
    contact: Contact<R, F::Modes>,
    inv_dt: R,
}

impl<R: Real, F: ContactFriction<R>, const BODIES: usize, const CONTACTS: usize>
    ContactSystem<R, F, BODIES, CONTACTS>
{
    /// No bodies, no contacts, no gravity.
    pub fn new(law: NormalLaw<R>, friction: F) -> Self {
        Self {
            law,
            friction,
            gravity: Vector3::new(R::ZERO, R::ZERO, R::ZERO),
            bodies: Vec::new(),
            contacts: Vec::new(),
        }
    }

    /// Adds a sphere.
    pub fn push_sphere(&mut self, sphere: SphereBody<R>) -> Result<BodyHandle, ContactSystemError> {
        self.push_body(SystemBody::Sphere(sphere))
    }

    /// Adds a plate.
    pub fn push_plate(&mut self, plate: WallBody<R>) -> Result<BodyHandle, ContactSystemError> {
        self.push_body(SystemBody::Plate(plate))
    }

    fn push_body(&mut self, member: SystemBody<R>) -> Result<BodyHandle, ContactSystemError> {
        let handle = BodyHandle(self.bodies.len());
        match self.bodies.push(LoadedBody::new(member)) {
            Ok(()) => Ok(handle),
            Err(_) => Err(ContactSystemError::Full { capacity: BODIES }),
        }
    }

    /// Adds a contact; the touch's normal leads from `first` to `second`, and at a plate the sphere
    /// is the first.
    pub fn push_contact(
        &mut self,
        first: BodyHandle,
        second: BodyHandle,
        touch: ContactGeometry<R>,
    ) -> Result<ContactHandle, ContactSystemError> {
        if first == second {
            return Err(ContactSystemError::SameBody);
        }
        let bodies = [first.0, second.0];
        if bodies.iter().any(|&body| body >= self.bodies.len()) {
            return Err(ContactSystemError::Unknown);
        }
        let handle = ContactHandle(self.contacts.len());
        let joint = ContactPair {
            bodies,
            touch,
            solved: None,
            impact: ContactVector::default(),
        };
        match self.contacts.push(joint) {
            Ok(()) => Ok(handle),
            Err(_) => Err(ContactSystemError::Full { capacity: CONTACTS }),
        }
    }

    /// Acceleration of all spheres that are not of infinite mass. Plates follow their
    /// [force](Self::set_force) alone.
    pub fn set_gravity(&mut self, gravity: Vector3<R>) {
        self.gravity = gravity;
    }

    /// Force and torque on a body from outside, from the next step on. Those on a plate move it as
    /// they are: along its normal is the caller's business.
    pub fn set_force(
        &mut self,
        body: BodyHandle,
        force: Vector3<R>,
        torque: Vector3<R>,
    ) -> Result<(), ContactSystemError> {
        let body = self
            .bodies
            .get_mut(body.0)
            .ok_or(ContactSystemError::Unknown)?;
        (body.force, body.torque) = (force, torque);
        Ok(())
    }

    /// Where a contact is now; its impulses are kept as the next guess.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::contact::{ContactBody, Cohesion, NormalLaw, WallBody, SphereBody};
    /// use tribos_core::contact::{IndependentFriction, TimeStep, ContactGeometry};
    /// use tribos_core::manifold::{ContactSystem, InitialGuess, SolverSettings};
    /// # let still = Vector3::new(0.0, 0.0, 0.0);
    /// # let ball = SphereBody { velocity: still, spin: still, inv_mass: 1.0, inv_inertia: 1000.0 };
    /// # let table = WallBody { velocity: still, inv_mass: 0.0 };
    /// # let (law, dt) = (NormalLaw::new(Cohesion::NONE, 0.0)?, TimeStep::new(1e-3)?);
    /// # let stop = SolverSettings { max_iterations: 10, tolerance: 1e-12 };
    /// # let up = Vector3::new(0.0, 0.0, 1.0);
    /// // A ball of 5 cm and 1 kg falls from 1 cm above a table.
    /// let mut falls = ContactSystem::<f64, _, 2, 1>::new(law, IndependentFriction::none());
    /// let (ball, table) = (falls.push_sphere(ball)?, falls.push_plate(table)?);
    /// let mut height = 0.06;
    /// let contact = falls.push_contact(ball, table, ContactGeometry::plate(height, &up, 0.05)?)?;
    /// falls.set_gravity(up * -9.81);
    /// for _ in 0..100 {
    ///     falls.set_geometry(contact, ContactGeometry::plate(height, &up, 0.05)?)?;
    ///     falls.solve(dt, InitialGuess::Last, stop);
    ///     height += dt.dt() * falls.body(ball).map_or(0.0, |ball| ball.velocity().z);
    /// }
    /// // It lies on the table, which bears its weight.
    /// assert!((height - 0.05).abs() < 1e-15);
    /// assert!(falls.force(contact).is_some_and(|force| (force.normal - 9.81).abs() < 1e-9));
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn set_geometry(
        &mut self,
        contact: ContactHandle,
        touch: ContactGeometry<R>,
    ) -> Result<(), ContactSystemError> {
        let joint = self.contacts.get_mut(contact.0);
        joint.ok_or(ContactSystemError::Unknown)?.touch = touch;
        Ok(())
    }

    /// Forgets all contacts, and their handles; bodies stay.
    pub fn clear_contacts(&mut self) {
        self.contacts.clear();
    }

    /// A body with its velocities.
    pub fn body(&self, body: BodyHandle) -> Option<&SystemBody<R>> {
        self.bodies.get(body.0).map(|body| &body.member)
    }

    /// The same, to be changed from outside.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tribos_core::contact::{ContactBody, Cohesion, NormalLaw, WallBody, SphereBody};
    /// use tribos_core::contact::{IndependentFriction, TimeStep, ContactGeometry};
    /// use tribos_core::manifold::{ContactSystem, SystemBody, InitialGuess, SolverSettings};
    /// # let still = Vector3::new(0.0, 0.0, 0.0);
    /// # let ball = SphereBody { velocity: still, spin: still, inv_mass: 1.0, inv_inertia: 1000.0 };
    /// # let table = WallBody { velocity: still, inv_mass: 0.0 };
    /// # let touch = ContactGeometry::plate(0.05_f64, &Vector3::new(0.0, 0.0, 1.0), 0.05)?;
    /// # let law = NormalLaw::new(Cohesion::NONE, 0.0)?;
    /// # let stop = SolverSettings { max_iterations: 10, tolerance: 1e-12 };
    /// // A solid ball of 5 cm and 1 kg on a belt, which is started at 0.1 m/s.
    /// let mut belt = ContactSystem::<f64, _, 2, 1>::new(law, IndependentFriction::sliding(0.3)?);
    /// let (ball, table) = (belt.push_sphere(ball)?, belt.push_plate(table)?);
    /// belt.push_contact(ball, table, touch)?;
    /// belt.set_gravity(Vector3::new(0.0, 0.0, -9.81));
    /// if let Some(SystemBody::Plate(table)) = belt.body_mut(table) {
    ///     table.velocity.x = 0.1;
    /// }
    /// for _ in 0..20 {
    ///     belt.solve(TimeStep::new(1e-3)?, InitialGuess::Last, stop);
    /// }
    /// // It rolls on the belt and follows with 2/7 of the belt's speed.
    /// let speed = belt.body(ball).map_or(0.0, |ball| ball.velocity().x);
    /// assert!((speed - 0.1 * 2.0 / 7.0).abs() < 1e-12);
    /// # Ok::<(), tribos_core::Error>(())
    /// ```
    pub fn body_mut(&mut self, body: BodyHandle) -> Option<&mut SystemBody<R>> {
        self.bodies.get_mut(body.0).map(|body| &mut body.member)
    }

    /// A contact as it was solved last, with its impulse, that of impacts included.
    pub fn contact(&self, contact: ContactHandle) -> Option<&Contact<R, F::Modes>> {
        Some(&self.solved(contact)?.contact)
    }

    /// Force and torque on the second body in the last step: impulse/dt, impacts included.
    pub fn force(&self, contact: ContactHandle) -> Option<ContactVector<R, F::Modes>> {
        let SolvedContact { contact, inv_dt } = self.solved(contact)?;
        Some(ContactVector::default().plus_scaled(*inv_dt, contact.impulse()))
    }

    fn solved(&self, contact: ContactHandle) -> Option<&SolvedContact<R, F>> {
        self.contacts.get(contact.0)?.solved.as_ref()
    }
}
