//! A few contacts solved together.

use crate::arrays::refused;
use crate::contact::{ContactLaw, plate_touch, sphere_touch};
use pyo3::prelude::*;
use tribos::friction::ContactVisitor;
use tribos_core::contact::{
    ContactBody, ContactFriction, ContactGeometry, NormalLaw, SphereBody, TimeStep, WallBody,
};
use tribos_core::manifold::{
    BodyHandle, ContactHandle, ContactSystemError, InitialGuess, SolverReport, SolverSettings,
    SystemBody,
};
use tribos_core::nalgebra::Vector3;

/// Most bodies, and most contacts.
const BODIES: usize = 64;
const CONTACTS: usize = 256;

/// Velocity, spin, 1/mass, 1/inertia.
type Ball = ([f64; 3], [f64; 3], f64, f64);
/// Normal force, sliding, rolling, torsion.
type Force = (f64, [f64; 3], [f64; 3], f64);

/// A manifold of any friction.
trait Solver: Send + Sync {
    fn copy(&self) -> Box<dyn Solver>;
    fn push_body(&mut self, member: SystemBody<f64>) -> Result<BodyHandle, ContactSystemError>;
    fn push_contact(
        &mut self,
        bodies: [BodyHandle; 2],
        touch: ContactGeometry<f64>,
    ) -> Result<ContactHandle, ContactSystemError>;
    fn set_touch(
        &mut self,
        contact: ContactHandle,
        touch: ContactGeometry<f64>,
    ) -> Result<(), ContactSystemError>;
    fn clear_contacts(&mut self);
    fn set_gravity(&mut self, gravity: Vector3<f64>);
    fn set_force(
        &mut self,
        body: BodyHandle,
        load: [Vector3<f64>; 2],
    ) -> Result<(), ContactSystemError>;
    fn body(&mut self, body: BodyHandle) -> Option<&mut SystemBody<f64>>;
    fn force(&self, contact: ContactHandle) -> Option<Force>;
    fn solve(
        &mut self,
        step: TimeStep<f64>,
        start: InitialGuess,
        stop: SolverSettings<f64>,
    ) -> SolverReport<f64>;
}

type System<F> = tribos_core::manifold::ContactSystem<f64, F, BODIES, CONTACTS>;

impl<F: ContactFriction<f64> + 'static> Solver for System<F> {
    fn copy(&self) -> Box<dyn Solver> {
        Box::new(self.clone())
    }
    fn push_body(&mut self, member: SystemBody<f64>) -> Result<BodyHandle, ContactSystemError> {
        match member {
            SystemBody::Sphere(sphere) => self.push_sphere(sphere),
            SystemBody::Plate(plate) => self.push_plate(plate),
        }
    }
    fn push_contact(
        &mut self,
        [first, second]: [BodyHandle; 2],
        touch: ContactGeometry<f64>,
    ) -> Result<ContactHandle, ContactSystemError> {
        System::push_contact(self, first, second, touch)
    }
    fn set_touch(
        &mut self,
        contact: ContactHandle,
        touch: ContactGeometry<f64>,
    ) -> Result<(), ContactSystemError> {
        System::set_geometry(self, contact, touch)
    }
    fn clear_contacts(&mut self) {
        System::clear_contacts(self);
    }
    fn set_gravity(&mut self, gravity: Vector3<f64>) {
        System::set_gravity(self, gravity);
    }
    fn set_force(
        &mut self,
        body: BodyHandle,
        [force, torque]: [Vector3<f64>; 2],
    ) -> Result<(), ContactSystemError> {
        System::set_force(self, body, force, torque)
    }
    fn body(&mut self, body: BodyHandle) -> Option<&mut SystemBody<f64>> {
        self.body_mut(body)
    }
    fn force(&self, contact: ContactHandle) -> Option<Force> {
        let force = System::force(self, contact)?;
        Some((
            force.normal,
            force.sliding().into(),
            force.rolling().into(),
            force.torsion(),
        ))
    }
    fn solve(
        &mut self,
        step: TimeStep<f64>,
        start: InitialGuess,
        stop: SolverSettings<f64>,
    ) -> SolverReport<f64> {
        System::solve(self, step, start, stop)
    }
}

struct Maker(NormalLaw<f64>);

impl ContactVisitor for Maker {
    type Output = Box<dyn Solver>;
    fn visit<F: ContactFriction<f64> + 'static>(self, friction: &F) -> Self::Output {
        Box::new(System::<F>::new(self.0, *friction))
    }
}

/// Bodies and contacts by their numbers.
#[pyclass(module = "tribos._native")]
pub struct Manifold {
    solver: Box<dyn Solver>,
    bodies: Vec<BodyHandle>,
    contacts: Vec<ContactHandle>,
}

impl Manifold {
    fn body_of(&self, body: usize) -> PyResult<BodyHandle> {
        let known = self.bodies.get(body).copied();
        known.ok_or_else(|| refused(format!("there is no body {body}")))
    }

    fn contact_of(&self, contact: usize) -> PyResult<ContactHandle> {
        let known = self.contacts.get(contact).copied();
        known.ok_or_else(|| refused(format!("there is no contact {contact}")))
    }

    fn member(&mut self, body: usize) -> PyResult<&mut SystemBody<f64>> {
        let handle = self.body_of(body)?;
        let member = self.solver.body(handle);
        member.ok_or_else(|| refused(ContactSystemError::Unknown))
    }

