//! One step: thermostats, kicks and drifts in a symmetric order.

use super::{Exchange, Integrator, System, SystemError};
use crate::md::group::MotionConstraint;
use crate::md::interaction::{Evaluation, Interaction};
use crate::md::thermostat::Thermostat;
use nalgebra::Vector3;

impl<I: Interaction> System<I> {
    /// Advances by Δt. `wanted` selects the sums of the interaction at the new positions.
    ///
    /// Velocity Verlet: thermostats and damping for Δt/2, kick Δt/2, drift Δt, forces, kick Δt/2,
    /// thermostats and damping Δt/2 (Tuckerman, Berne & Martyna 1992); leap-frog the same, cut
    /// before the drift. Langevin noise acts in the middle of the drift.
    pub fn step(&mut self, wanted: Evaluation) -> Result<(), SystemError> {
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
        for (index, group) in self.groups.iter().enumerate() {
            if !group.hold.is_driven_by_forces() {
                continue;
            }
            let drive = self.drive.as_ref();
            let drive = drive.filter(|d| d.is_on(at) && d.groups.contains(&index));
            let common = self.common_lift(index);
            let support = self.support.as_ref().filter(|s| s.group == index);
            let support = support.map(|s| (s, s.position(self.time())));
            for (number, &atom) in self.members[index].iter().enumerate() {
                let inv_mass = 1.0 / self.atoms.mass(atom);
                let mut push = self.forces[atom] * inv_mass;
                push.z = match group.hold {
                    MotionConstraint::Plane => 0.0,
                    MotionConstraint::Level => common,
                    _ => push.z + group.load * inv_mass,
                };
                if let Some(drive) = drive {
                    let [x, y] = drive.acceleration_at(&self.atoms.positions[atom]);
                    push.x += x;
                    push.y += y;
                }
                if let Some((support, position)) = support {
                    let [x, y] = support.force(number, &self.atoms.positions[atom], position);
                    push.x += x * inv_mass;
                    push.y += y * inv_mass;
                }
                velocities[atom] += push * time;
            }
        }
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
        for index in 0..self.groups.len() {
            let group = self.groups[index];
            match (group.hold, group.thermostat) {
                (MotionConstraint::Frozen, _) => {}
                (MotionConstraint::Turning { axis, rate }, _) => self.turn(index, axis, rate),
                (_, Thermostat::Langevin(thermostat)) => {
                    self.go(index, 0.5 * time);
                    self.langevin_kick(index, &thermostat);
                    self.go(index, 0.5 * time);
                }
                (_, _) => self.go(index, time),
            }
        }
        self.steps += 1;
        self.check_displacements()
    }

    fn go(&mut self, index: usize, time: f64) {
        for &atom in &self.members[index] {
            let velocity = self.atoms.velocities[atom];
            self.atoms.positions[atom] += velocity * time;
        }
    }

    /// Positions and velocities of a group that rotates at a given rate.
    fn turn(&mut self, index: usize, axis: [f64; 2], rate: f64) {
        let (sin, cos) = libm::sincos(rate * self.time_step);
        for &atom in &self.members[index] {
            let place = &mut self.atoms.positions[atom];
            let [x, y] = [place.x - axis[0], place.y - axis[1]];
            place.x = axis[0] + (cos * x - sin * y);
            place.y = axis[1] + (sin * x + cos * y);
            self.atoms.velocities[atom] = self.turning(atom, axis, rate);
        }
    }

    /// Refuses velocities that carry an atom by more than half the cut-off in a step.
    fn check_displacements(&self) -> Result<(), SystemError> {
        let limit = 0.5 * self.interaction.cutoff() / self.time_step;
        let is_flight = |velocity: &Vector3<f64>| {
            let speed_sq = velocity.norm_squared();
            speed_sq.is_nan() || speed_sq > limit * limit
        };
        match self.atoms.velocities.iter().position(is_flight) {
            None => Ok(()),
            Some(atom) => Err(SystemError::BlownUp {
                step: self.steps,
                atom,
                way: self.atoms.velocities[atom].norm() * self.time_step,
            }),
        }
    }
}
