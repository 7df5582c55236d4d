//! Motion of soft spheres and plates: leapfrog, with velocities at the ends of the steps.

use super::cell::CellLoads;
use super::contact::{Energies, Motion, SoftContact};
use super::law::{Law, Laws};
use super::mesh::{Met, find};
use super::setup::SoftSetup;
use super::step_length::{StepLength, fastest};
use crate::cd::cell::image;
use crate::cd::{
    EnergyBalance, Facing, Iterations, MaterialTable, MovingMesh, StepReport, Wall, WorldError,
    keeps_motion,
};
use nalgebra::Vector3;
use rayon::prelude::*;
use tribos_base::space::PeriodicBox;
use tribos_base::space::pairs::Cells;
use tribos_core::contact::{
    ContactBody, ContactError, ContactFriction, ContactGeometry, ContactModes, ContactVector,
    SphereBody,
};

/// The complete state of a world of soft spheres: a run continues from it with identical bits.
#[derive(Clone, Debug, PartialEq)]
pub struct SoftState<M: ContactModes<f64>> {
    /// Elapsed time.
    pub time: f64,
    /// Number of steps so far.
    pub steps: u64,
    /// Centres of the spheres, not wrapped into the periodic box.
    pub positions: Vec<Vector3<f64>>,
    /// Velocities, inverse masses and inertias of the spheres.
    pub spheres: Vec<SphereBody<f64>>,
    /// Walls with their current positions and velocities.
    pub walls: Vec<Wall>,
    /// The periodic box, with the images of a sheared one at their current places.
    pub space: PeriodicBox,
    /// Speeds at which the lengths of the box change.
    pub speeds: [f64; 3],
    /// Energy balance so far.
    pub energy: EnergyBalance,
    /// Pairs of neighbours, and spheres near walls, in ascending order of the bodies. Most of them are apart.
    pub contacts: [Vec<SoftContact<M>>; 2],
    /// Energies of springs and cohesion at the start, once it has been left.
    #[doc(hidden)]
    pub origin: Option<[f64; 2]>,
}

/// Soft spheres, walls and their contacts.
///
/// ```
/// use tribos::cd::{WorldMaterials, solid};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// use tribos::kernel::nalgebra::Vector3;
/// use tribos::soft::{SoftSetup, SoftContact, SoftState, Stiffness, SoftWorld};
/// let bouncy = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 0.8)?, IndependentFriction::none());
/// let ball = solid(0.05, 1900.0); // m, kg/m³
/// let setup = SoftSetup::new(bouncy, Stiffness::Linear(1e6)) // N/m
///     .sphere(Vector3::zeros(), 0.05, ball)
///     .sphere(Vector3::x() * 0.101, 0.05, ball);
/// let mut world = SoftWorld::new(setup)?;
/// world.state_mut().spheres[0].velocity.x = 2.0; // m/s
/// let mut deepest = 0.0_f64;
/// for _ in 0..200 {
///     world.step()?;
///     let contacts: &[SoftContact<_>] = &world.state().contacts[0];
///     deepest = contacts.iter().fold(deepest, |deepest, contact| deepest.max(-contact.gap));
/// }
/// assert!(deepest > 1e-3 && deepest < 1.5e-3); // m
/// // 1 m/s each of the common motion, and 0.8 of the relative one the other way.
/// let end: &SoftState<_> = world.state();
/// assert!((end.spheres[0].velocity.x - 0.2).abs() < 0.05);
/// assert!((end.spheres[1].velocity.x - 1.8).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SoftWorld<F: ContactFriction<f64>> {
    pub(super) setup: SoftSetup<F>,
    pub(super) state: SoftState<F::Modes>,
    laws: [Law<F>; 2],
    table: Option<MaterialTable<Law<F>>>,
    /// Largest gaps at which pairs, and spheres at walls, attract each other.
    pub(super) ranges: [f64; 2],
    length: StepLength,
    pub(super) cells: Cells,
    pub(super) skin: f64,
    /// Whether there is a list of neighbours, and the places for which it was built.
    pub(super) listed: bool,
    pub(super) listed_at: Vec<Vector3<f64>>,
    pub(super) listed_walls: Vec<f64>,
    /// Motion of the images since then, relative to the spheres.
    pub(super) image_drift: f64,
    /// Loads of the contacts on the cell.
    pub(super) cell_loads: CellLoads,
    /// Energies of all contacts in the last step.
    pub(super) energies: Vec<Result<Energies, ContactError>>,
    /// Force and torque on each sphere, force on each wall.
    loads: Vec<[Vector3<f64>; 2]>,
    wall_loads: Vec<Vector3<f64>>,
    /// Power that the mesh takes from the spheres, as the loads are.
    mesh_load: f64,
    /// Contacts in range at each wall.
    at_walls: Vec<usize>,
    /// Spheres in range of the mesh, and the time of its place.
    pub(super) met: Vec<Met>,
    pub(super) met_at: f64,
}

