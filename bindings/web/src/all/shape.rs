//! Contact patches.

use crate::exchange::Refused;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;
use tribos::friction;
use tribos_core::Error;
use tribos_core::patch::PatchError;
use tribos_core::patch::bar::Bar;
use tribos_core::patch::nodes::{Node, NodePatch, NodeSlice};
use tribos_core::patch::outline::{Edge, Linear, Polygon};
use tribos_core::patch::points::Points;

/// Points in a list.
#[derive(Clone, Debug)]
pub struct Nodes {
    nodes: Vec<Node<f64>>,
    total: f64,
}

impl Nodes {
    fn new(nodes: Vec<Node<f64>>) -> Result<Self, PatchError> {
        let total = NodeSlice::new(&nodes)?.total_weight();
        Ok(Self { nodes, total })
    }
}

impl NodePatch<f64> for Nodes {
    fn nodes(&self) -> &[Node<f64>] {
        &self.nodes
    }
    fn total_weight(&self) -> f64 {
        self.total
    }
}

/// A patch, ready for the kernel.
#[derive(Clone, Debug)]
pub enum Shape {
    /// With an axis: a patch of the library, and its radius in m.
    Round(friction::Patch, f64),
    /// Straight edges under uniform pressure.
    Polygon(Polygon<f64, Vec<Edge<f64>>>),
    /// Straight edges under linear pressure.
    Leaning(Polygon<f64, Vec<Edge<f64>>, Linear<f64>>),
    /// A line.
    Bar(Bar<f64>),
    /// Points with weights.
    Points(Points<f64, Nodes>),
}

/// A refusal of the library in its words.
pub fn said(error: impl ToString) -> Refused {
    Refused::Said(error.to_string())
}

impl Shape {
    /// A patch with an axis, by its name in radii.
    pub fn round(text: &str, radius: f64) -> Result<Self, Refused> {
        let patch: friction::Patch = text.parse().map_err(said)?;
        if !patch.has_axis() {
            return Err(said(friction::Refusal::NoAxis));
        }
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Error::from(PatchError::Radius { given: radius }).into());
        }
        Ok(Self::Round(patch, radius))
    }

    /// A polygon: its outer loop, then its holes; a centre of pressure makes the pressure linear.
    pub fn polygon(
        corners: &[[f64; 2]],
        counts: &[usize],
        centre: Option<[f64; 2]>,
    ) -> Result<Self, Refused> {
        let memory = vec![Edge::default(); corners.len()];
        let polygon = Polygon::with_counts(corners, counts, memory).map_err(Error::from)?;
        Ok(match centre {
            None => Self::Polygon(polygon),
            Some(at) => Self::Leaning(polygon.with_centre_of_pressure(at).map_err(Error::from)?),
        })
    }

    /// A line of this length along x about the origin.
    pub fn bar(length: f64) -> Result<Self, Refused> {
        let half = 0.5 * length;
        Ok(Self::Bar(
            Bar::new([-half, 0.0], [half, 0.0]).map_err(Error::from)?,
        ))
    }

    /// Points x, y, weight.
    pub fn points(points: &[[f64; 3]]) -> Result<Self, Refused> {
        let node = |&[x, y, weight]: &[f64; 3]| Node { x, y, weight };
        let nodes = Nodes::new(points.iter().map(node).collect());
        let points = nodes.and_then(Points::new).map_err(Error::from)?;
        Ok(Self::Points(points))
    }

    /// Distance of the farthest point from the centre of pressure, in m.
    pub fn radius(&self) -> f64 {
        match self {
            Self::Round(_, radius) => *radius,
            Self::Polygon(patch) => patch.radius(),
            Self::Leaning(patch) => patch.radius(),
            Self::Bar(patch) => patch.radius(),
            Self::Points(patch) => patch.radius(),
        }
    }

    /// The centre of pressure, in m.
    pub fn centre(&self) -> [f64; 2] {
        let centre = match self {
            Self::Round(..) => return [0.0; 2],
            Self::Polygon(patch) => patch.centre(),
            Self::Leaning(patch) => patch.centre(),
            Self::Bar(patch) => patch.centre(),
            Self::Points(patch) => patch.centre(),
        };
        [centre.x, centre.y]
    }
}
