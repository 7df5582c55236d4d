//! Initial state, laws and parameters of a world.

use super::cell::{self, CellControl};
use super::error::WorldError;
use super::impact;
use super::mixture::{LawBook, MaterialTable};
use super::moving_mesh::MovingMesh;
use super::shear::flow;
use super::solver::ContactSolver;
use super::wall::{UNIT, Wall};
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;
use tribos_core::contact::{NormalLaw, SphereBody};

/// Laws of one kind of contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactMaterial<F> {
    /// Along the normal: cohesion and restitution.
    pub normal: NormalLaw<f64>,
    /// Friction.
    pub friction: F,
}

/// Contact laws of a world.
///
/// ```
/// use tribos::cd::WorldMaterials;
/// use tribos::kernel::contact::{Attraction, Cohesion, NormalLaw, IndependentFriction};
/// // Cohesive spheres that also roll and spin with resistance, between walls without friction.
/// let cohesion = Cohesion::new(1.0, 0.01, Attraction::Pull)?;
/// let mut laws = WorldMaterials::uniform(NormalLaw::new(cohesion, 0.0)?, IndependentFriction::all(0.3, 0.1, 0.1)?);
/// laws.walls.friction = IndependentFriction::all(0.0, 0.0, 0.0)?;
/// assert_eq!(laws.pairs.normal, laws.walls.normal);
/// assert_eq!([laws.pairs, laws.walls].map(|law| law.friction.mu()), [0.3, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldMaterials<F> {
    /// Between spheres.
    pub pairs: ContactMaterial<F>,
    /// At walls.
    pub walls: ContactMaterial<F>,
}

impl<F: Copy> WorldMaterials<F> {
    /// The same laws between spheres and at walls.
    pub fn uniform(normal: NormalLaw<f64>, friction: F) -> Self {
        let laws = ContactMaterial { normal, friction };
        Self {
            pairs: laws,
            walls: laws,
        }
    }

    /// Friction of pairs and of walls.
    pub(crate) fn friction(&self) -> [F; 2] {
        [self.pairs.friction, self.walls.friction]
    }
}

impl<F> WorldMaterials<F> {
    /// Laws along the normal, of pairs and of walls.
    pub(crate) fn normal(&self) -> [NormalLaw<f64>; 2] {
        [self.pairs.normal, self.walls.normal]
    }
}

/// Limits of the time step. The default, 1 ms and 1 cm, suits bodies of centimetres in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLimits {
    /// Longest step, in time.
    pub longest: f64,
    /// Largest motion of a body that is expected in a step, a length. A step with a motion of
    /// more than twice this length is repeated with half the step.
    pub motion: f64,
}

impl Default for StepLimits {
    fn default() -> Self {
        Self {
            longest: 1e-3,
            motion: 1e-2,
        }
    }
}

/// Parameters of a world at time 0.
///
/// The [module](super) has an example.
#[derive(Clone, Debug)]
pub struct WorldSetup<F> {
    /// Periodic axes.
    pub space: PeriodicBox,
    /// Centres of the spheres.
    pub positions: Vec<Vector3<f64>>,
    /// Radii of the spheres.
    pub radii: Vec<f64>,
    /// Velocities, inverse masses and inertias of the spheres; see [`solid`]. A sphere whose inverses are both 0
    /// keeps its motion, whatever pushes it: fixed if it is at rest, driven otherwise.
    pub spheres: Vec<SphereBody<f64>>,
    /// Walls and pistons.
    pub walls: Vec<Wall>,
    /// A wall of triangles. Its contacts are numbered after those of the other walls.
    pub mesh: Option<MovingMesh>,
    /// Contact laws.
    pub laws: WorldMaterials<F>,
    /// Materials of the bodies and their laws, in place of `laws`, if there are several.
    pub mixture: Option<MaterialTable<F>>,
    /// Acceleration of all spheres.
    pub gravity: Vector3<f64>,
    /// Rate of a simple shear, the velocity along x over the height along z; 0 for none. It needs periods along
    /// both axes; see [`WorldSetup::sheared`].
    pub shear_rate: f64,
    /// How the periodic cell is deformed; none if it keeps its lengths. See [`WorldSetup::deforming`].
    pub cell: Option<CellControl>,
    /// Limits of the time step.
    pub step_limits: StepLimits,
    /// How contacts are solved.
    pub solver: ContactSolver,
    /// Sleep threshold: a group of touching bodies slower than this, surface speed included, is put to
    /// sleep until disturbed; 0 keeps everything awake.
    pub sleep_speed: f64,
}

