//! Heat of the groups: damping, thermostats, and what they take.

use super::System;
use crate::md::group::{MotionConstraint, ThermalFrame};
use crate::md::interaction::Interaction;
use crate::md::thermostat::{Langevin, Noise, NoseHoover, RotationBias, Thermostat};
use nalgebra::Vector3;

impl<I: Interaction> System<I> {
    /// Applies damping and Nosé–Hoover thermostats.
    pub(super) fn thermalise(&mut self, time: f64) {
        for index in 0..self.groups.len() {
            let group = self.groups[index];
            if !group.hold.is_driven_by_forces() {
                continue;
            }
            if group.damping != 0.0 {
                self.damp(index, libm::exp(-group.damping * time));
            }
            if let Thermostat::NoseHoover(mut thermostat) = group.thermostat {
                self.scale(index, &mut thermostat, time);
                self.groups[index].thermostat = Thermostat::NoseHoover(thermostat);
            }
        }
    }

    /// Scales the velocities of a group relative to its support, or to the box without one.
    fn damp(&mut self, index: usize, factor: f64) {
        let support = self.support.as_ref().filter(|s| s.group == index);
        let Some(support) = support else {
            self.exchange.heat += self.kinetic(index) * (1.0 - factor * factor);
            for &atom in &self.members[index] {
                self.atoms.velocities[atom] *= factor;
            }
            return;
        };
        let rate = support.velocity(self.time());
        let [x, y] = support.direction;
        let carried = Vector3::new(rate * x, rate * y, 0.0);
        for &atom in &self.members[index] {
            let mass = self.atoms.mass(atom);
            let slip = self.atoms.velocities[atom] - carried;
            self.atoms.velocities[atom] = slip * factor + carried;
            // The damper's heat, and what the support does against it.
            self.exchange.heat += 0.5 * mass * slip.norm_squared() * (1.0 - factor * factor);
            self.exchange.work += mass * (factor - 1.0) * slip.dot(&carried);
        }
    }

    /// Scales the velocities of a group, or their deviation from its common motion.
    fn scale(&mut self, index: usize, thermostat: &mut NoseHoover, time: f64) {
        let freedoms = self.heat_freedoms(index);
        match thermostat.spin() {
            RotationBias::Counts if self.groups[index].frame == ThermalFrame::Mean => {
                let common = self.mean_velocity(index);
                let kinetic = self.heat_kinetic(index);
                let factor = thermostat.scale(kinetic, freedoms, time);
                self.exchange.heat += kinetic * (1.0 - factor * factor);
                for &atom in &self.members[index] {
                    let velocity = &mut self.atoms.velocities[atom];
                    *velocity = (*velocity - common) * factor + common;
                }
            }
            RotationBias::Counts => {
                let kinetic = self.kinetic(index);
                let factor = thermostat.scale(kinetic, freedoms, time);
                self.exchange.heat += kinetic * (1.0 - factor * factor);
                for &atom in &self.members[index] {
                    self.atoms.velocities[atom] *= factor;
                }
            }
            RotationBias::Spared { axis } => {
                let rate = self.mean_rate(index, axis);
                let mut kinetic = 0.0;
                for &atom in &self.members[index] {
                    let common = self.turning(atom, axis, rate);
                    let velocity = &mut self.atoms.velocities[atom];
                    *velocity -= common;
                    let mass = self.atoms.masses[usize::from(self.atoms.species[atom])];
                    kinetic += 0.5 * mass * velocity.norm_squared();
                }
                let factor = thermostat.scale(kinetic, freedoms, time);
                self.exchange.heat += kinetic * (1.0 - factor * factor);
                for &atom in &self.members[index] {
                    let common = self.turning(atom, axis, rate);
                    let velocity = &mut self.atoms.velocities[atom];
                    *velocity = *velocity * factor + common;
                }
            }
        }
    }

