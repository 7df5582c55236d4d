//! Atoms: forces of the library's pair potentials, and atoms in motion.

use crate::arrays::refused;
use crate::threads::detached;
use crate::vectors::{rows, vectors};
use numpy::PyArray2;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use tribos::md::atoms::Atoms;
use tribos::md::group::Group;
use tribos::md::interaction::{Evaluation, Interaction, evaluate};
use tribos::md::neighbours::VerletList;
use tribos::md::observe::{conserved_energy, kinetic_energies, temperature};
use tribos::md::pair::{LennardJones, Mixing, Pairing, Shift};
use tribos::md::system::{Integrator, Setup, State, System as Moving, SystemError};
use tribos::md::thermostat::{Langevin, NoseHoover, RotationBias, Thermostat};
use tribos::space::PeriodicBox;

/// Reach of a list of neighbours that serves once, beyond the cut-off and in units of it.
const ONCE: f64 = 1e-3;

fn word<T: Copy>(name: &str, given: &str, words: &[(&str, T)]) -> PyResult<T> {
    let found = words.iter().find(|(word, _)| *word == given);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let known: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        let text = format!("{name} must be one of {}, not {given:?}", known.join(", "));
        PyValueError::new_err(text)
    })
}

/// The Lennard-Jones potential of species with (epsilon, sigma, cut-off).
#[pyclass(frozen, module = "tribos._native")]
#[derive(Debug)]
pub struct Potential(LennardJones);

#[pymethods]
impl Potential {
    #[new]
    fn new(species: Vec<[f64; 3]>, mixing: &str, shift: &str) -> PyResult<Self> {
        let like: Vec<Pairing> = species
            .into_iter()
            .map(|[epsilon, sigma, cutoff]| Pairing {
                epsilon,
                sigma,
                cutoff,
            })
            .collect();
        let mixing = word("mixing", mixing, &Mixing::WORDS)?;
        let shift = word("shift", shift, &Shift::WORDS)?;
        let made = LennardJones::mixed(&like, mixing, shift).map_err(refused)?;
        Ok(Self(made))
    }

    /// Energy, forces and the virial Σ r ⊗ F of atoms.
    #[expect(clippy::type_complexity, reason = "three results")]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        positions: &Bound<'py, PyAny>,
        species: Vec<u8>,
        periods: [Option<f64>; 3],
    ) -> PyResult<(f64, Bound<'py, PyArray2<f64>>, [[f64; 3]; 3])> {
        let mut atoms = Atoms::at(vectors("positions", positions)?);
        atoms.masses = vec![1.0; self.0.species()];
        atoms.species = species;
        atoms.check().map_err(refused)?;
        let space = PeriodicBox::new(periods).map_err(refused)?;
        let cutoff = self.0.cutoff();
        let mut list = VerletList::new(space, cutoff, ONCE * cutoff).map_err(refused)?;
        let mut forces = Vec::new();
        let tally = detached(py, || {
            evaluate(&self.0, &mut list, &atoms, &mut forces, Evaluation::Sums)
        })?
        .map_err(refused)?;
        Ok((
            tally.energy,
            rows(py, &forces)?,
            tally.virial.transpose().into(),
        ))
    }
}

/// Atoms in motion.
#[pyclass(frozen, module = "tribos._native")]
#[derive(Debug)]
pub struct System(Mutex<Moving<LennardJones>>);

/// A state that a system goes on from: steps, positions, velocities, positions of the list, thermostat.
type SavedState<'py> = (
    u64,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    [f64; 2],
);

