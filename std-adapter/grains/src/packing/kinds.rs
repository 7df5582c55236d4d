//! What each sphere of a packing is: its material and its density.

use super::{Material, SecondMaterial, SecondMaterialKeys};
use crate::packing::Assembly;
use nalgebra::Vector3;
use serde_json::{Map, Value};
use tribos_base::record::checkpoint::{damaged, hex, numbers, triple};
use tribos_base::record::{CheckpointError, digest};

/// Numbers of the two materials of a scene. Grains of higher numbers are of the first.
pub(super) const FIRST: u8 = 1;
pub(super) const SECOND: u8 = 2;

/// Material and density of each sphere.
#[derive(Clone, Debug, PartialEq)]
pub struct Kinds {
    /// Numbers of the materials, from 1.
    pub materials: Vec<u8>,
    pub densities: Vec<f64>,
}

impl Kinds {
    /// Spheres of two materials, each with the density of its own.
    pub fn of(is_second: &[bool], first: &Material, other: &SecondMaterialKeys) -> Self {
        let number = |&is: &bool| if is { SECOND } else { FIRST };
        let second = other.density.unwrap_or(first.density);
        let density = |&is: &bool| if is { second } else { first.density };
        Self {
            materials: is_second.iter().map(number).collect(),
            densities: is_second.iter().map(density).collect(),
        }
    }

    /// Spheres of a file or a run, which keep what they have of both; what they lack is of the scene, whose share
    /// of a second material is drawn.
    pub fn given(
        assembly: &Assembly,
        (seed, share): (u64, f64),
        (first, other): (&Material, &SecondMaterialKeys),
    ) -> Self {
        let drawn = || SecondMaterial::choose(seed, share, assembly.radii.len());
        let of_file = assembly.materials.as_ref();
        let is_second: Vec<bool> = of_file.map_or_else(drawn, |all| {
            all.iter().map(|&material| material == SECOND).collect()
        });
        let mut kinds = Self::of(&is_second, first, other);
        // Higher numbers stay what they are.
        let numbers = kinds
            .materials
            .iter_mut()
            .zip(of_file.into_iter().flatten());
        for (mine, given) in numbers.filter(|(_, given)| **given > SECOND) {
            *mine = *given;
        }
        if let Some(densities) = &assembly.densities {
            let is_chosen = of_file.is_none() && other.density.is_some();
            for ((mine, given), is_second) in
                kinds.densities.iter_mut().zip(densities).zip(is_second)
            {
                // Spheres that become the second material have its density.
                if !(is_chosen && is_second) {
                    *mine = *given;
                }
            }
        }
        kinds
    }

    /// One flag a sphere, true if it is of the second material.
    pub fn is_second(&self) -> Vec<bool> {
        let is = |&material: &u8| material == SECOND;
        self.materials.iter().map(is).collect()
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
