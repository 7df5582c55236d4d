//! The melt: a Lennard-Jones crystal at the density of LAMMPS' melt bench, warm enough to melt.

use nalgebra::Vector3;
use tribos::md::atoms::Atoms;
use tribos::md::group::Group;
use tribos::md::interaction::Wanted;
use tribos::md::pair::{LennardJones, Pairing, Shift};
use tribos::md::system::{Integrator, Setup, System};
use tribos::md::thermostat::Noise;
use tribos::space::PeriodicBox;

/// Atoms in a volume of σ³, and the temperature of the crystal in ε/k_B.
const DENSITY: f64 = 0.8442;
const TEMPERATURE: f64 = 1.44;
/// Of the potential, in σ.
pub const CUTOFF: f64 = 2.5;
/// Of the lists, in σ.
pub const SKIN: f64 = 0.3;
/// Δt in σ√(m/ε), of both programs.
pub const TIME_STEP: f64 = 0.005;
/// Stream of the first velocities.
const SEED: u64 = 5;
/// Places in the cube of the face-centred lattice, over its edge.
const INSIDE: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [0.0, 0.5, 0.5],
    [0.5, 0.0, 0.5],
    [0.5, 0.5, 0.0],
];

/// Atoms in a periodic cube.
#[derive(Clone, Debug)]
pub struct Melt {
    /// Places and velocities.
    pub atoms: Atoms,
    /// Edge of the box in σ.
    pub edge: f64,
}

impl Melt {
    /// A face-centred crystal of `cubes`³ cubes, its atoms at random velocities.
    fn crystal(cubes: usize) -> Self {
        let cube = libm::cbrt(INSIDE.len() as f64 / DENSITY);
        let mut positions = Vec::with_capacity(INSIDE.len() * cubes.pow(3));
        for index in 0..cubes.pow(3) {
            let corner = [index % cubes, index / cubes % cubes, index / cubes / cubes];
            for inside in INSIDE {
                let place = |axis: usize| (corner[axis] as f64 + inside[axis]) * cube;
                positions.push(Vector3::from_fn(|axis, _| place(axis)));
            }
        }
        let mut atoms = Atoms::at(positions);
        let mut noise = Noise::new(SEED, 0, 0);
        for velocity in &mut atoms.velocities {
            *velocity = noise.vector() * TEMPERATURE.sqrt();
        }
        let mean = atoms.velocities.iter().sum::<Vector3<f64>>() / atoms.len() as f64;
        for velocity in &mut atoms.velocities {
            *velocity -= mean;
        }
        Self {
            atoms,
            edge: cubes as f64 * cube,
        }
    }

    /// What has become of the crystal of `cubes`³ cubes after some steps; half of its heat goes into
    /// the melting.
    pub fn after(cubes: usize, steps: usize, shift: Shift) -> Result<Self, String> {
        let crystal = Self::crystal(cubes);
        let mut system = crystal.system(shift, TIME_STEP)?;
        for _ in 0..steps {
            let done = system.step(Wanted::Forces);
            done.map_err(|error| error.to_string())?;
        }
        Ok(Self {
            atoms: system.atoms().clone(),
            edge: crystal.edge,
        })
    }

    /// The atoms in motion, at constant energy.
    pub fn system(&self, shift: Shift, time_step: f64) -> Result<System<LennardJones>, String> {
        self.moved_as(Group::default(), shift, time_step)
    }

    /// The atoms in motion, all in one group.
    pub fn moved_as(
        &self,
        group: Group,
        shift: Shift,
        time_step: f64,
    ) -> Result<System<LennardJones>, String> {
        System::new(Setup {
            group_of: vec![0; self.atoms.len()],
            atoms: self.atoms.clone(),
            space: PeriodicBox::new([Some(self.edge); 3]).map_err(|error| error.to_string())?,
            interaction: lennard_jones(shift)?,
            skin: SKIN,
            groups: vec![group],
            drive: None,
            integrator: Integrator::VelocityVerlet,
            time_step,
            seed: SEED,
        })
        .map_err(|error| error.to_string())
    }
}

/// What acts between them.
pub fn lennard_jones(shift: Shift) -> Result<LennardJones, String> {
    let pairing = Pairing {
        epsilon: 1.0,
        sigma: 1.0,
        cutoff: CUTOFF,
    };
    LennardJones::single(pairing, shift).map_err(|error| error.to_string())
}
