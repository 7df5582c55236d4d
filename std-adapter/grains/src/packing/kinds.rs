//! What each sphere of a packing is: its material and its density.

use super::Mixture;
use crate::packing::Assembly;
use nalgebra::Vector3;
use serde_json::{Map, Value};
use tribos_base::record::checkpoint::{damaged, hex, numbers, triple};
use tribos_base::record::{CheckpointError, digest};

/// Type of the spheres of the first material.
const FIRST: u8 = 1;

/// Material and density of each sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Kinds {
    /// Types, from 1: the numbers of the materials, and of what no force moves.
    pub materials: Vec<u8>,
    pub densities: Vec<f64>,
}

impl Kinds {
    /// Spheres of these types, each with the density of its material.
    pub fn of(materials: Vec<u8>, mixture: &Mixture) -> Self {
        let density = |kind: &u8| mixture.density(*kind);
        Self {
            densities: materials.iter().map(density).collect(),
            materials,
        }
    }

    /// Spheres of a file or a run, which keep what they have of both; what they lack is of the scene, whose materials
    /// are drawn.
    pub fn given(assembly: &Assembly, seed: u64, mixture: &Mixture) -> Self {
        let drawn = || mixture.draw(seed, assembly.radii.len());
        let of_file = assembly.materials.clone();
        let are_drawn = of_file.is_none();
        let mut kinds = Self::of(of_file.unwrap_or_else(drawn), mixture);
        let given = assembly.densities.iter().flatten();
        for ((mine, kind), given) in kinds.densities.iter_mut().zip(&kinds.materials).zip(given) {
            // Spheres that become another material have its density.
            let index = mixture.index(*kind);
            let is_dense = mixture.components()[index].is_dense;
            if !(are_drawn && index > 0 && is_dense) {
                *mine = *given;
            }
        }
        kinds
    }

    /// Index of the material of each sphere.
    pub fn indices(&self, mixture: &Mixture) -> Vec<u8> {
        let index = |kind: &u8| mixture.index(*kind) as u8;
        self.materials.iter().map(index).collect()
    }

    /// The materials, unless all are the first.
    pub fn mixed(&self) -> Option<&[u8]> {
        mixed(&self.materials).then_some(self.materials.as_slice())
    }

    /// Adds the kinds to a checkpoint or a state; one density if it is that of all.
    pub fn put(&self, map: &mut Map<String, Value>) {
        let digit = |&material: &u8| char::from(b'0' + material);
        let materials: String = self.materials.iter().map(digit).collect();
        map.insert("materials".into(), materials.into());
        let densities = match self.densities.as_slice() {
            [one, rest @ ..] if rest.iter().all(|other| other == one) => &self.densities[..1],
            all => all,
        };
        map.insert("densities".into(), hex(densities).into());
    }

    /// Reads the kinds of so many spheres.
    pub fn read(value: &Value, spheres: usize) -> Result<Self, CheckpointError> {
        let digits = value["materials"].as_str();
        let digits = digits.ok_or_else(|| damaged("materials"))?;
        let material = |byte| match byte {
            b'1'..=b'9' => Ok(byte - b'0'),
            _ => Err(damaged("materials")),
        };
        let materials = digits
            .bytes()
            .map(material)
            .collect::<Result<Vec<_>, _>>()?;
        let mut densities = numbers(value, "densities")?;
        if let &[one] = densities.as_slice() {
            densities = vec![one; spheres];
        }
        let positive = |density: &f64| *density > 0.0 && density.is_finite();
        if materials.len() != spheres {
            Err(damaged("materials"))
        } else if densities.len() != spheres || !densities.iter().all(positive) {
            Err(damaged("densities"))
        } else {
            Ok(Self {
                materials,
                densities,
            })
        }
    }
}

/// Whether any sphere is of another material than the first.
pub(crate) fn mixed(materials: &[u8]) -> bool {
    materials.iter().any(|&material| material != FIRST)
}

/// What a run begins with, as a digest: places, those of the corners of a mesh behind them, radii and kinds.
pub(crate) fn origin<'a>(
    positions: impl Iterator<Item = &'a Vector3<f64>>,
    radii: &[f64],
    kinds: &Kinds,
) -> String {
    let numbers = positions.flat_map(triple);
    let numbers = numbers.chain(radii.iter().chain(&kinds.densities).copied());
    let mut bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
    bytes.extend(&kinds.materials);
    format!("{:032x}", digest(&bytes))
}
