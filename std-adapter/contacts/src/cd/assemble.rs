//! The contact problem of a step: contact search, free velocities, initial guess of the impulses.

use super::cell::{image_velocity, periods};
use super::error::WorldError;
use super::image::{ImageVelocity, Images, seen};
use super::impact::{self, Surroundings};
use super::moving_mesh::Surface;
use super::residual::Coefficients;
use super::setup::keeps_motion;
use super::spheres::Link;
use super::wall::Facing;
use super::world::World;
use tribos_core::contact::{Contact, ContactFriction, ContactGeometry, NormalLaw};

/// Bodies of a contact, and their geometry.
pub(super) type PairGeometry = ([u32; 2], ContactGeometry<f64>);

/// Margin of the neighbour list beyond the contact distance, in motions of a step: a longer
/// list remains valid for more steps.
const SKIN: f64 = 8.0;
/// Share of the room in a deforming box that a margin may take.
const ROOM: f64 = 0.99;
/// Distance at which surfaces may meet in a step: two bodies that each move by twice the usual motion.
const MEETING: f64 = 4.0;

impl<F: ContactFriction<f64> + Coefficients> World<F> {
    /// Distance within which two surfaces may act on each other in a step.
    pub(super) fn reach(&self) -> f64 {
        let book = self.setup.book();
        let ranges = book.all().map(|law| law.normal.cohesion().range());
        ranges.fold(MEETING * self.setup.step_limits.motion, f64::max)
    }

    /// Margin of the neighbour list; as much of it as a box that shrinks has room for, at least the motion of a step.
    fn room_for_skin(&self) -> f64 {
        let motion = self.setup.step_limits.motion;
        let skin = SKIN * motion;
        let Some(cell) = &self.state.cell else {
            return skin;
        };
        let widest = self.setup.radii.iter().fold(0.0, |most, &r| r.max(most));
        let lengths = cell.space.lengths().into_iter().flatten();
        let half = 0.5 * lengths.fold(f64::INFINITY, f64::min);
        skin.min(ROOM * (half - 2.0 * widest - self.reach()))
            .max(motion)
    }

    /// Renews the neighbour list once something has moved by half the margin.
    pub(super) fn list_neighbours(&mut self) -> Result<(), WorldError> {
        let margin = self.skin - self.drift;
        let far = |(x, y): (&_, &_)| nalgebra::Vector3::norm(&(x - y)) > 0.5 * margin;
        let positions = &self.state.positions;
        let listed = self.listed_at.len() == positions.len();
        if listed && margin > 0.0 && !positions.iter().zip(&self.listed_at).any(far) {
            return Ok(());
        }
        self.skin = self.room_for_skin();
        let reach = self.reach() + self.skin;
        let found = self
            .cells
            .find(&self.space(), positions, &self.setup.radii, reach);
        let found = found.map_err(|cause| WorldError::Neighbours {
            step: self.state.steps,
            cause,
        })?;
        self.neighbours.clear();
        let spheres = &self.state.spheres;
        // Two that keep their motion do not feel each other.
        let feels = |body: &u32| !keeps_motion(&spheres[*body as usize]);
        let meets = |pair: &&[u32; 2]| pair.iter().any(feels);
        self.neighbours.extend(found.iter().filter(meets));
        self.listed_at.clone_from(&self.state.positions);
        self.drift = 0.0;
        Ok(())
    }

