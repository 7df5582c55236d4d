//! Force chains after Peters, Muthuswamy, Wibowo and Tordesillas (2005), and their buckling.

use super::fabric::principal;
use super::{Assembly, Table};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;
use tribos_base::record::{ContactRow, Partner};

/// Fewest spheres of a chain.
const SHORTEST: usize = 3;
/// Stresses that differ from the mean by this share of it are equal to it but for rounding.
const ROUNDING: f64 = 1e-9;
/// Buckling counts from this change of the angle on, in rad: one degree (Tordesillas 2007).
const BUCKLED: f64 = PI / 180.0;

/// Chains of spheres along which the largest compression is passed on.
///
/// *Definition* (Peters et al., Phys. Rev. E 72, 041307, section II): the stress of a sphere is
/// Σ F ⊗ l/V over its contacts, l from its centre to the contact and V its volume. Spheres whose largest
/// principal stress is above the mean of all loaded spheres belong to chains; two of them are linked where
/// their contact lies within the angle of the principal directions of both. A chain has three spheres or more.
///
/// *Difference*: a sphere has at most one link at each end of its principal direction, the best aligned ones
/// first, so that chains do not branch and no sphere belongs to two.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceChains {
    /// The spheres of each chain from end to end.
    pub chains: Vec<Vec<u32>>,
    /// Largest principal stress of each sphere; 0 for those without contacts.
    pub stresses: Vec<f64>,
    /// Mean of the largest principal stress over the loaded spheres.
    pub mean_stress: f64,
    /// Share of the spheres that belong to a chain.
    pub share: f64,
}

/// Bending of the chains between two states.
///
/// The angle of three consecutive spheres is that between their two links; it changes as a chain buckles
/// (thesis, section 4.6.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Buckling {
    /// Number of triples of consecutive spheres.
    pub triples: usize,
    /// Number of triples that bent by one degree or more away from straight.
    pub buckled: usize,
    /// Mean change of the angle, in rad; positive away from straight.
    pub mean: f64,
    /// Largest change of the angle, in rad.
    pub largest: f64,
}

impl ForceChains {
    pub(super) fn of(assembly: &Assembly, angle: f64) -> Self {
        let (stresses, directions): (Vec<f64>, Vec<Vector3<f64>>) =
            tensors(assembly).iter().map(load).unzip();
        let loaded: Vec<f64> = stresses
            .iter()
            .copied()
            .filter(|stress| *stress > 0.0)
            .collect();
        let mean_stress = loaded.iter().sum::<f64>() / loaded.len() as f64;
        let is_strong = |index: u32| stresses[index as usize] >= (1.0 - ROUNDING) * mean_stress;
        let links = links(&assembly.contacts, &directions, libm::cos(angle), is_strong);
        let chains = follow(&links);
        let spheres: usize = chains.iter().map(Vec::len).sum();
        Self {
            share: spheres as f64 / stresses.len() as f64,
            chains,
            stresses,
            mean_stress,
        }
    }

    /// Mean number of spheres of a chain; NaN without chains.
    pub fn mean_length(&self) -> f64 {
        let spheres: usize = self.chains.iter().map(Vec::len).sum();
        spheres as f64 / self.chains.len() as f64
    }

    /// Number of spheres of the longest chain.
    pub fn longest(&self) -> usize {
        self.chains.iter().map(Vec::len).max().unwrap_or(0)
    }

    /// Columns: number of spheres, number of chains.
    pub fn table(&self) -> Table {
        let mut counts = vec![0.0; self.longest() + 1];
        for chain in &self.chains {
            counts[chain.len()] += 1.0;
        }
        let rows = counts.into_iter().enumerate().skip(SHORTEST);
        Table {
            name: "force-chains",
            columns: &["spheres", "chains"],
            rows: rows
                .map(|(length, count)| vec![length as f64, count])
                .collect(),
        }
    }

    /// How the chains bend from the state in which they were found to another one of the same spheres.
    pub fn buckling(&self, before: &Assembly, after: &Assembly) -> Buckling {
        let triples = self.chains.iter().flat_map(|chain| chain.windows(3));
        let change = |triple: &[u32]| bend(after, triple) - bend(before, triple);
        let changes: Vec<f64> = triples.map(change).collect();
        Buckling {
            triples: changes.len(),
            buckled: changes.iter().filter(|change| **change >= BUCKLED).count(),
            mean: changes.iter().sum::<f64>() / changes.len() as f64,
            largest: changes.iter().copied().fold(f64::NAN, f64::max),
        }
    }
}

