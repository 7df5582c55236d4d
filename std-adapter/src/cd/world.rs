//! Spheres and plates that move: implicit time stepping with contact impulses (Moreau and Jean).

use super::book::Book;
use super::island::Rest;
use super::memory::Memory;
use super::operator::Operator;
use super::residual::{Coefficients, Residual, residual};
use super::solver::{Solver, SolverState};
use super::spheres::{Link, Spheres};
use super::nsgs::Effort;
use crate::space::pairs::{Cells, NeighbourError};
use crate::space::PeriodicBox;
use nalgebra::Vector3;
use tribos_core::contact::{
    Contact, ContactFriction, NormalLaw, Plate, Sphere, Touch, TouchError,
};

/// A plane that bounds the space of the spheres: a wall, or a piston if it has a finite mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Unit normal, into the space of the spheres.
    pub outward: Vector3<f64>,
    /// Position along the normal: points x of the plane have outward·x = place.
    pub place: f64,
    /// Velocity and inverse mass.
    pub plate: Plate<f64>,
    /// Force on it along the normal; positive pushes it into the spheres' space.
    pub force: f64,
}

/// Contact laws of a world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laws<F> {
    /// Along the normal: between spheres, and at walls.
    pub normal: [NormalLaw<f64>; 2],
    /// Friction: between spheres, and at walls.
    pub friction: [F; 2],
}

/// Bounds of the time step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Longest step.
    pub longest: f64,
    /// Farthest that any body moves in a step, as a length.
    pub motion: f64,
}

/// A state that cannot go on.
#[derive(Debug, thiserror::Error)]
pub enum WorldError {
    /// Two bodies have no normal.
    #[error("step {step}: body {body} and {other}: {cause}")]
    Touch {
        /// Step of the run.
        step: u64,
        /// First body.
        body: usize,
        /// The other, or the wall.
        other: String,
        /// What is wrong.
        #[source]
        cause: TouchError,
    },
    /// The list of neighbours could not be made.
    #[error("step {step}: {cause}")]
    Neighbours {
        /// Step of the run.
        step: u64,
        /// What is wrong.
        #[source]
        cause: NeighbourError,
    },
    /// A velocity is infinite or NaN.
    #[error("step {step}: the velocity of body {body} is not finite")]
    NotFinite {
        /// Step of the run.
        step: u64,
        /// Which body.
        body: usize,
    },
    /// Nothing may move by the bound on motion.
    #[error("the longest step and the largest motion must be positive and finite, not {longest} and {motion}")]
    Pace {
        /// Given.
        longest: f64,
        /// Given.
        motion: f64,
    },
}

/// What one step did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Length of the step.
    pub dt: f64,
    /// Work of the solver.
    pub effort: Effort,
    /// What is left.
    pub residual: Residual,
    /// Contacts that took part.
    pub contacts: usize,
    /// Bodies that took part.
    pub awake: usize,
}

/// Spheres, walls and their contacts.
#[derive(Debug)]
pub struct World<F: ContactFriction<f64>> {
    /// Periodic axes.
    pub space: PeriodicBox,
    /// Centres.
    pub positions: Vec<Vector3<f64>>,
    /// Radii.
    pub radii: Vec<f64>,
    /// Velocities and inverse masses.
    pub spheres: Vec<Sphere<f64>>,
    /// Walls.
    pub walls: Vec<Wall>,
    /// Laws.
    pub laws: Laws<F>,
    /// Acceleration of all spheres.
    pub gravity: Vector3<f64>,
    /// Bounds of the step.
    pub pace: Pace,
    /// How contacts are solved.
    pub solver: Solver,
    /// Time so far.
    pub time: f64,
    /// Steps so far.
    pub steps: u64,
    /// Energy so far.
    pub book: Book,
    pub(super) memory: Memory<F::Modes>,
    pub(super) rest: Rest,
    state: SolverState<F::Modes>,
    cells: Cells,
    neighbours: Vec<[u32; 2]>,
    /// Positions at which the neighbours were listed.
    listed_at: Vec<Vector3<f64>>,
    problem: Spheres<F>,
}

/// Extra distance of listed neighbours over those that may touch, in largest motions of a step.
const SKIN: f64 = 8.0;

