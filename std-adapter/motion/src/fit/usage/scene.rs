//! A fitted law as a scene: a body on a spring that is pulled, or a disk that slides to rest.

use super::shape::Shape;
use super::spec::dahl;
use super::{FittedLaw, Usage};
use tribos_core::law::{LocalLaw as _, LuGreParameters, RateStateParameters};
use tribos_friction::Law;

/// Load of scenes with a coefficient, in N; with forces it is 1 N, so that coefficients are forces.
const LOAD: f64 = 10.0;

/// The scene, or why there is none.
pub(super) fn scene(law: &FittedLaw<'_>, shape: &Shape) -> Usage {
    match shape {
        Shape::Arctan { mu, vt } => Usage::NotPossible(format!(
            "Scenes have no arctan; the nearest law with the same slope at rest is law = \"tanh:mu={mu:?},vt={:?}\".",
            std::f64::consts::FRAC_PI_2 * vt
        )),
        Shape::Sliders(elements) => Usage::NotPossible(sliders(elements)),
        Shape::ElastoPlastic { joint, .. } => Usage::NotPossible(format!(
            "Scenes have no bristles without creep; the nearest are those of LuGre, friction_law = \"lugre\", \
             with coulomb_force = {:?}, static_force = {:?} and the others of the fit, which creep under loads that swing.",
            joint.coulomb_force, joint.static_force
        )),
        Shape::Amontons { mu, adhesion } => {
            // Adhesion is part of the coefficient at the load of the scene.
            let spec = format!("coulomb:mu={:?}", mu + adhesion / LOAD);
            let note = format!("# Adhesion is in the coefficient at this load: mu + {adhesion:?} N/load.\n");
            Usage::Text(note + &spring(&spec, LOAD))
        }
        Shape::Power { alpha, .. } if *alpha < 0.0 => Usage::Text(disk(law, shape)),
        Shape::Dahl { fc, s0 } => Usage::Text(bristles(law, &dahl(*fc, *s0))),
        Shape::LuGre(joint) => Usage::Text(bristles(law, joint)),
        Shape::RateState { rock, by_slip } => Usage::Text(rate_state(rock, *by_slip)),
        Shape::SteadyRateState(rock) if rock.b >= rock.a => Usage::NotPossible(
            "Steady friction that falls with the speed has no level at rest: fit a record over time, which gives dc, or fix it (--fix dc=1e-5).".into(),
        ),
        _ => Usage::Text(spring(&shape.spec().unwrap_or_default(), load(law))),
    }
}

fn load(law: &FittedLaw<'_>) -> f64 {
    if law.is_per_load { LOAD } else { 1.0 }
}

/// Springs that slip: LuGre's bristles are near to a single one.
fn sliders(elements: &[[f64; 2]]) -> String {
    let nearest = match elements {
        [[stiffness, force]] => format!(
            "the nearest are bristles, friction_law = \"lugre\", with coulomb_force = static_force = {force:?}, \
             bristle_stiffness = {stiffness:?} and no damping: they yield gradually"
        ),
        _ => "in Rust, C and Python they are a few lines, and hysteresis of a whole patch is PointPresliding".into(),
    };
    format!("Scenes have no springs that slip; {nearest}.")
}

/// A body on a spring under a law of the speed. Friction at the speed of the pull is the force of the spring
/// after a tenth of its time.
fn spring(spec: &str, load: f64) -> String {
    let law = spec
        .parse::<Law>()
        .ok()
        .and_then(|law| law.build::<f64>().ok());
    let force = law.map_or(load, |law| load * law.friction(PULL_SPEED));
    format!(
        "# A body on a spring whose end is pulled, under the fitted law: tribos run FILE --out DIR\n\
         body       = \"spring\"\n\
         mass       = 1.0  # kg\n\
         stiffness  = {:.3e}  # N/m\n\
         pull_speed = {PULL_SPEED:?}  # m/s\n\
         pull_time  = {PULL_TIME:?}  # s\n\
         load       = {load:?}  # N\n\
         law        = \"{spec}\"\n",
        10.0 * force / (PULL_SPEED * PULL_TIME)
    )
}