/// Force and springs of a contact, with its bodies.
pub(crate) type StoredContact<M> = ([u32; 2], [ContactVector<f64, M>; 2]);

/// Least number of neighbours for which threads are worth their start, and for one of them.
const WORTHWHILE: usize = 4096;
const SHARE_OF_THREAD: usize = 1024;

impl<F: ContactFriction<f64>> SoftWorld<F> {
    /// A world at time 0.
    pub fn new(setup: SoftSetup<F>) -> Result<Self, WorldError> {
        setup.check()?;
        let state = SoftState {
            time: 0.0,
            steps: 0,
            positions: setup.positions.clone(),
            spheres: setup.spheres.clone(),
            walls: setup.walls.clone(),
            space: setup.space,
            speeds: [0.0; 3],
            energy: EnergyBalance::default(),
            contacts: [Vec::new(), Vec::new()],
            origin: None,
        };
        let mut world = Self::resume(setup, state);
        world.add_flow();
        Ok(world)
    }

    /// A world that continues from a state of a world with the same setup.
    pub fn resume(setup: SoftSetup<F>, state: SoftState<F::Modes>) -> Self {
        let mut world = Self {
            laws: setup.contact_laws(),
            table: setup.contact_table(),
            ranges: setup.all_laws().map(|laws| {
                let ranges = laws.iter().map(|law| law.cohesion.range());
                ranges.fold(0.0, f64::max)
            }),
            length: StepLength::of(&setup),
            state,
            cells: Cells::default(),
            skin: 0.0,
            listed: false,
            listed_at: Vec::new(),
            listed_walls: Vec::new(),
            image_drift: 0.0,
            cell_loads: CellLoads::default(),
            energies: Vec::new(),
            loads: Vec::new(),
            wall_loads: Vec::new(),
            mesh_load: 0.0,
            at_walls: Vec::new(),
            met: Vec::new(),
            met_at: 0.0,
            setup,
        };
        world.skin = world.default_skin();
        world
    }

    /// Initial state and laws of the world.
    pub fn setup(&self) -> &SoftSetup<F> {
        &self.setup
    }

    /// The current state.
    pub fn state(&self) -> &SoftState<F::Modes> {
        &self.state
    }

    /// The current state, which may be changed between two steps.
    pub fn state_mut(&mut self) -> &mut SoftState<F::Modes> {
        &mut self.state
    }

    /// Sets the acceleration of all spheres from the next step on.
    pub fn set_gravity(&mut self, gravity: Vector3<f64>) {
        self.setup.gravity = gravity;
        self.length.set_gravity(&gravity);
    }

    /// Largest speed of any body.
    #[doc(hidden)]
    pub fn fastest(&self) -> f64 {
        let mesh = self.setup.mesh.as_ref().map_or(0.0, MovingMesh::fastest);
        fastest(&self.state.spheres, &self.state.walls).max(mesh)
    }

    /// Restores forces and springs of pairs and at walls, in ascending order of their bodies.
    #[doc(hidden)]
    pub fn restore(
        &mut self,
        stored: &[Vec<StoredContact<F::Modes>>; 2],
    ) -> Result<(), WorldError> {
        self.listed = false;
        self.list_neighbours()?;
        self.meet_mesh(0.0);
        let met = &self.met;
        let SoftState {
            positions,
            walls,
            contacts,
            steps,
            space,
            ..
        } = &mut self.state;
        let (space, radii) = (&*space, &self.setup.radii);
        for (kind, (contacts, stored)) in contacts.iter_mut().zip(stored).enumerate() {
            let mut stored = stored.iter().peekable();
            for contact in contacts {
                let Some((bodies, [force, springs])) =
                    stored.next_if(|(bodies, _)| *bodies == contact.bodies)
                else {
                    continue;
                };
                let [i, j] = bodies.map(|body| body as usize);
                let touch = if kind == 0 {
                    let apart = space.displacement(&positions[i], &positions[j]);
                    ContactGeometry::spheres(&apart, [radii[i], radii[j]])
                } else {
                    let wall = walls.get(j).map(|wall| wall.facing(space, &positions[i]));
                    let facing = wall.or_else(|| Some(find(met, *bodies)?.facing));
                    let Some(Facing { outward, height }) = facing else {
                        continue;
                    };
                    ContactGeometry::plate(height, &outward, radii[i])
                };
                let touch = touch.map_err(|cause| WorldError::Touch {
                    step: *steps,
                    body: i,
                    other: format!("body {j}"),
                    cause,
                })?;
                contact.restore(&touch, *force, *springs);
            }
        }
        Ok(())
    }

