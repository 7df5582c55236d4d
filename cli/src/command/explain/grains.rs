//! What grains carry.

use super::powder::{Springs, cohesion, coupling, modes, springs, thresholds};
use super::{bytes, duration, line};
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::cd::solid;
use tribos::grains::{GrainsCost, cost, size, stable_step};
use tribos::powder::ModeSet;
use tribos::scene::GrainsScene;

/// The whole account.
pub fn text(scene: &GrainsScene) -> Result<String, Failure> {
    let cost = cost(scene)?;
    let material = scene.material();
    let carried = material.carried();
    let mut text = line("contacts", modes(carried.modes));
    text += &line(
        "",
        format!(
            "{} unknowns each (normal 1, sliding 2, rolling 2, torsion 1), {} bytes",
            cost.unknowns, cost.bytes
        ),
    );
    text += &line("thresholds", thresholds(&material));
    text += &line("coupling", coupling(carried.coupling));
    text += &line(
        "cohesion",
        if material.cohesion > 0.0 {
            format!("{} N, {}", material.cohesion, cohesion(&material, "m"))
        } else {
            "none".into()
        },
    );
    text += &solver(scene, cost.longest_step);
    text += &line("grains", cost.grains.to_string());
    let [low, high] = cost.contacts;
    text += &line(
        "expected",
        format!(
            "{low} to {high} contacts when dense, {} to {} unknowns",
            low * cost.unknowns,
            high * cost.unknowns
        ),
    );
    text += &line("memory", format!("{} in the solver", bytes(cost.memory())));
    text += &update(&cost, carried.modes);
    text += &line(
        "steps",
        format!(
            "{:.0} of {:.3e} s at least; fast grains take shorter ones",
            cost.steps, cost.longest_step
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
        let how = format!(
            "accelerated Gauss-Seidel to {tolerance:e}, at most {sweeps} sweeps a step; where they miss it, \
             an interior point method if that is not much dearer"
        );
        return line("solver", how);
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

/// Time of an update, and what rolling and torsion add to it.
fn update(cost: &GrainsCost, modes: ModeSet) -> String {
    const NANO: f64 = 1e9;
    let mut rate = format!("{:.0} ns a contact here", NANO * cost.update_seconds);
    if modes != ModeSet::Sliding {
        let ratio = cost.update_seconds / cost.sliding_seconds;
        rate += &format!(", {ratio:.2} times what sliding alone takes");
    }
    line("update", rate)
}
