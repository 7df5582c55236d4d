//! One step: thermostats, kicks and drifts in a symmetric order.

use super::thermal::turning;
use super::{Exchange, Integrator, System, SystemError};
use crate::md::blocks::{Blocks, within};
use crate::md::drive::TorqueDrive;
use crate::md::group::{Group, MotionConstraint};
use crate::md::interaction::{Evaluation, Interaction};
use crate::md::support::Support;
use crate::md::thermostat::{Langevin, Thermostat};
use nalgebra::Vector3;
use rayon::prelude::*;

/// What changes the velocities of a group beside the forces of the interaction.
#[derive(Clone, Copy)]
struct Push<'a> {
    hold: MotionConstraint,
    /// Force on each atom along z.
    load: f64,
    members: &'a [usize],
    drive: Option<&'a TorqueDrive>,
    /// The support and its position.
    support: Option<(&'a Support, f64)>,
    /// Acceleration along z of a level group as a whole.
    common: f64,
}

/// How a group moves.
#[derive(Clone, Copy)]
enum Path {
    /// Not at all.
    None,
    /// Along the velocities for a time.
    Straight(f64),
    /// About a vertical axis.
    Circle {
        axis: [f64; 2],
        rate: f64,
        /// Sine and cosine of the angle.
        angle: (f64, f64),
    },
}

impl<I: Interaction> System<I> {
    /// Advances by Δt. `wanted` selects the sums of the interaction at the new positions.
    ///
    /// Velocity Verlet: thermostats and damping for Δt/2, kick Δt/2, drift Δt, forces, kick Δt/2,
    /// thermostats and damping Δt/2 (Tuckerman, Berne & Martyna 1992); leap-frog the same, cut
    /// before the drift. Langevin noise acts in the middle of the drift.
    pub fn step(&mut self, wanted: Evaluation) -> Result<(), SystemError>
    where
        I: Send,
    {
        if self.atoms.len() > Blocks::new(self.atoms.len()).len() {
            // The threads are entered once, not for each part of the step.
            rayon::scope(|_| self.advance(wanted))
        } else {
            self.advance(wanted)
        }
    }

    fn advance(&mut self, wanted: Evaluation) -> Result<(), SystemError> {
        let half = 0.5 * self.time_step;
        self.exchange = Exchange::default();
        let begin = self.support_at();
        // The drive is on or off according to the middle of the last step and of this one.
        let [last, this] = [self.time() - half, self.time() + half];
        match self.integrator {
            Integrator::VelocityVerlet => {
                self.thermalise(half);
                self.kick_all(half, this);
                self.drift()?;
                self.compute(wanted)?;
                self.kick_all(half, this);
                self.thermalise(half);
            }
            Integrator::LeapFrog => {
                self.kick_all(half, last);
                self.thermalise(self.time_step);
                self.kick_all(half, this);
                self.drift()?;
                self.compute(wanted)?;
            }
        }
        self.exchange.work += self.support_work(begin);
        Ok(())
    }

    /// Velocities at the time of the positions.
    ///
    /// ```
    /// # use nalgebra::Vector3;
    /// # use tribos::md::pair::{LennardJones, Pairing, Shift};
    /// # use tribos::md::{atoms::Atoms, group::Group, interaction::Evaluation};
    /// # use tribos::space::PeriodicBox;
    /// # use tribos::md::system::{Integrator, Setup, System};
    /// # let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
    /// // An atom falls from rest with g = 2: leap-frog keeps its velocity of half a step ago.
    /// let mut system = System::new(Setup {
    ///     atoms: Atoms::at(vec![Vector3::zeros()]),
    ///     groups: vec![Group { load: -2.0, ..Group::default() }],
    ///     integrator: Integrator::LeapFrog,
    ///     time_step: 0.01,
    ///     // ...
    /// #     space: PeriodicBox::OPEN,
    /// #     interaction: LennardJones::single(unit, Shift::None)?,
    /// #     skin: 0.3,
    /// #     group_of: vec![0],
    /// #     drive: None,
    /// #     seed: 1,
    /// })?;
    /// (0..10).try_for_each(|_| system.step(Evaluation::Forces))?;
    /// let time = system.time();
    /// assert!((system.atoms().velocities[0].z + 2.0 * (time - 0.005)).abs() < 1e-15);
    /// assert!((system.velocities_on_step()[0].z + 2.0 * time).abs() < 1e-15);
    /// assert!((system.atoms().positions[0].z + time * time).abs() < 1e-15); // g t²/2
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn velocities_on_step(&self) -> Vec<Vector3<f64>> {
        let mut velocities = self.atoms.velocities.clone();
        if self.integrator == Integrator::LeapFrog {
            let half = 0.5 * self.time_step;
            self.kick(&mut velocities, half, self.time() - half);
        }
        velocities
    }

