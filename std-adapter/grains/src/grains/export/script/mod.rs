//! The input script of a scene of grains.

mod measures;
mod step;
mod walls;

use super::group;
use super::quantity::{Clock, Quantity};
use crate::grains::bound::Holder;
use crate::grains::grains_body::GrainsBody;
use crate::grains::layout::Layout;
use crate::grains::scene::{Axis, Container, EndBoundary, GrainsScene};
use crate::packing::export::head;
use crate::packing::{InitialSpheres, OptionalFeatures, PackingBody, Springs};
use std::f64::consts::TAU;
use tribos_base::record::{brief, number};
use tribos_contacts::cd::Wall;

/// Distance by which neighbour lists reach beyond a contact, in mean radii.
const SKIN: f64 = 0.3;
/// Steps of Tribos for which slow grains count as at rest.
const SLOW_STEPS: f64 = 100.0;

/// A script on its way.
pub(super) struct Script<'a> {
    scene: &'a GrainsScene,
    layout: &'a Layout,
    start: &'a InitialSpheres,
    springs: &'a Springs,
    /// Commands of the laws of pairs, and the law at walls.
    laws: [String; 2],
    walls: Vec<Wall>,
    clock: Clock,
    /// Kinds of the grains that something holds.
    held: Vec<(Holder, Vec<u8>)>,
    /// Definitions of variables.
    variables: String,
    pub notes: Vec<String>,
}

impl<'a> Script<'a> {
    pub fn new(
        (scene, springs): (&'a GrainsScene, &'a Springs),
        body: &'a GrainsBody,
        start: &'a InitialSpheres,
        laws: [String; 2],
    ) -> Self {
        let mut walls = body.bodies(start, &OptionalFeatures::default()).walls;
        // Pistons of a run that goes on are where they were, and move as they did.
        if let Some(frozen) = &start.frozen {
            let pistons = walls.iter_mut().zip(&frozen.walls);
            for (wall, (place, velocity)) in pistons.filter(|(wall, _)| wall.plate.inv_mass > 0.0) {
                (wall.place, wall.plate.velocity) = (*place, *velocity);
            }
        }
        let kinds = (1..=9).filter(|kind| start.kinds.materials.contains(kind));
        let mut held: Vec<(Holder, Vec<u8>)> = Vec::new();
        for kind in kinds {
            let Some(holder) = scene.holder(kind) else {
                continue;
            };
            match held.iter_mut().find(|(other, _)| *other == holder) {
                Some((_, kinds)) => kinds.push(kind),
                None => held.push((holder, vec![kind])),
            }
        }
        Self {
            scene,
            layout: &body.layout,
            start,
            springs,
            laws,
            walls,
            clock: Clock(scene.ramp_period),
            held,
            variables: String::new(),
            notes: Vec::new(),
        }
    }

    /// The whole script.
    pub fn text(&mut self) -> String {
        let dt = self.step();
        let lines = (self.scene.sample_every as f64 * self.scene.longest_step() / dt).round();
        let [pairs, walls] = std::mem::take(&mut self.laws);
        let weight = self.weight();
        let groups = self.groups();
        let walls = self.wall_fixes(&walls);
        let series = self.series(lines.max(1.0));
        let run = self.run(dt);
        let clock = self
            .clock
            .definition()
            .filter(|_| self.variables.contains("v_clock"));
        let [how, load] = head("grains");
        self.tell(dt);
        let notes: String = self
            .notes
            .iter()
            .map(|note| format!("# - {note}\n"))
            .collect();
        let skin = number(SKIN * self.scene.radius);
        format!(
            "# Grains in a box, written by `tribos export lammps`. The run writes series.txt, with the names and units of the series\n\
             # of Tribos, grains.restart and the grains at the end as end.dump.\n\
             {how}\n\
             #\n\
             # What differs from a run of Tribos:\n\
             {notes}\n\
             {load}\n\
             units si\natom_style sphere\ncomm_modify vel yes\nboundary {boundary}\n\
             read_data grains.data\n\n\
             # Springs, dashpots, thresholds of friction over P = F_n + F_coh and cohesion.\n\
             # LAMMPS does not know the style gran/tribos unless the plugin is loaded.\n\
             pair_style gran/tribos\n{pairs}\
             neighbor {skin} bin\nneigh_modify delay 0 every 1 check yes\ntimestep {dt}\n\n\
             {clock}{variables}{groups}{weight}\n\
             {walls}\n{series}\n{run}\
             write_dump all custom end.dump id type radius mass x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n\
             write_restart grains.restart\n",
            boundary = self.boundary(),
            dt = number(dt),
            clock = clock.unwrap_or_default(),
            variables = self.variables,
        )
    }

    /// Periodic axes; along the others the box holds all grains wherever they go.
    fn boundary(&self) -> String {
        let periods = self.layout.space.lengths();
        let flags = periods.map(|period| if period.is_some() { "p" } else { "m" });
        flags.join(" ")
    }

