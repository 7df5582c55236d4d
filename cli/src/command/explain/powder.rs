//! What a powder carries.

use super::line;
use super::packing::{Springs, accelerated, cohesion, contacts, costs, springs};
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::cd::SolverMethod;
use tribos::powder::{PackingCost, cost, stable_step};
use tribos::scene::{ContactMethod, PowderScene};

/// The whole account.
pub fn text(scene: &PowderScene) -> Result<String, Failure> {
    let (cost, material) = (cost(scene)?, scene.material());
    let is_soft = scene.method == ContactMethod::Soft;
    let words = ["spheres", " in the deposit", "compacted"];
    let text = contacts(&material, &cost, cohesion(&material, "R"), is_soft) + &solver(scene);
    let text = text + &costs(&cost, words, material.carried().modes);
    Ok(text + &speed(&cost, is_soft))
}

fn solver(scene: &PowderScene) -> String {
    if let Some(step) = stable_step(scene) {
        let stiffness = scene.spring();
        return springs(&Springs {
            stiffness,
            units: ["F_coh/R", "F_coh/R^2"],
            damping: scene.damping_ratio,
            restitution: scene.restitution,
            overlap: (
                "a force of F_coh",
                format!("{} R", shown(stiffness.overlap(1.0, 0.5))),
            ),
            steps: [step, scene.max_time_step],
            per_collision: scene.steps_per_collision,
        });
    }
    let solver = scene.contact_solver();
    let most = solver.most_sweeps;
    let text = match solver.method {
        SolverMethod::Accelerated { tolerance } => accelerated(tolerance, most),
        SolverMethod::GaussSeidel { .. } => format!("Gauss-Seidel, at most {most} sweeps a step"),
    };
    line("solver", text)
}

/// Time of a step of springs or of a sweep.
fn speed(cost: &PackingCost, is_soft: bool) -> String {
    const MILLI: f64 = 1e3;
    let update = cost.update_seconds;
    let [low, high] = cost
        .contacts
        .map(|contacts| MILLI * contacts as f64 * update);
    let text = line(
        if is_soft { "step" } else { "sweep" },
        format!("{low:.3} to {high:.3} ms over all contacts when compacted"),
    );
    if is_soft {
        return text;
    }
    text + &line(
        "",
        "steps and sweeps follow from the motion: `--out DIR` of a run shows them",
    )
}
