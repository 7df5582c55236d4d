//! What keys of a scene of grains must fit together, and which of them are in force.

use super::{Axis, Container, EndBoundary, GrainsScene, SideBoundary};
use crate::grains::materials::rules as materials_rules;
use crate::grains::texts::Coordinates;
use crate::packing::COLUMNS_ALONE;
use crate::packing::method::{ContactMethod, NormalForce, soft_rules};
use std::ops::RangeInclusive;
use tribos_base::record::brief;
use tribos_base::scene::entries::Written;
use tribos_base::scene::reader::SceneDiagnostics;
use tribos_base::scene::words::Word;

/// Masses of a mean grain whose inertia and energies are numbers too.
const MASSES: RangeInclusive<f64> = 1e-90..=1e90;

/// Keys of the controls of the three axes: stress and speed.
const CONTROLS: [[&str; 2]; 3] = [
    ["wall_stress_x", "wall_velocity_x"],
    ["wall_stress_y", "wall_velocity_y"],
    ["wall_stress_z", "wall_velocity_z"],
];

/// Dimension, walls and loads must fit together.
pub(super) fn rules(scene: &GrainsScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.is_flat() && (scene.depth.is_some() || scene.boundary_y == SideBoundary::Walls) {
        let message = "a scene with dimension = 2 has no `depth` and no walls along y";
        judge.refuse(&["depth", "boundary_y", "dimension"], message);
    }
    if scene.size_distribution.is_some() && scene.radius_spread > 0.0 {
        let message = "give `radius_spread` or `size_distribution`, not both";
        judge.refuse(&["size_distribution", "radius_spread"], message);
    } else if let Err(error) = scene.radii() {
        judge.refuse(&["size_distribution"], error.to_string());
    }
    if scene.initial_state.is_some()
        && (scene.size_distribution.is_some() || scene.radius_spread > 0.0)
    {
        let message =
            "`initial_state` has its own radii; leave out `size_distribution` and `radius_spread`";
        judge.refuse(&["initial_state"], message);
    }
    if scene.columns.is_some() && scene.initial_state.is_none() {
        judge.refuse(&["columns"], COLUMNS_ALONE);
    }
    if scene.boundary_z == EndBoundary::Periodic && scene.height.is_none() {
        let message = "`height` is the period where boundary_z = \"periodic\"; give it";
        judge.refuse(&["height", "boundary_z"], message);
    }
    let sheared_by = match scene.inertial_number {
        Some(_) => "inertial_number",
        None => "shear_rate",
    };
    if scene.sheared().is_some() && scene.boundary_x == SideBoundary::Walls {
        let message = format!(
            "a shear needs boundary_x = \"periodic\"; leave `{sheared_by}` out or `boundary_x`"
        );
        judge.refuse(&[sheared_by, "boundary_x"], message);
    }
    let mass = scene.density
        * std::f64::consts::TAU
        * (scene.radius * scene.radius * scene.radius)
        * (2.0 / 3.0);
    if !MASSES.contains(&mass) {
        let message = format!(
            "`density` and `radius` make grains of {} kg, and masses must lie between {:e} and {:e}",
            brief(&mass),
            MASSES.start(),
            MASSES.end()
        );
        judge.refuse(&["density", "radius"], message);
    }
    if scene
        .average_from
        .is_some_and(|from| from >= scene.duration)
    {
        let message = format!(
            "`average_from` must be less than the `duration` of the run, {}",
            scene.duration
        );
        judge.refuse(&["average_from", "duration"], message);
    }
    gravity_rule(scene, judge);
    slow_rules(scene, judge);
    bound_rules(scene, judge);
    material_rules(scene, judge);
    materials_rules(scene, judge);
    if scene.method == ContactMethod::Soft {
        soft_rules(judge, scene.attraction, scene.least_restitution());
    }
    if scene.container != Container::Box
        && (scene.boundary_z != EndBoundary::Floor || scene.shake_amplitude > 0.0)
    {
        let message = "a hopper or a drum has boundary_z = \"floor\" and is not shaken";
        judge.refuse(&["container", "boundary_z", "shake_amplitude"], message);
    }
    if scene.container == Container::Hopper && scene.orifice_width >= scene.width {
        let message = format!(
            "`orifice_width` must be less than the `width` of the box, {}, not {}",
            scene.width, scene.orifice_width
        );
        judge.refuse(&["orifice_width", "width"], message);
    }
    if scene.container == Container::Drum && scene.boundary_x == SideBoundary::Walls {
        judge.refuse(
            &["boundary_x", "container"],
            "a drum has no walls along x; leave `boundary_x` out",
        );
    }
    for (keys, axis) in CONTROLS.iter().zip([Axis::X, Axis::Y, Axis::Z]) {
        let [pressure, velocity] = [scene.pressure(axis), scene.velocity(axis)];
        if pressure.is_some() && velocity.is_some() {
            let message = format!("give `{}` or `{}`, not both", keys[0], keys[1]);
            judge.refuse(keys, message);
        }
        let given = match (pressure, velocity) {
            (Some(_), _) => keys[0],
            (None, Some(_)) => keys[1],
            (None, None) => continue,
        };
        if scene.is_periodic(axis) && scene.has_bound() {
            let message = format!(
                "`{given}` deforms the box, which then has no glued or driven grains and no `mesh`"
            );
            judge.refuse(&[given], message);
        }
        if let Some(reason) = scene.no_control(axis) {
            judge.refuse(&[given], format!("`{given}` {reason}"));
        }
    }
}

