//! Limit surfaces of patches by name.

use super::{Patch, Refusal, columns, polynomial};
use std::path::Path;
use tribos_core::coupling::round::{PolynomialTable, RoundTable64};
use tribos_core::coupling::{Annulus, Dry, closed, table::Coulomb};
use tribos_core::limit_surface::{FrictionSet, LimitSurface, PatchSurface};
use tribos_core::patch::PatchError;
use tribos_core::patch::nodes::{Node, NodePatch, NodeSlice};
use tribos_core::patch::points::Points;

/// All wrenches that dry friction carries on `patch`, exact to rounding.
///
/// *Units*: `force_limit` is μN in N, `radius` in m. A patch with straight edges has its own size, and
/// its pressure its centre at `centre` where one is given; `radius` is for round patches. Points and
/// meshes have their own size too. The set of points has flat facets, whose normal is the rotation
/// about a point.
///
/// ```
/// use tribos::friction::limit_surface;
/// use tribos::prelude::*;
/// let table = limit_surface(&"box:0.2x0.1".parse()?, 2.0, 1.0, None)?; // N, m
/// let motion = table.twist_normal_to(&Wrench::new(0.0, 2.0, 0.08)); // N, N, N m
/// assert!(motion.velocity.y > 0.0 && motion.spin > 0.0);
/// let puck = limit_surface(&Patch::Disk, 0.5, 0.04, None)?;
/// assert!((puck.gauge(&Wrench::new(0.0, 0.0, 0.5 * 0.04 * 2.0 / 3.0)) - 1.0).abs() < 1e-14);
/// # Ok::<(), tribos::friction::Refusal>(())
/// ```
pub fn limit_surface(
    patch: &Patch,
    force_limit: f64,
    radius: f64,
    centre: Option<[f64; 2]>,
) -> Result<Box<dyn FrictionSet<f64>>, Refusal> {
    let (limit, r) = (force_limit, radius);
    if centre.is_some() && !matches!(patch, Patch::Flat(_)) {
        let reason = "a centre of pressure is for boxes and polygons";
        return Err(Refusal::Syntax(reason.into()));
    }
    Ok(match patch {
        Patch::Flat(flat) => Box::new(PatchSurface::new(flat.loaded::<f64>(centre)?, limit)?),
        Patch::Disk => Box::new(LimitSurface::new(Coulomb, limit, r)?),
        Patch::Ring => Box::new(LimitSurface::new(closed::Ring, limit, r)?),
        Patch::Hertz => Box::new(LimitSurface::new(closed::Hertz, limit, r)?),
        Patch::Punch => Box::new(LimitSurface::new(closed::FlatPunch, limit, r)?),
        Patch::Annulus(inner) => {
            Box::new(LimitSurface::new(Annulus::new(Coulomb, *inner)?, limit, r)?)
        }
        Patch::Paraboloid | Patch::Power(_) => {
            let pressure = patch.pressure().ok_or(Refusal::NoAxis)?;
            let table = Dry::new(RoundTable64::new(0.0, pressure)?)?;
            Box::new(LimitSurface::new(table, limit, r)?)
        }
        Patch::Polynomial(coefficients) => {
            let table = PolynomialTable::new(0.0, &polynomial(coefficients)?)?;
            Box::new(LimitSurface::new(Dry::new(table)?, limit, r)?)
        }
        Patch::Points(file) => {
            let nodes = HeldNodes::new(points_of(file)?)?;
            Box::new(PatchSurface::new(Points::new(nodes)?, limit)?)
        }
    })
}

/// The points of a file.
#[doc(hidden)]
pub fn points_of(file: &Path) -> Result<Vec<Node<f64>>, Refusal> {
    let rows = columns::read(file, ["x", "y", "weight"], MOST_POINTS)?;
    let node = |&[x, y, weight]: &[f64; 3]| Node { x, y, weight };
    Ok(rows.iter().map(node).collect())
}

/// Most points of a file.
const MOST_POINTS: usize = 100_000;

/// Nodes in a list.
#[derive(Debug)]
#[doc(hidden)]
pub struct HeldNodes {
    nodes: Vec<Node<f64>>,
    total: f64,
}

impl HeldNodes {
    #[doc(hidden)]
    pub fn new(nodes: Vec<Node<f64>>) -> Result<Self, PatchError> {
        let total = NodeSlice::new(&nodes)?.total_weight();
        Ok(Self { nodes, total })
    }
}

impl NodePatch<f64> for HeldNodes {
    fn nodes(&self) -> &[Node<f64>] {
        &self.nodes
    }
    fn total_weight(&self) -> f64 {
        self.total
    }
}
