//! From a scene to atoms, groups, potential and drive.

use super::forces::TipForces;
use super::run::TipError;
use super::shape::{AtomRole, Site};
use crate::md::atoms::Atoms;
use crate::md::drive::TorqueDrive;
use crate::md::group::{Group, MotionConstraint, ThermalFrame};
use crate::md::pair::{LennardJones, LennardJonesError, Mixing, Pairing};
use crate::md::support::Support;
use crate::md::system::Setup;
use crate::md::thermostat::{
    Langevin, Noise, NoseHoover, RotationBias, Thermostat, ThermostatError,
};
use crate::tip::scene::{
    DriveKind, DrivenHold, ThermostatBias, ThermostatKind, TipScene, TorqueNormalisation,
};
use nalgebra::Vector3;
use tribos_base::space::PeriodicBox;

/// Stream of the initial velocities, separate from the noise of the steps.
const FIRST: u64 = u64::MAX;

/// The setup of a run, with the support of a slid tip and the layer of each atom.
#[derive(Debug)]
pub struct TipSystem {
    /// Atoms, groups in the order of [`AtomRole::ALL`], drive.
    pub setup: Setup<TipForces>,
    /// The support of a slid tip.
    pub support: Option<Support>,
    /// Layer of each atom, from the lowest of the substrate.
    pub layer_of: Vec<usize>,
}

/// Builds the system of a scene.
///
/// ```
/// use tribos::scene::TipScene;
/// use tribos::tip::{AtomRole, TipError, TipSystem, build};
/// let mut scene = TipScene {
///     lambda: 0.01,
///     substrate_columns: 8,
///     substrate_rows: 8,
///     substrate_layers: 4,
///     tip_layers: 4,
///     tip_side_atoms: 2,
///     ..TipScene::default()
/// };
/// let TipSystem { setup, support, layer_of } = build(&scene)?;
/// assert_eq!(layer_of.last(), Some(&7)); // the highest of eight layers
/// // The lowest layers are held, and all driven atoms have the angular acceleration λ.
/// let base = (0..setup.atoms.len()).filter(|&atom| setup.group_of[atom] == 0);
/// assert!(base.clone().all(|atom| setup.atoms.velocities[atom].norm() == 0.0));
/// assert_eq!(base.count(), 2 * 8 * 8);
/// assert_eq!(setup.drive.map(|drive| drive.acceleration), Some(0.01));
/// assert!(support.is_none()); // it is not slid
/// scene.cutoff = 0.0; // no potential
/// assert!(matches!(build(&scene), Err(TipError::Scene(_))));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn build(scene: &TipScene) -> Result<TipSystem, TipError> {
    scene.check()?;
    let shape = scene.shape();
    let (sites, [x, y]) = (shape.sites(), shape.periods());
    let groups = groups(scene)?;
    let mut atoms = atoms(scene, &sites);
    let number = |part: AtomRole| AtomRole::ALL.iter().position(|&other| other == part);
    let group_of: Vec<u8> = sites
        .iter()
        .map(|site| number(site.part).unwrap_or_default() as u8)
        .collect();
    initial_velocities(scene, &groups, &group_of, &mut atoms);
    let setup = Setup {
        drive: (scene.drive == DriveKind::Torque).then(|| drive(scene, &sites)),
        atoms,
        space: PeriodicBox::new([Some(x), Some(y), None])?,
        interaction: potential(scene)?,
        skin: scene.skin,
        groups,
        group_of,
        integrator: scene.integrator,
        time_step: scene.time_step,
        seed: scene.seed,
    };
    let layer_of = sites.iter().map(|site| site.layer).collect();
    Ok(TipSystem {
        setup,
        support: support(scene, &sites),
        layer_of,
    })
}

/// Whether an atom belongs to the tip.
pub(super) fn is_of_tip(part: AtomRole) -> bool {
    matches!(part, AtomRole::Apex | AtomRole::TipBath | AtomRole::Driven)
}

/// One species, or one each for the substrate and the tip if they differ.
fn atoms(scene: &TipScene, sites: &[Site]) -> Atoms {
    let mut atoms = Atoms::at(sites.iter().map(|site| site.place).collect());
    let of_site = |[substrate, tip]: [u8; 2], site: &Site| {
        if is_of_tip(site.part) { tip } else { substrate }
    };
    if let Some((_, species)) = scene.potential.forces() {
        let [substrate, tip] = scene.potential.masses();
        atoms.masses = vec![substrate; 1 + usize::from(species[1])];
        atoms.masses[usize::from(species[1])] = tip;
        atoms.species = sites.iter().map(|site| of_site(species, site)).collect();
    } else if scene.adhesion_energy != 1.0 {
        atoms.masses = vec![1.0; 2];
        atoms.species = sites.iter().map(|site| of_site([0, 1], site)).collect();
    }
    atoms
}

fn potential(scene: &TipScene) -> Result<TipForces, LennardJonesError> {
    match scene.potential.forces() {
        Some((forces, _)) => Ok(forces.clone()),
        None => lennard_jones(scene).map(TipForces::LennardJones),
    }
}

fn lennard_jones(scene: &TipScene) -> Result<LennardJones, LennardJonesError> {
    let like = Pairing {
        epsilon: 1.0,
        sigma: 1.0,
        cutoff: scene.cutoff,
    };
    if scene.adhesion_energy == 1.0 {
        return LennardJones::single(like, scene.shift);
    }
    let mut potential = LennardJones::mixed(&[like, like], Mixing::default(), scene.shift)?;
    let across = Pairing {
        epsilon: scene.adhesion_energy,
        ..like
    };
    potential.set(0, 1, across)?;
    Ok(potential)
}