    pub(super) fn kick_all(&mut self, time: f64, at: f64) {
        let mut velocities = std::mem::take(&mut self.atoms.velocities);
        self.kick(&mut velocities, time, at);
        self.atoms.velocities = velocities;
    }

    /// Position of the support, and its force along its direction.
    fn support_at(&self) -> Option<[f64; 2]> {
        let support = self.support.as_ref()?;
        let ([x, y], [along_x, along_y]) = (self.support_force(), support.direction);
        Some([support.position(self.time()), x * along_x + y * along_y])
    }

    /// Work of the springs' far ends in a step: mean force of both its ends times the displacement.
    fn support_work(&self, begin: Option<[f64; 2]>) -> f64 {
        match (begin, self.support_at()) {
            (Some([from, first]), Some([to, last])) => 0.5 * (first + last) * (to - from),
            _ => 0.0,
        }
    }

    /// Adds the forces of the interaction, loads, the support and, if it is on at `at`, the drive to
    /// the velocities.
    fn kick(&self, velocities: &mut [Vector3<f64>], time: f64, at: f64) {
        let driven = |index: &usize| self.groups[*index].hold.is_driven_by_forces();
        let pushes = (0..self.groups.len()).filter(driven);
        let pushes: Vec<Push<'_>> = pushes.map(|index| self.push(index, at)).collect();
        let blocks = Blocks::new(velocities.len());
        let kick = |(block, velocities): (usize, &mut [Vector3<f64>])| {
            let block = blocks.entries(block, velocities.len());
            for push in pushes.iter().copied() {
                for (number, atom) in within(push.members, &block) {
                    velocities[atom - block.start] += self.acceleration(&push, number, atom) * time;
                }
            }
        };
        let velocities = velocities.par_chunks_mut(blocks.len());
        velocities.enumerate().for_each(kick);
    }

