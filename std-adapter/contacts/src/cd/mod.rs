//! Contact dynamics: rigid spheres and plates with constraint forces (thesis, section 4.4).
//!
//! A billiard ball that is struck through its centre slides at first and finally rolls with 5/7
//! of its initial speed, for any friction:
//!
//! ```
//! use tribos::cd::{WorldMaterials, WorldSetup, Wall, World, solid};
//! use tribos::kernel::contact::{Cohesion, NormalLaw, SphereBody, IndependentFriction};
//! use tribos::kernel::nalgebra::Vector3;
//!
//! let (up, radius) = (Vector3::z(), 0.028); // m
//! let ball = SphereBody { velocity: Vector3::x(), ..solid(radius, 1700.0) }; // m/s, kg/m³
//! let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::sliding(0.2)?);
//! let table = WorldSetup::new(laws).wall(Wall::fixed(up, 0.0)).gravity(up * -9.81);
//! let mut world = World::new(table.sphere(up * radius, radius, ball))?;
//! for _ in 0..200 {
//!     world.step()?;
//! }
//! let ball = &world.state().spheres[0];
//! assert!((ball.velocity.x - 5.0 / 7.0).abs() < 1e-12);
//! assert!((ball.spin.y * radius - ball.velocity.x).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod accelerated;
mod aligned;
mod assemble;
pub(crate) mod cell;
#[cfg(test)]
mod cell_tests;
mod energy;
mod error;
mod four_contacts;
mod gauss_seidel;
mod image;
mod impact;
mod impact_rest;
mod impact_round;
mod memory;
mod mesh;
mod mesh_grid;
#[cfg(test)]
mod mesh_tests;
mod mixture;
#[cfg(test)]
mod mixture_tests;
mod momentum;
mod moving_mesh;
mod operator;
mod pairs;
mod quads;
mod residual;
mod schedule;
mod setup;
mod shear;
#[cfg(test)]
mod shear_tests;
mod sleep;
mod solver;
mod spheres;
mod sweep;
#[cfg(test)]
mod sweep_tests;
mod to_problem;
mod vectors;
mod wall;
#[cfg(test)]
mod wall_tests;
mod world;

pub use cell::{AxisControl, CellControl, CellState};
pub use energy::EnergyBalance;
pub use error::WorldError;
pub use gauss_seidel::{IterationOrder, Iterations, StopRule};
pub use mesh::{Mesh, MeshError};
pub use mixture::MaterialTable;
pub use moving_mesh::MovingMesh;
#[doc(hidden)]
pub use moving_mesh::{Meeting, Pose, Surface};
pub use residual::ContactResidual;
pub(crate) use setup::keeps_motion;
pub use setup::{ContactMaterial, StepLimits, WorldMaterials, WorldSetup, solid};
pub use solver::{ContactSolver, SolverMethod};
#[doc(hidden)]
pub use wall::Facing;
pub use wall::{Rectangle, Wall};
pub use world::{StepReport, World, WorldState};

/// Internals of the solvers, public only for tests and benches of this project: no stable interface.
#[doc(hidden)]
pub mod internals {
    pub use super::accelerated::{Accelerated, Tolerance};
    pub use super::aligned::Aligned;
    pub use super::gauss_seidel::{Sweeper, solve};
    pub use super::memory::{Memory, StoredForce};
    pub use super::operator::{
        GlobalChange, Impulse, LocalChange, Monitor, NoMonitor, Operator, Visit,
    };
    pub use super::pairs::Pairs;
    pub use super::residual::{Coefficients, residual};
    pub use super::sleep::Sleep;
    pub use super::spheres::{Link, Spheres};
    pub use super::to_problem::PosedProblem;
}