impl<F> WorldSetup<F> {
    /// Open space without bodies and gravity, where nothing sleeps, with the default [`StepLimits`] and
    /// [`ContactSolver`].
    pub fn new(laws: WorldMaterials<F>) -> Self {
        Self {
            space: PeriodicBox::OPEN,
            positions: Vec::new(),
            radii: Vec::new(),
            spheres: Vec::new(),
            walls: Vec::new(),
            mesh: None,
            laws,
            mixture: None,
            gravity: Vector3::zeros(),
            shear_rate: 0.0,
            cell: None,
            step_limits: StepLimits::default(),
            solver: ContactSolver::default(),
            sleep_speed: 0.0,
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

    /// Shears the periodic cell, and adds the velocity of the flow at its height to every sphere given so far.
    ///
    /// *Formula*: v_x = rate (z − L_z/2). Images one period L_z higher move faster by rate L_z (Lees and
    /// Edwards 1972). *Domain*: x and z are periodic, walls are parallel to the flow and its gradient, and
    /// nothing sleeps.
    ///
    /// ```
    /// use tribos::cd::{WorldMaterials, WorldSetup, World, solid};
    /// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
    /// use tribos::kernel::nalgebra::Vector3;
    /// use tribos::space::PeriodicBox;
    /// let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::sliding(0.5)?);
    /// let mut setup = WorldSetup::new(laws).sphere(Vector3::z() * 7.5, 1.0, solid(1.0, 1.0));
    /// setup.space = PeriodicBox::new([Some(10.0), Some(10.0), Some(10.0)])?;
    /// let mut world = World::new(setup.sheared(0.1))?;
    /// world.step()?;
    /// // A lone sphere moves with the flow at its height, and the images above it faster by 0.1 · 10.
    /// let state = world.state();
    /// assert_eq!(state.spheres[0].velocity, Vector3::x() * 0.25);
    /// assert!((state.shear_offset - state.time).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn sheared(mut self, rate: f64) -> Self {
        self.shear_rate = rate;
        for (x, sphere) in self.positions.iter().zip(&mut self.spheres) {
            sphere.velocity += flow(rate, &self.space, x.z);
        }
        self
    }

    /// Deforms the periodic cell, and adds the velocity of its flow to every sphere given so far.
    ///
    /// *Domain*: controls of periodic axes; no restitution, walls, mesh, or spheres that keep their motion; nothing sleeps.
    ///
    /// ```
    /// use tribos::cd::{AxisControl, CellControl, WorldMaterials, WorldSetup, World, solid};
    /// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
    /// use tribos::kernel::nalgebra::Vector3;
    /// use tribos::space::PeriodicBox;
    /// let laws = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.0)?, IndependentFriction::none());
    /// // 27 spheres of radius 1 in rows, pressed until they touch by 1 kPa along each axis.
    /// let mut setup = WorldSetup::new(laws);
    /// setup.space = PeriodicBox::new([Some(6.15); 3])?;
    /// for site in 0..27 {
    ///     let place = [1, 3, 9].map(|stride| 1.0 + 2.05 * f64::from(site / stride % 3));
    ///     setup = setup.sphere(Vector3::from(place), 1.0, solid(1.0, 1.0));
    /// }
    /// let cell = CellControl { axes: [AxisControl::Stress(1e3); 3], shear_rate: 0.0, mass: 100.0 };
    /// let mut world = World::new(setup.deforming(cell))?;
    /// while world.state().time < 0.5 {
    ///     world.step()?;
    /// }
    /// // Three planes of contacts along each axis bear P L² each; how nine rigid rows share it is their own affair.
    /// assert!((world.space().lengths()[0].unwrap_or(0.0) - 6.0).abs() < 1e-6);
    /// let borne: f64 = world.state().memory.forces[0].iter().map(|(_, force)| force.normal).sum();
    /// assert!((borne / (9.0 * 1e3 * 36.0) - 1.0).abs() < 1e-5, "{borne}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn deforming(mut self, control: CellControl) -> Self {
        let speeds = control.given_speeds();
        for (x, sphere) in self.positions.iter().zip(&mut self.spheres) {
            sphere.velocity += cell::flow(&self.space, &speeds, control.shear_rate, x);
        }
        (self.cell, self.shear_rate) = (Some(control), control.shear_rate);
        self
    }

    /// Refuses a cell that cannot be deformed.
    fn check_cell(&self) -> Result<(), WorldError> {
        let Some(cell) = &self.cell else {
            return Ok(());
        };
        cell.check(&self.space)?;
        let is_alone = self.walls.is_empty() && self.mesh.is_none() && self.sleep_speed == 0.0;
        let bounces = impact::has_restitution(self.book());
        if is_alone && !bounces && !self.spheres.iter().any(keeps_motion) {
            Ok(())
        } else {
            Err(WorldError::RigidCell)
        }
    }

