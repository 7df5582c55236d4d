//! A fitted law as lines of Python.

use super::shape::Shape;
use super::spec::{dahl, joint_fields, rock_fields};
use super::{FittedLaw, SHOWN_SPEEDS, SHOWN_STEP, SHOWN_VELOCITIES, number};
use tribos_core::law::LuGreParameters;

/// All lines.
pub(super) fn lines(law: &FittedLaw<'_>, shape: &Shape) -> String {
    let unit = law.unit();
    match shape {
        Shape::Arctan { mu, vt } => function(
            &format!("{mu:?} * 2 / np.pi * np.arctan(speed / {vt:?})"),
            unit,
        ),
        Shape::Amontons { mu, adhesion } => amontons(*mu, *adhesion),
        Shape::Sliders(elements) => sliders(elements),
        Shape::Dahl { fc, s0 } => bristles(&dahl(*fc, *s0)),
        Shape::ElastoPlastic { joint, zba } => elasto_plastic(joint, *zba),
        Shape::LuGre(joint) => bristles(joint),
        Shape::RateState { rock, by_slip } => {
            let evolution = if *by_slip { "slip" } else { "ageing" };
            rate_state(&rock_fields(rock, keyword), evolution, rock.reference_speed)
        }
        // The catalogue has all others.
        _ => {
            let spec = shape.spec().unwrap_or_default();
            let (name, values) = spec.split_once(':').unwrap_or((&spec, ""));
            let made = format!("tribos.Law(\"{name}\", {})", values.replace(',', ", "));
            local(law, &made)
        }
    }
}

/// A line of a call.
fn keyword(name: &str, value: String) -> String {
    format!("    {name}={value},\n")
}

/// A law of the library that depends on the speed alone.
fn local(law: &FittedLaw<'_>, made: &str) -> String {
    let unit = law.unit();
    let load = match law.is_per_load {
        true => "load=10.0)  # N",
        false => "load=1.0)  # the law holds forces in N",
    };
    format!(
        "import tribos\n\n\
         law = {made}\n\
         for speed in {SHOWN_SPEEDS:?}:  # m/s\n    \
         print(f\"{{speed:g}} m/s: {{law.friction(speed):.9f}}\")  # {unit}\n\n\
         # Sliding and spinning of a patch under it: force and torque at 0.1 m/s and 5 rad/s.\n\
         puck = tribos.Friction(tribos.disk(0.04), law=law)  # radius in m\n\
         wrench = puck.wrench([0.1, 0.0, 5.0], {load}\n"
    )
}

/// A law that the library does not have.
fn function(expression: &str, unit: &str) -> String {
    format!(
        "import numpy as np\n\n\n\
         def friction(speed):\n    return {expression}\n\n\n\
         for speed in {SHOWN_SPEEDS:?}:  # m/s\n    \
         print(f\"{{speed:g}} m/s: {{friction(speed):.9f}}\")  # {unit}\n"
    )
}

fn amontons(mu: f64, adhesion: f64) -> String {
    format!(
        "import tribos\n\n\n\
         def law(load):\n    \
         # Adhesion is there without a load, so that the coefficient falls with it.\n    \
         return tribos.Law(\"coulomb\", mu={mu:?} + {adhesion:?} / load)\n\n\n\
         load = 10.0  # N\n\
         for speed in {SHOWN_SPEEDS:?}:  # m/s\n    \
         print(f\"{{speed:g}} m/s: {{load * law(load).friction(speed):.9f}}\")  # friction in N\n"
    )
}

/// Prints friction of some steps of 1 ms.
fn shown_steps(step: &str, unit: &str) -> String {
    format!(
        "for velocity in {SHOWN_VELOCITIES:?}:  # m/s\n{step}    \
         print(f\"{{velocity:g}} m/s: {{force:.9f}}\")  # {unit}, with the sign of the velocity\n"
    )
}

fn bristles(joint: &LuGreParameters<f64>) -> String {
    let step =
        format!("    deflection, force = law.step(deflection, velocity, {SHOWN_STEP:?})  # s\n");
    format!(
        "import tribos\n\n\
         law = tribos.LuGre(  # N, m and s\n{})\n\
         deflection = 0.0  # of the bristles; the state, one for each contact\n{}",
        joint_fields(joint, keyword),
        shown_steps(&step, "mean friction of the step")
    )
}

fn rate_state(rock: &str, evolution: &str, start: f64) -> String {
    let step = format!(
        "    age = law.step(age, abs(velocity), {SHOWN_STEP:?})  # s\n    \
         force = np.copysign(law.friction(velocity, age), velocity)\n"
    );
    format!(
        "import numpy as np\nimport tribos\n\n\
         law = tribos.RateState(\n{rock}    evolution=\"{evolution}\",\n)\n\
         age = law.steady_age({start:?})  # the state, one for each contact\n{}",
        shown_steps(&step, "friction per load")
    )
}

fn sliders(elements: &[[f64; 2]]) -> String {
    let column = |at: usize| {
        let values = elements.iter().filter_map(|pair| pair.get(at));
        values.map(|&x| number(x)).collect::<Vec<_>>().join(", ")
    };
    let step = format!(
        "    forces = step(forces, velocity, {SHOWN_STEP:?})  # s\n    force = forces.sum()\n"
    );
    format!(
        "import numpy as np\n\n\
         # Springs side by side, each of which slips at its own force.\n\
         stiffness = np.array([{}])  # N/m\n\
         slip_force = np.array([{}])  # N\n\n\n\
         def step(forces, velocity, dt):\n    \
         return np.clip(forces + stiffness * velocity * dt, -slip_force, slip_force)\n\n\n\
         forces = np.zeros({})  # of each spring; the state\n{}",
        column(0),
        column(1),
        elements.len(),
        shown_steps(&step, "friction")
    )
}

fn elasto_plastic(joint: &LuGreParameters<f64>, zba: f64) -> String {
    let constants = joint_fields(joint, |name, value| format!("{name} = {value}\n"));
    let step = format!("    deflection, force = step(deflection, velocity, {SHOWN_STEP:?})  # s\n");
    format!(
        "import math\n\n\
         # Bristles that do not creep while they are bent little, in N, m and s.\n{constants}\
         elastic_share = {zba:?}  # deflection up to which nothing slips, over that of steady sliding\n\n\n\
         def step(deflection, velocity, dt):  # abs(velocity) * dt well below coulomb_force / stiffness\n    \
         z, x = abs(deflection), velocity / stribeck_speed\n    \
         steady = coulomb_force + (static_force - coulomb_force) * math.exp(-x * x)\n    \
         most = steady / stiffness\n    \
         elastic = elastic_share * most\n    \
         if deflection * velocity <= 0.0 or z <= elastic:\n        \
         slipping = 0.0  # share of the motion\n    \
         elif z >= most:\n        slipping = 1.0\n    \
         else:\n        \
         slipping = 0.5 + 0.5 * math.sin(math.pi * (z - 0.5 * (most + elastic)) / (most - elastic))\n    \
         rate = slipping * abs(velocity) / most  # exact for this share\n    \
         time = -math.expm1(-rate * dt) / rate if rate > 0.0 else dt\n    \
         bent = (velocity - rate * deflection) * time\n    \
         force = stiffness * (deflection + bent) + bristle_damping * bent / dt + viscous_damping * velocity\n    \
         return deflection + bent, force\n\n\n\
         deflection = 0.0  # of the bristles; the state\n{}",
        shown_steps(&step, "friction")
    )
}
