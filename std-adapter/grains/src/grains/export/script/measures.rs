//! What a script measures: columns of the series, by their names in Tribos.

use super::super::group;
use super::Script;
use crate::grains::bound::Holder;
use crate::grains::scene::{Axis, Container};
use crate::grains::wall::{AxisEnd, WallId};
use tribos_base::record::number;

impl Script<'_> {
    /// A force on held grains along an axis, from 1; 0 without any.
    fn force_on(&self, holder: Holder, axis: u32) -> Option<String> {
        let mut held = self.held.iter();
        held.find(|(other, _)| *other == holder)
            .map(|_| format!("c_on_{}[{axis}]", group(holder)))
    }

    /// Columns of the series: names and formulas.
    fn measures(&self) -> Vec<(&'static str, String)> {
        let mut add = Vec::new();
        add.push(("time", "time".to_string()));
        add.push(("kinetic", "c_translation+c_rotation".into()));
        add.push(("speed", "sqrt(c_square)".into()));
        let side = |axis, end| self.wall(WallId::Side(axis, end));
        let sum = |parts: [Option<String>; 2]| {
            let parts: Vec<String> = parts.into_iter().flatten().collect();
            (!parts.is_empty()).then(|| parts.join(""))
        };
        let floor = side(Axis::Z, AxisEnd::Low).map(|wall| format!("-f_walls[{wall}][5]"));
        let fixed = self
            .force_on(Holder::Box, 3)
            .map(|force| format!("-{force}"));
        add.extend(sum([floor, fixed]).map(|force| ("floor_force", force)));
        let plate = side(Axis::Z, AxisEnd::High).map(|wall| format!("f_walls[{wall}][5]"));
        let glued = self
            .force_on(Holder::Lid, 3)
            .map(|force| format!("+{force}"));
        add.extend(sum([plate, glued]).map(|force| ("plate_force", force)));
        let names = [
            ("width", "side_force_x"),
            ("depth", "side_force_y"),
            ("height", ""),
        ];
        for (axis, (length, force)) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(names) {
            let Some(high) = side(axis, AxisEnd::High) else {
                continue;
            };
            if self.is_driven(axis) {
                add.push((length, self.length(axis).term()));
            }
            if axis != Axis::Z {
                add.push((force, format!("f_walls[{high}][{}]", axis.index() + 3)));
            }
        }
        let driven = ["driven_force_x", "driven_force_y", "driven_force_z"];
        for (axis, name) in (1..).zip(driven) {
            add.extend(
                self.force_on(Holder::Drive, axis)
                    .map(|force| (name, force)),
            );
        }
        if self.scene.container == Container::Hopper {
            add.push(("discharged", "c_below".into()));
        }
        add
    }

    /// What is measured on the way, every so many steps.
    pub(super) fn series(&self, every: f64) -> String {
        let free = self.free();
        let mut text = format!(
            "compute translation {free} ke\ncompute rotation {free} erotate/sphere\n\
             variable square atom vx*vx+vy*vy+vz*vz\ncompute square {free} reduce ave v_square\n"
        );
        if self.scene.container == Container::Hopper {
            let slot = number(self.scene.orifice_height);
            text += &format!(
                "variable below atom (z<{slot})*mass\ncompute below {free} reduce sum v_below\n"
            );
        }
        let mut names = Vec::new();
        for (name, formula) in &self.measures() {
            text += &format!("variable {name} equal {formula}\n");
            names.push(format!("v_{name}"));
        }
        let names = names.join(" ");
        text + &format!(
            "thermo {every}\nthermo_style custom step {names}\n\
             fix series all ave/time {every} 1 {every} {names} file series.txt format \" %.10g\"\n"
        )
    }
}