    /// What pushes a group while the drive is judged at `at`.
    fn push(&self, index: usize, at: f64) -> Push<'_> {
        let drive = self.drive.as_ref();
        let support = self.support.as_ref().filter(|s| s.group == index);
        Push {
            hold: self.groups[index].hold,
            load: self.groups[index].load,
            members: &self.members[index],
            drive: drive.filter(|d| d.is_on(at) && d.groups.contains(&index)),
            support: support.map(|s| (s, s.position(self.time()))),
            common: self.common_lift(index),
        }
    }

    /// Acceleration of an atom, the one of this number in its group.
    #[inline]
    fn acceleration(&self, push: &Push<'_>, number: usize, atom: usize) -> Vector3<f64> {
        let inv_mass = 1.0 / self.atoms.mass(atom);
        let mut sum = self.forces[atom] * inv_mass;
        sum.z = match push.hold {
            MotionConstraint::Plane => 0.0,
            MotionConstraint::Level => push.common,
            _ => sum.z + push.load * inv_mass,
        };
        if let Some(drive) = push.drive {
            let [x, y] = drive.acceleration_at(&self.atoms.positions[atom]);
            sum.x += x;
            sum.y += y;
        }
        if let Some((support, position)) = push.support {
            let [x, y] = support.force(number, &self.atoms.positions[atom], position);
            sum.x += x * inv_mass;
            sum.y += y * inv_mass;
        }
        sum
    }

    /// Acceleration along z of a level group as a whole.
    fn common_lift(&self, index: usize) -> f64 {
        let group = &self.groups[index];
        if group.hold != MotionConstraint::Level || self.members[index].is_empty() {
            return 0.0;
        }
        let (mut force, mut mass) = (0.0, 0.0);
        for &atom in &self.members[index] {
            force += self.forces[atom].z + group.load;
            mass += self.atoms.mass(atom);
        }
        force / mass
    }

    /// Moves the atoms, with the noise of Langevin groups in the middle.
    fn drift(&mut self) -> Result<(), SystemError> {
        let time = self.time_step;
        self.go(|group| match (group.hold, langevin(group)) {
            (MotionConstraint::Frozen, _) => Path::None,
            (MotionConstraint::Turning { axis, rate }, _) => Path::Circle {
                axis,
                rate,
                angle: libm::sincos(rate * time),
            },
            (_, Some(_)) => Path::Straight(0.5 * time),
            (_, None) => Path::Straight(time),
        });
        let thermostats: Vec<_> = self.groups.iter().map(langevin).collect();
        for (index, thermostat) in thermostats.iter().enumerate() {
            if let Some(thermostat) = thermostat {
                self.langevin_kick(index, thermostat);
            }
        }
        if thermostats.iter().any(Option::is_some) {
            self.go(|group| langevin(group).map_or(Path::None, |_| Path::Straight(0.5 * time)));
        }
        self.steps += 1;
        self.check_displacements()
    }

    /// Moves every group along its path.
    fn go(&mut self, path: impl Fn(&Group) -> Path) {
        let paths = self.groups.iter().map(path).zip(&self.members);
        let paths: Vec<(Path, &Vec<usize>)> = paths.collect();
        let blocks = Blocks::new(self.atoms.len());
        let places = self.atoms.positions.par_chunks_mut(blocks.len());
        let velocities = self.atoms.velocities.par_chunks_mut(blocks.len());
        let atoms = places.zip(velocities).enumerate();
        atoms.for_each(|(block, (places, velocities))| {
            let block = blocks.entries(block, places.len());
            for &(path, members) in &paths {
                for (_, atom) in within(members, &block) {
                    let at = atom - block.start;
                    path.follow(&mut places[at], &mut velocities[at]);
                }
            }
        });
    }

    /// Refuses velocities that carry an atom by more than half the cut-off in a step.
    fn check_displacements(&self) -> Result<(), SystemError> {
        let limit = 0.5 * self.interaction.cutoff() / self.time_step;
        let is_flight = |velocity: &Vector3<f64>| {
            let speed_sq = velocity.norm_squared();
            speed_sq.is_nan() || speed_sq > limit * limit
        };
        let block = Blocks::new(self.atoms.len()).len();
        let blocks = self.atoms.velocities.par_chunks(block).enumerate();
        let first = |(index, velocities): (usize, &[Vector3<f64>])| {
            let at = velocities.iter().position(is_flight)?;
            Some(index * block + at)
        };
        match blocks.find_map_first(first) {
            None => Ok(()),
            Some(atom) => Err(SystemError::BlownUp {
                step: self.steps,
                atom,
                way: self.atoms.velocities[atom].norm() * self.time_step,
            }),
        }
    }
}

impl Path {
    /// Moves an atom.
    #[inline]
    fn follow(self, place: &mut Vector3<f64>, velocity: &mut Vector3<f64>) {
        match self {
            Self::None => {}
            Self::Straight(time) => *place += *velocity * time,
            Self::Circle { axis, rate, angle } => {
                let (sin, cos) = angle;
                let [x, y] = [place.x - axis[0], place.y - axis[1]];
                place.x = axis[0] + (cos * x - sin * y);
                place.y = axis[1] + (sin * x + cos * y);
                *velocity = turning(place, axis, rate);
            }
        }
    }
}

/// The Langevin thermostat of a group that forces move.
fn langevin(group: &Group) -> Option<Langevin> {
    match group.thermostat {
        Thermostat::Langevin(thermostat) if group.hold.is_driven_by_forces() => Some(thermostat),
        _ => None,
    }
}
