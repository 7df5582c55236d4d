//! Atoms in motion: groups, forces, one step after another.

mod error;
mod motion;
mod overlap;
mod thermal;

pub use error::SystemError;

use super::atoms::Atoms;
use super::drive::TorqueDrive;
use super::group::Group;
use super::interaction::{Evaluation, Interaction, Tally, evaluate};
use super::neighbours::VerletList;
use super::support::Support;
use super::thermostat::Thermostat;
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;

/// Which velocities are stored from step to step. The positions differ only by rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// Velocities at the times of the positions.
    #[default]
    VelocityVerlet,
    /// Velocities half a step behind the positions.
    LeapFrog,
}

/// The initial state and the parameters of a run.
#[derive(Debug)]
pub struct Setup<I> {
    /// Atoms with their initial velocities, for either integrator.
    pub atoms: Atoms,
    /// The box.
    pub space: PeriodicBox,
    /// Interaction between the atoms.
    pub interaction: I,
    /// Skin: the reach of the neighbour list beyond the cut-off.
    pub skin: f64,
    /// Groups of atoms.
    pub groups: Vec<Group>,
    /// Group of each atom, as an index into `groups`.
    pub group_of: Vec<u8>,
    /// A torque on some groups.
    pub drive: Option<TorqueDrive>,
    /// Which velocities are stored from step to step.
    pub integrator: Integrator,
    /// Time step Δt.
    pub time_step: f64,
    /// Seed of all noise.
    pub seed: u64,
}

/// The state from which a run with the same setup resumes, to the same bits.
///
/// ```
/// # use nalgebra::Vector3;
/// # use tribos::md::pair::{LennardJones, Pairing, Shift};
/// # use tribos::md::{atoms::Atoms, group::Group, interaction::Evaluation};
/// # use tribos::space::PeriodicBox;
/// use tribos::md::system::{Integrator, Setup, State, System};
/// # let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
/// # let interaction = LennardJones::single(unit, Shift::Force)?;
/// # let setup = || Setup {
/// #     atoms: Atoms::at(vec![Vector3::zeros(), Vector3::new(1.0, 0.3, 0.0)]),
/// #     space: PeriodicBox::OPEN,
/// #     interaction: interaction.clone(),
/// #     skin: 0.3,
/// #     groups: vec![Group::default()],
/// #     group_of: vec![0; 2],
/// #     drive: None,
/// #     integrator: Integrator::VelocityVerlet,
/// #     time_step: 0.005,
/// #     seed: 1,
/// # };
/// // A run that is broken off after ten of twenty steps, and one that is not.
/// let (mut whole, mut first) = (System::new(setup())?, System::new(setup())?);
/// (0..20).try_for_each(|_| whole.step(Evaluation::Forces))?;
/// (0..10).try_for_each(|_| first.step(Evaluation::Forces))?;
/// let kept: State = first.state();
/// let mut second = System::resume(setup(), kept)?;
/// (0..10).try_for_each(|_| second.step(Evaluation::Forces))?;
/// assert_eq!(second.state(), whole.state()); // every bit
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Steps taken.
    pub steps: u64,
    /// Positions of the atoms.
    pub positions: Vec<Vector3<f64>>,
    /// Velocities as stored by the integrator.
    pub velocities: Vec<Vector3<f64>>,
    /// Positions at the last build of the neighbour list.
    pub reference: Vec<Vector3<f64>>,
    /// ξ and η of each group.
    pub thermostats: Vec<[f64; 2]>,
}

/// Energy that a step exchanged with the outside.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exchange {
    /// Energy that thermostats and damping took from the atoms.
    pub heat: f64,
    /// Work that the support did on its springs and by the damping against it.
    pub work: f64,
}

