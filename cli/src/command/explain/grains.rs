//! What grains carry.

use super::packing::{Springs, accelerated, cohesion, contacts, costs, springs};
use super::{duration, line};
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::cd::solid;
use tribos::grains::{cost, size, stable_step};
use tribos::scene::{ContactMethod, GrainsScene};

/// The whole account.
pub fn text(scene: &GrainsScene) -> Result<String, Failure> {
    let (cost, material) = (cost(scene)?, scene.material());
    let pull = if material.cohesion > 0.0 {
        format!("{} N, {}", material.cohesion, cohesion(&material, "m"))
    } else {
        "none".into()
    };
    let longest = scene.longest_step();
    let is_soft = scene.method == ContactMethod::Soft;
    let mut text = String::new();
    for (name, list) in [("materials", &scene.materials), ("pairs", &scene.pairs)] {
        text += &list
            .iter()
            .map(|list| line(name, list.to_string()))
            .collect::<String>();
    }
    if scene.materials.is_some() {
        text += &line("", "what follows is of two grains of the first material");
    }
    text += &contacts(&material, &cost, pull, is_soft);
    text += &solver(scene, longest);
    text += &costs(&cost, ["grains", "", "dense"], material.carried().modes);
    text += &line(
        "steps",
        format!(
            "{:.0} of {longest:.3e} s at least; fast grains take shorter ones",
            scene.duration / longest
        ),
    );
    text += &line(
        "time",
        format!("in the order of {}", duration(size(scene).seconds)),
    );
    Ok(text)
}

/// Sweeps, or springs with the overlap under the weight of one grain.
fn solver(scene: &GrainsScene, longest: f64) -> String {
    let Some(step) = stable_step(scene) else {
        let (tolerance, sweeps) = (scene.tolerance, scene.max_iterations);
        return line("solver", accelerated(tolerance, sweeps));
    };
    let stiffness = scene.spring();
    let [_, gravity] = scene.gravity.range();
    let weight = gravity / solid(scene.radius, scene.density).inv_mass;
    let overlap = stiffness.overlap(weight, 0.5 * scene.radius);
    springs(&Springs {
        stiffness,
        units: ["N/m", "Pa"],
        damping: scene.damping_ratio,
        restitution: scene.restitution,
        overlap: ("the weight of a grain", format!("{} m", shown(overlap))),
        steps: [step, longest],
        per_collision: scene.steps_per_collision,
    })
}
