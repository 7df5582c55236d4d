//! The meshes of `meshes.csv`.

use crate::tables::Table;
use tribos_core::Real;
use tribos_core::patch::mesh::{Mesh, Triangle, Vertex};

/// A mesh of the tables.
#[derive(Clone, Debug)]
pub struct Faces {
    /// Its name.
    pub name: String,
    /// Corners of each triangle: x, y and pressure.
    pub triangles: Vec<[[f64; 3]; 3]>,
}

/// All meshes, in the order of the table.
pub fn meshes() -> Vec<Faces> {
    let table = Table::read("mesh_triangles.csv");
    let mut meshes: Vec<Faces> = Vec::new();
    for row in table.rows() {
        let name = row.text("mesh");
        if meshes.last().is_none_or(|last| last.name != name) {
            meshes.push(Faces {
                name: name.to_owned(),
                triangles: Vec::new(),
            });
        }
        let corner = |names: [&str; 3]| names.map(|name| row.number(name));
        let triangle = [["x1", "y1", "p1"], ["x2", "y2", "p2"], ["x3", "y3", "p3"]].map(corner);
        let triangles = &mut meshes.last_mut().expect("pushed").triangles;
        triangles.push(triangle);
    }
    meshes
}

impl Faces {
    /// The patch, in either precision.
    ///
    /// # Panics
    /// If it is refused.
    pub fn patch<R: Real>(&self) -> Mesh<R, Vec<Triangle<R>>> {
        let vertex = |[x, y, pressure]: [f64; 3]| Vertex {
            x: R::from_f64(x),
            y: R::from_f64(y),
            pressure: R::from_f64(pressure),
        };
        let vertices: Vec<Vertex<R>> = self
            .triangles
            .as_flattened()
            .iter()
            .copied()
            .map(vertex)
            .collect();
        let count = self.triangles.len();
        let indices: Vec<[usize; 3]> = (0..count).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        Mesh::with_vertices(&vertices, &indices, vec![Triangle::default(); count])
            .expect(&self.name)
    }
}
