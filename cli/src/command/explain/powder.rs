//! What a powder carries.

use super::{bytes, line};
use crate::command::digits::shown;
use crate::failure::Failure;
use tribos::cd::SolverMethod;
use tribos::powder::{Material, ModeSet, PowderCost, cost, stable_step};
use tribos::scene::{ContactMethod, FrictionCoupling, PowderScene};
use tribos::soft::{self, Stiffness};
use tribos_core::contact::Attraction;

/// Names of the modes with friction.
pub const MODES: [&str; 3] = ["sliding", "rolling", "torsion"];
/// Keys that switch them on.
pub const SWITCHES: [&str; 3] = ["mu", "mu_rolling", "mu_torsion"];

/// Coefficients of the modes.
pub fn coefficients(scene: &PowderScene) -> [f64; 3] {
    [scene.mu, scene.mu_rolling, scene.mu_torsion]
}

/// The whole account.
pub fn text(scene: &PowderScene) -> Result<String, Failure> {
    let cost = cost(scene)?;
    let carried = scene.material().carried();
    let mut text = line("contacts", modes(carried.modes));
    text += &line(
        "",
        format!(
            "{} unknowns each (normal 1, sliding 2, rolling 2, torsion 1), {} bytes",
            cost.unknowns, cost.bytes
        ),
    );
    text += &idle(scene);
    text += &line("thresholds", thresholds(&scene.material()));
    text += &line("coupling", coupling(carried.coupling));
    text += &line("cohesion", cohesion(&scene.material(), "R"));
    text += &restitution(scene);
    text += &solver(scene);
    text += &size(&cost);
    text += &speed(scene, &cost, carried.modes);
    Ok(text)
}

/// Modes that are carried, and those that are not.
pub fn modes(modes: ModeSet) -> String {
    let names = MODES.iter().zip(modes.has());
    let carried: Vec<&str> = names
        .filter(|(_, has)| *has)
        .map(|(name, _)| *name)
        .collect();
    let absent: Vec<&str> = MODES
        .iter()
        .zip(modes.has())
        .filter(|(_, has)| !has)
        .map(|(name, _)| *name)
        .collect();
    let mut text = ["normal"]
        .into_iter()
        .chain(carried)
        .collect::<Vec<_>>()
        .join(", ");
    if !absent.is_empty() {
        text += &format!(
            "; {} not resisted, neither stored nor computed",
            absent.join(", ")
        );
    }
    text
}

/// Modes that are carried with a coefficient of zero.
fn idle(scene: &PowderScene) -> String {
    let (has, mu) = (scene.material().carried().modes.has(), coefficients(scene));
    let idle: Vec<&str> = MODES
        .iter()
        .enumerate()
        .filter(|(mode, _)| has.get(*mode) == Some(&true) && mu.get(*mode) == Some(&0.0))
        .map(|(_, name)| *name)
        .collect();
    if idle.is_empty() {
        return String::new();
    }
    line(
        "",
        format!(
            "{} computed with a coefficient of 0: no type of contact leaves it out",
            idle.join(" and ")
        ),
    )
}

/// How contacts rebound, and what that costs.
fn restitution(scene: &PowderScene) -> String {
    if scene.restitution == 0.0 || scene.method == ContactMethod::Soft {
        return String::new();
    }
    line(
        "restitution",
        format!(
            "e = {}: a step takes its impacts first, in rounds, each a reflection and friction under it",
            scene.restitution
        ),
    ) + &line(
        "",
        "at most 100 rounds a step, then stopped without rebound, and 1000 sweeps a reflection or its \
         friction; the run's end reports steps that use them up",
    ) + &line(
        "",
        "slower approaches than the loads of a step make do not rebound",
    )
}

/// Largest force and torques of a contact.
pub fn thresholds(material: &Material) -> String {
    let units = ["P", "P r_eff", "P r_eff"];
    let mu = [material.sliding, material.rolling, material.torsion];
    let has = material.carried().modes.has();
    let limits: Vec<String> = (0..MODES.len())
        .filter(|&mode| has[mode])
        .map(|mode| format!("{} {} {}", MODES[mode], mu[mode], units[mode]))
        .collect();
    if limits.is_empty() {
        return "none".into();
    }
    format!("{}, with P = F_n + F_coh", limits.join(", "))
}

