//! Atoms in motion: groups, forces, one step after another.

mod error;
mod motion;
mod overlap;

pub use error::SystemError;

use super::atoms::Atoms;
use super::drive::TorqueDrive;
use super::group::Group;
use super::interaction::{Interaction, Tally, Wanted, evaluate};
use super::neighbours::VerletList;
use super::thermostat::Thermostat;
use crate::space::PeriodicBox;
use nalgebra::Vector3;

/// Which velocities are kept from step to step. The places are the same but for rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// Velocities at the times of the places.
    #[default]
    VelocityVerlet,
    /// Velocities half a step behind the places.
    LeapFrog,
}

/// Everything that a run starts from.
#[derive(Debug)]
pub struct Setup<I> {
    /// Atoms; their velocities are those at the start, for either integrator.
    pub atoms: Atoms,
    /// The box.
    pub space: PeriodicBox,
    /// What acts between them.
    pub interaction: I,
    /// How much farther the list of neighbours reaches than the cut-off.
    pub skin: f64,
    /// The groups.
    pub groups: Vec<Group>,
    /// Group of each atom.
    pub group_of: Vec<u8>,
    /// A torque on some groups.
    pub drive: Option<TorqueDrive>,
    /// Which velocities are kept.
    pub integrator: Integrator,
    /// Δt.
    pub time_step: f64,
    /// Of all noise.
    pub seed: u64,
}

/// What a run goes on from, besides its setup, to the same bits.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Steps taken.
    pub steps: u64,
    /// Places.
    pub positions: Vec<Vector3<f64>>,
    /// Velocities as kept by the integrator.
    pub velocities: Vec<Vector3<f64>>,
    /// Places at the last build of the list.
    pub reference: Vec<Vector3<f64>>,
    /// ξ and η of each group.
    pub thermostats: Vec<[f64; 2]>,
}

/// Atoms in motion.
#[derive(Debug)]
pub struct System<I> {
    atoms: Atoms,
    interaction: I,
    list: VerletList,
    forces: Vec<Vector3<f64>>,
    groups: Vec<Group>,
    members: Vec<Vec<usize>>,
    drive: Option<TorqueDrive>,
    integrator: Integrator,
    time_step: f64,
    seed: u64,
    steps: u64,
    tally: Tally,
}

impl<I: Interaction> System<I> {
    /// Checks everything and computes the first forces.
    pub fn new(setup: Setup<I>) -> Result<Self, SystemError> {
        let mut system = Self::assemble(setup)?;
        system.compute(Wanted::Sums)?;
        system.refuse_overlaps()?;
        if system.integrator == Integrator::LeapFrog {
            let half = 0.5 * system.time_step;
            system.kick_all(-half, -half);
        }
        Ok(system)
    }

    /// Goes on from `state`, which belongs to the same setup.
    pub fn resume(setup: Setup<I>, state: State) -> Result<Self, SystemError> {
        let mut system = Self::assemble(setup)?;
        system.atoms.positions = state.positions;
        system.atoms.velocities = state.velocities;
        system.atoms.check()?;
        system.steps = state.steps;
        for (group, kept) in system.groups.iter_mut().zip(state.thermostats) {
            if let Thermostat::NoseHoover(thermostat) = &mut group.thermostat {
                thermostat.restore(kept);
            }
        }
        system.list.build(&state.reference, &system.atoms.species)?;
        system.compute(Wanted::Sums)?;
        Ok(system)
    }

    fn assemble(setup: Setup<I>) -> Result<Self, SystemError> {
        setup.atoms.check()?;
        let (known, given) = (setup.interaction.species(), setup.atoms.masses.len());
        if given > known {
            return Err(SystemError::Species { known, given });
        }
        let given = setup.time_step;
        if !given.is_finite() || given <= 0.0 {
            return Err(SystemError::TimeStep { given });
        }
        let mut members = vec![Vec::new(); setup.groups.len()];
        let last = setup.groups.len().saturating_sub(1);
        for atom in 0..setup.atoms.len() {
            let group = setup.group_of.get(atom).map(|&group| usize::from(group));
            match group.and_then(|group| members.get_mut(group)) {
                Some(members) => members.push(atom),
                None => return Err(SystemError::Group { atom, last }),
            }
        }
        let list = VerletList::new(setup.space, setup.interaction.cutoff(), setup.skin)?;
        Ok(Self {
            forces: vec![Vector3::zeros(); setup.atoms.len()],
            atoms: setup.atoms,
            interaction: setup.interaction,
            list,
            groups: setup.groups,
            members,
            drive: setup.drive,
            integrator: setup.integrator,
            time_step: setup.time_step,
            seed: setup.seed,
            steps: 0,
            tally: Tally::default(),
        })
    }

    /// Forces at the present places.
    fn compute(&mut self, wanted: Wanted) -> Result<(), SystemError> {
        self.tally = evaluate(
            &self.interaction,
            &mut self.list,
            &self.atoms,
            &mut self.forces,
            wanted,
        )?;
        Ok(())
    }

    /// The atoms; velocities as the integrator keeps them.
    pub fn atoms(&self) -> &Atoms {
        &self.atoms
    }

    /// Forces of the interaction at the present places.
    pub fn forces(&self) -> &[Vector3<f64>] {
        &self.forces
    }

    /// Energy and virial of the interaction, NaN after a step that did not want them.
    pub fn tally(&self) -> &Tally {
        &self.tally
    }

    /// The box.
    pub fn space(&self) -> &PeriodicBox {
        self.list.space()
    }

    /// The interaction.
    pub fn interaction(&self) -> &I {
        &self.interaction
    }

    /// The groups, thermostats as they are now.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// Atoms of a group, ascending.
    pub fn members(&self, group: usize) -> &[usize] {
        &self.members[group]
    }

    /// The torque drive.
    pub fn drive(&self) -> Option<&TorqueDrive> {
        self.drive.as_ref()
    }

    /// Replaces the torque drive: another protocol from here on.
    pub fn set_drive(&mut self, drive: Option<TorqueDrive>) {
        self.drive = drive;
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Δt.
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// Time since the start.
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.time_step
    }

    /// Builds of the list of neighbours so far.
    pub fn list_builds(&self) -> u64 {
        self.list.builds()
    }

    /// What [`resume`](Self::resume) goes on from.
    pub fn state(&self) -> State {
        let state = |group: &Group| match &group.thermostat {
            Thermostat::NoseHoover(thermostat) => thermostat.state(),
            _ => [0.0; 2],
        };
        State {
            steps: self.steps,
            positions: self.atoms.positions.clone(),
            velocities: self.atoms.velocities.clone(),
            reference: self.list.reference().to_vec(),
            thermostats: self.groups.iter().map(state).collect(),
        }
    }
}