impl<F: ContactFriction<f64> + Coefficients> World<F> {
    /// A world at rest at time 0; spheres are solid, of the given density.
    pub fn new(
        space: PeriodicBox,
        (positions, radii): (Vec<Vector3<f64>>, Vec<f64>),
        density: f64,
        walls: Vec<Wall>,
        laws: Laws<F>,
        pace: Pace,
        solver: Solver,
    ) -> Result<Self, WorldError> {
        let spheres: Vec<_> = radii.iter().map(|&radius| solid(radius, density)).collect();
        let Pace { longest, motion } = pace;
        let valid = |x: f64| x > 0.0 && x.is_finite();
        if !(valid(longest) && valid(motion)) {
            return Err(WorldError::Pace { longest, motion });
        }
        let problem = Spheres {
            spheres: Vec::new(),
            plates: Vec::new(),
            free: (Vec::new(), Vec::new()),
            pairs: Vec::new(),
            walls: Vec::new(),
            friction: laws.friction,
        };
        Ok(Self {
            rest: Rest::new(spheres.len()),
            space,
            positions,
            radii,
            spheres,
            walls,
            laws,
            gravity: Vector3::zeros(),
            pace,
            state: SolverState::new(&solver),
            solver,
            time: 0.0,
            steps: 0,
            book: Book::default(),
            memory: Memory::default(),
            cells: Cells::default(),
            neighbours: Vec::new(),
            listed_at: Vec::new(),
            problem,
        })
    }

    /// The contact problem of the last step, with its solution.
    pub fn problem(&self) -> &Spheres<F> {
        &self.problem
    }

    /// Takes one step. A step in which something would move much farther than allowed is taken
    /// again with half the length.
    pub fn step(&mut self) -> Result<StepReport, WorldError> {
        let mut dt = self.time_step();
        loop {
            self.list_neighbours()?;
            self.assemble(dt)?;
            let effort = self.state.solve(&self.solver, &mut self.problem);
            let moved = self.fastest(&self.problem.spheres, &self.problem.plates)? * dt;
            // Contacts were sought as far as twice the allowed motion.
            if moved <= 2.0 * self.pace.motion {
                return Ok(self.commit(dt, effort));
            }
            dt *= 0.5;
        }
    }

    /// The longest step in which nothing moves too far by its present velocity and load.
    fn time_step(&self) -> f64 {
        let plates: Vec<_> = self.walls.iter().map(|wall| wall.plate).collect();
        let speed = self.fastest(&self.spheres, &plates).unwrap_or(0.0);
        let pull = |wall: &Wall| (wall.force * wall.plate.inv_mass).abs();
        let pushed = self.walls.iter().map(pull).fold(0.0, f64::max);
        let acceleration = pushed.max(self.gravity.norm());
        let motion = self.pace.motion;
        // v dt + a dt² = motion
        let dt = 2.0 * motion / (speed + (speed * speed + 4.0 * acceleration * motion).sqrt());
        if dt < self.pace.longest { dt } else { self.pace.longest }
    }

    fn fastest(&self, spheres: &[Sphere<f64>], plates: &[Plate<f64>]) -> Result<f64, WorldError> {
        let mut fastest_sq = 0.0_f64;
        for (body, sphere) in spheres.iter().enumerate() {
            let speed_sq = sphere.velocity.norm_squared();
            if !(speed_sq + sphere.spin.norm_squared()).is_finite() {
                return Err(WorldError::NotFinite {
                    step: self.steps,
                    body,
                });
            }
            fastest_sq = fastest_sq.max(speed_sq);
        }
        for plate in plates {
            fastest_sq = fastest_sq.max(plate.velocity.norm_squared());
        }
        Ok(fastest_sq.sqrt())
    }

    /// Distance within which two surfaces may act on each other in this step.
    fn reach(&self) -> f64 {
        let range = |law: &NormalLaw<f64>| law.cohesion().range();
        let [pair, wall] = &self.laws.normal;
        range(pair).max(range(wall)).max(4.0 * self.pace.motion)
    }

    /// Renews the list of neighbours once something has moved half the extra distance.
    fn list_neighbours(&mut self) -> Result<(), WorldError> {
        let skin = SKIN * self.pace.motion;
        let limit_sq = 0.25 * skin * skin;
        let moved = |(x, y): (&Vector3<f64>, &Vector3<f64>)| (x - y).norm_squared() > limit_sq;
        let fresh = self.listed_at.len() == self.positions.len()
            && !self.positions.iter().zip(&self.listed_at).any(moved);
        if fresh {
            return Ok(());
        }
        let reach = self.reach() + skin;
        self.neighbours = self
            .cells
            .find(&self.space, &self.positions, &self.radii, reach)
            .map_err(|cause| WorldError::Neighbours {
                step: self.steps,
                cause,
            })?
            .to_vec();
        self.listed_at.clone_from(&self.positions);
        Ok(())
    }

