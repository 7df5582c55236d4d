//! Contact patches.

use crate::arrays::refused;
use pyo3::prelude::*;
use tribos::friction;
use tribos_core::patch::PatchError;
use tribos_core::patch::bar::Bar;
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};
use tribos_core::patch::nodes::{Node, NodePatch, NodeSlice};
use tribos_core::patch::outline::{Edge, Linear, Polygon};
use tribos_core::patch::points::Points;

/// Points in a list.
#[derive(Clone)]
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
#[derive(Clone)]
pub enum Shape {
    /// With an axis: a patch of the library, and its radius in m.
    Round(friction::Patch, f64),
    /// Straight edges under uniform pressure.
    Polygon(Polygon<f64, Vec<Edge<f64>>>),
    /// Straight edges under linear pressure.
    Leaning(Polygon<f64, Vec<Edge<f64>>, Linear<f64>>),
    /// A line.
    Bar(Bar<f64>),
    /// Triangles under linear pressure.
    Mesh(Mesh<f64, Vec<Triangle<f64>>>),
    /// Points with weights.
    Points(Points<f64, Nodes>),
}

/// A contact patch.
#[pyclass(frozen, module = "tribos._native")]
pub struct Patch(pub Shape);

#[pymethods]
impl Patch {
    /// A patch with an axis, by its name in radii.
    #[staticmethod]
    fn round(text: &str, radius: f64) -> PyResult<Self> {
        let patch: friction::Patch = text.parse().map_err(refused)?;
        if !patch.has_axis() {
            return Err(refused(format!("`{text}` has no axis")));
        }
        if let friction::Patch::Polynomial(coefficients) = &patch {
            // Refuses what is negative anywhere.
            friction::polynomial(coefficients).map_err(refused)?;
        }
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(refused(format!(
                "the radius must be > 0 and finite, not {radius}"
            )));
        }
        Ok(Self(Shape::Round(patch, radius)))
    }

    /// A polygon: its outer loop, then its holes.
    #[staticmethod]
    fn polygon(loops: Vec<Vec<[f64; 2]>>, centre: Option<[f64; 2]>) -> PyResult<Self> {
        let slices: Vec<&[[f64; 2]]> = loops.iter().map(Vec::as_slice).collect();
        let count = loops.iter().map(Vec::len).sum();
        let memory = vec![Edge::default(); count];
        let polygon = Polygon::with_holes(&slices, memory).map_err(refused)?;
        Ok(Self(match centre {
            None => Shape::Polygon(polygon),
            Some(at) => Shape::Leaning(polygon.with_centre_of_pressure(at).map_err(refused)?),
        }))
    }

    /// A line between two points.
    #[staticmethod]
    fn bar(start: [f64; 2], end: [f64; 2]) -> PyResult<Self> {
        Ok(Self(Shape::Bar(Bar::new(start, end).map_err(refused)?)))
    }

    /// Triangles of vertices x, y, pressure.
    #[staticmethod]
    fn mesh(vertices: Vec<[f64; 3]>, triangles: Vec<[usize; 3]>) -> PyResult<Self> {
        let vertices: Vec<Vertex<f64>> = vertices
            .into_iter()
            .map(|[x, y, pressure]| Vertex { x, y, pressure })
            .collect();
        let memory = vec![Triangle::default(); triangles.len()];
        let mesh = Mesh::with_vertices(&vertices, &triangles, memory).map_err(refused)?;
        Ok(Self(Shape::Mesh(mesh)))
    }

    /// Points x, y, weight.
    #[staticmethod]
    fn points(points: Vec<[f64; 3]>) -> PyResult<Self> {
        let nodes = points
            .into_iter()
            .map(|[x, y, weight]| Node { x, y, weight })
            .collect();
        let points = Nodes::new(nodes).and_then(Points::new).map_err(refused)?;
        Ok(Self(Shape::Points(points)))
    }

    /// Distance of the farthest point from the centre of pressure, in m.
    fn radius(&self) -> f64 {
        match &self.0 {
            Shape::Round(_, radius) => *radius,
            Shape::Polygon(patch) => patch.radius(),
            Shape::Leaning(patch) => patch.radius(),
            Shape::Bar(patch) => patch.radius(),
            Shape::Mesh(patch) => patch.radius(),
            Shape::Points(patch) => patch.radius(),
        }
    }

    /// The centre of pressure, in m.
    fn centre(&self) -> [f64; 2] {
        let centre = match &self.0 {
            Shape::Round(..) => return [0.0; 2],
            Shape::Polygon(patch) => patch.centre(),
            Shape::Leaning(patch) => patch.centre(),
            Shape::Bar(patch) => patch.centre(),
            Shape::Mesh(patch) => patch.centre(),
            Shape::Points(patch) => patch.centre(),
        };
        [centre.x, centre.y]
    }
}