/// A disk that slides and spins: friction that is infinite at rest never lets a spring's body go.
fn disk(law: &FittedLaw<'_>, shape: &Shape) -> String {
    format!(
        "# A disk that slides and spins to rest under the fitted law: tribos run FILE --out DIR\n\
         body          = \"disk\"\n\
         speed         = 1.0  # m/s\n\
         spin          = 5.0  # rad/s\n\
         radius        = 0.08  # m\n\
         mass          = {:?}  # kg\n\
         gravity       = 9.81  # m/s^2\n\
         inertia_ratio = 0.5\n\
         law           = \"{}\"\n",
        load(law) / GRAVITY,
        shape.spec().unwrap_or_default()
    )
}

/// Acceleration that presses the disk down, in m/s².
const GRAVITY: f64 = 9.81;

/// Bristles: forces, in N at the load of the scene.
fn bristles(law: &FittedLaw<'_>, joint: &LuGreParameters<f64>) -> String {
    let load = load(law);
    let keys = [
        ("coulomb_force", joint.coulomb_force, "N"),
        ("static_force", joint.static_force, "N"),
        ("bristle_stiffness", joint.stiffness, "N/m"),
        ("bristle_damping", joint.bristle_damping, "N s/m"),
        ("viscous_damping", joint.viscous_damping, "N s/m"),
    ];
    let keys = keys.map(|(key, x, unit)| format!("{key:<17} = {:?}  # {unit}\n", x * load));
    // The spring breaks away after a tenth of the pull.
    let force = joint.static_force * load;
    let (speed, time) = (joint.stribeck_speed, PULL_TIME);
    format!(
        "# A body on a spring whose end is pulled, under the fitted bristles: tribos run FILE --out DIR\n\
         body              = \"spring\"\n\
         friction_law      = \"lugre\"\n\
         mass              = 1.0  # kg\n\
         load              = {load:?}  # N\n\
         stiffness         = {:.3e}  # N/m\n\
         pull_speed        = {speed:?}  # m/s\n\
         pull_time         = {time:?}  # s\n\
         stribeck_speed    = {speed:?}  # m/s\n{}",
        10.0 * force / (speed * time),
        keys.concat()
    )
}

/// How long a spring is pulled, in s.
const PULL_TIME: f64 = 20.0;
/// Speed of the pull under laws of the speed, in m/s.
const PULL_SPEED: f64 = 0.05;

/// Rate and state, under a spring that is stiff enough to pull steadily.
fn rate_state(rock: &RateStateParameters<f64>, by_slip: bool) -> String {
    let evolution = if by_slip { "slip" } else { "ageing" };
    let keys = [
        ("mu_reference", rock.mu, ""),
        ("a", rock.a, ""),
        ("b", rock.b, ""),
        ("reference_speed", rock.reference_speed, "  # m/s"),
        ("slip_distance", rock.slip_distance, "  # m"),
        ("radiation_damping", rock.viscous, "  # s/m"),
    ];
    let keys = keys.map(|(key, x, unit)| format!("{key:<17} = {x:?}{unit}\n"));
    /// Distance of the pull, in memory lengths.
    const MEMORIES: f64 = 100.0;
    format!(
        "# A body on a spring whose end is pulled, under the fitted law: tribos run FILE --out DIR\n\
         # A spring below load (b - a)/slip_distance sticks and slips.\n\
         body              = \"spring\"\n\
         friction_law      = \"rate-state\"\n\
         mass              = 0.0  # kg: quasi-static\n\
         load              = {LOAD:?}  # N\n\
         stiffness         = {:.3e}  # N/m\n\
         pull_speed        = {:?}  # m/s\n\
         pull_time         = {:.3e}  # s\n\
         evolution         = \"{evolution}\"\n{}",
        LOAD * (rock.a + rock.b.abs()) / rock.slip_distance,
        rock.reference_speed,
        MEMORIES * rock.slip_distance / rock.reference_speed,
        keys.concat()
    )
}
