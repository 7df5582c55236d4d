//! Motion of spheres and plates: implicit time stepping with contact impulses (Moreau and Jean).

use super::cell::{CellBody, CellState};
use super::energy::EnergyBalance;
use super::error::WorldError;
use super::gauss_seidel::Iterations;
use super::impact::{self, Counts, Impacts};
use super::memory::Memory;
use super::moving_mesh::MovingMesh;
use super::operator::Operator;
use super::residual::{Coefficients, ContactResidual, residual};
use super::setup::WorldSetup;
use super::sleep::Sleep;
use super::solver::{Answer, Workspace};
use super::spheres::Spheres;
use super::wall::Wall;
use nalgebra::Vector3;
use std::sync::Arc;
use tribos_base::space::pairs::Cells;
use tribos_core::contact::{ContactFriction, ContactModes, SphereBody, WallBody};

/// Report of one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Length of the step.
    pub dt: f64,
    /// Cost of the solver for lasting contacts, and whether it met its stopping rule.
    pub iterations: Iterations,
    /// Whether sweeps handed the problem over to a solver with factorisations ([`crate::problem`]), because they
    /// missed their tolerance.
    pub handed_over: bool,
    /// Residual of the contact problem.
    pub residual: ContactResidual,
    /// Number of contacts in the problem.
    pub contacts: usize,
    /// Number of impacts with restitution; repeated impacts at the same contact count separately.
    pub impacts: usize,
    /// Rounds of impacts; each follows from the round before.
    pub impact_rounds: usize,
    /// Whether impacts still caused further impacts after the last round, the 100th. The remaining
    /// approach is then stopped without rebound.
    pub impacts_cut: bool,
    /// Reflections of impacts, and solutions of friction under them, that missed their tolerance of
    /// 1e-13 in 1000 sweeps: their impulses are approximate but do not raise the energy.
    pub impacts_unmet: usize,
    /// Number of spheres that were awake.
    pub awake: usize,
    /// Deepest overlap of two bodies as the step began, a length; 0 without one. Rigid bodies overlap by what the
    /// solver has missed so far.
    pub overlap: f64,
}

impl StepReport {
    /// Whether the solver met its stopping rule and the impacts ended, each within its tolerance.
    pub fn is_met(&self) -> bool {
        self.iterations.met && !self.impacts_cut && self.impacts_unmet == 0
    }
}

/// The complete state of a world: a run continues from it with identical bits.
#[derive(Clone, Debug, PartialEq)]
pub struct WorldState<M: ContactModes<f64>> {
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
    /// Displacement along x of the images one period higher along z, from 0 to the period; 0 without a shear.
    pub shear_offset: f64,
    /// The box and the speeds of its lengths, if it deforms.
    pub cell: Option<CellState>,
    /// Energy balance so far.
    pub energy: EnergyBalance,
    /// Contact forces of the last step, used as the initial guess for the next one.
    pub memory: Memory<M>,
    /// Mean forces of the last step's impacts with restitution: their impulses divided by the step. The
    /// force of a contact is the sum of both.
    pub impacts: Memory<M>,
    /// Sleep state of the bodies.
    pub sleep: Sleep,
}

/// Spheres, walls and their contacts.
///
/// ```
/// use tribos::cd::{WorldMaterials, WorldSetup, WorldState, StepReport, World, solid};
/// use tribos::kernel::contact::{Cohesion, NormalLaw, IndependentFriction};
/// use tribos::kernel::nalgebra::Vector3;
/// let smooth = WorldMaterials::uniform(NormalLaw::new(Cohesion::NONE, 1.0)?, IndependentFriction::none());
/// let ball = solid(0.05, 1900.0); // m, kg/m³
/// let setup = WorldSetup::new(smooth)
///     .sphere(Vector3::zeros(), 0.05, ball)
///     .sphere(Vector3::x() * 0.1, 0.05, ball);
/// // Two ivory balls at rest touch. The first is struck and hands all of its speed to the second.
/// let mut world = World::new(setup)?;
/// world.state_mut().spheres[0].velocity.x = 2.0;
/// let before: WorldState<_> = world.state().clone();
/// let report: StepReport = world.step()?;
/// assert!(report.is_met() && report.contacts == 1);
/// let speeds: Vec<f64> = world.state().spheres.iter().map(|ball| ball.velocity.x).collect();
/// assert!(speeds[0].abs() < 1e-12 && (speeds[1] - 2.0).abs() < 1e-12);
/// // A world that goes on from a state takes the same steps to the bit.
/// let mut again = World::resume(world.setup().clone(), before);
/// again.step()?;
/// assert_eq!(again.state(), world.state());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct World<F: ContactFriction<f64>> {
    pub(super) setup: WorldSetup<F>,
    pub(super) state: WorldState<F::Modes>,
    pub(super) problem: Spheres<F>,
    pub(super) cells: Cells,
    pub(super) neighbours: Vec<[u32; 2]>,
    /// Positions for which the neighbour list was built.
    pub(super) listed_at: Vec<Vector3<f64>>,
    /// Margin of that list.
    pub(super) skin: f64,
    /// Motion of the images since then, relative to the spheres.
    pub(super) drift: f64,
    /// Deepest overlap as the last step began.
    pub(super) overlap: f64,
    workspace: Workspace<F::Modes>,
    pub(super) impacts: Impacts<F>,
}