/// An inertial number needs a constant stress, and stands alone.
fn slow_rules(scene: &GrainsScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.inertial_number.is_none() {
        return;
    }
    for (key, given) in [
        ("shear_rate", scene.shear_rate.is_some()),
        ("wall_velocity_z", scene.wall_velocity_z.is_some()),
    ] {
        if given {
            let message = format!("give `inertial_number` or `{key}`, not both");
            judge.refuse(&["inertial_number", key], message);
        }
    }
    let rate = scene.sheared().or(scene.compression());
    if rate.is_none_or(|rate| rate <= 0.0) {
        let message = "`inertial_number` needs a constant stress above 0: `wall_stress_z` for a shear, or `wall_stress_x` alone for \
                       a compression along z";
        judge.refuse(
            &["inertial_number", "wall_stress_z", "wall_stress_x"],
            message,
        );
    }
}

/// Refuses gravity where nothing bears the grains: they would fall for ever.
fn gravity_rule(scene: &GrainsScene, judge: &mut SceneDiagnostics<'_>) {
    let walls = [scene.boundary_x, scene.boundary_y].contains(&SideBoundary::Walls)
        && scene.sheared().is_none();
    let [_, most] = scene.gravity.range();
    if scene.boundary_z == EndBoundary::Periodic && !walls && scene.mesh.is_none() && most > 0.0 {
        let message = format!(
            "nothing bears the grains against a `gravity` of up to {most} where boundary_z = \"periodic\" without walls, \
             or with `shear_rate`; set gravity = 0"
        );
        judge.refuse(&["gravity", "boundary_z"], message);
    }
}

/// Cohesion and stiffness are given in one way.
fn material_rules(scene: &GrainsScene, judge: &mut SceneDiagnostics<'_>) {
    if scene.surface_energy.is_some() && judge.is_given("cohesion") {
        let message = "give `cohesion` or `surface_energy`, from which it follows, not both";
        judge.refuse(&["cohesion", "surface_energy"], message);
    }
    if scene.young_modulus.is_none() {
        return;
    }
    if judge.is_given("stiffness") {
        let message = "give `stiffness` or `young_modulus`, not both";
        judge.refuse(&["stiffness", "young_modulus"], message);
    }
    if scene.normal_law == NormalForce::Linear && judge.is_given("normal_law") {
        let message = "`young_modulus` is of Hertz's law: leave out `normal_law` = \"linear\", or give `stiffness`";
        judge.refuse(&["normal_law", "young_modulus"], message);
    }
}

