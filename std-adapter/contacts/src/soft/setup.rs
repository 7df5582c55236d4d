//! Initial state, laws and parameters of a world of soft spheres.

use super::law::Law;
use super::law::Stiffness;
use crate::cd::{self, CellControl, MovingMesh, StepLimits, Wall, WorldError, WorldMaterials};
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::{Attraction, SphereBody};

/// Parameters of a world of soft spheres at time 0.
///
/// The [module](super) has an example.
#[derive(Clone, Debug)]
pub struct SoftSetup<F> {
    /// Periodic axes.
    pub space: PeriodicBox,
    /// Centres of the spheres.
    pub positions: Vec<Vector3<f64>>,
    /// Radii of the spheres.
    pub radii: Vec<f64>,
    /// Velocities, inverse masses and inertias of the spheres; see [`solid`](crate::cd::solid). A sphere whose inverses
    /// are both 0 keeps its motion.
    pub spheres: Vec<SphereBody<f64>>,
    /// Walls and pistons.
    pub walls: Vec<Wall>,
    /// A wall of triangles. Its contacts are numbered after those of the other walls.
    pub mesh: Option<MovingMesh>,
    /// Cohesion and friction. A restitution above 0 stands for the [`Stiffness::damping_ratio_of`] ratio that leads to it.
    pub laws: WorldMaterials<F>,
    /// Normal spring of every contact.
    pub stiffness: Stiffness,
    /// Damping ratio ζ of the contacts whose law has no restitution.
    pub damping: f64,
    /// Acceleration of all spheres.
    pub gravity: Vector3<f64>,
    /// Longest step, in time; contacts usually need shorter ones.
    pub longest: f64,
    /// Least number of steps of a collision: at least 2.
    pub steps_per_collision: f64,
    /// How the periodic box is deformed, if it is.
    pub cell: Option<CellControl>,
}

/// Usual steps of a collision: its restitution is then right to 0.5 % from e = 0.1 to 1.
#[doc(hidden)]
pub const STEPS_PER_COLLISION: f64 = 35.0;
/// Fewest steps of a collision: with one the bodies could pass each other's centres.
const FEWEST_STEPS: f64 = 2.0;

impl<F> SoftSetup<F> {
    /// Open space without bodies and gravity, with critical damping, steps of at most 1 ms and 35 steps a
    /// collision.
    pub fn new(laws: WorldMaterials<F>, stiffness: Stiffness) -> Self {
        Self {
            space: PeriodicBox::OPEN,
            positions: Vec::new(),
            radii: Vec::new(),
            spheres: Vec::new(),
            walls: Vec::new(),
            mesh: None,
            laws,
            stiffness,
            damping: 1.0,
            gravity: Vector3::zeros(),
            longest: StepLimits::default().longest,
            steps_per_collision: STEPS_PER_COLLISION,
            cell: None,
        }
    }

    /// Adds one sphere with its centre at `position`.
    #[must_use]
    pub fn sphere(mut self, position: Vector3<f64>, radius: f64, sphere: SphereBody<f64>) -> Self {
        self.positions.push(position);
        self.radii.push(radius);
        self.spheres.push(sphere);
        self
    }

    /// Adds one wall.
    #[must_use]
    pub fn wall(mut self, wall: Wall) -> Self {
        self.walls.push(wall);
        self
    }

    /// Sets the acceleration of all spheres.
    #[must_use]
    pub fn gravity(self, gravity: Vector3<f64>) -> Self {
        Self { gravity, ..self }
    }
}

impl<F: Copy> SoftSetup<F> {
    /// Refuses parameters with which no step is possible.
    pub(super) fn check(&self) -> Result<(), WorldError> {
        let given = self.stiffness.given();
        if !(given > 0.0 && given.is_finite()) {
            return Err(WorldError::Stiffness { given });
        }
        let given = self.damping;
        if !(given >= 0.0 && given.is_finite()) {
            return Err(WorldError::Damping { given });
        }
        let given = self.steps_per_collision;
        if !(given >= FEWEST_STEPS && given.is_finite()) {
            return Err(WorldError::StepsPerCollision { given });
        }
        let resists = |law: tribos_core::contact::NormalLaw<f64>| {
            law.cohesion().attraction() == Attraction::Resistance
        };
        if self.laws.normal().map(resists) != [false; 2] {
            return Err(WorldError::Resistance);
        }
        // Bodies and walls follow the rules of contact dynamics.
        let bodies = cd::WorldSetup {
            space: self.space,
            positions: self.positions.clone(),
            radii: self.radii.clone(),
            spheres: self.spheres.clone(),
            walls: self.walls.clone(),
            mesh: self.mesh.clone(),
            gravity: self.gravity,
            step_limits: StepLimits {
                longest: self.longest,
                ..StepLimits::default()
            },
            ..cd::WorldSetup::new(self.laws)
        };
        if let Some(cell) = &self.cell {
            cell.check(&self.space)?;
        }
        bodies.check()
    }

    /// Laws of pairs and of contacts with walls.
    pub(super) fn contact_laws(&self) -> [Law<F>; 2] {
        [self.laws.pairs, self.laws.walls].map(|law| {
            let restitution = law.normal.restitution();
            Law {
                stiffness: self.stiffness,
                damping: if restitution > 0.0 {
                    Stiffness::damping_ratio_of(restitution)
                } else {
                    self.damping
                },
                cohesion: *law.normal.cohesion(),
                friction: law.friction,
            }
        })
    }
}