    /// Takes one step: forces change the velocities for its first half, these move the bodies and load the springs,
    /// the new forces change the velocities for its second half.
    pub fn step(&mut self) -> Result<StepReport, WorldError> {
        self.begin()?;
        self.impose_speeds()?;
        let deepest = self.add_loads(|contact| contact.in_range.then_some(&contact.force));
        let SoftState { spheres, walls, .. } = &self.state;
        let dt = self.length.next(spheres, walls, deepest, &self.at_walls);
        self.kick(0.5 * dt, 0.5 * dt);
        self.drift(dt);
        self.drift_cell(dt)?;
        self.check_motion()?;
        self.list_neighbours()?;
        let taken = self.find_forces(dt)?;
        self.add_loads(|contact| Some(&contact.impulse));
        self.kick(1.0, 0.5 * dt);
        self.check_motion()?;
        self.state.time += dt;
        self.state.steps += 1;
        self.enter(&taken);
        let contacts = self.state.contacts.iter().flatten();
        Ok(StepReport {
            dt,
            iterations: Iterations {
                sweeps: 0,
                met: true,
            },
            contacts: contacts.filter(|contact| contact.in_range).count(),
            awake: self.state.spheres.len(),
            overlap: deepest,
            ..StepReport::default()
        })
    }

    /// Forces and energies at the start of a run.
    fn begin(&mut self) -> Result<(), WorldError> {
        if !self.listed {
            self.list_neighbours()?;
        }
        if self.state.origin.is_none() {
            let start = self.find_forces(0.0)?;
            self.state.origin = Some([start.elastic, start.cohesion]);
            self.state.energy.kinetic_initial = Some(self.kinetic());
        }
        Ok(())
    }

    /// Sums forces or impulses of the contacts on the bodies; returns the deepest overlap.
    fn add_loads(
        &mut self,
        of: impl Fn(&SoftContact<F::Modes>) -> Option<&ContactVector<f64, F::Modes>>,
    ) -> f64 {
        let radii = &self.setup.radii;
        let mut deepest = 0.0_f64;
        self.loads.clear();
        self.loads.resize(radii.len(), [Vector3::zeros(); 2]);
        self.wall_loads.clear();
        self.wall_loads
            .resize(self.state.walls.len(), Vector3::zeros());
        self.at_walls.clear();
        self.at_walls.resize(self.state.walls.len(), 0);
        let mut cell = CellLoads::default();
        let pose = self.setup.mesh.as_ref().map(|mesh| mesh.at(self.met_at));
        let positions = &self.state.positions;
        self.mesh_load = 0.0;
        let [pairs, walls] = &self.state.contacts;
        for (contact, load) in pairs
            .iter()
            .filter_map(|contact| Some((contact, of(contact)?)))
        {
            let [i, j] = contact.bodies.map(|body| body as usize);
            let (force, couple) = (load.linear(&contact.normal), load.angular(&contact.normal));
            let turn = contact.normal.cross(&force);
            let distance = contact.gap + (radii[i] + radii[j]);
            self.load_cell(&mut cell, [i, j], &force, &(contact.normal * distance));
            let share = distance / (radii[i] + radii[j]);
            self.loads[i][0] -= force;
            self.loads[i][1] -= turn * (share * radii[i]) + couple;
            self.loads[j][0] += force;
            self.loads[j][1] -= turn * (share * radii[j]) - couple;
            deepest = deepest.max(-contact.gap);
        }
        self.cell_loads = cell;
        for (contact, load) in walls
            .iter()
            .filter_map(|contact| Some((contact, of(contact)?)))
        {
            let [i, w] = contact.bodies.map(|body| body as usize);
            let (force, couple) = (load.linear(&contact.normal), load.angular(&contact.normal));
            self.loads[i][0] -= force;
            let turn = contact.normal.cross(&force);
            self.loads[i][1] -= turn * (contact.gap + radii[i]) + couple;
            if let Some(wall) = self.wall_loads.get_mut(w) {
                *wall += force;
                self.at_walls[w] += 1;
            } else if let Some(pose) = &pose {
                let way = contact.normal * (contact.gap + radii[i]);
                let surface = pose.surface(&self.setup.space, &(positions[i] + way));
                self.mesh_load += force.dot(&surface.velocity) + couple.dot(&surface.spin);
            }
            deepest = deepest.max(-contact.gap);
        }
        deepest
    }

