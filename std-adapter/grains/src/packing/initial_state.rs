//! Spheres at the start of a run; those of a file or of another run are read, and checked against the box.

use super::{Forces, Kinds, WorldSnapshot};
use crate::packing::method::ContactMethod;
use crate::packing::{Assembly, AssemblyError, PackingColumns};
use nalgebra::Vector3;
use std::path::Path;
use tribos_base::record::ContactRow;
use tribos_base::space::AXES;
use tribos_contacts::cd::EnergyBalance;

/// Deepest overlap of rigid spheres in a file, over the smaller radius: packings of soft spheres are that deep, and
/// rigid ones keep such an overlap without adding to it.
const DEEPEST: f64 = 0.05;
/// The same of soft spheres: a spring bears any overlap, until the centre of the smaller sphere enters the larger.
const DEEPEST_SOFT: f64 = 1.0;
/// Largest relative difference of a period from the scene's.
pub(crate) const SAME_PERIOD: f64 = 1e-9;
/// Range of the mean radius of a file, over that of the scene.
const MEAN_RADII: [f64; 2] = [0.5, 2.0];

/// Spheres at the start of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialSpheres {
    pub(crate) positions: Vec<Vector3<f64>>,
    pub(crate) radii: Vec<f64>,
    /// Periods of a file that hold in place of the scene's lengths, because the box deforms from there on.
    pub(crate) periods: [Option<f64>; 3],
    pub(crate) kinds: Kinds,
    pub(crate) contacts: Vec<ContactRow>,
    /// Motion, walls and forces of spheres that a file or another run has.
    pub(crate) frozen: Option<WorldSnapshot>,
}

/// How far spheres of a file may overlap under a method, over the smaller radius.
pub(crate) fn deepest(method: ContactMethod) -> f64 {
    match method {
        ContactMethod::ContactDynamics => DEEPEST,
        ContactMethod::Soft => DEEPEST_SOFT,
    }
}

