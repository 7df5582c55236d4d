//! Hoppers and drums: walls beside those of the box, and the room that they leave.

use super::wall::{InitialWall, WallId};
use crate::grains::scene::{Container, GrainsScene, SideBoundary};
use nalgebra::Vector3;
use serde_json::Value;
use std::f64::consts::TAU;
use tribos_base::scene::words::Word;
use tribos_contacts::cd::Rectangle;

/// Planes around a drum. A polygon of 64 sides lies within 0.12 % of the radius from its circle, and each
/// side moves along itself, so that the drum turns without a bump.
const FACETS: usize = 64;
/// Ends of a side without edges.
const ENDLESS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Walls of the container.
pub(super) fn walls(scene: &GrainsScene) -> Vec<InitialWall> {
    match scene.container {
        Container::Box => Vec::new(),
        Container::Hopper => hopper(scene).into(),
        Container::Drum => drum(scene),
    }
}

/// Two plates from the sides down to the slot, and the lid between their edges.
fn hopper(scene: &GrainsScene) -> [InitialWall; 3] {
    let (sin, cos) = libm::sincos(scene.hopper_angle.to_radians());
    let plate = |side: f64| {
        let edge = 0.5 * (scene.width + side * scene.orifice_width);
        let slot = Vector3::new(edge, 0.0, scene.orifice_height);
        let inward = Vector3::new(-side * sin, 0.0, cos);
        // Up the plate, from the slot on. Without walls the two plates meet where the box repeats.
        let along = Vector3::new(side * cos, 0.0, sin);
        let low = along.dot(&slot);
        let high = match scene.boundary_x {
            SideBoundary::Walls => f64::INFINITY,
            SideBoundary::Periodic => low + 0.5 * (scene.width - scene.orifice_width) / cos,
        };
        InitialWall {
            face: WallId::Slope,
            inward,
            place: inward.dot(&slot),
            edges: Some(Rectangle {
                along,
                ends: [[low, high], ENDLESS],
            }),
        }
    };
    let ends = [-1.0, 1.0].map(|side| 0.5 * (scene.width + side * scene.orifice_width));
    let lid = InitialWall {
        face: WallId::Lid,
        inward: Vector3::z(),
        place: scene.orifice_height,
        edges: Some(Rectangle {
            along: Vector3::x(),
            ends: [ends, ENDLESS],
        }),
    };
    [plate(-1.0), plate(1.0), lid]
}

/// Facets around the axis of a drum.
fn drum(scene: &GrainsScene) -> Vec<InitialWall> {
    let radius = 0.5 * scene.width;
    let centre = Vector3::new(radius, 0.0, radius);
    let facet = |index: usize| {
        let (sin, cos) = libm::sincos(TAU * index as f64 / FACETS as f64);
        let out = Vector3::new(cos, 0.0, sin);
        InitialWall {
            // A rotation about y moves what lies at `out` along y × out.
            face: WallId::Facet(Vector3::new(sin, 0.0, -cos)),
            inward: -out,
            place: -out.dot(&centre) - radius,
            edges: None,
        }
    };
    (0..FACETS).map(facet).collect()
}

/// A plane part of a wall for pictures: a corner and the two sides from it.
pub type PlateOutline = [[f64; 3]; 3];

/// The plates of a hopper or the facets of a drum in a box with these corners; of a scene as JSON, as films keep it.
pub fn plates(scene: &Value, [low, high]: [[f64; 3]; 2]) -> Vec<PlateOutline> {
    let number = |key: &str| scene[key].as_f64().unwrap_or(f64::NAN);
    let (width, depth) = (number("width"), [0.0, high[1] - low[1], 0.0]);
    match scene["container"].as_str().and_then(Container::of_word) {
        Some(Container::Hopper) => {
            let (slot, bottom) = (number("orifice_width"), number("orifice_height"));
            let run = 0.5 * (width - slot);
            let rise = run * libm::tan(number("hopper_angle").to_radians());
            // What is higher than the box is not seen.
            let share = ((high[2] - bottom) / rise).clamp(0.0, 1.0);
            let plate = |side: f64| {
                let edge = [0.5 * (width + side * slot), low[1], bottom];
                [edge, [side * share * run, 0.0, share * rise], depth]
            };
            [-1.0, 1.0].map(plate).into()
        }
        Some(Container::Drum) => {
            let radius = 0.5 * width;
            // Corners of the polygon, whose sides touch the circle.
            let corner = |index: usize| {
                let half = 0.5 * TAU / FACETS as f64;
                let (sin, cos) = libm::sincos((2 * index) as f64 * half - half);
                [cos, sin].map(|part| radius + radius / libm::cos(half) * part)
            };
            let facet = |index: usize| {
                let ([x, z], [u, w]) = (corner(index), corner(index + 1));
                [[x, low[1], z], [u - x, 0.0, w - z], depth]
            };
            (0..FACETS).map(facet).collect()
        }
        _ => Vec::new(),
    }
}

/// Whether a grain may start at a place.
pub(super) fn has_room(scene: &GrainsScene, place: &Vector3<f64>, radius: f64) -> bool {
    let is_lower = scene.container == Container::Hopper && place.z < scene.orifice_height + radius;
    let fits = |part: &InitialWall| part.inward.dot(place) - part.place >= radius;
    !is_lower && walls(scene).iter().all(fits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plates_of_pictures_lie_in_the_walls() {
        let depth = Some(0.3);
        for container in [Container::Hopper, Container::Drum] {
            let scene = GrainsScene {
                container,
                depth,
                width: 1.0,
                orifice_width: 0.2,
                ..Default::default()
            };
            let outlines = plates(&scene.json(), [[0.0; 3], [1.0, 0.3, 2.0]]);
            let walls = walls(&scene);
            assert_eq!(
                outlines.len(),
                walls.iter().filter(|wall| wall.face != WallId::Lid).count()
            );
            for ([corner, first, second], wall) in outlines.into_iter().zip(walls) {
                let [corner, first, second] = [corner, first, second].map(Vector3::from);
                assert!((wall.inward.dot(&corner) - wall.place).abs() < 1e-12);
                assert!(wall.inward.dot(&first).abs() < 1e-12 && wall.inward.dot(&second) == 0.0);
                assert_eq!(second.y, 0.3);
            }
        }
    }
}
