//! Dense random packings: spheres that press on each other from all sides, between two plates.

use nalgebra::Vector3;
use tribos::random::Random;
use tribos::space::pairs::Cells;
use tribos::space::{PeriodicBox, SpaceError};

/// Solid fraction, above random close packing (0.64): there are more contacts than forces can determine.
pub const SOLID_FRACTION: f64 = 0.66;
/// Half width of the radii around 1, which keeps a quick compression from making a crystal.
pub const UNEVEN: f64 = 0.1;
/// Extra distance of listed neighbours, so that a list can be used for many steps.
const SKIN: f64 = 0.3;
/// Steps of the relaxation, first and longest, in √(m/k): half of what twelve springs would allow.
const STEP: f64 = 0.1;
const LONGEST: f64 = 0.3;
/// Largest remaining force, in k R; contacts overlap by about 1e-2 R.
const RELAXED: f64 = 1e-4;
/// Most steps of the relaxation.
const MOST_STEPS: usize = 20_000;

/// Spheres between a plate at z = 0 and one at z = `height`, periodic across.
#[derive(Clone, Debug)]
pub struct Jammed {
    /// Periodic along x and y.
    pub space: PeriodicBox,
    /// Centres.
    pub positions: Vec<Vector3<f64>>,
    /// Radii.
    pub radii: Vec<f64>,
    /// Place of the upper plate.
    pub height: f64,
}

/// Why a packing could not be made.
#[derive(Debug)]
pub struct NotJammed(pub String);

impl core::fmt::Display for NotJammed {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "no packing: {}", self.0)
    }
}

impl core::error::Error for NotJammed {}

impl From<SpaceError> for NotJammed {
    fn from(error: SpaceError) -> Self {
        Self(error.to_string())
    }
}

/// Packs `count` spheres with radii 1 ± `uneven` over a square of `width`.
///
/// Random positions are relaxed as soft spheres until all forces balance. Remaining overlaps count
/// as contacts: the soft forces show that pushes alone can hold the packing under load.
pub fn jammed(count: usize, width: f64, uneven: f64, seed: u64) -> Result<Jammed, NotJammed> {
    let mut random = Random::new(seed, 0);
    let mut around_1 = |_| 1.0 + uneven * (2.0 * random.unit() - 1.0);
    let radii: Vec<f64> = (0..count).map(&mut around_1).collect();
    let volume: f64 = radii
        .iter()
        .map(|r| 4.0 / 3.0 * std::f64::consts::PI * r.powi(3))
        .sum();
    let height = volume / (SOLID_FRACTION * width * width);
    let size = Vector3::new(width, width, height);
    let place = |_| Vector3::from_fn(|axis, _| size[axis] * random.unit());
    let mut packing = Jammed {
        space: PeriodicBox::new([Some(width), Some(width), None])?,
        positions: (0..count).map(place).collect(),
        radii,
        height,
    };
    relax(&mut packing)?;
    // From the bottom to the top, as a deposit is numbered.
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| packing.positions[a].z.total_cmp(&packing.positions[b].z));
    packing.radii = order.iter().map(|&i| packing.radii[i]).collect();
    packing.positions = order.iter().map(|&i| packing.positions[i]).collect();
    Ok(packing)
}

/// Brings soft spheres to rest: velocities are turned towards the force and stopped when they lead
/// uphill (Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201, with its constants).
fn relax(packing: &mut Jammed) -> Result<(), NotJammed> {
    // Share of the velocity that is turned in a step, and how both change.
    const TURN: f64 = 0.1;
    const PATIENCE: usize = 5;
    let (mut step, mut turn, mut downhill) = (STEP, TURN, 0);
    let count = packing.positions.len();
    let mut velocities = vec![Vector3::zeros(); count];
    let mut forces = vec![Vector3::zeros(); count];
    let mut cells = Cells::default();
    let mut pairs: Vec<[u32; 2]> = Vec::new();
    let mut listed_at: Vec<Vector3<f64>> = Vec::new();
    for _ in 0..MOST_STEPS {
        let far = |(x, y): (&Vector3<f64>, &Vector3<f64>)| (x - y).norm() > 0.5 * SKIN;
        if listed_at.len() != count || packing.positions.iter().zip(&listed_at).any(far) {
            let found = cells.find(&packing.space, &packing.positions, &packing.radii, SKIN)?;
            pairs = found.to_vec();
            listed_at.clone_from(&packing.positions);
        }
        soft_forces(packing, &pairs, &mut forces);
        let largest = forces.iter().map(Vector3::norm).fold(0.0, f64::max);
        if largest <= RELAXED {
            return Ok(());
        }
        let power: f64 = forces.iter().zip(&velocities).map(|(f, v)| f.dot(v)).sum();
        let sizes = [&forces, &velocities].map(|list| {
            let sum: f64 = list.iter().map(Vector3::norm_squared).sum();
            sum.sqrt()
        });
        if power > 0.0 {
            downhill += 1;
            if downhill > PATIENCE {
                step = (1.1 * step).min(LONGEST);
                turn *= 0.99;
            }
        } else {
            (step, turn, downhill) = (0.5 * step, TURN, 0);
        }
        for ((x, v), f) in packing
            .positions
            .iter_mut()
            .zip(&mut velocities)
            .zip(&forces)
        {
            *v = if power > 0.0 {
                *v * (1.0 - turn) + f * (turn * sizes[1] / sizes[0])
            } else {
                Vector3::zeros()
            };
            *v += f * step;
            *x += *v * step;
        }
    }
    Err(NotJammed(format!(
        "{count} soft spheres did not come to rest in {MOST_STEPS} steps"
    )))
}

/// Springs of stiffness 1 against every overlap.
fn soft_forces(packing: &Jammed, pairs: &[[u32; 2]], forces: &mut [Vector3<f64>]) {
    forces.fill(Vector3::zeros());
    for &[a, b] in pairs {
        let [a, b] = [a as usize, b as usize];
        let apart = packing
            .space
            .displacement(&packing.positions[a], &packing.positions[b]);
        let distance = apart.norm();
        let overlap = packing.radii[a] + packing.radii[b] - distance;
        if overlap > 0.0 && distance > 0.0 {
            let push = apart * (overlap / distance);
            forces[a] -= push;
            forces[b] += push;
        }
    }
    for ((f, x), r) in forces
        .iter_mut()
        .zip(&packing.positions)
        .zip(&packing.radii)
    {
        f.z += (r - x.z).max(0.0) - (x.z + r - packing.height).max(0.0);
    }
}
