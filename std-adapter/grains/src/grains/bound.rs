//! Grains that no force moves: fixed in the box, glued to the plate above, or driven as one body.

use super::layout;
use super::texts::GrainTypes;
use crate::grains::scene::GrainsScene;
use crate::packing::InitialSpheres;
use nalgebra::Vector3;
use serde_json::Value;
use tribos_base::scene::table::Table as _;

/// Types of the grains that a scene adds: on the floor, the intruder, on the plate above.
pub(super) const FLOOR: u8 = 7;
pub(super) const DRIVEN: u8 = 8;
pub(super) const LID: u8 = 9;

impl GrainTypes {
    pub(super) const FLOOR: Self = Self::one(FLOOR);
    pub(super) const DRIVEN: Self = Self::one(DRIVEN);
}

/// Types of the spheres of a run that no force moves; none unless its scene is of grains.
pub(crate) fn held_types(scene: &Value) -> GrainTypes {
    let of_key = |key: &str| scene[key].as_str()?.parse::<GrainTypes>().ok();
    let keys = ["fixed_kinds", "driven_kinds"];
    match keys.map(|key| of_key(key).unwrap_or_default()) {
        [fixed, driven] if scene["body"] == GrainsScene::BODY => {
            fixed.and(driven).and(GrainTypes::one(LID))
        }
        _ => GrainTypes::default(),
    }
}

/// What moves grains that no force moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Holder {
    /// The box, which may be shaken.
    Box,
    /// The velocity of the scene.
    Drive,
    /// The plate above.
    Lid,
}

/// A grain that no force moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundGrain {
    pub grain: usize,
    pub holder: Holder,
    /// Its place at the start.
    pub start: Vector3<f64>,
}

impl GrainsScene {
    /// What holds grains of a type; `None` if they move freely.
    pub(super) fn holder(&self, kind: u8) -> Option<Holder> {
        if self.fixed_kinds.has(kind) {
            Some(Holder::Box)
        } else if self.driven_kinds.has(kind) {
            Some(Holder::Drive)
        } else {
            (kind == LID).then_some(Holder::Lid)
        }
    }

    /// The grains of a start that no force moves.
    pub(super) fn bound(&self, start: &InitialSpheres) -> Vec<BoundGrain> {
        let kinds = start.kinds.materials.iter().enumerate();
        let bound = |(grain, kind): (usize, &u8)| {
            let (holder, start) = (self.holder(*kind)?, start.positions[grain]);
            Some(BoundGrain {
                grain,
                holder,
                start,
            })
        };
        kinds.filter_map(bound).collect()
    }

    /// Heights that glued grains take from the box, at the floor and below the plate.
    pub(super) fn carpets(&self) -> [f64; 2] {
        [self.rough_floor, self.rough_lid].map(|radius| radius.unwrap_or(0.0))
    }

    /// Place and radius of the intruder.
    pub(super) fn intruder(&self) -> Option<(Vector3<f64>, f64)> {
        let place = self.intruder_position?;
        Some((Vector3::from(place.0), self.intruder_radius?))
    }
}

/// Mean of the places at the start of the driven grains.
pub(super) fn centre(bound: &[BoundGrain]) -> Vector3<f64> {
    let driven = bound.iter().filter(|held| held.holder == Holder::Drive);
    let places: Vec<_> = driven.map(|held| held.start).collect();
    places.iter().sum::<Vector3<f64>>() / places.len().max(1) as f64
}

/// Adds the glued grains of a scene and its intruder to the free ones.
pub(super) fn add(scene: &GrainsScene, start: &mut InitialSpheres) {
    let height = layout::height(scene, start);
    if let Some(radius) = scene.rough_floor {
        carpet(scene, (radius, 0.0, FLOOR), start);
    }
    if let Some(radius) = scene.rough_lid {
        carpet(scene, (radius, height, LID), start);
    }
    if let Some((place, radius)) = scene.intruder() {
        glue(scene, (radius, place, DRIVEN), start);
    }
}

/// Glues grains in a square lattice on a plate, side by side or as far apart as fills its length.
fn carpet(scene: &GrainsScene, (radius, z, kind): (f64, f64, u8), start: &mut InitialSpheres) {
    let places = |length: f64| (length / (2.0 * radius)).floor().max(1.0);
    let nx = places(scene.width);
    let ny = if scene.is_flat() {
        1.0
    } else {
        places(scene.box_depth())
    };
    for j in 0..ny as usize {
        for i in 0..nx as usize {
            let x = scene.width * (i as f64 + 0.5) / nx;
            let y = scene.box_depth() * (j as f64 + 0.5) / ny;
            let y = if scene.is_flat() { 0.0 } else { y };
            glue(scene, (radius, Vector3::new(x, y, z), kind), start);
        }
    }
}

fn glue(
    scene: &GrainsScene,
    (radius, place, kind): (f64, Vector3<f64>, u8),
    start: &mut InitialSpheres,
) {
    start.positions.push(place);
    start.radii.push(radius);
    start.kinds.materials.push(kind);
    start.kinds.densities.push(scene.density);
}