    /// Degrees of freedom of a group that its thermostat controls.
    ///
    /// The total momentum is no heat where nothing changes it: if all atoms are in the group, and neither a load, a
    /// support, a drive nor noise acts on them, the components that `hold` leaves free are not counted. Such a group
    /// must start without momentum, which would be taken for heat.
    ///
    /// ```
    /// # use nalgebra::Vector3;
    /// # use tribos::md::pair::{LennardJones, Pairing, Shift};
    /// # use tribos::md::{atoms::Atoms, group::Group, interaction::Evaluation};
    /// # use tribos::space::PeriodicBox;
    /// # use tribos::md::system::{Integrator, Setup, System};
    /// # use tribos::md::thermostat::{NoseHoover, RotationBias, Thermostat};
    /// # let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
    /// // The common rotation of a turned body is no heat, nor is the momentum of one that nothing holds.
    /// let bath = NoseHoover::new(0.1, 0.5, RotationBias::Spared { axis: [0.0; 2] })?;
    /// let turned = Group { thermostat: Thermostat::NoseHoover(bath), ..Group::default() };
    /// # let system = System::new(Setup {
    /// #     atoms: Atoms::at(vec![Vector3::x(), -Vector3::x()]),
    /// #     space: PeriodicBox::OPEN,
    /// #     interaction: LennardJones::single(unit, Shift::None)?,
    /// #     skin: 0.3,
    /// #     groups: vec![turned, Group::default()],
    /// #     group_of: vec![0; 2],
    /// #     drive: None,
    /// #     integrator: Integrator::VelocityVerlet,
    /// #     time_step: 0.005,
    /// #     seed: 1,
    /// # })?;
    /// assert_eq!(system.groups()[0], turned);
    /// assert_eq!(system.members(0), [0, 1]);
    /// assert_eq!(system.heat_freedoms(0), 3.0 * 2.0 - 3.0 - 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn heat_freedoms(&self, index: usize) -> f64 {
        let group = &self.groups[index];
        let all = group.hold.freedoms(self.members[index].len());
        let spared = match &group.thermostat {
            Thermostat::NoseHoover(thermostat) => {
                usize::from(thermostat.spin() != RotationBias::Counts && all > 0)
            }
            _ => 0,
        };
        // The mean velocity of a frame has two components.
        let carried = match group.frame {
            _ if self.is_isolated(index) => group.hold.freedoms(1),
            ThermalFrame::Mean => 2,
            ThermalFrame::Box => 0,
        };
        all.saturating_sub(spared + carried) as f64
    }

    /// Whether all atoms are in a group and its momentum stays.
    fn is_isolated(&self, index: usize) -> bool {
        let group = &self.groups[index];
        self.members[index].len() == self.atoms.len()
            && group.load == 0.0
            && !matches!(group.thermostat, Thermostat::Langevin(_))
            && self.support.is_none()
            && self.drive.is_none()
    }

    /// Kinetic energy of a group that its thermostat takes for heat, but for a spared rotation;
    /// from the stored velocities.
    fn heat_kinetic(&self, index: usize) -> f64 {
        let common = match self.groups[index].frame {
            ThermalFrame::Box => return self.kinetic(index),
            ThermalFrame::Mean => self.mean_velocity(index),
        };
        let part = |&atom: &usize| {
            let velocity = self.atoms.velocities[atom] - common;
            0.5 * self.atoms.mass(atom) * velocity.norm_squared()
        };
        self.members[index].iter().map(part).sum()
    }

    /// Mean velocity of a group along x and y.
    fn mean_velocity(&self, index: usize) -> Vector3<f64> {
        let (mut momentum, mut all) = (Vector3::zeros(), 0.0);
        for &atom in &self.members[index] {
            let mass = self.atoms.mass(atom);
            momentum += self.atoms.velocities[atom] * mass;
            all += mass;
        }
        if all > 0.0 {
            Vector3::new(momentum.x / all, momentum.y / all, 0.0)
        } else {
            Vector3::zeros()
        }
    }

    /// Kinetic energy of a group, from the stored velocities.
    fn kinetic(&self, index: usize) -> f64 {
        let part = |&atom: &usize| {
            0.5 * self.atoms.mass(atom) * self.atoms.velocities[atom].norm_squared()
        };
        self.members[index].iter().map(part).sum()
    }

    /// Angular momentum of a group over its moment of inertia about a vertical axis.
    fn mean_rate(&self, index: usize, axis: [f64; 2]) -> f64 {
        let (mut momentum, mut inertia) = (0.0, 0.0);
        for &atom in &self.members[index] {
            let (place, velocity) = (&self.atoms.positions[atom], &self.atoms.velocities[atom]);
            let [x, y] = [place.x - axis[0], place.y - axis[1]];
            let mass = self.atoms.mass(atom);
            momentum += mass * (x * velocity.y - y * velocity.x);
            inertia += mass * (x * x + y * y);
        }
        if inertia > 0.0 {
            momentum / inertia
        } else {
            0.0
        }
    }

    /// Velocity of an atom in a rotation about a vertical axis.
    pub(super) fn turning(&self, atom: usize, axis: [f64; 2], rate: f64) -> Vector3<f64> {
        let place = &self.atoms.positions[atom];
        Vector3::new(-rate * (place.y - axis[1]), rate * (place.x - axis[0]), 0.0)
    }

    /// Applies friction and noise over a whole step, along the free axes.
    pub(super) fn langevin_kick(&mut self, index: usize, thermostat: &Langevin) {
        let [kept, unit] = thermostat.factors(self.time_step);
        let is_flat = matches!(
            self.groups[index].hold,
            MotionConstraint::Plane | MotionConstraint::Level
        );
        let mut noise = Noise::new(self.seed, self.steps, index);
        let before = self.kinetic(index);
        if self.groups[index].frame == ThermalFrame::Mean {
            self.shake_about_the_mean(index, [kept, unit], &mut noise, is_flat);
            self.exchange.heat += before - self.kinetic(index);
            return;
        }
        for &atom in &self.members[index] {
            let size = unit / self.atoms.mass(atom).sqrt();
            let velocity = &mut self.atoms.velocities[atom];
            let lift = velocity.z;
            *velocity = *velocity * kept + noise.vector() * size;
            if is_flat {
                velocity.z = lift;
            }
        }
        self.exchange.heat += before - self.kinetic(index);
    }

    /// Friction and noise that leave the mean velocity along x and y as it is.
    fn shake_about_the_mean(
        &mut self,
        index: usize,
        [kept, unit]: [f64; 2],
        noise: &mut Noise,
        is_flat: bool,
    ) {
        let common = self.mean_velocity(index);
        for &atom in &self.members[index] {
            let size = unit / self.atoms.mass(atom).sqrt();
            let velocity = &mut self.atoms.velocities[atom];
            let lift = velocity.z;
            *velocity = (*velocity - common) * kept + noise.vector() * size;
            if is_flat {
                velocity.z = lift;
            }
        }
        let excess = common - self.mean_velocity(index);
        for &atom in &self.members[index] {
            self.atoms.velocities[atom] += excess;
        }
    }
}
