//! The longest step in which springs and dashpots are integrated stably, and collisions are resolved.
//!
//! - **Stability.** Leapfrog, with the dashpot's force at the velocity of half a step before, is stable for an
//!   oscillator of frequency ω and damping ratio ζ while ω dt < 2 (√(1 + ζ²) − ζ). The stiffest motion of a packing
//!   is bounded by that of twelve neighbours that move against each other: ω² = 8 k/m, with twice the damping ratio
//!   of a pair.
//! - **Collisions.** The lightest pair touches for 2 arccos(ζ)/√(1 − ζ²) √(m/(2 S)) and takes a number of steps for it.
//! - **Cohesion.** The lightest pair crosses the range d of a pull F with a speed of √(4 F d/m) where it decides
//!   whether it sticks, and is to do so in a number of steps. A range below the overlap F/S under the pull decides
//!   less than that overlap, which takes its place.

use super::law::{Law, Stiffness, duration};
use crate::cd::{MovingMesh, Wall, keeps_motion};
use nalgebra::Vector3;
use tribos_core::contact::{Cohesion, SphereBody};

/// Largest ω² of a sphere among twelve neighbours, in units of S/m.
const NEIGHBOURS: f64 = 8.0;
/// Damping ratio of that motion, in units of a pair's.
const STIFFER: f64 = 2.0;
/// Margin of the overlaps from one step to the next.
const DEEPER: f64 = 1.5;
/// Share of the longest stable step: half of it and a little, as walls and pistons come to the twelve neighbours.
const SHARE: f64 = 0.6;
/// Steps across the range of cohesion: the speed up to which a pair sticks is then right to 1 % at e = 0.9.
const RANGE_STEPS: f64 = 10.0;
/// Largest motion of a step, in units of the smallest radius: contacts are met before they are deep.
const MOTION: f64 = 0.02;

/// What does not change in a run.
#[derive(Clone, Debug)]
#[doc(hidden)]
pub struct StepLength {
    /// The stiffest spring.
    stiffness: Stiffness,
    /// The largest damping ratio: neither stability nor the time of a collision grows with it.
    damping: f64,
    /// Of all pairs and walls.
    cohesions: Vec<Cohesion<f64>>,
    /// Smallest and largest mass and radius.
    mass: [f64; 2],
    radius: [f64; 2],
    gravity: f64,
    longest: f64,
    steps_per_collision: f64,
    /// Largest speed of a mesh.
    mesh: f64,
}

impl StepLength {
    /// The bounds of a setup with these laws of pairs and walls.
    pub fn of<F: Copy>(setup: &super::SoftSetup<F>) -> Self {
        let extremes = |values: &mut dyn Iterator<Item = f64>| {
            values.fold([f64::INFINITY, 0.0_f64], |[low, high], x| {
                [low.min(x), high.max(x)]
            })
        };
        let laws = setup.all_laws().concat();
        let stiffer = |most: Stiffness, law: &Law<F>| {
            if law.stiffness.given() > most.given() {
                law.stiffness
            } else {
                most
            }
        };
        let stiffness = laws.first().map_or(setup.stiffness, |law| law.stiffness);
        Self {
            stiffness: laws.iter().fold(stiffness, stiffer),
            damping: laws.iter().fold(0.0, |most, law| law.damping.max(most)),
            cohesions: laws.iter().map(|law| law.cohesion).collect(),
            mass: extremes(&mut masses(&setup.spheres)),
            radius: extremes(&mut setup.radii.iter().copied()),
            gravity: setup.gravity.norm(),
            longest: setup.longest,
            steps_per_collision: setup.steps_per_collision,
            mesh: setup.mesh.as_ref().map_or(0.0, MovingMesh::fastest),
        }
    }

    /// Takes account of another acceleration of all spheres.
    pub fn set_gravity(&mut self, gravity: &Vector3<f64>) {
        self.gravity = gravity.norm();
    }