    /// Sets up the problem of a step of length `dt`.
    pub(super) fn assemble(&mut self, dt: f64) -> Result<(), WorldError> {
        let (pairs, walls) = (self.touching_pairs()?, self.touching_walls()?);
        let gaps = pairs.iter().chain(&walls).map(|(_, touch)| touch.gap);
        self.overlap = gaps.fold(0.0, |deepest, gap| deepest.max(-gap));
        let [images, periods] = self.images(&pairs);
        let cell = self.cell_body(dt)?;
        let surfaces = self.surfaces(&walls);
        let state = &mut self.state;
        state
            .sleep
            .wake(self.setup.sleep_speed, &pairs, &walls, &state.walls);
        let awake = state.sleep.awake();
        let problem = &mut self.problem;

        // Impacts come first, at the middle of the step's load.
        let book = self.setup.book();
        let (mut spheres, mut walls_before, mut loaded) = (&state.spheres, &state.walls, dt);
        if impact::has_restitution(book) {
            let around = Surroundings {
                touching: [&pairs, &walls],
                images: &images,
                awake,
                book,
                gravity: &self.setup.gravity,
                surfaces: &surfaces,
                dt,
            };
            self.impacts.run((spheres, walls_before), &around);
            (spheres, walls_before) = (&self.impacts.spheres, &self.impacts.walls);
            loaded = 0.5 * dt;
        }

        // Free motion of the bodies that are awake.
        problem.free.0.clone_from(spheres);
        for (sphere, _) in problem
            .free
            .0
            .iter_mut()
            .zip(awake)
            .filter(|(sphere, awake)| **awake && !keeps_motion(sphere))
        {
            sphere.velocity += self.setup.gravity * loaded;
        }
        problem.free.1.clear();
        problem
            .free
            .1
            .extend(walls_before.iter().map(|wall| wall.plate));
        for (plate, wall) in problem.free.1.iter_mut().zip(walls_before) {
            plate.velocity += wall.outward * (wall.force * plate.inv_mass * loaded);
        }

        // Lasting contacts; contacts that rebound were treated as impacts.
        let [pair, wall] = book.laws.normal().map(without_restitution);
        problem.pairs.clear();
        problem.images.clear();
        // Images of a cell that deforms are told by their periods.
        let is_rigid = cell.is_none();
        problem.cell = cell;
        let (mut images, mut periods) = (Images::new(&images), Images::new(&periods));
        for (number, (bodies, touch)) in pairs.iter().enumerate() {
            let [a, b] = bodies.map(|body| body as usize);
            let (image, away) = (images.of(number), periods.of(number));
            if awake[a] || awake[b] {
                let (a, b) = (&spheres[a], &seen(&spheres[b], image));
                let law = match book.mixture {
                    None => pair,
                    Some(mixture) => without_restitution(mixture.of_pair(*bodies).normal),
                };
                let contact = Contact::new(touch, &law, a, b, dt);
                let number = problem.pairs.len() as u32;
                let told = if is_rigid { image } else { away };
                problem.images.extend(told.map(|told| (number, told)));
                let bodies = *bodies;
                problem.join(&Link { bodies, contact });
            }
        }
        problem.walls.clear();
        problem.surfaces.clear();
        for (number, (bodies, touch)) in walls.iter().enumerate() {
            let [a, b] = bodies.map(|body| body as usize);
            if awake[a] {
                let (a, surface) = (&spheres[a], surfaces.get(number));
                let law = match book.mixture {
                    None => wall,
                    Some(mixture) => without_restitution(mixture.at_wall(*bodies).normal),
                };
                let contact = match (walls_before.get(b), surface) {
                    (Some(wall), _) => Contact::new(touch, &law, a, &wall.plate, dt),
                    (None, Some(surface)) => Contact::new(touch, &law, a, surface, dt),
                    (None, None) => continue,
                };
                problem.surfaces.extend(surface);
                problem.walls.push(Link {
                    bodies: *bodies,
                    contact,
                });
            }
        }
        let share = self.setup.solver.warm_start;
        if share > 0.0 {
            state.memory.warm_start(problem, share * dt);
        }
        problem.start();
        Ok(())
    }

    /// Pairs of spheres within interaction range, in ascending order.
    fn touching_pairs(&self) -> Result<Vec<PairGeometry>, WorldError> {
        let (reach, radii, space) = (self.reach(), &self.setup.radii, self.space());
        let mut found = Vec::new();
        for &[a, b] in &self.neighbours {
            let [i, j] = [a as usize, b as usize];
            let positions = &self.state.positions;
            let apart = space.displacement(&positions[i], &positions[j]);
            if apart.norm() - radii[i] - radii[j] > reach {
                continue;
            }
            let touch = ContactGeometry::spheres(&apart, [radii[i], radii[j]]);
            let touch = touch.map_err(|cause| WorldError::Touch {
                step: self.state.steps,
                body: i,
                other: format!("sphere {j}"),
                cause,
            })?;
            found.push(([a, b], touch));
        }
        Ok(found)
    }