#[pymethods]
impl System {
    #[new]
    #[pyo3(signature = (potential, positions, *, velocities, species, masses, periods, thermostat, integrator, time_step, skin, seed, kept))]
    #[expect(
        clippy::too_many_arguments,
        reason = "one for each of the library's settings"
    )]
    fn new<'py>(
        potential: &Bound<'py, Potential>,
        positions: &Bound<'py, PyAny>,
        velocities: Option<Bound<'py, PyAny>>,
        species: Vec<u8>,
        masses: Vec<f64>,
        periods: [Option<f64>; 3],
        thermostat: (String, f64, f64),
        integrator: &str,
        time_step: f64,
        skin: f64,
        seed: u64,
        kept: Option<SavedState<'py>>,
    ) -> PyResult<Self> {
        let mut atoms = Atoms::at(vectors("positions", positions)?);
        if let Some(given) = velocities {
            atoms.velocities = vectors("velocities", &given)?;
        }
        atoms.species = species;
        atoms.masses = masses;
        let (kind, target, rate) = thermostat;
        let thermostat = match kind.as_str() {
            "none" => Thermostat::None,
            "langevin" => Thermostat::Langevin(Langevin::new(target, rate).map_err(refused)?),
            _ => {
                let made = NoseHoover::new(target, rate, RotationBias::Counts);
                Thermostat::NoseHoover(made.map_err(refused)?)
            }
        };
        let group = Group {
            thermostat,
            ..Group::default()
        };
        let integrators = [
            ("velocity-verlet", Integrator::VelocityVerlet),
            ("leap-frog", Integrator::LeapFrog),
        ];
        let setup = Setup {
            group_of: vec![0; atoms.len()],
            atoms,
            space: PeriodicBox::new(periods).map_err(refused)?,
            interaction: potential.get().0.clone(),
            skin,
            groups: vec![group],
            drive: None,
            integrator: word("integrator", integrator, &integrators)?,
            time_step,
            seed,
        };
        let made = match kept {
            None => Moving::new(setup),
            Some((steps, positions, velocities, reference, thermostat)) => {
                let state = State {
                    steps,
                    positions: vectors("positions", &positions)?,
                    velocities: vectors("velocities", &velocities)?,
                    reference: vectors("reference", &reference)?,
                    thermostats: vec![thermostat],
                };
                Moving::resume(setup, state)
            }
        };
        Ok(Self(Mutex::new(made.map_err(refused)?)))
    }

    /// Takes steps; signals are looked for on the way.
    fn step(&self, py: Python<'_>, count: u64) -> PyResult<()> {
        /// Steps from one look for signals to the next.
        const PIECE: u64 = 64;
        let mut left = count;
        while left > 0 {
            let piece = left.min(PIECE);
            left -= piece;
            let last = left == 0;
            detached(py, || self.go(piece, last))?
                .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
            py.check_signals()?;
        }
        Ok(())
    }

    /// Time and number of steps.
    fn clock(&self, py: Python<'_>) -> (f64, u64) {
        let system = self.held(py);
        (system.time(), system.steps())
    }

    /// Positions, not wrapped into the box.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, &self.held(py).atoms().positions)
    }

    /// Velocities at the time of the positions.
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, &self.held(py).velocities_on_step())
    }

    /// Forces at the positions.
    fn forces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.held(py).forces())
    }

    /// Potential and kinetic energy, the conserved sum, the temperature and the virial.
    fn energies(&self, py: Python<'_>) -> ([f64; 4], [[f64; 3]; 3]) {
        let system = self.held(py);
        let kinetic: f64 = kinetic_energies(&system).iter().sum();
        let heat = temperature(kinetic, system.heat_freedoms(0));
        let tally = system.tally();
        let numbers = [tally.energy, kinetic, conserved_energy(&system), heat];
        (numbers, tally.virial.transpose().into())
    }

    /// The state from which a system goes on to the same bits.
    fn state<'py>(&self, py: Python<'py>) -> PyResult<SavedState<'py>> {
        let state = self.held(py).state();
        Ok((
            state.steps,
            rows(py, &state.positions)?,
            rows(py, &state.velocities)?,
            rows(py, &state.reference)?,
            state.thermostats.first().copied().unwrap_or_default(),
        ))
    }
}

impl System {
    fn lock(&self) -> MutexGuard<'_, Moving<LennardJones>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Sums are taken after the last step of a call.
    fn go(&self, steps: u64, last: bool) -> Result<(), SystemError> {
        let mut system = self.lock();
        for left in (0..steps).rev() {
            system.step(if last && left == 0 {
                Evaluation::Sums
            } else {
                Evaluation::Forces
            })?;
        }
        Ok(())
    }

    /// The system; a step of another thread is waited for without the interpreter's lock.
    fn held(&self, py: Python<'_>) -> MutexGuard<'_, Moving<LennardJones>> {
        loop {
            match self.0.try_lock() {
                Ok(system) => return system,
                Err(TryLockError::Poisoned(broken)) => return broken.into_inner(),
                Err(TryLockError::WouldBlock) => py.detach(|| drop(self.lock())),
            }
        }
    }
}
