//! Initial state, laws and parameters of a world of soft spheres.

use super::law::{Law, Sprung, Stiffness};
use crate::cd::{
    self, CellControl, ContactMaterial, MaterialTable, MovingMesh, StepLimits, Wall, WorldError,
    WorldMaterials,
};
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
    /// Materials of the bodies, if there are several, in place of `laws` and `stiffness`.
    pub mixture: Option<MaterialTable<Sprung<F>>>,
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
            mixture: None,
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
        for law in self.materials() {
            let given = law.friction.stiffness.given();
            if !(given > 0.0 && given.is_finite()) {
                return Err(WorldError::Stiffness { given });
            }
            if law.normal.cohesion().attraction() == Attraction::Resistance {
                return Err(WorldError::Resistance);
            }
        }
        let walls = self.walls.len();
        let fits = |mixture: &MaterialTable<Sprung<F>>| mixture.fits(self.positions.len(), walls);
        if !self.mixture.as_ref().is_none_or(fits) {
            return Err(WorldError::Mixture);
        }
        let given = self.damping;
        if !(given >= 0.0 && given.is_finite()) {
            return Err(WorldError::Damping { given });
        }
        let given = self.steps_per_collision;
        if !(given >= FEWEST_STEPS && given.is_finite()) {
            return Err(WorldError::StepsPerCollision { given });
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

    /// Laws of pairs and of contacts with walls, where all are alike.
    pub(super) fn contact_laws(&self) -> [Law<F>; 2] {
        self.sprung().map(|law| Law::of(&law, self.damping))
    }

    /// Laws by the materials of the bodies, if there are several.
    pub(super) fn contact_table(&self) -> Option<MaterialTable<Law<F>>> {
        let mixture = self.mixture.as_ref()?;
        Some(mixture.map(|law| Law::of(law, self.damping)))
    }

    /// Laws that any contact may have, with those of pairs before those of walls.
    pub(super) fn all_laws(&self) -> [Vec<Law<F>>; 2] {
        let laws = self.materials();
        let of = |law: &ContactMaterial<Sprung<F>>| Law::of(law, self.damping);
        let (pairs, walls) = laws.split_at(laws.len() / 2);
        [pairs, walls].map(|laws| laws.iter().map(of).collect())
    }

    /// All materials: those of pairs, then as many of walls.
    fn materials(&self) -> Vec<ContactMaterial<Sprung<F>>> {
        let Some(mixture) = &self.mixture else {
            return self.sprung().to_vec();
        };
        let pairs = mixture.laws().iter().map(|laws| laws.pairs);
        pairs
            .chain(mixture.laws().iter().map(|laws| laws.walls))
            .collect()
    }

    /// The material of all pairs, and that of all walls.
    fn sprung(&self) -> [ContactMaterial<Sprung<F>>; 2] {
        [self.laws.pairs, self.laws.walls].map(|law| ContactMaterial {
            normal: law.normal,
            friction: Sprung {
                stiffness: self.stiffness,
                friction: law.friction,
            },
        })
    }
}