/// How thresholds depend on each other.
pub fn coupling(coupling: FrictionCoupling) -> &'static str {
    match coupling {
        FrictionCoupling::Independent => "independent: each mode has its own threshold",
        FrictionCoupling::Ellipsoid => {
            "ellipsoid: sliding and torsion share a threshold, by an approximation"
        }
        FrictionCoupling::Exact => {
            "exact: sliding and torsion share the limit surface of a round contact"
        }
    }
}

/// How cohesion acts at a gap, whose unit is named.
pub fn cohesion(material: &Material, unit: &str) -> String {
    let how = match material.attraction {
        Attraction::Pull => "a constant pull",
        Attraction::Resistance => "a resistance to opening",
    };
    format!("{how} up to a gap of {} {unit}", material.cohesion_range)
}

/// Springs of soft contacts, to be told.
#[derive(Clone, Debug)]
pub struct Springs<'a> {
    pub stiffness: Stiffness,
    /// Unit of a spring, and of Hertz's modulus.
    pub units: [&'a str; 2],
    pub damping: f64,
    pub restitution: f64,
    /// A usual force, and the overlap under it.
    pub overlap: (&'a str, String),
    /// Lengths of a stable step and of the longest step.
    pub steps: [f64; 2],
    /// Least number of steps of a collision.
    pub per_collision: f64,
}

/// Springs, dashpots and their step.
pub fn springs(told: &Springs<'_>) -> String {
    let damping = if told.restitution > 0.0 {
        soft::damping_ratio_of(told.restitution)
    } else {
        told.damping
    };
    let [spring, modulus] = told.units;
    let law = match told.stiffness {
        Stiffness::Linear(given) => format!("linear springs of {given} {spring}"),
        Stiffness::Hertz(given) => format!("Hertz contacts with a modulus of {given} {modulus}"),
    };
    let method = format!(
        "none: {law}, damping ratio {}, restitution {}",
        shown(damping),
        shown(soft::restitution_of(damping))
    );
    let ((force, overlap), [stable, longest]) = (&told.overlap, told.steps);
    let steps = format!(
        "{force} overlaps by {overlap}; steps of {}, {} a collision or more, {:.0} in a longest step",
        shown(stable),
        told.per_collision,
        (longest / stable).ceil()
    );
    line("solver", method) + &line("", steps)
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
        SolverMethod::Accelerated { tolerance } => {
            format!(
                "accelerated Gauss-Seidel to {tolerance:e}, at most {most} sweeps a step; where they miss it, \
                 an interior point method if that is not much dearer"
            )
        }
        SolverMethod::GaussSeidel { .. } => format!("Gauss-Seidel, at most {most} sweeps a step"),
    };
    line("solver", text)
}

fn size(cost: &PowderCost) -> String {
    let [low, high] = cost.contacts;
    let unknowns = cost.contacts.map(|contacts| contacts * cost.unknowns);
    let mut text = line("spheres", format!("{} in the deposit", cost.spheres));
    text += &line(
        "expected",
        format!(
            "{low} to {high} contacts when compacted, {} to {} unknowns",
            unknowns[0], unknowns[1]
        ),
    );
    text + &line("memory", format!("{} in the solver", bytes(cost.memory())))
}

fn speed(scene: &PowderScene, cost: &PowderCost, modes: ModeSet) -> String {
    const NANO: f64 = 1e9;
    const MILLION: f64 = 1e-6;
    const MILLI: f64 = 1e3;
    let update = cost.update_seconds;
    let mut rate = format!(
        "{:.0} ns a contact here, {:.1} million a second",
        NANO * update,
        MILLION / update
    );
    if modes != ModeSet::Sliding {
        let ratio = update / cost.sliding_seconds;
        rate += &format!(", {ratio:.2} times what sliding alone takes");
    }
    let mut text = line("update", rate);
    let [low, high] = cost
        .contacts
        .map(|contacts| MILLI * contacts as f64 * update);
    let soft = scene.method == ContactMethod::Soft;
    text += &line(
        if soft { "step" } else { "sweep" },
        format!("{low:.3} to {high:.3} ms over all contacts when compacted"),
    );
    if soft {
        return text;
    }
    text + &line(
        "",
        "steps and sweeps follow from the motion: `--out DIR` of a run shows them",
    )
}