    /// New velocities after half a step, from the loads times a time.
    fn kick(&mut self, time: f64, half: f64) {
        self.kick_cell(time, half);
        let gravity = self.setup.gravity * half;
        let SoftState {
            spheres,
            walls,
            energy,
            ..
        } = &mut self.state;
        energy.work -= self.mesh_load * time;
        for (sphere, [force, torque]) in spheres.iter_mut().zip(&self.loads) {
            if keeps_motion(sphere) {
                // What drives it does the work of these forces.
                energy.work -= (force.dot(&sphere.velocity) + torque.dot(&sphere.spin)) * time;
                continue;
            }
            sphere.velocity += force * (sphere.inv_mass * time) + gravity;
            sphere.spin += torque * (sphere.inv_inertia * time);
        }
        for (wall, load) in walls.iter_mut().zip(&self.wall_loads) {
            let along = wall.outward.dot(load) * time;
            // What moves a wall without regard to forces does their work.
            let velocity = wall.plate.velocity;
            energy.work -= load.dot(&velocity) * time;
            if wall.plate.inv_mass > 0.0 {
                energy.work += along * wall.outward.dot(&velocity);
                let push = along + wall.force * half;
                wall.plate.velocity += wall.outward * (push * wall.plate.inv_mass);
            }
        }
    }

    /// New places after a step, and the work of weight and of the loads of pistons on the way.
    fn drift(&mut self, dt: f64) {
        let gravity = self.setup.gravity;
        let SoftState {
            positions,
            spheres,
            walls,
            energy,
            ..
        } = &mut self.state;
        let mut work = 0.0;
        for (sphere, x) in spheres.iter().zip(positions) {
            *x += sphere.velocity * dt;
            if keeps_motion(sphere) {
                continue;
            }
            work += gravity.dot(&sphere.velocity) / sphere.inv_mass;
        }
        for wall in walls {
            let speed = wall.outward.dot(&wall.plate.velocity);
            wall.place += speed * dt;
            if wall.plate.inv_mass > 0.0 {
                work += wall.force * speed;
            }
        }
        energy.work += work * dt;
    }

    /// Refuses velocities that have left the range of numbers.
    fn check_motion(&self) -> Result<(), WorldError> {
        let is_lost =
            |sphere: &SphereBody<f64>| !(sphere.velocity.norm() + sphere.spin.norm()).is_finite();
        let step = self.state.steps;
        if let Some(body) = self.state.spheres.iter().position(is_lost) {
            return Err(WorldError::NotFinite { step, body });
        }
        match self
            .state
            .walls
            .iter()
            .position(|wall| !wall.place.is_finite())
        {
            Some(wall) => Err(WorldError::Wall { wall }),
            None => Ok(()),
        }
    }

    /// Springs, forces and energies of all contacts after a step of length `dt`.
    fn find_forces(&mut self, dt: f64) -> Result<Energies, WorldError> {
        self.meet_mesh(dt);
        match self.table.take() {
            None => {
                let laws = self.laws;
                self.find_forces_by(&laws, dt);
            }
            Some(table) => {
                self.find_forces_by(&table, dt);
                self.table = Some(table);
            }
        }
        self.sum()
    }

