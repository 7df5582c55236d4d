//! What scenes of packings share on their way to LAMMPS: what it cannot hold, the laws in the words of the pair style
//! `gran/tribos`, steps that are stable during a whole run.

use super::{Kinds, Material, Mixture, PackingRunError, Springs, stable_step_between};
use crate::packing::method::{FrictionCoupling, WallLaw};
use std::collections::BTreeSet;
use std::f64::consts::PI;
use tribos_base::record::number;
use tribos_contacts::cd::Wall;
use tribos_contacts::soft::Stiffness;

/// Largest force of a contact, over that of the load and the weight on R². The mean at the walls of the thesis'
/// powders, of which 35 % are solid, is 9; single forces exceed it several times.
pub(crate) const LARGEST_FORCE: f64 = 100.0;
/// Most spheres at a wall, times the square of the radius over the area: disks in hexagonal order, 1/(2 √3).
const CLOSEST: f64 = 0.288_675_134_594_812_9;

/// Why a scene is not exported.
#[derive(Debug)]
pub enum ExportError {
    /// Rigid spheres have no springs that LAMMPS could integrate.
    Rigid,
    /// LAMMPS cannot hold what a key asks for.
    Beyond {
        /// Key of the scene.
        key: &'static str,
        /// What LAMMPS lacks, and what to do instead.
        reason: &'static str,
    },
    /// The spheres cannot be made or read.
    Start(PackingRunError),
}

impl std::fmt::Display for ExportError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Rigid => write!(
                f,
                "LAMMPS integrates springs: export the scene with method = \"soft\", or `--set method=soft`"
            ),
            Self::Beyond { key, reason } => write!(f, "`{key}`: {reason}"),
            Self::Start(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for ExportError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Rigid | Self::Beyond { .. } => None,
            Self::Start(error) => Some(error),
        }
    }
}

/// The first lines of a script: how to run it, the plugin, the spheres as LAMMPS knows them.
pub(crate) fn head(name: &str) -> [String; 2] {
    let run = format!(
        "# Run it in this folder:\n\
         #\n\
         #   mpiexec -np 2 lmp -in in.{name} -var plugin PATH/tribosplugin.so\n\
         #\n\
         # The plugin belongs to engines/lammps of Tribos. LAMMPS splits a path with spaces: set LD_LIBRARY_PATH to\n\
         # the folder of the plugin and leave -var out."
    );
    let load = "variable plugin index tribosplugin.so\nplugin load ${plugin}\n".into();
    [run, load]
}

/// The law of the spheres of a material, and that at walls.
fn laws(material: &Material, springs: &Springs) -> [String; 2] {
    let spring = match material.stiffness {
        Stiffness::Linear(k) => format!("hooke {}", number(k)),
        Stiffness::Hertz(modulus) => format!("hertz {}", number(modulus)),
    };
    let ratio = if material.restitution > 0.0 {
        Stiffness::damping_ratio_of(material.restitution)
    } else {
        springs.damping
    };
    let spring = format!("{spring} damping {}", number(ratio));
    let coupling = match material.carried().coupling {
        FrictionCoupling::Independent => "separate",
        FrictionCoupling::Ellipsoid => "ellipsoid",
        FrictionCoupling::Exact => "exact",
    };
    let [sliding, torsion, rolling, cohesion, range] = [
        material.sliding,
        material.torsion,
        material.rolling,
        material.cohesion,
        material.cohesion_range,
    ]
    .map(number);
    let friction = format!(
        " sliding {sliding} coupling {coupling} torsion {torsion} torsion/spring inertia rolling {rolling}"
    );
    let cohesion = if material.cohesion > 0.0 {
        format!(" cohesion {cohesion} {range}")
    } else {
        String::new()
    };
    let full = format!("{spring}{friction}{cohesion}");
    let wall = match material.wall {
        WallLaw::Full => full.clone(),
        WallLaw::Smooth => format!("{spring}{cohesion}"),
        WallLaw::Bare => spring,
    };
    [full, wall]
}

/// The laws of the types of the spheres, as commands of the pair style, and the law of those that move freely at walls;
/// `None` if that differs from material to material: a fix has one for all.
pub(crate) fn commands(
    mixture: &Mixture,
    springs: &Springs,
    kinds: &Kinds,
    is_free: impl Fn(u8) -> bool,
) -> (String, Option<String>) {
    let [first, _] = laws(mixture.first(), springs);
    let mut text = format!("pair_coeff * * {first}\n");
    let types: BTreeSet<u8> = kinds.materials.iter().copied().collect();
    for &i in &types {
        for &j in types.range(i..) {
            let [pair, _] = mixture.laws([i, j].map(|kind| mixture.index(kind)));
            let [pair, _] = laws(pair, springs);
            if pair != first {
                text += &format!("pair_coeff {i} {j} {pair}\n");
            }
        }
    }
    let at_wall = |kind: &u8| {
        let index = mixture.index(*kind);
        let [_, wall] = laws(mixture.laws([index, index])[1], springs);
        wall
    };
    let free = types.iter().filter(|kind| is_free(**kind));
    let walls: BTreeSet<String> = free.map(at_wall).collect();
    let mut walls = walls.into_iter();
    let wall = walls.next().unwrap_or_else(|| at_wall(&1));
    (text, walls.next().is_none().then_some(wall))
}

/// Why a scene whose materials differ at walls is not exported.
pub(crate) const UNLIKE_WALLS: &str = "a fix wall/gran/tribos has one law for all grains; give all materials the same law at walls, \
     such as pairs = \"glass-walls: mu=0.3; steel-walls: mu=0.3\" of grains, or no walls";

/// A step that is stable during a whole run: for the smallest sphere of the lowest density, the stiffest contact and the
/// largest force of one, and pistons, of these areas, on as many spheres as find room.
pub(crate) fn stable_step(
    (springs, mixture): (&Springs, &Mixture),
    (radii, kinds): (&[f64], &Kinds),
    force: f64,
    walls: &[(Wall, f64)],
) -> f64 {
    let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    let smallest = least(radii);
    let density = least(&kinds.densities);
    let at = |(_, area): &(Wall, f64)| {
        let room = (CLOSEST * area / (smallest * smallest)).ceil() as usize;
        room.min(radii.len())
    };
    let touching: Vec<usize> = walls.iter().map(at).collect();
    let walls: Vec<Wall> = walls.iter().map(|(wall, _)| *wall).collect();
    let of = |law: &Material| {
        let law = Material { density, ..*law };
        stable_step_between((springs, &law), (smallest, force), (&walls, &touching))
    };
    mixture.all().map(of).fold(f64::INFINITY, f64::min)
}

/// Mass of the spheres.
pub(crate) fn mass(radii: &[f64], kinds: &Kinds) -> f64 {
    let weighed = radii.iter().zip(&kinds.densities);
    weighed
        .map(|(radius, density)| density * volume(*radius))
        .sum()
}

/// Volume of a sphere.
pub(crate) fn volume(radius: f64) -> f64 {
    4.0 / 3.0 * PI * radius * radius * radius
}