    /// Sets up the contact problem of a step: free velocities, contacts, guessed impulses.
    fn assemble(&mut self, dt: f64) -> Result<(), WorldError> {
        let reach = self.reach();
        let problem = &mut self.problem;
        problem.friction = self.laws.friction;
        problem.pairs.clear();
        problem.walls.clear();
        problem.free.0.clone_from(&self.spheres);
        problem.free.1.clear();
        problem.free.1.extend(self.walls.iter().map(|wall| wall.plate));

        // Who touches whom, and who is awake.
        let mut touches = Vec::new();
        for &[a, b] in &self.neighbours {
            let [i, j] = [a as usize, b as usize];
            let apart = self.space.displacement(&self.positions[i], &self.positions[j]);
            let far = self.radii[i] + self.radii[j] + reach;
            if apart.norm_squared() > far * far {
                continue;
            }
            let touch = Touch::spheres(&apart, [self.radii[i], self.radii[j]]).map_err(|cause| {
                WorldError::Touch {
                    step: self.steps,
                    body: i,
                    other: format!("body {j}"),
                    cause,
                }
            })?;
            touches.push(([a, b], touch));
        }
        let mut wall_touches = Vec::new();
        for (i, (x, &radius)) in self.positions.iter().zip(&self.radii).enumerate() {
            for (w, wall) in self.walls.iter().enumerate() {
                let height = wall.outward.dot(x) - wall.place;
                if height - radius > reach {
                    continue;
                }
                let touch = Touch::plate(height, &wall.outward, radius).map_err(|cause| {
                    WorldError::Touch {
                        step: self.steps,
                        body: i,
                        other: format!("wall {w}"),
                        cause,
                    }
                })?;
                wall_touches.push(([i as u32, w as u32], touch));
            }
        }
        self.rest.wake(&touches, &wall_touches, &self.walls);

        // Free motion of what is awake.
        for (sphere, awake) in problem.free.0.iter_mut().zip(self.rest.awake()) {
            if *awake && sphere.inv_mass > 0.0 {
                sphere.velocity += self.gravity * dt;
            }
        }
        for (plate, wall) in problem.free.1.iter_mut().zip(&self.walls) {
            plate.velocity += wall.outward * (wall.force * plate.inv_mass * dt);
        }
        let awake = self.rest.awake();
        for (bodies, touch) in &touches {
            let [a, b] = bodies.map(|body| body as usize);
            if !(awake[a] || awake[b]) {
                continue;
            }
            let (a, b) = (&self.spheres[a], &self.spheres[b]);
            let contact = Contact::new(touch, &self.laws.normal[0], a, b, dt);
            problem.pairs.push(Link {
                bodies: *bodies,
                contact,
            });
        }
        for (bodies, touch) in &wall_touches {
            let [a, w] = bodies.map(|body| body as usize);
            if !awake[a] {
                continue;
            }
            let (a, b) = (&self.spheres[a], &self.walls[w].plate);
            let contact = Contact::new(touch, &self.laws.normal[1], a, b, dt);
            problem.walls.push(Link {
                bodies: *bodies,
                contact,
            });
        }
        problem.spheres.clone_from(&problem.free.0);
        problem.plates.clone_from(&problem.free.1);
        if self.solver.warm_start {
            self.memory.recall(problem, dt);
        }
        problem.refresh();
        Ok(())
    }

    /// Takes over the solution: velocities, positions, memory, energy.
    fn commit(&mut self, dt: f64, effort: Effort) -> StepReport {
        let residual = residual(&self.problem);
        let problem = &self.problem;
        self.book.enter(&self.spheres, &self.walls, problem, &self.gravity, dt);
        self.spheres.clone_from(&problem.spheres);
        for (x, sphere) in self.positions.iter_mut().zip(&self.spheres) {
            *x += sphere.velocity * dt;
        }
        for (wall, plate) in self.walls.iter_mut().zip(&problem.plates) {
            wall.plate = *plate;
            wall.place += wall.outward.dot(&plate.velocity) * dt;
        }
        self.memory.keep(problem, dt, self.rest.awake());
        let awake = self.rest.awake().iter().filter(|awake| **awake).count();
        self.rest.settle(&mut self.spheres, &mut self.book);
        self.time += dt;
        self.steps += 1;
        StepReport {
            dt,
            effort,
            residual,
            contacts: problem.contacts(),
            awake,
        }
    }
}

/// A solid sphere at rest.
pub fn solid(radius: f64, density: f64) -> Sphere<f64> {
    let mass = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3) * density;
    Sphere {
        velocity: Vector3::zeros(),
        spin: Vector3::zeros(),
        inv_mass: 1.0 / mass,
        inv_inertia: 1.0 / (0.4 * mass * radius * radius),
    }
}