    fn push(&mut self, member: SystemBody<f64>) -> PyResult<usize> {
        let handle = self.solver.push_body(member).map_err(full("bodies"))?;
        self.bodies.push(handle);
        Ok(self.bodies.len() - 1)
    }
}

fn full(what: &str) -> impl FnOnce(ContactSystemError) -> PyErr + '_ {
    move |error| match error {
        ContactSystemError::Full { capacity } => refused(format!(
            "a manifold has room for {capacity} {what}; larger systems are scenes of the command"
        )),
        other => refused(other),
    }
}

/// The touch at a plate for one radius, of spheres for two.
fn touch(normal: [f64; 3], gap: f64, radii: (f64, Option<f64>)) -> PyResult<ContactGeometry<f64>> {
    let normal = normal.into();
    match radii {
        (first, Some(second)) => sphere_touch(&normal, gap, [first, second]),
        (radius, None) => plate_touch(&normal, gap, radius),
    }
    .map_err(refused)
}

#[pymethods]
impl Manifold {
    #[new]
    fn new(law: &ContactLaw) -> Self {
        Self {
            solver: law.friction.visit(Maker(law.normal)),
            bodies: Vec::new(),
            contacts: Vec::new(),
        }
    }

    /// The same once more, with the impulses of the last step.
    fn copy(&self) -> Self {
        Self {
            solver: self.solver.copy(),
            bodies: self.bodies.clone(),
            contacts: self.contacts.clone(),
        }
    }

    /// Adds a sphere and returns its number.
    fn add_sphere(&mut self, ball: Ball) -> PyResult<usize> {
        let (velocity, spin, inv_mass, inv_inertia) = ball;
        self.push(SystemBody::Sphere(SphereBody {
            velocity: velocity.into(),
            spin: spin.into(),
            inv_mass,
            inv_inertia,
        }))
    }

    /// Adds a plate and returns its number.
    fn add_plate(&mut self, velocity: [f64; 3], inv_mass: f64) -> PyResult<usize> {
        let velocity = velocity.into();
        self.push(SystemBody::Plate(WallBody { velocity, inv_mass }))
    }

    /// Adds a contact and returns its number; a plate has no radius.
    fn add_contact(
        &mut self,
        first: usize,
        second: usize,
        normal: [f64; 3],
        gap: f64,
        radii: (f64, Option<f64>),
    ) -> PyResult<usize> {
        let bodies = [self.body_of(first)?, self.body_of(second)?];
        let touch = touch(normal, gap, radii)?;
        let handle = self.solver.push_contact(bodies, touch);
        self.contacts.push(handle.map_err(full("contacts"))?);
        Ok(self.contacts.len() - 1)
    }

    /// Where a contact is now.
    fn set_contact(
        &mut self,
        contact: usize,
        normal: [f64; 3],
        gap: f64,
        radii: (f64, Option<f64>),
    ) -> PyResult<()> {
        let (handle, touch) = (self.contact_of(contact)?, touch(normal, gap, radii)?);
        self.solver.set_touch(handle, touch).map_err(refused)
    }

    /// Forgets all contacts.
    fn clear_contacts(&mut self) {
        self.solver.clear_contacts();
        self.contacts.clear();
    }

    /// Acceleration of all spheres of finite mass, in m/s².
    fn set_gravity(&mut self, gravity: [f64; 3]) {
        self.solver.set_gravity(gravity.into());
    }

    /// Force in N and torque in N m on a body.
    fn set_force(&mut self, body: usize, force: [f64; 3], torque: [f64; 3]) -> PyResult<()> {
        let (handle, load) = (self.body_of(body)?, [force.into(), torque.into()]);
        self.solver.set_force(handle, load).map_err(refused)
    }

    /// Velocity in m/s and spin in rad/s of a body.
    fn motion(&mut self, body: usize) -> PyResult<([f64; 3], [f64; 3])> {
        let member = self.member(body)?;
        Ok((member.velocity().into(), member.angular_velocity().into()))
    }

    /// Sets them; plates do not spin.
    fn set_motion(&mut self, body: usize, velocity: [f64; 3], spin: [f64; 3]) -> PyResult<()> {
        match self.member(body)? {
            SystemBody::Sphere(sphere) => {
                (sphere.velocity, sphere.spin) = (velocity.into(), spin.into());
            }
            SystemBody::Plate(plate) => plate.velocity = velocity.into(),
        }
        Ok(())
    }

    /// Forces on the second body of a contact in the last step; None before it.
    fn force(&self, contact: usize) -> PyResult<Option<Force>> {
        Ok(self.solver.force(self.contact_of(contact)?))
    }

    /// One time step: sweeps, the relative change in the last one, whether that is within the tolerance.
    fn solve(
        &mut self,
        py: Python<'_>,
        dt: f64,
        start: &str,
        sweeps: u32,
        tolerance: f64,
    ) -> PyResult<(u32, f64, bool)> {
        let step = TimeStep::new(dt).map_err(refused)?;
        let start = match start {
            "last" => InitialGuess::Last,
            "zero" => InitialGuess::Zero,
            other => {
                return Err(refused(format!(
                    "start must be 'last' or 'zero', not {other:?}"
                )));
            }
        };
        let stop = SolverSettings {
            max_iterations: sweeps,
            tolerance,
        };
        let solver = &mut self.solver;
        let report = py.detach(|| solver.solve(step, start, stop));
        Ok((report.iterations, report.residual, report.converged))
    }
}
