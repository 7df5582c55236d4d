//! A fitted law as a program in C: with the library where it has the law, else complete in itself.

use super::shape::Shape;
use super::spec::{dahl, joint_fields, rock_fields};
use super::{FittedLaw, SHOWN_SPEEDS, SHOWN_STEP, SHOWN_VELOCITIES, number};
use tribos_core::law::LuGreParameters;

/// A whole program in C99.
pub(super) fn program(law: &FittedLaw<'_>, shape: &Shape) -> String {
    let unit = law.unit();
    match shape {
        Shape::Coulomb { mu } => with_library("coulomb", &member("mu", *mu), "friction", unit),
        Shape::Viscous { mu, k } => alone(&format!("{mu:?} + {k:?} * speed"), unit),
        Shape::Stribeck {
            mu_s,
            mu_d,
            vs,
            delta,
            k,
        } => {
            let dry = format!("    .dry = {{.mu_static = {mu_s:?}, .mu_dynamic = {mu_d:?}}},\n");
            let rest = [
                ("stribeck_speed", *vs),
                ("exponent", *delta),
                ("viscous", *k),
            ];
            let rest = rest.map(|(name, x)| member(name, x)).concat();
            with_library("stribeck", &(dry + &rest), "friction", unit)
        }
        Shape::Tanh { mu, vt } => alone(&format!("{mu:?} * tanh(speed / {vt:?})"), unit),
        Shape::Arctan { mu, vt } => {
            // 2/π to the last bit.
            alone(
                &format!(
                    "{mu:?} * {:?} * atan(speed / {vt:?})",
                    std::f64::consts::FRAC_2_PI
                ),
                unit,
            )
        }
        Shape::Rising { mu_s, mu_f, vr } => alone(
            &format!("{mu_s:?} - ({mu_f:?} - {mu_s:?}) * expm1(-speed / {vr:?})"),
            unit,
        ),
        Shape::Power { gamma, alpha } => {
            let members = member("alpha", *alpha) + &member("coefficient", *gamma);
            with_library("power", &members, "friction", unit)
        }
        Shape::Amontons { mu, adhesion } => amontons(*mu, *adhesion),
        Shape::Sliders(elements) => sliders(elements),
        Shape::Dahl { fc, s0 } => bristles(&dahl(*fc, *s0)),
        Shape::ElastoPlastic { joint, zba } => elasto_plastic(joint, *zba),
        Shape::LuGre(joint) => bristles(joint),
        Shape::SteadyLuGre(joint) => {
            with_library("lugre", &joint_fields(joint, line), "steady_force", unit)
        }
        Shape::RateState { rock, by_slip } => {
            let evolution = if *by_slip { "ruina" } else { "dieterich" };
            let age = rock.slip_distance / rock.reference_speed;
            rate_state(&rock_fields(rock, line), evolution, age)
        }
        Shape::SteadyRateState(rock) => with_library(
            "rate_state",
            &rock_fields(rock, line),
            "steady_friction",
            unit,
        ),
    }
}

/// A member of a structure.
fn line(name: &str, value: String) -> String {
    format!("    .{name} = {value},\n")
}

fn member(name: &str, value: f64) -> String {
    line(name, number(value))
}

/// Numbers as C lists them.
fn list(values: impl Iterator<Item = f64>) -> String {
    values.map(number).collect::<Vec<_>>().join(", ")
}

/// The end of a program of a law without a state.
fn shown_speeds() -> String {
    let speeds = list(SHOWN_SPEEDS.into_iter());
    format!(
        "int main(void)\n{{\n    const double velocities[] = {{{speeds}}}; /* m/s */\n    \
         for (int i = 0; i < {}; i++)\n        \
         printf(\"%g m/s: %.9f\\n\", velocities[i], friction(velocities[i]));\n    return 0;\n}}\n",
        SHOWN_SPEEDS.len()
    )
}

/// The end of a program of a law with a state.
fn shown_steps() -> String {
    let velocities = list(SHOWN_VELOCITIES.into_iter());
    format!(
        "int main(void)\n{{\n    const double velocities[] = {{{velocities}}}; /* m/s */\n    \
         for (int i = 0; i < {}; i++)\n        \
         printf(\"%g m/s: %.9f\\n\", velocities[i], friction(velocities[i], {SHOWN_STEP:?})); /* s */\n    \
         return 0;\n}}\n",
        SHOWN_VELOCITIES.len()
    )
}

/// The sign of the velocity in C, 0 at rest.
const SIGN: &str = "((v > 0.0) - (v < 0.0))";

/// A law of the speed of the library.
fn with_library(law: &str, members: &str, function: &str, unit: &str) -> String {
    format!(
        "#include \"tribos.h\"\n#include <math.h>\n#include <stdio.h>\n\n\
         /* For a processor with single precision alone: _f32, float, fabsf and an f behind each number. */\n\
         static const tribos_{law}_f64 law = {{\n{members}}};\n\n\
         /* At a velocity in m/s: {unit}, with the sign of the velocity. */\n\
         static double friction(double v)\n{{\n    double found = 0.0;\n    \
         (void)tribos_{law}_{function}_f64(&law, fabs(v), &found);\n    return {SIGN} * found;\n}}\n\n{}",
        shown_speeds()
    )
}

