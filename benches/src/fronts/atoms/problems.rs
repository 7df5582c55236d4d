//! Problems for both programs: melts and the tip, from the same positions and velocities.

use super::lammps::Input;
use super::melt::{CUTOFF, Melt, SKIN, TIME_STEP};
use crate::clock::Clock;
use tribos::md::atoms::Atoms;
use tribos::md::configuration::Configuration;
use tribos::md::interaction::{Evaluation, Interaction};
use tribos::md::lammps::data_file;
use tribos::md::pair::{LennardJones, Shift};
use tribos::md::system::System;
use tribos::run::Simulation;
use tribos::scene::TipScene;
use tribos::space::PeriodicBox;
use tribos::tip::{TipForces, TipSimulation, export};

/// Runs of an exported tip before the driven one: forces at the start, and the time before.
const TIP_RUNS_BEFORE: usize = 2;
/// As scenes/tip-reversible.toml, shorter: 300 steps before the drive, 500 with it.
const TIMES: [f64; 2] = [1.5, 2.5];
/// The same for a quick look.
const QUICK_TIMES: [f64; 2] = [0.5, 0.5];

/// A problem with its duration.
#[derive(Debug)]
pub enum Problem {
    /// A melt at constant energy.
    Melt {
        /// Where it starts.
        melt: Melt,
        /// Steps that are timed.
        steps: u64,
    },
    /// The driven tip.
    Tip(Box<TipScene>),
}

/// One run of ours.
#[derive(Debug)]
pub struct TimedRun {
    /// The processor's seconds.
    pub seconds: f64,
    /// Steps timed.
    pub steps: u64,
    /// Lists built meanwhile.
    pub builds: u64,
    /// Potential energy before the first step.
    pub energy: f64,
    /// Atoms at the end.
    pub atoms: Atoms,
    /// Their box.
    pub space: PeriodicBox,
    /// Interaction between the atoms.
    pub interaction: TipForces,
}

impl TimedRun {
    fn new<I: Interaction>(
        system: &System<I>,
        interaction: TipForces,
        energy: f64,
        since: &Since,
    ) -> Self {
        let seconds = since.clock.seconds();
        Self {
            seconds,
            steps: system.steps() - since.steps,
            builds: system.list_builds() - since.builds,
            energy,
            atoms: system.atoms().clone(),
            space: *system.space(),
            interaction,
        }
    }
}

/// Start of a timed section.
struct Since {
    steps: u64,
    builds: u64,
    clock: Clock,
}

impl Since {
    fn now<I: Interaction>(system: &System<I>) -> Self {
        Self {
            steps: system.steps(),
            builds: system.list_builds(),
            clock: Clock::start(),
        }
    }
}

/// Potential energy.
fn energy<I: Interaction>(system: &System<I>) -> f64 {
    system.tally().energy
}

impl Problem {
    /// A melt of `cubes`³ cubes of four atoms after some steps from the crystal.
    pub fn melt(cubes: usize, before: usize, steps: u64) -> Result<Self, String> {
        let melt = Melt::after(cubes, before, Shift::None)?;
        Ok(Self::Melt { melt, steps })
    }

    /// The tip.
    pub fn tip(is_quick: bool) -> Self {
        let [equilibration, drive_time] = if is_quick { QUICK_TIMES } else { TIMES };
        Self::Tip(Box::new(TipScene {
            equilibration,
            drive_time,
            rest_time: 0.0,
            ..TipScene::default()
        }))
    }

    /// Name of the problem in tables.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Melt { .. } => "melt",
            Self::Tip(_) => "tip, driven",
        }
    }

    /// Runs ours.
    pub fn run(&self) -> Result<TimedRun, String> {
        match self {
            Self::Melt { melt, steps } => {
                let mut system = melt.system(Shift::None, TIME_STEP)?;
                let energy = energy(&system);
                let since = Since::now(&system);
                advance(&mut system, *steps)?;
                let forces = TipForces::LennardJones(system.interaction().clone());
                Ok(TimedRun::new(&system, forces, energy, &since))
            }
            Self::Tip(scene) => run_tip(scene),
        }
    }

    /// The same for LAMMPS.
    pub fn input(&self) -> Result<Input, String> {
        match self {
            Self::Melt { melt, steps } => Ok(Input {
                data: ("melt.data", melt_data(melt)),
                script: melt_script(*steps),
                timed: 0,
            }),
            Self::Tip(scene) => {
                let files = export::start(scene).map_err(|error| error.to_string())?;
                Ok(Input {
                    data: ("tip.data", files.data),
                    script: files.script,
                    timed: TIP_RUNS_BEFORE,
                })
            }
        }
    }
}

/// Steps, with the sums after the last.
fn advance(system: &mut System<LennardJones>, steps: u64) -> Result<(), String> {
    for left in (0..steps).rev() {
        let wanted = if left == 0 {
            Evaluation::Sums
        } else {
            Evaluation::Forces
        };
        system.step(wanted).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// The tip, timed while it is driven; lines of the series included.
fn run_tip(scene: &TipScene) -> Result<TimedRun, String> {
    let mut run = TipSimulation::new(scene).map_err(|error| error.to_string())?;
    let energy = energy(run.system());
    let steps = scene.stage_steps();
    let until = |run: &mut TipSimulation, end: u64| -> Result<(), String> {
        while run.system().steps() < end {
            run.step().map_err(|error| error.to_string())?;
        }
        Ok(())
    };
    until(&mut run, steps.before)?;
    let since = Since::now(run.system());
    until(&mut run, steps.before + steps.driven)?;
    let forces = run.system().interaction().clone();
    Ok(TimedRun::new(run.system(), forces, energy, &since))
}

fn melt_data(melt: &Melt) -> String {
    let count = melt.atoms.len() as u64;
    data_file(&Configuration {
        atoms: melt.atoms.clone(),
        ids: (1..=count).collect(),
        names: None,
        bounds: [[0.0, melt.edge]; 3],
        has_box: true,
        is_periodic: [true; 3],
        step: 0,
        forces: None,
    })
}

/// LAMMPS' melt bench with lists that are never too old, as ours.
fn melt_script(steps: u64) -> String {
    format!(
        "units lj\natom_style atomic\nread_data melt.data\npair_style lj/cut {CUTOFF}\n\
         pair_coeff * * 1 1\nneighbor {SKIN} bin\nneigh_modify delay 0 every 1 check yes\n\
         fix move all nve\nthermo_style custom step pe\nthermo_modify norm no format float %.17g\n\
         thermo {steps}\ntimestep {TIME_STEP}\nrun {steps}\n"
    )
}
