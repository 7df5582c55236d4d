//! Spheres between walls, with a material and a method for their contacts chosen at run time.

use super::{Material, OptionalFeatures, PackingRunError, WorldSnapshot, rigid};
use nalgebra::Vector3;
use std::fmt::Debug;
use tribos_base::record::{ContactRow, Partner};
use tribos_base::space::PeriodicBox;
use tribos_contacts::cd::AxisControl;
use tribos_contacts::cd::{ContactSolver, EnergyBalance, StepLimits, StepReport, Wall, WorldError};
use tribos_contacts::problem::GlobalProblem;
use tribos_core::contact::{ContactError, SphereBody};

/// Spheres and walls at the start.
#[derive(Clone, Debug)]
pub struct Bodies {
    pub space: PeriodicBox,
    pub positions: Vec<Vector3<f64>>,
    pub radii: Vec<f64>,
    pub walls: Vec<Wall>,
    /// Acceleration of all spheres.
    pub gravity: Vector3<f64>,
}

/// How the contacts of a step are found and solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Rigid spheres with constraint forces.
    ContactDynamics {
        solver: ContactSolver,
        step_limits: StepLimits,
        /// Slower groups that nothing touches are left alone.
        still_speed: f64,
    },
    /// Springs and dashpots.
    Soft(Springs),
}

/// The contacts of soft spheres. A step is as long as the limits allow and is made of stable ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Springs {
    /// Damping ratio of a material without restitution.
    pub damping: f64,
    pub steps_per_collision: f64,
    pub step_limits: StepLimits,
}

/// Spheres between walls, with any contact modes.
pub trait Packing: Debug {
    /// Takes one step.
    fn step(&mut self) -> Result<StepReport, WorldError>;
    /// Elapsed time and number of steps.
    fn clock(&self) -> (f64, u64);
    /// Centres of the spheres.
    fn positions(&self) -> &[Vector3<f64>];
    /// Radii of the spheres.
    fn radii(&self) -> &[f64];
    /// Velocities, inverse masses and inertias of the spheres.
    fn spheres(&self) -> &[SphereBody<f64>];
    /// Walls, with their current places and velocities.
    fn walls(&self) -> &[Wall];
    /// Walls, which a body may move and load between two steps.
    fn walls_mut(&mut self) -> &mut [Wall];
    /// Puts a sphere that no force moves where its drive has it, with the velocity and spin of the next step.
    fn place(&mut self, sphere: usize, at: Vector3<f64>, motion: [Vector3<f64>; 2]);
    /// The periodic box, with the images of a sheared one at their current places.
    fn space(&self) -> PeriodicBox;
    /// Sets the acceleration of all spheres for the next steps.
    fn set_gravity(&mut self, gravity: Vector3<f64>);
    /// Sets what the axes of a deforming box follow in the next steps; a box that does not deform has none.
    fn set_axes(&mut self, _axes: [AxisControl; 3]) {}
    /// Energy balance.
    fn energy(&self) -> &EnergyBalance;
    /// Contacts that carry a force or lie within the range of cohesion, with the forces of the last
    /// step, including its impacts, at the current positions.
    fn contacts(&self) -> Result<Vec<ContactRow>, ContactError>;
    /// The contact problem of the last step, as data; `None` where the contacts have none of that form.
    fn problem(&self) -> Option<GlobalProblem>;
    /// Whether an overlap is an error of the solver, and neither the strain of a spring nor what a number of sweeps
    /// that was asked for leaves.
    fn is_rigid(&self) -> bool;
    /// The complete state of a run.
    fn snapshot(&self) -> WorldSnapshot;
}

/// Builds a packing at its start or from a stored state. Modes whose coefficient is zero are omitted if a
/// type without them exists.
pub(crate) fn build(
    material: &Material,
    bodies: Bodies,
    method: &Method,
    frozen: Option<&WorldSnapshot>,
) -> Result<Box<dyn Packing>, PackingRunError> {
    build_with(
        material,
        (bodies, &OptionalFeatures::default()),
        method,
        frozen,
    )
}

/// [`build`] with a shear or several materials.
pub(crate) fn build_with(
    material: &Material,
    bodies: (Bodies, &OptionalFeatures),
    method: &Method,
    frozen: Option<&WorldSnapshot>,
) -> Result<Box<dyn Packing>, PackingRunError> {
    rigid::build(material, bodies, method, frozen)
}

/// Vector from the first centre of a contact to the second, or perpendicular to the wall.
pub(crate) fn branch(contact: &ContactRow, radii: &[f64]) -> Vector3<f64> {
    let other = contact.b.particle().map_or(0.0, |b| radii[b as usize]);
    contact.normal * (radii[contact.a as usize] + other + contact.gap)
}

/// True for a contact of a sphere with this wall.
pub(crate) fn is_at(contact: &ContactRow, wall: u32) -> bool {
    contact.b == Partner::Wall(wall)
}
