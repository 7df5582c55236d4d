//! Why a world cannot start or continue.

use tribos_base::record::brief;
use tribos_base::space::SpaceError;
use tribos_core::contact::ContactError;

/// Why a world cannot start or continue.
///
/// ```
/// use tribos::cd::{WorldMaterials, WorldSetup, World, WorldError, solid};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// use tribos::kernel::nalgebra::Vector3;
/// let smooth = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 1.0)?, IndependentFriction::none());
/// let mut setup = WorldSetup::new(smooth).sphere(Vector3::zeros(), 0.05, solid(0.05, 1900.0));
/// setup.step_limits.longest = 0.0;
/// assert!(matches!(World::new(setup), Err(WorldError::StepLimits { .. })));
/// # Ok::<(), tribos::kernel::law::LawError>(())
/// ```
#[derive(Debug, thiserror::Error)]
pub enum WorldError {
    /// A contact of two bodies has no normal.
    #[error("step {step}: sphere {body} and {other}: {cause}")]
    Touch {
        /// Number of the step.
        step: u64,
        /// First body.
        body: usize,
        /// The other sphere, or the wall.
        other: String,
        /// The kernel's reason.
        #[source]
        cause: ContactError,
    },
    /// The neighbour list could not be built.
    #[error("step {step}: {cause}")]
    Neighbours {
        /// Number of the step.
        step: u64,
        /// The reason.
        #[source]
        cause: SpaceError,
    },
    /// A velocity is infinite or NaN.
    #[error("step {step}: the velocity of sphere {body} is not finite")]
    NotFinite {
        /// Number of the step.
        step: u64,
        /// Number of the sphere.
        body: usize,
    },
    /// No step is short enough for the motion.
    #[error(
        "step {step}: something moves {} however short the step; its load is too large",
        brief(.speed)
    )]
    TooFast {
        /// Number of the step.
        step: u64,
        /// Speed of what moves too far.
        speed: f64,
    },
    /// The limits of the step allow no motion.
    #[error(
        "the longest step and the largest motion must be positive and finite, \
         not {longest} and {motion}"
    )]
    StepLimits {
        /// Longest step given.
        longest: f64,
        /// Largest motion given.
        motion: f64,
    },
    /// The sleep threshold would put every body to sleep, or is not a number.
    #[error("the speed of stillness must be finite and not negative, not {given}")]
    StillSpeed {
        /// Value given.
        given: f64,
    },
    /// The numbers of positions, radii and velocities differ.
    #[error(
        "{positions} positions, {radii} radii and {spheres} spheres: give one of each a sphere"
    )]
    Count {
        /// Number of positions.
        positions: usize,
        /// Number of radii.
        radii: usize,
        /// Number of spheres.
        spheres: usize,
    },
    /// A radius is not positive and finite.
    #[error("sphere {body}: the radius must be positive and finite, not {given}")]
    Radius {
        /// Number of the sphere.
        body: usize,
        /// Value given.
        given: f64,
    },
    /// Gravity is infinite or NaN.
    #[error("gravity must be finite")]
    Gravity,
    /// The numbers of bodies with a material are not those of the bodies.
    #[error("a mixture needs one material for each sphere and each wall")]
    Mixture,
    /// The cell cannot be sheared at this rate.
    #[error(
        "a shear needs a finite rate, not {rate}, periods along x and z, a sleep threshold of 0, and no walls \
         but those that face along y"
    )]
    Shear {
        /// Rate given.
        rate: f64,
    },
    /// An axis of a deforming cell does not repeat, or follows no number.
    #[error(
        "axis {axis} of the cell: only a periodic axis can follow a stress or a speed, and a finite one, not {given}"
    )]
    Cell {
        /// Axis: 0, 1 or 2 for x, y or z.
        axis: usize,
        /// Value given.
        given: f64,
    },
    /// A deforming cell of rigid spheres has what it cannot have.
    #[error(
        "a deforming cell of rigid spheres has no restitution, walls, mesh or spheres that keep their motion, and nothing in it \
         sleeps"
    )]
    RigidCell,
    /// The axes of a cell under a stress have no mass.
    #[error(
        "the mass of an axis of the cell under a stress must be positive and finite, not {given}"
    )]
    CellMass {
        /// Value given.
        given: f64,
    },
    /// A sphere has a mass outside the valid range, or a state that is not finite.
    #[error(
        "sphere {body}: the mass must lie between 1e-100 and 1e100, the inertia must be positive \
         and finite, or both infinite, velocities finite; other units help"
    )]
    Sphere {
        /// Number of the sphere.
        body: usize,
    },
    /// The spring of a soft contact is not positive and finite.
    #[error("the stiffness of a contact must be positive and finite, not {given}")]
    Stiffness {
        /// Value given.
        given: f64,
    },
    /// The dashpot of a soft contact is negative or not finite.
    #[error("the damping ratio of a contact must be finite and not negative, not {given}")]
    Damping {
        /// Value given.
        given: f64,
    },
    /// A collision of soft spheres has too few steps.
    #[error("a collision needs at least 2 steps, and a finite number of them, not {given}")]
    StepsPerCollision {
        /// Value given.
        given: f64,
    },
    /// Soft spheres were given a cohesion that only resists opening.
    #[error(
        "cohesion that only resists opening needs constraint forces: soft spheres know a pull, \
         Attraction::Pull"
    )]
    Resistance,
    /// The motion of a mesh is not finite, or its axis is no unit vector.
    #[error("mesh: velocity, rate and centre must be finite, and the axis must have length 1")]
    Mesh,
    /// A wall's normal is not a unit vector, its state is not finite, or its edges bound no rectangle.
    #[error(
        "wall {wall}: the normal must have length 1, place, velocity and force must be finite; a wall with edges \
         is fixed, and along a periodic axis it has both ends or none"
    )]
    Wall {
        /// Number of the wall.
        wall: usize,
    },
}