/// Angle between the links of three spheres, in rad; 0 if they are in line.
fn bend(assembly: &Assembly, triple: &[u32]) -> f64 {
    let &[a, b, c] = triple else {
        return f64::NAN;
    };
    let [a, b, c] = [a, b, c].map(|index| assembly.positions[index as usize]);
    let (first, second) = (
        assembly.space.displacement(&a, &b),
        assembly.space.displacement(&b, &c),
    );
    libm::atan2(first.cross(&second).norm(), first.dot(&second))
}

/// Stress of each sphere, positive for compression.
fn tensors(assembly: &Assembly) -> Vec<Matrix3<f64>> {
    let radii = &assembly.radii;
    let mut tensors = vec![Matrix3::zeros(); radii.len()];
    for row in &assembly.contacts {
        // Force and lever change their signs together at the other end.
        let mut add = |index: u32| {
            let radius = radii[index as usize];
            let volume = 4.0 / 3.0 * PI * radius * radius * radius;
            let lever = row.normal * (radius + 0.5 * row.gap);
            tensors[index as usize] += row.force * lever.transpose() / volume;
        };
        add(row.a);
        if let Partner::Particle(b) = row.b {
            add(b);
        }
    }
    tensors
}

/// Largest principal stress and its direction.
fn load(tensor: &Matrix3<f64>) -> (f64, Vector3<f64>) {
    if *tensor == Matrix3::zeros() {
        return (0.0, Vector3::zeros());
    }
    let (values, direction) = principal(&((tensor + tensor.transpose()) * 0.5));
    (values[0], direction)
}

/// Links of each sphere against and along its principal direction.
fn links(
    contacts: &[ContactRow],
    directions: &[Vector3<f64>],
    least: f64,
    is_strong: impl Fn(u32) -> bool,
) -> Vec<[Option<u32>; 2]> {
    let mut found = Vec::new();
    for row in contacts {
        let Partner::Particle(b) = row.b else {
            continue;
        };
        if !is_strong(row.a) || !is_strong(b) || row.normal_force() <= 0.0 {
            continue;
        }
        // The contact as seen from both ends, each along its own direction.
        let cosines = [(row.a, 1.0), (b, -1.0)]
            .map(|(index, sign)| sign * directions[index as usize].dot(&row.normal));
        if cosines.iter().all(|cosine| cosine.abs() >= least) {
            found.push((cosines[0].abs() + cosines[1].abs(), [row.a, b], cosines));
        }
    }
    // The best aligned first; equal ones in the order of the spheres.
    found.sort_by(|x, y| f64::total_cmp(&y.0, &x.0).then(x.1.cmp(&y.1)));
    let mut links = vec![[None; 2]; directions.len()];
    for (_, [a, b], cosines) in found {
        let slots = cosines.map(|cosine| usize::from(cosine > 0.0));
        if links[a as usize][slots[0]].is_none() && links[b as usize][slots[1]].is_none() {
            links[a as usize][slots[0]] = Some(b);
            links[b as usize][slots[1]] = Some(a);
        }
    }
    links
}

/// The paths of links that are long enough; closed ones begin at their first sphere.
fn follow(links: &[[Option<u32>; 2]]) -> Vec<Vec<u32>> {
    let mut is_taken = vec![false; links.len()];
    let mut chains = Vec::new();
    let ends = |count: usize| {
        let number =
            move |(_, links): &(usize, &[Option<u32>; 2])| links.iter().flatten().count() == count;
        links
            .iter()
            .enumerate()
            .filter(number)
            .map(|(index, _)| index)
    };
    for start in ends(1).chain(ends(2)) {
        let mut chain = Vec::new();
        let mut next = Some(start);
        while let Some(index) = next {
            if std::mem::replace(&mut is_taken[index], true) {
                break;
            }
            chain.push(index as u32);
            let ahead = links[index].iter().flatten().map(|link| *link as usize);
            next = ahead.into_iter().find(|&link| !is_taken[link]);
        }
        if chain.len() >= SHORTEST {
            chains.push(chain);
        }
    }
    chains
}
