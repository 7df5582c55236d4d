//! The walls of triangles of a scene.

use crate::grains::scene::GrainsScene;
use crate::packing::PackingRunError;
use nalgebra::Vector3;
use std::sync::Arc;
use tribos_base::exchange::stl;
use tribos_contacts::cd::{Mesh, MovingMesh};

/// The mesh of a scene in its motion, if there is one.
pub(super) fn of(scene: &GrainsScene) -> Result<Option<MovingMesh>, PackingRunError> {
    let Some(path) = &scene.mesh else {
        return Ok(None);
    };
    let refused = |reason: String| PackingRunError::Mesh {
        file: path.display().to_string(),
        reason,
    };
    let bytes = std::fs::read(path).map_err(|cause| refused(cause.to_string()))?;
    let triangles = stl::triangles(&bytes).map_err(|cause| refused(cause.to_string()))?;
    let corner = |corner: [f64; 3]| Vector3::from(corner) * scene.mesh_scale;
    let triangles = triangles
        .into_iter()
        .map(|corners| corners.map(corner))
        .collect();
    let mesh = Mesh::new(triangles).map_err(|cause| refused(cause.to_string()))?;
    let vector = |key: super::Coordinates| Vector3::from(key.0);
    Ok(Some(MovingMesh {
        mesh: Arc::new(mesh),
        velocity: vector(scene.mesh_velocity),
        axis: scene.mesh_axis.direction(),
        rate: scene.mesh_angular_velocity,
        centre: vector(scene.mesh_centre),
    }))
}