    /// The group of the grains that move freely.
    fn free(&self) -> &'static str {
        if self.held.is_empty() { "all" } else { "free" }
    }

    /// A quantity as a word of a command: a number, or a variable of this name.
    fn word(&mut self, name: &str, quantity: &Quantity) -> String {
        match quantity {
            Quantity::Number(value) => number(*value),
            Quantity::Formula(text) => {
                self.variables += &format!("variable {name} equal {text}\n");
                format!("v_{name}")
            }
        }
    }

    /// Gravity.
    fn weight(&mut self) -> String {
        let [strength, angle] =
            [&self.scene.gravity, &self.scene.gravity_angle].map(|ramp| self.clock.value(ramp));
        if strength == Quantity::ZERO {
            return String::new();
        }
        let (free, strength) = (self.free(), self.word("gravity", &strength));
        let direction = if angle == Quantity::ZERO {
            "vector 0 0 -1".into()
        } else {
            format!("chute {}", self.word("gravity_angle", &angle))
        };
        format!("fix weight {free} gravity {strength} {direction}\n")
    }

    /// Speed of the shaken box along an axis.
    fn swing(&self, axis: Axis) -> Quantity {
        let scene = self.scene;
        let rate = TAU * scene.shake_frequency;
        if axis != scene.shake_axis || scene.shake_amplitude * rate == 0.0 {
            return Quantity::ZERO;
        }
        let most = number(scene.shake_amplitude * rate);
        Quantity::Formula(format!("{most}*cos({}*time)", number(rate)))
    }

    /// Velocity of the grains that something holds.
    fn velocity(&self, holder: Holder) -> [Quantity; 3] {
        let (scene, clock) = (self.scene, self.clock);
        let swing = [Axis::X, Axis::Y, Axis::Z].map(|axis| self.swing(axis));
        match holder {
            Holder::Box => swing,
            Holder::Drive => [
                &scene.driven_velocity_x,
                &scene.driven_velocity_y,
                &scene.driven_velocity_z,
            ]
            .map(|ramp| clock.value(ramp)),
            Holder::Lid => {
                let slides = clock.value(&scene.lid_speed_x);
                match &scene.wall_velocity_z {
                    Some(rises) => [slides, Quantity::ZERO, clock.value(rises)],
                    None => {
                        let [x, y, z] = swing;
                        [x.plus(slides), y, z]
                    }
                }
            }
        }
    }

    /// Groups, and what moves the grains of each.
    fn groups(&mut self) -> String {
        if self.held.is_empty() {
            return "fix move all nve/sphere\n".into();
        }
        let held = std::mem::take(&mut self.held);
        let mut text = String::from(
            "# Grains that no force moves: the springs on them push the others alone.\n",
        );
        let names: Vec<&str> = held.iter().map(|(holder, _)| group(*holder)).collect();
        for ((_, kinds), name) in held.iter().zip(&names) {
            let kinds: Vec<String> = kinds.iter().map(u8::to_string).collect();
            text += &format!("group {name} type {}\n", kinds.join(" "));
        }
        text += &format!("group bound union {}\n", names.join(" "));
        text += "group free subtract all bound\nneigh_modify exclude group bound bound\nfix move free nve/sphere\n";
        for (holder, _) in &held {
            let name = group(*holder);
            let velocity = self.velocity(*holder);
            if velocity.iter().all(|part| *part == Quantity::ZERO) {
                continue;
            }
            if velocity
                .iter()
                .all(|part| matches!(part, Quantity::Number(_)))
            {
                let parts = velocity
                    .each_ref()
                    .map(|part| self.word("", part))
                    .join(" ");
                text += &format!("fix move_{name} {name} move linear {parts}\n");
                continue;
            }
            let mut parts = Vec::new();
            for (axis, part) in ["x", "y", "z"].into_iter().zip(velocity) {
                let formula = Quantity::Formula(part.term());
                parts.push(self.word(&format!("{name}_{axis}"), &formula));
            }
            text += &format!(
                "fix move_{name} {name} move variable NULL NULL NULL {}\n",
                parts.join(" ")
            );
        }
        // The forces on them are stored before they are taken away.
        text += "fix force_on bound store/force\nfix hold bound freeze\n";
        for name in names {
            text += &format!(
                "compute on_{name} {name} reduce sum f_force_on[1] f_force_on[2] f_force_on[3]\n"
            );
        }
        self.held = held;
        text
    }

    /// The run to its end.
    fn run(&mut self, dt: f64) -> String {
        let scene = self.scene;
        let most = scene.max_steps as f64 * scene.longest_step();
        let steps = |time: f64| (time / dt).ceil() as u64;
        let all = steps(scene.duration.min(most));
        let mut text = String::new();
        if let Some(rest) = scene.rest_speed {
            let every = (SLOW_STEPS * scene.longest_step() / dt).ceil();
            text += &format!(
                "fix rest all halt {every} v_speed < {} error continue\n",
                number(rest)
            );
            self.notes.push("The run ends when the grains are slower than `rest_speed` at one of its tests, not after 100 slow steps.".into());
        }
        if scene.container == Container::Hopper && scene.open_time > 0.0 {
            let shut = steps(scene.open_time).min(all);
            text += &format!(
                "# The slot opens.\nrun {shut}\nunfix gate\nrun {}\n",
                all - shut
            );
        } else {
            text += &format!("run {all}\n");
        }
        text
    }

    /// What holds for every scene.
    fn tell(&mut self, dt: f64) {
        self.notes.insert(
            0,
            format!("All steps are {} s long, stable at the speed of a fall through the box; Tribos follows speeds and forces.", brief(&dt)),
        );
        let frozen = self.start.frozen.as_ref();
        if frozen.is_some_and(|frozen| frozen.forces.iter().any(|forces| !forces.is_empty())) {
            self.notes.push(
                "The springs across the contacts of the start are new, without force.".into(),
            );
        }
        if self.walls.iter().any(|wall| wall.plate.inv_mass > 0.0) {
            self.notes
                .push("kinetic of series.txt is that of the grains, without pistons.".into());
        }
        if self.scene.is_flat() {
            self.notes.push(
                "Grains stay in the plane y = 0 because nothing pushes them out of it.".into(),
            );
        }
        if self.scene.boundary_z == EndBoundary::Floor && self.scene.container != Container::Drum {
            self.notes.push("series.txt has no height, solid fraction, stresses or slope: they follow from end.dump by `tribos measure`.".into());
        }
    }
}