    /// The laws of the bodies.
    #[doc(hidden)]
    pub fn book(&self) -> LawBook<'_, F> {
        LawBook {
            laws: &self.laws,
            mixture: self.mixture.as_ref(),
        }
    }

    /// Refuses a shear of a cell that cannot be sheared.
    fn check_shear(&self) -> Result<(), WorldError> {
        let rate = self.shear_rate;
        let [x, _, z] = self.space.lengths();
        let beside = |wall: &Wall| wall.outward.x == 0.0 && wall.outward.z == 0.0;
        let can = x.is_some() && z.is_some() && self.sleep_speed == 0.0;
        if rate == 0.0 || (can && rate.is_finite() && self.walls.iter().all(beside)) {
            Ok(())
        } else {
            Err(WorldError::Shear { rate })
        }
    }
}

/// Range of masses whose squared impulses neither vanish nor overflow: the solvers compare squares.
const MASSES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

impl<F> WorldSetup<F> {
    /// Refuses parameters with which no step is possible.
    pub(crate) fn check(&self) -> Result<(), WorldError> {
        let StepLimits { longest, motion } = self.step_limits;
        let valid = |x: f64| x > 0.0 && x.is_finite();
        if !(valid(longest) && valid(motion)) {
            return Err(WorldError::StepLimits { longest, motion });
        }
        let given = self.sleep_speed;
        if !(given >= 0.0 && given.is_finite()) {
            return Err(WorldError::StillSpeed { given });
        }
        let [positions, radii] = [self.positions.len(), self.radii.len()];
        let spheres = self.spheres.len();
        if positions != spheres || radii != spheres {
            return Err(WorldError::Count {
                positions,
                radii,
                spheres,
            });
        }
        if let Some(body) = self.radii.iter().position(|radius| !valid(*radius)) {
            let given = self.radii[body];
            return Err(WorldError::Radius { body, given });
        }
        if !self.gravity.iter().all(|part| part.is_finite()) {
            return Err(WorldError::Gravity);
        }
        self.check_shear()?;
        self.check_cell()?;
        let fits = |mixture: &MaterialTable<F>| mixture.fits(spheres, self.walls.len());
        if !self.mixture.as_ref().is_none_or(fits) {
            return Err(WorldError::Mixture);
        }
        let sphere = |sphere: &SphereBody<f64>| {
            let moves = MASSES.contains(&(1.0 / sphere.inv_mass)) && valid(sphere.inv_inertia);
            (moves || keeps_motion(sphere))
                && (sphere.velocity.norm() + sphere.spin.norm()).is_finite()
        };
        if let Some(body) = self.spheres.iter().position(|body| !sphere(body)) {
            return Err(WorldError::Sphere { body });
        }
        let wall = |wall: &Wall| {
            // An edge pushes along other lines than a piston moves.
            let has_edges = wall.edges.as_ref().is_none_or(|edges| {
                wall.plate.inv_mass == 0.0 && edges.fits(&wall.outward, &self.space)
            });
            has_edges
                && (wall.outward.norm() - 1.0).abs() <= UNIT
                && (wall.place + wall.force + wall.plate.velocity.norm()).is_finite()
                && wall.plate.inv_mass >= 0.0
                && wall.plate.inv_mass.is_finite()
        };
        if !self.mesh.as_ref().is_none_or(MovingMesh::is_valid) {
            return Err(WorldError::Mesh);
        }
        match self.walls.iter().position(|plane| !wall(plane)) {
            Some(wall) => Err(WorldError::Wall { wall }),
            None => Ok(()),
        }
    }
}

/// Whether no impulse changes the motion of a sphere.
pub(crate) fn keeps_motion(sphere: &SphereBody<f64>) -> bool {
    sphere.inv_mass == 0.0 && sphere.inv_inertia == 0.0
}

/// A solid sphere at rest. One whose mass is beyond all numbers has NaN in place of its inverse, which a world refuses: 0
/// is that of a sphere that [keeps its motion](WorldSetup::spheres).
///
/// ```
/// use tribos::cd::solid;
/// // A steel ball with a radius of 1 cm: 33 g, and an inertia of 2/5 m R².
/// let ball = solid(0.01, 7850.0);
/// assert!((1.0 / ball.inv_mass - 0.0329).abs() < 1e-4);
/// assert!((ball.inv_mass / ball.inv_inertia - 0.4 * 0.01 * 0.01).abs() < 1e-18);
/// ```
pub fn solid(radius: f64, density: f64) -> SphereBody<f64> {
    let mass = 4.0 / 3.0 * std::f64::consts::PI * (radius * radius * radius) * density;
    let mass = if mass.is_finite() { mass } else { f64::NAN };
    SphereBody {
        velocity: Vector3::zeros(),
        spin: Vector3::zeros(),
        inv_mass: 1.0 / mass,
        inv_inertia: 1.0 / (0.4 * mass * radius * radius),
    }
}