/// Closing speed that a step may leave at a closed contact, in units of the largest motion of a step: the
/// overlap of two bodies may grow by this in a step. Only the accelerated method uses it.
const OVERLAP: f64 = 1e-3;
/// Number of halvings of a step after which the run fails.
const MOST_HALVINGS: u32 = 40;

impl<F: ContactFriction<f64> + Coefficients> World<F> {
    /// A world at time 0.
    pub fn new(setup: WorldSetup<F>) -> Result<Self, WorldError> {
        setup.check()?;
        let mut state = WorldState {
            time: 0.0,
            steps: 0,
            positions: setup.positions.clone(),
            spheres: setup.spheres.clone(),
            walls: setup.walls.clone(),
            shear_offset: 0.0,
            cell: setup.cell.map(|cell| CellState {
                space: setup.space,
                speeds: cell.given_speeds(),
            }),
            energy: EnergyBalance::default(),
            memory: Memory::default(),
            impacts: Memory::default(),
            sleep: Sleep::new(setup.spheres.len()),
        };
        state.energy.before_first(state.spheres.iter());
        Ok(Self::resume(setup, state))
    }

    /// A world that continues from a state of a world with the same setup.
    pub fn resume(setup: WorldSetup<F>, state: WorldState<F::Modes>) -> Self {
        let friction = setup.laws.friction();
        let (mut problem, mut impacts) = (Spheres::new(friction), Impacts::new(friction));
        problem.mixture = setup.mixture.clone().map(Arc::new);
        impacts.friction.mixture.clone_from(&problem.mixture);
        Self {
            problem,
            state,
            cells: Cells::default(),
            neighbours: Vec::new(),
            listed_at: Vec::new(),
            skin: 0.0,
            drift: 0.0,
            overlap: 0.0,
            workspace: Workspace::default(),
            impacts,
            setup,
        }
    }

    /// Initial state and laws of the world.
    pub fn setup(&self) -> &WorldSetup<F> {
        &self.setup
    }

    /// The current state.
    pub fn state(&self) -> &WorldState<F::Modes> {
        &self.state
    }

    /// The current state, which may be changed between two steps.
    pub fn state_mut(&mut self) -> &mut WorldState<F::Modes> {
        &mut self.state
    }

    /// Sets the acceleration of all spheres for the next steps. Bodies that sleep feel it once they wake.
    /// *Domain*: finite; otherwise the next step fails.
    pub fn set_gravity(&mut self, gravity: Vector3<f64>) {
        self.setup.gravity = gravity;
    }

    /// The contact problem of the last step, with its solution. If the law has restitution, the
    /// contacts' impulses include those of impacts, which a [`residual`] cannot judge:
    /// [`StepReport::residual`] judges the problem without them.
    pub fn problem(&self) -> &Spheres<F> {
        &self.problem
    }

    /// Takes one step. A step in which something would move much farther than allowed is
    /// repeated with half the length.
    pub fn step(&mut self) -> Result<StepReport, WorldError> {
        let mut dt = self.time_step();
        self.list_neighbours()?;
        for _ in 0..MOST_HALVINGS {
            self.assemble(dt)?;
            let step = (
                self.state.steps,
                OVERLAP * self.setup.step_limits.motion / dt,
            );
            let answer = self
                .workspace
                .solve(&self.setup.solver, &mut self.problem, step);
            let speed = self.fastest(self.problem.moving(), &self.problem.plates)?;
            let images = self.problem.cell.as_ref().map_or(0.0, CellBody::fastest);
            let speed = speed.max(images);
            // Contacts were searched up to the distance that two bodies can cover with this motion.
            if speed * dt <= 2.0 * self.setup.step_limits.motion {
                return self.apply_step(dt, answer);
            }
            dt *= 0.5;
        }
        let speed = self.fastest(self.problem.moving(), &self.problem.plates)?;
        let step = self.state.steps;
        Err(WorldError::TooFast { step, speed })
    }

