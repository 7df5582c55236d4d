//! Walls of a script: sides of the box, and regions for hoppers and drums.

use super::super::quantity::Quantity;
use super::Script;
use crate::grains::layout::Layout;
use crate::grains::scene::{Axis, Container, SideBoundary};
use crate::grains::wall::{AxisEnd, InitialWall, PLATE, WallId};
use tribos_base::record::{brief, number};
use tribos_contacts::cd::Wall;

/// Thickness of the plates of a hopper, in radii of the smallest grain; those of Tribos have none.
const THICKNESS: f64 = 1e-3;

impl Script<'_> {
    /// Length of the box along an axis, which a wall may change.
    pub(super) fn length(&self, axis: Axis) -> Quantity {
        let [low, high] =
            [AxisEnd::Low, AxisEnd::High].map(|end| self.wall(WallId::Side(axis, end)));
        match (low, high) {
            (Some(low), Some(high)) if self.is_driven(axis) => {
                Quantity::Formula(format!("f_walls[{high}][1]-f_walls[{low}][1]"))
            }
            _ => Quantity::Number(self.layout.lengths[axis.index()]),
        }
    }

    /// Whether a stress or a speed moves the wall at the far end of an axis.
    pub(super) fn is_driven(&self, axis: Axis) -> bool {
        self.scene.pressure(axis).is_some() || self.scene.velocity(axis).is_some()
    }

    /// Number of a wall in its fix, from 1.
    pub(super) fn wall(&self, face: WallId) -> Option<u32> {
        self.layout.wall(face).map(|wall| wall + 1)
    }

    /// Area across an axis at the start.
    pub(super) fn area_at_start(&self, axis: Axis) -> f64 {
        Layout::area(&self.layout.lengths.map(|length| [0.0, length]), axis)
    }

    /// A side of the box as a wall of the fix.
    fn side(&mut self, part: &InitialWall, wall: &Wall, (axis, end): (Axis, AxisEnd)) -> String {
        let (scene, clock) = (self.scene, self.clock);
        let name = format!("{axis}{}", if end == AxisEnd::Low { "lo" } else { "hi" });
        let place = if end == AxisEnd::Low {
            wall.place
        } else {
            -wall.place
        };
        let mut velocity = [Quantity::ZERO; 3];
        let load = match end {
            AxisEnd::Low => [None; 2],
            AxisEnd::High => [scene.pressure(axis), scene.velocity(axis)],
        };
        match load {
            [Some(_), _] => {
                let along = axis.index();
                velocity[along] = Quantity::Number(wall.plate.velocity[along]);
            }
            [None, Some(speed)] => velocity[axis.index()] = clock.value(speed),
            [None, None] => velocity = [Axis::X, Axis::Y, Axis::Z].map(|axis| self.swing(axis)),
        }
        if part.face == PLATE {
            velocity[0] = velocity[0].clone().plus(clock.value(&scene.lid_speed_x));
        } else if axis != Axis::Z {
            velocity[2] = velocity[2]
                .clone()
                .plus(clock.value(&scene.side_wall_speed_z));
        }
        let mut text = format!(" {name} {}", number(place + 0.0));
        if velocity.iter().any(|part| *part != Quantity::ZERO) {
            text += " velocity";
            for (along, part) in ["x", "y", "z"].into_iter().zip(&velocity) {
                text += &format!(" {}", self.word(&format!("{name}_{along}"), part));
            }
        }
        if let [Some(stress), _] = load {
            let across = [Axis::X, Axis::Y, Axis::Z]
                .into_iter()
                .filter(|other| *other != axis);
            let area = across.fold(Quantity::Number(1.0), |area, other| {
                area.times(self.length(other))
            });
            let push = clock.value(stress).times(area);
            let push = self.word(&format!("{name}_push"), &push);
            text += &format!(" piston {push} {}", number(1.0 / wall.plate.inv_mass));
        }
        text
    }

    /// All walls, by the fixes that have them.
    pub(super) fn wall_fixes(&mut self, law: &str) -> String {
        let (free, layout) = (self.free(), self.layout);
        let walls = std::mem::take(&mut self.walls);
        let mut sides = String::new();
        for (part, wall) in layout.parts.iter().zip(&walls) {
            if let WallId::Side(axis, end) = part.face {
                sides += &self.side(part, wall, (axis, end));
            }
        }
        self.walls = walls;
        let (regions, lid) = match self.scene.container {
            Container::Box => Default::default(),
            Container::Hopper => self.hopper(),
            Container::Drum => (self.drum(), String::new()),
        };
        let mut text: String = regions
            .iter()
            .map(|(name, shape)| format!("region {name} {shape} units box\n"))
            .collect();
        for (name, _) in &regions {
            sides += &format!(" region {name}");
        }
        if !sides.is_empty() {
            text += &format!("fix walls {free} wall/gran/tribos {law}{sides}\n");
        }
        if !lid.is_empty() {
            text +=
                &format!("{lid} units box\nfix gate {free} wall/gran/tribos {law} region gate\n");
        }
        text
    }

    /// Plates of a hopper from the slot up, and what closes the slot. Without walls the plates meet where the box repeats, and
    /// their images are there too.
    fn hopper(&mut self) -> (Vec<(String, String)>, String) {
        let scene = self.scene;
        let [smallest, largest] = self
            .start
            .radii
            .iter()
            .fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], radius| {
                [low.min(*radius), high.max(*radius)]
            });
        let room = 2.0 * largest;
        let depth = if scene.is_flat() {
            0.0
        } else {
            scene.box_depth()
        };
        let [y0, y1] = [-room, depth + room].map(number);
        let (sin, cos) = libm::sincos(scene.hopper_angle.to_radians());
        let (bottom, thickness) = (scene.orifice_height, THICKNESS * smallest);
        let is_closed = scene.boundary_x == SideBoundary::Walls;
        let run = 0.5 * (scene.width - scene.orifice_width) + if is_closed { room } else { 0.0 };
        let shifts = if is_closed { vec![0.0] } else { vec![0.0, 1.0] };
        let mut regions = Vec::new();
        for (name, side) in [("left", -1.0), ("right", 1.0)] {
            for shift in &shifts {
                let edge =
                    0.5 * (scene.width + side * scene.orifice_width) - side * shift * scene.width;
                let name = if *shift > 0.0 {
                    format!("{name}_image")
                } else {
                    name.into()
                };
                if sin == 0.0 {
                    let far = edge + side * run;
                    let [x0, x1] = [edge.min(far), edge.max(far)].map(number);
                    let [z0, z1] = [bottom - thickness, bottom].map(number);
                    let flat = format!("block {x0} {x1} {y0} {y1} {z0} {z1} side out");
                    regions.push((name, flat));
                    continue;
                }
                // The plate is as thin along x as makes its thickness across.
                let back = edge + side * thickness / sin;
                let [x0, x1] = [edge.min(back), edge.max(back)].map(number);
                let [z0, z1, lean] = [bottom, bottom + run * sin / cos, side * run].map(number);
                regions.push((
                    name,
                    format!("prism {x0} {x1} {y0} {y1} {z0} {z1} 0 {lean} 0 side out"),
                ));
            }
        }
        let [x0, x1] =
            [-1.0, 1.0].map(|side| number(0.5 * (scene.width + side * scene.orifice_width)));
        let [z0, z1] = [bottom - thickness, bottom].map(number);
        let lid = if scene.open_time > 0.0 {
            format!("region gate block {x0} {x1} {y0} {y1} {z0} {z1} side out")
        } else {
            String::new()
        };
        self.notes.push(format!(
            "The plates of the hopper are {} m thick; those of Tribos have no thickness.",
            brief(&thickness)
        ));
        (regions, lid)
    }

    /// The inside of a cylinder that turns.
    fn drum(&mut self) -> Vec<(String, String)> {
        let radius = number(0.5 * self.scene.width);
        let angle = self.clock.integral(&self.scene.drum_angular_velocity);
        let angle = self.word("drum_angle", &angle);
        self.notes.push(
            "The drum is a cylinder; that of Tribos has 64 plane sides, which lie up to 0.12 % of its radius outside of it.".into(),
        );
        let shape = format!(
            "cylinder y {radius} {radius} {radius} INF INF side in rotate {angle} {radius} 0 {radius} 0 1 0"
        );
        vec![("drum".into(), shape)]
    }
}
