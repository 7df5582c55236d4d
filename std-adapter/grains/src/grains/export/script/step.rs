//! The step of a script, which does not change in a run.

use super::Script;
use crate::grains::Ramp;
use crate::grains::scene::{Axis, Container};
use crate::grains::wall::WallId;
use crate::packing::Kinds;
use crate::packing::export::{LARGEST_FORCE, mass, stable_step};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use tribos_contacts::cd::Wall;

impl Script<'_> {
    /// A step that is stable during the whole run, at speeds of a fall through the box.
    pub(super) fn step(&self) -> f64 {
        let (scene, start) = (self.scene, self.start);
        let free = start
            .kinds
            .materials
            .iter()
            .map(|kind| scene.holder(*kind).is_none());
        let free: Vec<bool> = free.collect();
        let of_free = |values: &[f64]| -> Vec<f64> {
            let values = values.iter().zip(&free);
            values
                .filter(|(_, is)| **is)
                .map(|(value, _)| *value)
                .collect()
        };
        let radii = of_free(&start.radii);
        let kinds = Kinds {
            materials: Vec::new(),
            densities: of_free(&start.kinds.densities),
        };
        let areas = [Axis::X, Axis::Y, Axis::Z].map(|axis| self.area_at_start(axis));
        let [_, gravity] = scene.gravity.range();
        let top = start
            .positions
            .iter()
            .map(|place| place.z)
            .fold(0.0, f64::max);
        let largest = radii.iter().copied().fold(0.0, f64::max);
        // The strongest contact bears the stress of the plates and the weight of the bed on its own area.
        let loads = [Axis::X, Axis::Y, Axis::Z].map(|axis| {
            let stress = scene.pressure(axis).map_or(0.0, |stress| stress.range()[1]);
            stress
                + if axis == Axis::Z {
                    gravity * mass(&radii, &kinds) / areas[2]
                } else {
                    0.0
                }
        });
        let stress = loads.into_iter().fold(0.0, f64::max);
        let force = LARGEST_FORCE * largest * largest * stress;
        let falling = (2.0 * gravity * top).sqrt();
        let speed = falling.max(self.fastest_drive());
        // A wall as fast as the fastest grain.
        let mut walls = vec![(Wall::fixed(Vector3::z(), 0.0), 0.0)];
        walls[0].0.plate.velocity = Vector3::z() * speed;
        for (part, wall) in self.layout.parts.iter().zip(&self.walls) {
            if let WallId::Side(axis, _) = part.face {
                walls.push((*wall, areas[axis.index()]));
            }
        }
        let laws = (self.springs, &scene.mixture());
        stable_step(laws, (&radii, &kinds), force, &walls).min(scene.longest_step())
    }

    /// Largest speed of anything that a load moves, and of the grains at the start.
    fn fastest_drive(&self) -> f64 {
        let scene = self.scene;
        let most = |ramp: &Ramp| ramp.range().map(f64::abs).into_iter().fold(0.0, f64::max);
        let optional = [
            &scene.wall_velocity_x,
            &scene.wall_velocity_y,
            &scene.wall_velocity_z,
        ];
        let walls = optional.into_iter().flatten().map(most);
        let others = [
            &scene.lid_speed_x,
            &scene.side_wall_speed_z,
            &scene.driven_velocity_x,
            &scene.driven_velocity_y,
            &scene.driven_velocity_z,
        ];
        let shake = TAU * scene.shake_frequency * scene.shake_amplitude;
        let drum = match scene.container {
            Container::Drum => 0.5 * scene.width * most(&scene.drum_angular_velocity),
            _ => 0.0,
        };
        let motions = self.start.frozen.iter().flat_map(|frozen| &frozen.motions);
        let grains = motions.map(|[velocity, _]| velocity.norm());
        let all = walls.chain(others.into_iter().map(most)).chain(grains);
        all.fold(shake.max(drum), f64::max)
    }
}
