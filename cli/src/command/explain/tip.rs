//! What a tip carries.

use super::{duration, line};
use crate::command::digits::shown;
use crate::command::run::resource_check::{MemoryPermission, check};
use crate::failure::Failure;
use tribos::md::pair::Shift;
use tribos::md::system::Integrator;
use tribos::scene::{
    DriveKind, DrivenHold, StageSteps, ThermostatKind, TipScene, TorqueNormalisation,
};
use tribos::tip::{AtomRole, cost, size};

/// The whole account.
pub fn text(scene: &TipScene) -> Result<String, Failure> {
    // Its atoms are placed to be counted and timed.
    check(&size(scene), "atoms", MemoryPermission::Never)?;
    let cost = cost(scene)?;
    let atoms: usize = cost.atoms.iter().sum();
    let parts = AtomRole::ALL.iter().zip(cost.atoms);
    let parts: Vec<String> = parts
        .filter(|(_, count)| *count > 0)
        .map(|(part, count)| format!("{} {count}", part.name()))
        .collect();
    let mut text = line("atoms", format!("{atoms}: {}", parts.join(", ")));
    text += &line(
        "unknowns",
        format!("{} components of places move", scene.freedoms()),
    );
    text += &line(
        "pairs",
        format!(
            "{} within the cut-off of {} {}, {:.1} an atom",
            cost.pairs,
            shown(scene.reach()),
            units(scene)[0],
            2.0 * cost.pairs as f64 / atoms as f64
        ),
    );
    text += &line("potential", potential(scene));
    text += &line("thermostat", thermostat(scene));
    text += &line("driven", driven(scene));
    let StageSteps {
        before,
        driven: with,
        after,
    } = cost.steps;
    text += &line(
        "steps",
        format!(
            "{} of {} {}, {}: {before} before the drive, {with} with it, {after} after",
            cost.steps.total(),
            scene.time_step,
            units(scene)[1],
            integrator(scene.integrator)
        ),
    );
    const NANO: f64 = 1e9;
    const MILLION: f64 = 1e-6;
    let each = cost.atom_step_seconds;
    text += &line(
        "cost",
        format!(
            "{:.3e} atom-steps at {:.0} ns here, {:.1} million a second: {}",
            cost.atom_steps(),
            NANO * each,
            MILLION / each,
            duration(cost.seconds())
        ),
    );
    Ok(text)
}

/// A unit of Lennard-Jones atoms as the scene has it.
pub fn unit(scene: &TipScene, unit: &'static str) -> &'static str {
    match unit {
        _ if !scene.potential.is_metal() => unit,
        "sigma" => "A",
        "tau" => "ps",
        "eps" => "eV",
        "eps/sigma" => "eV/A",
        "eps/k_B" => "K",
        other => other,
    }
}

/// Units of lengths, times, energies and temperatures.
fn units(scene: &TipScene) -> [&'static str; 4] {
    ["sigma", "tau", "eps", "eps/k_B"].map(|of| unit(scene, of))
}

/// A metal, its crystals and its units.
fn metal(scene: &TipScene, [substrate, tip]: [&str; 2]) -> String {
    let [below, above] = scene.spacings().map(shown);
    format!(
        "{}: {substrate} with neighbours {below} A apart, tip of {tip} with {above} A; units A, ps, eV, K",
        scene.potential
    )
}

fn potential(scene: &TipScene) -> String {
    if let Some(elements) = scene.potential.elements() {
        return metal(scene, elements);
    }
    let shift = match scene.shift {
        Shift::None => "cut",
        Shift::Energy => "shifted to zero energy",
        Shift::Force => "shifted to zero force",
    };
    let species = if scene.adhesion_energy == 1.0 {
        "all atoms alike".to_owned()
    } else {
        format!("{} eps between tip and substrate", scene.adhesion_energy)
    };
    format!("Lennard-Jones, {shift} at the cut-off, {species}")
}

fn thermostat(scene: &TipScene) -> String {
    let groups = scene.thermostat_groups();
    let [_, tau, _, kelvin] = units(scene);
    let (relaxation, rate, heat) = (
        scene.thermostat_time,
        scene.langevin_rate,
        scene.temperature,
    );
    match scene.thermostat {
        ThermostatKind::NoseHoover => format!(
            "Nose-Hoover on {groups} groups, one unknown each, relaxation {relaxation} {tau}, T = {heat} {kelvin}"
        ),
        ThermostatKind::Langevin => {
            format!("Langevin on {groups} groups, rate {rate} / {tau}, T = {heat} {kelvin}")
        }
        ThermostatKind::None => "none".into(),
    }
}

fn driven(scene: &TipScene) -> String {
    let lift = match scene.driven_constraint {
        DrivenHold::Plane => "height of each atom fixed".to_owned(),
        DrivenHold::Level => {
            let [length, _, energy, _] = units(scene);
            format!(
                "one common height under {} {energy}/{length} an atom",
                -scene.lift()
            )
        }
    };
    if scene.drive == DriveKind::Slide {
        return slid(scene, &lift);
    }
    // The reading says what lambda is, and with it the force on an atom.
    let [mean, largest] = levers(scene);
    let length = match scene.reading {
        TorqueNormalisation::Angular => 1.0,
        TorqueNormalisation::Mean => mean,
        TorqueNormalisation::Largest => largest,
    };
    let reading = match scene.reading {
        TorqueNormalisation::Angular => "angular acceleration lambda".to_owned(),
        TorqueNormalisation::Mean => format!("lambda over the mean lever of {length:.4} sigma"),
        TorqueNormalisation::Largest => {
            format!("lambda over the largest lever of {length:.4} sigma")
        }
    };
    format!(
        "lambda {} eps/sigma^2, read as {reading}: up to {:.4e} eps/sigma on an atom; damping {} / tau, \
         {lift}",
        scene.lambda,
        scene.lambda * largest / length,
        scene.drive_damping_rate
    )
}

/// The support of a slid tip.
fn slid(scene: &TipScene, lift: &str) -> String {
    let [length, time, energy, _] = units(scene);
    let speed = scene.speed.unwrap_or(f64::NAN);
    let path = speed * scene.drive_time;
    let turns = scene.stroke.map_or("without turning".to_owned(), |stroke| {
        format!("in strokes of {stroke} {length}")
    });
    format!(
        "support at {speed} {length}/{time} over {} {length} {turns}, {} degrees from the rows, spring of {} \
         {energy}/{length}^2; damping {} / {time}, {lift}",
        shown(path),
        scene.drive_angle,
        scene.stiffness,
        scene.drive_damping_rate
    )
}

/// Mean and largest distance of the driven atoms from the axis.
fn levers(scene: &TipScene) -> [f64; 2] {
    let [x, y] = scene.shape().axis();
    let sites = scene.shape().sites();
    let driven = sites.iter().filter(|site| site.part == AtomRole::Driven);
    let levers: Vec<f64> = driven
        .map(|site| (site.place.x - x).hypot(site.place.y - y))
        .collect();
    let mean = levers.iter().sum::<f64>() / levers.len() as f64;
    [mean, levers.into_iter().fold(0.0, f64::max)]
}

fn integrator(integrator: Integrator) -> &'static str {
    match integrator {
        Integrator::LeapFrog => "leap-frog",
        Integrator::VelocityVerlet => "velocity Verlet",
    }
}
