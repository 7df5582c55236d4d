//! The state of a gas at the start: places at random, Maxwell's velocities, no momentum.

use super::lattice::{edge, lattice, site};
use crate::gas::scene::GasScene;
use crate::packing::PlacementError;
use nalgebra::Vector3;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use tribos_base::random::Random;
use tribos_contacts::event::{Advance, HardSpheres, Impact, Motion, Tangential};

/// Streams of the seed.
const SITES: u64 = 10;
const VELOCITIES: u64 = 11;
const SPINS: u64 = 12;
/// Moment of inertia of a sphere.
const INERTIA: f64 = 0.4;

/// Places and motions, after the elastic collisions that mix them; `watch` can stop it.
pub(super) fn start(
    scene: &GasScene,
    watch: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<Vec<(Vector3<f64>, Motion)>, PlacementError> {
    let length = edge(scene.count, scene.packing_fraction);
    let cells = lattice(scene.count, length).ok_or(PlacementError::Room)?;
    let places = chosen(scene.count, 4 * cells * cells * cells, scene.seed);
    let mut velocities = maxwellian(scene.count, scene.seed, VELOCITIES);
    scale(&mut velocities, 1.0);
    let bodies: Vec<_> = places
        .into_iter()
        .zip(velocities)
        .map(|(number, velocity)| {
            let spin = Vector3::zeros();
            (site(number, cells, length), Motion { velocity, spin })
        })
        .collect();

    // Elastic collisions mix places and velocities.
    let elastic = Impact::new(1.0, Tangential::Smooth)?;
    let mut gas = HardSpheres::new(length, &bodies, elastic, 0.0)?;
    let each = scene.count as u64;
    let enough = (0.5 * scene.mixing_collisions * scene.count as f64) as u64;
    while gas.collisions() < enough {
        if watch(scene.count).is_break() {
            return Err(PlacementError::Stopped);
        }
        let next = (gas.collisions() + each).min(enough);
        if gas.advance(next, f64::INFINITY) != Advance::Collisions {
            break;
        }
    }

    let mut velocities: Vec<_> = gas.motions().map(|motion| motion.velocity).collect();
    scale(&mut velocities, 1.0);
    let mut spins = maxwellian(scene.count, scene.seed, SPINS);
    scale(&mut spins, scene.rotational_temperature / INERTIA);
    let motions = velocities.into_iter().zip(spins);
    let motions = motions.map(|(velocity, spin)| Motion { velocity, spin });
    Ok(gas.places().into_iter().zip(motions).collect())
}

/// So many different numbers below a bound, in random order.
fn chosen(count: usize, below: usize, seed: u64) -> Vec<usize> {
    let mut numbers = Random::new(seed, SITES);
    let mut all: Vec<usize> = (0..below).collect();
    for k in 0..count {
        let rest = below - k;
        let other = k + ((numbers.unit() * rest as f64) as usize).min(rest - 1);
        all.swap(k, other);
    }
    all.truncate(count);
    all
}

/// Vectors with normally distributed components (Box & Muller 1958).
fn maxwellian(count: usize, seed: u64, stream: u64) -> Vec<Vector3<f64>> {
    let mut numbers = Random::new(seed, stream);
    let mut normal = || {
        // 1 − u is never 0.
        let radius = (-2.0 * libm::log(1.0 - numbers.unit())).sqrt();
        radius * libm::cos(2.0 * PI * numbers.unit())
    };
    (0..count)
        .map(|_| {
            let [x, y, z] = [normal(), normal(), normal()];
            Vector3::new(x, y, z)
        })
        .collect()
}

/// Takes away the mean and gives ⅓ of the mean square its value.
fn scale(vectors: &mut [Vector3<f64>], wanted: f64) {
    let count = vectors.len() as f64;
    let mean = vectors.iter().sum::<Vector3<f64>>() / count;
    for vector in vectors.iter_mut() {
        *vector -= mean;
    }
    let square: f64 = vectors.iter().map(Vector3::norm_squared).sum::<f64>() / (3.0 * count);
    let factor = if square > 0.0 {
        (wanted / square).sqrt()
    } else {
        0.0
    };
    for vector in vectors {
        *vector *= factor;
    }
}
