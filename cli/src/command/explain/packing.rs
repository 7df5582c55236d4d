//! What powders and grains carry alike.

use super::{bytes, line};
use crate::command::digits::shown;
use tribos::powder::{Material, ModeSet, PackingCost};
use tribos::scene::FrictionCoupling;
use tribos::soft::{self, Stiffness};
use tribos_core::contact::Attraction;

/// Names of the modes with friction.
pub const MODES: [&str; 3] = ["sliding", "rolling", "torsion"];
/// Keys that switch them on.
pub const SWITCHES: [&str; 3] = ["mu", "mu_rolling", "mu_torsion"];

/// Modes, laws and rebounds of the contacts; `cohesion` is what the scene's units make of it.
pub fn contacts(
    material: &Material,
    cost: &PackingCost,
    cohesion: String,
    is_soft: bool,
) -> String {
    let carried = material.carried();
    let mut text = line("contacts", modes(carried.modes));
    text += &line(
        "",
        format!(
            "{} unknowns each (normal 1, sliding 2, rolling 2, torsion 1), {} bytes",
            cost.unknowns, cost.bytes
        ),
    );
    text += &idle(material);
    text += &line("thresholds", thresholds(material));
    text += &line("coupling", coupling(carried.coupling));
    text += &line("cohesion", cohesion);
    if material.restitution > 0.0 && !is_soft {
        text += &rebounds(material.restitution);
    }
    text
}

/// Spheres and their contacts, memory, and the time of an update.
pub fn costs(cost: &PackingCost, [spheres, place, dense]: [&str; 3], modes: ModeSet) -> String {
    let [low, high] = cost.contacts;
    let mut text = line(spheres, format!("{}{place}", cost.spheres));
    text += &line(
        "expected",
        format!(
            "{low} to {high} contacts when {dense}, {} to {} unknowns",
            low * cost.unknowns,
            high * cost.unknowns
        ),
    );
    text += &line("memory", format!("{} in the solver", bytes(cost.memory())));
    text + &update(cost, modes)
}

/// Time of an update, and what rolling and torsion add to it.
fn update(cost: &PackingCost, modes: ModeSet) -> String {
    const NANO: f64 = 1e9;
    const MILLION: f64 = 1e-6;
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
    line("update", rate)
}

/// Accelerated sweeps.
pub fn accelerated(tolerance: f64, most: usize) -> String {
    format!(
        "accelerated Gauss-Seidel to {tolerance:e}, at most {most} sweeps a step; where they miss it, \
         an interior point method if that is not much dearer"
    )
}

/// Modes that are carried, and those that are not.
fn modes(modes: ModeSet) -> String {
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
fn idle(material: &Material) -> String {
    let (has, mu) = (material.carried().modes.has(), coefficients(material));
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

/// Coefficients of the modes.
pub fn coefficients(material: &Material) -> [f64; 3] {
    [material.sliding, material.rolling, material.torsion]
}

/// How contacts rebound, and what that costs.
fn rebounds(restitution: f64) -> String {
    line(
        "restitution",
        format!(
            "e = {restitution}: a step takes its impacts first, in rounds, each a reflection and friction under it"
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
fn thresholds(material: &Material) -> String {
    let units = ["P", "P r_eff", "P r_eff"];
    let mu = coefficients(material);
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
fn coupling(coupling: FrictionCoupling) -> &'static str {
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
        soft::Stiffness::damping_ratio_of(told.restitution)
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
        shown(soft::Stiffness::restitution_of(damping))
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
