//! Results of a step.

use rapier2d::prelude::*;

/// Friction of the floor on a body, as its mean over a step.
///
/// ```
/// use rapier2d::prelude::*;
/// use tribos_rapier2d::{Floor, Friction};
/// let mut world = PhysicsWorld::new();
/// world.gravity = Vector::ZERO;
/// let (puck, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.08).mass(0.17));
/// world.bodies[puck].add_force(Vector::new(0.2, 0.0), true); // mu N is 0.5 N
/// let mut floor = Floor::new(0.3, 9.81)?;
/// floor.step(&mut world);
/// let Friction { force, holds, .. } = floor.friction(puck).unwrap();
/// assert!(holds && (force.x + 0.2).abs() < 1e-6);
/// # Ok::<(), tribos_rapier2d::FloorError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct Friction {
    /// Force in newtons.
    pub force: Vector,
    /// Torque about the centre of mass in newton metres.
    pub torque: f32,
    /// Load on the floor in newtons.
    pub load: f32,
    /// Whether the body is at rest.
    pub holds: bool,
}

/// End of sliding within the last step.
///
/// ```
/// use rapier2d::prelude::*;
/// use tribos_rapier2d::{Floor, Stop};
/// let mut world = PhysicsWorld::new();
/// world.gravity = Vector::ZERO;
/// let body = RigidBodyBuilder::dynamic().linvel(Vector::new(1.0, 0.0));
/// let (puck, _) = world.insert(body, ColliderBuilder::ball(0.08));
/// let mut floor = Floor::new(0.3, 9.81)?;
/// let dt = world.integration_parameters.dt;
/// let stop = (0..60).find_map(|step| {
///     floor.step(&mut world);
///     let Stop { within_step } = floor.stop(puck)?;
///     Some(step as f32 * dt + within_step)
/// });
/// let exact = 1.0 / (0.3 * 9.81); // v/(mu g)
/// assert!((stop.unwrap() - exact).abs() < 1e-5);
/// # Ok::<(), tribos_rapier2d::FloorError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub struct Stop {
    /// Time from the beginning of the step in which the body came to rest, in seconds.
    pub within_step: f32,
}