    /// Pairs across the border of a cell whose images move, with the velocities of the second spheres' images; and with the
    /// whole periods from these to the spheres, if it deforms.
    fn images(&self, pairs: &[PairGeometry]) -> [Vec<ImageVelocity>; 2] {
        let positions = &self.state.positions;
        let way = |[a, b]: [u32; 2]| [a, b].map(|body| positions[body as usize]);
        if let Some(cell) = &self.state.cell {
            let away = |(number, (bodies, _)): (usize, &PairGeometry)| {
                let [a, b] = way(*bodies);
                let near = cell.space.displacement(&a, &b);
                let periods = periods(&(b - a - near), &cell.space);
                (periods != [0.0; 3]).then_some((number as u32, periods.into()))
            };
            let away: Vec<ImageVelocity> = pairs.iter().enumerate().filter_map(away).collect();
            let faster = self.level_velocity().x;
            let velocity = |(number, away): &ImageVelocity| {
                let velocity = -image_velocity(&(*away).into(), &cell.speeds, faster);
                (*number, velocity)
            };
            return [away.iter().map(velocity).collect(), away];
        }
        if self.setup.shear_rate == 0.0 {
            return [Vec::new(), Vec::new()];
        }
        let space = &self.setup.space;
        let faster = self.level_velocity();
        let image = |(number, (bodies, _)): (usize, &PairGeometry)| {
            let [a, b] = way(*bodies);
            // The displacement leaves these whole periods out.
            let levels = space.levels(b.z - a.z);
            (levels != 0.0).then_some((number as u32, faster * -levels))
        };
        [
            pairs.iter().enumerate().filter_map(image).collect(),
            Vec::new(),
        ]
    }

    /// Points of the mesh at the contacts with walls; none without a mesh.
    fn surfaces(&self, walls: &[PairGeometry]) -> Vec<Surface> {
        let Some(mesh) = &self.setup.mesh else {
            return Vec::new();
        };
        let (pose, state) = (mesh.at(self.state.time), &self.state);
        let surface = |([a, b], touch): &PairGeometry| {
            let at_mesh = *b as usize >= state.walls.len();
            let point = state.positions[*a as usize] + touch.normal * touch.arms[0];
            if at_mesh {
                pose.surface(&self.setup.space, &point)
            } else {
                Surface::default()
            }
        };
        walls.iter().map(surface).collect()
    }

    /// Pairs of a sphere and a wall within interaction range, sphere by sphere.
    fn touching_walls(&self) -> Result<Vec<PairGeometry>, WorldError> {
        let reach = self.reach();
        let pose = self
            .setup
            .mesh
            .as_ref()
            .map(|mesh| mesh.at(self.state.time));
        let (space, planes) = (&self.setup.space, self.state.walls.len());
        let mut found = Vec::new();
        for (i, (x, &radius)) in self
            .state
            .positions
            .iter()
            .zip(&self.setup.radii)
            .enumerate()
        {
            if keeps_motion(&self.state.spheres[i]) {
                continue;
            }
            let touches = |w: usize, Facing { outward, height }: Facing| {
                let touch = ContactGeometry::plate(height, &outward, radius);
                let touch = touch.map_err(|cause| WorldError::Touch {
                    step: self.state.steps,
                    body: i,
                    other: format!("wall {w}"),
                    cause,
                })?;
                Ok(([i as u32, w as u32], touch))
            };
            for (w, wall) in self.state.walls.iter().enumerate() {
                let facing = wall.facing(space, x);
                if facing.height - radius > reach {
                    continue;
                }
                found.push(touches(w, facing)?);
            }
            let Some(pose) = &pose else { continue };
            for meeting in pose.meetings(space, x, radius + reach) {
                found.push(touches(planes + meeting.number as usize, meeting.facing)?);
            }
        }
        Ok(found)
    }
}

/// The law of a contact without restitution.
fn without_restitution(law: NormalLaw<f64>) -> NormalLaw<f64> {
    // 0 is a valid coefficient of restitution.
    NormalLaw::new(*law.cohesion(), 0.0).unwrap_or(law)
}
