//! Contact patches.

use crate::arrays::refused;
use pyo3::prelude::*;
use tribos::friction::{Area, Coefficients};
use tribos_core::patch::mesh::Vertex;
use tribos_core::patch::nodes::Node;

/// A contact patch.
#[pyclass(frozen, module = "tribos._native")]
pub struct Patch(pub Area);

#[pymethods]
impl Patch {
    /// A patch as scenes write it; one with an axis has this radius.
    #[staticmethod]
    fn named(text: &str, radius: f64) -> PyResult<Self> {
        let patch = text.parse().map_err(refused)?;
        Ok(Self(Area::named(&patch, radius, None).map_err(refused)?))
    }

    /// A polygon: its outer loop, then its holes.
    #[staticmethod]
    fn polygon(loops: Vec<Vec<[f64; 2]>>, centre: Option<[f64; 2]>) -> PyResult<Self> {
        let loops: Vec<&[[f64; 2]]> = loops.iter().map(Vec::as_slice).collect();
        Ok(Self(Area::polygon(&loops, centre).map_err(refused)?))
    }

    /// Triangles of vertices x, y, pressure.
    #[staticmethod]
    fn mesh(vertices: Vec<[f64; 3]>, triangles: Vec<[usize; 3]>) -> PyResult<Self> {
        let vertex = |[x, y, pressure]: [f64; 3]| Vertex { x, y, pressure };
        let vertices: Vec<Vertex<f64>> = vertices.into_iter().map(vertex).collect();
        Ok(Self(Area::mesh(&vertices, &triangles).map_err(refused)?))
    }

    /// Points x, y, weight.
    #[staticmethod]
    fn points(points: Vec<[f64; 3]>) -> PyResult<Self> {
        let node = |[x, y, weight]: [f64; 3]| Node { x, y, weight };
        let nodes = points.into_iter().map(node).collect();
        Ok(Self(Area::points(nodes).map_err(refused)?))
    }

    /// The patch under friction that differs along an axis and across it, the axis at an angle in rad.
    fn anisotropic(&self, mu: [f64; 2], axis: f64) -> PyResult<Self> {
        let mu = Coefficients::along_and_across(mu, axis).map_err(refused)?;
        Ok(Self(mu.on(self.0.clone()).map_err(refused)?))
    }

    /// Distance of the farthest point from the centre of pressure, in m.
    fn radius(&self) -> f64 {
        self.0.radius()
    }

    /// The centre of pressure, in m.
    fn centre(&self) -> [f64; 2] {
        self.0.centre()
    }
}