    /// Springs, forces and energies by these laws, with the meetings of the mesh at hand.
    fn find_forces_by<L: Laws<F>>(&mut self, laws: &L, dt: f64) {
        let pose = self.setup.mesh.as_ref().map(|mesh| mesh.at(self.met_at));
        let met = &self.met;
        let SoftState {
            positions,
            spheres,
            walls,
            contacts,
            space,
            speeds,
            ..
        } = &mut self.state;
        let (space, radii) = (&*space, &self.setup.radii);
        let (speeds, cell) = (&*speeds, &self.setup.cell);
        let [pairs, at_walls] = contacts;
        let across = |contact: &mut SoftContact<F::Modes>| {
            let pair = laws.of_pair(contact.bodies);
            let [i, j] = contact.bodies.map(|body| body as usize);
            let between = [&positions[i], &positions[j]];
            let (apart, border) = match cell {
                None => (space.displacement(between[0], between[1]), Vector3::zeros()),
                Some(cell) => image(space, speeds, cell.shear_rate, between),
            };
            let gap = apart.norm() - (radii[i] + radii[j]);
            if is_apart(gap, pair.cohesion.range()) {
                let lever = radii[i] * radii[j] / (radii[i] + radii[j]);
                // What acts in the last half step acts here.
                if contact.in_range {
                    contact.normal = apart / (gap + (radii[i] + radii[j]));
                }
                return Ok(contact.part(gap, pair, lever, dt));
            }
            let touch = ContactGeometry::spheres(&apart, [radii[i], radii[j]])?;
            let motion = relative(&touch, &spheres[i], &spheres[j], &border);
            Ok(contact.advance(&touch, &motion, pair, dt))
        };
        self.energies.resize(pairs.len(), Ok(Energies::default()));
        if pairs.len() >= WORTHWHILE && rayon::current_num_threads() > 1 {
            let shared = pairs.par_iter_mut().with_min_len(SHARE_OF_THREAD);
            let energies = self.energies.par_iter_mut();
            shared
                .zip(energies)
                .for_each(|(contact, energy)| *energy = across(contact));
        } else {
            for (contact, energy) in pairs.iter_mut().zip(&mut self.energies) {
                *energy = across(contact);
            }
        }
        for contact in at_walls.iter_mut() {
            let wall = laws.at_wall(contact.bodies);
            let [i, w] = contact.bodies.map(|body| body as usize);
            let Some(plate) = walls.get(w) else {
                let radius = radii[i];
                let energies = match find(met, contact.bodies) {
                    // In the range of another material's cohesion.
                    Some(Met { facing, .. })
                        if L::ARE_MIXED
                            && is_apart(facing.height - radius, wall.cohesion.range()) =>
                    {
                        Ok(contact.part(facing.height - radius, wall, radius, dt))
                    }
                    Some(Met {
                        facing, surface, ..
                    }) => ContactGeometry::plate(facing.height, &facing.outward, radius).map(
                        |touch| {
                            let motion = relative(&touch, &spheres[i], surface, &Vector3::zeros());
                            contact.advance(&touch, &motion, wall, dt)
                        },
                    ),
                    None => {
                        // Beyond the end of a part its plane goes on, and nothing is there.
                        let number = (w - walls.len()) as u32;
                        let facing =
                            pose.and_then(|pose| pose.facing(number, space, &positions[i]));
                        let gap = facing.map_or(0.0, |facing| facing.height - radius);
                        let gap = gap.max(wall.cohesion.range().max(0.0));
                        Ok(contact.part(gap, wall, radius, dt))
                    }
                };
                self.energies.push(energies);
                continue;
            };
            let Facing { outward, height } = plate.facing(space, &positions[i]);
            let gap = height - radii[i];
            self.energies.push(if is_apart(gap, wall.cohesion.range()) {
                // A wall that was taken away has not opened a gap.
                let known = [gap, contact.gap].into_iter().find(|gap| gap.is_finite());
                let gap = known.unwrap_or(0.0);
                Ok(contact.part(gap, wall, radii[i], dt))
            } else {
                ContactGeometry::plate(height, &outward, radii[i]).map(|touch| {
                    let motion = relative(&touch, &spheres[i], &plate.plate, &Vector3::zeros());
                    contact.advance(&touch, &motion, wall, dt)
                })
            });
        }
    }
}

/// Whether nothing acts across a gap.
fn is_apart(gap: f64, range: f64) -> bool {
    gap >= 0.0 && gap > range
}

/// Motion of the second body against the first at their contact; `border` is the velocity of the second's
/// image against itself.
#[inline]
fn relative(
    touch: &ContactGeometry<f64>,
    a: &impl ContactBody<f64>,
    b: &impl ContactBody<f64>,
    border: &Vector3<f64>,
) -> Motion {
    let (spin_a, spin_b) = (a.angular_velocity(), b.angular_velocity());
    let turning = spin_a * touch.arms[0] + spin_b * touch.arms[1];
    Motion {
        velocity: b.velocity() + border - a.velocity() - turning.cross(&touch.normal),
        spin: spin_b - spin_a,
        turning: (spin_a + spin_b) * 0.5,
    }
}