    /// Spheres of one size at rest, held by a cohesion.
    pub fn of_spheres(
        (stiffness, damping): (Stiffness, f64),
        [mass, radius]: [f64; 2],
        cohesion: Cohesion<f64>,
        steps_per_collision: f64,
    ) -> Self {
        Self {
            stiffness,
            damping,
            cohesions: vec![cohesion],
            mass: [mass; 2],
            radius: [radius; 2],
            gravity: 0.0,
            longest: f64::MAX,
            steps_per_collision,
            mesh: 0.0,
        }
    }

    /// Length of the next step, given the deepest overlap and the number of contacts at each wall.
    pub fn next(
        &self,
        spheres: &[SphereBody<f64>],
        walls: &[Wall],
        deepest: f64,
        at: &[usize],
    ) -> f64 {
        let speed = fastest(spheres, walls).max(self.mesh);
        let slope = self.slope(speed, deepest);
        // A piston on many spheres moves against all of their springs.
        let pistons = walls.iter().zip(at);
        let piston =
            |(wall, &contacts): (&Wall, &usize)| 2.0 * contacts as f64 * wall.plate.inv_mass;
        let lightest = (NEIGHBOURS / self.mass[0]).max(pistons.map(piston).fold(0.0, f64::max));
        let frequency = (slope * lightest).sqrt();
        let damping = STIFFER * self.damping;
        let stable = 2.0 / (frequency * ((1.0 + damping * damping).sqrt() + damping));
        let pair = (0.5 * self.mass[0] / slope).sqrt();
        let collision = duration(self.damping) * pair / self.steps_per_collision;
        let dt = (SHARE * stable).min(collision).min(self.crossing());
        let dt = dt.min(self.longest);
        // v dt + a dt² within the largest motion.
        let pushed = walls
            .iter()
            .map(|wall| (wall.force * wall.plate.inv_mass).abs());
        let acceleration = pushed.fold(self.gravity, f64::max);
        let motion = MOTION * self.radius[0];
        let root = (speed * speed + 4.0 * acceleration * motion).sqrt();
        dt.min(2.0 * motion / (speed + root))
    }

    /// A share of the time in which the lightest pair crosses the range of a cohesion.
    fn crossing(&self) -> f64 {
        let time = |cohesion: &Cohesion<f64>| {
            let pull = cohesion.strength();
            let under = self.stiffness.overlap(pull, 0.5 * self.radius[0]);
            (self.mass[0] * cohesion.range().max(under) / (4.0 * pull)).sqrt()
        };
        let pulls = self.cohesions.iter().filter(|it| it.strength() > 0.0);
        pulls.map(time).fold(f64::INFINITY, f64::min) / RANGE_STEPS
    }

    /// Largest tangent stiffness to be expected in the step.
    fn slope(&self, speed: f64, deepest: f64) -> f64 {
        let (law, [_, heaviest], [smallest, largest]) = (&self.stiffness, self.mass, self.radius);
        let impact = law.impact_overlap(2.0 * speed, heaviest, 0.5 * smallest);
        let pulls = self.cohesions.iter().map(Cohesion::strength);
        let pulled = law.overlap(pulls.fold(0.0, f64::max), 0.5 * smallest);
        let overlap = impact.max(pulled).max(DEEPER * deepest);
        law.force(overlap, largest)[1]
    }
}

/// Masses of the spheres that forces move.
fn masses(spheres: &[SphereBody<f64>]) -> impl Iterator<Item = f64> {
    let moving = spheres.iter().filter(|sphere| !keeps_motion(sphere));
    moving.map(|sphere| 1.0 / sphere.inv_mass)
}

/// Largest speed of any body.
pub(super) fn fastest(spheres: &[SphereBody<f64>], walls: &[Wall]) -> f64 {
    let speed = |velocity: &Vector3<f64>| velocity.norm_squared();
    let spheres = spheres.iter().map(|sphere| speed(&sphere.velocity));
    let walls = walls.iter().map(|wall| speed(&wall.plate.velocity));
    spheres.chain(walls).fold(0.0, f64::max).sqrt()
}