/// A law of the speed by its formula.
fn alone(formula: &str, unit: &str) -> String {
    format!(
        "#include <math.h>\n#include <stdio.h>\n\n\
         /* At a velocity in m/s: {unit}, with the sign of the velocity. */\n\
         static double friction(double v)\n{{\n    const double speed = fabs(v);\n    \
         return {SIGN} * ({formula});\n}}\n\n{}",
        shown_speeds()
    )
}

fn amontons(mu: f64, adhesion: f64) -> String {
    format!(
        "#include <stdio.h>\n\n\
         static double load = 10.0; /* N */\n\n\
         /* At a velocity in m/s: friction in N, with the sign of the velocity. */\n\
         static double friction(double v)\n{{\n    \
         return {SIGN} * ({mu:?} * load + {adhesion:?});\n}}\n\n{}",
        shown_speeds()
    )
}

fn bristles(joint: &LuGreParameters<f64>) -> String {
    format!(
        "#include \"tribos.h\"\n#include <stdio.h>\n\n\
         /* N, m and s. For a processor with single precision alone: _f32, float and an f behind each number. */\n\
         static const tribos_lugre_f64 joint = {{\n{}}};\n\
         static double deflection; /* of the bristles; the state, one for each contact; 0 is relaxed */\n\n\
         /* Mean friction over the next dt seconds at a velocity in m/s, with its sign. */\n\
         static double friction(double v, double dt)\n{{\n    double force = 0.0;\n    \
         (void)tribos_lugre_step_f64(&joint, &deflection, v, dt, &force);\n    return force;\n}}\n\n{}",
        joint_fields(joint, line),
        shown_steps()
    )
}

fn rate_state(rock: &str, evolution: &str, age: f64) -> String {
    format!(
        "#include \"tribos.h\"\n#include <math.h>\n#include <stdio.h>\n\n\
         static const tribos_rate_state_f64 rock = {{\n{rock}}};\n\
         static double age = {age:?}; /* of the contact, s; the state. As in steady sliding at the reference speed */\n\n\
         /* Friction per load after dt seconds at a velocity in m/s, with its sign. */\n\
         static double friction(double v, double dt)\n{{\n    double found = 0.0;\n    \
         (void)tribos_rate_state_advance_{evolution}_f64(&rock, &age, fabs(v), dt);\n    \
         (void)tribos_rate_state_friction_f64(&rock, fabs(v), age, &found);\n    \
         return {SIGN} * found;\n}}\n\n{}",
        shown_steps()
    )
}

fn sliders(elements: &[[f64; 2]]) -> String {
    let column = |at: usize| list(elements.iter().filter_map(|pair| pair.get(at)).copied());
    format!(
        "#include <math.h>\n#include <stdio.h>\n\n\
         /* Springs side by side, each of which slips at its own force. */\n\
         enum {{ ELEMENTS = {} }};\n\
         static const double stiffness[ELEMENTS] = {{{}}}; /* N/m */\n\
         static const double slip_force[ELEMENTS] = {{{}}}; /* N */\n\
         static double spring_force[ELEMENTS]; /* N; the state, one for each contact; 0 is relaxed */\n\n\
         /* Friction after dt seconds at a velocity in m/s, with its sign. */\n\
         static double friction(double v, double dt)\n{{\n    double sum = 0.0;\n    \
         for (int i = 0; i < ELEMENTS; i++) {{\n        \
         const double pulled = spring_force[i] + stiffness[i] * v * dt;\n        \
         spring_force[i] = fmax(-slip_force[i], fmin(slip_force[i], pulled));\n        \
         sum += spring_force[i];\n    }}\n    return sum;\n}}\n\n{}",
        elements.len(),
        column(0),
        column(1),
        shown_steps()
    )
}

fn elasto_plastic(joint: &LuGreParameters<f64>, zba: f64) -> String {
    let constants = joint_fields(joint, |name, value| {
        format!("static const double {name} = {value};\n")
    });
    format!(
        "#include <math.h>\n#include <stdio.h>\n\n\
         /* Bristles that do not creep while they are bent little, in N, m and s. */\n{constants}\
         static const double elastic_share = {zba:?}; /* deflection up to which nothing slips, over that of steady sliding */\n\
         static double deflection; /* of the bristles; the state, one for each contact; 0 is relaxed */\n\n\
         /* Friction after dt seconds at a velocity in m/s; |v| dt has to be well below coulomb_force/stiffness. */\n\
         static double friction(double v, double dt)\n{{\n    \
         const double z = fabs(deflection), x = v / stribeck_speed;\n    \
         const double steady = coulomb_force + (static_force - coulomb_force) * exp(-x * x);\n    \
         const double most = steady / stiffness, elastic = elastic_share * most;\n    \
         double slipping = 0.0; /* share of the motion */\n    \
         if (deflection * v > 0.0 && z > elastic)\n        \
         slipping = z >= most ? 1.0 : 0.5 + 0.5 * sin({:?} * (z - 0.5 * (most + elastic)) / (most - elastic));\n    \
         const double rate = slipping * fabs(v) / most; /* exact for this share */\n    \
         const double time = rate > 0.0 ? -expm1(-rate * dt) / rate : dt;\n    \
         const double bent = (v - rate * deflection) * time;\n    \
         deflection += bent;\n    \
         return stiffness * deflection + bristle_damping * bent / dt + viscous_damping * v;\n}}\n\n{}",
        std::f64::consts::PI,
        shown_steps()
    )
}