/// Glued grains, the intruder and the mesh must fit the box.
fn bound_rules(scene: &GrainsScene, judge: &mut SceneDiagnostics<'_>) {
    let is_open = scene.boundary_z == EndBoundary::Periodic || scene.container == Container::Drum;
    if scene.rough_floor.is_some() && is_open {
        let message =
            "`rough_floor` needs a floor: boundary_z = \"floor\" or \"walls\", and no drum";
        judge.refuse(&["rough_floor", "boundary_z", "container"], message);
    }
    if scene.rough_lid.is_some() && scene.initial_state.is_some() {
        let message = "`initial_state` has its own glued grains, of type 9; leave out `rough_lid`";
        judge.refuse(&["rough_lid", "initial_state"], message);
    }
    if scene.rough_lid.is_some() && scene.wall_stress_z.is_some() {
        let message = "grains glued to the plate move with a speed; give `wall_velocity_z` in place of `wall_stress_z`";
        judge.refuse(&["rough_lid", "wall_stress_z"], message);
    }
    let slides = scene.lid_speed_x.constant() != Some(0.0);
    if scene.rough_lid.is_some() && slides && scene.boundary_x == SideBoundary::Walls {
        let message =
            "glued grains would leave through the walls along x; set boundary_x = \"periodic\"";
        judge.refuse(&["rough_lid", "lid_speed_x", "boundary_x"], message);
    }
    if scene.intruder_radius.is_some() != scene.intruder_position.is_some() {
        let message = "give `intruder_radius` and `intruder_position`, or neither";
        judge.refuse(&["intruder_radius", "intruder_position"], message);
    }
    if scene.sheared().is_some() && scene.intruder_radius.is_some() {
        judge.refuse(
            &["shear_rate", "intruder_radius"],
            "a sheared box has no intruder",
        );
    }
    let off = |place: Coordinates| place.0[1] != 0.0;
    if scene.is_flat() && (scene.mesh.is_some() || scene.intruder_position.is_some_and(off)) {
        let message = "with dimension = 2 there is no `mesh`, and an intruder lies at y = 0";
        judge.refuse(&["dimension", "mesh", "intruder_position"], message);
    }
    let turns = scene.driven_angular_velocity.constant() != Some(0.0);
    if scene.is_flat() && turns && (scene.driven_axis.0[0], scene.driven_axis.0[2]) != (0.0, 0.0) {
        let message =
            "with dimension = 2 driven grains turn about y: set driven_axis = \"0, 1, 0\"";
        judge.refuse(&["dimension", "driven_axis"], message);
    }
    for (key, axis) in [
        ("driven_axis", scene.driven_axis),
        ("mesh_axis", scene.mesh_axis),
    ] {
        if axis.0 == [0.0; 3] {
            let message = format!("`{key}` must have a direction, such as \"0, 0, 1\"");
            judge.refuse(&[key], message);
        }
    }
}

/// A start stands in place of the keys of random grains, a distribution in place of the spread, restitution in
/// place of damping, surface energy in place of cohesion, Young's modulus in place of the stiffness.
pub(super) fn in_force(
    scene: &GrainsScene,
    key: &str,
    written: Option<Written>,
) -> Option<Written> {
    let starts = scene.initial_state.is_some();
    if key == "normal_law" && scene.has_young_modulus() {
        return Some(Written::Text(NormalForce::Hertz.word().into()));
    }
    written.filter(|_| match key {
        "count" | "initial_spacing" => !starts,
        // A file may lack materials, which are drawn then.
        "seed" => !starts || scene.mixture().is_drawn(),
        "radius_spread" => scene.size_distribution.is_none() && !starts,
        "damping_ratio" => scene.least_restitution() == 0.0,
        "second_fraction" | "second_radius" => scene.materials.is_none(),
        "cohesion" => scene.surface_energy.is_none(),
        "adhesion" => scene.surface_energy.is_some(),
        "stiffness" => !scene.has_young_modulus(),
        "poisson_ratio" => scene.has_young_modulus(),
        _ => true,
    })
}