/// Spheres with the periods of a scene; `periods` has the lengths of its periodic axes with their keys, `radius` is
/// the mean radius that it expects of those that move, `known` the number of materials, and `is_bound` tells types that no force moves. A box that deforms
/// goes on from the periods of the file.
pub(crate) fn given(
    (path, columns): (&Path, Option<&PackingColumns>),
    (periods, deforms): ([Option<(f64, &'static str)>; 3], bool),
    (radius, method, known): (f64, ContactMethod, usize),
    is_bound: impl Fn(u8) -> bool,
) -> Result<Assembly, AssemblyError> {
    let file = path.display().to_string();
    let refused = |reason: String| AssemblyError::Content {
        file: file.clone(),
        reason,
    };
    let mut assembly = Assembly::read_as(path, columns)?;
    if assembly.radii.is_empty() {
        return Err(refused("there is no sphere; give one or more".into()));
    }
    let mut lengths = [None; 3];
    for (axis, wanted) in periods.into_iter().enumerate() {
        let Some((length, key)) = wanted else {
            continue;
        };
        match assembly.space.lengths()[axis] {
            Some(period) if !deforms && (period / length - 1.0).abs() > SAME_PERIOD => {
                let name = AXES[axis];
                return Err(refused(format!(
                    "its period along {name} is {period}, and `{key}` is {length}; set {key} = {period}"
                )));
            }
            Some(period) => lengths[axis] = Some(period),
            None => {
                assembly.begin_at_zero(axis, Some(length));
                check_within(&file, &assembly, axis, length)?;
                lengths[axis] = Some(length);
            }
        }
    }
    // Axes repeat in the box of the scene, not in that of the file.
    assembly.set_periods(&file, lengths)?;
    let is_known = |kind: &u8| (1..=known).contains(&usize::from(*kind)) || is_bound(*kind);
    if let Some(materials) = &assembly.materials
        && let Some(other) = materials.iter().find(|kind| !is_known(kind))
    {
        return Err(refused(format!(
            "there is a sphere of type {other}, and the materials of the scene are types 1 to {known}; give these, or more \
             `materials` of grains, up to 6"
        )));
    }
    if assembly.frozen.is_none() {
        let kinds = assembly.materials.as_deref().unwrap_or_default();
        let moves = |sphere: usize| !kinds.get(sphere).is_some_and(|kind| is_bound(*kind));
        check_spheres(&file, &assembly, (radius, method), moves)?;
    }
    Ok(assembly)
}

/// Refuses spheres out of a period that the file does not have.
fn check_within(
    file: &str,
    assembly: &Assembly,
    axis: usize,
    length: f64,
) -> Result<(), AssemblyError> {
    let is_out = |place: &Vector3<f64>| !(0.0..=length).contains(&place[axis]);
    match assembly.positions.iter().position(is_out) {
        Some(sphere) => Err(AssemblyError::Content {
            file: file.into(),
            reason: format!(
                "sphere {sphere} is at {} = {}, beyond the period from 0 to {length}",
                AXES[axis], assembly.positions[sphere][axis]
            ),
        }),
        None => Ok(()),
    }
}

/// Refuses lengths in other units and spheres that overlap deeply.
fn check_spheres(
    file: &str,
    assembly: &Assembly,
    (radius, method): (f64, ContactMethod),
    moves: impl Fn(usize) -> bool,
) -> Result<(), AssemblyError> {
    let refused = |reason: String| AssemblyError::Content {
        file: file.into(),
        reason,
    };
    let radii = assembly.radii.iter().enumerate();
    let radii: Vec<f64> = radii.filter(|(i, _)| moves(*i)).map(|(_, r)| *r).collect();
    let mean = radii.iter().sum::<f64>() / radii.len() as f64;
    let [smallest, largest] = MEAN_RADII;
    if !radii.is_empty() && !(smallest..=largest).contains(&(mean / radius)) {
        let factor = radius / mean;
        return Err(refused(format!(
            "the mean radius is {mean}, and that of the scene is {radius}; multiply all lengths by {factor}"
        )));
    }
    let one_moves = |pair: &&[u32; 2]| pair.iter().any(|sphere| moves(*sphere as usize));
    let deepest = assembly
        .deepest(one_moves)
        .map_err(|cause| AssemblyError::Space {
            file: file.into(),
            cause,
        })?;
    let most = self::deepest(method);
    match deepest {
        Some((depth, [a, b])) if depth > most => Err(refused(format!(
            "spheres {a} and {b} (from 0) overlap by {:.3} % of the smaller radius; at most {} % is taken{}",
            100.0 * depth,
            100.0 * most,
            match method {
                ContactMethod::Soft => "",
                ContactMethod::ContactDynamics =>
                    ": set method = \"soft\", or let them part with it first and start from the folder of that run",
            }
        ))),
        _ => Ok(()),
    }
}

impl WorldSnapshot {
    /// The same state at time 0 of a run with other parameters: clock, energies and sleep begin anew. Springs
    /// are of no use to constraint forces, nor impacts to springs.
    pub(crate) fn at_start(&self, is_soft: bool) -> Self {
        let count = self.positions.len();
        let impacts = if self.origin.is_some() == is_soft {
            self.impacts.clone()
        } else {
            Forces::default()
        };
        Self {
            time: 0.0,
            steps: 0,
            energy: EnergyBalance::default(),
            awake: vec![true; count],
            still: vec![0; count],
            origin: None,
            impacts,
            ..self.clone()
        }
    }

    /// Spheres that move as an assembly does, between walls at rest and without forces.
    pub(crate) fn moving(
        positions: Vec<Vector3<f64>>,
        assembly: &Assembly,
        walls: impl Iterator<Item = f64>,
    ) -> Self {
        let count = positions.len();
        let of = |all: &Option<Vec<Vector3<f64>>>, index: usize| {
            let vector = all.as_ref().and_then(|all| all.get(index));
            vector.copied().unwrap_or_else(Vector3::zeros)
        };
        let motion = |index| [of(&assembly.velocities, index), of(&assembly.spins, index)];
        Self {
            time: 0.0,
            steps: 0,
            positions,
            motions: (0..count).map(motion).collect(),
            walls: walls.map(|place| (place, Vector3::zeros())).collect(),
            energy: EnergyBalance::default(),
            forces: [Vec::new(), Vec::new()],
            impacts: [Vec::new(), Vec::new()],
            shear_offset: assembly.space.offset(),
            awake: vec![true; count],
            still: vec![0; count],
            cell: None,
            origin: None,
        }
    }
}
