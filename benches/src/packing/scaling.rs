//! Sweeps to a residual against the size of a packing: diffusion of information, (L/d)² for plain
//! sweeps (Unger and Kertész 2003), and waves, L/d, for accelerated ones.

use super::jammed::{Jammed, NotJammed, jammed};
use super::problems::{chain, pressed};
use super::work::{Method, Work, work_to};
use crate::power_law::exponent;
use crate::written::{Sheet, short};
use tribos::cd::IterationOrder;
use tribos::cd::internals::{Coefficients, Operator, Spheres};
use tribos_core::contact::{ContactFriction, IndependentFriction};
use tribos_tests::packings::rough;

/// Residuals to reach.
const TARGETS: [f64; 2] = [1e-6, 1e-8];
/// Plain and accelerated.
pub const METHODS: [Method; 2] = [
    Method::GaussSeidel(IterationOrder::Fixed),
    Method::Accelerated,
];
/// Width of a tower, in radii.
const TOWER: f64 = 8.0;
/// Width of a cube of `count` spheres, in radii: as high as wide.
fn cube(count: usize) -> f64 {
    (4.0 / 3.0 * std::f64::consts::PI * count as f64 / super::jammed::SOLID_FRACTION).cbrt()
}
/// Sliding, rolling and torsion coefficients.
const MU: [f64; 3] = [0.3, 0.1, 0.1];
const SEED: u64 = 1;
/// Most sweeps of any run.
const MOST_SWEEPS: usize = 1_000_000;

/// Sizes of the families, and a limit for the expected contact updates of a run.
#[derive(Clone, Debug)]
pub struct Extent {
    /// Spheres of chains.
    pub chains: Vec<usize>,
    /// Spheres of towers.
    pub towers: Vec<usize>,
    /// Spheres of cubes.
    pub cubes: Vec<usize>,
    /// Most contact updates of a run.
    pub updates: f64,
}

/// Work of one method on one packing.
#[derive(Clone, Debug)]
pub struct Point {
    /// Chain, tower or cube, and its friction.
    pub family: &'static str,
    /// Spheres and contacts.
    pub size: [usize; 2],
    /// Height over diameter.
    pub length: f64,
    /// Method.
    pub method: Method,
    /// Residual to reach.
    pub target: f64,
    /// Work of the run.
    pub work: Work,
}

/// All families; sizes that would take too long for a method are left out.
pub fn measure(extent: &Extent) -> Result<Vec<Point>, NotJammed> {
    let (smooth, all) = (IndependentFriction::none(), rough(MU[0], MU[1], MU[2]));
    let mut points = Vec::new();
    for &count in &extent.chains {
        let packing = chain(count);
        grow(
            "chain",
            &packing,
            &pressed(&packing, smooth)?,
            extent,
            &mut points,
        );
    }
    for &count in &extent.towers {
        let packing = jammed(count, TOWER, 0.0, SEED)?;
        let family = "tower, frictionless";
        grow(
            family,
            &packing,
            &pressed(&packing, smooth)?,
            extent,
            &mut points,
        );
        grow(
            "tower, all modes",
            &packing,
            &pressed(&packing, all)?,
            extent,
            &mut points,
        );
    }
    for &count in &extent.cubes {
        let packing = jammed(count, cube(count), 0.0, SEED)?;
        let family = "cube, frictionless";
        grow(
            family,
            &packing,
            &pressed(&packing, smooth)?,
            extent,
            &mut points,
        );
        grow(
            "cube, all modes",
            &packing,
            &pressed(&packing, all)?,
            extent,
            &mut points,
        );
    }
    Ok(points)
}

