//! The input script of a scene of grains.

use super::group;
use super::quantity::{Clock, Quantity};
use crate::grains::bound::Holder;
use crate::grains::grains_body::GrainsBody;
use crate::grains::layout::Layout;
use crate::grains::scene::{Axis, Container, EndBoundary, GrainsScene, SideBoundary};
use crate::grains::wall::{AxisEnd, InitialWall, PLATE, WallId};
use crate::packing::export::{LARGEST_FORCE, head, laws, mass, stable_step};
use crate::packing::{InitialSpheres, Kinds, OptionalFeatures, PackingBody, Springs};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use tribos_base::record::{brief, number};
use tribos_contacts::cd::Wall;

/// Distance by which neighbour lists reach beyond a contact, in mean radii.
const SKIN: f64 = 0.3;
/// Thickness of the plates of a hopper, in radii of the smallest grain; those of Tribos have none.
const THICKNESS: f64 = 1e-3;
/// Steps of Tribos for which slow grains count as at rest.
const SLOW_STEPS: f64 = 100.0;

/// A script on its way.
pub(super) struct Script<'a> {
    scene: &'a GrainsScene,
    layout: &'a Layout,
    start: &'a InitialSpheres,
    springs: &'a Springs,
    walls: Vec<Wall>,
    clock: Clock,
    /// Kinds of the grains that something holds.
    held: Vec<(Holder, Vec<u8>)>,
    /// Definitions of variables.
    variables: String,
    /// Columns of the series: names and formulas.
    columns: Vec<(&'static str, String)>,
    pub notes: Vec<String>,
}

impl<'a> Script<'a> {
    pub fn new(
        scene: &'a GrainsScene,
        body: &'a GrainsBody,
        start: &'a InitialSpheres,
        springs: &'a Springs,
    ) -> Self {
        let mut walls = body.bodies(start, &OptionalFeatures::default()).walls;
        // Pistons of a run that goes on stand where they were.
        if let Some(frozen) = &start.frozen {
            let pistons = walls.iter_mut().zip(&frozen.walls);
            for (wall, (place, _)) in pistons.filter(|(wall, _)| wall.plate.inv_mass > 0.0) {
                wall.place = *place;
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
            walls,
            clock: Clock(scene.ramp_period),
            held,
            variables: String::new(),
            columns: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The whole script.
    pub fn text(&mut self) -> String {
        let dt = self.step();
        let lines = (self.scene.sample_every as f64 * self.scene.longest_step() / dt).round();
        let [spheres, walls] = laws(&self.scene.material(), self.springs);
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
             pair_style gran/tribos\npair_coeff * * {spheres}\n\
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

    /// A step that is stable during the whole run, at speeds of a fall through the box.
    fn step(&self) -> f64 {
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
        let laws = (self.springs, &scene.material());
        stable_step(laws, (&radii, &kinds), force, &walls).min(scene.longest_step())
    }

    /// Largest speed of anything that a load moves, and of the grains at the start.
    fn fastest_drive(&self) -> f64 {
        let scene = self.scene;
        let most =
            |ramp: &super::super::Ramp| ramp.range().map(f64::abs).into_iter().fold(0.0, f64::max);
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

    /// Length of the box along an axis, which a wall may change.
    fn length(&self, axis: Axis) -> Quantity {
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
    fn is_driven(&self, axis: Axis) -> bool {
        self.scene.pressure(axis).is_some() || self.scene.velocity(axis).is_some()
    }

    /// Number of a wall in its fix, from 1.
    fn wall(&self, face: WallId) -> Option<u32> {
        self.layout.wall(face).map(|wall| wall + 1)
    }

    /// Area across an axis at the start.
    fn area_at_start(&self, axis: Axis) -> f64 {
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
            [Some(_), _] => {}
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
    fn wall_fixes(&mut self, law: &str) -> String {
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
                // The plate is as thin along x as makes its thickness across.
                let back = edge + side * thickness / sin;
                let [x0, x1] = [edge.min(back), edge.max(back)].map(number);
                let [z0, z1, lean] = [bottom, bottom + run * sin / cos, side * run].map(number);
                let name = if *shift > 0.0 {
                    format!("{name}_image")
                } else {
                    name.into()
                };
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

    /// A force on held grains along an axis, from 1; 0 without any.
    fn force_on(&self, holder: Holder, axis: u32) -> Option<String> {
        let mut held = self.held.iter();
        held.find(|(other, _)| *other == holder)
            .map(|_| format!("c_on_{}[{axis}]", group(holder)))
    }

    /// Columns of the series.
    fn measures(&mut self) {
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
        self.columns = add;
    }

    /// What is measured on the way, every so many steps.
    fn series(&mut self, every: f64) -> String {
        self.measures();
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
        for (name, formula) in &self.columns {
            text += &format!("variable {name} equal {formula}\n");
            names.push(format!("v_{name}"));
        }
        let names = names.join(" ");
        text + &format!(
            "thermo {every}\nthermo_style custom step {names}\n\
             fix series all ave/time {every} 1 {every} {names} file series.txt format \" %.10g\"\n"
        )
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
        let has_piston = self.walls.iter().any(|wall| wall.plate.inv_mass > 0.0);
        let moves = |(_, velocity): &(f64, Vector3<f64>)| velocity.norm() > 0.0;
        if has_piston && frozen.is_some_and(|frozen| frozen.walls.iter().any(moves)) {
            self.notes.push("Pistons start at rest.".into());
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
