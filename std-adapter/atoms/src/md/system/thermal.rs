//! Heat of the groups: damping, thermostats, and what they take.

use super::System;
use crate::md::blocks::{Blocks, within};
use crate::md::group::{MotionConstraint, ThermalFrame};
use crate::md::interaction::Interaction;
use crate::md::thermostat::{Langevin, Noise, NoseHoover, RotationBias, Thermostat};
use nalgebra::Vector3;
use rayon::prelude::*;

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
            let kinetic = self.kinetic(index, &CommonMotion::NONE);
            self.exchange.heat += kinetic * (1.0 - factor * factor);
            self.change_velocities(index, |_| (), |_, (), _, velocity| *velocity *= factor);
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

    /// Scales the velocities of a group relative to its common motion.
    fn scale(&mut self, index: usize, thermostat: &mut NoseHoover, time: f64) {
        let freedoms = self.heat_freedoms(index);
        let common = match thermostat.spin() {
            RotationBias::Counts => CommonMotion::Uniform(self.frame_velocity(index)),
            RotationBias::Spared { axis } => CommonMotion::Rotation {
                axis,
                rate: self.mean_rate(index, axis),
            },
        };
        let kinetic = self.kinetic(index, &common);
        let factor = thermostat.scale(kinetic, freedoms, time);
        self.exchange.heat += kinetic * (1.0 - factor * factor);
        let scale = |system: &Self, (): &mut (), atom: usize, velocity: &mut Vector3<f64>| {
            let common = common.at(&system.atoms.positions[atom]);
            *velocity = (*velocity - common) * factor + common;
        };
        self.change_velocities(index, |_| (), scale);
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

    /// Velocity of the frame in which the motion of a group is heat.
    fn frame_velocity(&self, index: usize) -> Vector3<f64> {
        match self.groups[index].frame {
            ThermalFrame::Box => Vector3::zeros(),
            ThermalFrame::Mean => self.mean_velocity(index),
        }
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

    /// Kinetic energy of a group beside its common motion, from the stored velocities.
    fn kinetic(&self, index: usize, common: &CommonMotion) -> f64 {
        let part = |&atom: &usize| {
            let velocity = self.atoms.velocities[atom] - common.at(&self.atoms.positions[atom]);
            0.5 * self.atoms.mass(atom) * velocity.norm_squared()
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

    /// Applies friction and noise over a whole step, along the free axes, relative to the frame of the group.
    pub(super) fn langevin_kick(&mut self, index: usize, thermostat: &Langevin) {
        let [kept, unit] = thermostat.factors(self.time_step);
        let is_flat = matches!(
            self.groups[index].hold,
            MotionConstraint::Plane | MotionConstraint::Level
        );
        let before = self.kinetic(index, &CommonMotion::NONE);
        let common = self.frame_velocity(index);
        let noise = Noise::new(self.seed, self.steps, index);
        let begin = |first: usize| noise.clone().skip(first);
        let shake = |system: &Self, noise: &mut Noise, atom: usize, velocity: &mut Vector3<f64>| {
            let size = unit / system.atoms.mass(atom).sqrt();
            let lift = velocity.z;
            *velocity = (*velocity - common) * kept + noise.vector() * size;
            if is_flat {
                velocity.z = lift;
            }
        };
        self.change_velocities(index, begin, shake);
        if self.groups[index].frame == ThermalFrame::Mean {
            // Noise leaves the mean velocity as it is.
            let excess = common - self.mean_velocity(index);
            self.change_velocities(index, |_| (), |_, (), _, velocity| *velocity += excess);
        }
        self.exchange.heat += before - self.kinetic(index, &CommonMotion::NONE);
    }

    /// Changes the velocities of a group, block by block; `begin` prepares a block, whose first atom has this number
    /// in the group.
    fn change_velocities<S>(
        &mut self,
        index: usize,
        begin: impl Fn(usize) -> S + Sync,
        change: impl Fn(&Self, &mut S, usize, &mut Vector3<f64>) + Sync,
    ) {
        let mut velocities = std::mem::take(&mut self.atoms.velocities);
        let (blocks, system) = (Blocks::new(velocities.len()), &*self);
        let in_block = |(block, velocities): (usize, &mut [Vector3<f64>])| {
            let block = blocks.entries(block, velocities.len());
            let mut members = within(&system.members[index], &block).peekable();
            let Some((first, _)) = members.peek() else {
                return;
            };
            let mut state = begin(*first);
            for (_, atom) in members {
                change(
                    system,
                    &mut state,
                    atom,
                    &mut velocities[atom - block.start],
                );
            }
        };
        let parts = velocities.par_chunks_mut(blocks.len());
        parts.enumerate().for_each(in_block);
        self.atoms.velocities = velocities;
    }
}

/// The motion of a group that is no heat.
enum CommonMotion {
    /// At one velocity.
    Uniform(Vector3<f64>),
    /// About a vertical axis.
    Rotation { axis: [f64; 2], rate: f64 },
}

impl CommonMotion {
    /// None: all motion is heat.
    const NONE: Self = Self::Uniform(Vector3::new(0.0, 0.0, 0.0));

    /// Velocity at a place.
    #[inline]
    fn at(&self, place: &Vector3<f64>) -> Vector3<f64> {
        match *self {
            Self::Uniform(velocity) => velocity,
            Self::Rotation { axis, rate } => turning(place, axis, rate),
        }
    }
}

/// Velocity at a place in a rotation about a vertical axis.
#[inline]
pub(super) fn turning(place: &Vector3<f64>, axis: [f64; 2], rate: f64) -> Vector3<f64> {
    Vector3::new(-rate * (place.y - axis[1]), rate * (place.x - axis[0]), 0.0)
}