/// All methods and targets on one packing.
fn grow<F>(
    family: &'static str,
    packing: &Jammed,
    problem: &Spheres<F>,
    extent: &Extent,
    points: &mut Vec<Point>,
) where
    F: ContactFriction<f64> + Coefficients,
{
    let contacts = problem.contacts();
    let mut sizes: Vec<_> = points
        .iter()
        .filter(|point| point.family == family)
        .map(|point| point.size)
        .collect();
    sizes.dedup();
    let sizes_before = sizes.len();
    let affordable = (extent.updates / contacts as f64) as usize;
    for method in METHODS {
        for target in TARGETS {
            let same = |point: &&Point| {
                point.family == family && point.method == method && point.target == target
            };
            // A run that was too long at the previous size is too long at this one.
            let reached = points.iter().filter(same).count();
            if reached < sizes_before {
                continue;
            }
            let Some(work) = work_to(problem, method, target, affordable.min(MOST_SWEEPS)) else {
                break;
            };
            points.push(Point {
                family,
                size: [packing.positions.len(), contacts],
                length: 0.5 * packing.height,
                method,
                target,
                work,
            });
        }
    }
}

/// A power law through points of one family.
#[derive(Clone, Debug)]
pub struct Law {
    /// Family.
    pub family: &'static str,
    /// Method.
    pub method: Method,
    /// Residual to reach.
    pub target: f64,
    /// Points.
    pub points: usize,
    /// Range of L/d.
    pub lengths: [f64; 2],
    /// Exponent of L/d.
    pub exponent: f64,
}

/// Least squares of the logarithms, for every family of at least three sizes.
pub fn laws(points: &[Point]) -> Vec<Law> {
    let mut families: Vec<_> = points.iter().map(|point| point.family).collect();
    families.dedup();
    let mut seen = Vec::new();
    families.retain(|family| {
        !seen.contains(family) && {
            seen.push(*family);
            true
        }
    });
    let mut laws = Vec::new();
    for family in families {
        for (method, target) in METHODS
            .iter()
            .flat_map(|&m| TARGETS.map(|target| (m, target)))
        {
            let of_law = |point: &&Point| {
                point.family == family && point.method == method && point.target == target
            };
            let of_size = |point: &Point| [point.length, point.work.sweeps as f64];
            let line: Vec<[f64; 2]> = points.iter().filter(of_law).map(of_size).collect();
            if line.len() >= 3 {
                laws.push(Law {
                    family,
                    method,
                    target,
                    points: line.len(),
                    lengths: [line[0][0], line[line.len() - 1][0]],
                    exponent: exponent(line),
                });
            }
        }
    }
    laws
}

/// Every point.
pub fn points_sheet(points: &[Point]) -> Sheet {
    Sheet::of(
        "Work to a residual against size: a chain, towers and cubes of a jammed packing \
         under a loaded plate, cold starts",
        points,
        &[
            ("family", &|point| point.family.replace(',', "")),
            ("spheres", &|point| point.size[0].to_string()),
            ("contacts", &|point| point.size[1].to_string()),
            ("L/d", &|point| short(point.length)),
            ("method", &|point| point.method.name().into()),
            ("residual", &|point| format!("{:.0e}", point.target)),
            ("sweeps", &|point| point.work.sweeps.to_string()),
            ("s", &|point| short(point.work.seconds)),
        ],
    )
}

/// Fitted exponents beside those of theory.
pub fn laws_sheet(laws: &[Law]) -> Sheet {
    let theory = |law: &&Law| match law.method {
        Method::Accelerated => "1".into(),
        _ => "2".into(),
    };
    Sheet::of(
        "Exponents of sweeps in L/d, by least squares of logarithms",
        laws,
        &[
            ("family", &|law| law.family.replace(',', "")),
            ("method", &|law| law.method.name().into()),
            ("residual", &|law| format!("{:.0e}", law.target)),
            ("sizes", &|law| law.points.to_string()),
            ("L/d", &|law| {
                format!("{} to {}", short(law.lengths[0]), short(law.lengths[1]))
            }),
            ("exponent", &|law| format!("{:.2}", law.exponent)),
            ("theory", &theory),
        ],
    )
}