    /// The longest step in which nothing moves too far at its current velocity and load.
    fn time_step(&self) -> f64 {
        let WorldState { spheres, walls, .. } = &self.state;
        let plates: Vec<_> = walls.iter().map(|wall| wall.plate).collect();
        let speed = self.fastest(spheres.iter(), &plates).unwrap_or(0.0);
        let pull = |wall: &Wall| (wall.force * wall.plate.inv_mass).abs();
        let pushed = walls.iter().map(pull).fold(0.0, f64::max);
        let [_, pulled] = self.cell_motion();
        let acceleration = pushed.max(self.setup.gravity.norm()).max(pulled);
        let step_limits = &self.setup.step_limits;
        // v dt + a dt² = motion
        let root = (speed * speed + 4.0 * acceleration * step_limits.motion).sqrt();
        let dt = 2.0 * step_limits.motion / (speed + root);
        if dt < step_limits.longest {
            dt
        } else {
            step_limits.longest
        }
    }

    /// Largest speed of any body.
    fn fastest<'a>(
        &self,
        spheres: impl Iterator<Item = &'a SphereBody<f64>>,
        plates: &[WallBody<f64>],
    ) -> Result<f64, WorldError> {
        let mut fastest = 0.0_f64;
        let shear = self.shear_speed();
        for (body, sphere) in spheres.enumerate() {
            let speed = self.own_speed(body, sphere) + shear;
            if !(speed + sphere.spin.norm()).is_finite() {
                let step = self.state.steps;
                return Err(WorldError::NotFinite { step, body });
            }
            fastest = fastest.max(speed);
        }
        let plates = plates.iter().map(|plate| plate.velocity.norm());
        let mesh = self.setup.mesh.as_ref().map_or(0.0, MovingMesh::fastest);
        let fastest = fastest.max(mesh);
        Ok(plates.fold(fastest, f64::max))
    }

    /// Applies the solution: velocities, positions, memory, energy.
    fn apply_step(&mut self, dt: f64, answer: Answer) -> Result<StepReport, WorldError> {
        let residual = residual(&self.problem);
        let (problem, state) = (&self.problem, &mut self.state);
        let (mut before, mut loaded) = ((&state.spheres[..], &state.walls[..]), dt);
        let counts = if impact::has_restitution(self.setup.book()) {
            state.energy.add_impacts(&self.impacts.taken);
            before = (&self.impacts.spheres, &self.impacts.walls);
            loaded = 0.5 * dt;
            self.impacts.counts
        } else {
            Counts::default()
        };
        let gravity = &self.setup.gravity;
        state
            .energy
            .add_step(state.sleep.awake(), before, problem, gravity, loaded);
        state.spheres.clear();
        state.spheres.extend(problem.moving());
        for (x, sphere) in state.positions.iter_mut().zip(&state.spheres) {
            *x += sphere.velocity * dt;
        }
        for (wall, plate) in state.walls.iter_mut().zip(&problem.plates) {
            wall.plate = *plate;
            wall.place += wall.outward.dot(&plate.velocity) * dt;
        }
        state.memory.store(problem, dt, state.sleep.awake());
        let awake = state.sleep.awake().iter().filter(|awake| **awake).count();
        state.sleep.settle(
            self.setup.sleep_speed,
            &mut state.spheres,
            &mut state.energy,
        );
        state.time += dt;
        state.steps += 1;
        self.shear(dt);
        self.drift_cell(dt)?;
        let (problem, state) = (&self.problem, &mut self.state);
        let contacts = problem.contacts();
        state.impacts.forces = self.impacts.mean_forces(dt);
        if counts.impacts > 0 {
            self.impacts.add_to(&mut self.problem);
        }
        Ok(StepReport {
            dt,
            iterations: answer.iterations,
            handed_over: answer.handed_over,
            residual,
            contacts,
            impacts: counts.impacts,
            impact_rounds: counts.rounds,
            impacts_cut: counts.cut,
            impacts_unmet: counts.unmet,
            awake,
            overlap: self.overlap,
        })
    }
}