/// Atoms in motion.
///
/// ```
/// use nalgebra::Vector3;
/// use tribos::md::pair::{LennardJones, Pairing, Shift};
/// use tribos::md::system::{Integrator, Setup, System};
/// use tribos::md::{atoms::Atoms, group::Group, interaction::{Interaction, Evaluation}};
/// use tribos::space::PeriodicBox;
/// // Two atoms, a little farther apart than r₀ = 2^(1/6), where U'' = 72/r₀²: they vibrate with
/// // ω = √(2 U''/m) = 12/r₀.
/// let bond = 2.0_f64.powf(1.0 / 6.0);
/// let period = std::f64::consts::TAU * bond / 12.0;
/// let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
/// let mut system = System::new(Setup {
///     atoms: Atoms::at(vec![Vector3::zeros(), Vector3::x() * (bond + 1e-4)]),
///     space: PeriodicBox::OPEN,
///     interaction: LennardJones::single(unit, Shift::None)?,
///     skin: 0.3,
///     groups: vec![Group::default()],
///     group_of: vec![0; 2],
///     drive: None,
///     integrator: Integrator::VelocityVerlet,
///     time_step: period / 100.0,
///     seed: 1,
/// })?;
/// let stretch = |system: &System<LennardJones>| {
///     let places = &system.atoms().positions;
///     (places[1] - places[0]).norm() - bond
/// };
/// while system.time() + 0.5 * system.time_step() < 0.5 * period {
///     system.step(Evaluation::Forces)?;
/// }
/// assert!((stretch(&system) + 1e-4).abs() < 1e-6); // after half a period as much too near
/// system.step(Evaluation::Sums)?;
/// assert!((system.tally().energy + 1.0).abs() < 1e-6);
/// assert_eq!(system.forces()[0], -system.forces()[1]);
/// assert_eq!((system.groups().len(), system.members(0)), (1, &[0, 1][..]));
/// // Nothing moved farther than the skin allows: the first list still holds.
/// assert_eq!((system.steps(), system.list_builds()), (51, 1));
/// assert!(system.interaction().cutoff() < 3.0 && *system.space() == PeriodicBox::OPEN);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct System<I> {
    atoms: Atoms,
    interaction: I,
    list: VerletList,
    forces: Vec<Vector3<f64>>,
    groups: Vec<Group>,
    members: Vec<Vec<usize>>,
    drive: Option<TorqueDrive>,
    support: Option<Support>,
    exchange: Exchange,
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
        system.compute(Evaluation::Sums)?;
        system.refuse_overlaps()?;
        if system.integrator == Integrator::LeapFrog {
            let half = 0.5 * system.time_step;
            system.kick_all(-half, -half);
        }
        Ok(system)
    }

    /// Resumes from `state`, which must belong to the same setup.
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
        system.compute(Evaluation::Sums)?;
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
            support: None,
            exchange: Exchange::default(),
            integrator: setup.integrator,
            time_step: setup.time_step,
            seed: setup.seed,
            steps: 0,
            tally: Tally::default(),
        })
    }

    /// Computes the forces at the current positions.
    fn compute(&mut self, wanted: Evaluation) -> Result<(), SystemError> {
        self.tally = evaluate(
            &self.interaction,
            &mut self.list,
            &self.atoms,
            &mut self.forces,
            wanted,
        )?;
        Ok(())
    }

    /// The atoms, with velocities as the integrator stores them.
    pub fn atoms(&self) -> &Atoms {
        &self.atoms
    }

    /// Forces of the interaction at the current positions.
    pub fn forces(&self) -> &[Vector3<f64>] {
        &self.forces
    }

    /// Energy and virial of the interaction, NaN after a step that did not request them.
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

    /// The groups, with the current state of their thermostats.
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

    /// Replaces the torque drive from now on.
    ///
    /// ```
    /// # use nalgebra::Vector3;
    /// # use tribos::md::pair::{LennardJones, Pairing, Shift};
    /// # use tribos::md::{atoms::Atoms, group::Group, interaction::Evaluation};
    /// # use tribos::space::PeriodicBox;
    /// # use tribos::md::{drive::TorqueDrive, system::{Integrator, Setup, System}};
    /// # let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
    /// # let mut system = System::new(Setup {
    /// #     atoms: Atoms::at(vec![Vector3::x() * 2.0, Vector3::x() * -2.0]),
    /// #     space: PeriodicBox::OPEN,
    /// #     interaction: LennardJones::single(unit, Shift::None)?,
    /// #     skin: 0.3,
    /// #     groups: vec![Group::default()],
    /// #     group_of: vec![0; 2],
    /// #     drive: None,
    /// #     integrator: Integrator::VelocityVerlet,
    /// #     time_step: 0.005,
    /// #     seed: 1,
    /// # })?;
    /// // Two atoms out of each other's reach, 2 from the axis: a torque for a time, then none.
    /// let (axis, acceleration) = ([0.0; 2], 0.1);
    /// let groups = vec![0];
    /// system.set_drive(Some(TorqueDrive { axis, acceleration, from: 0.0, until: 9.0, groups }));
    /// (0..20).try_for_each(|_| system.step(Evaluation::Forces))?;
    /// let speed = 2.0 * acceleration * system.time();
    /// for &atom in system.members(0) {
    ///     assert!((system.atoms().velocities[atom].norm() - speed).abs() < 1e-6);
    /// }
    /// system.set_drive(None);
    /// let driven = system.atoms().velocities.clone();
    /// system.step(Evaluation::Forces)?;
    /// assert!(system.drive().is_none() && system.atoms().velocities == driven);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_drive(&mut self, drive: Option<TorqueDrive>) {
        self.drive = drive;
    }

    /// The support that pulls a group.
    pub fn support(&self) -> Option<&Support> {
        self.support.as_ref()
    }

    /// Ties a group to a moving support from now on; it needs an anchor for each atom of the group.
    ///
    /// ```
    /// # use nalgebra::Vector3;
    /// # use tribos::md::pair::{LennardJones, Pairing, Shift};
    /// # use tribos::md::{atoms::Atoms, group::Group, interaction::Evaluation};
    /// # use tribos::md::{support::Support, system::{Integrator, Setup, System}};
    /// # use tribos::space::PeriodicBox;
    /// # let unit = Pairing { epsilon: 1.0, sigma: 1.0, cutoff: 2.5 };
    /// # let mut system = System::new(Setup {
    /// #     atoms: Atoms::at(vec![Vector3::zeros()]),
    /// #     space: PeriodicBox::OPEN,
    /// #     interaction: LennardJones::single(unit, Shift::None)?,
    /// #     skin: 0.3,
    /// #     groups: vec![Group::default()],
    /// #     group_of: vec![0],
    /// #     drive: None,
    /// #     integrator: Integrator::VelocityVerlet,
    /// #     time_step: 0.01,
    /// #     seed: 1,
    /// # })?;
    /// // A lone atom on a spring with ω = 1, pulled at a speed of 1: x = t − sin t.
    /// system.set_support(Support {
    ///     group: 0,
    ///     anchors: vec![[0.0; 2]],
    ///     direction: [1.0, 0.0],
    ///     stiffness: 1.0,
    ///     speed: 1.0,
    ///     stroke: f64::INFINITY,
    ///     from: 0.0,
    ///     until: 9.0,
    /// });
    /// let mut work = 0.0;
    /// for _ in 0..200 {
    ///     system.step(Evaluation::Forces)?;
    ///     work += system.exchange().work;
    /// }
    /// let time = system.time();
    /// assert!((system.atoms().positions[0].x - (time - time.sin())).abs() < 1e-4);
    /// assert!((work - (1.0 - time.cos())).abs() < 1e-4); // ∫ sin t dt
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_support(&mut self, support: Support) {
        self.support = Some(support);
    }

    /// What the last step exchanged with thermostats, damping and support.
    pub fn exchange(&self) -> Exchange {
        self.exchange
    }

    /// Force of the support on its group; nothing without one.
    pub fn support_force(&self) -> [f64; 2] {
        self.support.as_ref().map_or([0.0; 2], |support| {
            support.total(self.pulled(support), support.position(self.time()))
        })
    }

    /// Energy of the support's springs; 0 without one.
    pub fn support_energy(&self) -> f64 {
        self.support.as_ref().map_or(0.0, |support| {
            support.energy(self.pulled(support), support.position(self.time()))
        })
    }

    /// Positions of the atoms that a support pulls.
    fn pulled(&self, support: &Support) -> impl Iterator<Item = &Vector3<f64>> {
        let members = self
            .members
            .get(support.group)
            .map_or(&[][..], Vec::as_slice);
        members.iter().map(|&atom| &self.atoms.positions[atom])
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Time step Δt.
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

    /// The state from which [`resume`](Self::resume) continues.
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