/// Groups in the order of their parts.
fn groups(scene: &TipScene) -> Result<Vec<Group>, ThermostatError> {
    let axis = scene.shape().axis();
    let of_part = |part: AtomRole| {
        let mut group = Group::default();
        match part {
            AtomRole::Base => group.hold = MotionConstraint::Frozen,
            AtomRole::SubstrateBath => group.thermostat = thermostat(scene, RotationBias::Counts)?,
            AtomRole::TipBath if is_carried(scene) => {
                group.thermostat = thermostat(scene, RotationBias::Counts)?;
                group.frame = ThermalFrame::Mean;
            }
            AtomRole::TipBath => {
                group.thermostat = thermostat(scene, RotationBias::Spared { axis })?
            }
            AtomRole::Surface | AtomRole::Apex => {}
            AtomRole::Driven => {
                group.damping = scene.drive_damping_rate;
                (group.hold, group.load) = match scene.driven_constraint {
                    DrivenHold::Plane => (MotionConstraint::Plane, 0.0),
                    DrivenHold::Level => (MotionConstraint::Level, scene.lift()),
                };
            }
        }
        Ok(group)
    };
    AtomRole::ALL.into_iter().map(of_part).collect()
}

/// Whether the tip's bath moves with a mean velocity that is not heat.
fn is_carried(scene: &TipScene) -> bool {
    scene.drive == DriveKind::Slide && scene.spin == ThermostatBias::Spared
}

fn thermostat(scene: &TipScene, wanted: RotationBias) -> Result<Thermostat, ThermostatError> {
    let temperature = scene.temperature * scene.potential.boltzmann();
    Ok(match scene.thermostat {
        ThermostatKind::NoseHoover => {
            let spin = match scene.spin {
                ThermostatBias::Spared => wanted,
                ThermostatBias::Counts => RotationBias::Counts,
            };
            Thermostat::NoseHoover(NoseHoover::new(temperature, scene.thermostat_time, spin)?)
        }
        ThermostatKind::Langevin => {
            Thermostat::Langevin(Langevin::new(temperature, scene.langevin_rate)?)
        }
        ThermostatKind::None => Thermostat::None,
    })
}

/// Velocities at twice the temperature, since atoms on lattice sites lose half of it to potential energy.
fn initial_velocities(scene: &TipScene, groups: &[Group], group_of: &[u8], atoms: &mut Atoms) {
    let mut noise = Noise::new(scene.seed, FIRST, 0);
    let heat = 2.0 * scene.temperature * scene.potential.boltzmann();
    for (atom, &group) in group_of.iter().enumerate() {
        let drawn = noise.vector() * (heat / atoms.mass(atom)).sqrt();
        let velocity = &mut atoms.velocities[atom];
        *velocity = match groups[usize::from(group)].hold {
            MotionConstraint::Frozen | MotionConstraint::Turning { .. } => Vector3::zeros(),
            MotionConstraint::Plane | MotionConstraint::Level => {
                Vector3::new(drawn.x, drawn.y, 0.0)
            }
            MotionConstraint::Free => drawn,
        };
    }
}

/// The support of a slid tip: one spring for each driven atom, all together of the scene's stiffness.
fn support(scene: &TipScene, sites: &[Site]) -> Option<Support> {
    let speed = scene.speed.filter(|_| scene.drive == DriveKind::Slide)?;
    let driven = sites.iter().filter(|site| site.part == AtomRole::Driven);
    let anchors: Vec<[f64; 2]> = driven.map(|site| [site.place.x, site.place.y]).collect();
    let (sin, cos) = libm::sincos(scene.drive_angle.to_radians());
    let [from, until] = drive_times(scene);
    Some(Support {
        group: AtomRole::ALL.len() - 1,
        stiffness: scene.stiffness / anchors.len() as f64,
        anchors,
        direction: [cos, sin],
        speed,
        stroke: scene.stroke.unwrap_or(f64::INFINITY),
        from,
        until,
    })
}

/// Times from the start of the run at which the drive begins and ends.
fn drive_times(scene: &TipScene) -> [f64; 2] {
    let steps = scene.stage_steps();
    [steps.before, steps.before + steps.driven].map(|steps| steps as f64 * scene.time_step)
}

/// The torque of the second stage.
pub(super) fn drive(scene: &TipScene, sites: &[Site]) -> TorqueDrive {
    let axis = scene.shape().axis();
    let arm = |site: &Site| libm::hypot(site.place.x - axis[0], site.place.y - axis[1]);
    let arms = || {
        sites
            .iter()
            .filter(|site| site.part == AtomRole::Driven)
            .map(arm)
    };
    let length = match scene.reading {
        TorqueNormalisation::Angular => 1.0,
        TorqueNormalisation::Mean => arms().sum::<f64>() / arms().count() as f64,
        TorqueNormalisation::Largest => arms().fold(0.0, f64::max),
    };
    let [from, until] = drive_times(scene);
    TorqueDrive {
        axis,
        acceleration: scene.lambda / (length * scene.potential.masses()[1]),
        from,
        until,
        groups: vec![AtomRole::ALL.len() - 1],
    }
}
